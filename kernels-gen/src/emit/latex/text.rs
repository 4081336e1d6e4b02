//! Pieces of a formula, and how they are put together.

/// How strongly a piece holds together, from weakest to strongest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Tight {
    /// `a \land b`.
    Logic,
    /// `a < b`.
    Compare,
    /// `a + b`.
    Sum,
    /// `a\,b`, `-a`.
    Product,
    /// A fraction, a power, a symbol with a power in it: holds together, but not as the base of a power.
    Group,
    /// A symbol, a function of something, a number.
    Atom,
}

/// A piece.
#[derive(Clone, Debug)]
pub(super) struct Text {
    pub text: String,
    pub tight: Tight,
    /// Whether it is the name of a value that has a line of its own.
    pub is_name: bool,
}

impl Text {
    pub fn new(text: impl Into<String>, tight: Tight) -> Self {
        Text { text: text.into(), tight, is_name: false }
    }
    pub fn atom(text: impl Into<String>) -> Self {
        Text::new(text, Tight::Atom)
    }
    /// The name of a value.
    pub fn name(symbol: String) -> Self {
        Text { is_name: true, ..Text::given(&symbol) }
    }
    /// A symbol from outside, which may be more than a letter with an index.
    pub fn given(symbol: &str) -> Self {
        let bare = symbol.starts_with('(') && symbol.ends_with(')');
        let mut depth = 0_i32;
        let outside = |c: char| {
            depth += i32::from(c == '{') - i32::from(c == '}');
            depth == 0 && (c == '^' || c == '\'')
        };
        let is_group = symbol.starts_with(r"\frac") || symbol.chars().any(outside);
        Text::new(symbol, if is_group && !bare { Tight::Group } else { Tight::Atom })
    }
    /// How much room it takes, roughly.
    pub fn width(&self) -> usize {
        self.text.chars().filter(|c| !matches!(c, '{' | '}' | '\\' | ' ')).count()
    }
    /// In parentheses, unless it holds together at least so strongly.
    pub fn at_least(&self, tight: Tight) -> String {
        if self.tight >= tight { self.text.clone() } else { format!(r"\left({}\right)", self.text) }
    }
    pub fn to_the(&self, exponent: u32) -> Text {
        match exponent {
            1 => self.clone(),
            _ => Text::new(format!("{}^{{{exponent}}}", self.at_least(Tight::Atom)), Tight::Group),
        }
    }
    pub fn negated(&self) -> Text {
        match self.text.strip_prefix('-').filter(|_| self.tight == Tight::Product) {
            Some(rest) => Text::new(rest.trim_start(), Tight::Product),
            None => Text::new(format!("-{}", self.at_least(Tight::Product)), Tight::Product),
        }
    }
    pub fn plus(&self, other: &Text) -> Text {
        let text = match other.text.strip_prefix('-').filter(|_| other.tight >= Tight::Product) {
            Some(rest) => format!("{} - {}", self.text, rest.trim_start()),
            None => format!("{} + {}", self.text, other.text),
        };
        Text::new(text, Tight::Sum)
    }
    pub fn minus(&self, other: &Text) -> Text {
        let text = match other.text.strip_prefix('-').filter(|_| other.tight >= Tight::Product) {
            Some(rest) => format!("{} + {}", self.text, rest.trim_start()),
            None => format!("{} - {}", self.text, other.at_least(Tight::Product)),
        };
        Text::new(text, Tight::Sum)
    }
    pub fn times(&self, other: &Text) -> Text {
        // Numbers go in front.
        let is_number = |text: &Text| {
            let inside = text.text.strip_prefix(r"\frac{").unwrap_or(&text.text);
            text.tight >= Tight::Product && inside.starts_with(|c: char| c.is_ascii_digit())
        };
        if other.tight == Tight::Product && other.text.starts_with('-') {
            return self.times(&other.negated()).negated();
        }
        if is_number(other) && !is_number(self) && !self.text.starts_with('-') {
            return other.times(self);
        }
        if self.text == "-1" {
            return other.negated();
        }
        let left = self.at_least(Tight::Product);
        let right = other.at_least(Tight::Product);
        let sign = if is_number(other) { r" \cdot " } else { r"\," };
        Text::new(format!("{left}{sign}{right}"), Tight::Product)
    }
    pub fn over(&self, other: &Text) -> Text {
        let (sign, above) = match self.text.strip_prefix('-').filter(|_| self.tight == Tight::Product) {
            Some(rest) => ("-", rest.trim_start()),
            None => ("", self.text.as_str()),
        };
        let tight = if sign.is_empty() { Tight::Group } else { Tight::Product };
        Text::new(format!(r"{sign}\frac{{{above}}}{{{}}}", other.text), tight)
    }
}
