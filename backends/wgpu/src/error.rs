//! What can go wrong on a device, each with its remedy.

/// An error of the graphics backend. Every message is one sentence that names the remedy.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// No adapter at all: neither a graphics card's driver nor a software one.
    #[error(
        "no graphics adapter was found: install a Vulkan driver (for a machine without a graphics card Debian's \
         `mesa-vulkan-drivers`), or use `--backend simd`"
    )]
    NoAdapter,
    /// There are adapters, but none as wanted.
    #[error(
        "no graphics adapter is {wanted} among {available}: name one of these, or a part of its name, with `--adapter` \
         or in ETALON_ADAPTER, or give neither"
    )]
    AdapterNotFound {
        /// What was asked for, in words.
        wanted: String,
        /// The adapters that exist, each with its kind, joined by commas.
        available: String,
    },
    /// The adapter does not offer what WebGPU guarantees.
    #[error(
        "adapter `{adapter}` offers {offered} for {limit} where {needed} are needed: choose another one with `--adapter` or \
         ETALON_ADAPTER, or use `--backend simd`"
    )]
    AdapterTooSmall {
        /// Name of the adapter.
        adapter: String,
        /// Name of the limit.
        limit: &'static str,
        /// What this backend needs.
        needed: u64,
        /// What the adapter offers.
        offered: u64,
    },
    /// The driver refused to open the device.
    #[error(
        "adapter `{adapter}` could not be opened ({reason}): choose another one with `--adapter` or ETALON_ADAPTER, or use \
         `--backend simd`"
    )]
    DeviceRefused {
        /// Name of the adapter.
        adapter: String,
        /// The driver's words.
        reason: String,
    },
    /// The device went away while in use: reset, unplugged, or its driver crashed.
    #[error(
        "the graphics device was lost ({reason}): run again, on another adapter (`--adapter` or ETALON_ADAPTER) or with \
         `--backend simd`"
    )]
    DeviceLost {
        /// The driver's words.
        reason: String,
    },
    /// The device's memory is used up.
    #[error("the graphics device ran out of memory while {doing}: use fewer particles, or `--backend simd`")]
    OutOfMemory {
        /// What was being done.
        doing: String,
    },
    /// A buffer would be larger than the adapter can bind.
    #[error(
        "{what} needs {needed} bytes in one storage buffer but the adapter binds at most {limit}: use fewer particles, \
         an adapter with larger bindings (`--adapter` or ETALON_ADAPTER), or `--backend simd`"
    )]
    TooLarge {
        /// What the buffer holds.
        what: String,
        /// Bytes needed.
        needed: u64,
        /// Bytes that can be bound.
        limit: u64,
    },
    /// The neighbour lists would be longer than the adapter can bind.
    #[error(
        "the neighbour lists have {} entries but the adapter binds at most {limit}: use fewer particles or fewer \
         neighbours, an adapter with larger bindings (`--adapter` or ETALON_ADAPTER), or `--backend simd`",
        entries.map_or("more than 4294967294".to_owned(), |entries| entries.to_string())
    )]
    ListTooLong {
        /// Entries needed; `None` if they cannot be counted in 32 bits.
        entries: Option<u32>,
        /// Entries that can be bound.
        limit: u32,
    },
    /// WGSL text was refused: a defect of the text, whether generated or written by hand.
    #[error("the WGSL of `{kernel}` was refused, please report it with this message: {message}")]
    Shader {
        /// Name of the kernel.
        kernel: String,
        /// The validator's words.
        message: String,
    },
    /// The device refused a command: a defect of this crate.
    #[error("the graphics device refused a command while {doing}, please report it with this message: {message}")]
    Refused {
        /// What was being done.
        doing: String,
        /// The validator's words.
        message: String,
    },
    /// A torus that is none.
    #[error(
        "a torus needs 1, 2 or 3 axes of finite positive length within 1e-15 to 1e15, but got {lengths:?}: choose other units"
    )]
    BadTorus {
        /// The lengths as given.
        lengths: Vec<f64>,
    },
    /// No particles, or more than an index can count.
    #[error("{count} particles cannot be stored: give between 1 and 2147483647 of them")]
    BadCount {
        /// The number as given.
        count: usize,
    },
    /// Data of another length than the store has.
    #[error("{what} has {expected} values but {found} were given: give one per particle")]
    WrongLength {
        /// What was to be written.
        what: String,
        /// Values stored.
        expected: usize,
        /// Values given.
        found: usize,
    },
    /// A component or axis that the store does not have.
    #[error("there is no {what} {index}: the store has {count}, counted from 0")]
    NoSuchIndex {
        /// "component" or "axis" or "parameter".
        what: &'static str,
        /// The index as given.
        index: usize,
        /// How many there are.
        count: usize,
    },
    /// Two stores that should describe the same particles do not.
    #[error("{what} holds {found} particles where {expected} are expected: make both stores for the same particles")]
    CountMismatch {
        /// The store.
        what: &'static str,
        /// Particles expected.
        expected: usize,
        /// Particles held.
        found: usize,
    },
    /// A support radius that is zero, negative, infinite or not a number.
    #[error(
        "the support radii run from {smallest} to {largest} but must be positive and finite: the smoothing lengths have gone wrong, use a smaller time step"
    )]
    BadReach {
        /// Smallest support radius (a negative NaN counts as smallest).
        smallest: f32,
        /// Largest support radius (a positive NaN counts as largest).
        largest: f32,
    },
    /// A particle was to move by half the torus or more, or by something that is no number.
    #[error(
        "particle {particle} was to move by {displacement:?}, which is not within half the torus {half_length:?}: use a smaller time step"
    )]
    DisplacementTooLarge {
        /// The first such particle.
        particle: u32,
        /// Its displacement.
        displacement: Vec<f32>,
        /// Half the lengths of the torus.
        half_length: Vec<f32>,
    },
}
