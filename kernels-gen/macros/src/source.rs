//! The text of an item as its author wrote it, put together from the texts of its tokens.

use proc_macro::{TokenStream, TokenTree};

/// The text, or nothing if the compiler does not have it (the item came from another macro).
///
/// A group, and so a function's body, knows its whole text, comments included; what is between the tokens outside of groups is
/// white space or a comment, and only the white space can be told from their places.
pub(crate) fn text(item: &TokenStream) -> Option<String> {
    let mut text = String::new();
    let mut indent = None;
    // Where the text ends so far: line and column, from 1.
    let mut end = None;
    for token in item.clone() {
        let span = token.span();
        let (start, stop) = (span.start(), span.end());
        let start = (start.line(), start.column());
        if let Some(end) = end {
            // A doc comment became several tokens, each of which says that it is all of the comment.
            if start < end {
                continue;
            }
            let (line, column) = end;
            if start.0 > line {
                // One line on, however many there are: between documentation and function stood the attribute.
                text.push('\n');
                text.push_str(&" ".repeat(start.1.saturating_sub(1)));
            } else {
                text.push_str(&" ".repeat(start.1.saturating_sub(column)));
            }
        }
        indent.get_or_insert(start.1.saturating_sub(1));
        text.push_str(&span.source_text()?);
        end = Some((stop.line(), stop.column()));
        // Groups without delimiters come from other macros: their text is elsewhere.
        if matches!(&token, TokenTree::Group(group) if group.delimiter() == proc_macro::Delimiter::None) {
            return None;
        }
    }
    Some(without_indent(&text, indent?))
}

/// Takes up to `indent` spaces from the front of each line.
fn without_indent(text: &str, indent: usize) -> String {
    let strip = |line: &str| {
        let spaces = line.bytes().take_while(|byte| *byte == b' ').count();
        line[spaces.min(indent)..].trim_end().to_string()
    };
    text.lines().map(strip).collect::<Vec<_>>().join("\n")
}
