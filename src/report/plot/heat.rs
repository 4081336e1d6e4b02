//! A heat map: rows by columns, a number in each cell, colours from the best of a column to what is twice as bad.
//! Several matrices stand side by side where their numbers fit, one under the other where they do not.

use etalon_spec::tables::Goal;
use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

use super::super::{ReportError, number};
use super::Plot;
use super::canvas::{Area, Drawn, LABEL, LEFT, WIDTH, head, sheet, text, width_of, write};
use super::difference::relative_differences;
use super::palette::{text_on, viridis};
use super::refuse::{finite, unless};
use super::theme::{AXIS, GRID, INK, Pair, QUIET};

/// A column of a heat map.
#[derive(Clone, Debug, PartialEq)]
pub struct HeatColumn {
    /// Its name, short: it stands over cells as wide as their numbers.
    pub name: String,
    /// Which of two values is the better one.
    pub goal: Goal,
}

/// One of the matrices of a heat map.
#[derive(Clone, Debug, PartialEq)]
pub struct HeatMatrix {
    /// What it shows, for example `published`.
    pub title: String,
    /// A value or nothing for each column of each row.
    pub values: Vec<Vec<Option<f64>>>,
}

/// What is printed in the cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CellText {
    /// The values.
    Values,
    /// The relative differences to the best of the column, in per cent, as in GS25, Fig. 10.
    Differences,
}

/// What a heat map is drawn from.
#[derive(Clone, Debug, PartialEq)]
pub struct HeatMap {
    /// File name, with `.svg`.
    pub file: String,
    /// What the plot shows, in a few words.
    pub title: String,
    /// What is to be seen in it.
    pub caption: String,
    /// The names of the rows.
    pub rows: Vec<String>,
    /// The columns.
    pub columns: Vec<HeatColumn>,
    /// The matrices; each is coloured by the best of its own columns.
    pub matrices: Vec<HeatMatrix>,
    /// What is printed in the cells.
    pub cells: CellText,
}

/// Size of the text in cells, its room at either side, the height of a row.
const CELL: i32 = 22;
const ROOM: i32 = 6;
const ROW: i32 = 52;
/// Space between matrices, and right of the last.
const GAP: i32 = 36;
const RIGHT: i32 = 20;
/// Height of a matrix's title, and of the scale of colours below all.
const TITLE: i32 = 44;
const SCALE: i32 = 108;

/// A cell: its relative difference and its text.
type Cell = Option<(f64, String)>;

/// Where things go.
struct Layout {
    /// Width of the row names and of a cell; height of the column names.
    names: i32,
    cell: i32,
    header: i32,
    /// Whether the matrices stand side by side.
    beside: bool,
}

/// Draws a heat map. Cells without a value are hatched.
///
/// # Errors
/// [`ReportError::NotFinite`] for a value that is no number, [`ReportError::Inconsistent`] for a matrix of another size than rows and
/// columns or for none at all, [`ReportError::Plot`] if the drawing library refuses.
pub fn heat_map(map: &HeatMap) -> Result<Plot, ReportError> {
    check(map)?;
    let matrices: Vec<Vec<Vec<Cell>>> = map.matrices.iter().map(|matrix| cells(map, matrix)).collect();
    let layout = lay_out(map, &matrices);
    let block = TITLE + layout.header + ROW * map.rows.len() as i32 + GAP;
    let blocks = if layout.beside { 1 } else { matrices.len() as i32 };
    let title = &map.title;
    sheet(&map.file, title, &map.caption, (56 + block * blocks + SCALE) as u32, |area| {
        let top = head(area, title, &[])?;
        for (place, (matrix, cells)) in map.matrices.iter().zip(&matrices).enumerate() {
            let place = place as i32;
            let width = layout.cell * map.columns.len() as i32 + GAP;
            let corner =
                if layout.beside { (layout.names + width * place, top) } else { (layout.names, top + block * place) };
            write(area, &matrix.title, (corner.0, corner.1 + 20), &text(LABEL, INK, HPos::Left))?;
            let first = !layout.beside || place == 0;
            draw_matrix(area, map, &layout, cells, (corner.0, corner.1 + TITLE), first)?;
        }
        draw_scale(area, top + block * blocks)
    })
}

/// The sizes agree and every value is a number.
fn check(map: &HeatMap) -> Result<(), ReportError> {
    let full = !map.rows.is_empty() && !map.columns.is_empty() && !map.matrices.is_empty();
    unless(full, || map.file.clone(), "a heat map needs at least one row, one column and one matrix")?;
    for matrix in &map.matrices {
        let path = || format!("{}: matrix {}", map.file, matrix.title);
        let square =
            matrix.values.len() == map.rows.len() && matrix.values.iter().all(|row| row.len() == map.columns.len());
        unless(square, path, "it must have one value or none for each column of each row")?;
        for (name, row) in map.rows.iter().zip(&matrix.values) {
            for (column, value) in map.columns.iter().zip(row) {
                finite(value.unwrap_or(0.0), || format!("{}[{name}][{}]", path(), column.name))?;
            }
        }
    }
    Ok(())
}

/// The cells of a matrix, row by row.
fn cells(map: &HeatMap, matrix: &HeatMatrix) -> Vec<Vec<Cell>> {
    let mut rows = vec![Vec::with_capacity(map.columns.len()); map.rows.len()];
    for (place, column) in map.columns.iter().enumerate() {
        let values: Vec<Option<f64>> = matrix.values.iter().map(|row| row[place]).collect();
        let differences = relative_differences(&values, column.goal);
        for ((row, value), difference) in rows.iter_mut().zip(values).zip(differences) {
            row.push(value.zip(difference).map(|(value, difference)| {
                let text = match map.cells {
                    CellText::Values => number::short(value),
                    CellText::Differences => percent(difference),
                };
                (difference, text)
            }));
        }
    }
    rows
}

