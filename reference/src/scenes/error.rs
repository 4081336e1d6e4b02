//! Why a scene cannot be set up.

use super::{Definition, GlassError};
use crate::diagnostics::entropy::EntropyError;
use crate::diagnostics::mode_amplitude::AmplitudeError;
use crate::domain::DomainError;
use crate::engine::EngineError;
use crate::norms::NormError;
use crate::particles::ParticleError;
use crate::turbulence::TurbulenceError;

/// What is wrong with the choices; each says what to give instead.
#[derive(Debug, thiserror::Error)]
pub enum SceneError {
    /// So few particles that a support would meet itself around the box.
    #[error(
        "--n {given}: too few for {neighbours} neighbours in the {dimension}-D box, whose supports would meet themselves around it; \
         --n {enough} is enough"
    )]
    TooFew {
        /// What was asked for.
        given: usize,
        /// In how many dimensions.
        dimension: usize,
        /// What works.
        enough: usize,
        /// With so many neighbours.
        neighbours: f64,
    },
    /// A neighbour number that no kernel can use.
    #[error("--neighbours {given}: {dimension}-D needs between {least} and {most}")]
    Neighbours {
        /// What was asked for.
        given: f64,
        /// In how many dimensions.
        dimension: usize,
        /// At least.
        least: f64,
        /// At most.
        most: f64,
    },
    /// A choice of the scene's own that makes no sense.
    #[error("{name} = {given}: {rule}")]
    Choice {
        /// As it is named in scene files.
        name: &'static str,
        /// What was given.
        given: String,
        /// What is allowed.
        rule: String,
    },
    /// A dimension that the scene does not have.
    #[error("--dim {given}: the scene {scene} runs in {}; choose one of them", words(allowed))]
    Dimension {
        /// The scene.
        scene: &'static str,
        /// What was asked for.
        given: usize,
        /// What there is.
        allowed: &'static [usize],
    },
    /// Something the scene cannot do with particles given from outside.
    #[error("{0}")]
    Given(String),
    /// The particles were refused.
    #[error(transparent)]
    Particles(#[from] ParticleError),
    /// The glass failed.
    #[error(transparent)]
    Glass(#[from] GlassError),
    /// What it is to be compared with cannot be computed.
    #[error("no solution to compare with: {0}")]
    Solution(String),
    /// Something that is watched while it runs cannot be measured.
    #[error(transparent)]
    Norm(#[from] NormError),
    /// The amplitude of a wave cannot.
    #[error(transparent)]
    Amplitude(#[from] AmplitudeError),
    /// The entropy cannot.
    #[error(transparent)]
    Entropy(#[from] EntropyError),
    /// What is measured on turbulence cannot.
    #[error(transparent)]
    Turbulence(#[from] TurbulenceError),
    /// A sweep that measuring takes cannot be made.
    #[error("cannot sweep over the particles once more: {0}")]
    Engine(#[from] EngineError),
    /// A state without a field that its scene measures.
    #[error("the state has no {field}: read it with State::read_for, which reads what the scene asks for")]
    Unread {
        /// Which field.
        field: &'static str,
    },
}

impl SceneError {
    /// A choice that must be a finite number above some least one.
    pub(super) fn unless_above(name: &'static str, given: f64, least: f64) -> Result<(), Self> {
        let rule = || format!("give a finite number above {least}");
        if given.is_finite() && given > least {
            return Ok(());
        }
        Err(SceneError::Choice { name, given: given.to_string(), rule: rule() })
    }

    /// A dimension that the problem does not have.
    pub(super) fn unless_in<P: Definition>(scene: &'static str, given: usize) -> Result<(), Self> {
        match P::DIMENSIONS.contains(&given) {
            true => Ok(()),
            false => Err(SceneError::Dimension { scene, given, allowed: P::DIMENSIONS }),
        }
    }
}

impl From<DomainError> for SceneError {
    fn from(error: DomainError) -> Self {
        SceneError::Particles(error.into())
    }
}

fn words(dimensions: &[usize]) -> String {
    let all: Vec<String> = dimensions.iter().map(|d| format!("{d}-D")).collect();
    all.join(" and ")
}
