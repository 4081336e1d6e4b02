//! An explanation for people.

use super::{Explanation, Stage};
use crate::report::plain;
use etalon_kernels_gen::trace::Count;
use etalon_kernels_gen::{Field, Rank};
use std::fmt::Write;

/// Columns of a terminal that lists of fields keep to.
const WIDTH: usize = 110;
/// Where text begins after the name of what it is.
const INDENT: usize = 12;

/// The whole of it.
pub fn text(explanation: &Explanation) -> String {
    let mut out = String::new();
    header(&mut out, explanation);
    for (number, stage) in explanation.stages.iter().enumerate() {
        describe(&mut out, number + 1, stage);
    }
    fields(&mut out, explanation);
    work(&mut out, explanation);
    memory(&mut out, explanation);
    out
}

fn line(out: &mut String, text: &str) {
    out.push_str(text.trim_end());
    out.push('\n');
}

fn header(out: &mut String, explanation: &Explanation) {
    let setup = &explanation.setup;
    let method = setup.method();
    line(
        out,
        &format!(
            "{}, {}-D: scheme {} ({}), kernel {}, {} neighbours, grad-h {}{}",
            setup.problem.name().title(),
            setup.dimension,
            method.viscosity.dissipation,
            setup.coefficients(),
            method.kernel,
            method.neighbours,
            method.grad_h,
            setup.formulation().map_or(String::new(), |words| format!(", {words}"))
        ),
    );
    line(out, &format!("Units are those of mass M, length L and time T; nu = {}.", setup.dimension));
    line(out, "\nA step, in order. Neighbours are found after kick_drift.");
}

fn describe(out: &mut String, number: usize, stage: &Stage) {
    let kind = if stage.pair.is_some() { "pass over neighbours" } else { "each particle by itself" };
    line(out, &format!("\n{number}. {} ({kind})", stage.footprint.name));
    list(out, "reads", &stage.footprint.own);
    list(out, "of others", &stage.footprint.other);
    list(out, "sums", &stage.footprint.sums);
    list(out, "writes", &stage.footprint.out);
    let counts = |what: &str, [single, double]: &[Count; 2]| match single == double {
        true => format!("{single} {what}"),
        false => format!("{single} {what} in f32\n{:INDENT$}{double} {what} in f64", ""),
    };
    let mut parts = Vec::new();
    parts.extend(stage.pair.as_ref().map(|pair| counts("per pair", pair)));
    parts.push(counts("per particle", &stage.particle));
    labelled(out, "operations", &parts.join(&format!("\n{:INDENT$}", "")));
}

fn labelled(out: &mut String, label: &str, text: &str) {
    line(out, &format!("{label:<INDENT$}{text}"));
}

/// Fields with symbols, wrapped.
fn list(out: &mut String, label: &str, fields: &[Field]) {
    let mut rows = vec![String::new()];
    for (index, field) in fields.iter().enumerate() {
        let comma = if index + 1 < fields.len() { ", " } else { "" };
        let item = format!("{} {}{comma}", field.name, symbol(field.symbol));
        match rows.last_mut() {
            Some(row) if columns(row) + columns(&item) + INDENT <= WIDTH => row.push_str(&item),
            _ => rows.push(item),
        }
    }
    for (index, row) in rows.iter().filter(|row| !row.is_empty()).enumerate() {
        labelled(out, if index == 0 { label } else { "" }, row);
    }
}

fn fields(out: &mut String, explanation: &Explanation) {
    let numbers = explanation.numbers();
    line(out, &format!("\nFields of a particle: {}, {numbers} numbers in all", explanation.fields.len()));
    for row in table(&explanation.fields) {
        line(out, &format!("  {row}"));
    }
}

/// A row for each field: name, symbol, unit, rank, each column as wide as its widest entry needs.
fn table(fields: &[Field]) -> Vec<String> {
    let cells = |field: &Field| {
        let rank = match field.rank {
            Rank::Scalar => "scalar",
            Rank::Vector => "vector",
            Rank::Symmetric => "symmetric matrix",
            Rank::Matrix => "matrix",
        };
        [field.name.to_string(), symbol(field.symbol), field.unit.to_string(), rank.to_string()]
    };
    let rows: Vec<_> = fields.iter().map(cells).collect();
    let widths = [0, 1, 2, 3].map(|k| rows.iter().map(|row| columns(&row[k])).max().unwrap_or(0));
    let padded = |cell: &String, width: usize| cell.clone() + &" ".repeat(width.saturating_sub(columns(cell)));
    rows.iter()
        .map(|row| row.iter().zip(widths).map(|(cell, width)| padded(cell, width)).collect::<Vec<_>>().join("  "))
        .collect()
}

