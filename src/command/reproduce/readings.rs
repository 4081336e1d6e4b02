//! Which of our measurements stands beside which published number.

use crate::command::sweep::Record;
use etalon_reference::scenes::Name;

/// Where a number is found in what is remembered of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Read {
    /// The mean error of this field against the solution.
    Error(&'static str),
    /// The last value of this quantity.
    Last(&'static str),
    /// Its largest value.
    Largest(&'static str),
}

/// How a published quantity is measured here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// Its key in `spec/tables/`.
    pub quantity: &'static str,
    /// What is run.
    pub scene: Name,
    /// Where it is found.
    pub read: Read,
    /// What ours is multiplied with where the paper's box is deeper or shallower: the depth of the paper's box for sums over a two-dimensional one.
    pub depth: f64,
    /// What a reader of both numbers must know beside the paper's own caveat.
    pub note: &'static str,
}

/// All that can be set beside each other.
pub const READINGS: &[Reading] = &[Reading {
    quantity: "shock_tube_velocity_l1",
    scene: Name::Sod,
    read: Read::Error("velocity_x"),
    depth: 1.0,
    note: "from a sharp start; the printed start cannot reach the printed figures (docs/sod.md)",
}];

impl Reading {
    /// Ours, from a run; none if it did not measure it.
    pub fn of(&self, record: &Record) -> Option<f64> {
        let found = match self.read {
            Read::Error(field) => record.l1.get(field),
            Read::Last(name) => record.last.get(name),
            Read::Largest(name) => record.largest.get(name),
        };
        found.map(|value| value * self.depth)
    }
}
