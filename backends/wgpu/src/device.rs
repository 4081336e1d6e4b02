//! Finding an adapter and opening a device on it.

use std::fmt;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use crate::program::Cache;
use crate::{Error, Result};

/// The environment variable that chooses an adapter by a part of its name (upper and lower case alike).
pub const ADAPTER_VARIABLE: &str = "ETALON_ADAPTER";

/// What kind of device an adapter stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum AdapterKind {
    /// A graphics card with its own memory.
    Discrete,
    /// A graphics processor that shares the processor's memory.
    Integrated,
    /// A graphics processor lent to a virtual machine.
    Virtual,
    /// Hardware that does not say what it is.
    Other,
    /// A driver that computes on the processor.
    Software,
}

impl fmt::Display for AdapterKind {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Discrete => "discrete",
            Self::Integrated => "integrated",
            Self::Virtual => "virtual",
            Self::Other => "hardware",
            Self::Software => "software",
        })
    }
}

/// An adapter as it presents itself.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct AdapterDescription {
    /// The adapter's name.
    pub name: String,
    /// The graphics interface that reaches it: vulkan, metal or dx12.
    pub interface: String,
    /// Driver and its version.
    pub driver: String,
    /// Hardware of some kind, or software.
    pub kind: AdapterKind,
}

impl AdapterDescription {
    fn new(information: &wgpu::AdapterInfo) -> Self {
        Self {
            name: information.name.clone(),
            interface: information.backend.to_str().to_owned(),
            driver: format!("{} {}", information.driver, information.driver_info).trim().to_owned(),
            kind: match information.device_type {
                wgpu::DeviceType::DiscreteGpu => AdapterKind::Discrete,
                wgpu::DeviceType::IntegratedGpu => AdapterKind::Integrated,
                wgpu::DeviceType::VirtualGpu => AdapterKind::Virtual,
                wgpu::DeviceType::Other => AdapterKind::Other,
                wgpu::DeviceType::Cpu => AdapterKind::Software,
            },
        }
    }
}

impl fmt::Display for AdapterDescription {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{} ({}, {}, driver {})", self.name, self.kind, self.interface, self.driver)
    }
}

/// Which adapter to open.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub enum AdapterPreference {
    /// The most capable hardware; a software adapter if there is no hardware.
    #[default]
    Any,
    /// Hardware only.
    Hardware,
    /// Software only: slow, but the same everywhere.
    Software,
    /// The first adapter whose name contains this text, in the order of [`adapters`].
    Named(String),
}

impl AdapterPreference {
    /// The preference in [`ADAPTER_VARIABLE`]: `Any` if it is unset or empty, else `Named`.
    pub fn from_environment() -> Self {
        match std::env::var(ADAPTER_VARIABLE) {
            Ok(name) if !name.trim().is_empty() => Self::Named(name.trim().to_owned()),
            _ => Self::Any,
        }
    }

    fn accepts(&self, adapter: &AdapterDescription) -> bool {
        match self {
            Self::Any => true,
            Self::Hardware => adapter.kind != AdapterKind::Software,
            Self::Software => adapter.kind == AdapterKind::Software,
            Self::Named(name) => adapter.name.to_lowercase().contains(&name.to_lowercase()),
        }
    }
}

impl fmt::Display for AdapterPreference {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Any => formatter.write_str("usable"),
            Self::Hardware => formatter.write_str("hardware"),
            Self::Software => formatter.write_str("software"),
            Self::Named(name) => write!(formatter, "named like `{name}`"),
        }
    }
}

/// How to open a device.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct DeviceOptions {
    /// Which adapter.
    pub preference: AdapterPreference,
    /// The largest storage binding to use, in bytes, where less than the adapter offers: for leaving memory to others, and
    /// for trying what happens on a small device.
    pub largest_binding: Option<u64>,
}

/// The adapters of this machine, hardware before software, otherwise as the drivers list them.
pub fn adapters() -> Vec<AdapterDescription> {
    enumerate().into_iter().map(|(description, _)| description).collect()
}

/// Opens the adapter whose name contains this text or, without one, the one that [`ADAPTER_VARIABLE`] names, or else the most
/// capable one there is.
///
/// # Errors
/// As [`Device::open`], each one sentence with its remedy.
pub fn open(adapter_name: Option<&str>) -> Result<Device> {
    let preference = match adapter_name {
        Some(name) => AdapterPreference::Named(name.to_owned()),
        None => AdapterPreference::from_environment(),
    };
    Device::open(preference)
}

fn enumerate() -> Vec<(AdapterDescription, wgpu::Adapter)> {
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
    // No debug layers: wgpu's own validation is always there, and does not need a driver kit installed.
    descriptor.flags = wgpu::InstanceFlags::empty();
    let instance = wgpu::Instance::new(descriptor);
    let mut found: Vec<_> = pollster::block_on(instance.enumerate_adapters(wgpu::Backends::all()))
        .into_iter()
        .map(|adapter| (AdapterDescription::new(&adapter.get_info()), adapter))
        .collect();
    found.sort_by_key(|(description, _)| description.kind);
    found
}

