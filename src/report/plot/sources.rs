//! The three sources of error side by side, one row a run.

use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

use super::super::ReportError;
use super::super::model::Report;
use super::super::verdict::{key_error, key_field};
use super::Plot;
use super::axis::Decades;
use super::canvas::{Key, LABEL, Mark, WIDTH, head, key_label, mark, sheet, text, write};
use super::rows::{LABELS, axis_below, rows_height};
use super::theme::{self, GRID, INK, QUIET};

/// What is drawn for one run; every figure is relative to the scale of its quantity.
struct Row {
    label: String,
    index: usize,
    discretisation: Option<f64>,
    arithmetic: Option<(f64, f64)>,
    kernel: Option<f64>,
}

/// Discretisation, arithmetic with its tolerance, and kernel approximation of each run. `None` if nothing ran.
pub(super) fn draw(report: &Report) -> Result<Option<Plot>, ReportError> {
    let rows: Vec<Row> = report
        .measured()
        .map(|(index, run, measured)| Row {
            label: run.label(),
            index,
            discretisation: relative_key_error(report, measured),
            arithmetic: measured.worst_difference().map(|worst| (worst.compared(), worst.tolerance.value)),
            kernel: report
                .kernel_approximation
                .iter()
                .filter(|approximation| approximation.precision == run.precision)
                .map(|approximation| approximation.max)
                .max_by(f64::total_cmp),
        })
        .collect();
    if rows.is_empty() {
        return Ok(None);
    }
    let title = "Three sources of error, each relative to its quantity’s scale";
    let field = key_field(report).map_or("field", |field| &field.label);
    let caption = format!(
        "Discretisation is {} divided by the largest exact {field}; arithmetic is the worst field’s difference to the \
         reference with its tolerance; kernel approximation is the largest error of the functions inside the kernels. \
         The arithmetic leaves the answer alone as long as the diamond lies far to the right of everything else.",
        key_label(report)
    );
    let values = rows.iter().flat_map(|row| {
        let (arithmetic, tolerance) = row.arithmetic.unzip();
        [row.discretisation, arithmetic, tolerance, row.kernel].into_iter().flatten()
    });
    let decades = Decades::around(values).widened(0.03, 0.03);
    let keys = [
        Key { label: "discretisation".into(), colour: INK, mark: Mark::Diamond(11) },
        Key { label: "arithmetic".into(), colour: theme::run(1), mark: Mark::Disc(9) },
        Key { label: "its tolerance".into(), colour: QUIET, mark: Mark::Bar(13) },
        Key { label: "kernel approximation".into(), colour: QUIET, mark: Mark::Ring(8) },
    ];
    sheet("error_sources.svg", title, caption, rows_height(rows.len()), |area| {
        let top = head(area, title, &keys)?;
        let place = axis_below(area, top, rows.len(), &decades, "relative error")?;
        for (number, row) in rows.iter().enumerate() {
            let y = place.row(number);
            write(area, &row.label, (LABELS - 20, y), &text(LABEL, INK, HPos::Right))?;
            let ends = [(LABELS, y), (WIDTH as i32 - 30, y)];
            area.draw(&PathElement::new(ends, GRID.light.stroke_width(2)))?;
            if let Some((found, tolerance)) = row.arithmetic {
                mark(area, Mark::Bar(16), (place.column(tolerance), y), QUIET)?;
                mark(area, Mark::Disc(10), (place.column(found), y), theme::run(row.index))?;
            }
            if let Some(found) = row.kernel {
                mark(area, Mark::Ring(9), (place.column(found), y), QUIET)?;
            }
            if let Some(found) = row.discretisation {
                mark(area, Mark::Diamond(12), (place.column(found), y), INK)?;
            }
        }
        Ok(())
    })
    .map(Some)
}

/// The key field's L1 divided by the field's largest exact value.
pub(super) fn relative_key_error(report: &Report, measured: &super::super::model::Measurements) -> Option<f64> {
    let error = key_error(report, measured)?;
    let curve = report.exact.fields.iter().find(|curve| curve.field == error.field)?;
    let scale = curve.value.iter().fold(0.0_f64, |scale, value| scale.max(value.abs()));
    (scale > 0.0).then(|| error.l1 / scale)
}
