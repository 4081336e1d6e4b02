//! The report of a run: what was asked, what came out, how wrong it is and why, and how long it took.
//!
//! A caller fills a [`Report`] (plain data, [`model`]) and hands it to [`write()`], which leaves a folder with
//! `report.json`, `report.html`, one SVG a plot and the final particles. [`summary_table`] is the same in a few
//! aligned lines for a terminal. Nothing here computes physics: errors arrive measured, the report arranges them.
//!
//! | file | what lives there |
//! |---|---|
//! | `model.rs`, `model/` | the data, with units |
//! | `check.rs`, `json.rs` | what a report must satisfy; the versioned JSON form |
//! | `number.rs` | how a number is printed, in text and in typeset form |
//! | `verdict.rs`, `table.rs` | the one-sentence result; the terminal's table |
//! | `plot/`, `html/` | the pictures; the page |
//! | `particles.rs`, `vtu.rs` | the final particles as CSV and as VTK unstructured grid |
//! | `write.rs` | the folder: checked first, replaced as a whole |

mod check;
mod clock;
mod error;
mod html;
mod json;
pub mod model;
mod number;
mod particles;
mod plot;
#[cfg(test)]
mod synthetic;
mod table;
mod verdict;
mod vtu;
mod write;

pub use check::check;
pub use clock::utc_now;
pub use error::ReportError;
pub use html::page;
pub use json::{SCHEMA, SCHEMA_VERSION, from_json, to_json};
pub use model::Report;
pub use number::{plain, typeset};
pub use particles::{Column, Particles, write_csv};
pub use plot::{CellText, HeatColumn, HeatMap, HeatMatrix, heat_map, relative_differences};
pub use plot::{Curve, Plot, Words, curves, plots};
pub use plot::{FieldMap, Window, field_map, nearest, smoothed};
pub use plot::{Pareto, ParetoPoint, pareto, pareto_front};
pub use plot::{Series, SeriesLine, SeriesTarget, series};
pub use table::{columns, summary_table};
pub use verdict::{headline, passes};
pub use vtu::write_vtu;
pub use write::{Attachment, Beside, check_destination, write};
