//! Whether an equation's units fit: every node of its drawn graph is given a unit, from the inputs on.
//!
//! Sums, comparisons, minima and selections need equal units; roots halve exponents; literals are pure numbers. Three things are
//! *of any unit*: zero; the two bounds that stand for "no limit", 1e30 and its inverse, in a minimum or maximum; and a literal that a selection picks instead of a value (`1` for a divisor that is not used, `1e30` for a
//! step without limit). Masks have no unit.

use crate::number::Number;
use crate::probe::Probe;
use etalon_kernels_gen::trace::{Double, Drawing, Graph, Id, Op, Symbol, TraceError};
use etalon_reference::equations::time_step::LONGEST_STEP;
use etalon_spec::{Base, Unit};
use std::fmt;

/// A unit in a space of fixed dimension, with fractions for exponents.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Powers {
    /// In sixty-fourths: roots of roots stay whole.
    parts: [i32; 4],
}

const WHOLE: i32 = 64;

impl Powers {
    const PURE: Powers = Powers { parts: [0; 4] };

    fn of(unit: Unit, dimension: u8) -> Self {
        Powers { parts: Base::ALL.map(|base| WHOLE * unit.exponent(base).in_dimensions(dimension)) }
    }
    fn times(self, other: Self) -> Self {
        Powers { parts: std::array::from_fn(|i| self.parts[i] + other.parts[i]) }
    }
    fn over(self, other: Self) -> Self {
        Powers { parts: std::array::from_fn(|i| self.parts[i] - other.parts[i]) }
    }
    fn root(self) -> Option<Self> {
        let is_even = self.parts.iter().all(|part| part % 2 == 0);
        is_even.then(|| Powers { parts: self.parts.map(|part| part / 2) })
    }
}

/// `M L^-3`, `L^(1/2)`, or `1`.
impl fmt::Display for Powers {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let factor = |(base, part): (Base, i32)| {
            let common = (1..=WHOLE).rev().find(|d| part % d == 0 && WHOLE % d == 0).unwrap_or(1);
            match (part / common, WHOLE / common) {
                (0, _) => None,
                (1, 1) => Some(base.letter().to_string()),
                (whole, 1) => Some(format!("{}^{whole}", base.letter())),
                (over, under) => Some(format!("{}^({over}/{under})", base.letter())),
            }
        };
        let factors: Vec<String> = Base::ALL.into_iter().zip(self.parts).filter_map(factor).collect();
        f.pad(if factors.is_empty() { "1".to_string() } else { factors.join(" ") }.as_str())
    }
}

/// What is known of a node's unit.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Known {
    /// A number with a unit.
    Unit(Powers),
    /// Zero, or a choice between zeros: of any unit.
    Any,
    /// A mask, or a number of which a fault was reported already.
    Nothing,
}

/// Units that do not fit.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum UnitFault {
    /// Two operands with different units.
    #[error("{probe}, {place}: {operation} of {left} and {right}")]
    Mixed {
        /// The probe.
        probe: String,
        /// The value that it is part of, and the equation.
        place: String,
        /// What was done.
        operation: &'static str,
        /// The unit of one side.
        left: String,
        /// The unit of the other.
        right: String,
    },
    /// More roots of roots than exponents are kept for.
    #[error("{probe}, {place}: the root of {unit} has an exponent finer than 1/64; take roots of pure numbers")]
    TooManyRoots {
        /// The probe.
        probe: String,
        /// The value that it is part of, and the equation.
        place: String,
        /// The unit under the root.
        unit: String,
    },
    /// A result has another unit than declared.
    #[error("{probe}: the result {output} has the unit {found}, declared is {declared}")]
    Result {
        /// The probe.
        probe: String,
        /// The result.
        output: String,
        /// The unit that follows from the operations.
        found: String,
        /// The declared one.
        declared: String,
    },
    /// A declared unit is no unit.
    #[error("{probe}, {quantity}: {source}")]
    Unreadable {
        /// The probe.
        probe: String,
        /// The argument or result.
        quantity: &'static str,
        /// What is wrong with it.
        source: etalon_spec::UnitError,
    },
    /// The equation could not be drawn.
    #[error("{probe}: {source}")]
    NotDrawn {
        /// The probe.
        probe: String,
        /// Why not.
        source: TraceError,
    },
}

