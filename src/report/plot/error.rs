//! Both errors of the key field along the scene's coordinate, on one logarithmic axis.

use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

use super::super::model::Report;
use super::super::verdict::key_field;
use super::super::{ReportError, number};
use super::Plot;
use super::axis::{Decades, chart, padded};
use super::canvas::{HEIGHT, Key, LABEL, Mark, head, mark, sheet, text, write};
use super::profile::capital;
use super::theme::{self, AXIS, INK, Pair, QUIET};

/// Marks a series has at most: a larger file shows no more.
const MARKS: usize = 800;

/// Errors of one kind of one run.
struct Series {
    label: String,
    colour: Pair,
    mark: Mark,
    points: Vec<(f64, f64)>,
    /// How many errors were exactly zero, which has no place on the axis.
    zeros: usize,
}

/// Distance from the exact solution (one run stands for all: on this scale they coincide) above the distance of every
/// run from the reference. `None` without a profile.
pub(super) fn draw(report: &Report) -> Result<Option<Plot>, ReportError> {
    let Some(field) = key_field(report) else { return Ok(None) };
    let mut series = Vec::new();
    for (index, run, measured) in report.measured() {
        let Some(column) = measured.profile.fields.iter().find(|column| column.field == field.name) else { continue };
        let of = |label, colour, other: &[f64]| {
            let errors = column.value.iter().zip(other).map(|(value, other)| (value - other).abs());
            let points: Vec<(f64, f64)> = measured.profile.x.iter().copied().zip(errors).collect();
            let all = points.len();
            let points: Vec<(f64, f64)> = points.into_iter().filter(|(_, error)| *error > 0.0).collect();
            Series { label, colour, mark: Mark::Translucent(4), zeros: all - points.len(), points }
        };
        if series.is_empty() && !column.exact.is_empty() {
            let label = format!("{} − exact", run.label());
            series.push(of(label, INK, &column.exact));
        }
        if !column.reference.is_empty() {
            let label = format!("{} − reference", run.label());
            series.push(of(label, theme::run(index), &column.reference));
        }
    }
    if series.is_empty() {
        return Ok(None);
    }
    let zeros: Vec<String> = series
        .iter()
        .filter(|series| series.zeros > 0)
        .map(|series| format!("{} of {}", number::count(series.zeros as u64), series.label))
        .collect();
    let zeros =
        if zeros.is_empty() { String::new() } else { format!(" Exactly zero, hence not shown: {}.", zeros.join(", ")) };
    let norm = &report.scene.norm;
    let title = format!("{}: absolute error |Δ{}| [{}]", capital(&field.label), field.symbol, field.unit);
    let caption = format!(
        "Error of single particles along {}. {}distance from the scalar f64 reference, which is the arithmetic’s. Norms are taken \
         between the broken lines, {} to {}.{zeros}",
        norm.coordinate,
        match report.exact.x.is_empty() {
            true => "Clouds: ",
            false => "Upper cloud: distance from the exact solution, which is the method’s. Lower clouds: ",
        },
        number::short(norm.from),
        number::short(norm.to)
    );
    let keys: Vec<Key> = series
        .iter()
        .map(|series| Key { label: series.label.clone(), colour: series.colour, mark: Mark::Disc(7) })
        .collect();
    let x_range = padded(series.iter().flat_map(|series| series.points.iter().map(|&(x, _)| x)));
    let decades = Decades::around(series.iter().flat_map(|series| series.points.iter().map(|&(_, error)| error)));
    let decades = decades.widened(0.1, 0.0);
    let low = decades.low();
    let x_label = format!("{} [{}]", norm.coordinate, norm.unit);

    sheet("error.svg", title.clone(), caption, HEIGHT, |area| {
        let top = head(area, &title, &keys)?;
        let chart = chart(area, top, &x_label, x_range.clone(), decades)?;
        for series in &series {
            for point in series.points.iter().step_by(series.points.len().div_ceil(MARKS).max(1)) {
                mark(area, series.mark, chart.backend_coord(point), series.colour)?;
            }
        }
        for (x, horizontal) in [(norm.from, HPos::Left), (norm.to, HPos::Right)] {
            if !x_range.contains(&x) {
                continue;
            }
            let (column, bottom) = chart.backend_coord(&(x, low));
            for y in (top..bottom).step_by(16) {
                let dash = [(column, y), (column, (y + 8).min(bottom))];
                area.draw(&PathElement::new(dash, AXIS.light.stroke_width(2)))?;
            }
            if matches!(horizontal, HPos::Left) {
                write(area, "norm range →", (column + 10, bottom - 20), &text(LABEL - 3, QUIET, horizontal))?;
            } else {
                write(area, "←", (column - 8, bottom - 20), &text(LABEL - 3, QUIET, horizontal))?;
            }
        }
        Ok(())
    })
    .map(Some)
}
