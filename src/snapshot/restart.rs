//! A checkpoint as a file, from which a run goes on bit for bit.
//!
//! HDF5 again, so that any tool shows what is in it: the dataset `header` is JSON ([`Settings`], time, step and what the caller adds);
//! `coordinates/0` and so on are the fixed-point coordinates; `fields/NAME` are the fields; `order` is the order in which the engine kept its
//! particles.
//! Every dataset carries the CRC-32 of its bytes. What was made by another version, another engine or with other settings is refused.

use super::{SnapshotError, atomic};
use etalon_kernels_gen::{Component, components};
use etalon_reference::domain::Domain;
use etalon_reference::engine::Arrangement;
use etalon_reference::fields;
use etalon_reference::passes::Physics;
use etalon_reference::simulation::Checkpoint;
use etalon_reference::turbulence::forcing::ForcingState;
use hdf5_pure::{AttrValue, Dataset, DatasetBuilder, File, FileBuilder, GroupBuilder};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// What the file says it is.
const SCHEMA: &str = "etalon-restart";
/// The version of its form.
const SCHEMA_VERSION: u64 = 2;

/// What a run was asked to do, as far as its bits depend on it: a restart file is taken only where all of it is the same.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Settings {
    entries: Vec<(String, String)>,
}

impl Settings {
    /// The program's version, the engine by name and precision (`simd f64`), the physics and the box.
    pub fn new<const D: usize>(engine: &str, physics: &Physics, domain: &Domain<D>) -> Self {
        let none = Settings { entries: Vec::new() };
        // Numbers in `Debug` form are exact.
        none.with("program", env!("CARGO_PKG_VERSION"))
            .with("engine", engine)
            .with("dimensions", D.to_string())
            .with("physics", format!("{physics:?}"))
            .with("box", format!("{domain:?}"))
    }

    /// The same with something more, such as the text of a scene.
    pub fn with(mut self, name: &str, value: impl Into<String>) -> Self {
        self.entries.push((name.into(), value.into()));
        self
    }

    /// In words, the first thing that differs: of the file, and of this run.
    fn difference(&self, saved: &Self) -> Option<String> {
        let value = |of: &Self, name: &str| of.entries.iter().find(|(n, _)| n == name).map(|(_, value)| value.clone());
        let names = saved.entries.iter().chain(&self.entries).map(|(name, _)| name);
        names.into_iter().find_map(|name| match (value(saved, name), value(self, name)) {
            (Some(there), Some(here)) if there == here => None,
            (Some(there), Some(here)) => {
                let (there, here) = differing_part(&there, &here);
                Some(format!("it was made with {name} `{there}` where this run has `{here}`"))
            }
            (Some(there), None) => Some(format!("it was made with {name} `{there}`, which this run does not have")),
            (None, _) => Some(format!("it was made without {name}, which this run has")),
        })
    }
}

/// Of two long texts, the first parts between commas that differ.
fn differing_part<'a>(a: &'a str, b: &'a str) -> (&'a str, &'a str) {
    let parts = |text: &'a str| text.split([',', '{', '}', '\n']).map(str::trim);
    parts(a).zip(parts(b)).find(|(a, b)| a != b).unwrap_or((a, b))
}

/// What stands in the dataset `header`; `T` is what the caller adds.
#[derive(Serialize, Deserialize)]
struct Header<T> {
    settings: Settings,
    particles: u64,
    time: f64,
    next_step: f64,
    steps: u64,
    searches: u64,
    ordered: bool,
    forcing: Option<Force>,
    beside: T,
}

/// How a force stands.
#[derive(Serialize, Deserialize)]
struct Force {
    amplitudes: Vec<f64>,
    /// In hexadecimal: JSON has no whole numbers of 128 bits.
    random: String,
}

impl From<&ForcingState> for Force {
    fn from(state: &ForcingState) -> Self {
        Force { amplitudes: state.amplitudes.clone(), random: format!("{:x}", state.random) }
    }
}

