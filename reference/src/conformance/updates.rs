//! Whether an engine's updates compute what the equations say: each by itself, within the running bound of the reference.

use super::sets::{self, Difficulty};
use super::{Summary, to_precision, verdict};
use crate::engine::{Engine, EngineError, PlainEngine};
use crate::fields;
use crate::particles::ParticleSet;
use crate::passes::{Driver, Physics};
use crate::pipeline::{Pipeline, UpdateVisitor};
use crate::scenes::sod::Sod;
use crate::schemes::{Dissipation, Viscosity};
use crate::simulation::Simulation;
use etalon_kernels_gen::bounded::{Bounded, Roundoff};
use etalon_kernels_gen::{Component, Field, Footprint, Update, components};

/// A power of two: as exact in one precision as in the other.
const TIME_STEP: f64 = 1.0 / 1024.0;

/// Particles that all move, and some that do not among others that do.
const TRIED: [Difficulty; 2] = [Difficulty::None, Difficulty::FixedLayers];

/// All updates in `D` dimensions, on particles that move and on some that do not. `make` builds an engine of precision `P`.
///
/// Engine and reference get the same inputs, those of a run after its first step: its rates differ from their predecessors. No number may
/// be without a bound, as an update asks no question that is too close to call.
///
/// # Errors
/// [`EngineError`] if the particles, the run that makes the inputs or the engine fail. What does not compare is a failure of the
/// [`Summary`].
pub fn check_updates<const D: usize, P: Roundoff, E: Engine<D>>(
    mut make: impl FnMut(&ParticleSet<D>, &[Field]) -> Result<E, EngineError>,
) -> Result<Summary, EngineError> {
    // All that has an update of its own: a scheme with a switch, walls that are driven, a force from outside.
    let physics = Physics {
        driver: Some(Driver { period: 0.25, moves: true }),
        forced: true,
        viscosity: Viscosity::of(Dissipation::AvSw),
        ..Sod::standard(D).physics()
    };
    let pipeline = Pipeline::of_scene::<D>(&physics);
    let mut summary = Summary::default();
    for (difficulty, seed) in TRIED.into_iter().zip(7..) {
        let place = format!("{D}-D, {difficulty:?}");
        let across = [100, 20, 9][D - 1];
        let set = sets::set::<D>(difficulty, across, &physics, seed).map_err(EngineError::from_display)?;
        let mut engine = make(&set, &pipeline.fields::<D>())?;
        // Passes and updates are given mobilities to compare with; a run has those that the engine took from the particles.
        let mobile = set.particles().iter().map(|p| if p.mobile { 1.0 } else { 0.0 });
        if !mobile.eq(engine.read_scalar(fields::MOBILITY)?) {
            summary.failures.push(format!("{place}: the engine holds other walls than the particles"));
        }
        let mut run = Simulation::new(PlainEngine::<f64, D>::new(&set), physics)?;
        for index in 0..D {
            let force: Vec<f64> = (0..set.len()).map(|i| 1.0 - (i % 5) as f64 * 0.3).collect();
            run.engine().write(Component { field: fields::FORCING, index }, &force)?;
        }
        run.step(1.0)?;
        let bounded = PlainEngine::<Bounded<P>, D>::new(&set);
        let mut check = Check { inputs: run.engine(), bounded, engine: &mut engine, place, difficulty, summary };
        for update in pipeline.updates() {
            update.visit(physics, &mut check)?;
        }
        summary = check.summary;
    }
    Ok(summary)
}

struct Check<'e, P, E, const D: usize> {
    inputs: &'e mut PlainEngine<f64, D>,
    bounded: PlainEngine<Bounded<P>, D>,
    engine: &'e mut E,
    place: String,
    difficulty: Difficulty,
    summary: Summary,
}

impl<const D: usize, P: Roundoff, E: Engine<D>> UpdateVisitor<D> for Check<'_, P, E, D> {
    type Output = Result<(), EngineError>;

    fn visit_update<U: Update<D>>(&mut self, update: &U) -> Self::Output {
        let footprint = Footprint::of_update::<D, U>();
        for component in components(&footprint.own, D) {
            let rounded: Vec<f64> = self.inputs.read(component)?.into_iter().map(to_precision::<P>).collect();
            self.bounded.write(component, &rounded)?;
            self.engine.write(component, &rounded)?;
        }
        self.bounded.run_update(update, TIME_STEP)?;
        self.engine.run_update(update, TIME_STEP)?;
        let mut verdicts = Vec::new();
        for component in components(&footprint.out, D) {
            let found = self.engine.read(component)?;
            let expected = self.bounded.column(component).unwrap_or(&[]);
            let verdict = verdict::<P>(U::NAME, component.name(D), &found, expected);
            if verdict.unbounded > 0 {
                self.summary.failures.push(format!("{}: no bound: {verdict}", self.place));
            }
            verdicts.push(verdict);
        }
        self.summary.add::<P>(&self.place, D, self.difficulty, verdicts);
        Ok(())
    }
}