/// Checks a probe's units, node by node, in its dimension, or in one, two and three if it has none.
///
/// # Errors
/// Every fault, each at the first node where it shows.
pub fn check_units(probe: &Probe) -> Result<(), Vec<UnitFault>>
where
    Symbol<Double>: Number,
{
    let key = probe.key();
    let drawing = probe.draw::<Double>().map_err(|source| vec![UnitFault::NotDrawn { probe: key.clone(), source }])?;
    let dimensions = probe.dimension.map_or(vec![1, 2, 3], |dimension| vec![dimension as u8]);
    let mut faults = Vec::new();
    for dimension in dimensions {
        match declared(probe, dimension) {
            Ok((inputs, outputs)) => {
                let mut walk =
                    Walk { key: &key, drawing: &drawing, inputs: &inputs, known: Vec::new(), faults: Vec::new() };
                walk.nodes();
                walk.results(&outputs);
                for fault in walk.faults {
                    if !faults.contains(&fault) {
                        faults.push(fault);
                    }
                }
            }
            Err(fault) => return Err(vec![fault]),
        }
    }
    if faults.is_empty() { Ok(()) } else { Err(faults) }
}

/// The units of each number that goes in and comes out.
fn declared(probe: &Probe, dimension: u8) -> Result<(Vec<Powers>, Vec<Powers>), UnitFault> {
    let powers = |quantity: &crate::probe::Quantity| {
        let unit = quantity.unit().map_err(|source| UnitFault::Unreadable {
            probe: probe.key(),
            quantity: quantity.name,
            source,
        })?;
        Ok(vec![Powers::of(unit, dimension); quantity.suffixes.len()])
    };
    let inputs: Result<Vec<_>, UnitFault> = probe.arguments.iter().map(|argument| powers(&argument.quantity)).collect();
    let outputs: Result<Vec<_>, UnitFault> = probe.results.iter().map(powers).collect();
    Ok((inputs?.concat(), outputs?.concat()))
}

struct Walk<'a> {
    key: &'a str,
    drawing: &'a Drawing,
    inputs: &'a [Powers],
    known: Vec<Known>,
    faults: Vec<UnitFault>,
}

