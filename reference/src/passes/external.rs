//! What acts on particles from outside: walls that are driven, and a force that the host makes.

use crate::equations::time_step::acceleration_step;
use crate::fields::*;
use etalon_kernels_gen::functions::smaller;
use etalon_kernels_gen::{Real, Scalar, Update, Vector, record};
use std::f64::consts::TAU;

/// An oscillation that drives a scene's walls: at time `t` the velocity of a particle that is not mobile is `sin(2 pi t / T)` times the one
/// that it was started with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Driver {
    /// The period `T`, a time.
    pub period: f64,
    /// Whether the walls go where their velocity takes them; they keep their places otherwise, and only their velocity is felt.
    pub moves: bool,
}

/// Steps in a period at least. Between so many points a sine is straight to a part in 200.
const STEPS_IN_A_PERIOD: f64 = 32.0;

impl Driver {
    /// What share of their largest velocity the walls have at a time.
    pub fn share(&self, time: f64) -> f64 {
        (TAU * (time / self.period).fract()).sin()
    }
    /// For how long the walls would have to go at their largest velocity to get where they get in a step: the integral of the
    /// [`share`](Self::share), a time.
    pub fn way(&self, from: f64, step: f64) -> f64 {
        // A difference of cosines, written so that it keeps its digits in a short step.
        let half = 0.5 * TAU * step / self.period;
        let middle = TAU * (from / self.period).fract() + half;
        self.period / TAU * 2.0 * middle.sin() * half.sin()
    }
    /// The longest step that still sees the oscillation.
    pub fn longest_step(&self) -> f64 {
        self.period / STEPS_IN_A_PERIOD
    }
}

/// Gives walls their velocity; the scalar it takes is no time but the [`Driver::share`] at the end of the step.
#[derive(Clone, Copy, Debug)]
pub struct DriveWall;

/// Gives walls their displacement; the scalar it takes is the [`Driver::way`] of the step.
#[derive(Clone, Copy, Debug)]
pub struct MoveWall;

/// Adds the host's force to the acceleration that the passes have made, and lets it limit the step. Its scalar is not looked at.
#[derive(Clone, Copy, Debug)]
pub struct Push;

record! {
    /// Read.
    pub struct DriveWallOwn {
        mobility: Scalar = MOBILITY,
        velocity: Vector = VELOCITY,
        largest: Vector = DRIVE_VELOCITY,
    }
}
record! {
    /// Written.
    pub struct DriveWallOut { velocity: Vector = VELOCITY }
}
record! {
    /// Read.
    pub struct MoveWallOwn {
        mobility: Scalar = MOBILITY,
        displacement: Vector = DISPLACEMENT,
        largest: Vector = DRIVE_VELOCITY,
    }
}
record! {
    /// Written.
    pub struct MoveWallOut { displacement: Vector = DISPLACEMENT }
}
record! {
    /// Read.
    pub struct PushOwn {
        inverse_h: Scalar = INVERSE_SMOOTHING_LENGTH,
        mobility: Scalar = MOBILITY,
        acceleration: Vector = ACCELERATION,
        forcing: Vector = FORCING,
        time_step: Scalar = TIME_STEP,
    }
}
record! {
    /// Written.
    pub struct PushOut {
        acceleration: Vector = ACCELERATION,
        time_step: Scalar = TIME_STEP,
    }
}

impl<const D: usize> Update<D> for DriveWall {
    type Own<R: Real> = DriveWallOwn<R, D>;
    type Out<R: Real> = DriveWallOut<R, D>;
    const NAME: &'static str = "drive_wall";

    #[inline(always)]
    fn apply<R: Real>(&self, own: &Self::Own<R>, share: R) -> Self::Out<R> {
        let moves = own.mobility.gt(R::zero());
        let driven = own.largest.scale(share);
        DriveWallOut { velocity: Vector::from_fn(|axis| R::pick(moves, own.velocity[axis], driven[axis])) }
    }
}

impl<const D: usize> Update<D> for MoveWall {
    type Own<R: Real> = MoveWallOwn<R, D>;
    type Out<R: Real> = MoveWallOut<R, D>;
    const NAME: &'static str = "move_wall";

    #[inline(always)]
    fn apply<R: Real>(&self, own: &Self::Own<R>, way: R) -> Self::Out<R> {
        let moves = own.mobility.gt(R::zero());
        let driven = own.largest.scale(way);
        MoveWallOut { displacement: Vector::from_fn(|axis| R::pick(moves, own.displacement[axis], driven[axis])) }
    }
}

impl<const D: usize> Update<D> for Push {
    type Own<R: Real> = PushOwn<R, D>;
    type Out<R: Real> = PushOut<R, D>;
    const NAME: &'static str = "push";

    #[inline(always)]
    fn apply<R: Real>(&self, own: &Self::Own<R>, _: R) -> Self::Out<R> {
        let acceleration = own.acceleration + own.forcing.scale(own.mobility);
        let h = R::one() / own.inverse_h;
        PushOut { acceleration, time_step: smaller(own.time_step, acceleration_step(h, acceleration.norm())) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const DRIVER: Driver = Driver { period: 0.05, moves: true };

    #[test]
    fn share_is_the_sine_and_way_its_integral() {
        // Each is a product of a few numbers of order one; the phase is off by two roundings of the time in periods, at most 7 here.
        let tolerance = 20.0 * 7.0 * f64::EPSILON;
        for (time, share) in [(0.0, 0.0), (0.0125, 1.0), (0.025, 0.0), (0.0375, -1.0), (0.05 * 6.125, 0.5_f64.sqrt())] {
            assert!((DRIVER.share(time) - share).abs() < tolerance, "t = {time}: {}", DRIVER.share(time));
            let way = 0.05 / TAU * (1.0 - (TAU * time / 0.05).cos());
            assert!((DRIVER.way(0.0, time) - way).abs() < tolerance * 0.05, "t = {time}: {}", DRIVER.way(0.0, time));
        }
        // Short steps keep their digits: the way is the middle's share times the step.
        let (from, step) = (0.003, 1e-9);
        let due = DRIVER.share(from + 0.5 * step) * step;
        assert!((DRIVER.way(from, step) / due - 1.0).abs() < 1e-13);
    }

    #[test]
    fn ways_of_steps_add_up() {
        let (mut sum, mut time) = (0.0, 0.0);
        for k in 0..1000 {
            let step = 1e-4 * (1.0 + f64::from(k % 7));
            sum += DRIVER.way(time, step);
            time += step;
        }
        // A rounding of the sum and one of the time in each step.
        let off = (sum - DRIVER.way(0.0, time)).abs();
        assert!(off < 1000.0 * f64::EPSILON * (sum.abs() + time), "{off:e}");
    }
}
