//! LaTeX as MathML, which browsers show without a script or a font from elsewhere.

use pulldown_latex::config::{DisplayMode, RenderConfig};
use pulldown_latex::{Event, Parser, Storage, push_mathml};

/// LaTeX that cannot be rendered.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{latex}` cannot be rendered: {reason}")]
pub struct NoFormula {
    /// The LaTeX.
    pub latex: String,
    /// What the renderer says.
    pub reason: String,
}

/// LaTeX of mathematics, without dollars, as a `<math>` element: a block of its own, or in line. The element may stand in
/// Markdown, tables included.
///
/// # Errors
/// [`NoFormula`] for what the renderer does not know.
pub fn mathml(latex: &str, block: bool) -> Result<String, NoFormula> {
    let wrong = |reason: String| NoFormula { latex: latex.to_string(), reason };
    let storage = Storage::new();
    let spaced = with_plain_spaces(latex);
    // Errors first: the renderer would paint them into the page.
    let events: Result<Vec<Event>, _> = Parser::new(&spaced, &storage).collect();
    let events = events.map_err(|error| wrong(error.to_string()))?;
    let display_mode = if block { DisplayMode::Block } else { DisplayMode::Inline };
    let mut html = String::new();
    let config = RenderConfig { display_mode, ..RenderConfig::default() };
    push_mathml(&mut html, events.into_iter().map(Ok::<_, std::fmt::Error>), config)
        .map_err(|error| wrong(error.to_string()))?;
    Ok(safe_in_markdown(&html))
}

/// With `\;` for `\ `, of which the renderer makes the letters of `&nbsp;`.
fn with_plain_spaces(latex: &str) -> String {
    let mut plain = String::with_capacity(latex.len());
    let mut characters = latex.chars();
    while let Some(character) = characters.next() {
        plain.push(character);
        if character == '\\' {
            // A line break's second backslash is used up here, so that a space behind it stays one.
            plain.extend(characters.next().map(|next| if next == ' ' { ';' } else { next }));
        }
    }
    plain
}

/// Escapes, outside of tags, what Markdown would take for its own.
fn safe_in_markdown(html: &str) -> String {
    let mut safe = String::with_capacity(html.len());
    let mut in_tag = false;
    for character in html.chars() {
        match character {
            '<' => in_tag = true,
            '>' => in_tag = false,
            '|' | '*' | '_' | '[' | ']' | '`' | '\\' | '~' if !in_tag => {
                safe += &format!("&#{};", u32::from(character));
                continue;
            }
            '\n' => continue,
            _ => {}
        }
        safe.push(character);
    }
    safe
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_spec::Ledger;

    #[test]
    fn what_markdown_would_take_is_escaped() {
        let text = mathml(r"\left[|x|_a * 2\right]", false).unwrap();
        let outside: String = text.split('<').filter_map(|part| part.split('>').nth(1)).collect();
        assert!(!outside.contains(['|', '[', ']', '*', '_']), "{outside}");
        assert!(text.contains("&#91;") && text.contains("&#124;") && text.contains("<mi>x</mi>"), "{text}");
    }

    #[test]
    fn every_formula_of_the_ledger_is_rendered() {
        let ledger = Ledger::load().unwrap();
        let mut rendered = 0;
        for entry in ledger.entries() {
            let formulas = std::iter::once(&entry.latex).chain(&entry.latex_as_printed);
            for latex in formulas.chain(entry.symbols.iter().map(|symbol| &symbol.latex)) {
                let text = mathml(latex, true).unwrap_or_else(|error| panic!("{}: {error}", entry.id));
                assert!(
                    text.starts_with("<math") && !text.contains("merror") && !text.contains("amp;"),
                    "{}: {text}",
                    entry.id
                );
                rendered += 1;
            }
        }
        assert!(rendered > 79, "{rendered}");
    }

    #[test]
    fn spaces_are_spaces() {
        assert_eq!(with_plain_spaces(r"a\ b \\ c\\\ d"), r"a\;b \\ c\\\;d");
        for latex in [r"\mathit{p\ slope}", r"a\ \text{where}\ b"] {
            let text = mathml(latex, true).unwrap();
            assert!(!text.contains("amp;") && text.contains("<mspace"), "{text}");
        }
    }

    #[test]
    fn what_is_unknown_is_refused() {
        assert!(mathml(r"\nosuchcommand x", false).is_err());
        assert!(mathml(r"\frac{1}{", false).is_err());
    }
}
