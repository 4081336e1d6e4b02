//! What the scene measures while it runs.

use super::super::model::Report;
use super::super::plot::{Plot, capital, series_file};
use super::parts::{Head, escape, figure, figures, group, maybe, number, run_heading, section, table};

/// The plots, and each quantity at the start and at the end.
pub(super) fn measured(report: &Report, plots: &[Plot]) -> String {
    let Some((_, _, first)) = report.measured().next() else { return String::new() };
    if first.series.quantities.is_empty() {
        return String::new();
    }
    let drawn: Vec<String> =
        first.series.quantities.iter().map(|quantity| figure(plots, &series_file(&quantity.name))).collect();
    let heads = [
        Head("Quantity", "unit", false),
        Head("Run", "", false),
        Head("Start", "", true),
        Head("End", "", true),
        Head("Expected", "at the end", true),
        Head("From", "", false),
    ];
    let mut rows = String::new();
    for quantity in &first.series.quantities {
        let cells: Vec<String> = report
            .measured()
            .filter_map(|(index, run, measured)| {
                let own = measured.series.quantities.iter().find(|own| own.name == quantity.name)?;
                let (first, last) = (own.value.first()?, own.value.last()?);
                let source = quantity.expected_source.as_deref().unwrap_or("");
                Some(format!(
                    "{}{}{}{}<td>{}</td>",
                    run_heading(index, run),
                    number(*first),
                    number(*last),
                    maybe(quantity.expected),
                    escape(source)
                ))
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
    let lead = "Measured at the start, in between, and at the end; no step is cut short for it.";
    section("What happens on the way?", lead, &(figures(&drawn) + &table(&heads, &rows)))
}
