//! Drag between gas and dust, after the forces of the gas: PL20 (4)-(7), (10).

use super::Physics;
use super::momentum::Line;
use super::species::{differ, is_gas};
use crate::equations::dissipation::signal_velocity;
use crate::equations::double_hump::double_hump;
use crate::equations::drag::{drag_acceleration, drag_heating, drag_rate, drag_step, drag_weight, stopping_rate};
use crate::equations::dust_reconstruction::{entropy_fixed, mass_share, reconstructed_drag_velocity, slope_along_pair};
use crate::equations::kernels::inverse_volume;
use crate::equations::time_step::{acceleration_step, courant_step};
use crate::fields::*;
use crate::schemes::Drag;
use etalon_kernels_gen::functions::smaller;
use etalon_kernels_gen::{Matrix, Pass, Real, Scalar, Separation, Symmetric, Vector, record};

/// Drag with the velocities that the particles have (PL20 4-7).
///
/// Runs after the last sweep and adds to its acceleration and energy rate, as [`Conduction`](super::Conduction) does. The step is
/// limited by the explicit drag, by the whole acceleration, and by signals between any two particles, which alone hold dust that
/// streams through dust.
#[derive(Clone, Copy, Debug)]
pub struct DragForces(pub Physics);

/// [`DragForces`] with velocities reconstructed at a common point (PL20 8-10, 13-16).
#[derive(Clone, Copy, Debug)]
pub struct ReconstructedDragForces(pub Physics);

record! {
    /// Read of either particle.
    pub struct DragPair {
        inverse_h: Scalar = INVERSE_SMOOTHING_LENGTH,
        velocity: Vector = VELOCITY,
        density: Scalar = DENSITY,
        sound_speed: Scalar = SOUND_SPEED,
        species: Scalar = SPECIES,
    }
}
record! {
    /// Read of either particle when velocities are reconstructed.
    pub struct DragReconstructionPair {
        mass: Scalar = MASS,
        strain_rate: Symmetric = LINEAR_STRAIN_RATE,
    }
}
record! {
    /// Read of the particle by the epilogue.
    pub struct DragEpilogue {
        mobility: Scalar = MOBILITY,
        acceleration: Vector = ACCELERATION,
        energy_rate: Scalar = ENERGY_RATE,
        time_step: Scalar = TIME_STEP,
    }
}
record! {
    /// Read of the particle.
    pub struct DragOwn {
        pair: DragPair,
        epilogue: DragEpilogue,
    }
}
record! {
    /// Read of a neighbour.
    pub struct DragOther {
        pair: DragPair,
        volume: Scalar = VOLUME,
    }
}
record! {
    /// Read of the particle.
    pub struct ReconstructedDragOwn {
        base: DragOwn,
        reconstruction: DragReconstructionPair,
    }
}
record! {
    /// Read of a neighbour.
    pub struct ReconstructedDragOther {
        base: DragOther,
        reconstruction: DragReconstructionPair,
    }
}
record! {
    /// Summed, signal velocity and stopping rate maximised.
    pub struct DragSums {
        acceleration: Vector = DRAG_ACCELERATION,
        heating: Scalar = DRAG_HEATING,
        signal_velocity: Scalar = SIGNAL_VELOCITY,
        stopping_rate: Scalar = STOPPING_RATE,
    }
}
record! {
    /// Written.
    pub struct DragOut {
        acceleration: Vector = ACCELERATION,
        energy_rate: Scalar = ENERGY_RATE,
        time_step: Scalar = TIME_STEP,
    }
}

impl DragForces {
    /// A scene without drag that runs this sweep all the same has a coefficient of zero.
    #[inline(always)]
    fn drag(&self) -> Drag {
        self.0.drag.unwrap_or(Drag::of(0.0))
    }

