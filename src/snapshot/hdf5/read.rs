//! Reading: our files, and those of codes that share the layout.

use super::super::SnapshotError;
use super::super::names::{COORDINATES, IDS, stem_of};
use super::super::table::{AXES, Column, Frame, PARTICLE_TYPE, Snapshot, axes_in_use};
use super::{OWN, SCHEMA, SCHEMA_VERSION, TYPES};
use hdf5_pure::{AttrValue, Dataset, File, Group};
use std::collections::HashMap;
use std::path::Path;

/// The most that deflate can make of a byte (1032 to 1): what claims to be larger than this times the file is no data.
const MOST_INFLATED: u64 = 1032;
/// More numbers a particle than this is a table of something else.
const MOST_COMPONENTS: u64 = 9;

type Attributes = HashMap<String, AttrValue>;

/// Reads gas, and in our own files dust too.
///
/// # Errors
/// [`SnapshotError`] naming the dataset: a file that is no HDF5, is cut short or has no gas particles; a dataset of another shape than one
/// row a particle, or that claims more than the file can hold; numbers that are not finite; ids that come twice.
pub fn read(path: &Path) -> Result<Snapshot, SnapshotError> {
    let size = std::fs::metadata(path).map_err(SnapshotError::io("read", path))?.len();
    let bad = |problem: String| SnapshotError::file(path, problem);
    let file =
        File::open(path).map_err(|error| bad(format!("it cannot be read as HDF5 ({error}); was it cut short?")))?;
    Reader { file, size }.snapshot().map_err(bad)
}

struct Reader {
    file: File,
    size: u64,
}

/// A dataset of all particles of a kind.
struct Array {
    stem: String,
    unit: String,
    width: usize,
    values: Vec<f64>,
}

impl Reader {
    fn snapshot(&self) -> Result<Snapshot, String> {
        let own = match self.file.group(OWN) {
            Ok(group) => Some(checked(attributes(&group, OWN)?)?),
            Err(_) => None,
        };
        let header = match self.file.group("Header") {
            Ok(group) => attributes(&group, "Header")?,
            Err(_) => return Err("there is no group Header; it is no snapshot in the layout of GADGET or SWIFT".into()),
        };
        let kinds = if own.is_some() { 0..TYPES } else { 0..1 };
        let mut parts = Vec::new();
        for kind in kinds {
            if let Ok(group) = self.file.group(&format!("PartType{kind}")) {
                parts.push((kind, self.particles(&group, kind, &header)?));
            }
        }
        if parts.is_empty() {
            return Err("there is no group PartType0; a snapshot has gas particles".into());
        }
        assemble(parts, own.as_ref(), &header)
    }

    /// All datasets of a kind of particle, positions first, and the ids.
    fn particles(
        &self,
        group: &Group,
        kind: usize,
        header: &Attributes,
    ) -> Result<(Vec<Array>, Option<Vec<u64>>), String> {
        let place = format!("PartType{kind}");
        let mut names = group.datasets().map_err(|error| format!("the group {place} cannot be read ({error})"))?;
        names.sort();
        let Some(at) = names.iter().position(|name| name == COORDINATES) else {
            return Err(format!("there is no dataset {place}/{COORDINATES}; its datasets are {}", names.join(", ")));
        };
        names.swap(0, at);
        let mut rows = None;
        let (mut arrays, mut ids) = (Vec::new(), None);
        for name in names {
            let shown = format!("{place}/{name}");
            let broken = |error: hdf5_pure::Error| {
                format!(
                    "the dataset {shown} cannot be read ({error}); was the file cut short, or written in a format newer than HDF5 1.14's?"
                )
            };
            let dataset = group.dataset(&name).map_err(broken)?;
            let shape = dataset.shape().map_err(broken)?;
            let expected = *rows.get_or_insert(shape.first().copied().unwrap_or(0));
            let width = self.checked_width(&dataset, &shape, expected, &shown)?;
            if name == IDS {
                ids = Some(dataset.read_u64().map_err(broken)?);
                let given = dataset.attrs().map_err(broken)?.get("Given").and_then(AttrValue::as_u64);
                ids = ids.filter(|_| given != Some(0));
                continue;
            }
            let attributes = dataset.attrs().map_err(broken)?;
            let text = |key: &str| attributes.get(key).and_then(AttrValue::as_str).map(String::from);
            let stem =
                if name == COORDINATES { "position".into() } else { text("Column").unwrap_or_else(|| stem_of(&name)) };
            let unit = text("Unit").filter(|unit| unit != "1").unwrap_or_default();
            let values = dataset.read_f64().map_err(broken)?;
            if let Some(place) = values.iter().position(|value| !value.is_finite()) {
                let problem = format!("the dataset {shown} has {} for particle {}", values[place], place / width);
                return Err(format!("{problem}; it must be a finite number"));
            }
            arrays.push(Array { stem, unit, width, values });
        }
        if arrays[0].width != 3 {
            return Err(format!(
                "the dataset {place}/{COORDINATES} has {} numbers a particle; it must have 3",
                arrays[0].width
            ));
        }
        let rows = rows.unwrap_or(0) as usize;
        let masses = header.get("MassTable").and_then(AttrValue::to_f64s).and_then(|all| all.get(kind).copied());
        if let (Some(mass), false) =
            (masses.filter(|mass| *mass > 0.0), arrays.iter().any(|array| array.stem == "mass"))
        {
            arrays.push(Array { stem: "mass".into(), unit: String::new(), width: 1, values: vec![mass; rows] });
        }
        let stated = header.get("NumPart_ThisFile").and_then(AttrValue::to_i64s).and_then(|all| all.get(kind).copied());
        if stated.is_some_and(|stated| stated != rows as i64) {
            let stated = stated.unwrap_or(0);
            return Err(format!(
                "Header/NumPart_ThisFile says {stated} particles where {place}/{COORDINATES} has {rows}"
            ));
        }
        Ok((arrays, ids))
    }

