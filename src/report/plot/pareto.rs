//! Error against cost, with the front of what nothing beats in both.

use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

use super::super::{ReportError, number};
use super::Plot;
use super::axis::Decades;
use super::canvas::{HEIGHT, Key, LABEL, LEFT as MARGIN, Mark, head, mark, sheet, text, write};
use super::decades::{FOOT, Frame, LEFT, RIGHT};
use super::front::pareto_front;
use super::labels::Labels;
use super::refuse::{finite, unless};
use super::theme::{self, AXIS, INK, QUIET};

/// A setting with what it costs and how wrong it is.
#[derive(Clone, Debug, PartialEq)]
pub struct ParetoPoint {
    /// The cost; above zero.
    pub cost: f64,
    /// The error; not below zero. Zero is drawn at the lower end of the axis.
    pub error: f64,
    /// The setting in a few signs, for example `n = 100`.
    pub label: String,
    /// What the colour tells, for example the scheme.
    pub family: String,
    /// What the mark tells, for example kernel or precision; empty where marks tell nothing of their own.
    pub kind: String,
}

/// What the plot is drawn from.
#[derive(Clone, Debug, PartialEq)]
pub struct Pareto {
    /// File name, with `.svg`.
    pub file: String,
    /// What the plot shows, in a few words.
    pub title: String,
    /// What is to be seen in it; the front with its values is added.
    pub caption: String,
    /// What the cost is, with its unit.
    pub cost: String,
    /// What the error is, with its unit.
    pub error: String,
    /// The points.
    pub points: Vec<ParetoPoint>,
}

/// Marks by kind, in the order of first occurrence.
const MARKS: [Mark; 6] =
    [Mark::Disc(9), Mark::Diamond(12), Mark::Square(8), Mark::Ring(8), Mark::Triangle(10), Mark::Bar(11)];
/// Labels keep that far from the middle of a mark.
const CLEAR: i32 = 16;

/// Draws every point, the front as a staircase, and as many labels as there is room for: those of the front first, of the
/// others only what fits beside the mark.
///
/// # Errors
/// [`ReportError::NotFinite`] for a coordinate that is no number, [`ReportError::Inconsistent`] for a cost that is not above zero, an
/// error below zero or no points at all, [`ReportError::Plot`] if the drawing library refuses.
pub fn pareto(plot: &Pareto) -> Result<Plot, ReportError> {
    check(plot)?;
    let points: Vec<(f64, f64)> = plot.points.iter().map(|point| (point.cost, point.error)).collect();
    let front = pareto_front(&points)?;
    let families = distinct(plot.points.iter().map(|point| point.family.as_str()));
    let kinds = distinct(plot.points.iter().map(|point| point.kind.as_str()));
    let colour = |point: &ParetoPoint| theme::run(place_of(&families, &point.family));
    let shape = |point: &ParetoPoint| MARKS[place_of(&kinds, &point.kind) % MARKS.len()];
    let mut keys: Vec<Key> = Vec::new();
    for (place, family) in families.iter().enumerate().filter(|(_, family)| !family.is_empty()) {
        let single = if kinds.len() > 1 { Mark::Line } else { MARKS[0] };
        keys.push(Key { label: (*family).into(), colour: theme::run(place), mark: single });
    }
    for (place, kind) in kinds.iter().enumerate().filter(|(_, kind)| !kind.is_empty() && kinds.len() > 1) {
        keys.push(Key { label: (*kind).into(), colour: QUIET, mark: MARKS[place % MARKS.len()] });
    }
    let across = Decades::around(points.iter().map(|point| point.0)).widened(0.04, 0.04);
    let up = Decades::around(points.iter().map(|point| point.1)).widened(0.06, 0.06);
    let caption = format!("{} {}", plot.caption, front_in_words(plot, &front));

    sheet(&plot.file, &plot.title, caption, HEIGHT + 60, |area| {
        let top = head(area, &plot.title, &keys)?;
        write(area, &format!("↑ {}", plot.error), (MARGIN, top + 4), &text(LABEL, INK, HPos::Left))?;
        let frame = Frame { top: top + 32, bottom: HEIGHT as i32 + 60 - FOOT, across: &across, up: &up };
        frame.draw(area, &plot.cost)?;
        frame.draw_between(area)?;
        let stairs = staircase(&frame, front.iter().map(|&place| points[place]));
        area.draw(&PathElement::new(stairs.clone(), INK.light.stroke_width(3)))?;
        let pixels: Vec<(i32, i32)> = points.iter().map(|&point| frame.at(point)).collect();
        let mut labels = Labels::around((LEFT + 4, frame.top, RIGHT, frame.bottom - 4), &pixels, CLEAR);
        labels.keep_off(&stairs);
        let rest = (0..points.len()).filter(|place| !front.contains(place));
        let order: Vec<usize> = front.iter().copied().chain(rest).collect();
        // Only labels of the front may lie apart from their points. Marks are drawn over lines, labels over both.
        let place = |(rank, &place): (usize, &usize)| {
            labels.place(&plot.points[place].label, pixels[place], rank < front.len())
        };
        let placed: Vec<_> = order.iter().enumerate().map(place).collect();
        for (&place, placed) in order.iter().zip(&placed) {
            if let Some(lead) = placed.and_then(|placed| placed.lead) {
                area.draw(&PathElement::new([pixels[place], lead], AXIS.light))?;
            }
        }
        for (point, &at) in plot.points.iter().zip(&pixels) {
            mark(area, shape(point), at, colour(point))?;
        }
        for (rank, (&place, placed)) in order.iter().zip(placed).enumerate() {
            let Some(placed) = placed else { continue };
            let ink = if rank < front.len() { INK } else { QUIET };
            write(area, &plot.points[place].label, placed.at, &text(LABEL, ink, HPos::Left))?;
        }
        Ok(())
    })
}

