//! Curves of a run's end, one plot for each, all runs in it.

use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

use super::super::ReportError;
use super::super::model::{CurveColumn, EndCurve, Report};
use super::Plot;
use super::canvas::{Area, Drawn, HEIGHT, Key, LABEL, LEFT as MARGIN, Mark, head, mark, sheet, text, write};
use super::decades::{FOOT, LEFT, RIGHT};
use super::profile::capital;
use super::scale::Scale;
use super::series::line_mark;
use super::theme::{self, AXIS, GRID, INK, QUIET};

/// Marks along a line at most, so that lines can be told apart without colours.
const MARKS: usize = 12;

/// A plot for each curve that at least one run has.
pub(super) fn draw(report: &Report) -> Result<Vec<Plot>, ReportError> {
    let mut names: Vec<&str> = Vec::new();
    for curve in report.measured().flat_map(|(_, _, measured)| &measured.ending.curves) {
        if !names.contains(&curve.name.as_str()) {
            names.push(&curve.name);
        }
    }
    names.into_iter().map(|name| plot(report, name)).collect()
}

fn plot(report: &Report, name: &str) -> Result<Plot, ReportError> {
    let curves: Vec<(usize, String, &EndCurve)> = report
        .measured()
        .filter_map(|(index, run, measured)| {
            let curve = measured.ending.curves.iter().find(|curve| curve.name == name)?;
            Some((index, run.label(), curve))
        })
        .collect();
    // Names come from curves that are there.
    let Some((_, _, first)) = curves.first() else {
        return Err(ReportError::inconsistent("ending.curves", format!("no run has the curve `{name}`")));
    };
    let expected = first.expected.as_ref();
    let line: Vec<(f64, f64)> =
        expected.map_or_else(Vec::new, |line| line.x.iter().copied().zip(line.y.iter().copied()).collect());
    let all = || curves.iter().flat_map(|(_, _, curve)| curve.points()).chain(line.iter().copied());
    let across = Scale::around(first.x.logarithmic, all().map(|point| point.0));
    let up = Scale::around(first.y.logarithmic, all().map(|point| point.1));
    let mut keys: Vec<Key> = curves
        .iter()
        .map(|(index, label, _)| Key { label: label.clone(), colour: theme::run(*index), mark: line_mark(*index) })
        .collect();
    keys.extend(expected.map(|line| Key { label: line.source.clone(), colour: INK, mark: Mark::Line }));
    let title = capital(&first.label);
    let caption = match expected {
        Some(line) => format!("At the end. Broken: {}.", line.source),
        None => String::from("At the end. Runs that follow the reference lie on it."),
    };
    sheet(file(name), &title, caption, HEIGHT, |area| {
        let top = head(area, &title, &keys)?;
        write(area, &format!("↑ {}", words(&first.y)), (MARGIN, top + 4), &text(LABEL, INK, HPos::Left))?;
        let frame = Frame { top: top + 32, bottom: HEIGHT as i32 - FOOT, across, up };
        frame.draw(area, &words(&first.x))?;
        for (turn, (index, _, curve)) in curves.iter().enumerate() {
            let pixels: Vec<(i32, i32)> = curve.points().map(|point| frame.at(point)).collect();
            area.draw(&PathElement::new(pixels.clone(), theme::run(*index).light.stroke_width(4)))?;
            // Lines take turns, so that marks of lines that coincide do not hide each other.
            let every = pixels.len().div_ceil(MARKS).max(1);
            let begin = turn * every / curves.len();
            for &pixel in pixels.iter().skip(begin).step_by(every) {
                mark(area, line_mark(*index), pixel, theme::run(*index))?;
            }
        }
        let dashes: Vec<(i32, i32)> = line.iter().map(|&point| frame.at(point)).collect();
        match dashes.len() {
            0 => Ok(()),
            _ => area.draw(&DashedPathElement::new(dashes, 14, 8, INK.light.stroke_width(3))),
        }
    })
}

/// The name of a curve's plot.
pub(in super::super) fn file(name: &str) -> String {
    format!("curve_{name}.svg")
}

fn words(column: &CurveColumn) -> String {
    if column.unit.is_empty() { column.label.clone() } else { format!("{} [{}]", column.label, column.unit) }
}

/// A frame with its axes.
struct Frame {
    top: i32,
    bottom: i32,
    across: Scale,
    up: Scale,
}

impl Frame {
    fn at(&self, (x, y): (f64, f64)) -> (i32, i32) {
        (self.across.map(x, (LEFT, RIGHT)), self.up.map(y, (self.bottom, self.top)))
    }

    fn draw(&self, area: &Area, x_label: &str) -> Drawn {
        let (top, bottom) = (self.top, self.bottom);
        for (value, label) in self.across.ticks() {
            let x = self.across.map(value, (LEFT, RIGHT));
            area.draw(&PathElement::new([(x, top), (x, bottom)], GRID.light.stroke_width(2)))?;
            write(area, &label, (x, bottom + 24), &text(LABEL, QUIET, HPos::Center))?;
        }
        for (value, label) in self.up.ticks() {
            let y = self.up.map(value, (bottom, top));
            area.draw(&PathElement::new([(LEFT, y), (RIGHT, y)], GRID.light.stroke_width(2)))?;
            write(area, &label, (LEFT - 12, y), &text(LABEL, QUIET, HPos::Right))?;
        }
        area.draw(&PathElement::new([(LEFT, top), (LEFT, bottom), (RIGHT, bottom)], AXIS.light))?;
        write(area, x_label, ((LEFT + RIGHT) / 2, bottom + 64), &text(LABEL, INK, HPos::Center))
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic;
    use super::super::plots;
    use super::*;

    #[test]
    fn a_curve_has_all_runs_and_what_it_should_be() {
        let report = synthetic::with_ending();
        let all = plots(&report).unwrap();
        let plot = all.iter().find(|plot| plot.file == "curve_spectrum.svg").unwrap();
        let svg = plot.svg();
        for text in
            ["Spectrum of the velocity", "flat line", "SIMD f32", "label of wave_number [L^-1]", "↑ label of energy"]
        {
            assert!(svg.contains(text), "{text}");
        }
        // Along the axis 1, 2, 5, 10, 20, 50; up it 5e-5 to 1e-2.
        assert!(svg.lines().any(|line| line == "50") && svg.contains("10⁻⁴"), "{svg}");
        // One that only one run has is drawn of that one.
        let mut single = synthetic::with_ending();
        for run in &mut single.runs[..3] {
            let super::super::super::model::Outcome::Ran(measured) = &mut run.outcome else { panic!("it ran") };
            measured.ending.curves.clear();
        }
        assert_eq!(draw(&single).unwrap().len(), 1);
        assert!(draw(&synthetic::report()).unwrap().is_empty());
    }
}
