//! Building stones of the page. Everything that comes from the report passes through [`escape`].

use super::super::model::Run;
use super::super::number::typeset;
use super::super::plot::Plot;

/// Text that is safe between tags and inside quoted attributes.
pub(in super::super) fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            c => out.push(c),
        }
    }
    out
}

/// A section with heading and an explaining sentence.
pub(super) fn section(heading: &str, lead: &str, content: &str) -> String {
    let lead = if lead.is_empty() { String::new() } else { format!("<p>{}</p>\n", escape(lead)) };
    format!("<section>\n<h2>{}</h2>\n{lead}{content}</section>\n", escape(heading))
}

/// A column of a table: its heading, a unit or remark below it, whether it holds numbers.
pub(super) struct Head<'a>(pub(super) &'a str, pub(super) &'a str, pub(super) bool);

/// A table from headings and finished rows (`<tr>` elements).
pub(super) fn table(heads: &[Head], rows: &str) -> String {
    let heads: String = heads
        .iter()
        .map(|Head(heading, unit, number)| {
            let class = if *number { " class=\"n\"" } else { "" };
            let unit =
                if unit.is_empty() { String::new() } else { format!("<span class=\"unit\">{}</span>", escape(unit)) };
            format!("<th scope=\"col\"{class}>{}{unit}</th>", escape(heading))
        })
        .collect();
    format!(
        "<div class=\"card scroll\"><table>\n<thead><tr>{heads}</tr></thead>\n<tbody>\n{rows}</tbody>\n</table></div>\n"
    )
}

/// A table of facts: name and value.
pub(super) fn facts(heading: &str, rows: &[(String, String)]) -> String {
    let rows: String = rows
        .iter()
        .map(|(name, value)| format!("<tr><th scope=\"row\">{}</th><td>{}</td></tr>\n", escape(name), escape(value)))
        .collect();
    format!(
        "<div class=\"card\"><h3>{}</h3><table class=\"facts\"><tbody>\n{rows}</tbody></table></div>\n",
        escape(heading)
    )
}

/// The row heading of a run: its colour and its name.
pub(super) fn run_heading(index: usize, run: &Run) -> String {
    format!("<th scope=\"row\">{}</th>", run_name(index, run))
}

/// The heading of several rows of a run.
pub(super) fn run_group(index: usize, run: &Run, rows: usize) -> String {
    format!("<th scope=\"rowgroup\" rowspan=\"{rows}\">{}</th>", run_name(index, run))
}

/// The colour and the name of a run.
fn run_name(index: usize, run: &Run) -> String {
    let colour = index % super::theme::RUNS.len();
    format!("<span class=\"dot run{colour}\"></span>{}", escape(&run.label()))
}

/// Rows under a heading that spans them all. A row is the cells that follow the heading.
pub(super) fn group(heading: &str, rows: &[String]) -> String {
    let row = |(index, cells): (usize, &String)| match index {
        0 => format!("<tr class=\"group\">{heading}{cells}</tr>\n"),
        _ => format!("<tr>{cells}</tr>\n"),
    };
    rows.iter().enumerate().map(row).collect()
}

/// A row heading without text, below a run's own.
pub(super) fn text_heading(text: &str) -> String {
    format!("<th scope=\"row\">{}</th>", escape(text))
}

/// A cell with a number.
pub(super) fn number(value: f64) -> String {
    format!("<td class=\"n\">{}</td>", typeset(value))
}

/// A cell with a number, or a dash.
pub(super) fn maybe(value: Option<f64>) -> String {
    value.map_or_else(|| "<td class=\"n\">–</td>".into(), number)
}

/// A cell with text.
pub(super) fn words(text: &str) -> String {
    format!("<td>{}</td>", escape(text))
}

/// Explanations below a table, each under a letter, none twice.
#[derive(Default)]
pub(super) struct Notes(Vec<String>);

impl Notes {
    /// A cell with the letters of these explanations.
    pub(super) fn cell<'a>(&mut self, texts: impl IntoIterator<Item = &'a str>) -> String {
        let mut letters: Vec<String> = texts.into_iter().map(|text| self.letter(text)).collect();
        letters.sort();
        letters.dedup();
        format!("<td>{}</td>", letters.join(", "))
    }

    /// The letter of an explanation: a, b, ..., z, aa, ab, ...
    fn letter(&mut self, text: &str) -> String {
        let known = self.0.iter().position(|note| note == text);
        let mut place = known.unwrap_or_else(|| {
            self.0.push(text.to_owned());
            self.0.len() - 1
        });
        let mut letters = Vec::new();
        loop {
            letters.push(char::from(b'a' + (place % 26) as u8));
            if place < 26 {
                return letters.iter().rev().collect();
            }
            place = place / 26 - 1;
        }
    }

    /// The explanations as a list, whose letters are counted by the reader's program in the same way.
    pub(super) fn list(&self) -> String {
        if self.0.is_empty() {
            return String::new();
        }
        let items: String = self.0.iter().map(|note| format!("<li>{}</li>\n", escape(note))).collect();
        format!("<ol class=\"notes\">\n{items}</ol>\n")
    }
}

/// A cell that says how much of a tolerance is used up.
///
/// From 90 % on a tolerance looks fitted to the result; it is called close, so that someone asks.
pub(super) fn used(found: f64, tolerance: f64) -> String {
    let part = found.abs() / tolerance;
    let (class, word) = match part {
        part if part <= 0.9 => ("pass", "within"),
        part if part <= 1.0 => ("incomplete", "close"),
        _ => ("fail", "outside"),
    };
    let percent = match 100.0 * part {
        percent if percent > 0.0 && percent < 1.0 => "<1".into(),
        percent if percent < 1000.0 => format!("{percent:.0}"),
        percent => typeset(percent),
    };
    format!(
        "<td class=\"n\">{} %<span class=\"meter\"><i style=\"width:{:.1}%\"></i></span></td>\
         <td><span class=\"verdict {class}\">{word}</span></td>",
        escape(&percent),
        100.0 * part.min(1.0)
    )
}

/// The plot of that file name as a figure; nothing if there is none.
pub(super) fn figure(plots: &[Plot], file: &str) -> String {
    plots.iter().find(|plot| plot.file == file).map_or_else(String::new, |plot| {
        format!(
            "<figure class=\"card\">\n{}\n<figcaption>{}</figcaption>\n</figure>\n",
            plot.inline().trim_end(),
            escape(&plot.caption)
        )
    })
}

/// Figures side by side.
pub(super) fn figures(figures: &[String]) -> String {
    let content = figures.concat();
    if content.is_empty() { content } else { format!("<div class=\"plots\">\n{content}</div>\n") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn notes_are_lettered_once() {
        let mut notes = Notes::default();
        assert_eq!(notes.cell(["first", "second", "first"]), "<td>a, b</td>");
        for number in 2..27 {
            notes.letter(&number.to_string());
        }
        assert_eq!(
            (notes.letter("25"), notes.letter("26"), notes.letter("new")),
            ("z".into(), "aa".into(), "ab".into())
        );
        assert_eq!(notes.list().matches("<li>").count(), 28);
    }

    #[test]
    fn tolerances_are_judged() {
        assert!(used(-0.5, 1.0).contains("within"));
        assert!(used(0.95, 1.0).contains("close"));
        assert!(used(1.01, 1.0).contains("outside"));
        assert!(used(f64::NAN, 1.0).contains("outside"));
        assert!(used(1e-9, 1.0).contains("&lt;1 %"));
    }
}
