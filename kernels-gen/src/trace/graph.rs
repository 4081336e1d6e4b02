//! The expression graph.
//!
//! # What a graph means
//!
//! A graph is a list of nodes; a node's operands come earlier in the list than the node. Evaluating a graph means going
//! through the list once from the front: every node is evaluated exactly once, both sides of every selection included.
//! There are no effects, so any other order in which operands come before their users gives the same values. No node may
//! be reassociated, distributed or contracted with another: each rounds on its own, to nearest, ties to even, in the
//! precision of the drawing.
//!
//! | node | value |
//! |---|---|
//! | `Input(i)` | the number given for the input |
//! | `Literal(v)` | `v`, rounded to the drawing's precision when it was drawn |
//! | `Truth(b)` | the mask `b`; arises only from simplification |
//! | `Neg(a)`, `Abs(a)` | the sign turned, the sign dropped; exact |
//! | `Sqrt(a)` | the square root; `a` must not be negative |
//! | `Add`, `Sub`, `Mul`, `Div` | one rounding each; a divisor must not be zero |
//! | `Min(a, b)` | `a` if `a < b`, else `b` |
//! | `Max(a, b)` | `a` if `a > b`, else `b` |
//! | `MulAdd(a, b, c)` | `a * b + c` with *two* roundings, product first |
//! | `Less(a, b)`, `LessEqual(a, b)` | masks; `>` and `>=` are drawn with the operands exchanged |
//! | `And`, `Or`, `Not` | on masks |
//! | `Select(m, a, b)` | `a` where `m` holds, else `b`; both are evaluated |
//!
//! *No NaN, no infinity.* Equations are finite by construction: on legal input no node is infinite or NaN. `Min` and `Max`
//! return their second operand when either is NaN, as [`Real`](crate::Real) defines, but devices differ there, and
//! no legal result may rely on it; that NaN shows on the processor does (`docs/numerics.md`, bad input). [`first_not_finite`](super::first_not_finite) finds the node that breaks the promise.
//!
//! *The sign of zero* is not part of a graph's meaning: targets and the simplifier may turn it.
//!
//! *Numbers and masks are distinct*: each node is one or the other, see [`Op::shape`].
//!
//! Nodes are hash-consed: equal operations on equal operands are one node. The operands of `Add` and `Mul`, and the factors
//! of `MulAdd`, may be exchanged for that purpose; the order first written stays.

use std::collections::HashMap;
use std::fmt;

/// A node of a graph.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Id(u32);

impl Id {
    /// The node's place in the list.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// A constant, compared by its bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Literal(u64);

impl Literal {
    /// From its value.
    pub fn new(value: f64) -> Self {
        Literal(value.to_bits())
    }
    /// Its value.
    pub fn value(self) -> f64 {
        f64::from_bits(self.0)
    }
}

/// Whether a node is a number or a mask.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A real number.
    Number,
    /// The outcome of a comparison.
    Mask,
}

/// What a node does. The module's text gives the meaning of each.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[expect(missing_docs, reason = "the table in the module's text says what each computes")]
pub enum Op {
    Input(usize),
    Literal(Literal),
    Truth(bool),
    Neg(Id),
    Abs(Id),
    Sqrt(Id),
    Add(Id, Id),
    Sub(Id, Id),
    Mul(Id, Id),
    Div(Id, Id),
    Min(Id, Id),
    Max(Id, Id),
    MulAdd(Id, Id, Id),
    Less(Id, Id),
    LessEqual(Id, Id),
    And(Id, Id),
    Or(Id, Id),
    Not(Id),
    Select(Id, Id, Id),
}

