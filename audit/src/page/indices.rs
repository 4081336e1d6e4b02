//! The indices of the book: by paper, by symbol, and what is gained.

use super::book::{BookError, formula_error, place, place_of_function};
use super::figures::short;
use super::markdown::{GENERATED, prose, table};
use super::mathml::mathml;
use crate::catalogue::Catalogue;
use crate::enclosure::Gap;
use crate::encoded::path_of;
use crate::gains::{Gain, GainErrors};
use crate::ranges::Range;
use etalon_kernels_gen::EquationEntry;
use etalon_spec::{Entry, EquationId};
use std::collections::{BTreeMap, BTreeSet};

/// The index by paper.
pub(super) fn by_paper(catalogue: &Catalogue) -> Result<String, BookError> {
    let wrong = formula_error;
    let mut out = vec![
        GENERATED.trim_end().to_string(),
        "# Equations by paper".to_string(),
        "A page for each numbered equation: the formula, our reading, the code, what becomes of it on each target, and who would \
         notice if it were wrong. `etalon show gs25:13` prints the same. [By symbol](symbols.md). [Gains and ranges](gains.md)."
            .to_string(),
    ];
    for paper in catalogue.ledger.papers() {
        out.push(format!("## {}", paper.paper.key().to_uppercase()));
        out.push(prose(&paper.citation).map_err(wrong(paper.paper.key()))?);
        let row = |entry: &Entry| -> Result<Vec<String>, BookError> {
            let functions: Vec<String> = catalogue.functions(entry.id).map(|of| format!("`{}`", path_of(of))).collect();
            let encoded = if functions.is_empty() { format!("no ({})", entry.kind) } else { functions.join(", ") };
            let mut remarks = Vec::new();
            remarks.extend(entry.deviation.as_ref().map(|_| "deviation"));
            remarks.extend(entry.open_question.as_ref().map(|_| "open question"));
            let title = prose(&entry.title).map_err(formula_error(&entry.id.to_string()))?;
            Ok(vec![format!("[{}]({})", entry.id.number(), place(entry.id)), title, encoded, remarks.join(", ")])
        };
        let rows = paper.entries().map(row).collect::<Result<Vec<_>, _>>()?;
        out.push(table(&["number", "equation", "encoded by", "remarks"], &rows));
    }
    out.push("## Without a number".to_string());
    let row = |entry: &'static EquationEntry| -> Result<Vec<String>, BookError> {
        let path = path_of(entry);
        let what = prose(entry.unnumbered.unwrap_or_default()).map_err(formula_error(&path))?;
        Ok(vec![format!("[`{path}`]({})", place_of_function(&path)), what])
    };
    let rows = catalogue.unnumbered().map(row).collect::<Result<Vec<_>, _>>()?;
    out.push(table(&["function", "where it stands"], &rows));
    Ok(out.join("\n\n") + "\n")
}

