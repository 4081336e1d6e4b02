//! Whether a run that is interrupted between two steps goes on as if it had not been.

use crate::engine::{Engine, EngineError};
use crate::particles::ParticleSet;
use crate::passes::Physics;
use crate::pipeline::Pipeline;
use crate::simulation::{Checkpoint, Simulation};
use etalon_kernels_gen::{Field, components};

/// Runs `before` and `after` steps in one go; then again, but after `before` of them takes a checkpoint, hands it `through` something (a
/// file, say), and goes on from what comes back on a new engine. The names of all that differs in a bit at the end; none should.
///
/// # Errors
/// Whatever the engine gives, or a checkpoint that is refused.
pub fn differing<const D: usize, E: Engine<D>>(
    make: impl Fn(&ParticleSet<D>, &[Field]) -> E,
    set: &ParticleSet<D>,
    physics: Physics,
    [before, after]: [usize; 2],
    through: impl FnOnce(Checkpoint) -> Result<Checkpoint, EngineError>,
) -> Result<Vec<String>, EngineError> {
    let fields = Pipeline::of_scene::<D>(&physics).fields::<D>();
    let steps = |run: &mut Simulation<D, E>, count: usize| (0..count).try_for_each(|_| run.step(f64::MAX).map(drop));

    let mut whole = Simulation::new(make(set, &fields), physics)?;
    steps(&mut whole, before + after)?;
    let mut first = Simulation::new(make(set, &fields), physics)?;
    steps(&mut first, before)?;
    let saved = through(first.checkpoint(&[])?)?;
    drop(first);
    let mut second = Simulation::new(make(set, &fields), physics)?;
    second.restore(&saved)?;
    steps(&mut second, after)?;

    let mut differing = Vec::new();
    let mut note = |same: bool, name: String| differing.extend((!same).then_some(name));
    note(whole.steps() == second.steps(), "number of steps".into());
    note(whole.time().to_bits() == second.time().to_bits(), "time".into());
    for axis in 0..D {
        note(whole.engine().coordinates(axis)? == second.engine().coordinates(axis)?, format!("coordinate {axis}"));
    }
    for component in components(&fields, D) {
        let (a, b) = (whole.engine().read(component)?, second.engine().read(component)?);
        note(a.iter().map(|x| x.to_bits()).eq(b.iter().map(|x| x.to_bits())), component.name(D));
    }
    Ok(differing)
}