impl Op {
    /// Whether the result is a number or a mask.
    pub fn shape(self) -> Shape {
        match self {
            Op::Truth(_) | Op::Less(..) | Op::LessEqual(..) | Op::And(..) | Op::Or(..) | Op::Not(_) => Shape::Mask,
            _ => Shape::Number,
        }
    }
    /// The operands, in order.
    pub fn operands(self) -> impl Iterator<Item = Id> {
        let list = match self {
            Op::Input(_) | Op::Literal(_) | Op::Truth(_) => [None, None, None],
            Op::Neg(a) | Op::Abs(a) | Op::Sqrt(a) | Op::Not(a) => [Some(a), None, None],
            Op::Add(a, b) | Op::Sub(a, b) | Op::Mul(a, b) | Op::Div(a, b) | Op::Min(a, b) | Op::Max(a, b) => {
                [Some(a), Some(b), None]
            }
            Op::Less(a, b) | Op::LessEqual(a, b) | Op::And(a, b) | Op::Or(a, b) => [Some(a), Some(b), None],
            Op::MulAdd(a, b, c) | Op::Select(a, b, c) => [Some(a), Some(b), Some(c)],
        };
        list.into_iter().flatten()
    }
    /// The same operation on other operands.
    pub fn map(self, mut f: impl FnMut(Id) -> Id) -> Op {
        match self {
            Op::Input(_) | Op::Literal(_) | Op::Truth(_) => self,
            Op::Neg(a) => Op::Neg(f(a)),
            Op::Abs(a) => Op::Abs(f(a)),
            Op::Sqrt(a) => Op::Sqrt(f(a)),
            Op::Not(a) => Op::Not(f(a)),
            Op::Add(a, b) => Op::Add(f(a), f(b)),
            Op::Sub(a, b) => Op::Sub(f(a), f(b)),
            Op::Mul(a, b) => Op::Mul(f(a), f(b)),
            Op::Div(a, b) => Op::Div(f(a), f(b)),
            Op::Min(a, b) => Op::Min(f(a), f(b)),
            Op::Max(a, b) => Op::Max(f(a), f(b)),
            Op::Less(a, b) => Op::Less(f(a), f(b)),
            Op::LessEqual(a, b) => Op::LessEqual(f(a), f(b)),
            Op::And(a, b) => Op::And(f(a), f(b)),
            Op::Or(a, b) => Op::Or(f(a), f(b)),
            Op::MulAdd(a, b, c) => Op::MulAdd(f(a), f(b), f(c)),
            Op::Select(a, b, c) => Op::Select(f(a), f(b), f(c)),
        }
    }
    /// Whether it stands for itself: an input or a constant.
    pub fn is_leaf(self) -> bool {
        matches!(self, Op::Input(_) | Op::Literal(_) | Op::Truth(_))
    }
    /// The same value with exchanged operands, where that is the same value bit for bit.
    fn mirrored(self) -> Op {
        match self {
            Op::Add(a, b) => Op::Add(b, a),
            Op::Mul(a, b) => Op::Mul(b, a),
            Op::And(a, b) => Op::And(b, a),
            Op::Or(a, b) => Op::Or(b, a),
            Op::MulAdd(a, b, c) => Op::MulAdd(b, a, c),
            other => other,
        }
    }
}

/// The equation that a node was created in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Scope {
    /// The ledger's id, `gs25:8`, or several; for a definition without a number, where it stands.
    pub id: &'static str,
    /// The function's name: `balsara_limiter`.
    pub name: &'static str,
}

/// `gs25:8 balsara_limiter`, or `kernel_mixed_sinc (GS25 section 3)`; always one line.
impl fmt::Display for Scope {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let id = self.id.split_whitespace().collect::<Vec<_>>().join(" ");
        let is_number = |part: &str| part.contains(':') && !part.contains(' ');
        match id.split(", ").all(is_number) {
            true => write!(f, "{id} {}", self.name),
            false if id.is_empty() => write!(f, "{}", self.name),
            false => write!(f, "{} ({id})", self.name),
        }
    }
}

/// An operation with what is known about its origin.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Node {
    /// What it computes.
    pub op: Op,
    /// The name that the author's `let` gave it, if any; the first one stays. Inputs and constants have none.
    pub name: Option<String>,
    /// The innermost equation it was created in, if any.
    pub scope: Option<Scope>,
}

/// A hash-consed list of nodes. See the module's text.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    nodes: Vec<Node>,
    known: HashMap<Op, Id>,
}

impl Graph {
    /// The node.
    pub fn node(&self, id: Id) -> &Node {
        &self.nodes[id.index()]
    }
    /// What the node computes.
    pub fn op(&self, id: Id) -> Op {
        self.nodes[id.index()].op
    }
    /// The constant's value, if the node is one.
    pub fn literal(&self, id: Id) -> Option<f64> {
        match self.op(id) {
            Op::Literal(literal) => Some(literal.value()),
            _ => None,
        }
    }
    /// The number of nodes.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }
    /// Whether there are no nodes.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }
    /// All nodes, operands before users.
    pub fn ids(&self) -> impl Iterator<Item = Id> + use<> {
        (0..self.nodes.len() as u32).map(Id)
    }
    /// The node of this operation: an equal one if there is one, else a new one.
    pub(super) fn add(&mut self, op: Op, scope: Option<Scope>) -> Id {
        debug_assert!(op.operands().all(|a| a.index() < self.nodes.len()), "operands come before users");
        if let Some(id) = self.known.get(&op).or_else(|| self.known.get(&op.mirrored())) {
            return *id;
        }
        let id = Id(self.nodes.len() as u32);
        let scope = if op.is_leaf() { None } else { scope };
        self.nodes.push(Node { op, name: None, scope });
        self.known.insert(op, id);
        id
    }
    /// Gives a node its name, unless it has one or stands for itself.
    pub(super) fn name(&mut self, id: Id, name: &str) {
        let node = &mut self.nodes[id.index()];
        if node.name.is_none() && !node.op.is_leaf() {
            node.name = Some(name.to_string());
        }
    }
}
