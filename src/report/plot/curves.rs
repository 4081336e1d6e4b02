//! A few curves with scatter over one coordinate, whatever they are of.

use plotters::prelude::*;

use super::super::ReportError;
use super::Plot;
use super::axis::{chart, padded};
use super::canvas::{HEIGHT, Key, Mark, head, mark, sheet};
use super::theme;

/// One curve.
#[derive(Clone, Debug)]
pub struct Curve {
    /// What it is of, for the legend.
    pub label: String,
    /// Coordinate, value, and how far values scatter about it, in the order of the coordinate.
    pub points: Vec<[f64; 3]>,
}

/// What a plot of curves says beside them.
#[derive(Clone, Copy, Debug)]
pub struct Words<'a> {
    /// File name, for example `profile_density.svg`.
    pub file: &'a str,
    /// What it shows.
    pub title: &'a str,
    /// What is to be seen in it.
    pub caption: &'a str,
    /// The coordinate, with its unit.
    pub x_label: &'a str,
}

/// Draws curves in one frame, each in a colour and with marks of its own; bars show the scatter.
///
/// # Errors
/// [`ReportError::Plot`] if the drawing library refuses.
pub fn curves(words: Words, curves: &[Curve]) -> Result<Plot, ReportError> {
    let marks = [Mark::Ring(6), Mark::Diamond(8)];
    let shape = |index: usize| marks[index % marks.len()];
    let keys: Vec<Key> = curves
        .iter()
        .enumerate()
        .map(|(index, curve)| Key { label: curve.label.clone(), colour: theme::run(index), mark: shape(index) })
        .collect();
    let points = || curves.iter().flat_map(|curve| &curve.points);
    let x_range = padded(points().map(|[x, ..]| *x));
    let y_range = padded(points().flat_map(|[_, y, scatter]| [y - scatter, y + scatter]));
    sheet(words.file, words.title, words.caption, HEIGHT, |area| {
        let top = head(area, words.title, &keys)?;
        let chart = chart(area, top, words.x_label, x_range, y_range)?;
        for (index, curve) in curves.iter().enumerate() {
            let colour = theme::run(index);
            let line: Vec<(i32, i32)> = curve.points.iter().map(|[x, y, _]| chart.backend_coord(&(*x, *y))).collect();
            area.draw(&PathElement::new(line, colour.light.stroke_width(3)))?;
            for &[x, y, scatter] in &curve.points {
                if scatter > 0.0 {
                    let ends = [chart.backend_coord(&(x, y - scatter)), chart.backend_coord(&(x, y + scatter))];
                    area.draw(&PathElement::new(ends, colour.light.stroke_width(2)))?;
                }
                mark(area, shape(index), chart.backend_coord(&(x, y)), colour)?;
            }
        }
        Ok(())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn curves_have_a_legend_marks_and_bars() {
        // The bar ends within the range of the values, so that both plots have the same axes.
        let points = |scatter| vec![[0.0, 0.0, 0.0], [1.0, 2.0, scatter], [2.0, 4.0, 0.0]];
        let curve = |label: &str, scatter| Curve { label: label.into(), points: points(scatter) };
        let words = Words { file: "a.svg", title: "Density", caption: "", x_label: "x" };
        let two = curves(words, &[curve("one.csv", 0.5), curve("two.csv", 0.0)]).unwrap();
        let svg = two.svg();
        assert!(svg.contains("one.csv") && svg.contains("two.csv") && svg.contains("Density"), "{svg}");
        let plain = curves(words, &[curve("one.csv", 0.0), curve("two.csv", 0.0)]).unwrap();
        assert_eq!(svg.matches("<polyline").count(), plain.svg().matches("<polyline").count() + 1, "the bar");
        // Nothing to draw is drawn all the same.
        assert!(curves(words, &[]).is_ok());
    }
}
