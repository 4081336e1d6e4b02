//! The stages of a step with their work, counted from the drawing of what the backends run.

use crate::command::failure::Failure;
use etalon_kernels_gen::trace::{Count, Double, Drawing, Single, TraceError};
use etalon_kernels_gen::{Footprint, Pass, Update};
use etalon_reference::passes::Physics;
use etalon_reference::pipeline::{PassVisitor, Pipeline, UpdateVisitor};

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
        let opening =
            pipeline.opening().iter().chain(pipeline.driving()).map(|update| update.visit::<D, _>(physics, &mut Draw));
        let passes = pipeline.passes().iter().map(|pass| pass.visit::<D, _>(physics, &mut Draw));
        let closing =
            pipeline.pushing().iter().chain(pipeline.closing()).map(|update| update.visit::<D, _>(physics, &mut Draw));
        opening.chain(passes).chain(closing).collect()
    };
    all().map_err(|error| Failure::Broken(format!("a pass cannot be drawn: {error}")))
}

/// Counts a pass or an update.
struct Draw;

impl<const D: usize> PassVisitor<D> for Draw {
    type Output = Result<Stage, TraceError>;
    fn visit<P: Pass<D>>(&mut self, pass: &P) -> Self::Output {
        let single = Drawing::of_pass::<D, P, Single>(pass)?.simplified();
        let double = Drawing::of_pass::<D, P, Double>(pass)?.simplified();
        Ok(Stage {
            footprint: Footprint::of_pass::<D, P>(pass),
            pair: Some([single.count_pair(), double.count_pair()]),
            particle: [single.count_finish(), double.count_finish()],
        })
    }
}

impl<const D: usize> UpdateVisitor<D> for Draw {
    type Output = Result<Stage, TraceError>;
    fn visit_update<U: Update<D>>(&mut self, update: &U) -> Self::Output {
        let single = Drawing::of_update::<D, U, Single>(update)?.simplified();
        let double = Drawing::of_update::<D, U, Double>(update)?.simplified();
        Ok(Stage { footprint: Footprint::of_update::<D, U>(), pair: None, particle: [single.count(), double.count()] })
    }
}
