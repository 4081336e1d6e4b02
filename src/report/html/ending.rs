//! What the scene measures at the end alone.

use super::super::model::Report;
use super::super::plot::{Plot, capital, curve_file};
use super::parts::{Head, escape, figure, figures, group, maybe, number, run_heading, section, table};

/// The curves, and each quantity of each run or why it has none.
pub(super) fn measured(report: &Report, plots: &[Plot]) -> String {
    let Some((_, _, first)) = report.measured().next() else { return String::new() };
    let mut drawn: Vec<String> = Vec::new();
    for curve in report.measured().flat_map(|(_, _, measured)| &measured.ending.curves) {
        let picture = figure(plots, &curve_file(&curve.name));
        if !drawn.contains(&picture) {
            drawn.push(picture);
        }
    }
    if first.ending.quantities.is_empty() && drawn.is_empty() {
        return String::new();
    }
    let heads = [
        Head("Quantity", "unit", false),
        Head("Run", "", false),
        Head("Value", "", true),
        Head("Expected", "", true),
        Head("From", "", false),
    ];
    let mut rows = String::new();
    for quantity in &first.ending.quantities {
        let cells: Vec<String> = report
            .measured()
            .filter_map(|(index, run, measured)| {
                let own = measured.ending.quantities.iter().find(|own| own.name == quantity.name)?;
                let source = quantity.expected_source.as_deref().unwrap_or("");
                Some(match (own.value, &own.missing) {
                    (Some(value), _) => format!(
                        "{}{}{}<td>{}</td>",
                        run_heading(index, run),
                        number(value),
                        maybe(quantity.expected),
                        escape(source)
                    ),
                    (None, why) => format!(
                        "{}<td colspan=\"3\">None: {}</td>",
                        run_heading(index, run),
                        escape(why.as_deref().unwrap_or("not measured"))
                    ),
                })
            })
            .collect();
        let heading = format!(
            "<th scope=\"rowgroup\" rowspan=\"{}\">{} {}<span class=\"unit\">{}</span></th>",
            cells.len(),
            escape(&capital(&quantity.label)),
            escape(&quantity.symbol),
            escape(&quantity.unit)
        );
        rows += &group(&heading, &cells);
    }
    let listed = if rows.is_empty() { String::new() } else { table(&heads, &rows) };
    section("What is there at the end?", "Measured once, on the last state.", &(figures(&drawn) + &listed))
}

#[cfg(test)]
mod tests {
    use super::super::super::model::Outcome;
    use super::super::super::{from_json, plots, synthetic, to_json};
    use super::*;

    #[test]
    fn numbers_curves_and_reasons_are_on_the_page() {
        let mut report = synthetic::with_ending();
        assert_eq!(from_json(&to_json(&report, &[]).unwrap()).unwrap(), report);
        let html = |report: &Report| measured(report, &plots(report).unwrap());
        let page = html(&report);
        for text in ["The slope", "−1.50", "Kolmogorov", "None: too few particles"] {
            assert!(page.contains(text), "{text}: {page}");
        }
        assert_eq!(page.matches("<figure").count(), 1, "one plot for all runs");
        let Outcome::Ran(first) = &mut report.runs[0].outcome else { panic!("it ran") };
        first.ending.quantities[1].missing = Some("<b>".into());
        assert!(!html(&report).contains("<b>"));
        assert_eq!(html(&synthetic::report()), "");
    }
}
