//! The command line, as typed.

use super::choices::{Backend, Precision, SceneName, Start, Target};
use crate::snapshot::compare::{Along, By};
use clap::{Args, Parser, Subcommand};
use etalon_reference::scenes::sod::END_TIME;
use etalon_reference::schemes::{Dissipation, GradH, Kernel};
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  etalon run sod                          3-D, a minute or two on 2 cores; report in etalon-out/sod-3d
  etalon run sod --dim 1 --n 1000         1-D, a second
  etalon run sod --backend simd --precision f32 --alone --n 1e6
  etalon explain sod --scheme AV          passes, fields, memory and work of a step
  etalon emit sod --target wgsl --out DIR  its kernels as text, to read or to port
  etalon compare A.hdf5 B.hdf5             two snapshots, particle by particle and as profiles
  etalon bench                            speed of a step on one core
  etalon audit                            every equation of the papers against its record, in seconds
  etalon show gs25:13                     an equation: formula, reading, code, errors, tests

Exit code: 0 if all is well, 1 if a comparison failed its tolerance, something became worse than recorded or a run broke down, 2 for
bad input.";

/// A reference standard for the kernels of smoothed-particle hydrodynamics.
#[derive(Debug, Parser)]
#[command(name = "etalon", version, about, after_help = EXAMPLES)]
pub struct Arguments {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Run a scene on every backend, compare them with each other and with the exact solution, and write a report
    Run(RunArguments),
    /// List the scenes and the names that options take
    Scenes {
        /// Print JSON
        #[arg(long)]
        json: bool,
    },
    /// Show what a scene computes: passes, fields, memory, operations per pair
    Explain(ExplainArguments),
    /// Print the kernels of a scene in another language, to read or to port
    Emit(EmitArguments),
    /// Measure the speed of a complete step
    Bench(BenchArguments),
    /// Compare two snapshots, ours or another code's, particle by particle and as profiles
    Compare(CompareArguments),
    /// Hold every equation of the papers against its record: encoded, tested, how far each target is from the truth
    Audit(AuditArguments),
    /// Show all that is known of an equation: paper, reading, code, WGSL, errors, tests
    Show(ShowArguments),
    /// Write the book's pages of the equations
    Pages(PagesArguments),
}

/// A scene and its physics.
#[derive(Clone, Debug, Args)]
pub struct SceneArguments {
    /// The scene: sod
    pub scene: SceneName,
    /// Dimensions: 1, 2 or 3
    #[arg(long, value_name = "D", default_value = "3", value_parser = dimension, allow_negative_numbers = true)]
    pub dim: usize,
    /// About how many particles, boundary layers not counted [default: 450 in 1-D, 6000 in 2-D, 14000 in 3-D]
    #[arg(long, value_parser = count, allow_negative_numbers = true)]
    pub n: Option<usize>,
    /// Dissipation scheme: AV, AVSW, AVSLR, AVSWSLR, AVSLRB, AVSLRB2, AVSLRB2F or AVB; `etalon scenes` lists all
    #[arg(long, value_name = "NAME", default_value = "AVSLRB2")]
    pub scheme: Dissipation,
    /// Kernel: sinc49, M4, M6, C2, C4 or C6
    #[arg(long, value_name = "NAME", default_value = "sinc49")]
    pub kernel: Kernel,
    /// Neighbours within a support, the particle included [default: 100 in 3-D, and the same support in other dimensions]
    #[arg(long, value_name = "N", value_parser = number, allow_negative_numbers = true)]
    pub neighbours: Option<f64>,
    /// The grad-h factor: exact or corrected
    #[arg(long, value_name = "FORM", default_value = "corrected")]
    pub grad_h: GradH,
    /// Artificial conduction of heat with this coefficient [default: none; 0.1 if no number is given]
    #[arg(long, value_name = "ALPHA", num_args = 0..=1, default_missing_value = "0.1", value_parser = number, allow_negative_numbers = true)]
    pub conduction: Option<f64>,
    /// How particles start: on a lattice, or relaxed to a glass
    #[arg(long, value_name = "HOW", default_value = "lattice")]
    pub start: Start,
    /// Start from the particles in this table of comma-separated values (columns in docs/sod.md) instead of making them
    #[arg(long, value_name = "CSV", conflicts_with_all = ["n", "start", "smoothed"])]
    pub start_file: Option<PathBuf>,
    /// Start from a pressure smoothed across the interface (GS25, Eq. 21) instead of a sharp jump
    #[arg(long)]
    pub smoothed: bool,
    /// Adiabatic index [default: 5/3]
    #[arg(long, value_parser = number, allow_negative_numbers = true)]
    pub gamma: Option<f64>,
    /// Simulated time to stop at
    #[arg(long, value_name = "T", default_value_t = END_TIME, value_parser = number, allow_negative_numbers = true)]
    pub end_time: f64,
    /// One backend only, beside the reference: reference, simd or wgpu [default: all]
    #[arg(long, value_name = "NAME")]
    pub backend: Option<Backend>,
    /// One precision only, beside the reference: f32 or f64 [default: all]
    #[arg(long)]
    pub precision: Option<Precision>,
}

