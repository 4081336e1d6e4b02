//! One field along the scene's coordinate.

use plotters::prelude::*;

use super::super::model::{Field, ProfileField, Report};
use super::super::{ReportError, number};
use super::Plot;
use super::axis::{chart, padded};
use super::canvas::{HEIGHT, Key, Mark, head, mark, particle, sheet};
use super::theme::{self, INK};

/// Marks a plot has at most, however many particles the profiles hold: a larger file shows no more.
const MARKS: usize = 1600;

/// Particles of every run over the exact solution. `None` if no run has a profile of the field.
pub(super) fn draw(report: &Report, field: &Field) -> Result<Option<Plot>, ReportError> {
    let runs: Vec<(usize, String, &[f64], &ProfileField)> = report
        .measured()
        .filter_map(|(index, run, measured)| {
            let column = measured.profile.fields.iter().find(|column| column.field == field.name)?;
            Some((index, run.label(), measured.profile.x.as_slice(), column))
        })
        .collect();
    if runs.is_empty() {
        return Ok(None);
    }
    let norm = &report.scene.norm;
    let exact = report.exact.fields.iter().find(|curve| curve.field == field.name);
    let exact = exact.map(|curve| report.exact.x.iter().copied().zip(curve.value.iter().copied()));
    let line: Vec<(f64, f64)> = exact.into_iter().flatten().collect();

    let mut keys = Vec::new();
    if !line.is_empty() {
        keys.push(Key { label: "exact".into(), colour: INK, mark: Mark::Line });
    }
    keys.extend(runs.iter().map(|(index, label, ..)| Key {
        label: label.clone(),
        colour: theme::run(*index),
        mark: particle(*index),
    }));
    let title = format!("{} {} [{}]", capital(&field.label), field.symbol, field.unit);
    let shown: usize = runs.iter().map(|(_, _, x, _)| x.len()).max().unwrap_or(0);
    let caption = format!(
        "{} along {} at t = {}: {}marks are particles. The runs took turns with {} particles, so that their marks do not hide \
         each other.",
        capital(&field.label),
        norm.coordinate,
        number::short(report.scene.end_time),
        if line.is_empty() { "" } else { "the line is the exact solution, " },
        number::count(shown.min(MARKS) as u64)
    );
    let x_range = padded(runs.iter().flat_map(|(_, _, x, _)| x.iter().copied()));
    let values = runs.iter().flat_map(|(.., column)| column.value.iter().copied());
    let y_range = padded(values.chain(line.iter().map(|&(_, y)| y)));
    let x_label = format!("{} [{}]", norm.coordinate, norm.unit);

    sheet(format!("profile_{}.svg", field.name), title.clone(), caption, HEIGHT, |area| {
        let top = head(area, &title, &keys)?;
        let chart = chart(area, top, &x_label, x_range.clone(), y_range)?;
        let every = runs.len().max(shown.div_ceil(MARKS));
        for (turn, (index, _, x, column)) in runs.iter().enumerate() {
            let points = x.iter().copied().zip(column.value.iter().copied());
            for point in points.skip(turn).step_by(every) {
                mark(area, particle(*index), chart.backend_coord(&point), theme::run(*index))?;
            }
        }
        // Over the particles, so that it is never hidden. Cut to the range of the particles.
        let inside = line.iter().filter(|(x, _)| x_range.contains(x));
        let pixels: Vec<(i32, i32)> = inside.map(|point| chart.backend_coord(point)).collect();
        if pixels.is_empty() {
            return Ok(());
        }
        area.draw(&PathElement::new(pixels, INK.light.stroke_width(3)))
    })
    .map(Some)
}

/// The text with a capital at its beginning.
pub(in super::super) fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