/// An open device with its command queue. Cloning gives another handle to the same device.
#[derive(Debug, Clone)]
pub struct Device {
    device: wgpu::Device,
    queue: wgpu::Queue,
    adapter: AdapterDescription,
    /// Compiled texts, see [`crate::program::Program`].
    programs: Arc<Mutex<Cache>>,
    /// Why the device was lost, or what went wrong outside of any error scope.
    trouble: Arc<Mutex<Option<Error>>>,
}

impl Device {
    /// Opens the adapter that the preference names; see [`AdapterPreference`] for the order of choice.
    ///
    /// # Errors
    /// [`Error::NoAdapter`], [`Error::AdapterNotFound`], [`Error::AdapterTooSmall`] or [`Error::DeviceRefused`].
    pub fn open(preference: AdapterPreference) -> Result<Self> {
        Self::open_with(&DeviceOptions { preference, largest_binding: None })
    }

    /// As [`Device::open`], with every option.
    ///
    /// # Errors
    /// As [`Device::open`].
    pub fn open_with(options: &DeviceOptions) -> Result<Self> {
        let (description, adapter) = choose(enumerate(), &options.preference)?;
        let mut limits = wgpu::Limits::default().or_worse_values_from(&adapter.limits());
        limits.max_buffer_size = adapter.limits().max_buffer_size;
        limits.max_storage_buffer_binding_size = adapter.limits().max_storage_buffer_binding_size;
        if let Some(largest) = options.largest_binding {
            limits.max_storage_buffer_binding_size = limits.max_storage_buffer_binding_size.min(largest.max(256));
        }
        check_limits(&description, &limits)?;

        let (device, queue) = pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor {
            label: Some("etalon"),
            required_features: adapter.features() & wgpu::Features::TIMESTAMP_QUERY,
            required_limits: limits,
            ..Default::default()
        }))
        .map_err(|error| Error::DeviceRefused {
            adapter: description.name.clone(),
            reason: one_line(&error.to_string()),
        })?;

        let trouble = Arc::new(Mutex::new(None));
        let noted = Arc::clone(&trouble);
        device.set_device_lost_callback(move |_, reason| note(&noted, Error::DeviceLost { reason: one_line(&reason) }));
        let noted = Arc::clone(&trouble);
        // Without a handler such an error would end the process.
        device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| note(&noted, typed(error, "working"))));
        Ok(Self { device, queue, adapter: description, programs: Arc::default(), trouble })
    }

    /// The adapter this device was opened on.
    pub fn adapter(&self) -> &AdapterDescription {
        &self.adapter
    }

    /// The largest storage buffer that can be bound, in bytes.
    pub fn largest_binding(&self) -> u64 {
        let limits = self.device.limits();
        limits.max_storage_buffer_binding_size.min(limits.max_buffer_size)
    }

    /// Whether kernels can be timed on the device.
    pub fn has_timestamps(&self) -> bool {
        self.device.features().contains(wgpu::Features::TIMESTAMP_QUERY)
    }

    /// Gives the device back at once; every later use of it, through any handle, is [`Error::DeviceLost`].
    pub fn close(&self) {
        // Noted here too: the driver's own report of a loss only arrives when the device is next waited for.
        note(&self.trouble, Error::DeviceLost { reason: "it was closed".into() });
        self.device.destroy();
    }

    /// The texts compiled so far.
    pub(crate) fn programs(&self) -> MutexGuard<'_, Cache> {
        self.programs.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub(crate) fn raw(&self) -> &wgpu::Device {
        &self.device
    }

    pub(crate) fn queue(&self) -> &wgpu::Queue {
        &self.queue
    }

    /// Runs device calls and returns what they complained of as a typed error. `doing` continues "while ...".
    pub(crate) fn checked<T>(&self, doing: &str, calls: impl FnOnce() -> T) -> Result<T> {
        let internal = self.device.push_error_scope(wgpu::ErrorFilter::Internal);
        let memory = self.device.push_error_scope(wgpu::ErrorFilter::OutOfMemory);
        let validation = self.device.push_error_scope(wgpu::ErrorFilter::Validation);
        let value = calls();
        let caught = [
            pollster::block_on(validation.pop()),
            pollster::block_on(memory.pop()),
            pollster::block_on(internal.pop()),
        ];
        self.healthy()?;
        match caught.into_iter().flatten().next() {
            Some(error) => Err(typed(error, doing)),
            None => Ok(value),
        }
    }

    /// Fails if the device was lost, or if an error occurred outside of [`Device::checked`].
    pub(crate) fn healthy(&self) -> Result<()> {
        match &*self.trouble.lock().unwrap_or_else(PoisonError::into_inner) {
            Some(error) => Err(error.clone()),
            None => Ok(()),
        }
    }

    /// Waits until everything submitted has been done.
    pub(crate) fn wait(&self) -> Result<()> {
        let outcome = self.device.poll(wgpu::PollType::wait_indefinitely());
        self.healthy()?;
        match outcome {
            Ok(_) => Ok(()),
            Err(error) => Err(Error::Refused { doing: "waiting for the device".into(), message: error.to_string() }),
        }
    }
}

