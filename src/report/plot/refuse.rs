//! Input that no plot can show, refused with the place of the fault.

use super::super::ReportError;

/// Refuses what is not a finite number.
pub(super) fn finite(value: f64, path: impl FnOnce() -> String) -> Result<(), ReportError> {
    if value.is_finite() { Ok(()) } else { Err(ReportError::NotFinite { path: path() }) }
}

/// Refuses what does not hold.
pub(super) fn unless(holds: bool, path: impl FnOnce() -> String, problem: &str) -> Result<(), ReportError> {
    if holds { Ok(()) } else { Err(ReportError::inconsistent(path(), problem)) }
}
