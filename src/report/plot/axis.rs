//! Axes: linear and by decades, ranges that never collapse, one look for all.

use std::ops::Range;

use plotters::chart::ChartContext;
use plotters::coord::ranged1d::{AsRangedCoord, KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

use super::super::number;
use super::canvas::{Area, Drawn, LABEL, text};
use super::theme::{AXIS, GRID, INK, QUIET};

/// A logarithmic axis with marks at powers of ten only.
#[derive(Clone)]
pub(super) struct Decades(Range<f64>);

impl Decades {
    /// An axis that holds all positive values, from a power of ten to a power of ten. Without any it is 10⁻¹ to 10.
    pub(super) fn around(values: impl Iterator<Item = f64>) -> Self {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for exponent in values.filter(|value| *value > 0.0 && value.is_finite()).map(f64::log10) {
            (low, high) = (low.min(exponent), high.max(exponent));
        }
        if low > high {
            (low, high) = (-1.0, 1.0);
        }
        let low = low.floor();
        let high = high.ceil().max(low + 1.0);
        Self(low..high)
    }

    /// The same axis, wider at either end by a part of its length.
    pub(super) fn widened(self, below: f64, above: f64) -> Self {
        let length = self.0.end - self.0.start;
        Self(self.0.start - below * length..self.0.end + above * length)
    }

    /// The smallest value on the axis.
    pub(super) fn low(&self) -> f64 {
        10_f64.powf(self.0.start)
    }
}

impl Ranged for Decades {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        // Zero and below have no place on the axis: they are drawn at its lower end.
        let exponent = if *value > 0.0 { value.log10() } else { self.0.start };
        let part = ((exponent - self.0.start) / (self.0.end - self.0.start)).clamp(0.0, 1.0);
        (f64::from(limit.0) + part * f64::from(limit.1 - limit.0)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        let (low, high) = (self.0.start.ceil() as i32, self.0.end.floor() as i32);
        let step = ((high - low) as usize / hint.max_num_points().max(2) + 1).max(1);
        (low..=high).filter(|exponent| exponent.rem_euclid(step as i32) == 0).map(|e| 10_f64.powi(e)).collect()
    }

    fn range(&self) -> Range<f64> {
        10_f64.powf(self.0.start)..10_f64.powf(self.0.end)
    }
}

impl ValueFormatter<f64> for Decades {
    fn format_ext(&self, value: &f64) -> String {
        number::power_of_ten(value.log10().round() as i32)
    }
}

/// The range of the values with a twentieth of its width to spare on both sides; never empty.
pub(super) fn padded(values: impl Iterator<Item = f64>) -> Range<f64> {
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for value in values.filter(|value| value.is_finite()) {
        (low, high) = (low.min(value), high.max(value));
    }
    if low > high {
        return 0.0..1.0;
    }
    let pad = match 0.05 * (high - low) {
        // A constant gets a range of its own size, zero one of size one.
        pad if pad <= 1e-12 * high.abs() => {
            if high == 0.0 {
                0.5
            } else {
                0.5 * high.abs()
            }
        }
        pad => pad,
    };
    low - pad..high + pad
}

/// A tick label of a linear axis: no more digits than needed, a true minus sign.
pub(super) fn tick(value: f64) -> String {
    let rounded = format!("{:.6}", value);
    let trimmed = rounded.trim_end_matches('0').trim_end_matches('.');
    match trimmed {
        "-0" | "" => "0".into(),
        "0" if value != 0.0 && value.abs() > 1e-9 => number::typeset(value),
        digits => digits.replace('-', "−"),
    }
}

/// A chart whose x axis is linear.
pub(super) type Chart<'a, 'b, Y> = ChartContext<'b, SVGBackend<'a>, Cartesian2d<RangedCoordf64, Y>>;

/// Draws the frame of a chart below `top`.
pub(super) fn chart<'a, 'b, Y>(
    area: &'b Area<'a>,
    top: i32,
    x_label: &str,
    x: Range<f64>,
    y: Y,
) -> Drawn<Chart<'a, 'b, Y::CoordDescType>>
where
    Y: AsRangedCoord<Value = f64>,
    Y::CoordDescType: Ranged<ValueType = f64> + ValueFormatter<f64> + Tick,
{
    let mut chart = ChartBuilder::on(area)
        .margin_top(top)
        .margin_right(24)
        .margin_bottom(8)
        .x_label_area_size(78)
        .y_label_area_size(92)
        .build_cartesian_2d(x, y)?;
    chart
        .configure_mesh()
        .max_light_lines(0)
        .axis_style(AXIS.light)
        .light_line_style(GRID.light)
        .bold_line_style(GRID.light.stroke_width(2))
        .x_labels(8)
        .y_labels(6)
        .x_label_formatter(&|value| tick(*value))
        .y_label_formatter(&|value| Y::CoordDescType::label(*value))
        .label_style(text(LABEL, QUIET, HPos::Left))
        .axis_desc_style(text(LABEL, INK, HPos::Left))
        .x_desc(x_label)
        .draw()?;
    Ok(chart)
}

/// How an axis labels its ticks.
pub(super) trait Tick {
    /// The label at a value.
    fn label(value: f64) -> String;
}

impl Tick for RangedCoordf64 {
    fn label(value: f64) -> String {
        tick(value)
    }
}

impl Tick for Decades {
    fn label(value: f64) -> String {
        number::power_of_ten(value.log10().round() as i32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_never_collapse() {
        assert_eq!(padded([].into_iter()), 0.0..1.0);
        assert_eq!(padded([0.0, 0.0].into_iter()), -0.5..0.5);
        assert_eq!(padded([4.0].into_iter()), 2.0..6.0);
        let range = padded([-1.0, 1.0, f64::NAN].into_iter());
        assert!((range.start + 1.1).abs() < 1e-12 && (range.end - 1.1).abs() < 1e-12, "{range:?}");
    }

    #[test]
    fn decades_hold_their_values() {
        assert_eq!(Decades::around([3e-5, 0.2, 0.0].into_iter()).0, -5.0..0.0);
        assert_eq!(Decades::around([1.0].into_iter()).0, 0.0..1.0);
        assert_eq!(Decades::around([0.0].into_iter()).0, -1.0..1.0);
        let axis = Decades::around([1e-3, 1.0].into_iter());
        assert_eq!([1e-3, 1.0, 0.0, 5.0].map(|value| axis.map(&value, (0, 300))), [0, 300, 0, 300]);
    }

    #[test]
    fn ticks_are_short() {
        assert_eq!([0.1 + 0.2, -0.0, -1.5, 2.0, 1e-8].map(tick), ["0.3", "0", "−1.5", "2", "1.00×10⁻⁸"]);
    }
}
