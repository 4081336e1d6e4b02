//! Every combination of precision, dimension and pass, compiled here.
//!
//! The vector code of the passes is most of what there is to compile. Naming each combination once lets all programs and tests that
//! use this crate share it, instead of compiling it again in each; optimised builds do so for functions that are never inlined.

use crate::engine::LaneEngine;
use etalon_reference::engine::{Engine, EngineError};
use etalon_reference::passes::{
    Conduction, Correct, Decay, Density, DragForces, DriveWall, GasOnly, Gradients, KickDrift, LinearGradients,
    Momentum, MoveWall, Push, ReconstructedDragForces, ReconstructedMomentum, SameSpecies, Switch, SwitchedMomentum,
    VelocityGradients, VolumeElements,
};

type Run<const D: usize, T, P> = fn(&mut LaneEngine<T, D>, &P) -> Result<(), EngineError>;
type Advance<const D: usize, T, U> = fn(&mut LaneEngine<T, D>, &U, f64) -> Result<(), EngineError>;

macro_rules! instances {
    ($($name:ident: $number:ty, $dimension:literal;)*) => {$(
        /// All passes and updates of gas, those of gas with dust, and those of both, in this precision and dimension.
        #[allow(dead_code)]
        pub static $name: (
            (
                Run<$dimension, $number, VolumeElements>,
                Run<$dimension, $number, Density>,
                Run<$dimension, $number, Gradients>,
                Run<$dimension, $number, VelocityGradients>,
                Run<$dimension, $number, Momentum>,
                Run<$dimension, $number, ReconstructedMomentum>,
                Run<$dimension, $number, Switch>,
                Run<$dimension, $number, SwitchedMomentum>,
                Run<$dimension, $number, Conduction>,
            ),
            (
                Run<$dimension, $number, SameSpecies<VolumeElements>>,
                Run<$dimension, $number, SameSpecies<Density>>,
                Run<$dimension, $number, SameSpecies<Gradients>>,
                Run<$dimension, $number, SameSpecies<VelocityGradients>>,
                Run<$dimension, $number, SameSpecies<LinearGradients>>,
                Run<$dimension, $number, GasOnly<Momentum>>,
                Run<$dimension, $number, GasOnly<ReconstructedMomentum>>,
                Run<$dimension, $number, GasOnly<Switch>>,
                Run<$dimension, $number, GasOnly<SwitchedMomentum>>,
                Run<$dimension, $number, GasOnly<Conduction>>,
                Run<$dimension, $number, DragForces>,
                Run<$dimension, $number, ReconstructedDragForces>,
            ),
            (
                Advance<$dimension, $number, KickDrift>,
                Advance<$dimension, $number, Correct>,
                Advance<$dimension, $number, Decay>,
                Advance<$dimension, $number, DriveWall>,
                Advance<$dimension, $number, MoveWall>,
                Advance<$dimension, $number, Push>,
            ),
        ) = (
            (
                Engine::run_pass,
                Engine::run_pass,
                Engine::run_pass,
                Engine::run_pass,
                Engine::run_pass,
                Engine::run_pass,
                Engine::run_pass,
                Engine::run_pass,
                Engine::run_pass,
            ),
            (
                Engine::run_pass,
                Engine::run_pass,
                Engine::run_pass,
                Engine::run_pass,
                Engine::run_pass,
                Engine::run_pass,
                Engine::run_pass,
                Engine::run_pass,
                Engine::run_pass,
                Engine::run_pass,
                Engine::run_pass,
                Engine::run_pass,
            ),
            (
                Engine::run_update,
                Engine::run_update,
                Engine::run_update,
                Engine::run_update,
                Engine::run_update,
                Engine::run_update,
            ),
        );
    )*};
}

instances! {
    SINGLE_1: f32, 1;
    SINGLE_2: f32, 2;
    SINGLE_3: f32, 3;
    DOUBLE_1: f64, 1;
    DOUBLE_2: f64, 2;
    DOUBLE_3: f64, 3;
}
