//! What rounding does to this flow: the ground on which tolerances stand.
//!
//! Two correct computations round differently, and the flow carries every rounding on; how far depends on the flow. So it is measured,
//! with the reference alone: it runs once more for each precision that is to be judged, and in every step each particle that moves is
//! changed at random, as that precision's roundings would change it. What comes out differs from the reference by what rounding may do.

use super::noisy::{Noise, Noisy};
use super::progress::Progress;
use super::seen::{FIELDS, VELOCITY};
use super::simulate::{Finished, Task};
use super::timed::Timed;
use crate::command::choices::Precision;
use crate::command::failure::Failure;
use crate::command::restarts::Restarts;
use crate::report::model::Tolerance;
use crate::report::plain;
use etalon_reference::domain::{DOUBLE_PLACES, SINGLE_PLACES};
use etalon_reference::engine::PlainEngine;
use etalon_reference::norms::l2_error;
use etalon_reference::particles::ParticleSet;

/// Roundings of about a particle's own numbers in a step: velocity and energy are written twice, the smoothing length once; density,
/// pressure, its coefficient, the sums of the last sweep, and the kernels' arguments and values make up the rest. Terms of sums round
/// too, but average out over the neighbours.
const ROUNDINGS_PER_STEP: f64 = 16.0;

/// The noise is one sample of what may happen, and a few growing modes can dominate it: another sample may be some times as large.
const SPREAD: f64 = 4.0;

/// A difference above this is never excused, whatever rounding is found to do: such a flow tells one kernel from another no more.
const MOST: f64 = 0.01;

/// How far random roundings of one precision carry each field from the reference.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensitivity {
    precision: Precision,
    /// Root of the mean square difference in units of the field's scale.
    response: [f64; FIELDS],
    steps: u64,
}

/// What differences of each field are measured in: the largest magnitude that the reference has, and for the velocity at least the
/// largest `sqrt(P / rho)`, which is about the speed of sound: the sums that accelerate a particle cancel terms of that size, so a gas
/// at rest has velocities that are rounding and nothing else.
pub fn scales(reference: &Finished) -> [f64; FIELDS] {
    let columns = reference.seen.compared();
    let state = &reference.seen.state;
    let thermal = state.pressure.iter().zip(&state.density).map(|(p, rho)| (p / rho).sqrt()).fold(0.0, f64::max);
    std::array::from_fn(|k| {
        let least = if k == VELOCITY { thermal } else { 0.0 };
        // A gas without any heat has no scale of it; what is zero in both runs differs by nothing in any.
        columns[k].iter().fold(least.max(f64::MIN_POSITIVE), |largest, v| largest.max(v.abs()))
    })
}

/// The spacing of positions in sides of the box: 32 bits beside `f32`, 53 beside `f64`.
fn grid(precision: Precision) -> f64 {
    match precision {
        Precision::Single => 1.0 / SINGLE_PLACES,
        Precision::Double => 1.0 / DOUBLE_PLACES,
    }
}

impl Sensitivity {
    /// Runs the reference with random roundings of that precision.
    pub fn measure<const D: usize>(
        precision: Precision,
        task: &Task<'_, D>,
        set: &ParticleSet<D>,
        reference: &Finished,
        restarts: Option<&Restarts>,
        shown: bool,
    ) -> Result<Self, Failure> {
        let noise = Noise {
            relative: ROUNDINGS_PER_STEP.sqrt() * precision.unit_roundoff(),
            // Rounded to the nearest, a position is off by at most half a grid spacing; the reference rounds its own as well.
            place: set.domain().torus_length().map(|side| side * grid(precision)),
        };
        let label = format!("reference f64, rounded like {precision} at random");
        // The random numbers of a run half-way are kept nowhere.
        let restart = restarts.map(|all| all.of(&Self::engine(precision), &task.physics, set).of_the_end_only());
        let engine = Timed::new(Noisy::new(PlainEngine::<f64, D>::new(set), noise));
        let noisy = task.simulate(engine, set.domain(), Progress::new(&label, task.end_time, shown), restart)?;
        let mut response = [0.0; FIELDS];
        let pairs = reference.seen.compared().into_iter().zip(noisy.seen.compared());
        for (k, ((a, b), scale)) in pairs.zip(scales(reference)).enumerate() {
            response[k] = rms(a, b)? / scale;
        }
        Ok(Sensitivity { precision, response, steps: reference.steps })
    }

    /// What its run is called in a restart file.
    pub fn engine(precision: Precision) -> String {
        format!("rounded like {precision}")
    }

    /// The precision it is about.
    pub fn precision(&self) -> Precision {
        self.precision
    }

    /// What the rms difference of a field may be, in units of its scale.
    pub fn tolerance(&self, field: usize, name: &str) -> Tolerance {
        let (unit, place) = match self.precision {
            Precision::Single => ("2⁻²⁴", "2⁻³²"),
            Precision::Double => ("2⁻⁵³", "2⁻⁵³"),
        };
        // A field that the flow does not disturb is still rounded itself.
        let value = (SPREAD * self.response[field]).max(self.precision.unit_roundoff());
        let capped = if value > MOST { format!("{MOST} at most, and less than ") } else { String::new() };
        Tolerance::new(
            value.min(MOST),
            format!(
                "{capped}{SPREAD} × {}, which is how far {} goes in the reference itself when each of its {} steps changes every particle at \
                 random by √{ROUNDINGS_PER_STEP} × {unit} (about {ROUNDINGS_PER_STEP} roundings) and its position by {place} of the box; \
                 {SPREAD} for the spread between one sample of such noise and another",
                plain(self.response[field]),
                name,
                self.steps,
            ),
        )
    }
}

/// Root of the mean square difference over all particles.
pub fn rms(a: &[f64], b: &[f64]) -> Result<f64, Failure> {
    let everywhere = (f64::NEG_INFINITY, f64::INFINITY);
    l2_error(a, b, a, everywhere).map_err(|error| Failure::Broken(error.to_string()))
}
