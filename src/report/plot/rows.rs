//! Charts with a row a run and a logarithmic axis below.

use plotters::coord::ranged1d::Ranged;
use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

use super::super::number;
use super::axis::Decades;
use super::canvas::{Area, Drawn, HEIGHT, LABEL, WIDTH, text, write};
use super::theme::{AXIS, GRID, INK, QUIET};

/// Where row labels end and the axis begins.
pub(super) const LABELS: i32 = 236;
/// Where the axis ends.
const RIGHT: i32 = WIDTH as i32 - 30;
/// Height of a row at the least.
const ROW: i32 = 78;
/// Height of title and legend, and of the axis with its label.
const HEAD: i32 = 140;
const FOOT: i32 = 92;

/// Height of a row: few of them share the room of a usual sheet.
fn row_height(rows: usize) -> i32 {
    ((HEIGHT as i32 - HEAD - FOOT) / rows.max(1) as i32).clamp(ROW, 2 * ROW)
}

/// Height of a sheet with that many rows.
pub(super) fn rows_height(rows: usize) -> u32 {
    (HEAD + FOOT + row_height(rows) * rows as i32) as u32
}

/// Where things go.
pub(super) struct Place<'a> {
    top: i32,
    row: i32,
    decades: &'a Decades,
}

impl Place<'_> {
    /// The middle of a row.
    pub(super) fn row(&self, number: usize) -> i32 {
        self.top + self.row * number as i32 + self.row / 2
    }

    /// The column of a value.
    pub(super) fn column(&self, value: f64) -> i32 {
        self.decades.map(&value, (LABELS, RIGHT))
    }
}

/// Draws grid, axis and its label below `rows` rows that begin at `top`.
pub(super) fn axis_below<'a>(
    area: &Area,
    top: i32,
    rows: usize,
    decades: &'a Decades,
    label: &str,
) -> Drawn<Place<'a>> {
    // What the legend leaves is shared out among the rows.
    let place = Place { top, row: (rows_height(rows) as i32 - FOOT - top) / rows.max(1) as i32, decades };
    let bottom = top + place.row * rows as i32;
    for value in decades.key_points(12) {
        let x = place.column(value);
        area.draw(&PathElement::new([(x, top), (x, bottom)], GRID.light.stroke_width(2)))?;
        let tick = number::power_of_ten(value.log10().round() as i32);
        write(area, &tick, (x, bottom + 24), &text(LABEL, QUIET, HPos::Center))?;
    }
    area.draw(&PathElement::new([(LABELS, bottom), (RIGHT, bottom)], AXIS.light))?;
    write(area, label, ((LABELS + RIGHT) / 2, bottom + 64), &text(LABEL, INK, HPos::Center))?;
    Ok(place)
}
