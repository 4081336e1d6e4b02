//! Simplification that changes no bit.
//!
//! The simplified drawing gives, on every input on which the original has only finite nodes, the same outputs bit for bit,
//! *except for the sign of zero*. The rules, with the reason where it is not plain:
//!
//! - operations on constants are done beforehand in the drawing's precision, by the interpreter's own arithmetic, unless the
//!   result is not finite;
//! - `x + 0`, `x - 0`, `x * 1`, `x / 1`, `-(-x)`, `||x||`, `|-x|`, `x + (-y)`, `(-x) * (-y)`: exact;
//! - `0 * x`, `0 / x`, `x - x` are `0`: exact because `x` is finite (and not zero in `0 / x`);
//! - `x / 2^k` becomes `x * 2^-k`: both round the same real number;
//! - `a * b + c` with a factor 0, 1 or -1, or with `c = 0`: exact, the product does not round, or the sum does not;
//! - comparisons of a value with itself: known because it is not NaN;
//! - choices whose mask is known or whose sides are equal;
//! - equal operations are one node, and nodes that no output needs go.
//!
//! `MulAdd` of constants is folded with two roundings, which is its meaning in a graph.

use super::drawing::{Drawing, Output};
use super::graph::{Graph, Id, Literal, Op, Scope};
use super::interpret::{Value, evaluate};
use crate::real::{Precision, Real};

impl Drawing {
    /// The same computation with everything removed that costs something and changes nothing. See the rules in
    /// `trace/simplify.rs`; the inputs stay as they are, also those that are no longer used.
    pub fn simplified(&self) -> Drawing {
        self.simplified_knowing(|_| None)
    }

    /// Like [`simplified`](Drawing::simplified), with some inputs replaced by constants that they are known to have.
    pub fn simplified_knowing(&self, known: impl Fn(&str) -> Option<f64>) -> Drawing {
        let mut simplifier = Simplifier { graph: Graph::default(), precision: self.precision() };
        let simple = self.rebuilt(&mut simplifier, |simplifier, op, scope| match op {
            Op::Input(index) => match known(&self.inputs()[index]) {
                Some(value) => simplifier.literal(value),
                None => simplifier.graph.add(op, None),
            },
            _ => simplifier.build(op, scope),
        });
        // Rules leave nodes behind that nothing needs any more.
        let mut fresh = Simplifier { graph: Graph::default(), precision: self.precision() };
        simple.rebuilt(&mut fresh, |fresh, op, scope| fresh.graph.add(op, scope))
    }

    /// The needed nodes made anew, in order, by `make`; names and outputs follow.
    fn rebuilt(&self, simplifier: &mut Simplifier, make: impl Fn(&mut Simplifier, Op, Option<Scope>) -> Id) -> Drawing {
        let mut new_ids: Vec<Option<Id>> = vec![None; self.graph().len()];
        // Operands come before users and outputs are needed, so a new node is always there already.
        let renewed = |new_ids: &[Option<Id>], old: Id| new_ids[old.index()].unwrap_or(old);
        for id in self.needed() {
            let node = self.graph().node(id);
            let new = make(simplifier, node.op.map(|operand| renewed(&new_ids, operand)), node.scope);
            if let Some(name) = &node.name {
                simplifier.graph.name(new, name);
            }
            new_ids[id.index()] = Some(new);
        }
        let place = |output: &Output| Output { name: output.name.clone(), id: renewed(&new_ids, output.id) };
        let outputs = self.outputs().iter().map(place).collect();
        Drawing::new(std::mem::take(&mut simplifier.graph), self.inputs().to_vec(), outputs, self.precision())
    }
}

/// Builds nodes whose operands are already simple.
struct Simplifier {
    graph: Graph,
    precision: Precision,
}

impl Simplifier {
    fn literal(&mut self, value: f64) -> Id {
        let value = match self.precision {
            Precision::Single => value as f32 as f64,
            Precision::Double | Precision::Extended => value,
        };
        self.graph.add(Op::Literal(Literal::new(value)), None)
    }
    fn truth(&mut self, value: bool) -> Id {
        self.graph.add(Op::Truth(value), None)
    }

