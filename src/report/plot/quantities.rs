//! What a scene measures while it runs, over time, one plot a quantity.

use super::super::ReportError;
use super::super::model::Report;
use super::profile::capital;
use super::{Plot, Series, SeriesLine, SeriesTarget, series};

/// A plot for each quantity of which at least one run has more than one value.
pub(super) fn draw(report: &Report) -> Result<Vec<Plot>, ReportError> {
    let Some((_, _, first)) = report.measured().next() else { return Ok(Vec::new()) };
    let mut plots = Vec::new();
    for quantity in &first.series.quantities {
        let lines: Vec<SeriesLine> = report
            .measured()
            .filter_map(|(_, run, measured)| {
                let own = measured.series.quantities.iter().find(|own| own.name == quantity.name)?;
                let points = measured.series.time.iter().copied().zip(own.value.iter().copied()).collect();
                Some(SeriesLine { label: run.label(), points })
            })
            .filter(|line| line.points.len() > 1)
            .collect();
        if lines.is_empty() {
            continue;
        }
        let source = quantity.expected_source.as_deref().unwrap_or("expected");
        let caption = match quantity.expected {
            Some(value) => format!("Expected at the end: {} ({source}).", super::super::number::short(value)),
            None => String::from("Runs that follow the reference lie on it."),
        };
        plots.push(series(&Series {
            file: file(&quantity.name),
            title: format!("{} {} [{}]", capital(&quantity.label), quantity.symbol, quantity.unit),
            caption,
            time: "time".into(),
            logarithmic: false,
            lines,
            target: quantity.expected.map(|value| SeriesTarget::Value { label: "expected at the end".into(), value }),
        })?);
    }
    Ok(plots)
}

/// The name of a quantity's plot.
pub(in super::super) fn file(name: &str) -> String {
    format!("series_{name}.svg")
}