impl Walk<'_> {
    fn graph(&self) -> &Graph {
        self.drawing.graph()
    }
    fn of(&self, id: Id) -> Known {
        self.known[id.index()]
    }
    fn is_literal(&self, id: Id) -> bool {
        self.graph().literal(id).is_some()
    }

    fn nodes(&mut self) {
        for id in self.graph().ids() {
            let known = self.node(id);
            self.known.push(known);
        }
    }

    fn node(&mut self, id: Id) -> Known {
        let both = |a: Known, b: Known, f: fn(Powers, Powers) -> Powers| match (a, b) {
            (Known::Unit(a), Known::Unit(b)) => Known::Unit(f(a, b)),
            (Known::Any, _) | (_, Known::Any) => Known::Any,
            _ => Known::Nothing,
        };
        match self.graph().op(id) {
            Op::Input(index) => Known::Unit(self.inputs[index]),
            Op::Literal(literal) if literal.value() == 0.0 => Known::Any,
            Op::Literal(_) => Known::Unit(Powers::PURE),
            Op::Truth(_) | Op::And(..) | Op::Or(..) | Op::Not(_) => Known::Nothing,
            Op::Neg(a) | Op::Abs(a) => self.of(a),
            Op::Sqrt(a) => match self.of(a) {
                Known::Unit(unit) => self.root(id, unit),
                other => other,
            },
            Op::Add(a, b) => self.equal(id, "a sum", self.of(a), self.of(b)),
            Op::Sub(a, b) => self.equal(id, "a difference", self.of(a), self.of(b)),
            Op::Mul(a, b) => both(self.of(a), self.of(b), Powers::times),
            Op::Div(a, b) => both(self.of(a), self.of(b), Powers::over),
            Op::MulAdd(a, b, c) => {
                let product = both(self.of(a), self.of(b), Powers::times);
                self.equal(id, "a sum", product, self.of(c))
            }
            Op::Min(a, b) => self.equal(id, "the smaller", self.bound(a), self.bound(b)),
            Op::Max(a, b) => self.equal(id, "the larger", self.bound(a), self.bound(b)),
            Op::Select(_, a, b) => self.picked(id, a, b),
            Op::Less(a, b) | Op::LessEqual(a, b) => {
                self.equal(id, "a comparison", self.of(a), self.of(b));
                Known::Nothing
            }
        }
    }

    fn root(&mut self, id: Id, unit: Powers) -> Known {
        let root = unit.root();
        if root.is_none() {
            let probe = self.key.to_string();
            self.faults.push(UnitFault::TooManyRoots { probe, place: self.place(id), unit: unit.to_string() });
        }
        root.map_or(Known::Nothing, Known::Unit)
    }
    /// The common unit of two operands; a fault if they have none.
    fn equal(&mut self, id: Id, operation: &'static str, left: Known, right: Known) -> Known {
        match (left, right) {
            (Known::Unit(a), Known::Unit(b)) if a != b => {
                let (left, right) = (a.to_string(), b.to_string());
                self.faults.push(UnitFault::Mixed {
                    probe: self.key.to_string(),
                    place: self.place(id),
                    operation,
                    left,
                    right,
                });
                Known::Nothing
            }
            (Known::Any, other) | (other, Known::Any) => other,
            (Known::Nothing, _) | (_, Known::Nothing) => Known::Nothing,
            (Known::Unit(unit), Known::Unit(_)) => Known::Unit(unit),
        }
    }
    /// An operand of a minimum or maximum: what stands for "no limit" has any unit.
    fn bound(&self, id: Id) -> Known {
        let no_limit = |literal: f64| literal == LONGEST_STEP || literal == 1.0 / LONGEST_STEP;
        if self.graph().literal(id).is_some_and(no_limit) { Known::Any } else { self.of(id) }
    }
    /// A selection: a literal on one side stands in for a value of the other side's unit.
    fn picked(&mut self, id: Id, a: Id, b: Id) -> Known {
        match (self.is_literal(a), self.is_literal(b)) {
            (true, false) => self.of(b),
            (false, true) => self.of(a),
            _ => self.equal(id, "a choice", self.of(a), self.of(b)),
        }
    }

    /// The node's own name or the value that it is part of, with its equation.
    fn place(&self, id: Id) -> String {
        let node = self.graph().node(id);
        let part_of = || {
            let users = self.graph().ids().skip(id.index() + 1);
            let uses = |user: &Id| self.graph().op(*user).operands().any(|operand| operand == id);
            let name = users.filter(uses).find_map(|user| self.graph().node(user).name.clone());
            let output = self.drawing.outputs().iter().find(|output| output.id == id).map(|output| output.name.clone());
            name.or(output).map_or(format!("node {}", id.index()), |name| format!("in `{name}`"))
        };
        let name = node.name.as_ref().map_or_else(part_of, |name| format!("`{name}`"));
        node.scope.map_or(name.clone(), |scope| format!("{name} of {scope}"))
    }

    fn results(&mut self, declared: &[Powers]) {
        for (output, expected) in self.drawing.outputs().iter().zip(declared) {
            match self.of(output.id) {
                Known::Unit(found) if found != *expected => self.faults.push(UnitFault::Result {
                    probe: self.key.to_string(),
                    output: output.name.clone(),
                    found: found.to_string(),
                    declared: expected.to_string(),
                }),
                _ => {}
            }
        }
    }
}
