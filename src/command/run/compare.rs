//! A run against the exact solution, against the reference, and against itself at the start.

use super::seen::{ENERGY, FIELDS, Seen, VELOCITY, columns, names};
use super::sensitivity::{Sensitivity, rms, scales};
use super::simulate::Finished;
use crate::command::failure::Failure;
use crate::report::model::{
    Conserved, FieldDifference, FieldError, Norm, Profile, ProfileField, Tolerance, stratified,
};
use crate::report::plain;
use etalon_reference::norms::{NormError, l1_error, l2_error, max_error};
use etalon_reference::scenes::{GivenMomentum, Measured, Solution, View};

/// Particles shown in plots.
const SHOWN: usize = 1200;

/// First source of error: distance from the solution over the gas in the measured range that moves.
pub fn discretisation(
    seen: &Seen,
    view: View,
    solution: &dyn Solution,
    measured: Measured,
) -> Result<Vec<FieldError>, Failure> {
    let moving: Vec<usize> = seen.state.moving_gas().collect();
    let pick = |column: &[f64]| moving.iter().map(|&i| column[i]).collect::<Vec<f64>>();
    let x = pick(&seen.coordinate);
    let truth = columns(solution, &x);
    let (from, to) = measured.range;
    let particles = x.iter().filter(|x| (from..=to).contains(*x)).count() as u64;
    let names = names(view);
    let error = |k: usize| -> Result<FieldError, NormError> {
        let found = pick(seen.compared()[k]);
        Ok(FieldError {
            field: names[k].into(),
            l1: l1_error(&found, &truth[k], &x, measured.range)?,
            l2: l2_error(&found, &truth[k], &x, measured.range)?,
            max: max_error(&found, &truth[k], &x, measured.range)?,
            particles,
        })
    };
    (0..FIELDS).map(|k| error(k).map_err(|e| Failure::Broken(format!("{}: {e}", names[k])))).collect()
}

