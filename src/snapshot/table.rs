//! The particles at one moment, as columns.

use super::SnapshotError;
use crate::report::Particles;
use etalon_reference::domain::Domain;
use std::collections::HashSet;

/// The names of the axes.
pub(super) const AXES: [&str; 3] = ["x", "y", "z"];

/// The column that tells kinds of particles apart, where there are several: 0 for gas, 1 for dust.
pub const PARTICLE_TYPE: &str = "particle_type";

/// One number of every particle.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Name, for example `velocity_x`: ASCII letters, digits and `_`.
    pub name: String,
    /// Unit, in words or symbols; empty for a pure number, or where a file does not say.
    pub unit: String,
    /// One value a particle.
    pub values: Vec<f64>,
}

impl Column {
    /// A column.
    pub fn new(name: impl Into<String>, unit: impl Into<String>, values: Vec<f64>) -> Self {
        Column { name: name.into(), unit: unit.into(), values }
    }
}

/// The box the particles are in, axis by axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// Its lower ends.
    pub lower: Vec<f64>,
    /// Its upper ends.
    pub upper: Vec<f64>,
    /// Which axes close on themselves.
    pub periodic: Vec<bool>,
}

impl<const D: usize> From<&Domain<D>> for Frame {
    fn from(domain: &Domain<D>) -> Self {
        Frame { lower: domain.lower().to_vec(), upper: domain.upper().to_vec(), periodic: domain.periodic().to_vec() }
    }
}

/// The particles at one moment. Positions are the columns `x`, `y`, `z`, as many as there are dimensions.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    dimension: usize,
    columns: Vec<Column>,
    ids: Option<Vec<u64>>,
    time: Option<f64>,
    frame: Option<Frame>,
}

impl Snapshot {
    /// Particles in so many dimensions.
    ///
    /// # Errors
    /// [`SnapshotError::Invalid`] naming the column, and the row where it is one: not 1 to 3 dimensions, no column for the position on one of
    /// the axes, or one for an axis that is not there; no particles; names that are not plain or come twice; columns of unequal length;
    /// numbers that are not finite.
    pub fn new(dimension: usize, columns: Vec<Column>) -> Result<Self, SnapshotError> {
        let refused = |problem: String| Err(SnapshotError::Invalid(problem));
        if !(1..=3).contains(&dimension) {
            return refused(format!("it is of {dimension} dimensions; there are 1, 2 or 3"));
        }
        for (axis, name) in AXES.iter().enumerate() {
            if columns.iter().any(|column| column.name == *name) != (axis < dimension) {
                let there = if axis < dimension { "there is no" } else { "there is a" };
                return refused(format!("{there} column `{name}` in {dimension} dimensions"));
            }
        }
        let rows = columns[0].values.len();
        if rows == 0 {
            return refused("there is no particle in it; a snapshot has at least one".into());
        }
        let mut names = HashSet::new();
        for Column { name, values, .. } in &columns {
            if name.is_empty() || name == "id" || !name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_') {
                return refused(format!(
                    "a column is called `{name}`; a name is made of ASCII letters, digits and `_`, and is not `id`"
                ));
            }
            if !names.insert(name) {
                return refused(format!("there are two columns `{name}`; keep one"));
            }
            if values.len() != rows {
                return refused(format!("column `{name}` has {} values for {rows} particles", values.len()));
            }
            if let Some(row) = values.iter().position(|value| !value.is_finite()) {
                return refused(format!("{name} of particle {row} is {}; it must be a finite number", values[row]));
            }
        }
        Ok(Snapshot { dimension, columns, ids: None, time: None, frame: None })
    }

    /// The same with these numbers of the particles.
    ///
    /// # Errors
    /// [`SnapshotError::Invalid`] for another number of them, or one that comes twice.
    pub fn with_ids(mut self, ids: Vec<u64>) -> Result<Self, SnapshotError> {
        let rows = self.len();
        if ids.len() != rows {
            return Err(SnapshotError::Invalid(format!("there are {} ids for {rows} particles", ids.len())));
        }
        let mut seen = HashSet::with_capacity(rows);
        if let Some(twice) = ids.iter().find(|id| !seen.insert(**id)) {
            return Err(SnapshotError::Invalid(format!("two particles have the id {twice}; each needs its own")));
        }
        self.ids = Some(ids);
        Ok(self)
    }

    /// The same at this time. One that is not finite is none.
    pub fn at_time(mut self, time: f64) -> Self {
        self.time = Some(time).filter(|time| time.is_finite());
        self
    }

    /// The same in this box.
    ///
    /// # Errors
    /// [`SnapshotError::Invalid`] if it has other dimensions or no finite positive length on one of them.
    pub fn in_frame(mut self, frame: Frame) -> Result<Self, SnapshotError> {
        let axes = [frame.lower.len(), frame.upper.len(), frame.periodic.len()];
        if axes != [self.dimension; 3] {
            let problem = format!("the box has {} axes for {} dimensions", axes[0], self.dimension);
            return Err(SnapshotError::Invalid(problem));
        }
        for (axis, (lower, upper)) in AXES.iter().zip(frame.lower.iter().zip(&frame.upper)) {
            if !(lower.is_finite() && upper.is_finite() && upper > lower) {
                let problem =
                    format!("the box runs from {lower} to {upper} along {axis}; it needs a finite positive length");
                return Err(SnapshotError::Invalid(problem));
            }
        }
        self.frame = Some(frame);
        Ok(self)
    }

    /// How many dimensions.
    pub fn dimension(&self) -> usize {
        self.dimension
    }
    /// How many particles; never zero.
    #[allow(clippy::len_without_is_empty)]
    pub fn len(&self) -> usize {
        self.columns[0].values.len()
    }
    /// All columns.
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }
    /// The values of a column.
    pub fn column(&self, name: &str) -> Option<&[f64]> {
        self.columns.iter().find(|column| column.name == name).map(|column| column.values.as_slice())
    }
    /// The positions, axis by axis.
    pub fn position(&self) -> Vec<&[f64]> {
        AXES[..self.dimension].iter().filter_map(|axis| self.column(axis)).collect()
    }
    /// The particles' numbers, where they have any of their own.
    pub fn ids(&self) -> Option<&[u64]> {
        self.ids.as_deref()
    }
    /// The number of a particle: its own, or that of its row.
    pub fn id(&self, row: usize) -> u64 {
        self.ids.as_ref().map_or(row as u64, |ids| ids[row])
    }
    /// The time, where it is known.
    pub fn time(&self) -> Option<f64> {
        self.time
    }
    /// The box, where it is known.
    pub fn frame(&self) -> Option<&Frame> {
        self.frame.as_ref()
    }

    /// As a table for the report's writers.
    pub(super) fn table(&self) -> Result<Particles<'_>, SnapshotError> {
        let columns =
            self.columns.iter().map(|Column { name, unit, values }| crate::report::Column { name, unit, values });
        let table = Particles::new(columns.collect());
        let mut table = table.map_err(|error| SnapshotError::Invalid(error.to_string()))?;
        table.ids = self.ids.as_deref();
        table.time = self.time;
        Ok(table)
    }
}

