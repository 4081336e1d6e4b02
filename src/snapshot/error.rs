//! What can be wrong with a file or a snapshot.

use std::io;
use std::path::{Path, PathBuf};

/// Why a snapshot could not be made, read or written. One sentence, which names file, dataset, column or line, and what is allowed.
#[derive(Debug, thiserror::Error)]
pub enum SnapshotError {
    /// The operating system refused.
    #[error("cannot {action} {}: {source}", .path.display())]
    Io {
        /// What was tried, as a verb.
        action: &'static str,
        /// On what.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// What is in a file.
    #[error("{}: {problem}", .path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What is wrong in it, and what is allowed.
        problem: String,
    },
    /// Columns that are no snapshot.
    #[error("{0}")]
    Invalid(String),
}

impl SnapshotError {
    /// Wraps an operating system's error with what was tried on what.
    pub(super) fn io(action: &'static str, path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_owned();
        move |source| Self::Io { action, path, source }
    }

    /// Something wrong in a file.
    pub(super) fn file(path: &Path, problem: impl Into<String>) -> Self {
        Self::File { path: path.to_owned(), problem: problem.into() }
    }

    /// The same, said of a file: what is no snapshot was read from there.
    pub(super) fn in_file(self, path: &Path) -> Self {
        match self {
            Self::Invalid(problem) => Self::file(path, problem),
            known => known,
        }
    }
}