/// `etalon run`.
#[derive(Clone, Debug, Args)]
pub struct RunArguments {
    /// What to run.
    #[command(flatten)]
    pub scene: SceneArguments,
    /// Do not run the reference beside what was chosen
    #[arg(long)]
    pub alone: bool,
    /// Threads of the simd backend [default: all]
    #[arg(long, value_name = "N", value_parser = count, allow_negative_numbers = true)]
    pub threads: Option<usize>,
    /// Instructions of the simd backend: avx512, avx2, neon or portable [default: the best there are]
    #[arg(long, value_name = "NAME")]
    pub instructions: Option<String>,
    /// Graphics adapter, by a part of its name [default: hardware before software]
    #[arg(long, value_name = "NAME")]
    pub adapter: Option<String>,
    /// Folder of the report; a report that is there is replaced, any other folder refused [default: etalon-out/SCENE-Dd]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Print report.json instead of the table
    #[arg(long)]
    pub json: bool,
}

/// `etalon explain`.
#[derive(Clone, Debug, Args)]
pub struct ExplainArguments {
    /// What to explain.
    #[command(flatten)]
    pub scene: SceneArguments,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

/// `etalon emit`.
#[derive(Clone, Debug, Args)]
pub struct EmitArguments {
    /// What to print.
    #[command(flatten)]
    pub scene: SceneArguments,
    /// The language: wgsl or c
    #[arg(long, value_name = "NAME", default_value = "wgsl")]
    pub target: Target,
    /// One pass only, by its name in `etalon explain` [default: all of a step]
    #[arg(long, value_name = "NAME")]
    pub pass: Option<String>,
    /// Write a file for each pass into this folder instead of printing
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Replace files of these names that are there
    #[arg(long, requires = "out")]
    pub replace: bool,
}

/// `etalon bench`.
#[derive(Clone, Debug, Args)]
pub struct BenchArguments {
    /// About how many particles
    #[arg(long, default_value = "1000000", value_parser = count, allow_negative_numbers = true)]
    pub n: usize,
    /// Threads
    #[arg(long, value_name = "T", default_value = "1", value_parser = count, allow_negative_numbers = true)]
    pub threads: usize,
    /// Steps that are timed
    #[arg(long, value_name = "K", default_value = "10", value_parser = count, allow_negative_numbers = true)]
    pub steps: usize,
    /// Instructions: avx512, avx2, neon or portable [default: the best there are]
    #[arg(long, value_name = "NAME")]
    pub instructions: Option<String>,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

/// `etalon compare`.
#[derive(Clone, Debug, Args)]
pub struct CompareArguments {
    /// The snapshot that the other is measured against: HDF5 (GADGET, SWIFT), VTU or CSV
    #[arg(value_name = "A")]
    pub first: PathBuf,
    /// The other
    #[arg(value_name = "B")]
    pub second: PathBuf,
    /// Which particles belong together: id, position, or none (profile) [default: id where both have them, else position]
    #[arg(long, value_name = "HOW")]
    pub by: Option<By>,
    /// How far apart particles matched by position may be [default: half the mean spacing]
    #[arg(long, value_name = "L", value_parser = number, allow_negative_numbers = true)]
    pub within: Option<f64>,
    /// Along what profiles are taken: x, y, z or the radius r
    #[arg(long, value_name = "WHAT", default_value = "x")]
    pub along: Along,
    /// From where radii are counted, as x,y,z [default: the middle of the box]
    #[arg(long, value_name = "X,Y,Z", value_delimiter = ',', value_parser = number, allow_negative_numbers = true)]
    pub centre: Option<Vec<f64>>,
    /// Intervals of a profile
    #[arg(long, value_name = "N", default_value = "50", value_parser = count, allow_negative_numbers = true)]
    pub bins: usize,
    /// Exit with 1 if a field differs by more than this anywhere, in units of the field's scale
    #[arg(long, value_name = "X", value_parser = number, allow_negative_numbers = true)]
    pub tolerance: Option<f64>,
    /// Write compare.json and plots into this folder
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

/// `etalon audit`.
#[derive(Clone, Debug, Args)]
pub struct AuditArguments {
    /// Random inputs for each equation, beside the hard ones [default: 1000; 100000 for a record]
    #[arg(long, value_name = "N", value_parser = count, allow_negative_numbers = true)]
    pub samples: Option<usize>,
    /// One equation only, by its number (gs25:13) or its function (slope_limiter)
    #[arg(long, value_name = "ID", conflicts_with = "record")]
    pub only: Option<String>,
    /// Graphics adapter that runs WGSL, by a part of its name [default: hardware before software]
    #[arg(long, value_name = "NAME")]
    pub adapter: Option<String>,
    /// Do not run WGSL; show what is on record of it
    #[arg(long, conflicts_with = "adapter")]
    pub no_adapter: bool,
    /// Hold what is found against the records in this folder, such as `audit` of another version [default: those built in]
    #[arg(long, value_name = "DIR", conflicts_with = "record")]
    pub against: Option<PathBuf>,
    /// Make what is found the record that later audits are held against (minutes); run it in the root of the sources
    #[arg(long)]
    pub record: bool,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

/// `etalon show`.
#[derive(Clone, Debug, Args)]
pub struct ShowArguments {
    /// An equation's number, such as gs25:13, or a function, such as mixed_sinc
    #[arg(value_name = "ID")]
    pub subject: String,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

/// `etalon pages`.
#[derive(Clone, Debug, Args)]
pub struct PagesArguments {
    /// Write nothing; fail if a page is stale
    #[arg(long)]
    pub check: bool,
    /// The book's folder
    #[arg(long, value_name = "DIR", default_value = "docs")]
    pub out: PathBuf,
}

/// A whole number from 1 on; `1e6` and `1_000_000` are one too.
fn count(text: &str) -> Result<usize, String> {
    let digits = text.replace('_', "");
    let value = digits.parse::<f64>().map_err(|_| "it must be a whole number, such as 20000 or 1e6".to_string())?;
    match value {
        v if v.is_nan() || v < 1.0 => Err("it must be at least 1".into()),
        v if v.fract() != 0.0 => Err("it must be a whole number, such as 20000 or 1e6".into()),
        // Above this not every whole number is an f64, and no machine holds so many.
        v if v > 9e15 => Err("that is more than any machine holds; give a smaller number".into()),
        v => Ok(v as usize),
    }
}

/// A finite number.
fn number(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        _ => Err("it must be a finite number, such as 0.2".into()),
    }
}

fn dimension(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(dimension @ 1..=3) => Ok(dimension),
        _ => Err("there are 1, 2 or 3 dimensions; choose one of them".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_consistent() {
        Arguments::command().debug_assert();
    }

    #[test]
    fn counts_are_read_as_people_write_them() {
        assert_eq!([count("20000"), count("1e6"), count("1_000")], [Ok(20_000), Ok(1_000_000), Ok(1000)]);
        for bad in ["0", "-3", "1.5", "NaN", "inf", "many", ""] {
            assert!(count(bad).is_err(), "{bad} was taken as {:?}", count(bad));
        }
    }
}
