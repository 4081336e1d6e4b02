//! Whether an engine's updates compute what the equations say: each by itself, within the running bound of the reference.

use super::sets::{self, Difficulty};
use super::{Summary, to_precision, verdict};
use crate::engine::{Engine, EngineError, PlainEngine};
use crate::fields;
use crate::particles::ParticleSet;
use crate::passes::{Correct, Decay, KickDrift};
use crate::pipeline::Pipeline;
use crate::scenes::sod::Sod;
use crate::schemes::Dissipation;
use crate::simulation::Simulation;
use etalon_kernels_gen::bounded::{Bounded, Roundoff};
use etalon_kernels_gen::{Field, Footprint, Update, components};

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
    // A scheme with a switch, which has an update of its own.
    let physics = Sod { dissipation: Dissipation::AvSw, ..Sod::standard(D) }.physics();
    let mut check = Check { summary: Summary::default(), place: String::new(), difficulty: Difficulty::None };
    for (difficulty, seed) in TRIED.into_iter().zip(7..) {
        let across = [100, 20, 9][D - 1];
        let set = sets::set::<D>(difficulty, across, &physics, seed).map_err(EngineError::from_display)?;
        let mut engine = make(&set, &Pipeline::of_scene::<D>(&physics).fields::<D>())?;
        check.place = format!("{D}-D, {difficulty:?}");
        check.difficulty = difficulty;
        // Passes and updates are given mobilities to compare with; a run has those that the engine took from the particles.
        let mobile = set.particles().iter().map(|p| if p.mobile { 1.0 } else { 0.0 });
        if !mobile.eq(engine.read_scalar(fields::MOBILITY)?) {
            check.summary.failures.push(format!("{}: the engine holds other walls than the particles", check.place));
        }
        let mut run = Simulation::new(PlainEngine::<f64, D>::new(&set), physics)?;
        run.step(1.0)?;
        let mut bounded = PlainEngine::<Bounded<P>, D>::new(&set);
        check.update(&KickDrift(physics), run.engine(), &mut bounded, &mut engine)?;
        check.update(&Correct, run.engine(), &mut bounded, &mut engine)?;
        check.update(&Decay(physics), run.engine(), &mut bounded, &mut engine)?;
    }
    Ok(check.summary)
}

struct Check {
    summary: Summary,
    place: String,
    difficulty: Difficulty,
}

impl Check {
    fn update<const D: usize, P: Roundoff, U: Update<D>>(
        &mut self,
        update: &U,
        inputs: &mut PlainEngine<f64, D>,
        bounded: &mut PlainEngine<Bounded<P>, D>,
        engine: &mut impl Engine<D>,
    ) -> Result<(), EngineError> {
        let footprint = Footprint::of_update::<D, U>();
        for component in components(&footprint.own, D) {
            let rounded: Vec<f64> = inputs.read(component)?.into_iter().map(to_precision::<P>).collect();
            bounded.write(component, &rounded)?;
            engine.write(component, &rounded)?;
        }
        bounded.run_update(update, TIME_STEP)?;
        engine.run_update(update, TIME_STEP)?;
        let mut verdicts = Vec::new();
        for component in components(&footprint.out, D) {
            let found = engine.read(component)?;
            let expected = bounded.column(component).unwrap_or(&[]);
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
