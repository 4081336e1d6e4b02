//! The choices a scene makes, by the names the papers give them.

use crate::choice;

choice! {
    /// The dissipation schemes of GS25 Table 1 that need no time-dependent coefficient.
    Dissipation, "dissipation scheme" {
        /// Constant coefficients, no limiter.
        Av = "AV",
        /// Velocities reconstructed at the pair's midpoint.
        AvSlr = "AVSLR",
        /// Reconstruction times `1 - B`.
        AvSlrB = "AVSLRB",
        /// Reconstruction times `1 - B^2`.
        AvSlrB2 = "AVSLRB2",
        /// The same, and the linear coefficient lowered to `max(F, B)`.
        AvSlrB2F = "AVSLRB2F",
    }
}

choice! {
    /// The interpolating kernel.
    Kernel, "kernel" {
        /// `0.9 S_4 + 0.1 S_9`, each member normalised by itself (Cabezón & García-Senz 2024).
        MixedSinc = "sinc49",
        /// The cubic spline M4.
        CubicSpline = "M4",
        /// The quintic spline M6.
        QuinticSpline = "M6",
        /// Wendland's C2.
        WendlandC2 = "C2",
        /// Wendland's C4.
        WendlandC4 = "C4",
        /// Wendland's C6.
        WendlandC6 = "C6",
    }
}

choice! {
    /// Which grad-h factor enters the equations of motion.
    GradH, "grad-h form" {
        /// The derivative of the density estimate itself.
        Exact = "exact",
        /// With the derivative of the partition of unity taken out (C25 31).
        Corrected = "corrected",
    }
}

mod drag;
pub use drag::{CommonPoint, DragReconstruction, DragSigns, SlopeLimiter};
choice! {
    /// What is a parabola in the driving of turbulence.
    Profile, "driving profile" {
        /// The power per wave number, as SPH-EXA has it.
        Power = "power",
        /// The amplitude of each mode, as C25 section 2 and GS25 section 4 say.
        Amplitude = "amplitude",
    }
}

choice! {
    /// How the driven modes are weighted among directions.
    ModeWeights, "weights of the driven modes" {
        /// Every mode the same.
        Even = "even",
        /// As SPH-EXA's list of modes makes them: power twice as large along a face of the box, four times along an edge.
        Published = "published",
    }
}

choice! {
    /// Whether the half stands in the Mach number of a scale (C25 33).
    MachReading, "reading of C25 33" {
        /// `sqrt(S_2 / 2) / c`: far apart it is the root-mean-square Mach number.
        Halved = "halved",
        /// `sqrt(S_2) / c`.
        Whole = "whole",
    }
}

choice! {
    /// What a mean over particles stands for.
    Weighting, "weighting" {
        /// A mean over mass.
        Mass = "mass",
        /// A mean over volume, `m / rho` a particle.
        Volume = "volume",
    }
}

impl Kernel {
    /// Support radius in units of the smoothing length.
    pub const fn support(self) -> f64 {
        match self {
            Kernel::QuinticSpline => 3.0,
            _ => 2.0,
        }
    }
}

impl Dissipation {
    /// Whether velocities are reconstructed before they enter the viscosity.
    pub const fn reconstructs(self) -> bool {
        !matches!(self, Dissipation::Av)
    }
}

/// The numbers that go with a dissipation scheme.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Viscosity {
    /// The scheme.
    pub dissipation: Dissipation,
    /// Linear coefficient (GS25 Table 1: 1).
    pub alpha: f64,
    /// Quadratic coefficient (GS25 Table 1: 2).
    pub beta: f64,
    /// Width of the cut-off of the reconstruction at short range, in units of `h` (GS25 14: 0.2).
    pub q_fold: f64,
    /// Floor of the linear coefficient in AVSLRB2F (GS25 Table 1: 0.5).
    pub floor: f64,
}

impl Viscosity {
    /// The scheme with the coefficients of GS25 Table 1.
    pub const fn of(dissipation: Dissipation) -> Self {
        Viscosity { dissipation, alpha: 1.0, beta: 2.0, q_fold: 0.2, floor: 0.5 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_go_both_ways_and_a_wrong_one_lists_the_right_ones() {
        for &scheme in Dissipation::ALL {
            assert_eq!(scheme.name().to_lowercase().parse(), Ok(scheme));
        }
        let error = "AVSW".parse::<Dissipation>().unwrap_err().to_string();
        assert_eq!(error, "there is no dissipation scheme `AVSW`; choose one of AV, AVSLR, AVSLRB, AVSLRB2, AVSLRB2F");
    }
}