    /// What a neighbour does, given the pair's velocity difference along its line at the common point.
    #[inline(always)]
    fn forces<R: Real, const D: usize>(
        &self,
        a: &DragPair<R, D>,
        other: &DragOther<R, D>,
        at: &Separation<R, D>,
        line: &Line<R>,
        omega_star: R,
    ) -> DragSums<R, D> {
        let (b, drag) = (&other.pair, self.drag());
        let coefficient = R::lit(drag.coefficient);
        let omega_star = match drag.entropy_fix {
            true => entropy_fixed(omega_star, line.omega, R::zero()),
            false => omega_star,
        };
        // The larger of the two smoothing lengths.
        let inverse_h = a.inverse_h.min(b.inverse_h);
        let shape = double_hump::<R, D>(self.0.kernel, at.r_squared * (inverse_h * inverse_h));
        let hump = shape * inverse_volume::<R, D>(inverse_h);
        let weight = drag_weight::<R, D>(drag_rate(coefficient, a.density), other.volume, hump);
        // Among particles of one species there is none.
        let weight = R::pick(differ(a.species, b.species), weight, R::zero());
        let rate = stopping_rate(coefficient, a.density, b.density);
        DragSums {
            acceleration: drag_acceleration(drag.signs, weight, omega_star, at.x_ab.scale(line.inverse_r)),
            heating: drag_heating(weight, omega_star, line.omega),
            signal_velocity: signal_velocity(a.sound_speed, b.sound_speed, R::zero().min(line.omega)),
            stopping_rate: R::pick(differ(a.species, b.species), rate, R::zero()),
        }
    }
}

impl<const D: usize> Pass<D> for DragForces {
    type Own<R: Real> = DragOwn<R, D>;
    type Other<R: Real> = DragOther<R, D>;
    type Sums<R: Real> = DragSums<R, D>;
    type Out<R: Real> = DragOut<R, D>;
    const NAME: &'static str = "drag_forces";

    #[inline(always)]
    fn pair<R: Real>(&self, own: &Self::Own<R>, other: &Self::Other<R>, at: &Separation<R, D>) -> Self::Sums<R> {
        let line = Line::of(own.pair.velocity, other.pair.velocity, at);
        self.forces(&own.pair, other, at, &line, line.omega)
    }

    #[inline(always)]
    fn finish<R: Real>(&self, own: &Self::Own<R>, sums: &Self::Sums<R>) -> Self::Out<R> {
        let DragEpilogue { mobility, acceleration, energy_rate, time_step } = own.epilogue;
        let acceleration = acceleration + sums.acceleration.scale(mobility);
        // All of the heat goes to the gas.
        let heating = R::pick(is_gas(own.pair.species), sums.heating, R::zero());
        let h = R::one() / own.pair.inverse_h;
        let of_motion = smaller(courant_step(h, sums.signal_velocity), acceleration_step(h, acceleration.norm()));
        let time_step = smaller(time_step, smaller(of_motion, drag_step(sums.stopping_rate)));
        DragOut { acceleration, energy_rate: heating.mul_add(mobility, energy_rate), time_step }
    }
}

impl<const D: usize> Pass<D> for ReconstructedDragForces {
    type Own<R: Real> = ReconstructedDragOwn<R, D>;
    type Other<R: Real> = ReconstructedDragOther<R, D>;
    type Sums<R: Real> = DragSums<R, D>;
    type Out<R: Real> = DragOut<R, D>;
    const NAME: &'static str = "reconstructed_drag_forces";

    #[inline(always)]
    fn pair<R: Real>(&self, own: &Self::Own<R>, other: &Self::Other<R>, at: &Separation<R, D>) -> Self::Sums<R> {
        let plain = DragForces(self.0);
        let (a, b) = (&own.base.pair, &other.base.pair);
        let line = Line::of(a.velocity, b.velocity, at);
        let direction = at.x_ab.scale(line.inverse_r);
        let slope = |of: &DragReconstructionPair<R, D>| {
            slope_along_pair(Matrix::from_fn(|i, j| of.strain_rate.at(i, j)), direction)
        };
        // (10) calls the gas particle a and the dust particle i, from whichever of the two the pair is seen.
        let gas_first = is_gas(a.species);
        let sorted = |own: R, other: R| (R::pick(gas_first, own, other), R::pick(gas_first, other, own));
        let (slope_a, slope_i) = sorted(slope(&own.reconstruction), slope(&other.reconstruction));
        let (mass_a, mass_i) = sorted(own.reconstruction.mass, other.reconstruction.mass);
        let omega_star = reconstructed_drag_velocity(
            plain.drag().reconstruction,
            line.omega,
            line.r,
            slope_a,
            slope_i,
            mass_share(mass_a, mass_i),
            mass_share(mass_i, mass_a),
        );
        plain.forces(a, &other.base, at, &line, omega_star)
    }

    #[inline(always)]
    fn finish<R: Real>(&self, own: &Self::Own<R>, sums: &Self::Sums<R>) -> Self::Out<R> {
        DragForces(self.0).finish(&own.base, sums)
    }
}
