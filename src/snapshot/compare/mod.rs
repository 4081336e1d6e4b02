//! Two snapshots beside each other: particle by particle, and as profiles.
//!
//! The first is what the second is measured against: the scale of each field, profiles and box are the first one's.

mod matching;
mod particles;
mod profile;

pub use matching::Matching;
pub use particles::{FieldDifference, Place};
pub use profile::{Bin, BinValue, Profile};

use super::{Snapshot, SnapshotError};
use serde::Serialize;
use std::fmt;
use std::str::FromStr;

/// Which particles of two snapshots belong together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// Those with the same id.
    Id,
    /// Those that are nearest to each other, both ways.
    Position,
    /// None: only profiles are compared.
    Profile,
}

impl By {
    /// All of them.
    pub const ALL: &'static [Self] = &[Self::Id, Self::Position, Self::Profile];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            By::Id => "id",
            By::Position => "position",
            By::Profile => "profile",
        }
    }
}

/// Along what profiles are taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Along {
    /// An axis, from 0.
    Axis(usize),
    /// The distance from a centre.
    Radius,
}

impl Along {
    /// All of them.
    pub const ALL: &'static [Self] = &[Self::Axis(0), Self::Axis(1), Self::Axis(2), Self::Radius];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Along::Axis(axis) => super::table::AXES[axis.min(2)],
            Along::Radius => "r",
        }
    }
}

macro_rules! named {
    ($($kind:ident),*) => {$(
        impl fmt::Display for $kind {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(self.name())
            }
        }
        impl FromStr for $kind {
            type Err = String;
            fn from_str(text: &str) -> Result<Self, String> {
                let names = || Self::ALL.iter().map(|one| one.name()).collect::<Vec<_>>().join(", ");
                Self::ALL.iter().find(|one| one.name() == text).copied().ok_or_else(|| format!("there are {}; choose one of them", names()))
            }
        }
    )*};
}
named!(By, Along);

/// How two snapshots are to be compared.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Which particles belong together; if not said, by id where both files have them, else by position.
    pub by: Option<By>,
    /// How far apart particles that belong together may be, in position matching; if not said, half the mean spacing.
    pub within: Option<f64>,
    /// Along what profiles are taken.
    pub along: Along,
    /// From where radii are counted; if not said, the middle of the first one's box, or of its particles.
    pub centre: Option<Vec<f64>>,
    /// How many intervals a profile has.
    pub bins: usize,
}

impl Default for Options {
    fn default() -> Self {
        Options { by: None, within: None, along: Along::Axis(0), centre: None, bins: 50 }
    }
}

/// What came of it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Comparison {
    /// Dimensions of both.
    pub dimension: usize,
    /// Which particles belong together.
    pub by: &'static str,
    /// How many do; not there if only profiles were compared.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub matched: Option<Matched>,
    /// How the fields that both have differ, particle by particle; the worst first. Empty if only profiles were compared.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub fields: Vec<FieldDifference>,
    /// Along what the profiles are.
    pub along: &'static str,
    /// From where radii are counted, for those.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub centre: Option<Vec<f64>>,
    /// The same fields, averaged in intervals.
    pub profiles: Vec<Profile>,
    /// Fields that only the first has.
    pub only_in_a: Vec<String>,
    /// Fields that only the second has.
    pub only_in_b: Vec<String>,
}

/// How many particles belong together.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Matched {
    /// So many pairs.
    pub pairs: usize,
    /// So many of the first belong to none of the second.
    pub unmatched_a: usize,
    /// So many of the second belong to none of the first.
    pub unmatched_b: usize,
    /// How far apart they may be, where they are matched by position.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub within: Option<f64>,
}

impl Comparison {
    /// Fields and profiles that differ by more than this, in units of the field's scale: at any one particle, or, where only profiles were
    /// compared, in the mean of any interval.
    pub fn beyond(&self, tolerance: f64) -> Vec<String> {
        let beyond = |name: &String, found: f64| (found.is_nan() || found > tolerance).then(|| name.clone());
        match self.matched {
            Some(_) => self.fields.iter().filter_map(|field| beyond(&field.name, field.relative_max)).collect(),
            None => self.profiles.iter().filter_map(|profile| beyond(&profile.name, profile.relative_max)).collect(),
        }
    }
}

/// Compares a second snapshot with a first.
///
/// # Errors
/// [`SnapshotError::Invalid`]: other dimensions; no particle in common; ids asked for where there are none; a distance, centre or number of
/// intervals that is none; an axis that is not there.
pub fn compare(a: &Snapshot, b: &Snapshot, options: &Options) -> Result<Comparison, SnapshotError> {
    let refused = |problem: String| Err(SnapshotError::Invalid(problem));
    if a.dimension() != b.dimension() {
        return refused(format!(
            "the first snapshot has {} dimensions and the second {}; only such with the same number can be compared",
            a.dimension(),
            b.dimension()
        ));
    }
    let both_have_ids = a.ids().is_some() && b.ids().is_some();
    let by = options.by.unwrap_or(if both_have_ids { By::Id } else { By::Position });
    let matching = match by {
        By::Id if !both_have_ids => {
            let without = if a.ids().is_none() { "first" } else { "second" };
            return refused(format!(
                "the particles of the {without} snapshot have no ids; use --by position or --by profile"
            ));
        }
        By::Id => Some(Matching::by_id(a, b)),
        By::Position => Some(Matching::by_position(a, b, options.within)?),
        By::Profile => None,
    };
    if matching.as_ref().is_some_and(|matching| matching.pairs.is_empty()) {
        let remedy = match by {
            By::Id => "no id is in both snapshots; use --by position or --by profile",
            _ => "no particles of the two are as near as that to each other; use --within or --by profile",
        };
        return refused(remedy.into());
    }
    let names = |of: &Snapshot, other: &Snapshot| {
        let missing = of.columns().iter().filter(|column| other.column(&column.name).is_none());
        missing.map(|column| column.name.clone()).collect()
    };
    let mut fields = matching.as_ref().map_or_else(Vec::new, |matching| particles::differences(a, b, matching));
    fields.sort_by(|one, other| other.relative_max.total_cmp(&one.relative_max));
    let ruler = profile::Ruler::new(a, b, options)?;
    Ok(Comparison {
        dimension: a.dimension(),
        by: by.name(),
        matched: matching.map(|matching| Matched {
            pairs: matching.pairs.len(),
            unmatched_a: a.len() - matching.pairs.len(),
            unmatched_b: b.len() - matching.pairs.len(),
            within: matching.within,
        }),
        fields,
        along: options.along.name(),
        centre: ruler.centre().map(<[f64]>::to_vec),
        profiles: ruler.profiles(a, b),
        only_in_a: names(a, b),
        only_in_b: names(b, a),
    })
}

#[cfg(test)]
mod tests;
