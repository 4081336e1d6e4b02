//! A quantity over time for several runs, with what it should be.

use std::ops::Range;

use plotters::coord::ranged1d::{AsRangedCoord, Ranged, ValueFormatter};
use plotters::element::DashedPathElement;
use plotters::prelude::*;

use super::super::{ReportError, number};
use super::Plot;
use super::axis::{Chart, Decades, Tick, chart, padded};
use super::canvas::{Area, Drawn, HEIGHT, Key, Mark, head, mark, sheet};
use super::refuse::{finite, unless};
use super::theme::{self, INK, Pair, QUIET};

/// One run of a series.
#[derive(Clone, Debug, PartialEq)]
pub struct SeriesLine {
    /// Its name; the legend adds the last value.
    pub label: String,
    /// Time and value, by rising time.
    pub points: Vec<(f64, f64)>,
}

/// What the quantity should be.
#[derive(Clone, Debug, PartialEq)]
pub enum SeriesTarget {
    /// One value at all times.
    Value {
        /// What it is, for example `exact`.
        label: String,
        /// The value.
        value: f64,
    },
    /// A range at all times.
    Band {
        /// What it is.
        label: String,
        /// Its lower end.
        low: f64,
        /// Its upper end.
        high: f64,
    },
    /// A value for each time.
    Curve {
        /// What it is.
        label: String,
        /// Time and value, by rising time.
        points: Vec<(f64, f64)>,
    },
}

/// What the plot is drawn from.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// File name, with `.svg`.
    pub file: String,
    /// What the plot shows, in a few words, with the unit of the quantity.
    pub title: String,
    /// What is to be seen in it.
    pub caption: String,
    /// What runs along the lower axis, with its unit.
    pub time: String,
    /// Whether the quantity's axis is logarithmic; values that are not above zero then lie at its lower end.
    pub logarithmic: bool,
    /// The runs.
    pub lines: Vec<SeriesLine>,
    /// What the quantity should be.
    pub target: Option<SeriesTarget>,
}

/// Points a line has at most: a larger file shows no more.
const POINTS: usize = 1000;
/// Marks along a line, so that lines can be told apart without colours.
const MARKS: [Mark; 4] = [Mark::Disc(7), Mark::Diamond(10), Mark::Square(7), Mark::Ring(7)];
const MARKS_ON_LINE: usize = 6;

/// Draws one line a run, with marks of its own, and the target in ink.
///
/// # Errors
/// [`ReportError::NotFinite`] for a number that is none, [`ReportError::Inconsistent`] for no lines, an empty line, times that do not
/// rise or a band whose ends are in the wrong order, [`ReportError::Plot`] if the drawing library refuses.
pub fn series(plot: &Series) -> Result<Plot, ReportError> {
    check(plot)?;
    let keys = keys(plot);
    let curve: &[(f64, f64)] = match &plot.target {
        Some(SeriesTarget::Curve { points, .. }) => points,
        _ => &[],
    };
    let points = plot.lines.iter().flat_map(|line| &line.points).chain(curve);
    let times = padded(points.clone().map(|point| point.0));
    let levels = match plot.target {
        Some(SeriesTarget::Value { value, .. }) => vec![value],
        Some(SeriesTarget::Band { low, high, .. }) => vec![low, high],
        _ => vec![],
    };
    let values = points.map(|point| point.1).chain(levels);
    sheet(&plot.file, &plot.title, &plot.caption, HEIGHT, |area| {
        let top = head(area, &plot.title, &keys)?;
        if plot.logarithmic {
            let axis = Decades::around(values).widened(0.03, 0.03);
            draw(area, plot, top, times, axis)
        } else {
            draw(area, plot, top, times, padded(values))
        }
    })
}

fn check(plot: &Series) -> Result<(), ReportError> {
    unless(!plot.lines.is_empty(), || plot.file.clone(), "there are no lines to draw")?;
    let line = |label: &str, points: &[(f64, f64)]| {
        let path = || format!("{}: {label}", plot.file);
        unless(!points.is_empty(), path, "the line has no points")?;
        for (place, &(time, value)) in points.iter().enumerate() {
            finite(time, || format!("{}.time[{place}]", path()))?;
            finite(value, || format!("{}.value[{place}]", path()))?;
        }
        unless(points.is_sorted_by_key(|point| point.0), path, "its times do not rise; sort the points by time")
    };
    for SeriesLine { label, points } in &plot.lines {
        line(label, points)?;
    }
    match &plot.target {
        Some(SeriesTarget::Curve { label, points }) => line(label, points),
        Some(SeriesTarget::Value { label, value }) => finite(*value, || format!("{}: {label}", plot.file)),
        Some(SeriesTarget::Band { label, low, high }) => {
            let path = || format!("{}: {label}", plot.file);
            finite(*low, path)?;
            finite(*high, path)?;
            unless(low <= high, path, "the lower end of the band is above the upper one")
        }
        None => Ok(()),
    }
}

