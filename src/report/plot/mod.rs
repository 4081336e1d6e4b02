//! The plots, as SVG that reads on light and on dark ground.
//!
//! | file | plot |
//! |---|---|
//! | `profile.rs` | a field along the tube: particles of every run, exact solution |
//! | `error.rs` | both errors of the key field along the tube |
//! | `sources.rs` | the three sources of error of each run on one axis |
//! | `time.rs` | time a particle update |
//! | `trade.rs` | speed against error |
//! | `heat.rs`, `difference.rs` | schemes by tests, coloured by the distance from the best |
//! | `pareto.rs`, `front.rs`, `labels.rs` | error against cost, and the front of what nothing beats in both |
//! | `series.rs`, `quantities.rs` | a quantity over time for several runs; those of a report |
//! | `ending.rs` | the curves that a scene has at the end |
//! | `map.rs`, `sample.rs`, `raster.rs` | a picture of a field in the plane |
//! | `curves.rs` | any curves with scatter over one coordinate |
//! | `canvas.rs`, `axis.rs`, `scale.rs`, `decades.rs`, `rows.rs`, `theme.rs`, `palette.rs`, `refuse.rs` | what they share |

mod axis;
mod canvas;
mod curves;
mod decades;
mod difference;
mod ending;
mod error;
mod front;
mod heat;
mod labels;
mod map;
mod palette;
mod pareto;
mod profile;
mod quantities;
mod raster;
mod refuse;
mod rows;
mod sample;
mod scale;
mod series;
mod sources;
#[cfg(test)]
mod studies;
pub(super) mod theme;
mod time;
mod trade;

pub use curves::{Curve, Words, curves};
pub use difference::relative_differences;
pub use front::pareto_front;
pub use heat::{CellText, HeatColumn, HeatMap, HeatMatrix, heat_map};
pub use map::{FieldMap, field_map};
pub use pareto::{Pareto, ParetoPoint, pareto};
pub use sample::{Window, nearest, smoothed};
pub use series::{Series, SeriesLine, SeriesTarget, series};

pub(super) use canvas::key_label;
pub(super) use ending::file as curve_file;
pub(super) use profile::capital;
pub(super) use quantities::file as series_file;

use super::{Report, ReportError};

/// A finished plot.
#[derive(Clone, Debug)]
pub struct Plot {
    /// File name, for example `profile_density.svg`.
    pub file: String,
    /// What the plot shows, in a few words.
    pub title: String,
    /// What is to be seen in it, for those who do not see it and as a caption for those who do.
    pub caption: String,
    /// The `<svg>` element without styles, for a page that brings [`theme::style_sheet`] itself.
    body: String,
}

impl Plot {
    /// The plot as a file of its own.
    pub fn svg(&self) -> String {
        canvas::standalone(&self.body)
    }

    /// The plot as an element of a page that includes [`theme::style_sheet`].
    pub(super) fn inline(&self) -> &str {
        &self.body
    }
}

/// All plots of a report, in the order of the page. A plot for which there are no data is left out.
///
/// # Errors
/// [`ReportError::Plot`] if the drawing library refuses.
pub fn plots(report: &Report) -> Result<Vec<Plot>, ReportError> {
    let mut plots = Vec::new();
    for field in &report.fields {
        plots.extend(profile::draw(report, field)?);
    }
    plots.extend(quantities::draw(report)?);
    plots.extend(ending::draw(report)?);
    plots.extend(error::draw(report)?);
    plots.extend(sources::draw(report)?);
    plots.extend(time::draw(report)?);
    plots.extend(trade::draw(report)?);
    Ok(plots)
}

#[cfg(test)]
mod tests {
    use super::super::model::Outcome;
    use super::super::synthetic;
    use super::*;

    /// The values of an attribute throughout a document.
    fn values<'a>(svg: &'a str, attribute: &str) -> impl Iterator<Item = &'a str> {
        let opening = format!(" {attribute}=\"");
        let pieces: Vec<&str> = svg.split(&opening).skip(1).collect();
        pieces.into_iter().filter_map(|rest| rest.split('"').next())
    }

    #[test]
    fn every_plot_is_there_and_named() {
        let plots = plots(&synthetic::complete()).unwrap();
        let files: Vec<&str> = plots.iter().map(|plot| plot.file.as_str()).collect();
        assert_eq!(
            files,
            [
                "profile_density.svg",
                "profile_velocity_x.svg",
                "profile_pressure.svg",
                "profile_internal_energy.svg",
                "error.svg",
                "error_sources.svg",
                "time.svg",
                "speed_and_error.svg"
            ]
        );
    }

    #[test]
    fn every_colour_has_a_counterpart_on_dark_ground() {
        for plot in plots(&synthetic::complete()).unwrap() {
            let svg = plot.svg();
            for attribute in ["fill", "stroke"] {
                for colour in values(plot.inline(), attribute).filter(|&colour| colour != "none") {
                    let rule = format!("[{attribute}=\"{colour}\"]");
                    assert!(svg.contains(&rule), "{}: no dark rule for {attribute} {colour}", plot.file);
                }
            }
        }
    }

    #[test]
    fn labels_are_inside_the_picture() {
        for plot in plots(&synthetic::complete()).unwrap() {
            let svg = plot.inline();
            for text in svg.split("<text ").skip(1) {
                let x: f64 = values(&format!(" {text}"), "x").next().unwrap().parse().unwrap();
                assert!((0.0..=f64::from(canvas::WIDTH)).contains(&x), "{}: text at x = {x}", plot.file);
            }
            for cx in values(svg, "cx") {
                let cx: f64 = cx.parse().unwrap();
                assert!((0.0..=f64::from(canvas::WIDTH)).contains(&cx), "{}: mark at x = {cx}", plot.file);
            }
        }
    }

    #[test]
    fn degenerate_data_still_draw() {
        // One particle, constant fields, no exact curve, everything bit-equal: no axis may collapse.
        let mut report = synthetic::report();
        report.exact.x.clear();
        report.exact.fields.iter_mut().for_each(|field| field.value.clear());
        for run in &mut report.runs {
            let Outcome::Ran(measured) = &mut run.outcome else { continue };
            measured.profile.x = vec![0.5];
            for field in &mut measured.profile.fields {
                (field.value, field.exact) = (vec![1.0], vec![1.0]);
                field.reference.truncate(1);
                field.reference.iter_mut().for_each(|value| *value = 1.0);
            }
            for difference in &mut measured.arithmetic_difference {
                (difference.rms, difference.max) = (0.0, 0.0);
            }
        }
        assert!(plots(&report).unwrap().len() >= 6);
        report.runs.drain(..3);
        assert!(plots(&report).unwrap().is_empty(), "nothing ran, nothing to draw");
    }
}
