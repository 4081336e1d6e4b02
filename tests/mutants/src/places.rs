//! Where things are.

use std::path::{Path, PathBuf};

/// The root of the repository.
pub fn root() -> PathBuf {
    // This crate is two folders below it.
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The package whose tests are run.
pub fn reference() -> PathBuf {
    root().join("reference")
}

/// What was found at the last run.
pub fn record() -> PathBuf {
    root().join("tests/mutants/record.toml")
}

/// The mutants that are no faults, with reasons.
pub fn equivalents() -> PathBuf {
    root().join("tests/mutants/equivalent.toml")
}

/// The page with the result.
pub fn page() -> PathBuf {
    root().join("docs/mutants.md")
}
