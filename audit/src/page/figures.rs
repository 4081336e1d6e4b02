//! Figures on record as tables: a row for each way to call a function, a column for each target.

use super::{Call, Function};
use crate::gains::Gain;
use crate::ranges::Range;
use crate::target::Target;
use std::collections::BTreeSet;

/// A table of plain words, and the sentences below it.
pub(super) struct Table {
    /// The first row.
    pub head: Vec<String>,
    /// The others.
    pub rows: Vec<Vec<String>>,
    /// What else is to be said.
    pub notes: Vec<String>,
}

impl Table {
    fn new(head: &[&str], rows: Vec<Vec<String>>) -> Self {
        Table { head: head.iter().map(ToString::to_string).collect(), rows, notes: Vec::new() }
    }
}

/// Above a table of errors.
pub(super) const ERRORS: &str = "The worst error measured, of the budget: how far a result can be off if every rounding conspires. Both are in ulps \
                                 of the natural scale, the size of what a result is made of.";
/// Above a table of ranges.
pub(super) const RANGES: &str =
    "What it can give at all, for any real arguments of the domain, with true constants and functions.";
/// Above a table of gains.
pub(super) const GAINS: &str = "Measured on the same arguments against the same oracle: the largest error in ulps of the natural scale of ours, and for how many \
                                arguments there was no finite result.";

/// Errors: for each call its operations in `f32` and `f64`, and on each target the worst error and the budget in ulps.
pub(super) fn errors(function: &Function) -> Table {
    let records = || function.calls.iter().flat_map(|call| &call.figures);
    let adapters: BTreeSet<&str> = records().filter_map(|record| record.adapter.as_deref()).collect();
    let number = |place: usize| if adapters.len() > 1 { format!(" ({})", place + 1) } else { String::new() };
    let columns: Vec<(String, Target, Option<&str>)> = Target::HERE
        .iter()
        .map(|target| (target.name().to_string(), *target, None))
        .chain(adapters.iter().enumerate().map(|(place, adapter)| {
            (format!("{}{}", Target::WgslSingle, number(place)), Target::WgslSingle, Some(*adapter))
        }))
        .collect();
    let row = |call: &Call| {
        let operations = match (call.operations.f32, call.operations.f64) {
            (single, double) if single == double => single.to_string(),
            (single, double) => format!("{single}, {double} in f64"),
        };
        let cell = |(_, target, adapter): &(String, Target, Option<&str>)| {
            let is_it =
                |record: &&crate::Record| record.target == target.name() && record.adapter.as_deref() == *adapter;
            let record = call.figures.iter().find(is_it);
            record.map_or_else(|| "-".to_string(), |record| ratio(record.worst, record.budget))
        };
        [name(function, call), operations].into_iter().chain(columns.iter().map(cell)).collect()
    };
    let mut table = Table::new(&["call", "operations"], function.calls.iter().map(row).collect());
    table.head.extend(columns.iter().map(|(name, ..)| name.clone()));
    let inputs = records().map(|record| record.inputs).min().unwrap_or(0);
    table.notes.push(format!(
        "Errors are measured, on at least {inputs} arguments a call. Budgets are proven, to first order in the roundoff{}.",
        if adapters.is_empty() { "" } else { "; that of WGSL is believed, for it rests on what WGSL promises of single operations" }
    ));
    table.notes.extend(adapters.iter().enumerate().map(|(place, adapter)| match adapters.len() {
        1 => format!("WGSL was run on {adapter}."),
        _ => format!("({}): WGSL was run on {adapter}.", place + 1),
    }));
    if adapters.is_empty() && !function.calls.is_empty() {
        table.notes.push("WGSL was not run since the equation last changed.".to_string());
    }
    for call in &function.calls {
        for record in call.figures.iter().filter(|record| record.unbounded > 0) {
            let (target, count, inputs) = (&record.target, record.unbounded, record.inputs);
            let what = if call.probe == function.path { String::new() } else { format!("{}, ", name(function, call)) };
            table.notes.push(format!(
                "{what}{target}: {count} numbers among the results for {inputs} arguments have no budget, because a divisor may be nothing."
            ));
        }
    }
    table
}

/// Proven ranges beside those that a sample of a thousand has.
pub(super) fn ranges(function: &Function) -> Table {
    let row = |call: &Call, range: &Range| {
        let bound = |bound: Option<f64>, is_low| {
            bound.map_or_else(|| "none".to_string(), |bound| bound_in_short(bound, is_low))
        };
        let label = range.label.map_or_else(|| "-".to_string(), |label| label.to_string());
        let seen = format!("{} .. {}", seen_in_short(range.seen[0]), seen_in_short(range.seen[1]));
        vec![
            name(function, call),
            format!("`{}`", range.output),
            bound(range.low, true),
            bound(range.high, false),
            label,
            seen,
        ]
    };
    let rows = function.calls.iter().flat_map(|call| call.ranges.iter().map(move |range| row(call, range)));
    let mut table = Table::new(&["call", "result", "not below", "not above", "known", "a sample gave"], rows.collect());
    let gaps: BTreeSet<&String> =
        function.calls.iter().flat_map(|call| &call.ranges).filter_map(|range| range.gap.as_ref()).collect();
    table.notes = gaps.into_iter().map(|gap| format!("Why bounds are missing: {gap}.")).collect();
    table
}

