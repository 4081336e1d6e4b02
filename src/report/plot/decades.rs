//! The frame of a plot with two logarithmic axes.

use plotters::coord::ranged1d::Ranged;
use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

use super::super::number;
use super::axis::Decades;
use super::canvas::{Area, Drawn, LABEL, WIDTH, text, write};
use super::theme::{AXIS, GRID, INK, QUIET};

/// The sides of the frame but the upper one, which the legend decides.
pub(super) const LEFT: i32 = 104;
pub(super) const RIGHT: i32 = WIDTH as i32 - 24;
/// Space below the frame, for the axis and its label.
pub(super) const FOOT: i32 = 96;

/// A frame with its axes.
pub(super) struct Frame<'a> {
    pub(super) top: i32,
    pub(super) bottom: i32,
    pub(super) across: &'a Decades,
    pub(super) up: &'a Decades,
}

impl Frame<'_> {
    /// The pixel of a point.
    pub(super) fn at(&self, (x, y): (f64, f64)) -> (i32, i32) {
        (self.across.map(&x, (LEFT, RIGHT)), self.up.map(&y, (self.bottom, self.top)))
    }

    /// Draws grid, axes and the label below.
    pub(super) fn draw(&self, area: &Area, x_label: &str) -> Drawn {
        let (top, bottom) = (self.top, self.bottom);
        let tick = |value: &f64| number::power_of_ten(value.log10().round() as i32);
        for value in self.across.key_points(8) {
            let x = self.across.map(&value, (LEFT, RIGHT));
            area.draw(&PathElement::new([(x, top), (x, bottom)], GRID.light.stroke_width(2)))?;
            write(area, &tick(&value), (x, bottom + 24), &text(LABEL, QUIET, HPos::Center))?;
        }
        for value in self.up.key_points(8) {
            let y = self.up.map(&value, (bottom, top));
            area.draw(&PathElement::new([(LEFT, y), (RIGHT, y)], GRID.light.stroke_width(2)))?;
            write(area, &tick(&value), (LEFT - 12, y), &text(LABEL, QUIET, HPos::Right))?;
        }
        area.draw(&PathElement::new([(LEFT, top), (LEFT, bottom), (RIGHT, bottom)], AXIS.light))?;
        write(area, x_label, ((LEFT + RIGHT) / 2, bottom + 64), &text(LABEL, INK, HPos::Center))
    }

    /// Short marks at twice to nine times the powers of ten, for axes of few decades.
    pub(super) fn draw_between(&self, area: &Area) -> Drawn {
        let between = |axis: &Decades| -> Vec<f64> {
            let range = axis.range();
            let (low, high) = (range.start.log10().floor() as i32, range.end.log10().ceil() as i32);
            let all =
                (low..high).flat_map(|exponent| (2..10).map(move |digit| f64::from(digit) * 10_f64.powi(exponent)));
            all.filter(|value| range.contains(value)).collect()
        };
        for value in between(self.across) {
            let x = self.across.map(&value, (LEFT, RIGHT));
            area.draw(&PathElement::new([(x, self.bottom - 8), (x, self.bottom)], AXIS.light))?;
        }
        for value in between(self.up) {
            let y = self.up.map(&value, (self.bottom, self.top));
            area.draw(&PathElement::new([(LEFT, y), (LEFT + 8, y)], AXIS.light))?;
        }
        Ok(())
    }
}
