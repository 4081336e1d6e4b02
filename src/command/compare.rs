//! `etalon compare`: two snapshots, ours or another code's.

use super::arguments::CompareArguments;
use super::failure::Failure;
use super::{Done, to_text};
use crate::report::{self, Curve, Plot, Words, plain};
use crate::snapshot::compare::{Along, Comparison, Options, Profile, compare as comparison};
use crate::snapshot::{Format, Snapshot};
use serde_json::{Value, json};
use std::fmt::Write;
use std::fs;
use std::path::Path;

/// The file by which a folder of ours is recognised.
const JSON: &str = "compare.json";
/// What it says it is.
const SCHEMA: &str = "etalon-compare";
const SCHEMA_VERSION: u64 = 1;

/// Reads both, compares, and prints a table or JSON; fails where a field differs by more than a tolerance that was given.
pub fn compare(arguments: &CompareArguments) -> Result<Done, Failure> {
    if arguments.tolerance.is_some_and(|tolerance| tolerance < 0.0) {
        return Err(Failure::BadInput("--tolerance: it must not be negative".into()));
    }
    if let Some(folder) = &arguments.out {
        check_folder(folder)?;
    }
    let (mut a, mut b) = (Side::read(&arguments.first)?, Side::read(&arguments.second)?);
    if a.name == b.name {
        // Two runs of one kind name their files alike.
        [a.name, b.name] = [&a, &b].map(|side| side.path.display().to_string());
    }
    let options = Options {
        by: arguments.by,
        within: arguments.within,
        along: arguments.along,
        centre: arguments.centre.clone(),
        bins: arguments.bins,
    };
    let found = comparison(&a.snapshot, &b.snapshot, &options)?;
    let beyond = arguments.tolerance.map(|tolerance| (tolerance, found.beyond(tolerance)));
    let document = document(&a, &b, &found, beyond.as_ref())?;
    if let Some(folder) = &arguments.out {
        write(folder, &document, &plots(&a, &b, &found, arguments.along)?)?;
    }
    let passed = beyond.as_ref().is_none_or(|(_, names)| names.is_empty());
    let text = if arguments.json {
        to_text(&document)?
    } else {
        table(&a, &b, &found, beyond.as_ref(), arguments.out.as_deref())
    };
    Ok(Done { text, passed })
}

/// A snapshot and where it is from.
struct Side<'a> {
    path: &'a Path,
    /// For legends: the file's name, without its folders if that tells both sides apart.
    name: String,
    format: Format,
    snapshot: Snapshot,
}

impl<'a> Side<'a> {
    fn read(path: &'a Path) -> Result<Self, Failure> {
        let name = path.file_name().map_or_else(|| path.display().to_string(), |name| name.to_string_lossy().into());
        Ok(Side { path, name, format: Format::of_file(path)?, snapshot: Snapshot::read(path)? })
    }

    fn json(&self) -> Value {
        let mut value = json!({
            "path": self.path.display().to_string(),
            "format": self.format.name(),
            "particles": self.snapshot.len(),
        });
        if let Some(time) = self.snapshot.time() {
            value["time"] = json!(time);
        }
        value
    }

    fn line(&self) -> String {
        let time = self.snapshot.time().map_or_else(|| "time unknown".into(), |time| format!("t = {time}"));
        format!("{}: {}, {} particles, {time}", self.path.display(), self.format, self.snapshot.len())
    }
}

type Beyond = (f64, Vec<String>);

fn document(a: &Side, b: &Side, found: &Comparison, beyond: Option<&Beyond>) -> Result<Value, Failure> {
    let mut document = json!({ "schema": SCHEMA, "schema_version": SCHEMA_VERSION, "a": a.json(), "b": b.json() });
    super::extend(&mut document, found)?;
    if let Some((tolerance, names)) = beyond {
        document["tolerance"] = json!({ "value": tolerance, "beyond": names, "passed": names.is_empty() });
    }
    Ok(document)
}

