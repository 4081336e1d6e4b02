//! The top of the page: what was run, what came out, and the table that the terminal shows too.

use super::super::model::{Outcome, Report};
use super::super::number::{count, short, times};
use super::super::plot::key_label;
use super::super::verdict::{Verdict, failures, headline, key_error};
use super::parts::{Head, escape, maybe, number, run_heading, section, table as html_table};

/// Title, setting in one line, verdict and headline.
pub(super) fn header(report: &Report) -> String {
    let scene = &report.scene;
    let subtitle = format!(
        "{}-D, {} particles, {} neighbours, kernel {}, scheme {}, to t = {}",
        scene.dimension,
        count(scene.particles),
        short(scene.neighbours),
        scene.kernel,
        scene.scheme,
        short(scene.end_time)
    );
    let (class, word) = match Verdict::on(report) {
        Verdict::Pass => ("pass", "within tolerance"),
        Verdict::Fail => ("fail", "outside tolerance"),
        Verdict::Incomplete => ("incomplete", "not compared"),
    };
    let failures = failures(report);
    let list = if failures.len() < 2 {
        String::new()
    } else {
        let items: String = failures.iter().map(|failure| format!("<li>{}</li>", escape(failure))).collect();
        format!("<ul class=\"failures\">{items}</ul>\n")
    };
    format!(
        "<header>\n<p class=\"mark\">Etalon report</p>\n<h1>{}</h1>\n<p class=\"subtitle\">{}</p>\n\
         <div class=\"headline\"><span class=\"verdict {class}\">{word}</span>\n<p>{}</p>\n{list}</div>\n</header>\n",
        escape(&scene.title),
        escape(&subtitle),
        escape(&headline(report))
    )
}

/// One row a run.
pub(super) fn table(report: &Report) -> String {
    let heads = [
        Head("Run", "", false),
        Head(&key_label(report), "against exact solution", true),
        Head("Difference", "to reference / field’s scale", true),
        Head("Tolerance", "", true),
        Head("Time", "ns per particle update", true),
        Head("Speed-up", "over reference", true),
    ];
    let mut rows = String::new();
    for (index, run) in report.runs.iter().enumerate() {
        let heading = run_heading(index, run);
        rows += &match &run.outcome {
            Outcome::Skipped { reason } => {
                let columns = heads.len() - 1;
                format!(
                    "<tr class=\"skipped\">{heading}<td colspan=\"{columns}\">skipped: {}</td></tr>\n",
                    escape(reason)
                )
            }
            Outcome::Ran(measured) => {
                let worst = measured.worst_difference();
                format!(
                    "<tr>{heading}{}{}{}{}<td class=\"n\">{}</td></tr>\n",
                    maybe(key_error(report, measured).map(|error| error.l1)),
                    maybe(worst.map(|worst| worst.compared())),
                    maybe(worst.map(|worst| worst.tolerance.value)),
                    number(measured.speed.nanoseconds_per_update),
                    measured.speed.speed_up.map_or_else(|| "–".into(), times)
                )
            }
        };
    }
    section("Summary", "", &html_table(&heads, &rows))
}
