//! What was run on what, and how to run it again.

use super::super::model::Report;
use super::super::number::{count, short, typeset};
use super::parts::{self, escape, facts};

/// Scene and machine side by side.
pub(super) fn section(report: &Report) -> String {
    let scene = &report.scene;
    let row = |name: &str, value: String| (name.to_owned(), value);
    let mut scene_rows = vec![
        row("Scene", format!("{} ({})", scene.title, scene.name)),
        row("Dimension", scene.dimension.to_string()),
        row("Particles", count(scene.particles)),
        row("Neighbours asked for", short(scene.neighbours)),
        row("Kernel", scene.kernel.clone()),
        row("Dissipation scheme", scene.scheme.clone()),
        row("Adiabatic index γ", short(scene.gamma)),
        row("End time", short(scene.end_time)),
        row("Start", format!("{}, {}", scene.arrangement, scene.discontinuity)),
        row("Boundaries", scene.boundaries.clone()),
    ];
    scene_rows.extend(scene.settings.iter().map(|setting| (setting.name.clone(), setting.value.clone())));
    let machine = &report.machine;
    let peak = machine.fma_peak_gflops_per_core;
    let machine_rows = [
        row("Processor", machine.cpu.clone()),
        row("Hardware threads", machine.threads.to_string()),
        row("Instruction set", machine.instruction_set.clone()),
        row("System", machine.system.clone()),
        row("Graphics adapter", machine.adapter.clone().unwrap_or_else(|| "none".into())),
        row("FMA peak of a core, f32", format!("{} GFLOP/s, measured", typeset(peak.f32))),
        row("FMA peak of a core, f64", format!("{} GFLOP/s, measured", typeset(peak.f64))),
    ];
    let tables = facts("Scene", &scene_rows) + &facts("Machine", &machine_rows);
    parts::section("Setting", "", &format!("<div class=\"pair\">\n{tables}</div>\n"))
}

/// The command, and what lies beside the page.
pub(super) fn reproduce(report: &Report, files: &[&str]) -> String {
    let lead = "This command makes this report again; times will differ.";
    let mut content = format!("<div class=\"card\"><pre>{}</pre></div>\n", escape(&report.command));
    if !files.is_empty() {
        let names: Vec<String> = files.iter().map(|file| format!("<code>{}</code>", escape(file))).collect();
        content += &format!("<h3>Beside this page</h3>\n<p>{}</p>\n", names.join(", "));
    }
    parts::section("Do it again", lead, &content)
}

/// Version and date, and how the plotted particles were chosen.
pub(super) fn footer(report: &Report) -> String {
    let selection = report.measured().map(|(_, _, measured)| measured.profile.selection.as_str()).next();
    let selection = selection.map_or_else(String::new, |text| format!(" Particles in the plots: {text}."));
    let line = format!("Made by etalon {} on {}.{selection}", report.program_version, report.created);
    format!("<footer><p>{}</p></footer>\n", escape(&line))
}
