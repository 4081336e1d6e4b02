//! `etalon reproduce`: the papers' comparisons, our number beside the published one.
//!
//! | file | what lives there |
//! |---|---|
//! | `readings.rs` | which of our measurements stands beside which published number |
//! | `series.rs` | how an error falls over several runs |
//! | `variants.rs` | how what a paper compares is chosen here |
//! | `conditions.rs` | how each scene is run |
//! | `runs.rs` | the runs that takes |
//! | `comparison.rs` | both numbers with their ranks |
//! | `heat.rs` | the same as heat maps |

mod comparison;
mod conditions;
mod heat;
mod readings;
mod runs;
mod series;
mod variants;

use super::Done;
use super::arguments::ReproduceArguments;
use super::failure::Failure;
use super::sweep::{Made, make};
use crate::report::Plot;
use comparison::Comparison;
use etalon_spec::tables::published;
use std::path::{Path, PathBuf};

/// Minutes that a run of the default sizes may take.
const USUAL_MINUTES: f64 = 15.0;

/// Makes the runs that are not made yet, compares, tells.
pub fn reproduce(arguments: &ReproduceArguments) -> Result<Done, Failure> {
    let all = published().map_err(|error| Failure::Broken(format!("the published tables: {error}")))?;
    let compared = runs::wanted(arguments, all)?;
    let folder = arguments.sweep.out.clone().unwrap_or_else(|| PathBuf::from("etalon-out").join("reproduce"));
    let minutes = (!arguments.paper_resolution).then_some(USUAL_MINUTES);
    let Made { store, left, .. } = make(&runs::jobs_of(&compared), &folder, &arguments.sweep, minutes)?;
    let comparison = Comparison::new(&compared, &store, all);
    let plots = comparison.heat_maps()?;
    write(&comparison, &plots, &folder)?;
    let text = match arguments.sweep.json {
        true => super::to_text(&comparison.json())?,
        false => {
            let mut text = comparison.text();
            if left > 0 {
                text += &format!("{left} runs are left; the same command goes on with them.\n");
            }
            let files: Vec<String> = plots.iter().map(|plot| folder.join(&plot.file).display().to_string()).collect();
            text + &files.iter().map(|file| format!("Heat map: {file}\n")).collect::<String>()
        }
    };
    Ok(Done::passed(text))
}

fn write(comparison: &Comparison, plots: &[Plot], folder: &Path) -> Result<(), Failure> {
    let put = |name: &str, text: String| {
        let path = folder.join(name);
        std::fs::write(&path, text).map_err(|error| {
            Failure::Broken(format!("cannot write {}: {error}; the results are in results.jsonl", path.display()))
        })
    };
    put("reproduce.json", super::to_text(&comparison.json())?)?;
    plots.iter().try_for_each(|plot| put(&plot.file, plot.svg()))
}
