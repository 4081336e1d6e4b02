//! Artificial conduction, after the forces: it adds to their heating and may shorten their step.

use super::Physics;
use super::gradient_vector::gradient_vector;
use crate::equations::conduction::{conduction_rate, conduction_velocity, conduction_weight};
use crate::equations::time_step::cooling_step;
use crate::fields::*;
use etalon_kernels_gen::functions::{ratio_or_zero, smaller};
use etalon_kernels_gen::{Field, Part, Pass, Real, Scalar, Separation, Symmetric, Vector, record};

/// Heat flows from the hotter to the colder particle of a pair whose pressures differ (Price et al. 2018; GS25 section 3.6).
///
/// Runs after the last sweep and adds to its energy rate: a scene without conduction has neither the sweep nor its fields.
#[derive(Clone, Copy, Debug)]
pub struct Conduction(pub Physics);

record! {
    /// Read of either particle.
    pub struct ConductionPair {
        inverse_h: Scalar = INVERSE_SMOOTHING_LENGTH,
        internal_energy: Scalar = INTERNAL_ENERGY,
        density: Scalar = DENSITY,
        pressure: Scalar = PRESSURE,
        grad_h: Scalar = GRAD_H,
        c: Symmetric = GRADIENT_MATRIX,
    }
}
record! {
    /// Read of the particle.
    pub struct ConductionOwn {
        pair: ConductionPair,
        mobility: Scalar = MOBILITY,
        energy_rate: Scalar = ENERGY_RATE,
        time_step: Scalar = TIME_STEP,
    }
}
record! {
    /// Read of a neighbour.
    pub struct ConductionOther {
        pair: ConductionPair,
        mass: Scalar = MASS,
    }
}
record! {
    /// Summed.
    pub struct ConductionSums { conduction: Scalar = CONDUCTION_RATE }
}
record! {
    /// Written.
    pub struct ConductionOut {
        energy_rate: Scalar = ENERGY_RATE,
        time_step: Scalar = TIME_STEP,
    }
}

impl Conduction {
    /// `A_ab(h) / (Omega rho)`, or the kernel's gradient for `A_ab`, with the smoothing length and the matrix of one of the two.
    #[inline(always)]
    fn weighted_gradient<R: Real, const D: usize>(
        &self,
        of: &ConductionPair<R, D>,
        at: &Separation<R, D>,
    ) -> Vector<R, D> {
        let gradient = gradient_vector(&self.0, of.c, of.inverse_h, -at.x_ab, at.r_squared);
        gradient.scale(conduction_weight(of.grad_h, of.density))
    }
}

impl<const D: usize> Pass<D> for Conduction {
    type Own<R: Real> = ConductionOwn<R, D>;
    type Other<R: Real> = ConductionOther<R, D>;
    type Sums<R: Real> = ConductionSums<R, D>;
    type Out<R: Real> = ConductionOut<R, D>;
    const NAME: &'static str = "conduction";

    fn uses(&self, _: Part, field: Field) -> bool {
        self.0.knows(field)
    }

    #[inline(always)]
    fn pair<R: Real>(&self, own: &Self::Own<R>, other: &Self::Other<R>, at: &Separation<R, D>) -> Self::Sums<R> {
        let (a, b) = (&own.pair, &other.pair);
        let inverse_r = ratio_or_zero(R::one(), at.r_squared.sqrt());
        let mean_density = R::lit(0.5) * (a.density + b.density);
        let conduction = conduction_rate(
            other.mass,
            R::lit(self.0.viscosity.conduction),
            conduction_velocity(a.pressure, b.pressure, mean_density),
            a.internal_energy - b.internal_energy,
            at.x_ab,
            inverse_r,
            self.weighted_gradient(a, at) + self.weighted_gradient(b, at),
        );
        ConductionSums { conduction }
    }

    #[inline(always)]
    fn finish<R: Real>(&self, own: &Self::Own<R>, sums: &Self::Sums<R>) -> Self::Out<R> {
        let energy_rate = sums.conduction.mul_add(own.mobility, own.energy_rate);
        let time_step = smaller(own.time_step, cooling_step(own.pair.internal_energy, energy_rate));
        ConductionOut { energy_rate, time_step }
    }
}
