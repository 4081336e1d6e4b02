//! Speed against error.

use plotters::style::text_anchor::HPos;

use super::super::ReportError;
use super::super::model::Report;
use super::Plot;
use super::axis::Decades;
use super::canvas::{HEIGHT, Key, LABEL, Mark, head, key_label, mark, sheet, text, width_of, write};
use super::decades::{FOOT, Frame, LEFT, RIGHT};
use super::sources::relative_key_error;
use super::theme::{self, INK};

/// Each run at its time a particle update, once with its error against the exact solution, once with its difference
/// to the reference. `None` if nothing ran.
pub(super) fn draw(report: &Report) -> Result<Option<Plot>, ReportError> {
    /// Place in the report, label, time, error against the exact solution, difference to the reference.
    type Run = (usize, String, f64, Option<f64>, Option<f64>);
    let runs: Vec<Run> = report
        .measured()
        .map(|(index, run, measured)| {
            let difference = measured.worst_difference().map(|worst| worst.compared());
            let time = measured.speed.nanoseconds_per_update;
            (index, run.label(), time, relative_key_error(report, measured), difference)
        })
        .collect();
    if runs.is_empty() {
        return Ok(None);
    }
    let title = "Speed against error";
    let caption = "Down is closer, left is faster. Diamonds: error against the exact solution, the same for every run as \
                   long as the arithmetic is good enough. Discs: difference to the scalar f64 reference, which itself has \
                   none.";
    let across = Decades::around(runs.iter().map(|run| run.2)).widened(0.05, 0.05);
    let up = Decades::around(runs.iter().flat_map(|run| [run.3, run.4].into_iter().flatten())).widened(0.12, 0.06);
    let keys = [
        Key { label: format!("{} / largest exact value", key_label(report)), colour: INK, mark: Mark::Diamond(11) },
        Key { label: "difference to reference / scale".into(), colour: theme::run(1), mark: Mark::Disc(9) },
    ];

    sheet("speed_and_error.svg", title, caption, HEIGHT, |area| {
        let top = head(area, title, &keys)?;
        let frame = Frame { top, bottom: HEIGHT as i32 - FOOT, across: &across, up: &up };
        frame.draw(area, "time [ns per particle update]")?;
        for (index, label, time, error, difference) in &runs {
            if let Some(error) = error {
                mark(area, Mark::Diamond(12), frame.at((*time, *error)), theme::run(*index))?;
            }
            if let Some(difference) = difference {
                mark(area, Mark::Disc(11), frame.at((*time, *difference)), theme::run(*index))?;
            }
            // The name stands under the lower mark, within the frame.
            let Some(lower) = difference.or(*error) else { continue };
            let half = width_of(label, LABEL) / 2;
            let (x, y) = frame.at((*time, lower));
            let under = (x.clamp(LEFT + half, RIGHT - half), y + 32);
            write(area, label, under, &text(LABEL, INK, HPos::Center))?;
        }
        Ok(())
    })
    .map(Some)
}
