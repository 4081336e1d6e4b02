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

/// Drag between gas and dust, as a scene chooses it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drag {
    /// The drag coefficient `K` (M L^-nu T^-1), the same everywhere; zero for two species that do not feel each other.
    pub coefficient: f64,
    /// Which signs drag has.
    pub signs: DragSigns,
    /// How the velocities of a pair are reconstructed.
    pub reconstruction: DragReconstruction,
    /// Whether the raw velocity difference is taken where the reconstructed one would cool the gas (PL20 section 2.5).
    pub entropy_fix: bool,
}

impl Drag {
    /// Drag with this coefficient as PL20 recommends it: reconstructed at the barycentre with the monotonized central limiter, without the entropy
    /// fix, which the paper found more dissipative.
    pub const fn of(coefficient: f64) -> Self {
        let reconstruction = DragReconstruction::RECOMMENDED;
        Drag { coefficient, signs: DragSigns::Physical, reconstruction, entropy_fix: false }
    }

    /// Whether velocity gradients are needed.
    pub fn reconstructs(&self) -> bool {
        self.reconstruction.point != CommonPoint::Particles
    }
}