impl TryFrom<Force> for ForcingState {
    type Error = String;
    fn try_from(force: Force) -> Result<Self, String> {
        let random = u128::from_str_radix(&force.random, 16);
        let random = random.map_err(|error| format!("the state of its random numbers is damaged ({error})"))?;
        Ok(ForcingState { amplitudes: force.amplitudes, random })
    }
}

/// Writes a restart file, complete or not at all: one that was there before is there until the new one takes its place. `beside` is what the
/// caller wants back with it, numbers that are finite.
///
/// # Errors
/// [`SnapshotError`]: what the system refuses, or a time that is not finite.
pub fn save<T: Serialize>(
    path: &Path,
    checkpoint: &Checkpoint,
    settings: &Settings,
    beside: &T,
) -> Result<(), SnapshotError> {
    let bad = |problem: String| SnapshotError::file(path, problem);
    if !(checkpoint.time.is_finite() && checkpoint.next_step.is_finite()) {
        return Err(bad(format!(
            "time {} and step {} cannot be saved; both must be finite",
            checkpoint.time, checkpoint.next_step
        )));
    }
    let header = Header {
        settings: settings.clone(),
        particles: checkpoint.coordinates.first().map_or(0, Vec::len) as u64,
        time: checkpoint.time,
        next_step: checkpoint.next_step,
        steps: checkpoint.steps,
        searches: checkpoint.arrangement.searches,
        ordered: !checkpoint.arrangement.order.is_empty(),
        forcing: checkpoint.forcing.as_ref().map(Force::from),
        beside,
    };
    let header = serde_json::to_vec(&header).map_err(|error| bad(format!("its header has no JSON form ({error})")))?;
    let mut file = FileBuilder::new();
    file.set_attr("Schema", AttrValue::AsciiString(SCHEMA.into()));
    file.set_attr("SchemaVersion", AttrValue::U64(SCHEMA_VERSION));
    signed(file.create_dataset("header").with_u8_data(&header), &header);
    if !checkpoint.arrangement.order.is_empty() {
        let order = &checkpoint.arrangement.order;
        signed(file.create_dataset("order").with_u32_data(order), &bytes(order, |n| n.to_le_bytes()));
    }
    let put = |group: &mut GroupBuilder, name: &str, words: &[u64]| {
        signed(group.create_dataset(name).with_u64_data(words), &bytes(words, |n| n.to_le_bytes()));
    };
    let mut group = file.create_group("coordinates");
    for (axis, column) in checkpoint.coordinates.iter().enumerate() {
        put(&mut group, &axis.to_string(), column);
    }
    file.add_group(group.finish());
    let mut group = file.create_group("fields");
    for (component, values) in &checkpoint.columns {
        let name = component.name(checkpoint.coordinates.len());
        signed(group.create_dataset(&name).with_f64_data(values), &bytes(values, |x| x.to_bits().to_le_bytes()));
    }
    file.add_group(group.finish());
    let image = file.finish().map_err(|error| bad(format!("it cannot be written as HDF5 ({error})")))?;
    atomic::write_bytes(path, &image)
}

/// Little-endian bytes.
fn bytes<T: Copy, const N: usize>(values: &[T], of: impl Fn(T) -> [u8; N]) -> Vec<u8> {
    values.iter().flat_map(|value| of(*value)).collect()
}

fn signed(dataset: &mut DatasetBuilder, bytes: &[u8]) {
    dataset.set_attr("Crc32", AttrValue::U32(crc32fast::hash(bytes)));
}

/// Reads a restart file that was made with these settings, for so many dimensions, and what its writer added.
///
/// # Errors
/// [`SnapshotError`] naming what is wrong and where: no restart file, another version, other settings, cut short or damaged.
pub fn load<const D: usize, T: DeserializeOwned>(
    path: &Path,
    settings: &Settings,
) -> Result<(Checkpoint, T), SnapshotError> {
    let bad = |problem: String| SnapshotError::file(path, problem);
    let image = std::fs::read(path).map_err(SnapshotError::io("read", path))?;
    let size = image.len() as u64;
    let broken = |error| bad(format!("it cannot be read as HDF5 ({error}); was it cut short?"));
    let file = File::from_bytes(image).map_err(broken)?;
    Reader { file, size }.checkpoint::<D, T>(settings).map_err(bad)
}