    /// The value of an operation whose operands are all constants, if it is finite.
    fn folded(&self, op: Op) -> Option<Op> {
        let constant = |id| matches!(self.graph.op(id), Op::Literal(_) | Op::Truth(_));
        if op.is_leaf() || !op.operands().all(constant) {
            return None;
        }
        fn fold<R: Real<Mask = bool> + Into<f64>>(graph: &Graph, op: Op) -> Option<Op> {
            match evaluate::<R>(op, &[], |id| evaluate(graph.op(id), &[], |_| Value::Mask(false))) {
                Value::Mask(holds) => Some(Op::Truth(holds)),
                Value::Number(number) => {
                    Some(number.into()).filter(|v: &f64| v.is_finite()).map(|v| Op::Literal(Literal::new(v)))
                }
            }
        }
        match self.precision {
            Precision::Single => fold::<f32>(&self.graph, op),
            Precision::Double | Precision::Extended => fold::<f64>(&self.graph, op),
        }
    }

    /// The node of an operation, in its simplest form.
    fn build(&mut self, op: Op, scope: Option<Scope>) -> Id {
        if let Some(constant) = self.folded(op) {
            return self.graph.add(constant, None);
        }
        match self.rule(op) {
            Rule::Keep => self.graph.add(op, scope),
            Rule::Node(id) => id,
            Rule::Number(value) => self.literal(value),
            Rule::Truth(value) => self.truth(value),
            // A rewritten operation is shorter than the one it comes from, so this ends.
            Rule::Rewrite(op) => self.build(op, scope),
            Rule::Scale(a, factor) => {
                let factor = self.literal(factor);
                self.build(Op::Mul(a, factor), scope)
            }
            Rule::Shift(a, addend) => {
                let addend = self.literal(addend);
                self.build(Op::Add(addend, a), scope)
            }
        }
    }

