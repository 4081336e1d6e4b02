//! A picture of a field in the plane, with its scale of colours.

use std::ops::Range;

use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

use super::super::{ReportError, number};
use super::Plot;
use super::axis::chart;
use super::canvas::{Area, Drawn, LABEL, LEFT, WIDTH, head, sheet, text, write};
use super::palette::viridis;
use super::raster::data_address;
use super::refuse::{finite, unless};
use super::sample::Window;
use super::theme::{AXIS, INK, QUIET};

/// What the picture is made from, but for the field itself.
#[derive(Clone, Debug, PartialEq)]
pub struct FieldMap {
    /// File name, with `.svg`.
    pub file: String,
    /// What the plot shows, in a few words.
    pub title: String,
    /// What is to be seen in it.
    pub caption: String,
    /// What the field is, with its unit, for example `ρ [ρ₀]`.
    pub field: String,
    /// What runs along the axes, with units: to the right, and upwards.
    pub axes: [String; 2],
    /// The part of the plane that is shown.
    pub window: Window,
    /// The values at the ends of the scale, so that pictures can share one; beyond them colours stay those of the ends. Without, the
    /// smallest and largest value found.
    pub range: Option<(f64, f64)>,
    /// Pixels along the longer side, 2 to [`FieldMap::MOST_PIXELS`].
    pub pixels: u32,
}

impl FieldMap {
    /// The most pixels along a side: more than are shown, and a file of a megabyte.
    pub const MOST_PIXELS: u32 = 1000;
}

/// Width of the sheet's right part, for the scale, and of the scale itself.
const SCALE: i32 = 168;
const BAR: i32 = 36;
/// The picture's largest width and height; the labels' space left of and below it.
const WIDEST: f64 = (WIDTH as i32 - SCALE - 92 - 24) as f64;
const HIGHEST: f64 = 1200.0;
const BESIDE: i32 = 92 + 24;
const BELOW: i32 = 8 + 78;
/// Space above the picture, for the title and the name of the upward axis.
const TOP: i32 = 56 + 40;

/// Draws the field that `sample` gives at points of the window; where it gives nothing, the ground shows through.
///
/// Both axes have the same scale, unless one side is more than seven times the other.
///
/// # Errors
/// [`ReportError::NotFinite`] for a sampled value or an end of the range that is no number, [`ReportError::Inconsistent`] for an empty
/// window, a range without width, no value anywhere or a number of pixels out of bounds, [`ReportError::Plot`] if the drawing library
/// or the encoder refuses.
pub fn field_map(map: &FieldMap, sample: impl Fn([f64; 2]) -> Option<f64>) -> Result<Plot, ReportError> {
    let window = &map.window;
    window.check()?;
    let bounds = (2..=FieldMap::MOST_PIXELS).contains(&map.pixels);
    unless(bounds, || format!("{}: pixels", map.file), "there must be 2 to 1000 along the longer side")?;
    let aspect = (window.side(1) / window.side(0)).clamp(1.0 / 7.0, 7.0);
    let across = WIDEST.min(HIGHEST / aspect);
    let (width, height) = (across as i32, (across * aspect) as i32);
    let longer = f64::from(map.pixels);
    let pixels = [1.0 / aspect, aspect].map(|ratio| (longer * ratio.min(1.0)).round().max(2.0) as u32);
    let values = sampled(map, pixels, sample)?;
    let (low, high) = range(map, &values)?;
    let bytes: Vec<u8> = values.iter().flat_map(|value| pixel(*value, low, high)).collect();
    let refused = |error: png::EncodingError| ReportError::Plot { plot: map.file.clone(), problem: error.to_string() };
    let address = data_address(pixels, &bytes).map_err(refused)?;

    let mut frame: (Range<i32>, Range<i32>) = (0..0, 0..0);
    let mut plot = sheet(&map.file, &map.title, &map.caption, (TOP + height + BELOW) as u32, |area| {
        head(area, &map.title, &[])?;
        write(area, &format!("↑ {}", map.axes[1]), (LEFT, TOP - 28), &text(LABEL, INK, HPos::Left))?;
        let (left, _) = area.split_horizontally(BESIDE + width);
        let sides = [0, 1].map(|axis| window.low[axis]..window.high[axis]);
        let [x, y] = sides;
        frame = chart(&left, TOP, &map.axes[0], x, y)?.plotting_area().get_pixel_range();
        scale(area, map, BESIDE + width, (low, high))
    })?;
    // Over the grid, which a picture has no use for. The drawing library writes no such element.
    let (x, y) = frame;
    let image = format!(
        "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" href=\"{address}\"/>\n",
        x.start,
        y.start,
        x.end - x.start,
        y.end - y.start
    );
    let end = plot.body.rfind("</svg>").unwrap_or(plot.body.len());
    plot.body.insert_str(end, &image);
    Ok(plot)
}

