//! What is measured at a run's end alone: what is costly, what takes the whole course of a run, or what gas at rest does not have.

use super::State;

/// A run that has ended.
#[derive(Clone, Copy, Debug)]
pub struct Course<'a> {
    /// The state at the end.
    pub end: &'a State,
    /// When something was measured on the way, ascending.
    pub time: &'a [f64],
    /// The scene's quantities then, in their order, each as long as `time`.
    pub values: &'a [Vec<f64>],
}

impl<'a> Course<'a> {
    /// Of which only the end is known.
    pub fn to(end: &'a State) -> Self {
        Course { end, time: &[], values: &[] }
    }
}

/// What is measured at the end.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AtEnd {
    /// The value of each quantity, in their order; or why it has none and what would give it one, in a clause.
    pub values: Vec<Result<f64, String>>,
    /// One number over another; those that this end does not have are left out.
    pub curves: Vec<Curve>,
}

/// One number over another at a run's end.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// As a file is named: lower-case letters, digits and `_`.
    pub name: &'static str,
    /// For people.
    pub label: &'static str,
    /// What it runs along.
    pub x: Axis,
    /// What it shows.
    pub y: Axis,
    /// Its points, by rising `x`; positive along a logarithmic axis.
    pub points: Vec<(f64, f64)>,
    /// What it should look like, where that is known.
    pub expected: Option<Expected>,
}

/// An axis of a [`Curve`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// As a column is named.
    pub name: &'static str,
    /// For people, with its symbol.
    pub label: &'static str,
    /// Its unit; empty for a plain number.
    pub unit: &'static str,
    /// Whether it is drawn by powers of ten.
    pub logarithmic: bool,
}

/// What a [`Curve`] should look like.
#[derive(Clone, Debug, PartialEq)]
pub struct Expected {
    /// What it is and where it is from.
    pub source: &'static str,
    /// The corners of a line, by rising `x`.
    pub points: Vec<(f64, f64)>,
}
