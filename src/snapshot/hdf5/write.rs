//! Writing.

use super::super::names::{COORDINATES, IDS, dataset_of};
use super::super::table::{AXES, Column, PARTICLE_TYPE, Snapshot};
use super::super::{SnapshotError, atomic};
use super::{OWN, SCHEMA, SCHEMA_VERSION, TYPES};
use hdf5_pure::{AttrValue, FileBuilder};
use std::path::Path;

/// Writes all columns, in double precision: `name_x`, `name_y`, `name_z` as one dataset of three numbers a particle, others as they are.
///
/// # Errors
/// [`SnapshotError::Io`]; a particle type that is none.
pub fn write(snapshot: &Snapshot, path: &Path) -> Result<(), SnapshotError> {
    let rows_of = rows_by_type(snapshot)?;
    let mut file = FileBuilder::new();
    let origin = origin(snapshot);

    let mut header = file.create_group("Header");
    let counts: Vec<u32> = rows_of.iter().map(|rows| rows.len() as u32).collect();
    header.set_attr("NumPart_ThisFile", AttrValue::U32Array(counts.clone()));
    header.set_attr("NumPart_Total", AttrValue::U32Array(counts));
    header.set_attr(
        "NumPart_Total_HighWord",
        AttrValue::U32Array(rows_of.iter().map(|rows| (rows.len() as u64 >> 32) as u32).collect()),
    );
    header.set_attr("MassTable", AttrValue::F64Array(vec![0.0; TYPES]));
    header.set_attr("Time", AttrValue::F64(snapshot.time().unwrap_or(0.0)));
    header.set_attr("BoxSize", AttrValue::F64(box_size(snapshot, &origin)));
    header.set_attr("Dimension", AttrValue::I32(snapshot.dimension() as i32));
    header.set_attr("NumFilesPerSnapshot", AttrValue::I32(1));
    // Nothing expands; readers look for these all the same.
    for (name, value) in [("Redshift", 0.0), ("Omega0", 0.0), ("OmegaLambda", 0.0), ("HubbleParam", 1.0)] {
        header.set_attr(name, AttrValue::F64(value));
    }
    for flag in ["Flag_Sfr", "Flag_Cooling", "Flag_Feedback", "Flag_StellarAge", "Flag_Metals", "Flag_Entropy_ICs"] {
        header.set_attr(flag, AttrValue::I32(0));
    }
    file.add_group(header.finish());

    let mut own = file.create_group(OWN);
    own.set_attr("Schema", AttrValue::AsciiString(SCHEMA.into()));
    own.set_attr("SchemaVersion", AttrValue::U64(SCHEMA_VERSION));
    own.set_attr("Program", AttrValue::AsciiString(format!("etalon {}", env!("CARGO_PKG_VERSION"))));
    own.set_attr("Dimension", AttrValue::U64(snapshot.dimension() as u64));
    own.set_attr("TimeKnown", AttrValue::U8(snapshot.time().is_some().into()));
    own.set_attr("Origin", AttrValue::F64Array(origin.clone()));
    if let Some(frame) = snapshot.frame() {
        own.set_attr("BoxLower", AttrValue::F64Array(frame.lower.clone()));
        own.set_attr("BoxUpper", AttrValue::F64Array(frame.upper.clone()));
        own.set_attr("Periodic", AttrValue::U8Array(frame.periodic.iter().map(|p| (*p).into()).collect()));
    }
    file.add_group(own.finish());

    for (kind, rows) in rows_of.iter().enumerate().filter(|(_, rows)| !rows.is_empty()) {
        let mut group = file.create_group(&format!("PartType{kind}"));
        for Array { name, stem, unit, parts } in arrays(snapshot, &origin) {
            let values: Vec<f64> = rows.iter().flat_map(|&row| parts.iter().map(move |part| part.at(row))).collect();
            let shape: &[u64] = &[rows.len() as u64, parts.len() as u64];
            let dataset = group.create_dataset(&name);
            dataset.with_f64_data(&values).with_shape(if parts.len() == 1 { &shape[..1] } else { shape });
            dataset.set_attr("Column", AttrValue::AsciiString(stem));
            // A string of HDF5 has at least one character.
            let unit = if unit.is_empty() { "1" } else { unit };
            dataset.set_attr("Unit", AttrValue::String(unit.into()));
        }
        let ids: Vec<u64> = rows.iter().map(|&row| snapshot.id(row)).collect();
        group.create_dataset(IDS).with_u64_data(&ids).set_attr("Given", AttrValue::U8(snapshot.ids().is_some().into()));
        file.add_group(group.finish());
    }
    let mut failed = None;
    atomic::write(path, |out| {
        file.finish_to(out).map_err(|error| {
            failed = Some(error.to_string());
            std::io::Error::other("see below")
        })
    })
    .map_err(|error| match failed {
        Some(problem) => SnapshotError::file(path, format!("it cannot be written as HDF5 ({problem})")),
        None => error,
    })
}

