//! How much work a drawing is.

use super::drawing::Drawing;
use super::graph::Op;
use std::fmt;
use std::ops::Add;

/// Operations of a drawing by kind; each needed node counts once. Both sides of a selection count, as both are evaluated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Count {
    /// Additions and subtractions.
    pub add: u32,
    /// Multiplications.
    pub multiply: u32,
    /// Fused or unfused `a * b + c`; each is two operations.
    pub multiply_add: u32,
    /// Divisions.
    pub divide: u32,
    /// Square roots.
    pub square_root: u32,
    /// Minima and maxima.
    pub min_max: u32,
    /// Comparisons.
    pub compare: u32,
    /// Selections.
    pub select: u32,
    /// Negations and absolute values: not counted as work, they are one bit.
    pub sign: u32,
    /// `and`, `or`, `not` of masks: not counted as work.
    pub mask: u32,
}

impl Count {
    /// Of the nodes a drawing needs.
    pub fn of(drawing: &Drawing) -> Self {
        let mut count = Count::default();
        for id in drawing.needed() {
            let slot = match drawing.graph().op(id) {
                Op::Input(_) | Op::Literal(_) | Op::Truth(_) => continue,
                Op::Add(..) | Op::Sub(..) => &mut count.add,
                Op::Mul(..) => &mut count.multiply,
                Op::MulAdd(..) => &mut count.multiply_add,
                Op::Div(..) => &mut count.divide,
                Op::Sqrt(_) => &mut count.square_root,
                Op::Min(..) | Op::Max(..) => &mut count.min_max,
                Op::Less(..) | Op::LessEqual(..) => &mut count.compare,
                Op::Select(..) => &mut count.select,
                Op::Neg(_) | Op::Abs(_) => &mut count.sign,
                Op::And(..) | Op::Or(..) | Op::Not(_) => &mut count.mask,
            };
            *slot += 1;
        }
        count
    }
    /// The total: `a * b + c` counts two, every other arithmetic operation, comparison and selection one, signs and masks
    /// nothing.
    pub fn flops(&self) -> u32 {
        self.add
            + self.multiply
            + 2 * self.multiply_add
            + self.divide
            + self.square_root
            + self.min_max
            + self.compare
            + self.select
    }
}

impl Add for Count {
    type Output = Count;
    fn add(self, other: Count) -> Count {
        Count {
            add: self.add + other.add,
            multiply: self.multiply + other.multiply,
            multiply_add: self.multiply_add + other.multiply_add,
            divide: self.divide + other.divide,
            square_root: self.square_root + other.square_root,
            min_max: self.min_max + other.min_max,
            compare: self.compare + other.compare,
            select: self.select + other.select,
            sign: self.sign + other.sign,
            mask: self.mask + other.mask,
        }
    }
}

/// `51 (12 add, 20 multiply, 9 multiply-add, 1 divide)`: the total, then the kinds that occur.
impl fmt::Display for Count {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kinds = [
            (self.add, "add"),
            (self.multiply, "multiply"),
            (self.multiply_add, "multiply-add"),
            (self.divide, "divide"),
            (self.square_root, "square root"),
            (self.min_max, "min/max"),
            (self.compare, "compare"),
            (self.select, "select"),
        ];
        let kinds: Vec<String> = kinds.iter().filter(|(n, _)| *n > 0).map(|(n, kind)| format!("{n} {kind}")).collect();
        write!(f, "{}", self.flops())?;
        if !kinds.is_empty() {
            write!(f, " ({})", kinds.join(", "))?;
        }
        Ok(())
    }
}

impl Drawing {
    /// The operations it takes. Meaningful after [simplification](Drawing::simplified).
    pub fn count(&self) -> Count {
        Count::of(self)
    }
}