    /// How many numbers a particle has there, before anything is read.
    fn checked_width(&self, dataset: &Dataset, shape: &[u64], rows: u64, shown: &str) -> Result<usize, String> {
        let width = match *shape {
            [_] => 1,
            [_, width] if (1..=MOST_COMPONENTS).contains(&width) => width,
            _ => {
                return Err(format!(
                    "the dataset {shown} has the shape {shape:?}; it must be one row a particle with 1 to {MOST_COMPONENTS} numbers"
                ));
            }
        };
        if shape[0] != rows {
            return Err(format!(
                "the dataset {shown} has {} rows where {COORDINATES} has {rows}; they must agree",
                shape[0]
            ));
        }
        let element =
            dataset.element_size().map_err(|error| format!("the dataset {shown} cannot be read ({error})"))?;
        let most = self.size.saturating_mul(if dataset.filters().is_empty() { 1 } else { MOST_INFLATED });
        // Numbers of up to eight bytes are what particles have; the widest record of them bounds what reading makes of it.
        if rows.saturating_mul(width).saturating_mul(element) > most {
            return Err(format!(
                "the dataset {shown} claims {rows} rows of {width} numbers, more than the file of {} bytes can hold; was it cut short?",
                self.size
            ));
        }
        Ok(width as usize)
    }
}

fn attributes(group: &Group, name: &str) -> Result<Attributes, String> {
    group.attrs().map_err(|error| {
        format!("the attributes of the group {name} cannot be read ({error}); was the file cut short?")
    })
}

/// Our own attributes, if they are of a version that is known.
fn checked(own: Attributes) -> Result<Attributes, String> {
    let schema = own.get("Schema").and_then(AttrValue::as_str).unwrap_or("");
    let version = own.get("SchemaVersion").and_then(AttrValue::as_u64).unwrap_or(0);
    if schema != SCHEMA {
        return Err(format!("the group {OWN} says that it is `{schema}`; a snapshot says `{SCHEMA}`"));
    }
    if version != SCHEMA_VERSION {
        return Err(format!("it is a snapshot of version {version}; this program reads version {SCHEMA_VERSION}"));
    }
    Ok(own)
}

type Particles = (usize, (Vec<Array>, Option<Vec<u64>>));

