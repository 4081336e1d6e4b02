//! Errors: against the exact solution, against the reference, of the kernel's functions, and what should be conserved.

use super::super::model::{Conserved, FieldDifference, Report};
use super::super::number::{count, short, typeset};
use super::super::plot::{Plot, capital, key_label};
use super::super::verdict::{key_error, key_field};
use super::parts::{
    Head, Notes, escape, figure, figures, group, number, run_group, run_heading, section, table, text_heading, used,
    words,
};

/// Profiles and the errors of every field against the exact solution.
pub(super) fn accuracy(report: &Report, plots: &[Plot]) -> String {
    if report.measured().next().is_none() {
        return String::new();
    }
    let norm = &report.scene.norm;
    let profiles = report.fields.iter().map(|field| format!("profile_{}.svg", field.name));
    let profiles: Vec<String> = profiles.chain(["map_density.svg".into()]).map(|file| figure(plots, &file)).collect();
    if report.measured().all(|(_, _, measured)| measured.discretisation_error.is_empty()) {
        let lead = "Particles at the end time. There is no exact solution of this scene to compare them with.";
        return section("What came out?", lead, &figures(&profiles));
    }
    let lead = format!(
        "Particles at the end time over the exact solution. Norms are means over the particles with {} between {} and {} \
         ({}), in each field’s own unit.",
        norm.coordinate,
        short(norm.from),
        short(norm.to),
        norm.source
    );
    let heads = [
        Head("Field", "unit", false),
        Head("Run", "", false),
        Head("L₁", "mean |error|", true),
        Head("L₂", "root mean square", true),
        Head("Largest", "", true),
        Head("Particles", "in range", true),
    ];
    let mut rows = String::new();
    for field in &report.fields {
        let errors: Vec<String> = report
            .measured()
            .filter_map(|(index, run, measured)| {
                let error = measured.error_of(&field.name)?;
                Some(format!(
                    "{}{}{}{}<td class=\"n\">{}</td>",
                    run_heading(index, run),
                    number(error.l1),
                    number(error.l2),
                    number(error.max),
                    count(error.particles)
                ))
            })
            .collect();
        let heading = format!(
            "<th scope=\"rowgroup\" rowspan=\"{}\">{} {}<span class=\"unit\">{}</span></th>",
            errors.len(),
            escape(&capital(&field.label)),
            escape(&field.symbol),
            escape(&field.unit)
        );
        rows += &group(&heading, &errors);
    }
    section("Is the answer right?", &lead, &(figures(&profiles) + &table(&heads, &rows)))
}

/// The three sources of error: what they are, how large, and the tables of the second and third.
pub(super) fn sources(report: &Report, plots: &[Plot]) -> String {
    if report.measured().next().is_none() {
        return String::new();
    }
    let lead = "A particle code is wrong in three ways that have nothing to do with one another. They are measured \
                separately, so that one cannot hide behind another.";
    let shown = [figure(plots, "error.svg"), figure(plots, "error_sources.svg")];
    let content = [cards(report), figures(&shown), arithmetic(report), approximation(report)];
    section("Where does the error come from?", lead, &content.concat())
}

/// One card a source: its figure and its meaning.
fn cards(report: &Report) -> String {
    let unit = key_field(report).map_or("the field’s unit", |field| &field.unit);
    let discretisation = report
        .measured()
        .find_map(|(_, _, measured)| Some(typeset(key_error(report, measured)?.l1)))
        .unwrap_or_else(|| "–".into());
    let levels: Vec<(String, f64)> = report
        .measured()
        .filter_map(|(_, run, measured)| Some((run.label(), measured.worst_difference()?.compared())))
        .collect();
    let worst = levels.iter().max_by(|a, b| a.1.total_cmp(&b.1));
    let (arithmetic, whose) = worst.map_or_else(
        || ("–".into(), "nothing compared with the reference".into()),
        |(label, level)| (typeset(*level), format!("largest, {label}, relative")),
    );
    let widest = report.kernel_approximation.iter().max_by(|a, b| a.max.total_cmp(&b.max));
    let (kernel, which) = widest.map_or_else(
        || ("–".into(), "no approximated functions".into()),
        |widest| (typeset(widest.max), format!("largest, {}, relative", widest.precision)),
    );
    let card = |title: &str, figure: &str, small: &str, text: &str| {
        format!(
            "<div class=\"card\"><h3>{}</h3>\n<p class=\"figure\">{}<small>{}</small></p>\n<p>{}</p></div>\n",
            escape(title),
            escape(figure),
            escape(small),
            escape(text)
        )
    };
    format!(
        "<div class=\"sources\">\n{}{}{}</div>\n",
        card(
            "1. Discretisation",
            &discretisation,
            &format!("{}, in {unit}", key_label(report)),
            "The method has finitely many particles and smears what is sharp. Measured against the exact solution; more \
             particles make it smaller, more digits do not."
        ),
        card(
            "2. Arithmetic",
            &arithmetic,
            &whose,
            "Every operation rounds, and f32 rounds earlier than f64. Measured against the scalar f64 reference, field by \
             field, from the same start over the whole run; more digits make it smaller, more particles do not."
        ),
        card(
            "3. Kernel approximation",
            &kernel,
            &which,
            "Inside the kernels polynomials stand for functions such as the sine. Measured against the exact function over \
             the whole support; it is fixed once and the same in every run of that precision."
        )
    )
}