/// Ours beside a textbook's form.
pub(super) fn gain(gain: &Gain) -> Table {
    let row = |name: &str, operations: u32, of: [(f64, usize, usize); 2]| {
        let mut cells = vec![name.to_string(), operations.to_string()];
        for (error, not_finite, inputs) in of {
            cells.push(short(error));
            cells.push(format!("{not_finite} of {inputs}"));
        }
        cells
    };
    let both = [&gain.f32, &gain.f64];
    let textbook = both.map(|of| (of.textbook, of.textbook_not_finite, of.inputs));
    let ours = both.map(|of| (of.ours, of.ours_not_finite, of.inputs));
    let rows = vec![row("textbook", gain.textbook_operations, textbook), row("ours", gain.operations, ours)];
    let mut table =
        Table::new(&["form", "operations", "worst in f32", "not finite", "worst in f64", "not finite"], rows);
    table.notes.extend(
        gain.stretched.as_ref().map(|words| format!("Arguments are those of the domain, multiplied: {words}.")),
    );
    table.notes.extend(gain.restricted.as_ref().map(|words| format!("Compared are {words}.")));
    table
}

/// What tells a call from others of the same function.
fn name(function: &Function, call: &Call) -> String {
    let name = call.probe.strip_prefix(&function.path).map_or(call.probe.as_str(), str::trim);
    if name.is_empty() { "the only one".to_string() } else { name.to_string() }
}

/// A bound in four digits, rounded outward so that it stays one: down if it is the lower one. What only the outward rounding of intervals keeps from
/// being a short number is named after that number.
fn bound_in_short(bound: f64, is_low: bool) -> String {
    let sign = if is_low { 1.0 } else { -1.0 };
    let value = sign * bound;
    let rounded = |value: f64| format!("{value:.3e}").parse().unwrap_or(value); // a printed number always reads back
    let near: f64 = if value.abs() < f64::MIN_POSITIVE { 0.0 } else { rounded(value) };
    let word = if is_low { "just below " } else { "just above " };
    if near <= value {
        plainly(sign * near)
    } else if near - value <= 1e-12 * value.abs() || near == 0.0 {
        format!("{word}{}", plainly(sign * near))
    } else {
        let last_digit = 10_f64.powi(value.abs().log10().floor() as i32 - 3);
        plainly(sign * rounded(near - last_digit))
    }
}

/// Few digits in the shorter notation.
fn plainly(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 {
        return "0".to_string();
    }
    if (1e-3..1e5).contains(&size) { format!("{value}") } else { format!("{value:e}") }
}

fn seen_in_short(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 || (1e-3..1e5).contains(&size) { short(value) } else { format!("{value:.2e}") }
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
    fn bounds_stay_bounds_when_they_are_shortened() {
        let low = [1.23456, -1.23446, 0.5_f64.next_down(), -5e-324, 0.0, 1.0, -2_002_000_000.000_000_2];
        let texts = ["1.234", "-1.235", "just below 0.5", "just below 0", "0", "1", "just below -2.002e9"];
        assert_eq!(low.map(|bound| bound_in_short(bound, true)), texts);
        let high = [1.23446, -1.23456, 1.0_f64.next_up(), 5e-324, 1.23e-7];
        let texts = ["1.235", "-1.234", "just above 1", "just above 0", "1.23e-7"];
        assert_eq!(high.map(|bound| bound_in_short(bound, false)), texts);
        for k in 0..1000 {
            let value = 1.01_f64.powi(k) - 3.0;
            if let Ok(bound) = bound_in_short(value, true).parse::<f64>() {
                assert!(bound <= value && value - bound <= 2.1e-3 * value.abs(), "{value} and {bound}");
            }
        }
    }

    #[test]
    fn figures_are_short() {
        assert_eq!(ratio(1.444, 2.0), "1.44 of 2");
        assert_eq!(ratio(0.0, 12.34), "0 of 12.3");
        assert_eq!(ratio(1234.5, 2.5e7), "1234 of 2.5e7");
        assert_eq!([seen_in_short(0.0), seen_in_short(-1.23456e-7), seen_in_short(12.345)], ["0", "-1.23e-7", "12.3"]);
    }
}
