//! The JSON form: the report inside an envelope that names its schema and the files beside it.

use std::io;

use serde::{Deserialize, Serialize};
use serde_json::Value;
use serde_json::ser::{Formatter, PrettyFormatter, Serializer};

use super::check::check;
use super::{Report, ReportError};

/// Value of the key `schema` in every report.
pub const SCHEMA: &str = "etalon-report";

/// Value of the key `schema_version`: raised when a key changes its meaning or disappears; new keys do not raise it.
pub const SCHEMA_VERSION: u32 = 1;

/// A report as written.
#[derive(Serialize)]
struct Written<'a> {
    schema: &'a str,
    schema_version: u32,
    files: &'a [&'a str],
    #[serde(flatten)]
    report: &'a Report,
}

/// What every version of the schema has: enough to recognise a report.
#[derive(Deserialize)]
pub(super) struct Envelope {
    /// [`SCHEMA`].
    pub(super) schema: String,
    /// Version it was written in.
    pub(super) schema_version: u32,
    /// Names of all files written into the same folder.
    #[serde(default)]
    pub(super) files: Vec<String>,
}

/// The report as pretty-printed JSON, with the names of the `files` that lie beside it.
///
/// # Errors
/// [`ReportError::NotFinite`] names the first number that is NaN or infinite, [`ReportError::Inconsistent`] the first
/// contradiction.
pub fn to_json(report: &Report, files: &[&str]) -> Result<String, ReportError> {
    check(report)?;
    let written = Written { schema: SCHEMA, schema_version: SCHEMA_VERSION, files, report };
    let mut text = Vec::new();
    let mut serializer = Serializer::with_formatter(&mut text, Layout(PrettyFormatter::new()));
    let unwritable = |problem: String| ReportError::Unreadable { problem };
    written.serialize(&mut serializer).map_err(|error| unwritable(error.to_string()))?;
    text.push(b'\n');
    String::from_utf8(text).map_err(|error| unwritable(error.to_string()))
}

/// A key a line, but lists without line breaks: a profile is one long line instead of a thousand short ones.
struct Layout(PrettyFormatter<'static>);

impl Formatter for Layout {
    fn begin_array_value<W: ?Sized + io::Write>(&mut self, out: &mut W, first: bool) -> io::Result<()> {
        out.write_all(if first { b"" } else { b", " })
    }

    fn begin_object<W: ?Sized + io::Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.0.begin_object(out)
    }

    fn end_object<W: ?Sized + io::Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.0.end_object(out)
    }

    fn begin_object_key<W: ?Sized + io::Write>(&mut self, out: &mut W, first: bool) -> io::Result<()> {
        self.0.begin_object_key(out, first)
    }

    fn begin_object_value<W: ?Sized + io::Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.0.begin_object_value(out)
    }

    fn end_object_value<W: ?Sized + io::Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.0.end_object_value(out)
    }
}

/// Reads what [`to_json`] wrote.
///
/// # Errors
/// [`ReportError::Unreadable`] if the text is not JSON, not a report, or a report of another schema version.
pub fn from_json(text: &str) -> Result<Report, ReportError> {
    let unreadable = |problem: String| ReportError::Unreadable { problem };
    let envelope = envelope(text)?;
    if envelope.schema_version != SCHEMA_VERSION {
        let found = envelope.schema_version;
        return Err(unreadable(format!(
            "it has schema version {found}, this program reads version {SCHEMA_VERSION}: make it again with `etalon run`"
        )));
    }
    let report: Report = serde_json::from_str(text).map_err(|error| unreadable(error.to_string()))?;
    check(&report)?;
    Ok(report)
}

/// Reads no more than says what a text is.
pub(super) fn envelope(text: &str) -> Result<Envelope, ReportError> {
    let unreadable = |problem: String| ReportError::Unreadable { problem };
    let envelope: Envelope = serde_json::from_str(text).map_err(|error| unreadable(error.to_string()))?;
    if envelope.schema != SCHEMA {
        return Err(unreadable(format!("its schema is `{}`, not `{SCHEMA}`", envelope.schema)));
    }
    Ok(envelope)
}

/// Finds the first number of a report that JSON cannot hold.
///
/// serde_json turns NaN and infinities into `null`, and the model never writes a `null` otherwise (absent options are
/// left out), so a `null` *is* such a number; the place where it stands names it.
pub(super) fn first_not_finite(report: &Report) -> Option<String> {
    // A plain data model cannot fail to become a value; if it did, there would be no number to name.
    let mut value = serde_json::to_value(report).ok()?;
    // Runs are named by two keys; the rest of the model by one.
    for (run, entry) in report.runs.iter().zip(value.get_mut("runs")?.as_array_mut()?) {
        entry["name"] = Value::String(run.label());
    }
    find_null(&value, String::new())
}

