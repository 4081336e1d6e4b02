//! Tokens as a person would write them.

use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};
use quote::ToTokens;

/// The text of some tokens on one line, spaced as usual: `a.min(b) + R::lit(0.5)`.
pub(crate) fn text(tokens: impl ToTokens) -> String {
    let mut writer = Writer { text: String::new(), last: Last::Nothing, generics: 0, is_closure_open: false };
    writer.stream(tokens.to_token_stream());
    writer.text
}

/// What stands before the next token.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Last {
    Nothing,
    /// A name, a literal or a closed group: what an operator can follow.
    Value,
    Keyword,
    /// An operator between two values.
    Operator,
    /// What clings to the next token: `.`, `::`, an open parenthesis, a sign.
    Prefix,
    Comma,
}

struct Writer {
    text: String,
    last: Last,
    /// How many `::<` are open.
    generics: usize,
    /// Whether a closure's arguments are being written.
    is_closure_open: bool,
}

impl Writer {
    fn space(&mut self) {
        if !self.text.is_empty() && !self.text.ends_with([' ', '(', '[']) {
            self.text.push(' ');
        }
    }

    fn stream(&mut self, tokens: TokenStream) {
        let mut tokens = tokens.into_iter().peekable();
        while let Some(token) = tokens.next() {
            match token {
                TokenTree::Group(group) => self.group(group.delimiter(), group.stream()),
                TokenTree::Ident(name) => self.word(&name.to_string()),
                TokenTree::Literal(literal) => self.word(&literal.to_string()),
                TokenTree::Punct(punct) => {
                    let mut operator = punct.as_char().to_string();
                    let mut spacing = punct.spacing();
                    // `<=`, `::`, `&&`, `..=`; a lifetime's apostrophe joins its name by itself.
                    while spacing == Spacing::Joint
                        && let Some(TokenTree::Punct(next)) = tokens.peek()
                        && !(self.generics > 0 && next.as_char() == '>')
                    {
                        operator.push(next.as_char());
                        spacing = next.spacing();
                        tokens.next();
                    }
                    self.operator(&operator);
                }
            }
        }
    }

    fn word(&mut self, word: &str) {
        if !matches!(self.last, Last::Nothing | Last::Prefix) {
            self.space();
        }
        self.text.push_str(word);
        let is_keyword =
            matches!(word, "if" | "else" | "match" | "in" | "as" | "let" | "for" | "return" | "move" | "mut");
        self.last = if is_keyword { Last::Keyword } else { Last::Value };
    }

    fn group(&mut self, delimiter: Delimiter, inside: TokenStream) {
        let (open, close) = match delimiter {
            Delimiter::Parenthesis => ("(", ")"),
            Delimiter::Bracket => ("[", "]"),
            Delimiter::Brace => ("{ ", " }"),
            Delimiter::None => ("", ""),
        };
        let clings = matches!(self.last, Last::Nothing | Last::Prefix)
            || self.last == Last::Value && matches!(delimiter, Delimiter::Parenthesis | Delimiter::Bracket);
        if !clings {
            self.space();
        }
        self.text.push_str(open);
        self.last = Last::Prefix;
        let outer = std::mem::take(&mut self.generics);
        self.stream(inside);
        self.generics = outer;
        self.text.push_str(close);
        self.last = Last::Value;
    }

    fn operator(&mut self, operator: &str) {
        let is_prefix = self.last != Last::Value;
        match operator {
            "," | ";" => {
                self.text.push_str(operator);
                self.last = Last::Comma;
            }
            "." | "::" | ".." | "..=" | "?" => {
                self.text.push_str(operator);
                self.last = if operator == "?" { Last::Value } else { Last::Prefix };
            }
            "::<" => {
                self.text.push_str(operator);
                self.generics += 1;
                self.last = Last::Prefix;
            }
            "<" if self.text.ends_with("::") => {
                self.text.push('<');
                self.generics += 1;
                self.last = Last::Prefix;
            }
            ">" if self.generics > 0 => {
                self.text.push('>');
                self.generics -= 1;
                self.last = Last::Value;
            }
            "-" | "!" | "&" | "*" | "'" if is_prefix => {
                if !matches!(self.last, Last::Nothing | Last::Prefix) {
                    self.space();
                }
                self.text.push_str(operator);
                self.last = Last::Prefix;
            }
            "|" if self.is_closure_open => {
                self.text.push('|');
                self.is_closure_open = false;
                self.last = Last::Keyword;
            }
            "|" if is_prefix => {
                if !matches!(self.last, Last::Nothing | Last::Prefix) {
                    self.space();
                }
                self.text.push('|');
                self.is_closure_open = true;
                self.last = Last::Prefix;
            }
            ":" => {
                self.text.push(':');
                self.last = Last::Operator;
            }
            _ => {
                self.space();
                self.text.push_str(operator);
                self.last = Last::Operator;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::text;

    #[test]
    fn text_is_spaced_as_people_do() {
        for written in [
            "a + b * (c - d)",
            "x.min(0.0) - R::lit(FLOOR.0) * y[D - 1]",
            "dimension_root::<R, D>(wanted / neighbours)",
            "-(a * -b) / !c",
            "a <= b && f(&x, -y) || c",
            "Shape { value: w, slope: s.mul_add(a, b) }",
            "[1.0, 2.0; 3][i]",
            "if x < 0.0 { -x } else { x }",
            "n as f64",
            "0..n",
            "from_fn(|i, j| a[i] * b[j], |k| -k)",
        ] {
            assert_eq!(text(written.parse::<proc_macro2::TokenStream>().unwrap()), written);
        }
    }
}
