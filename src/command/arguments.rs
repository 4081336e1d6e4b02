//! The command line, as typed.

use super::choices::{Backend, Cost, Precision, Target};
use super::restarts::USUAL_SECONDS;
use crate::snapshot::compare::{Along, By};
use clap::{Args, Parser, Subcommand};
use etalon_reference::scenes::{Arrangement, Name};
use etalon_reference::schemes::{Dissipation, GradH, Kernel};
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  etalon run sod                          3-D, a minute or two on 2 cores; report in etalon-out/sod-3d
  etalon run sod --dim 1 --n 1000         1-D, a second
  etalon scenes sod > my-scene.toml       a scene as a file, to change and to run: etalon run my-scene.toml
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
    /// List the scenes and the names that options take, or print one as a file to copy and change
    Scenes(ScenesArguments),
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
    /// Run a scene with many settings and show which buys a given error cheapest
    Pareto(ParetoArguments),
    /// Run the papers' comparisons and print our numbers beside the published ones, with ranks and a heat map
    Reproduce(ReproduceArguments),
    /// Write the book's pages of the equations
    Pages(PagesArguments),
}

/// A scene and its physics.
#[derive(Clone, Debug, Default, Args)]
pub struct SceneArguments {
    /// A scene that `etalon scenes` lists, or a file that describes one (`etalon scenes NAME` prints one to copy)
    pub scene: String,
    /// Dimensions: 1, 2 or 3 [default: the scene's]
    #[arg(long, value_name = "D", value_parser = dimension, allow_negative_numbers = true)]
    pub dim: Option<usize>,
    /// About how many particles, boundary layers not counted [default: the scene's; for sod 450 in 1-D, 6000 in 2-D, 14000 in 3-D]
    #[arg(long, value_parser = count, allow_negative_numbers = true)]
    pub n: Option<usize>,
    /// Dissipation scheme: AV, AVSW, AVSLR, AVSWSLR, AVSLRB, AVSLRB2, AVSLRB2F or AVB; `etalon scenes` lists all [default: the scene's, AVSLRB2]
    #[arg(long, value_name = "NAME")]
    pub scheme: Option<Dissipation>,
    /// Kernel: sinc49, M4, M6, C2, C4 or C6 [default: the scene's, sinc49]
    #[arg(long, value_name = "NAME")]
    pub kernel: Option<Kernel>,
    /// Neighbours within a support, the particle included [default: the scene's; 100 in 3-D, and the same support in other dimensions]
    #[arg(long, value_name = "N", value_parser = number, allow_negative_numbers = true)]
    pub neighbours: Option<f64>,
    /// The grad-h factor: exact or corrected [default: the scene's, corrected]
    #[arg(long, value_name = "FORM")]
    pub grad_h: Option<GradH>,
    /// Artificial conduction of heat with this coefficient [default: the scene's; 0.1 if no number is given]
    #[arg(long, value_name = "ALPHA", num_args = 0..=1, default_missing_value = "0.1", value_parser = number, allow_negative_numbers = true)]
    pub conduction: Option<f64>,
    /// How particles start: on a lattice, or relaxed to a glass [default: the scene's, lattice]
    #[arg(long, value_name = "HOW")]
    pub start: Option<Arrangement>,
    /// Start the tube from the particles in this table of comma-separated values (columns in docs/sod.md) instead of making them
    #[arg(long, value_name = "CSV", conflicts_with_all = ["n", "start", "smoothed"])]
    pub start_file: Option<PathBuf>,
    /// Start the tube from a pressure smoothed across the interface (GS25, Eq. 21) instead of a sharp jump: --set smoothed=true
    #[arg(long)]
    pub smoothed: bool,
    /// Adiabatic index: --set gamma=GAMMA [default: the scene's]
    #[arg(long, value_parser = number, allow_negative_numbers = true)]
    pub gamma: Option<f64>,
    /// Set a choice of the scene's own, such as smoothed=true, or of the method, such as method.alpha=0.5; `etalon scenes NAME` lists both
    #[arg(long, value_name = "KEY=VALUE", value_parser = setting)]
    pub set: Vec<(String, toml::Value)>,
    /// Simulated time to stop at [default: the scene's]
    #[arg(long, value_name = "T", value_parser = number, allow_negative_numbers = true)]
    pub end_time: Option<f64>,
    /// One backend only, beside the reference: reference, simd or wgpu [default: all]
    #[arg(long, value_name = "NAME")]
    pub backend: Option<Backend>,
    /// One precision only, beside the reference: f32 or f64 [default: all]
    #[arg(long)]
    pub precision: Option<Precision>,
}

/// `etalon scenes`.
#[derive(Clone, Debug, Args)]
pub struct ScenesArguments {
    /// Print this scene as a file, all its choices spelled out
    #[arg(value_name = "NAME")]
    pub scene: Option<Name>,
    /// In so many dimensions [default: the scene's usual ones]
    #[arg(long, value_name = "D", value_parser = dimension, allow_negative_numbers = true, requires = "scene")]
    pub dim: Option<usize>,
    /// Print the list as JSON
    #[arg(long, conflicts_with = "scene")]
    pub json: bool,
}

