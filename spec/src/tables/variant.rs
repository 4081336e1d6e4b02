//! What the papers compare: schemes of dissipation, of drag, and ingredients of a code.

use std::fmt;

use super::membrane::MembraneVariant;
use super::schemes::SchemeName;

/// How PL20 computes drag between gas and dust.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum DragScheme {
    /// Velocities as they stand at the particles, as before that paper.
    Unreconstructed,
    /// Reconstructed velocities without a limiter.
    Unlimited,
    /// Reconstructed, with the limiter of PL20 equation 13.
    Minmod,
    /// Reconstructed, with the limiter of equation 14.
    VanLeer,
    /// Reconstructed, with the limiter of equation 15, which the paper recommends.
    MonotonizedCentral,
    /// Reconstructed, with the limiter of equation 16.
    Superbee,
    /// Reconstructed without a limiter, but not where that would change the sign of the velocity difference (section 2.5).
    EntropyFix,
}

/// A rung of C25's ladder: each has the ingredients of those before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Rung {
    /// The classic scheme.
    Standard,
    /// Gradients by integrals.
    IntegralGradients,
    /// Generalised volume elements.
    VolumeElements,
    /// A viscosity that varies in time.
    VariableViscosity,
    /// Slope-limited reconstruction.
    SlopeLimitedReconstruction,
}

/// The form of the grad-h factor that C25 compares.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum GradHForm {
    /// The derivative of the density estimate itself.
    Exact,
    /// C25 equation 31.
    Corrected,
}

/// One of the alternatives among which a paper compares.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Variant {
    /// A dissipation scheme of GS25, Table 1.
    Scheme(SchemeName),
    /// A variant of GS25, Table 8; of the same name as a scheme, it need not have its coefficients.
    Membrane(MembraneVariant),
    /// A way to compute drag, of PL20.
    Drag(DragScheme),
    /// A rung of C25's ladder.
    Rung(Rung),
    /// A form of the grad-h factor, of C25.
    GradH(GradHForm),
}

impl Variant {
    /// The name: the paper's where it has one, without calligraphy; the limiters' and grad-h forms' are Etalon's.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Scheme(name) => name.as_str(),
            Self::Membrane(name) => name.as_str(),
            Self::Drag(drag) => match drag {
                DragScheme::Unreconstructed => "unreconstructed",
                DragScheme::Unlimited => "none",
                DragScheme::Minmod => "minmod",
                DragScheme::VanLeer => "van-leer",
                DragScheme::MonotonizedCentral => "MC",
                DragScheme::Superbee => "superbee",
                DragScheme::EntropyFix => "entropy-fix",
            },
            Self::Rung(rung) => match rung {
                Rung::Standard => "STD",
                Rung::IntegralGradients => "IA",
                Rung::VolumeElements => "GVE",
                Rung::VariableViscosity => "VAV",
                Rung::SlopeLimitedReconstruction => "SLR",
            },
            Self::GradH(GradHForm::Exact) => "exact",
            Self::GradH(GradHForm::Corrected) => "corrected",
        }
    }
}

impl fmt::Display for Variant {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(self.as_str())
    }
}