/// Columns of a terminal that a text takes: a mark over a letter, such as the dot of a rate, takes none.
fn columns(text: &str) -> usize {
    text.chars().filter(|character| !('\u{300}'..='\u{36f}').contains(character)).count()
}

fn work(out: &mut String, explanation: &Explanation) {
    let [single, double] = explanation.work_per_pair();
    let neighbours = explanation.setup.method().neighbours;
    let thousands = |flops: u32| plain(f64::from(flops) * neighbours / 1000.0);
    line(
        out,
        &format!(
            "\nWork of a step: {single} operations per pair in f32, {double} in f64; with {neighbours} neighbours about {} and {} \
             thousand per particle.\na * b + c counts two, every other operation one, signs none. A pair is counted from both ends.",
            thousands(single),
            thousands(double)
        ),
    );
}

fn memory(out: &mut String, explanation: &Explanation) {
    line(out, "\nMemory, bytes a particle");
    let mut row = |name: &str, cells: [String; 6]| {
        let mut text = format!("  {name:<15}");
        for cell in cells {
            // Writing to a string cannot fail.
            let _ = write!(text, "{cell:>12}");
        }
        line(out, &text);
    };
    row("", ["fields", "copy", "places", "packed", "neighbours", "total"].map(String::from));
    for (backend, precision, memory) in &explanation.memory {
        let parts = [memory.fields, memory.copy, memory.places, memory.records, memory.neighbours, memory.total()];
        row(&format!("{backend} {precision}"), parts.map(|bytes| format!("{bytes:.0}")));
    }
}

/// LaTeX as a terminal can show it.
fn symbol(latex: &str) -> String {
    const SIGNS: &[(&str, &str)] = &[
        ("\\frac12", "½"),
        ("\\mathcal{B}", "B"),
        ("\\dot v", "v̇"),
        ("\\dot u", "u̇"),
        ("\\Delta ", "Δ"),
        ("\\Delta", "Δ"),
        ("\\Omega ", "Ω "),
        ("\\Omega", "Ω"),
        ("\\rho", "ρ"),
        ("\\tau", "τ"),
        ("\\mu", "μ"),
        ("\\sum", "Σ"),
        ("\\alpha", "α"),
        ("\\omega", "ω"),
        ("\\nabla\\cdot ", "∇·"),
        ("\\nabla", "∇"),
        ("^T", "ᵀ"),
        ("^0", "⁰"),
        ("^2", "²"),
        ("{", ""),
        ("}", ""),
    ];
    SIGNS.iter().fold(latex.to_string(), |text, (from, to)| text.replace(from, to))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_field_shows_a_backslash() {
        for field in etalon_reference::fields::ALL {
            let shown = symbol(field.symbol);
            assert!(!shown.contains(['\\', '{', '}']), "{}: {shown}", field.name);
        }
    }

    #[test]
    fn columns_of_the_table_of_fields_stand_apart_and_below_each_other() {
        let all = etalon_reference::fields::ALL;
        let rows = table(all);
        // Where the rank begins, which is a word of its own: two spaces before it, the same place in each row.
        let starts: Vec<_> = rows
            .iter()
            .map(|row| {
                let rank = row.trim_end().rfind("  ").expect("columns stand apart") + 2;
                (columns(&row[..rank]), &row[rank..])
            })
            .collect();
        for (row, (field, (place, rank))) in rows.iter().zip(all.iter().zip(&starts)) {
            assert_eq!(*place, starts[0].0, "{row}");
            assert!(["scalar", "vector", "symmetric matrix", "matrix"].contains(&rank.trim_end()), "{row}");
            assert!(
                row.starts_with(&format!("{}  ", field.name)) && row.contains(&format!("  {}  ", field.unit)),
                "{row}"
            );
        }
        // The dot over v takes no column of its own.
        assert_eq!([columns("v\u{307}"), columns("ρ⁰")], [1, 2]);
    }
}
