//! The result in one sentence.

use super::model::{FieldError, Measurements, Outcome, Report};
use super::number::typeset;

/// How a report ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Verdict {
    /// Everything that was compared lies within its tolerance.
    Pass,
    /// Something does not.
    Fail,
    /// There was nothing to compare.
    Incomplete,
}

impl Verdict {
    /// The verdict on a report.
    pub(super) fn on(report: &Report) -> Self {
        if !failures(report).is_empty() {
            Self::Fail
        } else if report.reference().is_none() || report.measured().count() < 2 {
            Self::Incomplete
        } else {
            Self::Pass
        }
    }
}

/// Whether everything that was compared lies within its tolerance; true also where nothing was.
pub fn passes(report: &Report) -> bool {
    failures(report).is_empty()
}

/// Everything that lies outside its tolerance, each in a clause.
pub(super) fn failures(report: &Report) -> Vec<String> {
    let mut found = Vec::new();
    for (_, run, measured) in report.measured() {
        let label = run.label();
        for difference in measured.arithmetic_difference.iter().filter(|difference| !difference.pass) {
            let field = report.field(&difference.field).map_or(difference.field.as_str(), |field| &field.label);
            found.push(format!(
                "{label} differs from the reference in {field} by {} of its scale, tolerance {}",
                typeset(difference.compared()),
                typeset(difference.tolerance.value)
            ));
        }
        for conserved in &measured.conservation {
            if let Some(tolerance) = conserved.tolerance.as_ref().filter(|_| !conserved.passes()) {
                found.push(format!(
                    "{label} lets {} drift by {}, tolerance {}",
                    conserved.quantity,
                    typeset(conserved.scaled_drift),
                    typeset(tolerance.value)
                ));
            }
        }
    }
    for approximation in report.kernel_approximation.iter().filter(|approximation| !approximation.passes()) {
        found.push(format!(
            "the {} {} is off by {}, tolerance {}",
            approximation.precision,
            approximation.function,
            typeset(approximation.max),
            typeset(approximation.tolerance.value)
        ));
    }
    found
}

/// The result in a few sentences: who follows the reference how closely, how far all are from the exact solution, how
/// much faster the fastest is, and what was skipped. A failure comes first and hides the rest.
pub fn headline(report: &Report) -> String {
    let failures = failures(report);
    if let Some((first, rest)) = failures.split_first() {
        return match rest.len() {
            0 => format!("{first}."),
            others => format!("{first}; and {others} more."),
        };
    }
    let sentences: Vec<String> = [agreement(report), accuracy(report), speed(report)].into_iter().flatten().collect();
    let skipped = report.runs.iter().filter_map(|run| match &run.outcome {
        Outcome::Skipped { reason } => Some(format!("{} was skipped: {reason}.", run.label())),
        Outcome::Ran(_) => None,
    });
    let nothing = if report.measured().next().is_none() { Some("Nothing was measured.".into()) } else { None };
    nothing.into_iter().chain(sentences).chain(skipped).collect::<Vec<_>>().join(" ")
}

/// `SIMD f64 follows the scalar reference to 2.20×10⁻¹⁴ and SIMD f32 to 6.60×10⁻⁶ of each field's scale.`
fn agreement(report: &Report) -> Option<String> {
    report.reference()?;
    let followers: Vec<(String, f64)> = report
        .measured()
        .filter_map(|(_, run, measured)| Some((run.label(), measured.worst_difference()?.compared())))
        .collect();
    let clause = |(index, (label, level)): (usize, &(String, f64))| match (index, *level) {
        (0, 0.0) => format!("{label} follows the scalar reference bit for bit"),
        (_, 0.0) => format!("{label} bit for bit"),
        (0, level) => format!("{label} follows the scalar reference to {}", typeset(level)),
        (_, level) => format!("{label} to {}", typeset(level)),
    };
    let clauses: Vec<String> = followers.iter().enumerate().map(clause).collect();
    let (last, others) = clauses.split_last()?;
    let joined = if others.is_empty() { last.clone() } else { format!("{} and {last}", others.join(", ")) };
    let unit = if followers.iter().any(|(_, level)| *level > 0.0) { " of each field’s scale" } else { "" };
    Some(format!("{joined}{unit}."))
}

