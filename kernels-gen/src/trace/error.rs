//! What can go wrong between an equation and its drawing.

use std::fmt;

/// Why a computation could not be drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TraceError {
    /// `draw` was called inside the closure of another `draw` on the same thread.
    Nested,
    /// A symbol was used that does not belong to the drawing being made.
    ForeignSymbol,
    /// Two outputs have the same name.
    DuplicateOutput {
        /// The name.
        name: String,
    },
}

impl fmt::Display for TraceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            TraceError::Nested => {
                write!(f, "a drawing was begun while another is being made on this thread; finish the outer one first")
            }
            TraceError::ForeignSymbol => {
                write!(
                    f,
                    "a symbol from outside this drawing was used in it; take symbols only from this drawing's inputs"
                )
            }
            TraceError::DuplicateOutput { name } => {
                write!(f, "the output `{name}` was given twice; a record must not contain the same field twice")
            }
        }
    }
}
impl std::error::Error for TraceError {}

/// Why a drawing could not be evaluated.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum InterpretError {
    /// The number of values given is not the number of inputs.
    InputCount {
        /// What the drawing has.
        expected: usize,
        /// What was given.
        found: usize,
    },
}

impl fmt::Display for InterpretError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            InterpretError::InputCount { expected, found } => {
                write!(
                    f,
                    "the drawing has {expected} inputs but {found} values were given; give one per input, in order"
                )
            }
        }
    }
}
impl std::error::Error for InterpretError {}