/// How many axes particles need whose places and velocities are given on three: those at the end on which nothing differs and nothing
/// moves are none.
pub(super) fn axes_in_use(position: [&[f64]; 3], velocity: [Option<&[f64]>; 3]) -> usize {
    let used = |axis: usize| {
        let differs = position[axis].windows(2).any(|pair| pair[0] != pair[1]);
        differs || velocity[axis].is_some_and(|column| column.iter().any(|v| *v != 0.0))
    };
    (1..3).rev().find(|&axis| used(axis)).map_or(1, |axis| axis + 1)
}

#[cfg(test)]
mod tests {
    use super::super::testing::small;
    use super::*;

    #[test]
    fn what_is_no_snapshot_is_refused_by_name() {
        let column = |name: &str, values: &[f64]| Column::new(name, "", values.to_vec());
        let message = |dimension, columns: Vec<Column>| Snapshot::new(dimension, columns).unwrap_err().to_string();
        let x = || column("x", &[0.0, 1.0]);
        assert_eq!(message(4, vec![x()]), "it is of 4 dimensions; there are 1, 2 or 3");
        assert_eq!(message(2, vec![x()]), "there is no column `y` in 2 dimensions");
        assert_eq!(message(1, vec![x(), column("y", &[0.0; 2])]), "there is a column `y` in 1 dimensions");
        assert!(message(1, vec![column("x", &[])]).contains("no particle"));
        assert!(message(1, vec![x(), column("a b", &[0.0; 2])]).contains("`a b`"));
        assert!(message(1, vec![x(), x()]).contains("two columns `x`"));
        assert_eq!(message(1, vec![x(), column("mass", &[1.0])]), "column `mass` has 1 values for 2 particles");
        let spoilt = vec![x(), column("mass", &[1.0, f64::NAN])];
        assert_eq!(message(1, spoilt), "mass of particle 1 is NaN; it must be a finite number");
        let ids = |ids: &[u64]| small(1).with_ids(ids.to_vec()).unwrap_err().to_string();
        assert_eq!(ids(&[1, 2]), "there are 2 ids for 3 particles");
        assert!(ids(&[1, 2, 1]).starts_with("two particles have the id 1;"));
        let frame = Frame { lower: vec![0.0], upper: vec![0.0], periodic: vec![false] };
        assert!(small(1).in_frame(frame.clone()).unwrap_err().to_string().contains("along x"));
        assert!(small(2).in_frame(frame).unwrap_err().to_string().contains("1 axes for 2 dimensions"));
    }

    #[test]
    fn axes_on_which_nothing_happens_are_none() {
        let (flat, spread) = ([0.5, 0.5], [0.0, 1.0]);
        assert_eq!(axes_in_use([&spread, &flat, &flat], [None; 3]), 1);
        assert_eq!(axes_in_use([&spread, &spread, &flat], [None; 3]), 2);
        assert_eq!(axes_in_use([&flat, &flat, &spread], [None; 3]), 3);
        assert_eq!(axes_in_use([&spread, &flat, &flat], [None, Some(&spread), None]), 2);
    }
}
