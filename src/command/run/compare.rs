//! A run against the exact solution, against the reference, and against itself at the start.

use super::exact::Exact;
use super::sensitivity::{Sensitivity, rms, scales};
use super::simulate::Finished;
use super::state::{COMPARED, State};
use crate::command::failure::Failure;
use crate::report::model::{
    Conserved, FieldDifference, FieldError, Norm, Profile, ProfileField, Tolerance, stratified,
};
use crate::report::plain;
use etalon_reference::norms::{NormError, l1_error, l2_error, max_error};
use etalon_reference::scenes::sod;

/// Particles shown in plots.
const SHOWN: usize = 1200;

/// First source of error: distance from the exact solution over the particles in the measured range.
pub fn discretisation(state: &State, exact: &Exact) -> Result<Vec<FieldError>, Failure> {
    let x = &state.position[0];
    let truth = exact.columns(x);
    let (from, to) = sod::MEASURED;
    let particles = x.iter().filter(|x| (from..=to).contains(*x)).count() as u64;
    let error = |k: usize| -> Result<FieldError, NormError> {
        let (found, truth) = (state.compared()[k], &truth[k]);
        Ok(FieldError {
            field: COMPARED[k].into(),
            l1: l1_error(found, truth, x, sod::MEASURED)?,
            l2: l2_error(found, truth, x, sod::MEASURED)?,
            max: max_error(found, truth, x, sod::MEASURED)?,
            particles,
        })
    };
    (0..COMPARED.len()).map(|k| error(k).map_err(|e| Failure::Broken(format!("{}: {e}", COMPARED[k])))).collect()
}

/// Second source of error: distance from the reference, particle by particle.
pub fn arithmetic(
    run: &Finished,
    reference: &Finished,
    sensitivity: &Sensitivity,
) -> Result<Vec<FieldDifference>, Failure> {
    let scale = scales(reference);
    let mut all = Vec::new();
    for (k, (found, wanted)) in run.state.compared().into_iter().zip(reference.state.compared()).enumerate() {
        let max = found.iter().zip(wanted).fold(0.0, |largest: f64, (a, b)| largest.max((a - b).abs()));
        let tolerance = sensitivity.tolerance(k);
        all.push(FieldDifference::new(COMPARED[k], rms(found, wanted)?, max, scale[k], Norm::Rms, tolerance));
    }
    Ok(all)
}

/// The reference's run, and how far another may go from it: what a drift of conserved totals is held against.
#[derive(Clone, Copy)]
pub struct Yardstick<'a> {
    reference: &'a Finished,
    sensitivity: &'a Sensitivity,
    /// The share of all particles that move.
    moving: f64,
}

impl<'a> Yardstick<'a> {
    /// Of the reference, and the precision of the run that is judged.
    pub fn new(reference: &'a Finished, sensitivity: &'a Sensitivity, mobile: &[bool]) -> Self {
        let moving = mobile.iter().filter(|mobile| **mobile).count() as f64 / mobile.len() as f64;
        Yardstick { reference, sensitivity, moving }
    }

    /// How much the velocities and energies of all particles may add up to at most, weighted by mass: a sum differs by no more than its terms, and
    /// the mean size of these by no more than its root mean square.
    fn most(&self, dimension: usize) -> [f64; 2] {
        let scale = scales(self.reference);
        let all = |name: &str| {
            let k = COMPARED.iter().position(|n| *n == name).unwrap_or(0);
            // Tolerances are means over all particles, of which the fixed ones do not differ.
            self.reference.end.mass * self.sensitivity.tolerance(k).value * scale[k] / self.moving.sqrt()
        };
        [all("velocity_x") * (dimension as f64).sqrt(), all("internal_energy")]
    }

    /// The drift that the reference has in the same units, and `more`.
    fn tolerance(&self, of_reference: f64, more: f64) -> Tolerance {
        Tolerance::new(
            of_reference.abs() + more,
            format!(
                "{}, the reference's own, which is that of the scheme, and {} for what velocities and energies of all particles may differ by",
                plain(of_reference.abs()),
                plain(more)
            ),
        )
    }
}

