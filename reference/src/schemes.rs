//! The choices a scene makes, by the names the papers give them.

use crate::choice;

choice! {
    /// The dissipation schemes of GS25: Table 1, the classical one of its section 2.2, and what Table 8 adds.
    Dissipation, "dissipation scheme" {
        /// Constant coefficients, no limiter.
        Av = "AV",
        /// A linear coefficient that rises where the flow is about to converge and decays elsewhere (9, 10).
        AvSw = "AVSW",
        /// Velocities reconstructed at the pair's midpoint.
        AvSlr = "AVSLR",
        /// Both: the switch's coefficient and reconstructed velocities.
        AvSwSlr = "AVSWSLR",
        /// Reconstruction times `1 - B`.
        AvSlrB = "AVSLRB",
        /// Reconstruction times `1 - B^2`.
        AvSlrB2 = "AVSLRB2",
        /// The same, and the linear coefficient lowered to `max(F, B)`.
        AvSlrB2F = "AVSLRB2F",
        /// The classical form in `mu` (4, 5), multiplied with Balsara's limiter (7).
        AvB = "AVB",
        /// AVSLRB2 with the limiter that knows the period of a driven wave (28).
        AvSlrBStar2 = "AVSLRB*2",
        /// AVSLRB2F with that limiter.
        AvSlrBStar2F = "AVSLRB*2F",
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

choice! {
    /// How derivatives are estimated: the first rung of C25's ladder.
    Gradients, "way to take gradients" {
        /// With the kernel's own gradient `grad_a W_ab`: angular momentum is kept exactly, linear fields are not.
        Kernel = "kernel",
        /// By the integral approach (C25 1-5): exact for linear fields.
        Integral = "integral",
    }
}

choice! {
    /// Which volume a particle stands for: the second rung of C25's ladder.
    VolumeElement, "volume element" {
        /// `m / rho` with `rho = sum m_b W_ab`.
        Standard = "standard",
        /// `X / k` with `X = m / rho^0`, `k = sum X_b W_ab` (C25 19, 20).
        Generalised = "generalised",
    }
}

choice! {
    /// The rungs of C25's ladder (section 2, Figure 1), by the paper's names; each has the ingredients of those before it.
    Rung, "rung of the ladder" {
        /// The classic scheme: kernel gradients, standard volume elements, constant viscosity.
        Standard = "STD",
        /// Gradients by integrals.
        IntegralGradients = "IA",
        /// Generalised volume elements.
        VolumeElements = "GVE",
        /// A viscosity that varies in time.
        VariableViscosity = "VAV",
        /// Slope-limited reconstruction.
        SlopeLimitedReconstruction = "SLR",
    }
}

impl Rung {
    /// How it takes gradients.
    pub const fn gradients(self) -> Gradients {
        match self {
            Rung::Standard => Gradients::Kernel,
            _ => Gradients::Integral,
        }
    }
    /// Its volume elements.
    pub const fn volume_element(self) -> VolumeElement {
        match self {
            Rung::Standard | Rung::IntegralGradients => VolumeElement::Standard,
            _ => VolumeElement::Generalised,
        }
    }
    /// Its dissipation scheme, in GS25's names: C25 (15, 16) are GS25 (9, 10), and (8-14) are (11-17).
    pub const fn dissipation(self) -> Dissipation {
        match self {
            Rung::Standard | Rung::IntegralGradients | Rung::VolumeElements => Dissipation::Av,
            Rung::VariableViscosity => Dissipation::AvSw,
            Rung::SlopeLimitedReconstruction => Dissipation::AvSwSlr,
        }
    }
}

choice! {
    /// Which velocity of approach stands in the viscosity.
    ApproachForm, "form of the viscosity" {
        /// `omega`, along the line of centres (GS25 6).
        Projected = "projected",
        /// `mu`, weighted with `h/r` and regularised (GS25 4, 5): the classical form, and (27) as printed.
        Regularised = "regularised",
    }
}

mod drag;
pub use drag::{CommonPoint, Drag, DragReconstruction, DragSigns, SlopeLimiter};
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
        !matches!(self, Dissipation::Av | Dissipation::AvSw | Dissipation::AvB)
    }
    /// Whether the linear coefficient depends on time (GS25 9, 10).
    pub const fn switches(self) -> bool {
        matches!(self, Dissipation::AvSw | Dissipation::AvSwSlr)
    }
    /// Whether the limiter has to know the period of a driven wave (GS25 28).
    pub const fn knows_waves(self) -> bool {
        matches!(self, Dissipation::AvSlrBStar2 | Dissipation::AvSlrBStar2F)
    }
}

/// The numbers that go with a dissipation scheme.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Viscosity {
    /// The scheme.
    pub dissipation: Dissipation,
    /// Which velocity of approach it takes.
    pub form: ApproachForm,
    /// Linear coefficient (GS25 Table 1: 1); the largest where it depends on time.
    pub alpha: f64,
    /// The smallest linear coefficient where it depends on time (GS25 section 2.1: 0.05).
    pub alpha_min: f64,
    /// Quadratic coefficient (GS25 Table 1: 2).
    pub beta: f64,
    /// Width of the cut-off of the reconstruction at short range, in units of `h` (GS25 14: 0.2).
    pub q_fold: f64,
    /// Floor of the linear coefficient in AVSLRB2F and AVSLRB*2F (GS25 Tables 1 and 8: 0.5).
    pub floor: f64,
    /// The period of the wave's driver in the schemes that know it (GS25 section 5.2: 0.05, the membrane's), a time.
    pub wave_period: f64,
    /// Coefficient of artificial conduction, `alpha_u`; zero for none ([`Viscosity::CONDUCTION`] where there is some).
    pub conduction: f64,
}

impl Viscosity {
    /// The coefficient of conduction that GS25 section 3.6 states.
    pub const CONDUCTION: f64 = 0.1;

    /// The scheme with the coefficients of GS25's Tables 1 and 8, without conduction.
    pub const fn of(dissipation: Dissipation) -> Self {
        let form = match dissipation {
            Dissipation::AvB => ApproachForm::Regularised,
            _ => ApproachForm::Projected,
        };
        Viscosity {
            dissipation,
            form,
            alpha: 1.0,
            alpha_min: 0.05,
            beta: 2.0,
            q_fold: 0.2,
            floor: 0.5,
            wave_period: 0.05,
            conduction: 0.0,
        }
    }

    /// The six schemes of the oscillating membrane, in the order of GS25 Table 8. The first has a lower coefficient than elsewhere.
    pub const MEMBRANE: [Self; 6] = [
        Viscosity { alpha: 0.2, ..Self::of(Dissipation::Av) },
        Self::of(Dissipation::AvSw),
        Self::of(Dissipation::AvSlrB2),
        Self::of(Dissipation::AvSwSlr),
        Self::of(Dissipation::AvSlrBStar2),
        Self::of(Dissipation::AvSlrBStar2F),
    ];

    /// The angular frequency of the wave's driver, `2 pi / T` (GS25 28).
    pub fn angular_frequency(&self) -> f64 {
        std::f64::consts::TAU / self.wave_period
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
        let error = "AVX".parse::<Dissipation>().unwrap_err().to_string();
        let all = "AV, AVSW, AVSLR, AVSWSLR, AVSLRB, AVSLRB2, AVSLRB2F, AVB, AVSLRB*2, AVSLRB*2F";
        assert_eq!(error, format!("there is no dissipation scheme `AVX`; choose one of {all}"));
    }
}
