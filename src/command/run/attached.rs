//! Files of a run that other programs open: the final particles as HDF5, and what was measured on the way as tables.

use crate::report::Attachment;
use crate::report::model::{EndCurve, Report, Series};
use crate::snapshot::series::{Quantity, SeriesWriter};
use crate::snapshot::{Column, Format, Frame, PARTICLE_TYPE, Snapshot, SnapshotError};
use etalon_reference::domain::Domain;
use etalon_reference::scenes::State;
use std::path::Path;

const AXES: [&str; 3] = ["x", "y", "z"];
const VELOCITIES: [&str; 3] = ["velocity_x", "velocity_y", "velocity_z"];

/// The files of a report: `particles.hdf5`, and of each run that measured something `series_BACKEND_PRECISION.csv` and
/// `curve_NAME_BACKEND_PRECISION.csv`.
pub fn attachments<'a, const D: usize>(
    report: &'a Report,
    particles: Option<&'a State>,
    domain: &'a Domain<D>,
) -> Vec<Attachment<'a>> {
    let mut all = Vec::new();
    if let Some(state) = particles {
        all.push(Attachment {
            file: "particles.hdf5".into(),
            save: Box::new(move |path| in_words(hdf5(state, domain).and_then(|s| s.write(path, Format::Hdf5)))),
        });
    }
    for (_, run, measured) in report.measured() {
        let series = &measured.series;
        if !series.quantities.is_empty() {
            all.push(Attachment {
                file: format!("series_{}_{}.csv", run.backend, run.precision),
                save: Box::new(move |path| in_words(table(series, path))),
            });
        }
        for curve in &measured.ending.curves {
            all.push(Attachment {
                file: format!("curve_{}_{}_{}.csv", curve.name, run.backend, run.precision),
                save: Box::new(move |path| in_words(points(curve, path))),
            });
        }
    }
    all
}

fn in_words(done: Result<(), SnapshotError>) -> Result<(), String> {
    done.map_err(|error| error.to_string())
}

fn hdf5<const D: usize>(state: &State, domain: &Domain<D>) -> Result<Snapshot, SnapshotError> {
    let mut columns = Vec::new();
    let mut put = |name: &str, unit: &str, values: &[f64]| columns.push(Column::new(name, unit, values.to_vec()));
    for axis in 0..D {
        put(AXES[axis], "L", &state.position[axis]);
        put(VELOCITIES[axis], "L T^-1", &state.velocity[axis]);
    }
    put("mass", "M", &state.mass);
    put("density", "M L^-nu", &state.density);
    put("pressure", "M L^(2-nu) T^-2", &state.pressure);
    put("internal_energy", "L^2 T^-2", &state.internal_energy);
    put("smoothing_length", "L", &state.smoothing_length);
    put("mobility", "", &state.mobility);
    if !state.species.is_empty() {
        put(PARTICLE_TYPE, "", &state.species);
    }
    let ids = (0..state.len() as u64).collect();
    Snapshot::new(D, columns)?.with_ids(ids)?.at_time(state.time).in_frame(Frame::from(domain))
}

fn table(series: &Series, path: &Path) -> Result<(), SnapshotError> {
    let columns = series.quantities.iter().map(|q| Quantity::new(q.name.as_str(), q.unit.as_str()));
    let columns: Vec<Quantity> = std::iter::once(Quantity::new("time", "T")).chain(columns).collect();
    let mut writer = SeriesWriter::create(path, &columns)?;
    for (row, time) in series.time.iter().enumerate() {
        let values = series.quantities.iter().map(|quantity| quantity.value[row]);
        writer.append(&std::iter::once(*time).chain(values).collect::<Vec<f64>>())?;
    }
    Ok(())
}

fn points(curve: &EndCurve, path: &Path) -> Result<(), SnapshotError> {
    let columns = [&curve.x, &curve.y].map(|column| Quantity::new(column.name.as_str(), column.unit.as_str()));
    let mut writer = SeriesWriter::create(path, &columns)?;
    curve.points().try_for_each(|(x, y)| writer.append(&[x, y]))
}