/// Second source of error: distance from the reference, particle by particle.
pub fn arithmetic(
    run: &Finished,
    reference: &Finished,
    view: View,
    sensitivity: &Sensitivity,
) -> Result<Vec<FieldDifference>, Failure> {
    let scale = scales(reference);
    let names = names(view);
    let mut all = Vec::new();
    for (k, (found, wanted)) in run.seen.compared().into_iter().zip(reference.seen.compared()).enumerate() {
        let max = found.iter().zip(wanted).fold(0.0, |largest: f64, (a, b)| largest.max((a - b).abs()));
        let tolerance = sensitivity.tolerance(k, names[k]);
        all.push(FieldDifference::new(names[k], rms(found, wanted)?, max, scale[k], Norm::Rms, tolerance));
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
        let all = |k: usize| {
            // Tolerances are means over all particles, of which the fixed ones do not differ.
            self.reference.end.mass * self.sensitivity.tolerance(k, "").value * scale[k] / self.moving.sqrt()
        };
        [all(VELOCITY) * (dimension as f64).sqrt(), all(ENERGY)]
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
pub fn conservation(
    run: &Finished,
    dimension: usize,
    given: &GivenMomentum,
    walls: bool,
    yardstick: Option<Yardstick>,
) -> Vec<Conserved> {
    let magnitude = |run: &Finished| run.end.momentum_magnitude.max(f64::MIN_POSITIVE);
    let gained = |run: &Finished, axis: usize| run.end.momentum[axis] - run.start.momentum[axis];
    let energy = |run: &Finished| (run.end.energy - run.start.energy) / run.start.energy.max(f64::MIN_POSITIVE);
    let tolerance = |drift: &dyn Fn(&Finished) -> f64, more: &dyn Fn([f64; 2], &Finished) -> f64| {
        yardstick.map(|y| y.tolerance(drift(y.reference), more(y.most(dimension), y.reference)))
    };
    let mut all = vec![Conserved {
        quantity: "mass".into(),
        scaled_drift: (run.end.mass - run.start.mass) / run.start.mass,
        tolerance: Some(Tolerance::new(
            f64::EPSILON,
            "nothing writes masses: both sums are of the same numbers in the same order",
        )),
        note: None,
    }];
    let pushed = match given {
        GivenMomentum::Along { axis, .. } => Some(*axis),
        _ => None,
    };
    if let GivenMomentum::Along { axis, momentum, by } = given {
        let along = |run: &Finished| (gained(run, *axis) - momentum) / momentum.abs();
        all.push(Conserved {
            quantity: format!("momentum along {}", AXES[*axis]),
            scaled_drift: along(run),
            tolerance: tolerance(&along, &|[more, _], _| more / momentum.abs()),
            note: Some(format!(
                "not conserved: {by}; by t = {} that gives the moving particles a momentum of {}, and they have {}; the number is the \
                 difference in units of what is given",
                plain(run.time),
                plain(*momentum),
                plain(gained(run, *axis))
            )),
        });
    }
    let others: Vec<usize> = (0..dimension).filter(|axis| pushed != Some(*axis)).collect();
    if !others.is_empty() {
        let across =
            |run: &Finished| others.iter().map(|&a| (gained(run, a) / magnitude(run)).abs()).fold(0.0, f64::max);
        let names: Vec<&str> = others.iter().map(|&axis| AXES[axis]).collect();
        let note = match given {
            GivenMomentum::Unknown(why) => Some(format!("not conserved: {why}")),
            _ if walls => Some(
                "among moving particles it is conserved to rounding; the fixed ones take what they are given".into(),
            ),
            _ => None,
        };
        all.push(Conserved {
            quantity: format!("momentum along {}", names.join(" and ")),
            scaled_drift: across(run),
            tolerance: tolerance(&across, &|[more, _], run| more / magnitude(run)),
            note,
        });
    }
    // A change of the velocities changes the kinetic energy by their own size at most.
    let fastest = |run: &Finished| scales(run)[VELOCITY];
    let beside = if walls { ", and fixed particles keep the share of the pairs they take part in" } else { "" };
    all.push(Conserved {
        quantity: "energy".into(),
        scaled_drift: energy(run),
        tolerance: tolerance(&energy, &|[more, heat], run| {
            (more * fastest(run) + heat) / run.start.energy.max(f64::MIN_POSITIVE)
        }),
        note: Some(format!(
            "kinetic and internal; the equations conserve it at every instant where nothing acts from outside; the integrator is of second order \
             in the step{beside}"
        )),
    });
    all
}

const AXES: [&str; 3] = ["x", "y", "z"];

/// The particles that plots show.
pub fn profile(seen: &Seen, view: View, solution: Option<&dyn Solution>, reference: Option<&Seen>) -> Profile {
    let moving: Vec<usize> = seen.state.moving_gas().collect();
    let all: Vec<f64> = moving.iter().map(|&i| seen.coordinate[i]).collect();
    let shown: Vec<usize> = stratified(&all, SHOWN).into_iter().map(|k| moving[k]).collect();
    let pick = |column: &[f64]| shown.iter().map(|&i| column[i]).collect::<Vec<f64>>();
    let x = pick(&seen.coordinate);
    let truth = solution.map(|solution| columns(solution, &x));
    let names = names(view);
    let field = |k: usize| ProfileField {
        field: names[k].into(),
        value: pick(seen.compared()[k]),
        exact: truth.as_ref().map_or_else(Vec::new, |truth| truth[k].clone()),
        reference: reference.map_or_else(Vec::new, |reference| pick(reference.compared()[k])),
    };
    let fields = (0..FIELDS).map(field).collect();
    let selection = format!(
        "{} of the {} particles of gas that move, evenly along {}",
        shown.len(),
        moving.len(),
        view.coordinate()
    );
    Profile { selection, x, fields }
}
