//! Expressions that graphics drivers were seen to rewrite, although WGSL text asks for something else.
//!
//! Every expression with the same operations was tried one at a time on two software Vulkan devices against unfused `f32`:
//! all gave the same bits but the eight patterns here. A kernel without them is bit-identical to the scalar code on such
//! devices; with them it is only as accurate. Constants that are powers of two are let pass: moving them changes no bit.

use super::drawing::Drawing;
use super::graph::{Graph, Id, Op, Scope};
use crate::real::Precision;
use std::fmt;

/// How much of an expression a finding shows.
const SKETCH_DEPTH: u32 = 3;

/// A rewritable shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Pattern {
    /// `(x * y) * c` or `(x * c1) * c2`: the constant is moved inside the product.
    ProductTimesConstant,
    /// `(x + c1) + c2`: the constants are added first.
    SumPlusConstant,
    /// `x * y + x * z`: the factor is taken out.
    SharedFactor,
    /// `(x + y) - x` and its kin: cancelled, which destroys compensated sums.
    SumMinusPart,
    /// `sqrt(x) * sqrt(x)`: replaced by `x`.
    RootSquared,
    /// `c - (c - x)`: replaced by `x`.
    ConstantMinusDifference,
    /// `x / c`: replaced by the product with the rounded reciprocal.
    DivisionByConstant,
    /// `(x / y) * y`: replaced by `x`.
    QuotientTimesDivisor,
}

impl Pattern {
    /// All of them.
    pub const ALL: [Pattern; 8] = [
        Pattern::ProductTimesConstant,
        Pattern::SumPlusConstant,
        Pattern::SharedFactor,
        Pattern::SumMinusPart,
        Pattern::RootSquared,
        Pattern::ConstantMinusDifference,
        Pattern::DivisionByConstant,
        Pattern::QuotientTimesDivisor,
    ];
    /// The shape, and what to write instead.
    pub fn advice(self) -> (&'static str, &'static str) {
        match self {
            Pattern::ProductTimesConstant => ("(x * y) * c", "multiply the constant into one factor beforehand"),
            Pattern::SumPlusConstant => ("(x + c1) + c2", "add the constants beforehand"),
            Pattern::SharedFactor => ("x * y + x * z", "take the factor out: x * (y + z)"),
            Pattern::SumMinusPart => ("(x + y) - x", "accumulate in integers instead of compensating"),
            Pattern::RootSquared => ("sqrt(x) * sqrt(x)", "use x"),
            Pattern::ConstantMinusDifference => ("c - (c - x)", "use x"),
            Pattern::DivisionByConstant => ("x / c", "multiply by the reciprocal, as a constant"),
            Pattern::QuotientTimesDivisor => ("(x / y) * y", "use x"),
        }
    }
}

/// A rewritable expression in a drawing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// Its shape.
    pub pattern: Pattern,
    /// The outer node.
    pub id: Id,
    /// The outer node's name, or that of the nearest named value or output it is part of.
    pub name: String,
    /// The equation it comes from, if any.
    pub equation: Option<Scope>,
    /// The expression, with what lies deeper left out.
    pub expression: String,
}

/// One clear sentence.
impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (shape, remedy) = self.pattern.advice();
        if let Some(equation) = self.equation {
            write!(f, "{equation}: ")?;
        }
        write!(f, "`{}` in `{}` has the form {shape}, which drivers rewrite; {remedy}", self.expression, self.name)
    }
}

impl Drawing {
    /// The rewritable expressions among the needed nodes, in their order. Ask a [simplified](Drawing::simplified) drawing:
    /// that is what is printed.
    pub fn lint(&self) -> Vec<Finding> {
        let needed = self.needed();
        let owners = self.owners();
        let view = View(self.graph());
        let mut findings = Vec::new();
        for id in needed {
            for pattern in view.patterns(id) {
                findings.push(Finding {
                    pattern,
                    id,
                    name: owners[id.index()].to_string(),
                    equation: self.graph().node(id).scope,
                    expression: self.sketch(id, SKETCH_DEPTH),
                });
            }
        }
        findings
    }

    /// An expression as a person would jot it down, to a limited depth.
    fn sketch(&self, id: Id, depth: u32) -> String {
        let node = self.graph().node(id);
        let whole = depth == SKETCH_DEPTH;
        if let (Some(name), false) = (&node.name, whole) {
            return name.clone();
        }
        if depth == 0 && !node.op.is_leaf() {
            return "...".to_string();
        }
        let of = |a| self.sketch(a, depth.saturating_sub(1));
        let inner = |text: String| if whole { text } else { format!("({text})") };
        let infix = |a, sign: &str, b| inner(format!("{} {sign} {}", of(a), of(b)));
        match node.op {
            Op::Input(index) => self.inputs()[index].clone(),
            Op::Literal(literal) if self.precision() == Precision::Single => format!("{:?}", literal.value() as f32),
            Op::Literal(literal) => format!("{:?}", literal.value()),
            Op::Truth(value) => value.to_string(),
            Op::Neg(a) => format!("-{}", of(a)),
            Op::Abs(a) => format!("abs({})", of(a)),
            Op::Sqrt(a) => format!("sqrt({})", of(a)),
            Op::Add(a, b) => infix(a, "+", b),
            Op::Sub(a, b) => infix(a, "-", b),
            Op::Mul(a, b) => infix(a, "*", b),
            Op::Div(a, b) => infix(a, "/", b),
            Op::MulAdd(a, b, c) => inner(format!("({} * {}) + {}", of(a), of(b), of(c))),
            Op::Min(a, b) => format!("min({}, {})", of(a), of(b)),
            Op::Max(a, b) => format!("max({}, {})", of(a), of(b)),
            _ => "...".to_string(),
        }
    }
}

