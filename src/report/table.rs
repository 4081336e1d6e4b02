//! The result as a few aligned lines for a terminal.

use super::Report;
use super::model::Outcome;
use super::number::plain;
use super::verdict::{key_error, key_field};

/// One line per backend and precision: error against the exact solution, arithmetic difference to the reference beside
/// its tolerance, time per particle update, speed-up. A skipped run says why. ASCII, lines end in `\n`.
pub fn summary_table(report: &Report) -> String {
    let key = key_field(report).map_or("field", |field| field.name.as_str());
    let head = [
        "backend".to_owned(),
        "precision".into(),
        format!("L1({key})"),
        "difference to reference".into(),
        "ns/update".into(),
        "speed-up".into(),
    ];
    let mut rows = vec![Row::Cells(head)];
    for run in &report.runs {
        rows.push(match &run.outcome {
            Outcome::Skipped { reason } => Row::Skipped([run.backend.clone(), run.precision.clone()], reason.clone()),
            Outcome::Ran(measured) => {
                let difference = match measured.worst_difference() {
                    None if run.is_reference() => "(is the reference)".into(),
                    None => "-".into(),
                    Some(worst) => {
                        let failed = measured.arithmetic_difference.iter().find(|difference| !difference.pass);
                        let shown = failed.unwrap_or(worst);
                        let (sign, verdict) = if shown.pass { ("<=", "ok") } else { (">", "FAIL") };
                        let (found, bound) = (plain(shown.compared()), plain(shown.tolerance.value));
                        format!("{found} {sign} {bound} {verdict} ({})", shown.field)
                    }
                };
                Row::Cells([
                    run.backend.clone(),
                    run.precision.clone(),
                    key_error(report, measured).map_or_else(|| "-".into(), |error| plain(error.l1)),
                    difference,
                    plain(measured.speed.nanoseconds_per_update),
                    measured.speed.speed_up.map_or_else(|| "-".into(), plain),
                ])
            }
        });
    }
    align(&rows)
}

/// A line of the table.
enum Row {
    Cells([String; 6]),
    Skipped([String; 2], String),
}

/// Pads every column to its widest cell: words to the left, numbers to the right.
fn align(rows: &[Row]) -> String {
    let mut width = [0; 6];
    for row in rows {
        let cells = match row {
            Row::Cells(cells) => &cells[..],
            Row::Skipped(cells, _) => &cells[..],
        };
        for (width, cell) in width.iter_mut().zip(cells) {
            *width = (*width).max(cell.chars().count());
        }
    }
    let pad = |index: usize, cell: &str| {
        let width = width[index];
        match index {
            0 | 1 | 3 => format!("{cell:<width$}"),
            _ => format!("{cell:>width$}"),
        }
    };
    let mut out = String::new();
    for row in rows {
        let line = match row {
            Row::Cells(cells) => cells.iter().enumerate().map(|(index, cell)| pad(index, cell)).collect::<Vec<_>>(),
            Row::Skipped([backend, precision], reason) => {
                vec![pad(0, backend), pad(1, precision), format!("skipped: {reason}")]
            }
        };
        out.push_str(line.join("  ").trim_end());
        out.push('\n');
    }
    out
}

/// Rows of cells as aligned lines, the first row a heading: columns of numbers to the right, words to the left. Lines end in `\n`.
pub fn columns<const N: usize>(rows: &[[String; N]]) -> String {
    let width: [usize; N] = std::array::from_fn(|k| rows.iter().map(|row| row[k].chars().count()).max().unwrap_or(0));
    let is_number = |cell: &str| cell.is_empty() || cell == "-" || cell.parse::<f64>().is_ok();
    let numbers: [bool; N] = std::array::from_fn(|k| rows.iter().skip(1).all(|row| is_number(&row[k])));
    let mut out = String::new();
    for row in rows {
        let cells: [String; N] = std::array::from_fn(|k| match (numbers[k], width[k], &row[k]) {
            (true, width, cell) => format!("{cell:>width$}"),
            (false, width, cell) => format!("{cell:<width$}"),
        });
        out.push_str(cells.join("  ").trim_end());
        out.push('\n');
    }
    out
}

#[cfg(test)]
mod tests {
    use super::super::model::{FieldDifference, Norm, Tolerance};
    use super::super::synthetic;
    use super::*;

    #[test]
    fn columns_line_up_and_skips_say_why() {
        insta::assert_snapshot!(summary_table(&synthetic::report()), @r"
        backend    precision  L1(velocity_x)  difference to reference               ns/update  speed-up
        reference  f64               7.21e-3  (is the reference)                         6211      1.00
        simd       f64               7.21e-3  2.20e-14 <= 8.00e-14 ok (velocity_x)       1192      5.21
        simd       f32               7.21e-3  6.60e-6 <= 4.00e-5 ok (velocity_x)          638      9.73
        wgpu       f32        skipped: no graphics adapter found (install a Vulkan driver, or mesa-vulkan-drivers)
        ");
    }

    #[test]
    fn a_failure_is_shown_even_if_another_field_differs_more() {
        let mut report = synthetic::report();
        let Outcome::Ran(measured) = &mut report.runs[1].outcome else { panic!("the synthetic SIMD run ran") };
        // Density breaks a strict tolerance while velocity, with a larger difference, keeps a wide one.
        let strict = Tolerance::new(1e-15, "test");
        measured.arithmetic_difference[0] = FieldDifference::new("density", 1e-14, 1e-14, 1.0, Norm::Rms, strict);
        let table = summary_table(&report);
        assert!(table.contains("1.00e-14 > 1.00e-15 FAIL (density)"), "{table}");
    }

    #[test]
    fn numbers_stand_to_the_right_and_words_to_the_left() {
        let cells = |row: [&str; 3]| row.map(String::from);
        let text = columns(&[cells(["scheme", "L1", "on"]), cells(["AV", "1.50e-3", "*"]), cells(["AVSLR", "-", ""])]);
        assert_eq!(text, "scheme       L1  on\nAV      1.50e-3  *\nAVSLR         -\n");
    }
}