/// The first adapter that the preference accepts.
fn choose<A>(found: Vec<(AdapterDescription, A)>, preference: &AdapterPreference) -> Result<(AdapterDescription, A)> {
    if found.is_empty() {
        return Err(Error::NoAdapter);
    }
    // Names have commas and parentheses in them, so each goes between backticks.
    let available = found.iter().map(|(adapter, _)| format!("`{}` ({})", adapter.name, adapter.kind));
    let available = available.collect::<Vec<_>>().join(", ");
    found
        .into_iter()
        .find(|(description, _)| preference.accepts(description))
        .ok_or_else(|| Error::AdapterNotFound { wanted: preference.to_string(), available })
}

/// Refuses adapters below what WebGPU guarantees, which is what the kernels are written for.
fn check_limits(adapter: &AdapterDescription, limits: &wgpu::Limits) -> Result<()> {
    let needs = [
        ("storage buffers per shader stage", limits.max_storage_buffers_per_shader_stage.into(), 8),
        ("invocations per workgroup", limits.max_compute_invocations_per_workgroup.into(), 64),
        ("workgroups per dimension", limits.max_compute_workgroups_per_dimension.into(), 65535),
        ("bytes of workgroup memory", limits.max_compute_workgroup_storage_size.into(), 1024),
    ];
    for (limit, offered, needed) in needs {
        if offered < needed {
            return Err(Error::AdapterTooSmall { adapter: adapter.name.clone(), limit, needed, offered });
        }
    }
    Ok(())
}

fn note(trouble: &Mutex<Option<Error>>, error: Error) {
    // The first trouble is the cause of the later ones.
    trouble.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
}

fn typed(error: wgpu::Error, doing: &str) -> Error {
    let doing = doing.to_owned();
    match error {
        wgpu::Error::OutOfMemory { .. } => Error::OutOfMemory { doing },
        wgpu::Error::Validation { description, .. } | wgpu::Error::Internal { description, .. } => {
            Error::Refused { doing, message: one_line(&description) }
        }
    }
}

/// A message on one line: wgpu's are indented trees.
pub(crate) fn one_line(message: &str) -> String {
    message.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn adapter(name: &str, kind: AdapterKind) -> AdapterDescription {
        AdapterDescription { name: name.into(), interface: "vulkan".into(), driver: "none 1.0".into(), kind }
    }

    #[test]
    fn preferences_accept_by_kind_and_by_name() {
        let card = adapter("GeForce", AdapterKind::Discrete);
        let lavapipe = adapter("llvmpipe (LLVM 15)", AdapterKind::Software);
        assert!(AdapterPreference::Any.accepts(&card) && AdapterPreference::Any.accepts(&lavapipe));
        assert!(AdapterPreference::Hardware.accepts(&card) && !AdapterPreference::Hardware.accepts(&lavapipe));
        assert!(!AdapterPreference::Software.accepts(&card) && AdapterPreference::Software.accepts(&lavapipe));
        let named = AdapterPreference::Named("LLVMPIPE".into());
        assert!(named.accepts(&lavapipe) && !named.accepts(&card));
    }

    #[test]
    fn no_adapter_is_one_sentence_with_the_remedy() {
        let error = choose(Vec::<(_, ())>::new(), &AdapterPreference::Any).unwrap_err();
        assert_eq!(error, Error::NoAdapter);
        let message = error.to_string();
        assert!(
            message.contains("mesa-vulkan-drivers") && message.contains("--backend simd") && !message.contains('\n')
        );
    }

    #[test]
    fn an_adapter_that_is_not_there_is_one_sentence_with_the_remedy_and_those_that_are() {
        let found = || {
            vec![
                (adapter("GeForce", AdapterKind::Discrete), 1),
                (adapter("llvmpipe (LLVM 15, 256 bits)", AdapterKind::Software), 2),
            ]
        };
        let wanted = |name: &str| AdapterPreference::Named(name.into());
        let message = choose(found(), &wanted("Arc")).unwrap_err().to_string();
        assert_eq!(
            message,
            "no graphics adapter is named like `Arc` among `GeForce` (discrete), `llvmpipe (LLVM 15, 256 bits)` \
             (software): name one of these, or a part of its name, with `--adapter` or in ETALON_ADAPTER, or give neither"
        );
        assert_eq!(choose(found(), &wanted("llvm")).unwrap().1, 2);
        assert_eq!(choose(found(), &AdapterPreference::Any).unwrap().1, 1);
    }

    #[test]
    fn hardware_sorts_before_software() {
        let mut kinds = [AdapterKind::Software, AdapterKind::Other, AdapterKind::Discrete, AdapterKind::Integrated];
        kinds.sort();
        assert_eq!(kinds[0], AdapterKind::Discrete);
        assert_eq!(kinds[3], AdapterKind::Software);
    }
}