/// A graph seen as sums and products, whichever nodes they are made of.
struct View<'a>(&'a Graph);

/// One side of a sum: a node, or the product within a `MulAdd`.
#[derive(Clone, Copy)]
enum Term {
    Node(Id),
    Product(Id, Id),
}

impl View<'_> {
    /// The factors, if the node is a product or contains one that is added to.
    fn factors(&self, id: Id) -> Option<(Id, Id)> {
        match self.0.op(id) {
            Op::Mul(a, b) | Op::MulAdd(a, b, _) => Some((a, b)),
            _ => None,
        }
    }
    fn term_factors(&self, term: Term) -> Option<(Id, Id)> {
        match term {
            Term::Product(a, b) => Some((a, b)),
            Term::Node(id) => match self.0.op(id) {
                Op::Mul(a, b) => Some((a, b)),
                Op::Neg(x) => self.term_factors(Term::Node(x)),
                _ => None,
            },
        }
    }
    /// The two sides, if the node is a sum or difference.
    fn terms(&self, id: Id) -> Option<(Term, Term)> {
        match self.0.op(id) {
            Op::Add(a, b) | Op::Sub(a, b) => Some((Term::Node(a), Term::Node(b))),
            Op::MulAdd(a, b, c) => Some((Term::Product(a, b), Term::Node(c))),
            _ => None,
        }
    }
    fn is_constant(&self, id: Id) -> bool {
        self.0.literal(id).is_some()
    }
    /// A constant that cannot be moved through a product without rounding.
    fn is_uneven(&self, id: Id) -> bool {
        let even = |value: f64| value.to_bits() & 0x000f_ffff_ffff_ffff == 0;
        self.0.literal(id).is_some_and(|value| !even(value))
    }
    /// The sign with which `part` enters the sum or difference `whole`, if it does: true for plus.
    fn sign_in(&self, whole: Id, part: Id) -> Option<bool> {
        match self.0.op(whole) {
            Op::Add(x, y) if x == part || y == part => Some(true),
            Op::Sub(x, _) if x == part => Some(true),
            Op::Sub(_, y) if y == part => Some(false),
            Op::MulAdd(_, _, c) if c == part => Some(true),
            _ => None,
        }
    }
    fn has_constant_term(&self, whole: Id) -> bool {
        match self.0.op(whole) {
            Op::Add(x, y) | Op::Sub(x, y) => self.is_constant(x) || self.is_constant(y),
            Op::MulAdd(_, _, c) => self.is_constant(c),
            _ => false,
        }
    }

    fn patterns(&self, id: Id) -> Vec<Pattern> {
        let mut found = Vec::new();
        let either = |(a, b): (Id, Id), test: &dyn Fn(Id, Id) -> bool| test(a, b) || test(b, a);
        if let Some(factors) = self.factors(id) {
            let of_product = |a, c| self.is_uneven(c) && matches!(self.0.op(a), Op::Mul(..));
            if either(factors, &of_product) {
                found.push(Pattern::ProductTimesConstant);
            }
            if factors.0 == factors.1 && matches!(self.0.op(factors.0), Op::Sqrt(_)) {
                found.push(Pattern::RootSquared);
            }
            if either(factors, &|a, y| matches!(self.0.op(a), Op::Div(_, divisor) if divisor == y)) {
                found.push(Pattern::QuotientTimesDivisor);
            }
        }
        if let Some((a, b)) = self.terms(id)
            && let (Some((p, q)), Some((r, s))) = (self.term_factors(a), self.term_factors(b))
            && (p == r || p == s || q == r || q == s)
            && (p, q) != (r, s)
        // doubling is exact, wherever it is done
        {
            found.push(Pattern::SharedFactor);
        }
        found.extend(self.pattern_of_sum(id));
        if matches!(self.0.op(id), Op::Div(_, divisor) if self.is_uneven(divisor)) {
            found.push(Pattern::DivisionByConstant);
        }
        found
    }

    /// The pattern of a sum or difference in which something meets its like again.
    fn pattern_of_sum(&self, id: Id) -> Option<Pattern> {
        // What is added or subtracted last cancels against the part of the other side with the opposite sign.
        let (a, b, cancelling) = match self.0.op(id) {
            Op::Add(a, b) => (a, b, Some(false)),
            Op::Sub(a, b) => (a, b, Some(true)),
            _ => return None,
        };
        let cancels = self.sign_in(a, b) == cancelling || self.sign_in(b, a) == cancelling;
        let difference_from_same = matches!(self.0.op(b), Op::Sub(c, _) if c == a);
        match (self.is_constant(a), self.is_constant(b)) {
            (true, _) if cancels && difference_from_same => Some(Pattern::ConstantMinusDifference),
            (true, _) => self.has_constant_term(b).then_some(Pattern::SumPlusConstant),
            (_, true) => self.has_constant_term(a).then_some(Pattern::SumPlusConstant),
            (false, false) => cancels.then_some(Pattern::SumMinusPart),
        }
    }
}
