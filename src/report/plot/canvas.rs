//! A sheet to draw on: text, legend, marks; and how it becomes a file.
//!
//! Sheets are twice as large as they are shown, since the drawing library counts in whole pixels.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::super::ReportError;
use super::super::html::escape;
use super::super::model::Report;
use super::super::verdict::key_field;
use super::Plot;
use super::theme::{self, INK, PAPER, Pair, QUIET};

/// Width of every sheet.
pub(super) const WIDTH: u32 = 1120;
/// Height of a usual sheet.
pub(super) const HEIGHT: u32 = 760;
/// Left margin, where titles begin.
pub(super) const LEFT: i32 = 12;
/// Text sizes.
pub(super) const TITLE: i32 = 30;
pub(super) const LABEL: i32 = 26;

/// The SVG writer divides text sizes by this; they are multiplied by it first.
const WRITER_SHRINKS: f64 = 1.24;

/// The drawing area of the SVG writer.
pub(super) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
/// What drawing on it may return.
pub(super) type Drawn<T = ()> = Result<T, DrawingAreaErrorKind<std::io::Error>>;

/// Draws a plot: `paint` gets an empty sheet of the given height.
pub(super) fn sheet(
    file: impl Into<String>,
    title: impl Into<String>,
    caption: impl Into<String>,
    height: u32,
    paint: impl FnOnce(&Area) -> Drawn,
) -> Result<Plot, ReportError> {
    let (file, title, caption) = (file.into(), title.into(), caption.into());
    let mut raw = String::new();
    {
        let area = SVGBackend::with_string(&mut raw, (WIDTH, height)).into_drawing_area();
        let refused = |problem: String| ReportError::Plot { plot: file.clone(), problem };
        paint(&area).map_err(|error| refused(error.to_string()))?;
        area.present().map_err(|error| refused(error.to_string()))?;
    }
    let content = raw.find("<svg").and_then(|start| raw[start..].find('>').map(|end| &raw[start + end + 1..]));
    let Some(content) = content else {
        return Err(ReportError::Plot { plot: file, problem: "the SVG writer left no <svg> element".into() });
    };
    let body = format!(
        "<svg class=\"plot\" role=\"img\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height}\">\n\
         <title>{}</title>\n<desc>{}</desc>{content}",
        escape(&title),
        escape(&caption)
    );
    Ok(Plot { file, title, caption, body })
}

/// A body as a file of its own: with a ground to stand on and its styles.
pub(super) fn standalone(body: &str) -> String {
    let Some(end) = body.find("<title>") else { return body.to_owned() };
    let (head, rest) = body.split_at(end);
    let paper = theme::hex(PAPER.light);
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{head}<style>{}</style>\n\
         <rect width=\"100%\" height=\"100%\" fill=\"{paper}\"/>\n{rest}",
        theme::style_sheet()
    )
}

/// A style for text of that size and colour.
pub(super) fn text(size: i32, colour: Pair, horizontal: HPos) -> TextStyle<'static> {
    ("sans-serif", f64::from(size) * WRITER_SHRINKS)
        .into_font()
        .color(&colour.light)
        .pos(Pos::new(horizontal, VPos::Center))
}

/// Writes a line of text with its middle at height `y`.
pub(super) fn write(area: &Area, line: &str, at: (i32, i32), style: &TextStyle) -> Drawn {
    area.draw_text(line, style, at)
}

/// Rough width of a line of text. No font is at hand when the plot is made; these are the widths of a wide one, so that
/// with another there is a little more space rather than an overlap.
pub(super) fn width_of(line: &str, size: i32) -> i32 {
    let width = |c: char| match c {
        'i' | 'j' | 'l' | '.' | ',' | ':' | '\'' | '|' => 0.3,
        ' ' | 'f' | 't' | 'r' | 'I' | '(' | ')' | '[' | ']' | '/' | '-' => 0.4,
        'm' | 'w' | 'M' | 'W' | '−' | '×' => 0.9,
        c if c.is_uppercase() => 0.72,
        '₀'..='₉' | 'ₓ' => 0.4,
        _ => 0.62,
    };
    (line.chars().map(width).sum::<f64>() * f64::from(size)).ceil() as i32
}