fn check(plot: &Pareto) -> Result<(), ReportError> {
    unless(!plot.points.is_empty(), || plot.file.clone(), "there are no points to draw")?;
    for point in &plot.points {
        let path = |part: &str| format!("{}: {part} of `{}`", plot.file, point.label);
        finite(point.cost, || path("cost"))?;
        finite(point.error, || path("error"))?;
        unless(point.cost > 0.0, || path("cost"), "it must be above zero to have a place on a logarithmic axis")?;
        unless(point.error >= 0.0, || path("error"), "an error is not below zero")?;
    }
    Ok(())
}

/// Every text once, in the order of first occurrence.
fn distinct<'a>(texts: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let mut out: Vec<&str> = Vec::new();
    for text in texts {
        if !out.contains(&text) {
            out.push(text);
        }
    }
    out
}

/// The place of a text among distinct ones that hold it.
fn place_of(texts: &[&str], text: &str) -> usize {
    texts.iter().position(|other| *other == text).unwrap_or(0)
}

/// The lowest error that a cost buys: down at every point of the front, level between.
fn staircase(frame: &Frame, front: impl Iterator<Item = (f64, f64)>) -> Vec<(i32, i32)> {
    let mut stairs: Vec<(i32, i32)> = Vec::new();
    for (x, y) in front.map(|point| frame.at(point)) {
        let level = stairs.last().map_or(frame.top, |last| last.1);
        stairs.extend([(x, level), (x, y)]);
    }
    let level = stairs.last().map_or(frame.bottom, |last| last.1);
    stairs.push((RIGHT, level));
    stairs
}

/// The front as a sentence, with values; the cheapest first.
fn front_in_words(plot: &Pareto, front: &[usize]) -> String {
    let of = |&place: &usize| {
        let point = &plot.points[place];
        let names = [&point.label, &point.family, &point.kind];
        let names: Vec<&str> = names.into_iter().map(String::as_str).filter(|name| !name.is_empty()).collect();
        format!("{} ({} at {})", names.join(" "), number::typeset(point.error), number::typeset(point.cost))
    };
    let points: Vec<String> = front.iter().map(of).collect();
    format!("Nothing is both cheaper and closer than the line: {}.", points.join(", "))
}
