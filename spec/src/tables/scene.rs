//! The problems that the papers' numbers belong to.

use std::fmt;

use serde::Deserialize;

use super::setups::Test;

/// A problem of one of the three papers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Scene {
    /// Sod's shock tube.
    Sod,
    /// Sedov's blast wave.
    Sedov,
    /// The steady vortex of Gresho and Chan.
    GreshoChan,
    /// The Kelvin-Helmholtz instability.
    KelvinHelmholtz,
    /// The Rayleigh-Taylor instability.
    RayleighTaylor,
    /// A cloud in a supersonic wind.
    WindCloud,
    /// Driven subsonic turbulence.
    Turbulence,
    /// The wave of an oscillating cylinder.
    Membrane,
    /// A sound wave in gas and dust.
    Dustywave,
    /// A shock tube of gas and dust.
    Dustyshock,
}

impl Scene {
    /// Every problem.
    pub const ALL: [Self; 10] = [
        Self::Sod,
        Self::Sedov,
        Self::GreshoChan,
        Self::KelvinHelmholtz,
        Self::RayleighTaylor,
        Self::WindCloud,
        Self::Turbulence,
        Self::Membrane,
        Self::Dustywave,
        Self::Dustyshock,
    ];

    /// The name in a command line, such as `gresho-chan`.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Sod => "sod",
            Self::Sedov => "sedov",
            Self::GreshoChan => "gresho-chan",
            Self::KelvinHelmholtz => "kelvin-helmholtz",
            Self::RayleighTaylor => "rayleigh-taylor",
            Self::WindCloud => "wind-cloud",
            Self::Turbulence => "turbulence",
            Self::Membrane => "membrane",
            Self::Dustywave => "dustywave",
            Self::Dustyshock => "dustyshock",
        }
    }
}

impl From<Test> for Scene {
    fn from(test: Test) -> Self {
        match test {
            Test::ShockTube => Self::Sod,
            Test::Sedov => Self::Sedov,
            Test::GreshoChanVortex => Self::GreshoChan,
            Test::KelvinHelmholtz => Self::KelvinHelmholtz,
            Test::RayleighTaylor => Self::RayleighTaylor,
            Test::WindCloud => Self::WindCloud,
            Test::Turbulence => Self::Turbulence,
        }
    }
}

impl fmt::Display for Scene {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(self.as_str())
    }
}