    fn rule(&self, op: Op) -> Rule {
        let lit = |id| self.graph.literal(id);
        let is = |id, value: f64| lit(id) == Some(value);
        let negated = |id| match self.graph.op(id) {
            Op::Neg(x) => Some(x),
            _ => None,
        };
        let truth = |id| match self.graph.op(id) {
            Op::Truth(value) => Some(value),
            _ => None,
        };
        match op {
            Op::Neg(a) => negated(a).map_or(Rule::Keep, Rule::Node),
            Op::Abs(a) => match self.graph.op(a) {
                Op::Abs(_) => Rule::Node(a),
                Op::Neg(x) => Rule::Rewrite(Op::Abs(x)),
                _ => Rule::Keep,
            },
            Op::Add(a, b) if is(a, 0.0) => Rule::Node(b),
            Op::Add(a, b) if is(b, 0.0) => Rule::Node(a),
            Op::Add(a, b) => match (negated(a), negated(b)) {
                (_, Some(y)) => Rule::Rewrite(Op::Sub(a, y)),
                (Some(x), None) => Rule::Rewrite(Op::Sub(b, x)),
                (None, None) => Rule::Keep,
            },
            Op::Sub(a, b) if a == b => Rule::Number(0.0),
            Op::Sub(a, b) if is(b, 0.0) => Rule::Node(a),
            Op::Sub(a, b) if is(a, 0.0) => Rule::Rewrite(Op::Neg(b)),
            Op::Sub(a, b) => negated(b).map_or(Rule::Keep, |y| Rule::Rewrite(Op::Add(a, y))),
            Op::Mul(a, b) if is(a, 0.0) || is(b, 0.0) => Rule::Number(0.0),
            Op::Mul(a, b) if is(a, 1.0) => Rule::Node(b),
            Op::Mul(a, b) if is(b, 1.0) => Rule::Node(a),
            Op::Mul(a, b) if is(a, -1.0) => Rule::Rewrite(Op::Neg(b)),
            Op::Mul(a, b) if is(b, -1.0) => Rule::Rewrite(Op::Neg(a)),
            Op::Mul(a, b) => both(negated(a), negated(b)).map_or(Rule::Keep, |(x, y)| Rule::Rewrite(Op::Mul(x, y))),
            Op::Div(a, _) if is(a, 0.0) => Rule::Number(0.0),
            Op::Div(a, b) if is(b, 1.0) => Rule::Node(a),
            Op::Div(a, b) if is(b, -1.0) => Rule::Rewrite(Op::Neg(a)),
            Op::Div(a, b) => match (lit(b).and_then(|b| self.exact_reciprocal(b)), both(negated(a), negated(b))) {
                (Some(reciprocal), _) => Rule::Scale(a, reciprocal),
                (None, Some((x, y))) => Rule::Rewrite(Op::Div(x, y)),
                (None, None) => Rule::Keep,
            },
            Op::Min(a, b) | Op::Max(a, b) if a == b => Rule::Node(a),
            Op::MulAdd(a, b, c) if is(a, 0.0) || is(b, 0.0) => Rule::Node(c),
            Op::MulAdd(a, b, c) if is(c, 0.0) => Rule::Rewrite(Op::Mul(a, b)),
            Op::MulAdd(a, b, c) if is(a, 1.0) => Rule::Rewrite(Op::Add(b, c)),
            Op::MulAdd(a, b, c) if is(b, 1.0) => Rule::Rewrite(Op::Add(a, c)),
            Op::MulAdd(a, b, c) if is(a, -1.0) => Rule::Rewrite(Op::Sub(c, b)),
            Op::MulAdd(a, b, c) if is(b, -1.0) => Rule::Rewrite(Op::Sub(c, a)),
            Op::MulAdd(a, b, c) if lit(a).is_some() && lit(b).is_some() => match self.folded(Op::Mul(a, b)) {
                Some(Op::Literal(product)) => Rule::Shift(c, product.value()),
                _ => Rule::Keep,
            },
            Op::MulAdd(a, b, c) => {
                both(negated(a), negated(b)).map_or(Rule::Keep, |(x, y)| Rule::Rewrite(Op::MulAdd(x, y, c)))
            }
            Op::Less(a, b) if a == b => Rule::Truth(false),
            Op::LessEqual(a, b) if a == b => Rule::Truth(true),
            Op::And(a, b) | Op::Or(a, b) if a == b => Rule::Node(a),
            Op::And(a, b) => match (truth(a), truth(b)) {
                (Some(false), _) | (_, Some(false)) => Rule::Truth(false),
                (Some(true), _) => Rule::Node(b),
                (_, Some(true)) => Rule::Node(a),
                (None, None) => Rule::Keep,
            },
            Op::Or(a, b) => match (truth(a), truth(b)) {
                (Some(true), _) | (_, Some(true)) => Rule::Truth(true),
                (Some(false), _) => Rule::Node(b),
                (_, Some(false)) => Rule::Node(a),
                (None, None) => Rule::Keep,
            },
            Op::Not(a) => match self.graph.op(a) {
                Op::Not(x) => Rule::Node(x),
                _ => Rule::Keep,
            },
            Op::Select(_, a, b) if a == b => Rule::Node(a),
            Op::Select(m, a, b) => match self.graph.op(m) {
                Op::Truth(true) => Rule::Node(a),
                Op::Truth(false) => Rule::Node(b),
                Op::Not(x) => Rule::Rewrite(Op::Select(x, b, a)),
                _ => Rule::Keep,
            },
            _ => Rule::Keep,
        }
    }

    /// `1 / divisor`, if the divisor is a power of two and neither is outside the precision's normal range.
    fn exact_reciprocal(&self, divisor: f64) -> Option<f64> {
        let is_power = |value: f64| match self.precision {
            Precision::Single => (value as f32).is_normal() && (value as f32).to_bits() & 0x007f_ffff == 0,
            Precision::Double | Precision::Extended => {
                value.is_normal() && value.to_bits() & 0x000f_ffff_ffff_ffff == 0
            }
        };
        Some(1.0 / divisor).filter(|reciprocal| is_power(divisor) && is_power(*reciprocal))
    }
}

/// What to put in an operation's place.
enum Rule {
    /// Itself.
    Keep,
    /// A node that is there.
    Node(Id),
    /// A constant.
    Number(f64),
    /// A known mask.
    Truth(bool),
    /// Another operation.
    Rewrite(Op),
    /// A product with a constant.
    Scale(Id, f64),
    /// A constant with something added.
    Shift(Id, f64),
}

fn both(a: Option<Id>, b: Option<Id>) -> Option<(Id, Id)> {
    a.zip(b)
}
