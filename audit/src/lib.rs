//! The audit: how far each equation is from the truth on each target, whether its units fit, and what encloses it.
//!
//! Each equation of [`etalon_reference`] has one or more [`Probe`]s: a declaration of its arguments (symbol, unit, domain), its
//! results, and the call, generic over the number type. [`probes`] lists them all. From a probe follow:
//!
//! | question | answer |
//! |---|---|
//! | how far from the truth? | [`measure`] on a [`Target`] against the [`Quad`] oracle, in ulps; [`Budgets`] is the record |
//! | how far can it be? | [`Gauge`]: the budget that follows from the operations |
//! | what can it give at all? | [`enclose`]: rigorous bounds over its domain, by [`Interval`]s |
//! | what of bad input? | [`outcomes`], [`unsaid`], [`bad_input_differences`]: NaN, infinities, zeros, wrong signs |
//! | do its units fit? | [`check_units`]: every node of the drawn graph |
//! | what does the code compute? | [`formula`] in LaTeX; [`Probe::draw`], printed by [`etalon_kernels_gen::emit`] |
//!
//! ```
//! use etalon_audit::{Budgets, Target, measure, probes};
//!
//! let probes = probes();
//! let balsara = probes.iter().find(|probe| probe.function == "balsara_limiter").ok_or("no such probe")?;
//! let measurement = measure(balsara, Target::ScalarSingle, 1000);
//! assert!(measurement.of_scale.ulps <= measurement.budget);
//! assert_eq!(Budgets::recorded()?.compare(&measurement), []);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! `docs/audit.md` explains the figures and their reasons; `docs/how-to/equation.md` says how to add a probe.
#![forbid(unsafe_code)]

mod bad_input;
mod budgets;
mod catalogue;
mod declare;
mod device;
mod domain;
mod enclosure;
mod encoded;
mod formula;
mod gains;
pub mod gauge;
mod interval;
mod measure;
mod number;
pub mod page;
mod probe;
mod probes;
mod quad;
mod ranges;
mod reach;
mod records;
mod sample;
mod shaped;
mod state;
mod target;
mod textbook;
mod units;

pub use bad_input::{
    BadInputFault, Kind, Outcome, Trial, Unnumbered, differences as bad_input_differences, not_caught, of_unnumbered,
    outcomes, trials, unsaid,
};
pub use budgets::{Budgets, FULL_SAMPLES, Record, Regression};
pub use catalogue::{Catalogue, CatalogueError, Subject, Unknown, is_host};
pub use device::{Device, DeviceError, text_mark};
pub use domain::{Domain, Spread, any, between, not_negative, positive};
pub use enclosure::{Enclosure, Gap, enclose};
pub use encoded::{Encoded, EncodedFunction, Vanished, path_of};
pub use formula::formula;
pub use gains::{Gain, GainErrors, Gains};
pub use gauge::Gauge;
pub use interval::{Decided, Interval};
pub use measure::{Measurement, RunBy, Violation, Worst, measure, measure_inputs, measure_on, measure_targets};
pub use number::{Body, Evaluators, Number};
pub use probe::{Argument, Declaration, Name, Probe, Quantity, WrongCount, own};
pub use probes::{of_equation, probes};
pub use quad::{NotANumber, Quad};
pub use ranges::{BOXES, Range, Ranges};
pub use reach::{Equivalent, Mutants, Noticed, Reach};
pub use records::RecordError;
pub use sample::{all_inputs, hard_inputs, random_inputs};
pub use shaped::{Shaped, take};
pub use state::{Error as TargetError, Row, State, Survey, Worse};
pub use target::{Label, Target, UnknownTarget};
pub use textbook::{Elementary, Errors, Textbook, textbooks};
pub use units::{UnitFault, check_units};

/// What [`probe!`] refers to. Not for direct use.
#[doc(hidden)]
pub mod macro_parts {
    pub use crate::{Argument, Body, Declaration, Probe, Quantity, Shaped, take};
    pub use etalon_kernels_gen::{Matrix, Real, Symmetric, Vector};
}
