//! What can go wrong with a report.

use std::io;
use std::path::{Path, PathBuf};

/// Why a report could not be made, written or read. Each message names the culprit and, where there is one, the remedy.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// A number that JSON cannot hold.
    #[error("{path} is not a finite number, which a report cannot hold; the run that produced it went wrong")]
    NotFinite {
        /// Where in the report, for example `runs[SIMD f64].profile.fields[density].value[17]`.
        path: String,
    },
    /// Parts of the report contradict each other.
    #[error("{path}: {problem}")]
    Inconsistent {
        /// Where in the report.
        path: String,
        /// What is wrong there.
        problem: String,
    },
    /// A text that is not a report, or not one that this version reads.
    #[error("not a readable report: {problem}")]
    Unreadable {
        /// Why not.
        problem: String,
    },
    /// The folder holds something that this program did not write.
    #[error("{} {problem}; nothing was written: name another folder with --out", .folder.display())]
    Occupied {
        /// The folder asked for.
        folder: PathBuf,
        /// What is there.
        problem: String,
    },
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
    /// A plot could not be drawn.
    #[error("cannot draw the plot {plot}: {problem}")]
    Plot {
        /// Which plot.
        plot: String,
        /// Why not.
        problem: String,
    },
}

impl ReportError {
    /// Wraps an operating-system error with what was tried on what.
    pub(super) fn io(action: &'static str, path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_owned();
        move |source| Self::Io { action, path, source }
    }

    /// A contradiction at `path`.
    pub(super) fn inconsistent(path: impl Into<String>, problem: impl Into<String>) -> Self {
        Self::Inconsistent { path: path.into(), problem: problem.into() }
    }
}