/// The field at the middle of every pixel, row by row from the top.
fn sampled(
    map: &FieldMap,
    [columns, rows]: [u32; 2],
    sample: impl Fn([f64; 2]) -> Option<f64>,
) -> Result<Vec<Option<f64>>, ReportError> {
    let window = &map.window;
    let mut values = Vec::with_capacity((columns * rows) as usize);
    for row in 0..rows {
        let y = window.high[1] - (f64::from(row) + 0.5) / f64::from(rows) * window.side(1);
        for column in 0..columns {
            let x = window.low[0] + (f64::from(column) + 0.5) / f64::from(columns) * window.side(0);
            let value = sample([x, y]);
            finite(value.unwrap_or(0.0), || format!("{}: {} at ({x}, {y})", map.file, map.field))?;
            values.push(value);
        }
    }
    Ok(values)
}

/// The values at the ends of the scale.
fn range(map: &FieldMap, values: &[Option<f64>]) -> Result<(f64, f64), ReportError> {
    if let Some((low, high)) = map.range {
        let path = || format!("{}: range", map.file);
        finite(low, path)?;
        finite(high, path)?;
        unless(low < high, path, "the upper end must lie above the lower one")?;
        return Ok((low, high));
    }
    let found = values.iter().flatten();
    let (low, high) =
        found.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(*value), high.max(*value)));
    unless(low <= high, || format!("{}: {}", map.file, map.field), "there is no value anywhere in the window")?;
    // A constant field gets a scale around it, of its own size or, for zero, of size one.
    let half = match 0.5 * low.abs() {
        0.0 => 0.5,
        half => half,
    };
    Ok(if low < high { (low, high) } else { (low - half, low + half) })
}

/// The four bytes of a pixel.
fn pixel(value: Option<f64>, low: f64, high: f64) -> [u8; 4] {
    let Some(value) = value else { return [0; 4] };
    let (red, green, blue) = viridis((value - low) / (high - low)).rgb();
    [red, green, blue, 255]
}

/// The scale of colours at the right of the picture: name, bar, five values.
fn scale(area: &Area, map: &FieldMap, left: i32, (low, high): (f64, f64)) -> Drawn {
    let (_, height) = area.dim_in_pixel();
    let (top, bottom) = (TOP, height as i32 - BELOW);
    write(area, &map.field, (left, TOP - 28), &text(LABEL, INK, HPos::Left))?;
    let steps = 96;
    let row = |step: i32| bottom - (bottom - top) * step / steps;
    for step in 0..steps {
        let colour = viridis((f64::from(step) + 0.5) / f64::from(steps));
        // Each goes on to the top, under the next: no seam shows.
        area.draw(&Rectangle::new([(left, top), (left + BAR, row(step))], colour.filled()))?;
    }
    for part in 0..=4 {
        let value = low + (high - low) * f64::from(part) / 4.0;
        let y = row(steps * part / 4);
        area.draw(&PathElement::new([(left + BAR, y), (left + BAR + 8, y)], AXIS.light))?;
        write(area, &number::short(value), (left + BAR + 14, y), &text(LABEL - 2, QUIET, HPos::Left))?;
    }
    Ok(())
}
