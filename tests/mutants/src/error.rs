//! What can go wrong, each in one sentence.

use std::path::PathBuf;

/// Why there is no result.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The tests do not compile with the feature `mutants`.
    #[error("the tests of the equations could not be built with `--features mutants`; cargo says why above")]
    Build,
    /// A program could not be started.
    #[error("`{program}` could not be started ({source}): is it installed and executable?")]
    Start {
        /// Its name.
        program: String,
        /// The system's words.
        source: std::io::Error,
    },
    /// The tests fail before anything is changed.
    #[error("`{test}` fails with no fault switched on: mend it first")]
    Failing {
        /// The test.
        test: String,
    },
    /// A file cannot be read or written.
    #[error("{path}: {source}")]
    File {
        /// Which.
        path: PathBuf,
        /// The system's words.
        source: std::io::Error,
    },
    /// A file does not say what it should.
    #[error("{path}: {message}")]
    Content {
        /// Which.
        path: PathBuf,
        /// What is wrong.
        message: String,
    },
    /// A program said something unexpected.
    #[error("not understood: {what}")]
    Unreadable {
        /// What it said.
        what: String,
    },
    /// What is compiled is not what is read.
    #[error(
        "the test program has other mutants than the source: is an equation made by a macro, or hidden from some builds? \
         Write it out"
    )]
    Differs,
    /// No equation has such a name.
    #[error("no equation's path contains {only}: `--list` shows all paths")]
    NothingChosen {
        /// What was asked for.
        only: String,
    },
}

impl Error {
    /// For `map_err` on a path.
    pub fn file(path: impl Into<PathBuf>) -> impl FnOnce(std::io::Error) -> Self {
        let path = path.into();
        move |source| Error::File { path, source }
    }
}