/// `etalon run`.
#[derive(Clone, Debug, Args)]
pub struct RunArguments {
    /// What to run.
    #[command(flatten)]
    pub scene: SceneArguments,
    /// Simulated time between two measurements of what the scene measures while it runs [default: a fiftieth of the whole]
    #[arg(long, value_name = "T", value_parser = number, allow_negative_numbers = true)]
    pub observe_every: Option<f64>,
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
    /// Seconds of wall-clock time between two restart files, in DIR.restart beside the report's folder: after an interruption the same command
    /// goes on from them. 0 for none
    #[arg(long, value_name = "SECONDS", default_value_t = USUAL_SECONDS, value_parser = number, allow_negative_numbers = true)]
    pub restart_every: f64,
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

/// What commands that make many runs have in common.
#[derive(Clone, Debug, Args)]
pub struct SweepArguments {
    /// Begin no run that would not end within so many minutes; the same command goes on later [default: 15 for `reproduce` at its usual sizes, else none]
    #[arg(long, value_name = "MINUTES", value_parser = number, allow_negative_numbers = true)]
    pub minutes: Option<f64>,
    /// Threads of the simd backend [default: all]
    #[arg(long, value_name = "N", value_parser = count, allow_negative_numbers = true)]
    pub threads: Option<usize>,
    /// Graphics adapter, by a part of its name [default: hardware before software]
    #[arg(long, value_name = "NAME")]
    pub adapter: Option<String>,
    /// Folder of the results; what is done already is found there [default: etalon-out/reproduce, etalon-out/pareto-SCENE-Dd]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

/// `etalon pareto`. Lists are separated by commas.
#[derive(Clone, Debug, Args)]
pub struct ParetoArguments {
    /// A scene that `etalon scenes` lists, or a file that describes one
    pub scene: String,
    /// Dimensions: 1, 2 or 3 [default: the scene's]
    #[arg(long, value_name = "D", value_parser = dimension, allow_negative_numbers = true)]
    pub dim: Option<usize>,
    /// Particle numbers [default: the scene's, and as many as are twice and four times as far apart]
    #[arg(long, value_name = "N,..", value_delimiter = ',', value_parser = count, allow_negative_numbers = true)]
    pub n: Vec<usize>,
    /// Dissipation schemes [default: AV,AVSLR,AVSLRB2]
    #[arg(long, value_name = "NAME,..", value_delimiter = ',')]
    pub scheme: Vec<Dissipation>,
    /// Kernels [default: the scene's]
    #[arg(long, value_name = "NAME,..", value_delimiter = ',')]
    pub kernel: Vec<Kernel>,
    /// Neighbours within a support [default: the scene's]
    #[arg(long, value_name = "N,..", value_delimiter = ',', value_parser = number, allow_negative_numbers = true)]
    pub neighbours: Vec<f64>,
    /// Precisions [default: f32,f64]
    #[arg(long, value_name = "NAME,..", value_delimiter = ',')]
    pub precision: Vec<Precision>,
    /// Backends [default: simd]
    #[arg(long, value_name = "NAME,..", value_delimiter = ',')]
    pub backend: Vec<Backend>,
    /// How particles start [default: the scene's]
    #[arg(long, value_name = "HOW")]
    pub start: Option<Arrangement>,
    /// Set a choice of the scene's own or of the method, as for `etalon run`
    #[arg(long, value_name = "KEY=VALUE", value_parser = setting)]
    pub set: Vec<(String, toml::Value)>,
    /// Simulated time to stop at [default: the scene's]
    #[arg(long, value_name = "T", value_parser = number, allow_negative_numbers = true)]
    pub end_time: Option<f64>,
    /// What is paid: seconds of wall clock, operations, or bytes of memory
    #[arg(long, value_name = "NAME", default_value = "seconds")]
    pub cost: Cost,
    /// The error: a field against the exact solution, or what the scene measures, at the end [default: the velocity]
    #[arg(long, value_name = "NAME")]
    pub error: Option<String>,
    /// How the runs are made.
    #[command(flatten)]
    pub sweep: SweepArguments,
}

/// `etalon reproduce`.
#[derive(Clone, Debug, Args)]
pub struct ReproduceArguments {
    /// Scenes [default: all with published numbers]
    #[arg(value_name = "SCENE")]
    pub scenes: Vec<Name>,
    /// The papers' dimensions and particle numbers (hours to days); the same command goes on after an interruption
    #[arg(long, conflicts_with_all = ["dim", "size"])]
    pub paper_resolution: bool,
    /// Dimensions: 1, 2 or 3 [default: as few as the flow has: 1 for tubes, 2 for what is plane]
    #[arg(long, value_name = "D", value_parser = dimension, allow_negative_numbers = true)]
    pub dim: Option<usize>,
    /// Particle numbers in units of each scene's usual one
    #[arg(long, value_name = "FACTOR", default_value = "1", value_parser = number, allow_negative_numbers = true)]
    pub size: f64,
    /// What runs them
    #[arg(long, value_name = "NAME", default_value = "simd")]
    pub backend: Backend,
    /// In which precision [default: f32; f64 for the dusty wave, which is too faint for less]
    #[arg(long, value_name = "NAME")]
    pub precision: Option<Precision>,
    /// How the runs are made.
    #[command(flatten)]
    pub sweep: SweepArguments,
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

/// A key and its value as TOML has it; what is no TOML is a word, so that quotes may be left out.
fn setting(text: &str) -> Result<(String, toml::Value), String> {
    let Some((key, value)) = text.split_once('=').map(|(key, value)| (key.trim(), value.trim())) else {
        return Err("give a key and a value, such as smoothed=true".into());
    };
    let parsed = format!("value = {value}").parse::<toml::Table>().ok().and_then(|mut table| table.remove("value"));
    Ok((key.to_string(), parsed.unwrap_or_else(|| toml::Value::String(value.to_string()))))
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