/// A difference in per cent, without the sign: whole from ten on, one digit behind the point below.
fn percent(difference: f64) -> String {
    match 100.0 * difference {
        0.0 => "0".into(),
        percent if percent.is_infinite() => "∞".into(),
        percent if percent < 0.05 => "<0.1".into(),
        percent if percent < 9.95 => format!("{percent:.1}"),
        percent if percent < 9999.5 => format!("{percent:.0}"),
        percent => number::typeset(percent),
    }
}

fn lay_out(map: &HeatMap, matrices: &[Vec<Vec<Cell>>]) -> Layout {
    let widest =
        |names: &mut dyn Iterator<Item = &String>, size| names.map(|name| width_of(name, size)).max().unwrap_or(0);
    let names = LEFT + widest(&mut map.rows.iter(), LABEL) + 16;
    let texts = matrices.iter().flatten().flatten().flatten().map(|(_, text)| text);
    let needed = widest(&mut texts.into_iter(), CELL).max(36) + 2 * ROOM;
    let columns = map.columns.len() as i32;
    let blocks = matrices.len() as i32;
    // What is left for the cells of all matrices side by side.
    let shared = (WIDTH as i32 - names - RIGHT - GAP * (blocks - 1)) / blocks;
    let beside = shared >= needed * columns;
    let room = if beside { shared } else { WIDTH as i32 - names - RIGHT };
    let cell = (room / columns).clamp(ROOM, 150);
    let column_names = widest(&mut map.columns.iter().map(|column| &column.name), CELL);
    // Names too wide for their cells stand upright.
    let header = if column_names + ROOM <= cell { 36 } else { column_names + 16 };
    Layout { names, cell, header, beside }
}

/// One matrix with its upper left corner, names of columns included, at `corner`.
fn draw_matrix(
    area: &Area,
    map: &HeatMap,
    layout: &Layout,
    cells: &[Vec<Cell>],
    corner: (i32, i32),
    row_names: bool,
) -> Drawn {
    let top = corner.1 + layout.header;
    for (place, column) in map.columns.iter().enumerate() {
        let middle = corner.0 + layout.cell * place as i32 + layout.cell / 2;
        if layout.header == 36 {
            write(area, &column.name, (middle, top - 18), &text(CELL, QUIET, HPos::Center))?;
        } else {
            let upright = text(CELL, QUIET, HPos::Left).transform(FontTransform::Rotate270);
            write(area, &column.name, (middle, top - 10), &upright)?;
        }
    }
    for (place, (name, row)) in map.rows.iter().zip(cells).enumerate() {
        let y = top + ROW * place as i32;
        if row_names {
            write(area, name, (corner.0 - 12, y + ROW / 2), &text(LABEL, INK, HPos::Right))?;
        }
        for (place, cell) in row.iter().enumerate() {
            let x = corner.0 + layout.cell * place as i32;
            // A gap of two pixels between cells.
            let corners = [(x, y), (x + layout.cell - 2, y + ROW - 2)];
            let Some((difference, printed)) = cell else {
                hatched(area, corners)?;
                continue;
            };
            let colour = viridis(1.0 - difference);
            area.draw(&Rectangle::new(corners, colour.filled()))?;
            let ink = text_on(colour);
            let style = text(CELL, Pair { light: ink, dark: ink }, HPos::Center);
            write(area, printed, (x + layout.cell / 2 - 1, y + ROW / 2 - 1), &style)?;
        }
    }
    Ok(())
}

/// A cell without a value.
fn hatched(area: &Area, [(left, top), (right, bottom)]: [(i32, i32); 2]) -> Drawn {
    let height = bottom - top;
    // Lines that rise by 45 degrees, cut at the sides of the cell.
    for start in (left - height..right).step_by(12) {
        let from = (start.max(left), bottom - (start.max(left) - start));
        let to = ((start + height).min(right), bottom - ((start + height).min(right) - start));
        area.draw(&PathElement::new([from, to], AXIS.light.stroke_width(1)))?;
    }
    area.draw(&Rectangle::new([(left, top), (right, bottom)], GRID.light.stroke_width(2)))
}

/// The scale of colours with its ends, and what hatching means.
fn draw_scale(area: &Area, top: i32) -> Drawn {
    let (left, right) = (LEFT, 500);
    let steps = 64;
    for step in 0..steps {
        let column = |step: i32| left + (right - left) * step / steps;
        let colour = viridis(1.0 - (f64::from(step) + 0.5) / f64::from(steps));
        // Each goes on to the end, under the next: no seam shows.
        area.draw(&Rectangle::new([(column(step), top), (right, top + 24)], colour.filled()))?;
    }
    for (part, label, anchor) in [(0, "best", HPos::Left), (1, "50 %", HPos::Center), (2, "100 % or more", HPos::Right)]
    {
        write(area, label, (left + (right - left) * part / 2, top + 46), &text(CELL, QUIET, anchor))?;
    }
    write(area, "relative difference to the best of the column", (left, top + 80), &text(CELL, QUIET, HPos::Left))?;
    let box_left = right + 60;
    hatched(area, [(box_left, top), (box_left + 48, top + 24)])?;
    write(area, "no value", (box_left + 60, top + 12), &text(CELL, QUIET, HPos::Left))
}
