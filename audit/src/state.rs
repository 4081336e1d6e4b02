//! The state of all equations: encoded, tested, measured, and what became worse since it was recorded.

mod survey;
mod table;

pub use survey::Survey;

use crate::budgets::Record;
use crate::catalogue::{Catalogue, Subject, is_host};
use crate::encoded::path_of;
use crate::measure::Measurement;
use crate::target::{Label, Target};
use etalon_kernels_gen::EquationEntry;
use etalon_spec::EquationId;
use serde::Serialize;
use std::collections::BTreeSet;

/// The state of the equations asked for.
#[derive(Clone, Debug, Serialize)]
pub struct State {
    /// How many random inputs were tried for each measurement, beside the hard ones.
    pub samples: usize,
    /// Whether nothing became worse.
    pub passed: bool,
    /// What did.
    pub regressions: Vec<Worse>,
    /// The numbered equations, paper by paper.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub equations: Vec<Row>,
    /// The definitions without a number.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub unnumbered: Vec<Row>,
}

/// Something that became worse.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(into = "String")]
pub struct Worse {
    /// The functions it concerns; for one that is gone its number.
    pub subject: String,
    /// What is wrong, and what to do.
    pub message: String,
}

impl From<Worse> for String {
    fn from(worse: Worse) -> Self {
        format!("{}: {}", worse.subject, worse.message)
    }
}

/// An equation.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// Its number, or the path of a definition without one.
    pub id: String,
    /// What it is called.
    pub title: String,
    /// What it is for; only of a numbered one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub kind: Option<String>,
    /// How sure our reading is; only of a numbered one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub confidence: Option<String>,
    /// Whether a function encodes it.
    pub encoded: bool,
    /// The functions that run on all targets.
    pub functions: Vec<String>,
    /// Those that run on the host only.
    pub host_functions: Vec<String>,
    /// Why no function encodes it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub not_encoded: Option<String>,
    /// How many tests exercise it.
    pub tests: usize,
    /// How many mutants a test noticed, and how many there are that are no faults.
    pub mutants_caught: usize,
    /// Mutants that all tests passed over: equivalent ones.
    pub mutants_equivalent: usize,
    /// What it can be run on or printed for.
    pub targets: Vec<String>,
    /// The largest error of its functions, by target.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub errors: Vec<Error>,
    /// Whether the ledger notes that the paper departs from physics, itself or published codes.
    pub deviation: bool,
    /// Whether the ledger has an open question.
    pub open_question: bool,
    /// `fit`, `fault`, or `unchecked` where no probe declares them.
    pub units: &'static str,
    /// Whether something became worse.
    pub regressed: bool,
}

/// The largest error on a target, in ulps of the natural scale.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Error {
    /// The target.
    pub target: &'static str,
    /// The device, where one ran it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub adapter: Option<String>,
    /// Whether it was measured now; if not, the figures are the recorded ones.
    pub measured: bool,
    /// The probe that it is in.
    pub probe: String,
    /// The error.
    pub worst: f64,
    /// How that is known.
    pub worst_label: Label,
    /// The bound that follows from the operations.
    pub budget: f64,
    /// How that is known.
    pub budget_label: Label,
    /// The error recorded for this probe.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub recorded_worst: Option<f64>,
    /// The budget recorded for it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub recorded_budget: Option<f64>,
}

impl State {
    /// What a survey means beside the records.
    #[must_use]
    pub fn of(catalogue: &Catalogue, survey: &Survey) -> Self {
        let (numbers, entries) = chosen(catalogue, survey.only.as_ref());
        let findings = Findings { survey, regressions: survey.regressions(catalogue) };
        let by_number = |id: &EquationId| {
            let functions: Vec<_> = catalogue.functions(*id).collect();
            let mut row = findings.row(catalogue, id.to_string(), &functions);
            let entry = catalogue.ledger.get(*id);
            row.title.clone_from(&entry.title);
            row.kind = Some(entry.kind.to_string());
            row.confidence = Some(entry.confidence.to_string());
            row.not_encoded = functions.is_empty().then(|| entry.kind.reason_not_encoded().to_string());
            row.deviation = entry.deviation.is_some();
            row.open_question = entry.open_question.is_some();
            row
        };
        let unnumbered = entries.iter().filter(|entry| entry.ids.is_empty());
        State {
            samples: survey.samples,
            passed: findings.regressions.is_empty(),
            equations: numbers.iter().map(by_number).collect(),
            unnumbered: unnumbered.map(|entry| findings.row(catalogue, path_of(entry), &[entry])).collect(),
            regressions: findings.regressions,
        }
    }
}