/// The rows of each kind of particle.
fn rows_by_type(snapshot: &Snapshot) -> Result<[Vec<usize>; TYPES], SnapshotError> {
    let mut rows_of: [Vec<usize>; TYPES] = Default::default();
    let kinds = snapshot.column(PARTICLE_TYPE);
    for row in 0..snapshot.len() {
        let kind = kinds.map_or(0.0, |kinds| kinds[row]);
        if !(kind.fract() == 0.0 && (0.0..TYPES as f64).contains(&kind)) {
            let problem = format!(
                "{PARTICLE_TYPE} of particle {row} is {kind}; it must be a whole number from 0 to {}",
                TYPES - 1
            );
            return Err(SnapshotError::Invalid(problem));
        }
        rows_of[kind as usize].push(row);
    }
    Ok(rows_of)
}

/// What is subtracted from places, for the layout's boxes begin at zero.
fn origin(snapshot: &Snapshot) -> Vec<f64> {
    let smallest = |column: &[f64]| column.iter().copied().fold(f64::INFINITY, f64::min);
    let frame = snapshot.frame();
    let of_axis = |(axis, column): (usize, &&[f64])| match frame {
        // On an open axis particles may have left the box.
        Some(frame) if frame.periodic[axis] => frame.lower[axis],
        Some(frame) => frame.lower[axis].min(smallest(column)),
        None => smallest(column),
    };
    snapshot.position().iter().enumerate().map(of_axis).collect()
}

/// The side of the cube from the origin that holds box and particles.
fn box_size(snapshot: &Snapshot, origin: &[f64]) -> f64 {
    let largest = |column: &[f64]| column.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let side = |(axis, column): (usize, &&[f64])| {
        let upper = snapshot.frame().map_or(f64::NEG_INFINITY, |frame| frame.upper[axis]);
        upper.max(largest(column)) - origin[axis]
    };
    let side = snapshot.position().iter().enumerate().map(side).fold(0.0, f64::max);
    if side > 0.0 { side } else { 1.0 }
}

/// One number of each particle: a column, perhaps shifted, or zero.
struct Part<'a> {
    values: Option<&'a [f64]>,
    shift: f64,
}

impl Part<'_> {
    fn at(&self, row: usize) -> f64 {
        self.values.map_or(0.0, |values| values[row] - self.shift)
    }
}

/// A dataset.
struct Array<'a> {
    name: String,
    stem: String,
    unit: &'a str,
    parts: Vec<Part<'a>>,
}

/// All datasets but the ids.
fn arrays<'a>(snapshot: &'a Snapshot, origin: &[f64]) -> Vec<Array<'a>> {
    let column = |name: &str| snapshot.columns().iter().find(|column| column.name == name);
    let vector = |named: &dyn Fn(&str) -> String, origin: &[f64]| -> Vec<Part<'a>> {
        let part = |(axis, name): (usize, &&str)| Part {
            values: column(&named(name)).map(|column| column.values.as_slice()),
            shift: origin.get(axis).copied().unwrap_or(0.0),
        };
        AXES.iter().enumerate().map(part).collect()
    };
    let unit = |name: &str| column(name).map_or("", |column| column.unit.as_str());
    let position = vector(&|axis| axis.into(), origin);
    let mut all = vec![Array { name: COORDINATES.into(), stem: "position".into(), unit: unit("x"), parts: position }];
    for Column { name, unit, values } in snapshot.columns() {
        if AXES.contains(&name.as_str()) || name == PARTICLE_TYPE {
            continue;
        }
        // A vector is one if it has all axes that there are.
        let stem = name.rsplit_once('_').filter(|(stem, axis)| {
            let there = |axis: &&str| column(&format!("{stem}_{axis}")).is_some();
            !stem.is_empty() && AXES.contains(axis) && AXES[..snapshot.dimension()].iter().all(there)
        });
        match stem {
            Some((stem, _)) if all.iter().any(|array| array.stem == stem && array.parts.len() == 3) => {}
            Some((stem, _)) => {
                let parts = vector(&|axis| format!("{stem}_{axis}"), &[]);
                all.push(Array { name: dataset_of(stem), stem: stem.into(), unit, parts });
            }
            None => {
                let parts = vec![Part { values: Some(values), shift: 0.0 }];
                all.push(Array { name: dataset_of(name), stem: name.clone(), unit, parts });
            }
        }
    }
    all
}