/// An entry of a legend.
pub(super) struct Key {
    pub(super) label: String,
    pub(super) colour: Pair,
    pub(super) mark: Mark,
}

/// How a thing is marked.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Mark {
    /// A line.
    Line,
    /// An open ring, of that radius.
    Ring(i32),
    /// A disc, of that radius.
    Disc(i32),
    /// A disc that lets what lies under it through.
    Translucent(i32),
    /// A diamond, of that half-diagonal.
    Diamond(i32),
    /// A square, of that half-side.
    Square(i32),
    /// A triangle that stands on its base, of that half-height.
    Triangle(i32),
    /// A short upright bar, of that half-height.
    Bar(i32),
}

/// Draws one mark at a pixel.
pub(super) fn mark(area: &Area, mark: Mark, at: (i32, i32), colour: Pair) -> Drawn {
    let colour = colour.light;
    match mark {
        Mark::Line => area.draw(&PathElement::new([(at.0 - 14, at.1), (at.0 + 14, at.1)], colour.stroke_width(4))),
        Mark::Ring(radius) => area.draw(&Circle::new(at, radius, colour.stroke_width(3))),
        Mark::Disc(radius) => area.draw(&Circle::new(at, radius, colour.filled())),
        Mark::Translucent(radius) => area.draw(&Circle::new(at, radius, colour.mix(0.6).filled())),
        Mark::Diamond(r) => {
            let corners = [(at.0, at.1 - r), (at.0 + r, at.1), (at.0, at.1 + r), (at.0 - r, at.1)];
            area.draw(&Polygon::new(corners, colour.mix(0.8).filled()))
        }
        Mark::Square(half) => {
            let corners = [(at.0 - half, at.1 - half), (at.0 + half, at.1 + half)];
            area.draw(&Rectangle::new(corners, colour.mix(0.7).filled()))
        }
        Mark::Triangle(half) => {
            let corners = [(at.0, at.1 - half), (at.0 + half, at.1 + half), (at.0 - half, at.1 + half)];
            area.draw(&Polygon::new(corners, colour.mix(0.8).filled()))
        }
        Mark::Bar(half) => {
            area.draw(&PathElement::new([(at.0, at.1 - half), (at.0, at.1 + half)], colour.stroke_width(4)))
        }
    }
}

/// Draws a title with a legend under it; returns the height taken, so that the chart can begin below.
pub(super) fn head(area: &Area, title: &str, keys: &[Key]) -> Drawn<i32> {
    write(area, title, (LEFT, 26), &text(TITLE, INK, HPos::Left))?;
    let (mut x, mut y) = (LEFT, 72);
    for key in keys {
        let width = 40 + width_of(&key.label, LABEL) + 24;
        if x > LEFT && x + width > WIDTH as i32 {
            (x, y) = (LEFT, y + 36);
        }
        mark(area, key.mark, (x + 16, y), key.colour)?;
        write(area, &key.label, (x + 40, y), &text(LABEL, QUIET, HPos::Left))?;
        x += width;
    }
    Ok(if keys.is_empty() { 56 } else { y + 38 })
}

/// How the particles of a run are drawn: shapes as well as colours tell the runs apart.
pub(super) fn particle(index: usize) -> Mark {
    [Mark::Ring(6), Mark::Translucent(6), Mark::Diamond(8), Mark::Square(5)][index % 4]
}

/// The label of the key field's error, `L₁(vₓ)`.
pub(in super::super) fn key_label(report: &Report) -> String {
    format!("L₁({})", key_field(report).map_or("field", |field| &field.symbol))
}
