//! Why the program stops before its work is done.

use crate::report::ReportError;
use crate::snapshot::SnapshotError;
use etalon_reference::engine::EngineError;
use etalon_reference::scenes::SceneError;
use std::process::ExitCode;

/// One sentence for stderr, and the exit code that goes with it.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// What was asked for cannot be done; the sentence names the remedy. Exit code 2.
    #[error("{0}")]
    BadInput(String),
    /// It went wrong on the way. Exit code 1.
    #[error("{0}")]
    Broken(String),
}

impl Failure {
    /// The process's exit code.
    pub fn exit_code(&self) -> ExitCode {
        ExitCode::from(match self {
            Failure::BadInput(_) => 2,
            Failure::Broken(_) => 1,
        })
    }
}

impl From<SceneError> for Failure {
    fn from(error: SceneError) -> Self {
        match error {
            SceneError::Glass(_) => Failure::Broken(error.to_string()),
            _ => Failure::BadInput(error.to_string()),
        }
    }
}

impl From<EngineError> for Failure {
    fn from(error: EngineError) -> Self {
        Failure::Broken(error.to_string())
    }
}

impl From<SnapshotError> for Failure {
    fn from(error: SnapshotError) -> Self {
        // A file that is not there, is damaged or cannot be written: another file or folder helps.
        Failure::BadInput(error.to_string())
    }
}

impl From<ReportError> for Failure {
    fn from(error: ReportError) -> Self {
        match error {
            // Another folder helps.
            ReportError::Occupied { .. } | ReportError::Io { .. } => Failure::BadInput(error.to_string()),
            _ => Failure::Broken(error.to_string()),
        }
    }
}
