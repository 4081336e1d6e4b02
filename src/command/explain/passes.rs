//! The stages of a step with their work, counted from the drawing of what the backends run.

use crate::command::failure::Failure;
use etalon_kernels_gen::trace::{Count, Double, Drawing, Single, TraceError};
use etalon_kernels_gen::{Footprint, Pass, Update};
use etalon_reference::passes::{Correct, Decay, KickDrift, Physics};
use etalon_reference::pipeline::{PassVisitor, Pipeline};

/// A pass or an update of a step.
pub struct Stage {
    /// What it reads and writes.
    pub footprint: Footprint,
    /// Work of one pair in single and double precision; none for an update.
    pub pair: Option<[Count; 2]>,
    /// Work of one particle beside its pairs.
    pub particle: [Count; 2],
}

/// The stages of a step, in the order they run.
pub fn stages<const D: usize>(pipeline: &Pipeline, physics: Physics) -> Result<Vec<Stage>, Failure> {
    let all = || -> Result<Vec<Stage>, TraceError> {
        let mut all = vec![update::<D, _>(&KickDrift(physics))?];
        if pipeline.switches() {
            all.push(update::<D, _>(&Decay(physics))?);
        }
        for pass in pipeline.passes() {
            all.push(pass.visit::<D, _>(physics, &mut Draw)?);
        }
        all.push(update::<D, _>(&Correct)?);
        Ok(all)
    };
    all().map_err(|error| Failure::Broken(format!("a pass cannot be drawn: {error}")))
}

/// Counts a pass.
struct Draw;

impl<const D: usize> PassVisitor<D> for Draw {
    type Output = Result<Stage, TraceError>;
    fn visit<P: Pass<D>>(&mut self, pass: &P) -> Self::Output {
        let single = Drawing::of_pass::<D, P, Single>(pass)?.simplified();
        let double = Drawing::of_pass::<D, P, Double>(pass)?.simplified();
        Ok(Stage {
            footprint: Footprint::of_pass::<D, P>(),
            pair: Some([single.count_pair(), double.count_pair()]),
            particle: [single.count_finish(), double.count_finish()],
        })
    }
}

fn update<const D: usize, U: Update<D>>(update: &U) -> Result<Stage, TraceError> {
    let single = Drawing::of_update::<D, U, Single>(update)?.simplified();
    let double = Drawing::of_update::<D, U, Double>(update)?.simplified();
    Ok(Stage { footprint: Footprint::of_update::<D, U>(), pair: None, particle: [single.count(), double.count()] })
}