/// Differences to the reference beside their tolerances.
fn arithmetic(report: &Report) -> String {
    let heads = [
        Head("Run", "", false),
        Head("Field", "", false),
        Head("rms", "field’s unit", true),
        Head("Largest", "field’s unit", true),
        Head("Scale", "field’s unit", true),
        Head("Compared", "divided by scale", true),
        Head("Tolerance", "", true),
        Head("Used", "of the tolerance", true),
        Head("", "", false),
        Head("Note", "", false),
    ];
    let (mut rows, mut notes) = (String::new(), Notes::default());
    for (index, run, measured) in report.measured() {
        let differences = &measured.arithmetic_difference;
        let cells: Vec<String> =
            differences.iter().map(|difference| difference_cells(report, difference, &mut notes)).collect();
        rows += &group(&run_group(index, run, cells.len()), &cells);
    }
    if rows.is_empty() {
        return String::new();
    }
    format!("<h3>Arithmetic: difference to the scalar f64 reference</h3>\n{}{}", table(&heads, &rows), notes.list())
}

/// All cells of a difference but the run's.
fn difference_cells(report: &Report, difference: &FieldDifference, notes: &mut Notes) -> String {
    let label = report.field(&difference.field).map_or(difference.field.as_str(), |field| &field.label);
    let (compared, tolerance) = (difference.compared(), difference.tolerance.value);
    // A verdict that was stored as failed stays failed, whatever the figures say.
    let judged = if difference.pass { compared } else { compared.max(tolerance * 1.001) };
    format!(
        "{}{}{}{}<td class=\"n\">{} {}</td>{}{}{}",
        words(label),
        number(difference.rms),
        number(difference.max),
        number(difference.scale),
        difference.norm.label(),
        typeset(compared),
        number(tolerance),
        used(judged, tolerance),
        notes.cell([difference.tolerance.source.as_str()])
    )
}

/// Errors of the functions inside the kernels.
fn approximation(report: &Report) -> String {
    if report.kernel_approximation.is_empty() {
        return String::new();
    }
    let heads = [
        Head("Function", "", false),
        Head("Approximated by", "", false),
        Head("Precision", "", false),
        Head("Largest error", "relative to largest value", true),
        Head("Tolerance", "", true),
        Head("Used", "of the tolerance", true),
        Head("", "", false),
        Head("Note", "", false),
    ];
    let (mut rows, mut notes) = (String::new(), Notes::default());
    for entry in &report.kernel_approximation {
        rows += &format!(
            "<tr>{}{}{}{}{}{}{}</tr>\n",
            text_heading(&entry.function),
            words(&entry.approximation),
            words(&entry.precision),
            number(entry.max),
            number(entry.tolerance.value),
            used(entry.max, entry.tolerance.value),
            notes.cell([entry.tolerance.source.as_str()])
        );
    }
    format!(
        "<h3>Kernel approximation: polynomial against exact function</h3>\n{}{}",
        table(&heads, &rows),
        notes.list()
    )
}

/// Drift of what should be conserved.
pub(super) fn conservation(report: &Report) -> String {
    let heads = [
        Head("Run", "", false),
        Head("Quantity", "", false),
        Head("Drift", "/ sum of magnitudes", true),
        Head("Tolerance", "", true),
        Head("Used", "of the tolerance", true),
        Head("", "", false),
        Head("Notes", "", false),
    ];
    let (mut rows, mut notes) = (String::new(), Notes::default());
    for (index, run, measured) in report.measured() {
        let conserved = &measured.conservation;
        let cells: Vec<String> = conserved.iter().map(|conserved| conserved_cells(conserved, &mut notes)).collect();
        rows += &group(&run_group(index, run, cells.len()), &cells);
    }
    if rows.is_empty() {
        return String::new();
    }
    let lead = "Change of each sum from start to end, divided by the sum of the magnitudes of its terms.";
    section("What is conserved?", lead, &(table(&heads, &rows) + &notes.list()))
}

/// All cells of a conserved quantity but the run's.
fn conserved_cells(conserved: &Conserved, notes: &mut Notes) -> String {
    let verdict = conserved.tolerance.as_ref().map_or_else(
        || "<td class=\"n\">–</td><td class=\"n\">–</td><td></td>".into(),
        |tolerance| number(tolerance.value) + &used(conserved.scaled_drift, tolerance.value),
    );
    let source = conserved.tolerance.as_ref().map(|tolerance| tolerance.source.as_str());
    let texts = conserved.note.as_deref().into_iter().chain(source);
    format!("{}{}{verdict}{}", words(&conserved.quantity), number(conserved.scaled_drift), notes.cell(texts))
}