/// The numbers and functions that are asked for: a function brings its numbers, a number its functions.
fn chosen(catalogue: &Catalogue, only: Option<&Subject>) -> (Vec<EquationId>, Vec<&'static EquationEntry>) {
    match only {
        None => (EquationId::all().collect(), catalogue.entries.clone()),
        Some(Subject::Number(id)) => (vec![*id], catalogue.functions(*id).collect()),
        Some(Subject::Functions(entries)) => {
            let ids: BTreeSet<EquationId> =
                entries.iter().flat_map(|entry| entry.ids).filter_map(|id| id.parse().ok()).collect();
            (ids.into_iter().collect(), entries.clone())
        }
    }
}

/// What a survey found, and what of it is worse than recorded.
struct Findings<'a> {
    survey: &'a Survey,
    regressions: Vec<Worse>,
}

impl Findings<'_> {
    /// All that the functions have in common with a number.
    fn row(&self, catalogue: &Catalogue, id: String, functions: &[&'static EquationEntry]) -> Row {
        let paths_of = |host: bool| {
            let those = functions.iter().filter(move |entry| is_host(entry) == host);
            those.map(|entry| path_of(entry)).collect::<Vec<_>>()
        };
        let paths: Vec<String> = functions.iter().map(|entry| path_of(entry)).collect();
        let tests: BTreeSet<&String> = functions.iter().flat_map(|entry| catalogue.tests(entry)).collect();
        let mutants: Vec<_> = paths.iter().filter_map(|path| catalogue.reach.mutants(path)).collect();
        let errors: Vec<Error> =
            Target::ALL.into_iter().filter_map(|target| self.error(catalogue, &paths, target)).collect();
        let mut targets: Vec<String> = errors.iter().map(|error| error.target.to_string()).collect();
        let printed: BTreeSet<_> = paths.iter().filter_map(|path| self.survey.printed.get(path)).flatten().collect();
        targets.extend(printed.into_iter().map(ToString::to_string));
        if functions.iter().any(|entry| is_host(entry)) {
            targets.push("host".to_string());
        }
        let units: Vec<bool> = paths.iter().filter_map(|path| self.survey.units.get(path).copied()).collect();
        Row {
            title: functions.first().map_or(String::new(), |entry| entry.unnumbered.unwrap_or_default().to_string()),
            kind: None,
            confidence: None,
            encoded: !functions.is_empty(),
            functions: paths_of(false),
            host_functions: paths_of(true),
            not_encoded: None,
            tests: tests.len(),
            mutants_caught: mutants.iter().map(|mutants| mutants.caught).sum(),
            mutants_equivalent: mutants.iter().map(|mutants| mutants.passed_over).sum(),
            targets,
            errors,
            deviation: false,
            open_question: false,
            units: match (units.is_empty(), units.iter().all(|fit| *fit)) {
                (true, _) => "unchecked",
                (false, true) => "fit",
                (false, false) => "fault",
            },
            regressed: self.regressions.iter().any(|worse| worse.subject == id || paths.contains(&worse.subject)),
            id,
        }
    }
    /// The largest error of these functions on a target.
    fn error(&self, catalogue: &Catalogue, paths: &[String], target: Target) -> Option<Error> {
        // A key begins with the path, and goes on with a space or not at all.
        let is_of = |measurement: &&Measurement| {
            let path = measurement.probe.split(' ').next().unwrap_or_default();
            measurement.target == target && paths.iter().any(|known| known == path)
        };
        let measured = self.survey.measurements.iter().filter(is_of);
        let Some(worst) = measured.max_by(|a, b| a.of_scale.ulps.total_cmp(&b.of_scale.ulps)) else {
            return recorded(catalogue, paths, target);
        };
        let record = catalogue.budgets.counterpart(worst);
        Some(Error {
            target: target.name(),
            adapter: worst.device.as_ref().map(|device| device.adapter.clone()),
            measured: true,
            probe: worst.probe.clone(),
            worst: worst.of_scale.ulps,
            worst_label: Label::Measured,
            budget: worst.budget,
            budget_label: target.budget_label(),
            recorded_worst: record.map(|record| record.worst),
            recorded_budget: record.map(|record| record.budget),
        })
    }
}

/// The largest recorded error of these functions on a target that only a device can run, which is not here.
fn recorded(catalogue: &Catalogue, paths: &[String], target: Target) -> Option<Error> {
    let is_of = |record: &&Record| {
        let path = record.probe.split(' ').next().unwrap_or_default();
        record.adapter.is_some() && record.target == target.name() && paths.iter().any(|known| known == path)
    };
    let records = catalogue.budgets.records.iter().filter(is_of).filter(|record| record.is_of_this_text());
    let worst = records.max_by(|a, b| a.worst.total_cmp(&b.worst))?;
    Some(Error {
        target: target.name(),
        adapter: worst.adapter.clone(),
        measured: false,
        probe: worst.probe.clone(),
        worst: worst.worst,
        worst_label: worst.worst_label,
        budget: worst.budget,
        budget_label: worst.budget_label,
        recorded_worst: Some(worst.worst),
        recorded_budget: Some(worst.budget),
    })
}
