//! Recorded errors as a table: a row for each way to call a function, a column for each target.

use super::Function;
use crate::target::Target;

/// The head of the table.
pub(super) fn head() -> Vec<String> {
    let targets = Target::ALL.map(Target::name);
    ["call", "operations"].into_iter().chain(targets).map(ToString::to_string).collect()
}

/// Its rows: the call, its operations in `f32` and `f64`, the worst error and the budget on each target in ulps.
pub(super) fn rows(function: &Function) -> Vec<Vec<String>> {
    let row = |call: &super::Call| {
        let operations = match (call.operations.f32, call.operations.f64) {
            (single, double) if single == double => single.to_string(),
            (single, double) => format!("{single}, {double} in f64"),
        };
        let cell = |target: Target| {
            let record = call.figures.iter().find(|record| record.target == target.name());
            record.map_or_else(|| "-".to_string(), |record| ratio(record.worst, record.budget))
        };
        let name = call.probe.strip_prefix(&function.path).map_or(call.probe.as_str(), str::trim);
        let name = if name.is_empty() { "the only one" } else { name };
        [name.to_string(), operations].into_iter().chain(Target::ALL.map(cell)).collect()
    };
    function.calls.iter().map(row).collect()
}

/// How many numbers of a function's calls have no bound, and of how many inputs.
pub(super) fn unbounded(function: &Function) -> usize {
    function.calls.iter().flat_map(|call| &call.figures).map(|record| record.unbounded).sum()
}

/// `1.44 of 2`, in ulps.
pub(crate) fn ratio(worst: f64, budget: f64) -> String {
    format!("{} of {}", short(worst), short(budget))
}

/// Three digits.
pub(crate) fn short(value: f64) -> String {
    let digits = match value.abs() {
        size if size < 10.0 => format!("{value:.2}"),
        size if size < 100.0 => format!("{value:.1}"),
        size if size < 1e5 => format!("{value:.0}"),
        _ => format!("{value:.1e}"),
    };
    match digits.split_once('.') {
        Some(_) if !digits.contains('e') => digits.trim_end_matches('0').trim_end_matches('.').to_string(),
        _ => digits,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_are_short() {
        assert_eq!(ratio(1.444, 2.0), "1.44 of 2");
        assert_eq!(ratio(0.0, 12.34), "0 of 12.3");
        assert_eq!(ratio(1234.5, 2.5e7), "1234 of 2.5e7");
    }
}
