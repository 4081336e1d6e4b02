//! What a report must satisfy before anything is made of it.

use super::json::first_not_finite;
use super::model::{EndCurve, Measurements, Profile, Tolerance};
use super::{Report, ReportError};

/// Checks that all numbers are finite and that the parts fit each other.
///
/// # Errors
/// [`ReportError::NotFinite`] or [`ReportError::Inconsistent`], naming the first culprit.
pub fn check(report: &Report) -> Result<(), ReportError> {
    if let Some(path) = first_not_finite(report) {
        return Err(ReportError::NotFinite { path });
    }
    if report.runs.is_empty() {
        return Err(ReportError::inconsistent("runs", "a report needs at least one run, skipped or not"));
    }
    for (index, field) in report.fields.iter().enumerate() {
        if !names_a_file(&field.name) {
            let problem = format!("`{}` is not a field's name: lower-case ASCII letters, digits and `_`", field.name);
            return Err(ReportError::inconsistent("fields", problem));
        }
        if report.fields[..index].iter().any(|other| other.name == field.name) {
            return Err(ReportError::inconsistent("fields", format!("`{}` is declared twice", field.name)));
        }
    }
    for curve in &report.exact.fields {
        let path = format!("exact.fields[{}]", curve.field);
        known(report, &curve.field, &path)?;
        same_length(&path, "value", curve.value.len(), report.exact.x.len())?;
    }
    for approximation in &report.kernel_approximation {
        positive(&format!("kernel_approximation[{}]", approximation.function), &approximation.tolerance)?;
    }
    report.measured().try_for_each(|(_, run, measured)| check_run(report, &run.label(), measured))
}

/// Checks one run that took place.
fn check_run(report: &Report, label: &str, measured: &Measurements) -> Result<(), ReportError> {
    let nanoseconds = measured.speed.nanoseconds_per_update;
    if nanoseconds <= 0.0 {
        let problem = format!("{nanoseconds} ns per particle update: a run takes time");
        return Err(ReportError::inconsistent(format!("runs[{label}].speed"), problem));
    }
    for error in &measured.discretisation_error {
        known(report, &error.field, &format!("runs[{label}].discretisation_error"))?;
    }
    for difference in &measured.arithmetic_difference {
        let path = format!("runs[{label}].arithmetic_difference[{}]", difference.field);
        known(report, &difference.field, &path)?;
        positive(&path, &difference.tolerance)?;
        if difference.scale <= 0.0 {
            return Err(ReportError::inconsistent(path, "the scale of differences must be positive"));
        }
    }
    for conserved in &measured.conservation {
        if let Some(tolerance) = &conserved.tolerance {
            positive(&format!("runs[{label}].conservation[{}]", conserved.quantity), tolerance)?;
        }
    }
    let times = measured.series.time.len();
    for quantity in &measured.series.quantities {
        same_length(&format!("runs[{label}].series[{}]", quantity.name), "value", quantity.value.len(), times)?;
    }
    measured.ending.curves.iter().try_for_each(|curve| check_curve(label, curve))?;
    check_profile(report, label, &measured.profile)
}

/// Whether a name may become part of a file's name.
fn names_a_file(name: &str) -> bool {
    let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
    !name.is_empty() && name.chars().all(plain)
}

/// Checks that a curve of the end can be drawn.
fn check_curve(label: &str, curve: &EndCurve) -> Result<(), ReportError> {
    let path = format!("runs[{label}].ending.curves[{}]", curve.name);
    if !names_a_file(&curve.name) {
        return Err(ReportError::inconsistent(path, "a curve's name is of lower-case ASCII letters, digits and `_`"));
    }
    same_length(&path, "y", curve.y.value.len(), curve.x.value.len())?;
    if let Some(line) = &curve.expected {
        same_length(&format!("{path}.expected"), "y", line.y.len(), line.x.len())?;
    }
    let line = curve.expected.as_ref();
    let both = [(&curve.x, line.map(|line| &line.x)), (&curve.y, line.map(|line| &line.y))];
    let low = |value: &f64| *value <= 0.0;
    for (column, line) in both.into_iter().filter(|(column, _)| column.logarithmic) {
        if column.value.iter().chain(line.into_iter().flatten()).any(low) {
            let problem =
                format!("`{}` is drawn by powers of ten and has a number that is not above zero", column.name);
            return Err(ReportError::inconsistent(path, problem));
        }
    }
    Ok(())
}