/// `Against the exact solution L₁(vₓ) = 7.21×10⁻³.`
fn accuracy(report: &Report) -> Option<String> {
    let field = key_field(report)?;
    let (_, run, measured) = report.measured().find(|(_, _, measured)| measured.error_of(&field.name).is_some())?;
    let error = typeset(measured.error_of(&field.name)?.l1);
    let of_all = |measured: &Measurements| measured.error_of(&field.name).map(|other| typeset(other.l1));
    let same = report.measured().all(|(_, _, measured)| of_all(measured).is_none_or(|other| other == error));
    let whose = match (same, report.measured().count()) {
        (_, 1) => String::new(),
        (true, _) => " for every one".into(),
        (false, _) => format!(" for the {}", run.label()),
    };
    Some(format!("Against the exact solution, L₁({}) = {error}{whose}.", field.symbol))
}

/// `SIMD f32 is 9.70 times as fast as the reference.`
fn speed(report: &Report) -> Option<String> {
    report.reference()?;
    let (label, speed_up) = report
        .measured()
        .filter(|(_, run, _)| !run.is_reference())
        .filter_map(|(_, run, measured)| Some((run.label(), measured.speed.speed_up?)))
        .max_by(|a, b| a.1.total_cmp(&b.1))?;
    Some(format!("Fastest is {label}, {} times the speed of the reference.", typeset(speed_up)))
}

/// The field that stands for the others where there is room for one: the velocity, as in the papers' tables.
pub(super) fn key_field(report: &Report) -> Option<&super::model::Field> {
    report.fields.iter().find(|field| field.name.starts_with("velocity")).or(report.fields.first())
}

/// The key field's error of a run against the exact solution.
pub(super) fn key_error<'a>(report: &Report, measured: &'a Measurements) -> Option<&'a FieldError> {
    measured.error_of(&key_field(report)?.name)
}

#[cfg(test)]
mod tests {
    use super::super::synthetic;
    use super::*;

    #[test]
    fn a_pass_says_how_close_how_right_and_how_fast() {
        let report = synthetic::report();
        assert_eq!(Verdict::on(&report), Verdict::Pass);
        insta::assert_snapshot!(headline(&report), @"SIMD f64 follows the scalar reference to 2.20×10⁻¹⁴ and SIMD f32 to 6.60×10⁻⁶ of each field’s scale. Against the exact solution, L₁(vₓ) = 7.21×10⁻³ for every one. Fastest is SIMD f32, 9.73 times the speed of the reference. WGSL f32 was skipped: no graphics adapter found (install a Vulkan driver, or mesa-vulkan-drivers).");
    }

    #[test]
    fn a_failure_is_said_first() {
        let mut report = synthetic::report();
        let Outcome::Ran(measured) = &mut report.runs[2].outcome else { panic!("the synthetic SIMD run ran") };
        measured.arithmetic_difference[2].pass = false;
        assert_eq!(Verdict::on(&report), Verdict::Fail);
        assert!(headline(&report).starts_with("SIMD f32 differs from the reference in pressure by"));

        let mut report = synthetic::report();
        report.kernel_approximation[0].max = 1.0;
        assert!(headline(&report).contains("mixed sinc kernel w(q) is off by 1.00"), "{}", headline(&report));
        let Outcome::Ran(measured) = &mut report.runs[1].outcome else { panic!("the synthetic SIMD run ran") };
        measured.conservation[1].scaled_drift = -1.0;
        assert_eq!(failures(&report).len(), 2);
        assert!(headline(&report).ends_with("; and 1 more."));
    }

    #[test]
    fn nothing_compared_is_not_a_pass() {
        let mut report = synthetic::report();
        report.runs.remove(0);
        assert_eq!(Verdict::on(&report), Verdict::Incomplete);
        assert!(!headline(&report).contains("reference"));
        report.runs.drain(..2);
        assert!(headline(&report).starts_with("Nothing was measured. WGSL f32 was skipped: no graphics adapter"));
    }

    #[test]
    fn bit_equality_is_called_by_its_name() {
        let mut report = synthetic::report();
        let Outcome::Ran(measured) = &mut report.runs[1].outcome else { panic!("the synthetic SIMD run ran") };
        for difference in &mut measured.arithmetic_difference {
            (difference.rms, difference.max) = (0.0, 0.0);
        }
        assert!(headline(&report).starts_with("SIMD f64 follows the scalar reference bit for bit and SIMD f32 to "));
    }
}