struct Reader {
    file: File,
    size: u64,
}

impl Reader {
    fn checkpoint<const D: usize, T: DeserializeOwned>(&self, settings: &Settings) -> Result<(Checkpoint, T), String> {
        let own = self.file.root().attrs().map_err(|error| format!("its attributes cannot be read ({error})"))?;
        if own.get("Schema").and_then(AttrValue::as_str) != Some(SCHEMA) {
            return Err("it is no restart file of this program".into());
        }
        let version = own.get("SchemaVersion").and_then(AttrValue::as_u64).unwrap_or(0);
        if version != SCHEMA_VERSION {
            return Err(format!(
                "it is a restart file of version {version}; this program reads version {SCHEMA_VERSION}"
            ));
        }
        let header = self.checked("header", None, |data| data.read_u8(), |n| n.to_le_bytes())?;
        let header: Header<T> =
            serde_json::from_slice(&header).map_err(|error| format!("its header is damaged ({error})"))?;
        if let Some(difference) = settings.difference(&header.settings) {
            return Err(format!("{difference}; resume with what the run was started with"));
        }
        let count = Some(header.particles);
        let coordinate =
            |axis: usize| self.checked(&format!("coordinates/{axis}"), count, |d| d.read_u64(), |n| n.to_le_bytes());
        let order = match header.ordered {
            true => self.checked("order", count, |data| data.read_u32(), |n| n.to_le_bytes())?,
            false => Vec::new(),
        };
        let group = self.file.group("fields").map_err(|error| format!("its fields cannot be read ({error})"))?;
        let mut names = group.datasets().map_err(|error| format!("its fields cannot be read ({error})"))?;
        names.sort();
        let known: Vec<Component> = components(fields::ALL, D);
        let column = |name: String| {
            let component = known.iter().find(|component| component.name(D) == name);
            let component =
                component.ok_or_else(|| format!("it has a field {name}, which this program does not know"))?;
            let values =
                self.checked(&format!("fields/{name}"), count, |d| d.read_f64(), |x| x.to_bits().to_le_bytes())?;
            Ok((*component, values))
        };
        let checkpoint = Checkpoint {
            coordinates: (0..D).map(coordinate).collect::<Result<_, _>>()?,
            columns: names.into_iter().map(column).collect::<Result<_, String>>()?,
            arrangement: Arrangement { order, searches: header.searches },
            time: header.time,
            steps: header.steps,
            next_step: header.next_step,
            forcing: header.forcing.map(ForcingState::try_from).transpose()?,
        };
        Ok((checkpoint, header.beside))
    }

    /// A dataset whose size and checksum are right.
    fn checked<T: Copy, const N: usize>(
        &self,
        name: &str,
        count: Option<u64>,
        read: impl Fn(&Dataset) -> Result<Vec<T>, hdf5_pure::Error>,
        of: impl Fn(T) -> [u8; N],
    ) -> Result<Vec<T>, String> {
        let broken = |error| format!("its dataset {name} cannot be read ({error}); was it cut short?");
        let dataset = self.file.dataset(name).map_err(broken)?;
        let shape = dataset.shape().map_err(broken)?;
        let rows = match *shape {
            [rows] if count.is_none_or(|count| rows == count) && rows.saturating_mul(N as u64) <= self.size => rows,
            _ => {
                return Err(format!(
                    "its dataset {name} has the shape {shape:?}, which is not that of its particles; it is damaged"
                ));
            }
        };
        let stated = dataset.attrs().map_err(broken)?.get("Crc32").and_then(AttrValue::as_u64);
        let values = read(&dataset).map_err(broken)?;
        if values.len() as u64 != rows || stated != Some(crc32fast::hash(&bytes(&values, of)).into()) {
            return Err(format!("its dataset {name} does not have its checksum; it is damaged"));
        }
        Ok(values)
    }
}

#[cfg(test)]
mod tests;
