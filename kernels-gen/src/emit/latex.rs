//! LaTeX: the formula as the code computes it, for a reader beside the paper's.
//!
//! A drawing becomes a chain of definitions, one for each value that the author named, each result of an equation that was
//! called, and each longer part that is used more than once; the outputs come last. What the arithmetic does step by step is
//! gathered into what it means: repeated products into powers, roots of roots into one, Horner's rule into a polynomial, nested
//! selections into cases, constants into fractions. The order of operations is therefore not always that of the code; the other
//! printers keep it.

mod horner;
mod literal;
mod names;
mod text;

use crate::trace::{Drawing, Id, Op, Shape};
use horner::Horner;
use literal::{coefficient, literal};
use names::Symbols;
use text::{Text, Tight};

/// A part used more than once is written where it is used if it is no longer than this.
const SHORT: usize = 24;
/// Where a long polynomial goes on in the next line; such a one always has lines of its own.
const BREAK: &str = " \\\\\n&\\quad ";
/// So many terms of a polynomial stand in a line.
const TERMS_IN_LINE: usize = 4;

/// The drawing as an `aligned` environment, to stand in display mode. `inputs` and `outputs` are the symbols, in the drawing's
/// order; where one is missing the name in the drawing is used.
#[must_use]
pub fn formula(drawing: &Drawing, inputs: &[String], outputs: &[String]) -> String {
    let drawing = drawing.simplified();
    let mut symbols = Symbols::new();
    let named = |names: Vec<&String>, given: &[String], symbols: &mut Symbols| -> Vec<String> {
        let symbol = |(i, name): (usize, &&String)| given.get(i).cloned().unwrap_or_else(|| names::symbol(name));
        names.iter().enumerate().map(symbol).inspect(|symbol| symbols.take(symbol)).collect()
    };
    let inputs = named(drawing.inputs().iter().collect(), inputs, &mut symbols);
    let outputs = named(drawing.outputs().iter().map(|output| &output.name).collect(), outputs, &mut symbols);
    let mut writer = Writer {
        drawing: &drawing,
        inputs: &inputs,
        uses: drawing.uses(),
        is_output: of_outputs(&drawing),
        results: drawing.results(),
        horner: Horner::of(&drawing),
        symbols,
        texts: vec![None; drawing.graph().len()],
        lines: Vec::new(),
    };
    for id in drawing.needed() {
        writer.write(id);
    }
    for (output, symbol) in drawing.outputs().iter().zip(&outputs) {
        let text = writer.text(output.id);
        writer.line(symbol, &text);
    }
    format!("\\begin{{aligned}}\n{}\n\\end{{aligned}}\n", writer.lines.join(" \\\\\n"))
}

fn of_outputs(drawing: &Drawing) -> Vec<bool> {
    let mut is_output = vec![false; drawing.graph().len()];
    for output in drawing.outputs() {
        is_output[output.id.index()] = true;
    }
    is_output
}

struct Writer<'a> {
    drawing: &'a Drawing,
    inputs: &'a [String],
    uses: Vec<u32>,
    is_output: Vec<bool>,
    results: Vec<bool>,
    horner: Horner,
    symbols: Symbols,
    /// How to write each node where it is used; filled in order.
    texts: Vec<Option<Text>>,
    lines: Vec<String>,
}