/// Drift of mass, momentum and energy of the particles that move. It is judged where there is a reference to hold it against: its own drift is
/// no matter of arithmetic, but of scheme, step and walls.
pub fn conservation(run: &Finished, dimension: usize, yardstick: Option<Yardstick>) -> Vec<Conserved> {
    let area = sod::WIDTH.powi(dimension as i32 - 1);
    let push = (sod::PRESSURE[0] - sod::PRESSURE[1]) * area * run.time;
    let gained = |run: &Finished| run.end.momentum[0] - run.start.momentum[0];
    let along = |run: &Finished| (gained(run) - push) / push;
    let magnitude = |run: &Finished| run.end.momentum_magnitude.max(f64::MIN_POSITIVE);
    let across = |run: &Finished| {
        let drift = |axis: usize| ((run.end.momentum[axis] - run.start.momentum[axis]) / magnitude(run)).abs();
        (1..dimension).map(drift).fold(0.0, f64::max)
    };
    let energy = |run: &Finished| (run.end.energy - run.start.energy) / run.start.energy;
    let tolerance = |drift: &dyn Fn(&Finished) -> f64, more: &dyn Fn([f64; 2], &Finished) -> f64| {
        yardstick.map(|y| y.tolerance(drift(y.reference), more(y.most(dimension), y.reference)))
    };
    let mut all = vec![
        Conserved {
            quantity: "mass".into(),
            scaled_drift: (run.end.mass - run.start.mass) / run.start.mass,
            tolerance: Some(Tolerance::new(
                f64::EPSILON,
                "nothing writes masses: both sums are of the same numbers in the same order",
            )),
            note: None,
        },
        Conserved {
            quantity: "momentum along the tube".into(),
            scaled_drift: along(run),
            tolerance: tolerance(&along, &|[momentum, _], _| momentum / push),
            note: Some(format!(
                "not conserved: the fixed layers push with the pressure of the gas at rest, P_L − P_R = {} on an area of {}; by t = {} that \
                 gives the moving particles a momentum of {}, and they have {}; the number is the difference in units of the push",
                plain(sod::PRESSURE[0] - sod::PRESSURE[1]),
                plain(area),
                plain(run.time),
                plain(push),
                plain(gained(run))
            )),
        },
    ];
    if dimension > 1 {
        all.push(Conserved {
            quantity: "momentum across the tube".into(),
            scaled_drift: across(run),
            tolerance: tolerance(&across, &|[momentum, _], run| momentum / magnitude(run)),
            note: Some(
                "among moving particles it is conserved to rounding; the fixed layers at both ends take what they are given".into(),
            ),
        });
    }
    // A change of the velocities changes the kinetic energy by their own size at most.
    let fastest = |run: &Finished| scales(run)[1];
    all.push(Conserved {
        quantity: "energy".into(),
        scaled_drift: energy(run),
        tolerance: tolerance(&energy, &|[momentum, heat], run| (momentum * fastest(run) + heat) / run.start.energy),
        note: Some(
            "the equations conserve it at every instant; the integrator is of second order in the step, and the fixed layers \
             keep the share of the pairs they take part in"
                .into(),
        ),
    });
    all
}

/// The particles that plots show.
pub fn profile(state: &State, mobile: &[bool], exact: &Exact, reference: Option<&State>) -> Profile {
    let moving: Vec<usize> = (0..mobile.len()).filter(|&i| mobile[i]).collect();
    let all: Vec<f64> = moving.iter().map(|&i| state.position[0][i]).collect();
    let shown: Vec<usize> = stratified(&all, SHOWN).into_iter().map(|k| moving[k]).collect();
    let pick = |column: &[f64]| shown.iter().map(|&i| column[i]).collect::<Vec<f64>>();
    let x = pick(&state.position[0]);
    let truth = exact.columns(&x);
    let field = |(k, truth): (usize, Vec<f64>)| ProfileField {
        field: COMPARED[k].into(),
        value: pick(state.compared()[k]),
        exact: truth,
        reference: reference.map_or_else(Vec::new, |reference| pick(reference.compared()[k])),
    };
    let fields = truth.into_iter().enumerate().map(field).collect();
    let selection = format!("{} of the {} that move, evenly along the tube", shown.len(), moving.len());
    Profile { selection, x, fields }
}