/// The legend: each run with its last value, and the target.
fn keys(plot: &Series) -> Vec<Key> {
    let key = |(place, line): (usize, &SeriesLine)| {
        let last = line.points.last().map_or(f64::NAN, |point| point.1);
        let label = format!("{}: {}", line.label, number::typeset(last));
        Key { label, colour: theme::run(place), mark: line_mark(place) }
    };
    let mut keys: Vec<Key> = plot.lines.iter().enumerate().map(key).collect();
    let target = match &plot.target {
        Some(SeriesTarget::Value { label, value }) => Some(format!("{label}: {}", number::typeset(*value))),
        Some(SeriesTarget::Band { label, low, high }) => {
            Some(format!("{label}: {} to {}", number::typeset(*low), number::typeset(*high)))
        }
        Some(SeriesTarget::Curve { label, .. }) => Some(label.clone()),
        None => None,
    };
    keys.extend(target.map(|label| Key { label, colour: INK, mark: Mark::Line }));
    keys
}

/// The mark of a line by its place; with the colours, whose number differs by two, no pair repeats before the thirteenth.
pub(super) fn line_mark(place: usize) -> Mark {
    MARKS[place % MARKS.len()]
}

fn draw<Y>(area: &Area, plot: &Series, top: i32, times: Range<f64>, values: Y) -> Drawn
where
    Y: AsRangedCoord<Value = f64>,
    Y::CoordDescType: Ranged<ValueType = f64> + ValueFormatter<f64> + Tick,
{
    let chart = chart(area, top, &plot.time, times.clone(), values)?;
    let level = |value: f64| [(times.start, value), (times.end, value)];
    if let Some(SeriesTarget::Band { low, high, .. }) = &plot.target {
        let [from, to] = [(times.start, *high), (times.end, *low)].map(|point| chart.backend_coord(&point));
        area.draw(&Rectangle::new([from, to], QUIET.light.mix(0.15).filled()))?;
        for end in [low, high] {
            line(area, &chart, &level(*end), INK, 1)?;
        }
    }
    for (place, SeriesLine { points, .. }) in plot.lines.iter().enumerate() {
        line(area, &chart, points, theme::run(place), 4)?;
        // Lines take turns, so that marks of lines that coincide do not hide each other.
        let shift = (place as f64 + 0.5) / plot.lines.len() as f64;
        for number in 0..MARKS_ON_LINE {
            let along = (number as f64 + shift) / MARKS_ON_LINE as f64 * points.len() as f64;
            let point = points[(along as usize).min(points.len() - 1)];
            mark(area, line_mark(place), chart.backend_coord(&point), theme::run(place))?;
        }
    }
    // Over the runs, so that it is never hidden.
    match &plot.target {
        Some(SeriesTarget::Value { value, .. }) => dashed(area, &chart, &level(*value)),
        Some(SeriesTarget::Curve { points, .. }) => dashed(area, &chart, points),
        Some(SeriesTarget::Band { .. }) | None => Ok(()),
    }
}

/// A line through points, no more of them than a reader can see; the last is among them.
fn line<Y>(area: &Area, chart: &Chart<Y>, points: &[(f64, f64)], colour: Pair, width: u32) -> Drawn
where
    Y: Ranged<ValueType = f64>,
{
    let pixels = pixels(chart, points);
    area.draw(&PathElement::new(pixels, colour.light.stroke_width(width)))
}

/// The same in ink, broken.
fn dashed<Y>(area: &Area, chart: &Chart<Y>, points: &[(f64, f64)]) -> Drawn
where
    Y: Ranged<ValueType = f64>,
{
    area.draw(&DashedPathElement::new(pixels(chart, points), 14, 8, INK.light.stroke_width(3)))
}

fn pixels<Y>(chart: &Chart<Y>, points: &[(f64, f64)]) -> Vec<(i32, i32)>
where
    Y: Ranged<ValueType = f64>,
{
    let every = points.len().div_ceil(POINTS).max(1);
    points.iter().step_by(every).chain(points.last()).map(|point| chart.backend_coord(point)).collect()
}
