//! How drag between gas and dust is computed.

use crate::choice;

choice! {
    /// Which signs the drag on gas and dust has (PL20 4, 5).
    DragSigns, "choice of signs of the drag" {
        /// Minus times gas less dust on the gas, plus on the dust: the difference decays.
        Physical = "physical",
        /// The signs as printed, with the printed `v_ai = v_a - v_i`: the difference grows. For comparison only.
        AsPrinted = "as-printed",
    }
}

choice! {
    /// Where the velocities of gas and dust are compared (PL20 8-10).
    CommonPoint, "common point of a pair" {
        /// Nowhere: each velocity is taken at its own particle, as before PL20.
        Particles = "particles",
        /// In the middle between the two particles.
        Midpoint = "midpoint",
        /// At the pair's centre of mass.
        Barycentre = "barycentre",
        /// With the weights as printed in PL20 (10), wrong unless the masses are equal. For comparison only.
        AsPrinted = "as-printed",
    }
}

choice! {
    /// The limiter of the two slopes of a pair (PL20 13-16).
    SlopeLimiter, "slope limiter" {
        /// None: the slopes' weighted mean.
        Unlimited = "none",
        /// PL20 (13), the most dissipative.
        Minmod = "minmod",
        /// PL20 (14).
        VanLeer = "van-leer",
        /// PL20 (15), the paper's choice.
        MonotonizedCentral = "MC",
        /// PL20 (16); feeds energy into waves.
        Superbee = "superbee",
    }
}

/// How the velocity difference of a gas and a dust particle is reconstructed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct DragReconstruction {
    /// Where the two velocities are compared.
    pub point: CommonPoint,
    /// How the two slopes are limited.
    pub limiter: SlopeLimiter,
}

impl DragReconstruction {
    /// What PL20 recommends: the barycentre, monotonized central.
    pub const RECOMMENDED: Self =
        DragReconstruction { point: CommonPoint::Barycentre, limiter: SlopeLimiter::MonotonizedCentral };
    /// No reconstruction at all.
    pub const NONE: Self = DragReconstruction { point: CommonPoint::Particles, limiter: SlopeLimiter::Unlimited };
}
