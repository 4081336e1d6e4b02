//! Time for one particle update.

use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

use super::super::model::Report;
use super::super::{ReportError, number};
use super::Plot;
use super::axis::Decades;
use super::canvas::{LABEL, Mark, head, mark, sheet, text, write};
use super::rows::{LABELS, axis_below, rows_height};
use super::theme::{self, INK, QUIET};

/// Nanoseconds a particle update on a logarithmic axis. `None` if nothing ran.
pub(super) fn draw(report: &Report) -> Result<Option<Plot>, ReportError> {
    /// Place in the report, label, time, what is written at it.
    type Row = (usize, String, f64, String);
    let rows: Vec<Row> = report
        .measured()
        .map(|(index, run, measured)| {
            let time = measured.speed.nanoseconds_per_update;
            let threads = match measured.threads {
                1 => "1 thread".into(),
                threads => format!("{threads} threads"),
            };
            let faster = measured.speed.speed_up.filter(|_| !run.is_reference());
            let faster = faster.map_or_else(String::new, |ratio| format!(", {} as fast", number::times(ratio)));
            (index, run.label(), time, format!("{} ns on {threads}{faster}", number::typeset(time)))
        })
        .collect();
    if rows.is_empty() {
        return Ok(None);
    }
    let title = "Time for one particle update";
    let caption = "Wall-clock nanoseconds for one particle to advance by one step, all threads of the run at work. Every \
                   grid line is ten times the one before.";
    let decades = Decades::around(rows.iter().map(|(_, _, time, _)| *time)).widened(0.0, 0.03);

    sheet("time.svg", title, caption, rows_height(rows.len()), |area| {
        let top = head(area, title, &[])?;
        let place = axis_below(area, top, rows.len(), &decades, "time [ns per particle update]")?;
        for (number, (index, label, time, remark)) in rows.iter().enumerate() {
            let (x, y) = (place.column(*time), place.row(number));
            let colour = theme::run(*index);
            write(area, label, (LABELS - 20, y), &text(LABEL, INK, HPos::Right))?;
            area.draw(&PathElement::new([(LABELS, y), (x, y)], colour.light.stroke_width(6)))?;
            mark(area, Mark::Disc(11), (x, y), colour)?;
            write(area, remark, (LABELS + 12, y - 28), &text(LABEL, QUIET, HPos::Left))?;
        }
        Ok(())
    })
    .map(Some)
}