/// One snapshot of all kinds of particles, one kind after the other. What a kind does not have is zero.
fn assemble(mut parts: Vec<Particles>, own: Option<&Attributes>, header: &Attributes) -> Result<Snapshot, String> {
    let counts: Vec<usize> = parts.iter().map(|(_, (arrays, _))| arrays[0].values.len() / 3).collect();
    let mut known: Vec<(String, String, usize)> = Vec::new();
    for array in parts.iter().flat_map(|(_, (arrays, _))| arrays) {
        match known.iter().find(|(stem, ..)| *stem == array.stem) {
            Some((_, _, width)) if *width != array.width => {
                return Err(format!("{} has {width} numbers in one group and {} in another", array.stem, array.width));
            }
            Some(_) => {}
            None => known.push((array.stem.clone(), array.unit.clone(), array.width)),
        }
    }
    let mut columns = Vec::new();
    for (stem, unit, width) in known {
        for component in 0..width {
            let mut values = Vec::with_capacity(counts.iter().sum());
            for ((_, (arrays, _)), count) in parts.iter().zip(&counts) {
                match arrays.iter().find(|array| array.stem == stem) {
                    Some(array) => values.extend(array.values.iter().skip(component).step_by(width)),
                    None => values.extend(std::iter::repeat_n(0.0, *count)),
                }
            }
            columns.push(Column::new(component_name(&stem, component, width), unit.clone(), values));
        }
        // Not twice in memory.
        parts.iter_mut().for_each(|(_, (arrays, _))| arrays.retain(|array| array.stem != stem));
    }
    if parts.iter().any(|(kind, _)| *kind != 0) {
        let kinds = parts.iter().zip(&counts).flat_map(|((kind, _), count)| std::iter::repeat_n(*kind as f64, *count));
        columns.push(Column::new(PARTICLE_TYPE, "", kinds.collect()));
    }
    let dimension = dimension(&columns, own, header)?;
    trim(&mut columns, dimension);
    let numbers = |key: &str| own.and_then(|own| own.get(key)).and_then(AttrValue::to_f64s);
    if let Some(origin) = numbers("Origin") {
        for (axis, shift) in AXES.iter().zip(origin) {
            for column in columns.iter_mut().filter(|column| column.name == *axis) {
                column.values.iter_mut().for_each(|x| *x += shift);
            }
        }
    }
    let told = |error: SnapshotError| error.to_string();
    let mut snapshot = Snapshot::new(dimension, columns).map_err(told)?;
    if parts.iter().all(|(_, (_, ids))| ids.is_some()) {
        snapshot = snapshot
            .with_ids(parts.into_iter().flat_map(|(_, (_, ids))| ids.unwrap_or_default()).collect())
            .map_err(told)?;
    }
    let time_known = own.and_then(|own| own.get("TimeKnown")).and_then(AttrValue::as_u64) != Some(0);
    if let Some(time) =
        header.get("Time").and_then(AttrValue::to_f64s).and_then(|t| t.first().copied()).filter(|_| time_known)
    {
        snapshot = snapshot.at_time(time);
    }
    let periodic = own.and_then(|own| own.get("Periodic")).and_then(AttrValue::to_u64s);
    match (numbers("BoxLower"), numbers("BoxUpper"), periodic) {
        (Some(lower), Some(upper), Some(periodic)) => {
            let frame = Frame { lower, upper, periodic: periodic.iter().map(|p| *p != 0).collect() };
            snapshot.in_frame(frame).map_err(told)
        }
        _ => Ok(snapshot),
    }
}

/// The number of dimensions: as a file says, or as its particles need.
fn dimension(columns: &[Column], own: Option<&Attributes>, header: &Attributes) -> Result<usize, String> {
    let stated =
        own.unwrap_or(header).get("Dimension").and_then(AttrValue::to_i64s).and_then(|all| all.first().copied());
    match stated {
        Some(dimension @ 1..=3) => return Ok(dimension as usize),
        Some(other) => return Err(format!("the attribute Dimension is {other}; it must be 1, 2 or 3")),
        None => {}
    }
    let column = |name: &str| columns.iter().find(|column| column.name == name).map(|column| column.values.as_slice());
    let position = AXES.map(|axis| column(axis).unwrap_or(&[]));
    Ok(axes_in_use(position, AXES.map(|axis| column(&format!("velocity_{axis}")))))
}

/// Removes the components of vectors along axes that are none.
fn trim(columns: &mut Vec<Column>, dimension: usize) {
    let names: Vec<String> = columns.iter().map(|column| column.name.clone()).collect();
    columns.retain(|column| {
        AXES[dimension..].iter().all(|axis| {
            let of_vector = column.name.strip_suffix(&format!("_{axis}"));
            column.name != *axis && !of_vector.is_some_and(|stem| names.contains(&format!("{stem}_x")))
        })
    });
}

fn component_name(stem: &str, component: usize, width: usize) -> String {
    match (stem, width) {
        ("position", _) => AXES[component.min(2)].into(),
        (_, 1) => stem.into(),
        (_, 3) => format!("{stem}_{}", AXES[component]),
        _ => format!("{stem}_{component}"),
    }
}
