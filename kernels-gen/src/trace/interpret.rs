//! Evaluating a drawing on plain numbers: the check that drawing, simplifying and printing lose nothing.
//!
//! `f32` and `f64` evaluate `MulAdd` with two roundings, which is what a graph means; [`Fused`](crate::Fused) with one. A
//! drawing made for `f32` may be evaluated in `f64`, but its constants are those of `f32`.

use super::drawing::Drawing;
use super::error::InterpretError;
use super::graph::{Id, Op, Shape};
use crate::real::{Mask, Real};

/// What a node evaluates to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Value<R> {
    Number(R),
    Mask(bool),
}

impl<R: Real<Mask = bool>> Value<R> {
    // Nodes are made from typed symbols only, so the other shape never occurs.
    fn number(self) -> R {
        match self {
            Value::Number(number) => number,
            Value::Mask(holds) => R::lit(if holds { 1.0 } else { 0.0 }),
        }
    }
    fn mask(self) -> bool {
        matches!(self, Value::Mask(true))
    }
}

/// One node's value from those of its operands.
pub(super) fn evaluate<R: Real<Mask = bool>>(op: Op, inputs: &[R], value: impl Fn(Id) -> Value<R>) -> Value<R> {
    let number = |id| value(id).number();
    let mask = |id| value(id).mask();
    match op {
        Op::Input(index) => Value::Number(inputs[index]),
        Op::Literal(literal) => Value::Number(R::lit(literal.value())),
        Op::Truth(truth) => Value::Mask(truth),
        Op::Neg(a) => Value::Number(-number(a)),
        Op::Abs(a) => Value::Number(number(a).abs()),
        Op::Sqrt(a) => Value::Number(number(a).sqrt()),
        Op::Add(a, b) => Value::Number(number(a) + number(b)),
        Op::Sub(a, b) => Value::Number(number(a) - number(b)),
        Op::Mul(a, b) => Value::Number(number(a) * number(b)),
        Op::Div(a, b) => Value::Number(number(a) / number(b)),
        Op::Min(a, b) => Value::Number(number(a).min(number(b))),
        Op::Max(a, b) => Value::Number(number(a).max(number(b))),
        Op::MulAdd(a, b, c) => Value::Number(number(a).mul_add(number(b), number(c))),
        Op::Less(a, b) => Value::Mask(number(a).lt(number(b))),
        Op::LessEqual(a, b) => Value::Mask(number(a).le(number(b))),
        Op::And(a, b) => Value::Mask(mask(a).and(mask(b))),
        Op::Or(a, b) => Value::Mask(mask(a).or(mask(b))),
        Op::Not(a) => Value::Mask(mask(a).not()),
        Op::Select(m, a, b) => Value::Number(R::pick(mask(m), number(a), number(b))),
    }
}

/// The values of all nodes, needed or not.
fn all<R: Real<Mask = bool>>(drawing: &Drawing, inputs: &[R]) -> Result<Vec<Value<R>>, InterpretError> {
    let (expected, found) = (drawing.inputs().len(), inputs.len());
    if expected != found {
        return Err(InterpretError::InputCount { expected, found });
    }
    let graph = drawing.graph();
    let mut values: Vec<Value<R>> = Vec::with_capacity(graph.len());
    for id in graph.ids() {
        let value = evaluate(graph.op(id), inputs, |operand| values[operand.index()]);
        values.push(value);
    }
    Ok(values)
}

/// The outputs, in order, for the given inputs, in order.
///
/// # Errors
/// If the number of values is not the number of inputs.
pub fn interpret<R: Real<Mask = bool>>(drawing: &Drawing, inputs: &[R]) -> Result<Vec<R>, InterpretError> {
    let values = all(drawing, inputs)?;
    Ok(drawing.outputs().iter().map(|output| values[output.id.index()].number()).collect())
}

/// The first needed node that is NaN or infinite on these inputs: equations are finite by construction, so on legal input
/// there is none.
///
/// # Errors
/// If the number of values is not the number of inputs.
pub fn first_not_finite<R: Real<Mask = bool> + Into<f64>>(
    drawing: &Drawing,
    inputs: &[R],
) -> Result<Option<Id>, InterpretError> {
    let values = all(drawing, inputs)?;
    let broken = |id: &Id| {
        let is_number = drawing.graph().op(*id).shape() == Shape::Number;
        let value: f64 = values[id.index()].number().into();
        is_number && !value.is_finite()
    };
    Ok(drawing.needed().into_iter().find(broken))
}