/// For a terminal: what was compared, one line a field, what is not in both.
fn table(a: &Side, b: &Side, found: &Comparison, beyond: Option<&Beyond>, folder: Option<&Path>) -> String {
    let mut text = format!("A  {}\nB  {}\n", a.line(), b.line());
    let mut line = |words: String| {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{words}");
    };
    if let Some(matched) = &found.matched {
        let within = matched.within.map_or_else(String::new, |within| format!(" within {}", plain(within)));
        let rest = match (matched.unmatched_a, matched.unmatched_b) {
            (0, 0) => "all".into(),
            (of_a, of_b) => format!("{of_a} only in A, {of_b} only in B"),
        };
        line(format!("{} pairs by {}{within}; {rest}\n", matched.pairs, found.by));
        let head = ["field", "scale", "rms", "L1", "max", "at id", "position"].map(String::from);
        let row = |field: &crate::snapshot::compare::FieldDifference| {
            let position: Vec<String> = field.at.position.iter().map(|x| plain(*x)).collect();
            [
                field.name.clone(),
                with_unit(field.scale, &field.unit),
                plain(field.relative_rms),
                plain(field.relative_l1),
                plain(field.relative_max),
                field.at.id.to_string(),
                position.join(", "),
            ]
        };
        line(aligned(std::iter::once(head).chain(found.fields.iter().map(row)).collect()));
    }
    line(format!(
        "profiles along {}, means of {} intervals\n",
        found.along,
        found.profiles.first().map_or(0, |p| p.bins.len())
    ));
    let head = ["field", "scale", "rms", "L1", "max", "at"].map(String::from);
    let row = |profile: &Profile| {
        [
            profile.name.clone(),
            with_unit(profile.scale, &profile.unit),
            plain(profile.relative_rms),
            plain(profile.relative_l1),
            plain(profile.relative_max),
            plain(profile.at),
        ]
    };
    line(aligned(std::iter::once(head).chain(found.profiles.iter().map(row)).collect()));
    line("Differences (B - A) are in units of the field's scale.".into());
    for (names, side) in [(&found.only_in_a, "A"), (&found.only_in_b, "B")] {
        if !names.is_empty() {
            line(format!("only in {side}, not compared: {}", names.join(", ")));
        }
    }
    match beyond {
        Some((tolerance, names)) if names.is_empty() => line(format!("within {tolerance}: every field")),
        Some((tolerance, names)) => line(format!("FAIL beyond {tolerance}: {}", names.join(", "))),
        None => {}
    }
    if let Some(folder) = folder {
        line(format!("plots and {JSON} in {}", folder.display()));
    }
    text
}

fn with_unit(value: f64, unit: &str) -> String {
    if unit.is_empty() { plain(value) } else { format!("{} {unit}", plain(value)) }
}

/// Lines whose columns begin below each other.
fn aligned<const N: usize>(rows: Vec<[String; N]>) -> String {
    let width: [usize; N] = std::array::from_fn(|k| rows.iter().map(|row| row[k].chars().count()).max().unwrap_or(0));
    let line = |row: &[String; N]| {
        let cells = row.iter().zip(width).map(|(cell, width)| format!("{cell:width$}"));
        cells.collect::<Vec<_>>().join("  ").trim_end().to_string() + "\n"
    };
    rows.iter().map(line).collect()
}

/// Both profiles and their difference, for each field.
fn plots(a: &Side, b: &Side, found: &Comparison, along: Along) -> Result<Vec<Plot>, Failure> {
    let mut plots = Vec::new();
    for profile in &found.profiles {
        let of = |side: &Side, value: &dyn Fn(&crate::snapshot::compare::Bin) -> Option<[f64; 2]>| Curve {
            label: side.name.clone(),
            points: profile
                .bins
                .iter()
                .filter_map(|bin| value(bin).map(|[y, scatter]| [bin.middle(), y, scatter]))
                .collect(),
        };
        let curves =
            [of(a, &|bin| bin.a.map(|v| [v.mean, v.scatter])), of(b, &|bin| bin.b.map(|v| [v.mean, v.scatter]))];
        let unit = if profile.unit.is_empty() { String::new() } else { format!(" [{}]", profile.unit) };
        let title = format!("{}{unit}", profile.name);
        let file = format!("profile_{}.svg", profile.name);
        let caption = "Means of the particles in each interval; bars are their scatter.";
        plots.push(report::curves(Words { file: &file, title: &title, caption, x_label: along.name() }, &curves)?);
        let title = format!("{}: difference{unit}", profile.name);
        let file = format!("difference_{}.svg", profile.name);
        let difference =
            Curve { label: format!("{} - {}", b.name, a.name), ..of(b, &|bin| bin.difference().map(|d| [d, 0.0])) };
        let caption = "Difference of the means, where both have particles.";
        plots
            .push(report::curves(Words { file: &file, title: &title, caption, x_label: along.name() }, &[difference])?);
    }
    Ok(plots)
}

/// Whether the folder is new, empty, or one of ours.
fn check_folder(folder: &Path) -> Result<(), Failure> {
    let refused = |problem: &str| Err(Failure::BadInput(format!("--out {}: {problem}", folder.display())));
    match fs::read_dir(folder).map(|mut entries| entries.next().is_some()) {
        Ok(true) if !folder.join(JSON).is_file() => {
            refused("it is not empty and holds no comparison; name another folder")
        }
        Err(error) if error.kind() != std::io::ErrorKind::NotFound => refused(&format!("it cannot be used ({error})")),
        _ => Ok(()),
    }
}

/// Writes plots and JSON, each complete or not at all; plots of an earlier comparison are removed first.
fn write(folder: &Path, document: &Value, plots: &[Plot]) -> Result<(), Failure> {
    let failed = |error: std::io::Error| {
        Failure::BadInput(format!("--out {}: it cannot be written ({error})", folder.display()))
    };
    fs::create_dir_all(folder).map_err(failed)?;
    for entry in fs::read_dir(folder).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let ours = name.ends_with(".svg") && ["profile_", "difference_"].iter().any(|prefix| name.starts_with(prefix));
        if ours {
            fs::remove_file(&path).map_err(failed)?;
        }
    }
    for plot in plots {
        crate::snapshot::write_file(&folder.join(&plot.file), plot.svg().as_bytes())?;
    }
    Ok(crate::snapshot::write_file(&folder.join(JSON), to_text(document)?.as_bytes())?)
}
