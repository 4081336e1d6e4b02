//! Text in other languages, printed from drawings.
//!
//! - [`wgsl`]: functions for the WGSL driver templates; `f32`.
//! - [`c`]: the same graph as C99, `float` or `double`.
//! - [`latex`]: the formula for readers.
//!
//! Text is printed from the [simplified](crate::trace::Drawing::simplified) drawing, one `let` after the other in the order in
//! which the author's code ran. A value gets a line of its own if the author named it, if it is used more than once, if it
//! is what an equation returns, or if the line it would stand in becomes too long; everything else is written where it is
//! used. Where the equation changes a comment names it. The same drawing always gives the same text.

mod body;
pub mod c;
mod description;
mod error;
mod expression;
mod header;
pub mod latex;
mod names;
pub mod wgsl;

pub use error::EmitError;
pub use header::Header;

/// How the multiply-add of a graph is printed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MulAdd {
    /// `(a * b) + c`: what a graph means. Compilers and drivers may fuse it all the same; the
    /// software devices tried do not.
    #[default]
    TwoRoundings,
    /// `fma(a, b, c)`: one rounding where the target has it, two where it has not.
    Fused,
}
