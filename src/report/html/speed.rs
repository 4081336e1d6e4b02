//! How fast, and where the time goes.

use super::super::model::{Report, Stage};
use super::super::number::{count, typeset};
use super::super::plot::{Plot, theme};
use super::parts::{self, Head, escape, figure, figures, maybe, number, run_heading, table};

/// Charts, rates, and time by stage.
fn content(report: &Report, plots: &[Plot]) -> String {
    let shown = [figure(plots, "time.svg"), figure(plots, "speed_and_error.svg")];
    let peak = report.machine.fma_peak_gflops_per_core;
    let peak = format!(
        "Measured FMA peak of one core: {} GFLOP/s in f32, {} GFLOP/s in f64.",
        typeset(peak.f32),
        typeset(peak.f64)
    );
    format!(
        "{}<h3>Rates</h3>\n{}<p class=\"below\">{}</p>\n<h3>Time by stage</h3>\n{}",
        figures(&shown),
        rates(report),
        escape(&peak),
        stages(report)
    )
}

/// The section, if anything was timed.
pub(super) fn section(report: &Report, plots: &[Plot]) -> String {
    if report.measured().next().is_none() {
        return String::new();
    }
    let lead = "Wall-clock times of the steps alone, without set-up and comparison. They depend on the machine and on what \
                else it was doing: compare within this report.";
    parts::section("How fast?", lead, &content(report, plots))
}

/// One row a run.
fn rates(report: &Report) -> String {
    let heads = [
        Head("Run", "", false),
        Head("Threads", "", true),
        Head("Steps", "", true),
        Head("Wall clock", "s", true),
        Head("Time", "ns per particle update", true),
        Head("Updates/s", "per core", true),
        Head("Updates/s per GFLOP/s", "per core, of FMA peak", true),
        Head("Work", "operations per update", true),
        Head("Memory", "bytes per particle", true),
    ];
    let rows: String = report
        .measured()
        .map(|(index, run, measured)| {
            let speed = &measured.speed;
            format!(
                "<tr>{}<td class=\"n\">{}</td><td class=\"n\">{}</td>{}{}{}{}{}{}</tr>\n",
                run_heading(index, run),
                measured.threads,
                count(measured.steps),
                number(measured.wall_seconds),
                number(speed.nanoseconds_per_update),
                maybe(speed.updates_per_second_per_core),
                maybe(speed.updates_per_gflop),
                number(measured.operations_per_update),
                number(measured.bytes_per_particle)
            )
        })
        .collect();
    table(&heads, &rows)
}

/// Stages in rows; two columns a run, nanoseconds a particle update and the share; and the number of calls.
fn stages(report: &Report) -> String {
    let mut names: Vec<&str> = Vec::new();
    for stage in report.measured().flat_map(|(_, _, measured)| &measured.stages) {
        if !names.contains(&stage.name.as_str()) {
            names.push(&stage.name);
        }
    }
    if names.is_empty() {
        return String::new();
    }
    let labels: Vec<String> = report.measured().map(|(_, run, _)| run.label()).collect();
    let mut heads = vec![Head("Stage", "", false)];
    for label in &labels {
        heads.push(Head(label, "ns per update", true));
        heads.push(Head("", "share", true));
    }
    heads.push(Head("Calls", "", true));
    let mut rows = String::new();
    for (place, &name) in names.iter().enumerate() {
        rows += &format!("<tr><th scope=\"row\">{}{}</th>", swatch(place), escape(name));
        for (_, _, measured) in report.measured() {
            let whole: f64 = measured.stages.iter().map(|stage| stage.seconds).sum();
            rows += &match measured.stages.iter().find(|stage| stage.name == name) {
                None => "<td class=\"n\">–</td><td class=\"n\">–</td>".into(),
                Some(stage) => {
                    // The run's own time an update, split as its wall clock is.
                    let part = stage.seconds / measured.wall_seconds * measured.speed.nanoseconds_per_update;
                    let share = if whole > 0.0 { 100.0 * stage.seconds / whole } else { 0.0 };
                    format!("{}<td class=\"n\">{share:.0} %</td>", number(part))
                }
            };
        }
        rows += &format!("<td class=\"n\">{}</td></tr>\n", calls(report, name));
    }
    shares(report, &names) + &table(&heads, &rows)
}

/// How often a stage was called: one number if all runs agree, otherwise one a run.
fn calls(report: &Report, name: &str) -> String {
    let stages = report.measured().flat_map(|(_, _, measured)| &measured.stages);
    let mut counts: Vec<String> = stages.filter(|stage| stage.name == name).map(|stage| count(stage.count)).collect();
    counts.dedup();
    counts.join(", ")
}

/// One bar a run: the share of each stage in its time.
fn shares(report: &Report, names: &[&str]) -> String {
    let mut bars = String::new();
    for (_, run, measured) in report.measured() {
        let whole: f64 = measured.stages.iter().map(|stage| stage.seconds).sum();
        let part = |stage: &Stage| {
            let place = names.iter().position(|name| *name == stage.name).unwrap_or(0) % theme::STAGES.len();
            let width = 100.0 * stage.seconds / whole;
            format!("<i class=\"stage{place}\" style=\"width:{width:.2}%\" title=\"{}\"></i>", escape(&stage.name))
        };
        if whole > 0.0 {
            let parts: String = measured.stages.iter().map(part).collect();
            bars += &format!("<dt>{}</dt><dd>{parts}</dd>\n", escape(&run.label()));
        }
    }
    let legend: String = names
        .iter()
        .enumerate()
        .map(|(place, name)| format!("<span>{}{}</span>\n", swatch(place), escape(name)))
        .collect();
    format!("<div class=\"card shares\">\n<p>{legend}</p>\n<dl>\n{bars}</dl>\n</div>\n")
}

/// The colour of a stage.
fn swatch(place: usize) -> String {
    format!("<span class=\"swatch stage{}\"></span>", place % theme::STAGES.len())
}
