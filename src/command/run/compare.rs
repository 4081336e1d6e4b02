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

/// The momentum that the fixed layers give may differ so much from their pressure times area and time.
const PUSH: f64 = 0.02;
/// Momentum across the tube, scaled by the sum of all magnitudes.
const ACROSS: f64 = 1e-3;
/// Energy that appears or goes, as a fraction.
const ENERGY: f64 = 5e-4;

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

/// Drift of mass, momentum and energy of the particles that move.
pub fn conservation(run: &Finished, dimension: usize) -> Vec<Conserved> {
    let (start, end) = (&run.start, &run.end);
    let drift =
        |axis: usize| (end.momentum[axis] - start.momentum[axis]) / end.momentum_magnitude.max(f64::MIN_POSITIVE);
    let area = sod::WIDTH.powi(dimension as i32 - 1);
    let push = (sod::PRESSURE[0] - sod::PRESSURE[1]) * area * run.time;
    let gained = end.momentum[0] - start.momentum[0];
    let mut all = vec![
        Conserved {
            quantity: "mass".into(),
            scaled_drift: (end.mass - start.mass) / start.mass,
            tolerance: Some(Tolerance::new(
                f64::EPSILON,
                "nothing writes masses: both sums are of the same numbers in the same order",
            )),
            note: None,
        },
        Conserved {
            quantity: "momentum along the tube".into(),
            scaled_drift: (gained - push) / push,
            tolerance: Some(Tolerance::new(
                PUSH,
                "the fixed layers are particles, and push with the pressure that sums over them give: within 0.5 % of the gas at rest \
                 in every start that was tried",
            )),
            note: Some(format!(
                "not conserved: the fixed layers push with the pressure of the gas at rest, P_L − P_R = {} on an area of {}; by t = {} that \
                 gives the moving particles a momentum of {}, and they have {}; the number is the difference in units of the push",
                plain(sod::PRESSURE[0] - sod::PRESSURE[1]),
                plain(area),
                plain(run.time),
                plain(push),
                plain(gained)
            )),
        },
    ];
    if dimension > 1 {
        all.push(Conserved {
            quantity: "momentum across the tube".into(),
            scaled_drift: (1..dimension).map(|axis| drift(axis).abs()).fold(0.0, f64::max),
            tolerance: Some(Tolerance::new(
                ACROSS,
                "what the fixed layers take: rounding where the start is regular across the tube, 7e-5 of all momenta where it is a glass",
            )),
            note: Some(
                "among moving particles it is conserved to rounding; the fixed layers at both ends take what they are given".into(),
            ),
        });
    }
    all.push(Conserved {
        quantity: "energy".into(),
        scaled_drift: (end.energy - start.energy) / start.energy,
        tolerance: Some(Tolerance::new(
            ENERGY,
            "eight times what 100 particles in 1-D show; it falls with the step, so with more particles",
        )),
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