/// What is gained over textbook forms, and how many ranges are proven.
pub(super) fn gains(catalogue: &Catalogue) -> Result<String, BookError> {
    let row = |gain: &Gain| -> Result<Vec<String>, BookError> {
        let path = gain.probe.split(' ').next().unwrap_or_default();
        let of_path = |entry: &&&'static EquationEntry| path_of(entry) == path;
        let entry = catalogue.entries.iter().find(of_path);
        let id = entry.and_then(|entry| entry.ids.first()).and_then(|id| id.parse::<EquationId>().ok());
        let link = id.map_or_else(|| place_of_function(path), place);
        let form = mathml(&gain.formula, false).map_err(formula_error(&gain.probe))?;
        let words = |of: &GainErrors| format!("{} → {}", short(of.textbook), short(of.ours));
        let failed = format!("{}, {}", gain.f32.textbook_not_finite, gain.f64.textbook_not_finite);
        let operations = format!("{} → {}", gain.textbook_operations, gain.operations);
        Ok(vec![format!("[`{}`]({link})", gain.probe), form, words(&gain.f32), words(&gain.f64), failed, operations])
    };
    let rows = catalogue.gains.gains.iter().map(row).collect::<Result<Vec<_>, _>>()?;
    let head = ["equation", "textbook's form", "f32", "f64", "failed", "operations"];
    let about = "Each of these equations has a form in a textbook or a paper that is the same function and loses digits, or its head, in floating \
                 point. Both were measured on the same arguments against the same oracle: the largest error of the textbook's form → that of ours, in ulps \
                 of the natural scale of ours; and for how many of some 10^5 arguments the textbook's form had no finite result in f32 and in f64 (ours always \
                 had). A sine or an exponential counts as many operations as this project's own polynomial takes. The \
                 equation's page says who writes the form so, what goes wrong, and on which arguments.";
    let count = |of: &dyn Fn(&Range) -> bool| catalogue.ranges.ranges.iter().filter(|range| of(range)).count();
    let arranged = Gap::Arranged.to_string();
    let ranges = format!(
        "Of {} results of all calls, {} have a finite range that is proven for every real argument of their domains. {} have none because {arranged}. For the other {} one bound or both are missing: {}.",
        catalogue.ranges.ranges.len(),
        catalogue.ranges.finite(),
        count(&|range| range.gap.as_ref() == Some(&arranged)),
        count(&|range| range.gap.is_some() && range.gap.as_ref() != Some(&arranged)),
        Gap::Divisor
    );
    let parts = [
        GENERATED.trim_end(),
        "# Gains and ranges",
        "[By paper](README.md).",
        "## Gains over textbook forms",
        about,
        &table(&head, &rows),
        "## Proven ranges",
        &ranges,
    ];
    Ok(parts.join("\n\n") + "\n")
}

/// The index by symbol.
pub(super) fn by_symbol(catalogue: &Catalogue) -> Result<String, BookError> {
    // A symbol that two equations give different meanings has a row for each.
    let mut symbols = BTreeMap::<(String, &str, &str, String), BTreeSet<EquationId>>::new();
    for entry in catalogue.ledger.entries() {
        for symbol in &entry.symbols {
            let key = (sort_key(&symbol.latex), symbol.latex.as_str(), symbol.name.as_str(), symbol.unit.to_string());
            symbols.entry(key).or_default().insert(entry.id);
        }
    }
    let row = |((_, latex, name, unit), ids): (&(String, &str, &str, String), &BTreeSet<EquationId>)| {
        let links: Vec<String> = ids.iter().map(|id| format!("[{id}]({})", place(*id))).collect();
        let symbol = mathml(latex, false).map_err(formula_error(latex))?;
        Ok(vec![symbol, name.replace('|', "\\|"), unit.clone(), links.join(", ")])
    };
    let rows = symbols.iter().map(row).collect::<Result<Vec<_>, BookError>>()?;
    let head = "# Equations by symbol";
    let about = "In the order of the alphabet, Greek letters under their names. [By paper](README.md).";
    let table = table(&["symbol", "what it is", "unit", "equations"], &rows);
    Ok([GENERATED.trim_end(), head, about, table.as_str()].join("\n\n") + "\n")
}

/// Letters only, without the commands that mark or set them.
fn sort_key(latex: &str) -> String {
    let marks = [
        "bar",
        "hat",
        "dot",
        "mathbf",
        "mathrm",
        "mathcal",
        "boldsymbol",
        "langle",
        "rangle",
        "Delta",
        "left",
        "right",
    ];
    let plain = marks.iter().fold(latex.to_string(), |text, mark| text.replace(&format!("\\{mark}"), ""));
    plain.chars().filter(|c| c.is_alphanumeric()).collect::<String>().to_lowercase()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn symbols_are_sorted_by_their_letters() {
        assert_eq!(sort_key(r"\bar{\alpha}_{ab}"), "alphaab");
        assert_eq!(sort_key(r"\mathbf{v}_{ab}"), "vab");
        assert_eq!(sort_key(r"\Pi_{ab}"), "piab");
    }
}