/// The path of the first `null` at or below `value`, which itself stands at `path`.
fn find_null(value: &Value, path: String) -> Option<String> {
    match value {
        Value::Null => Some(path),
        Value::Array(items) => items.iter().enumerate().find_map(|(index, item)| {
            let name = ["name", "field", "quantity", "function"].iter().find_map(|key| item.get(key)?.as_str());
            find_null(item, format!("{path}[{}]", name.map_or_else(|| index.to_string(), str::to_owned)))
        }),
        Value::Object(map) => map.iter().find_map(|(key, item)| {
            find_null(item, if path.is_empty() { key.clone() } else { format!("{path}.{key}") })
        }),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::super::model::Outcome;
    use super::super::synthetic;
    use super::*;

    #[test]
    fn round_trip_is_exact() {
        let report = synthetic::report();
        let text = to_json(&report, &["report.json"]).unwrap();
        // Equality of the floats bit by bit, hence of everything computed from them.
        assert_eq!(from_json(&text).unwrap(), report);
    }

    #[test]
    fn the_envelope_names_the_schema() {
        let text = to_json(&synthetic::report(), &["report.json", "report.html"]).unwrap();
        let value: Value = serde_json::from_str(&text).unwrap();
        assert_eq!(value["schema"], "etalon-report");
        assert_eq!(value["schema_version"], 1);
        assert_eq!(value["files"][1], "report.html");
        assert!(value["runs"][0]["outcome"]["ran"]["speed"]["nanoseconds_per_update"].is_f64());
        assert!(value["runs"][3]["outcome"]["skipped"]["reason"].is_string());
    }

    #[test]
    fn every_key_is_documented() {
        const PAGE: &str = include_str!("../../docs/report-schema.md");
        fn visit(value: &Value) {
            match value {
                Value::Array(items) => items.iter().for_each(visit),
                Value::Object(map) => map.iter().for_each(|(key, item)| {
                    let named = PAGE.contains(&format!("`{key}`")) || PAGE.contains(&format!("\"{key}\""));
                    assert!(named, "docs/report-schema.md does not say what `{key}` is");
                    visit(item);
                }),
                _ => {}
            }
        }
        visit(&serde_json::from_str(&to_json(&synthetic::report(), &[]).unwrap()).unwrap());
    }

    #[test]
    fn other_schemas_and_versions_are_refused() {
        let text = to_json(&synthetic::report(), &[]).unwrap();
        let message = |text: &str| from_json(text).unwrap_err().to_string();
        let newer = text.replacen("\"schema_version\": 1", "\"schema_version\": 2", 1);
        assert!(message(&newer).contains("schema version 2"), "{}", message(&newer));
        let foreign = text.replacen("etalon-report", "benchmark", 1);
        assert!(message(&foreign).contains("`benchmark`"), "{}", message(&foreign));
        assert!(message("{}").contains("schema"), "{}", message("{}"));
        assert!(message("no json").contains("not a readable report"));
    }

    #[test]
    fn a_number_that_is_not_finite_is_named() {
        for bad in [f64::NAN, f64::INFINITY] {
            let mut report = synthetic::report();
            let Outcome::Ran(measured) = &mut report.runs[1].outcome else { panic!("the synthetic SIMD run ran") };
            measured.profile.fields[2].value[17] = bad;
            let message = to_json(&report, &[]).unwrap_err().to_string();
            assert!(
                message.contains("runs[SIMD f64].outcome.ran.profile.fields[pressure].value[17] is not a finite"),
                "{message}"
            );
        }
    }

    #[test]
    fn every_optional_part_may_be_absent() {
        // Would notice an `Option` without `skip_serializing_if`: its `null` would pass for a NaN.
        let mut report = synthetic::report();
        report.machine.adapter = None;
        for run in &mut report.runs {
            if let Outcome::Ran(measured) = &mut run.outcome {
                measured.speed.updates_per_second_per_core = None;
                measured.speed.updates_per_gflop = None;
                measured.speed.speed_up = None;
                for conserved in &mut measured.conservation {
                    conserved.tolerance = None;
                    conserved.note = None;
                }
            }
        }
        assert_eq!(from_json(&to_json(&report, &[]).unwrap()).unwrap(), report);
    }
}