impl Writer<'_> {
    fn op(&self, id: Id) -> Op {
        self.drawing.graph().op(id)
    }
    fn text(&self, id: Id) -> Text {
        self.texts[id.index()].clone().unwrap_or_else(|| Text::atom("")) // operands come first, so it is there
    }
    fn line(&mut self, symbol: &str, text: &Text) {
        self.lines.push(format!("{symbol} &= {}", text.text));
    }
    /// Whether the node is written by its own name wherever it is used.
    fn is_named(&self, id: Id) -> bool {
        self.texts[id.index()].as_ref().is_some_and(|text| text.is_name)
    }

    fn write(&mut self, id: Id) {
        if self.horner.is_inside[id.index()] {
            return;
        }
        let text = self.compose(id);
        let node = self.drawing.graph().node(id);
        let uses = self.uses[id.index()];
        let only_output = self.is_output[id.index()] && uses == 1;
        let is_result = self.results[id.index()] && !self.is_output[id.index()];
        let is_mask = node.op.shape() == Shape::Mask;
        let is_broken = text.text.contains(BREAK);
        let is_variable = self.horner.is_variable[id.index()] && text.tight < Tight::Atom;
        let is_long = is_broken || is_variable || uses > 1 && text.width() > SHORT && self.power(id).is_none();
        if node.op.is_leaf() || only_output || is_mask || !(node.name.is_some() || is_result || is_long) {
            self.texts[id.index()] = Some(text);
            return;
        }
        let wanted = match (&node.name, node.scope.filter(|_| is_result)) {
            (Some(name), _) => names::symbol(name),
            (None, Some(scope)) => names::symbol(scope.name),
            (None, None) => "t".to_string(),
        };
        let symbol = self.symbols.unique(&wanted);
        self.line(&symbol, &text);
        self.texts[id.index()] = Some(Text::name(symbol));
    }

    fn compose(&self, id: Id) -> Text {
        if let Some(polynomial) = self.polynomial(id) {
            return polynomial;
        }
        if let Some((base, exponent)) = self.power(id) {
            return self.text(base).to_the(exponent);
        }
        let operands: Vec<Text> = self.op(id).operands().map(|operand| self.text(operand)).collect();
        let [a, b, c] = std::array::from_fn(|i| operands.get(i).cloned().unwrap_or_else(|| Text::atom("")));
        match self.op(id) {
            Op::Input(index) => Text::given(&self.inputs[index]),
            Op::Literal(value) => literal(value.value()),
            Op::Truth(holds) => Text::atom(if holds { r"\top" } else { r"\bot" }),
            Op::Neg(_) => a.negated(),
            Op::Abs(_) => Text::atom(format!(r"\left|{}\right|", a.text)),
            Op::Sqrt(_) => self.root(id),
            Op::Add(left, right) if left == right => Text::atom("2").times(&a),
            Op::Add(..) => a.plus(&b),
            Op::Sub(..) => a.minus(&b),
            Op::Mul(..) => a.times(&b),
            Op::Div(..) => a.over(&b),
            Op::Min(..) => Text::atom(format!(r"\min\left({}, {}\right)", a.text, b.text)),
            Op::Max(..) => Text::atom(format!(r"\max\left({}, {}\right)", a.text, b.text)),
            Op::MulAdd(..) => a.times(&b).plus(&c),
            Op::Less(..) => Text::new(format!("{} < {}", a.text, b.text), Tight::Compare),
            Op::LessEqual(..) => Text::new(format!(r"{} \le {}", a.text, b.text), Tight::Compare),
            Op::And(..) => {
                Text::new(format!(r"{} \land {}", a.at_least(Tight::Compare), b.at_least(Tight::Compare)), Tight::Logic)
            }
            Op::Or(..) => {
                Text::new(format!(r"{} \lor {}", a.at_least(Tight::Compare), b.at_least(Tight::Compare)), Tight::Logic)
            }
            Op::Not(_) => Text::new(format!(r"\lnot {}", a.at_least(Tight::Atom)), Tight::Compare),
            Op::Select(..) => self.cases(id),
        }
    }

    /// A product of one thing with itself: the thing and how often.
    fn power(&self, id: Id) -> Option<(Id, u32)> {
        let Op::Mul(a, b) = self.op(id) else { return None };
        let part = |id: Id| if self.is_named(id) { (id, 1) } else { self.power(id).unwrap_or((id, 1)) };
        let ((base_a, a), (base_b, b)) = (part(a), part(b));
        let is_worth_it = !matches!(self.op(base_a), Op::Literal(_));
        (base_a == base_b && is_worth_it).then_some((base_a, a + b))
    }

    /// A root, a root of a root, and so on.
    fn root(&self, id: Id) -> Text {
        let (mut degree, mut inside) = (1, id);
        while let Op::Sqrt(operand) = self.op(inside)
            && (inside == id || !self.is_named(inside))
        {
            (degree, inside) = (2 * degree, operand);
        }
        let radicand = self.text(inside).text;
        Text::atom(if degree == 2 {
            format!(r"\sqrt{{{radicand}}}")
        } else {
            format!(r"\sqrt[{degree}]{{{radicand}}}")
        })
    }

    /// Selections among the other sides of selections, one below the other.
    fn cases(&self, id: Id) -> Text {
        let (mut rows, mut masks) = (Vec::new(), Vec::new());
        let mut last = id;
        while let Op::Select(mask, yes, no) = self.op(last)
            && (last == id || !self.is_named(last) && self.uses[last.index()] == 1)
        {
            rows.push(format!("{} & {}", self.where_it_holds(yes, mask).text, self.text(mask).text));
            masks.push(mask);
            last = no;
        }
        rows.push(format!(r"{} & \text{{otherwise}}", self.where_none_holds(last, &masks).text));
        Text::atom(format!(r"\begin{{cases}} {} \end{{cases}}", rows.join(r" \\ ")))
    }

    /// A side of a selection: a divisor that was made safe by the same mask is itself there.
    fn where_it_holds(&self, id: Id, mask: Id) -> Text {
        if let Op::Div(above, below) = self.op(id)
            && let Op::Select(guard, divisor, _) = self.op(below)
            && guard == mask
            && !self.is_named(id)
        {
            return self.text(above).over(&self.text(divisor));
        }
        self.text(id)
    }

    /// What is left when no mask holds, likewise.
    fn where_none_holds(&self, id: Id, masks: &[Id]) -> Text {
        if let Op::Div(above, below) = self.op(id)
            && let Op::Select(guard, _, divisor) = self.op(below)
            && masks.contains(&guard)
            && !self.is_named(id)
        {
            return self.text(above).over(&self.text(divisor));
        }
        self.text(id)
    }

    /// Horner's rule with constants, written as the polynomial that it is.
    fn polynomial(&self, id: Id) -> Option<Text> {
        let (variable, constants) = horner::chain(self.drawing, &self.uses, id)?;
        let x = self.text(variable);
        let term = |(power, value): (usize, &f64)| match power {
            0 => coefficient(*value),
            _ => coefficient(*value).times(&x.to_the(power as u32)),
        };
        let terms: Vec<Text> = constants.iter().enumerate().filter(|(_, value)| **value != 0.0).map(term).collect();
        let mut lines = terms.chunks(TERMS_IN_LINE).map(|part| {
            let mut parts = part.iter().cloned();
            let first = parts.next().unwrap_or_else(|| Text::atom("0"));
            parts.fold(first, |sum, term| sum.plus(&term)).text
        });
        let first = lines.next().unwrap_or_default();
        let rest = lines.map(|line| match line.strip_prefix('-') {
            Some(line) => format!("{BREAK}- {line}"),
            None => format!("{BREAK}+ {line}"),
        });
        Some(Text::new(rest.fold(first, |all, line| all + &line), Tight::Sum))
    }
}
