//! What can be wrong with a ledger file.

use thiserror::Error;

use crate::unit::UnitError;

/// A fault in a ledger file. Each message names the file, the equation, the field and what to do.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum LedgerError {
    /// The file is not TOML.
    #[error("{file}, line {line}: this is not valid TOML ({message}); correct the line")]
    NotToml {
        /// The file.
        file: String,
        /// The line, from 1; 0 if the parser cannot tell.
        line: usize,
        /// The parser's message.
        message: String,
    },
    /// The part of the file before the equations is wrong.
    #[error("{file}, header: {message}; see spec/README.md for the keys of the header")]
    BadHeader {
        /// The file.
        file: String,
        /// What is wrong.
        message: String,
    },
    /// The file declares another paper than the one it is kept for.
    #[error(
        "{file}, header, field `paper`: it says `{found}`; write `{expected}` or put the text in that paper's file"
    )]
    WrongPaper {
        /// The file.
        file: String,
        /// The key it should have.
        expected: String,
        /// The key it has.
        found: String,
    },
    /// An equation has an unknown, missing or mistyped key.
    #[error("{file}, equation {equation}: {message}; see spec/README.md for the keys of an equation")]
    BadEntry {
        /// The file.
        file: String,
        /// The equation's number, or its place in the file where the number itself cannot be read.
        equation: String,
        /// What is wrong, with the name of the key.
        message: String,
    },
    /// A number is outside the paper's range.
    #[error("{file}, equation {number}, field `number`: the paper's equations are 1 to {last}; correct the number")]
    NumberOutOfRange {
        /// The file.
        file: String,
        /// The number found.
        number: u16,
        /// The paper's last number.
        last: u16,
    },
    /// A number occurs twice.
    #[error("{file}, equation {number}, field `number`: it occurs twice; keep one entry for each number")]
    DuplicateNumber {
        /// The file.
        file: String,
        /// The number.
        number: u16,
    },
    /// A number does not occur.
    #[error("{file}: equation {number} is missing; the file needs an [[equation]] for every number from 1 to {last}")]
    MissingNumber {
        /// The file.
        file: String,
        /// The first number that is missing.
        number: u16,
        /// The paper's last number.
        last: u16,
    },
    /// The entries are not in ascending order.
    #[error(
        "{file}, equation {number}, field `number`: it stands after equation {previous}; sort the entries by number"
    )]
    OutOfOrder {
        /// The file.
        file: String,
        /// The number that comes too late.
        number: u16,
        /// The number before it.
        previous: u16,
    },
    /// A field that must say something is empty.
    #[error("{file}, equation {number}, field `{field}`: it is empty; fill it in")]
    EmptyField {
        /// The file.
        file: String,
        /// The equation.
        number: u16,
        /// The field.
        field: &'static str,
    },
    /// The confidence and the open question contradict each other.
    #[error(
        "{file}, equation {number}, field `open_question`: the confidence is `open` but nothing says what is open; add the question"
    )]
    OpenWithoutQuestion {
        /// The file.
        file: String,
        /// The equation.
        number: u16,
    },
    /// Nothing says what an equation does with bad input.
    #[error(
        "{file}, equation {number}, field `bad_input`: it is missing; say whether bad values are guarded, refused, or propagate"
    )]
    MissingBadInput {
        /// The file.
        file: String,
        /// The equation.
        number: u16,
    },
    /// Values are caught although all propagate.
    #[error(
        "{file}, equation {number}, field `caught`: values are caught but `bad_input` says that all propagate; write `guards` or `refuses`, or remove them"
    )]
    CaughtYetPropagates {
        /// The file.
        file: String,
        /// The equation.
        number: u16,
    },
    /// A class of values is listed twice.
    #[error("{file}, equation {number}, field `caught`, values of `{of}`: one is listed twice; keep one")]
    DuplicateBadValue {
        /// The file.
        file: String,
        /// The equation.
        number: u16,
        /// The argument.
        of: String,
    },
    /// LaTeX whose braces, environments or dollar signs do not pair up.
    #[error("{file}, equation {number}, field `{field}`: {fault}; balance them")]
    Unbalanced {
        /// The file.
        file: String,
        /// The equation.
        number: u16,
        /// The field.
        field: &'static str,
        /// Which pair is broken, and where.
        fault: String,
    },
    /// A symbol's unit cannot be read.
    #[error("{file}, equation {number}, field `symbols`, unit of `{symbol}`: {source}")]
    BadUnit {
        /// The file.
        file: String,
        /// The equation.
        number: u16,
        /// The symbol.
        symbol: String,
        /// What is wrong with the unit, and what is right.
        source: UnitError,
    },
    /// A symbol is listed twice.
    #[error("{file}, equation {number}, field `symbols`: `{symbol}` is listed twice; keep one")]
    DuplicateSymbol {
        /// The file.
        file: String,
        /// The equation.
        number: u16,
        /// The symbol.
        symbol: String,
    },
    /// A listed symbol is not in the formula.
    #[error(
        "{file}, equation {number}, field `symbols`: `{symbol}` does not occur in the formula; write it as the formula does or remove it"
    )]
    SymbolNotInFormula {
        /// The file.
        file: String,
        /// The equation.
        number: u16,
        /// The symbol.
        symbol: String,
    },
    /// A letter of the formula is neither part of a listed symbol nor an index of the file.
    #[error(
        "{file}, equation {number}, field `symbols`: the formula uses `{letter}`, which no symbol explains; list its symbol"
    )]
    UnexplainedLetter {
        /// The file.
        file: String,
        /// The equation.
        number: u16,
        /// The letter or Greek command.
        letter: String,
    },
}
