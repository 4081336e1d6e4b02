//! Polynomials evaluated by Horner's rule.

use crate::trace::{Drawing, Id, Op};

/// Fewer coefficients are not worth it: `a x + b` is written as such.
const FEWEST: usize = 3;

/// What of a drawing belongs to a polynomial.
pub(super) struct Horner {
    /// Steps that a later step goes on with.
    pub is_inside: Vec<bool>,
    /// Variables of polynomials.
    pub is_variable: Vec<bool>,
}

impl Horner {
    /// Finds all polynomials.
    pub fn of(drawing: &Drawing) -> Self {
        let uses = drawing.uses();
        let mut found = Horner { is_inside: vec![false; uses.len()], is_variable: vec![false; uses.len()] };
        // From the end, so that a polynomial is found from its last step.
        for id in drawing.needed().into_iter().rev() {
            let is_last = !found.is_inside[id.index()];
            if let Some((variable, constants)) = chain(drawing, &uses, id).filter(|_| is_last) {
                found.is_variable[variable.index()] = true;
                let mut at = id;
                for _ in 2..constants.len() {
                    if let Op::MulAdd(inner, ..) = drawing.graph().op(at) {
                        found.is_inside[inner.index()] = true;
                        at = inner;
                    }
                }
            }
        }
        found
    }
}

/// The variable and the coefficients, lowest power first, of the polynomial whose last step this node is.
pub(super) fn chain(drawing: &Drawing, uses: &[u32], id: Id) -> Option<(Id, Vec<f64>)> {
    let graph = drawing.graph();
    let mut constants = Vec::new();
    let mut variable = None;
    let mut at = id;
    while let Op::MulAdd(inner, x, constant) = graph.op(at) {
        let is_step = at == id || (uses[at.index()] == 1 && graph.node(at).name.is_none());
        if !is_step || *variable.get_or_insert(x) != x {
            return None;
        }
        constants.push(graph.literal(constant)?);
        at = inner;
    }
    constants.push(graph.literal(at)?);
    variable.filter(|_| constants.len() >= FEWEST).map(|variable| (variable, constants))
}
