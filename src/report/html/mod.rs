//! The page: one file with everything in it, no scripts, nothing fetched.
//!
//! | file | part of the page |
//! |---|---|
//! | `summary.rs` | headline, summary table |
//! | `errors.rs` | the three sources of error and their tables |
//! | `series.rs`, `ending.rs` | what the scene measures on the way, and at the end |
//! | `speed.rs` | time by stage, rates, memory |
//! | `setting.rs` | scene, machine, how to repeat it |
//! | `parts.rs` | table, figure, and the escaping of text |

mod ending;
mod errors;
mod parts;
mod series;
mod setting;
mod speed;
mod summary;

pub(super) use parts::escape;

use super::model::Report;
use super::plot::{Plot, theme};

/// The styles of the page.
const STYLE: &str = include_str!("style.css");

/// The page of a report that has passed [`crate::report::check`], with its plots drawn into it. `files` are the names
/// of all files that lie beside it.
pub fn page(report: &Report, plots: &[Plot], files: &[&str]) -> String {
    let title = escape(&format!("{}: etalon report", report.scene.title));
    let sections = [
        summary::table(report),
        errors::accuracy(report, plots),
        series::measured(report, plots),
        ending::measured(report, plots),
        errors::sources(report, plots),
        errors::conservation(report),
        speed::section(report, plots),
        setting::section(report),
        setting::reproduce(report, files),
    ];
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{title}</title>\n\
         <style>\n{STYLE}{}{}</style>\n\
         </head>\n<body>\n{}<main>\n{}{}</main>\n</body>\n</html>\n",
        colours(),
        theme::style_sheet(),
        summary::header(report),
        sections.concat(),
        setting::footer(report)
    )
}

/// Classes for the colours of runs and stages.
fn colours() -> String {
    let rules = |pick: fn(&theme::Pair) -> theme::Colour| {
        let named = |name: &str, (index, pair): (usize, &theme::Pair)| {
            format!(".{name}{index}{{color:{}}}", theme::hex(pick(pair)))
        };
        let runs = theme::RUNS.iter().enumerate().map(|entry| named("run", entry));
        let stages = theme::STAGES.iter().enumerate().map(|entry| named("stage", entry));
        runs.chain(stages).collect::<String>()
    };
    let (light, dark) = (rules(|pair| pair.light), rules(|pair| pair.dark));
    format!("{light}\n@media screen and (prefers-color-scheme:dark){{{dark}}}\n")
}

#[cfg(test)]
mod tests {
    use super::super::{model::Outcome, plots, synthetic};
    use super::*;

    fn rendered(report: &Report) -> String {
        page(report, &plots(report).unwrap(), &["report.json", "particles.csv"])
    }

    #[test]
    fn everything_the_report_knows_is_on_the_page() {
        let report = synthetic::report();
        let html = rendered(&report);
        for field in &report.fields {
            assert!(html.contains(&field.label) && html.contains(&escape(&field.unit)), "{}", field.name);
        }
        for run in &report.runs {
            assert!(html.contains(&run.label()), "{}", run.label());
        }
        for expected in [
            "7.21×10⁻³",
            "no graphics adapter found",
            "integral-approach matrix",
            "mixed sinc kernel w(q)",
            "Example CPU @ 2.75 GHz",
            "GS25, Eq. 20",
            "√(214 steps",
            "etalon run sod --dim 3",
            "particles.csv",
            "momentum",
        ] {
            assert!(html.contains(expected), "missing: {expected}");
        }
        assert_eq!(html.matches("<svg").count(), 8);
    }

    #[test]
    fn nothing_is_fetched_or_executed() {
        let html = rendered(&synthetic::complete());
        for forbidden in ["<script", "<link", "<img", "<iframe", "href=", "src=", "url(", "@import", "onload"] {
            assert!(!html.contains(forbidden), "{forbidden}");
        }
        // The only address is the name of the SVG language.
        assert_eq!(html.matches("http").count(), html.matches("http://www.w3.org/2000/svg").count());
    }

    #[test]
    fn text_is_escaped_wherever_it_comes_from() {
        let mut report = synthetic::report();
        let evil = "<b>&\"'";
        report.program_version = evil.into();
        report.created = evil.into();
        report.command = evil.into();
        let scene = &mut report.scene;
        let setting = &mut scene.settings[0];
        let approximation = &mut report.kernel_approximation[0];
        for text in [
            &mut scene.name,
            &mut scene.title,
            &mut scene.kernel,
            &mut scene.scheme,
            &mut scene.arrangement,
            &mut scene.discontinuity,
            &mut scene.boundaries,
            &mut scene.norm.coordinate,
            &mut scene.norm.unit,
            &mut scene.norm.source,
            &mut setting.name,
            &mut setting.value,
            &mut report.machine.cpu,
            &mut report.machine.instruction_set,
            &mut report.machine.system,
            &mut approximation.function,
            &mut approximation.approximation,
            &mut approximation.precision,
            &mut approximation.tolerance.source,
        ] {
            *text = evil.into();
        }
        report.machine.adapter = Some(evil.into());
        for field in &mut report.fields {
            (field.label, field.symbol, field.unit) = (evil.into(), evil.into(), evil.into());
        }
        for run in &mut report.runs {
            match &mut run.outcome {
                Outcome::Skipped { reason } => *reason = evil.into(),
                Outcome::Ran(measured) => {
                    measured.stages[0].name = evil.into();
                    measured.conservation[1].quantity = evil.into();
                    measured.conservation[1].note = Some(evil.into());
                    measured.profile.selection = evil.into();
                    for difference in &mut measured.arithmetic_difference {
                        difference.tolerance.source = evil.into();
                    }
                }
            }
        }
        report.runs[1].precision = evil.into();
        let html = rendered(&report);
        assert!(!html.contains("<b>"), "raw markup came through");
        assert!(html.contains("&lt;b&gt;&amp;&quot;&#39;"));
        assert!(!html.contains("&amp;lt;"), "escaped twice");
    }

    #[test]
    fn elements_are_balanced() {
        let html = rendered(&synthetic::complete());
        let mut open: Vec<&str> = Vec::new();
        for tag in html.split('<').skip(2) {
            let tag = tag.split('>').next().unwrap();
            let name = tag.split([' ', '\n']).next().unwrap();
            match name.strip_prefix('/') {
                Some(name) => assert_eq!(open.pop(), Some(name), "{tag}"),
                None if tag.ends_with('/') || name == "meta" => {}
                None => open.push(name),
            }
        }
        assert!(open.is_empty(), "{open:?}");
    }

    #[test]
    fn a_failure_shows() {
        let mut report = synthetic::report();
        assert!(!rendered(&report).contains("class=\"verdict fail\""));
        let Outcome::Ran(measured) = &mut report.runs[2].outcome else { panic!("the synthetic SIMD run ran") };
        measured.arithmetic_difference[2].pass = false;
        assert!(rendered(&report).contains("class=\"verdict fail\""));
    }

    #[test]
    fn a_report_of_skips_is_still_a_page() {
        let mut report = synthetic::report();
        report.runs.drain(..3);
        assert!(rendered(&report).contains("Nothing was measured"));
    }
}
