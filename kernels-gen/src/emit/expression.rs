//! One operation as text, given the text of its operands.

use crate::trace::Op;

/// How strongly a piece of text holds together, from weakest to strongest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Tight {
    /// `a && b`, `a ? b : c`.
    Choice,
    /// `a < b`.
    Compare,
    /// `a + b`.
    Sum,
    /// `a * b`.
    Product,
    /// `-a`, `!a`.
    Unary,
    /// A name, a call, a constant.
    Atom,
}

/// An expression.
#[derive(Clone, Debug)]
pub(super) struct Text {
    pub text: String,
    pub tight: Tight,
}

impl Text {
    pub fn new(text: impl Into<String>, tight: Tight) -> Self {
        Text { text: text.into(), tight }
    }
    pub fn atom(text: impl Into<String>) -> Self {
        Text::new(text, Tight::Atom)
    }
    /// As an operand that must hold together at least so strongly.
    pub fn at_least(&self, tight: Tight) -> String {
        if self.tight >= tight { self.text.clone() } else { format!("({})", self.text) }
    }
    /// As a right operand: likewise, and not beginning with a sign.
    fn right(&self, tight: Tight) -> String {
        if self.text.starts_with('-') { format!("({})", self.text) } else { self.at_least(tight) }
    }
}

/// What differs between the languages.
pub(super) trait Dialect {
    /// A constant; negative ones with their sign in front.
    fn literal(&self, value: f64) -> String;
    /// How an input is read, by its name in the drawing.
    fn input(&self, name: &str) -> String;
    /// The names of absolute value, square root, minimum and maximum.
    fn functions(&self) -> [&'static str; 4];
    /// The name of the fused multiply-add, if it is to be used.
    fn fused(&self) -> Option<&'static str>;
    /// `yes` where the mask holds, else `no`.
    fn select(&self, mask: &Text, yes: &Text, no: &Text) -> Text;
    /// The beginning of a line that gives a number, or a mask, its name: `let`.
    fn declare(&self, is_mask: bool) -> &'static str;
    /// Words that are not to be used as names.
    fn forbidden(&self) -> fn(&str) -> bool;
}

/// The text of an operation. `operands` are those of [`Op::operands`], in order.
pub(super) fn compose(op: Op, dialect: &dyn Dialect, inputs: &[String], operands: &[Text]) -> Text {
    let [absolute, square_root, min, max] = dialect.functions();
    let call = |function: &str| {
        let arguments: Vec<&str> = operands.iter().map(|operand| operand.text.as_str()).collect();
        Text::atom(format!("{function}({})", arguments.join(", ")))
    };
    let infix = |sign: &str, left: Tight, right: Tight, whole: Tight| {
        Text::new(format!("{} {sign} {}", operands[0].at_least(left), operands[1].right(right)), whole)
    };
    match op {
        Op::Input(index) => Text::atom(dialect.input(&inputs[index])),
        Op::Literal(literal) => {
            let text = dialect.literal(literal.value());
            let tight = if text.starts_with('-') { Tight::Unary } else { Tight::Atom };
            Text::new(text, tight)
        }
        Op::Truth(value) => Text::atom(value.to_string()),
        Op::Neg(_) => Text::new(format!("-{}", operands[0].at_least(Tight::Atom)), Tight::Unary),
        Op::Not(_) => Text::new(format!("!{}", operands[0].at_least(Tight::Atom)), Tight::Unary),
        Op::Abs(_) => call(absolute),
        Op::Sqrt(_) => call(square_root),
        Op::Min(..) => call(min),
        Op::Max(..) => call(max),
        Op::Add(..) => plus(operands[0].at_least(Tight::Sum), &operands[1]),
        Op::Sub(..) => infix("-", Tight::Sum, Tight::Product, Tight::Sum),
        Op::Mul(..) => infix("*", Tight::Product, Tight::Unary, Tight::Product),
        Op::Div(..) => infix("/", Tight::Product, Tight::Unary, Tight::Product),
        Op::MulAdd(..) => match dialect.fused() {
            Some(function) => call(function),
            None => {
                let product = infix("*", Tight::Product, Tight::Unary, Tight::Product);
                plus(format!("({})", product.text), &operands[2])
            }
        },
        Op::Less(..) => infix("<", Tight::Sum, Tight::Sum, Tight::Compare),
        Op::LessEqual(..) => infix("<=", Tight::Sum, Tight::Sum, Tight::Compare),
        Op::And(..) => infix("&&", Tight::Unary, Tight::Unary, Tight::Choice),
        Op::Or(..) => infix("||", Tight::Unary, Tight::Unary, Tight::Choice),
        Op::Select(..) => dialect.select(&operands[0], &operands[1], &operands[2]),
    }
}

/// A sum; adding a negative constant is written as a subtraction, which is the same.
fn plus(left: String, right: &Text) -> Text {
    let negative_constant = |text: &str| {
        let rest = text.strip_prefix('-')?;
        rest.starts_with(|c: char| c.is_ascii_digit()).then(|| rest.to_string())
    };
    let text = match negative_constant(&right.text).filter(|_| right.tight == Tight::Unary) {
        Some(positive) => format!("{left} - {positive}"),
        None => format!("{left} + {}", right.right(Tight::Product)),
    };
    Text::new(text, Tight::Sum)
}

/// The shortest decimal that reads back as the same `f32` or `f64`, always with a decimal point: `1.0e-7`.
pub(super) fn decimal(debug: String) -> String {
    match debug.split_once('e') {
        Some((digits, exponent)) if !digits.contains('.') => format!("{digits}.0e{exponent}"),
        _ => debug,
    }
}
