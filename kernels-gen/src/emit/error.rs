//! Why a drawing could not be printed.

use std::fmt;

/// Why a drawing could not be printed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum EmitError {
    /// WGSL has no portable double precision.
    NotSingle {
        /// The function asked for.
        function: String,
    },
    /// A constant, or an operation on constants, is not finite.
    NotFinite {
        /// The function asked for.
        function: String,
        /// The value it belongs to.
        name: String,
        /// The equation it was made in.
        equation: String,
    },
}

impl fmt::Display for EmitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            EmitError::NotSingle { function } => {
                write!(f, "`{function}` was drawn in double precision, which WGSL lacks; draw it with `Single`")
            }
            EmitError::NotFinite { function, name, equation } => {
                write!(
                    f,
                    "a constant in `{name}` of `{function}` ({equation}) is not finite; change the constants it is made of"
                )
            }
        }
    }
}
impl std::error::Error for EmitError {}