/// Checks that all columns of a profile belong to the same particles.
fn check_profile(report: &Report, label: &str, profile: &Profile) -> Result<(), ReportError> {
    let rows = profile.x.len();
    for field in &profile.fields {
        let path = format!("runs[{label}].profile.fields[{}]", field.field);
        known(report, &field.field, &path)?;
        same_length(&path, "value", field.value.len(), rows)?;
        if !field.exact.is_empty() {
            same_length(&path, "exact", field.exact.len(), rows)?;
        }
        if !field.reference.is_empty() {
            same_length(&path, "reference", field.reference.len(), rows)?;
        }
    }
    Ok(())
}

/// The field must be declared in [`Report::fields`].
fn known(report: &Report, field: &str, path: &str) -> Result<(), ReportError> {
    match report.field(field) {
        Some(_) => Ok(()),
        None => Err(ReportError::inconsistent(path, format!("the field `{field}` is not declared in `fields`"))),
    }
}

/// Columns of one table must be equally long.
fn same_length(path: &str, column: &str, found: usize, expected: usize) -> Result<(), ReportError> {
    if found == expected {
        return Ok(());
    }
    Err(ReportError::inconsistent(path, format!("`{column}` has {found} entries where `x` has {expected}")))
}

/// A tolerance of zero or less is a mistake: exact agreement is asked for by the smallest positive number.
fn positive(path: &str, tolerance: &Tolerance) -> Result<(), ReportError> {
    if tolerance.value > 0.0 {
        return Ok(());
    }
    Err(ReportError::inconsistent(path, format!("the tolerance must be positive, not {}", tolerance.value)))
}

#[cfg(test)]
mod tests {
    use super::super::model::Outcome;
    use super::super::synthetic;
    use super::*;

    /// Applies `spoil` to the SIMD f64 run and returns the complaint.
    fn complaint(spoil: impl FnOnce(&mut Measurements)) -> String {
        let mut report = synthetic::report();
        let Outcome::Ran(measured) = &mut report.runs[1].outcome else { panic!("the synthetic SIMD run ran") };
        spoil(measured);
        check(&report).unwrap_err().to_string()
    }

    #[test]
    fn contradictions_are_named() {
        assert!(complaint(|m| m.profile.fields[0].exact.truncate(3)).contains("`exact` has 3 entries"));
        assert!(complaint(|m| m.discretisation_error[0].field = "spin".into()).contains("`spin` is not declared"));
        assert!(complaint(|m| m.arithmetic_difference[0].scale = 0.0).contains("scale"));
        assert!(complaint(|m| m.arithmetic_difference[0].tolerance.value = 0.0).contains("tolerance"));
        assert!(complaint(|m| m.speed.nanoseconds_per_update = 0.0).contains("SIMD f64"));
        let curve = |spoil: &dyn Fn(&mut EndCurve)| {
            let mut report = synthetic::with_ending();
            let Outcome::Ran(measured) = &mut report.runs[1].outcome else { panic!("the synthetic SIMD run ran") };
            spoil(&mut measured.ending.curves[0]);
            check(&report).unwrap_err().to_string()
        };
        assert!(curve(&|c| c.y.value[7] = 0.0).contains("`energy` is drawn by powers of ten"));
        assert!(curve(&|c| c.x.value.truncate(7)).contains("`y` has 59 entries where `x` has 7"));
        assert!(curve(&|c| c.expected.as_mut().unwrap().y[0] = -1.0).contains("not above zero"));
        assert!(curve(&|c| c.name = "../../etc".into()).contains("lower-case"));
        for name in ["../../etc", "Density", "", "velocity_x"] {
            let mut named = synthetic::report();
            named.fields[0].name = name.into();
            assert!(check(&named).unwrap_err().to_string().starts_with("fields: "), "{name}");
        }
        let mut empty = synthetic::report();
        empty.runs.clear();
        assert!(check(&empty).unwrap_err().to_string().contains("at least one run"));
    }
}
