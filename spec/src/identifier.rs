//! Identifiers of equations, such as `gs25:13`.

use std::fmt;
use std::str::FromStr;

use thiserror::Error;

use crate::paper::Paper;

/// A numbered equation of one of the papers; written `gs25:13`.
///
/// Only equations that exist can be named: the constructors check the number against the paper's range.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct EquationId {
    paper: Paper,
    number: u16,
}

/// Why a text is not the identifier of an equation in the ledger.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum IdError {
    /// The text has no colon between paper and number.
    #[error(
        "`{text}` is not an equation identifier: write the paper's key, a colon and the number, for example `gs25:13`"
    )]
    Shape {
        /// What was given.
        text: String,
    },
    /// The key names no paper of the ledger.
    #[error("`{text}`: the ledger has no paper `{paper}`; its papers are {}", papers())]
    UnknownPaper {
        /// What was given.
        text: String,
        /// The part before the colon.
        paper: String,
    },
    /// The part after the colon is not a plain whole number.
    #[error(
        "`{text}`: `{number}` is not an equation number; write digits without sign, spaces or leading zeros, \
         {} has 1 to {}", paper.key(), paper.last_number()
    )]
    NotANumber {
        /// What was given.
        text: String,
        /// The paper, which is known.
        paper: Paper,
        /// The part after the colon.
        number: String,
    },
    /// The paper has no equation of this number.
    #[error("{paper} has no equation {number}; its equations are 1 to {}", paper.last_number())]
    OutOfRange {
        /// The paper.
        paper: Paper,
        /// The number asked for.
        number: u64,
    },
}

fn papers() -> String {
    Paper::ALL.map(Paper::key).join(", ")
}

impl EquationId {
    /// The equation `number` of `paper`.
    ///
    /// # Errors
    /// [`IdError::OutOfRange`] if the paper has no equation of that number.
    pub fn new(paper: Paper, number: u16) -> Result<Self, IdError> {
        if (1..=paper.last_number()).contains(&number) {
            Ok(Self { paper, number })
        } else {
            Err(IdError::OutOfRange { paper, number: u64::from(number) })
        }
    }

    /// The paper.
    #[must_use]
    pub const fn paper(self) -> Paper {
        self.paper
    }

    /// The equation's number in the paper, from 1.
    #[must_use]
    pub const fn number(self) -> u16 {
        self.number
    }

    /// Every identifier of a paper, in order.
    pub fn of_paper(paper: Paper) -> impl Iterator<Item = Self> {
        (1..=paper.last_number()).map(move |number| Self { paper, number })
    }

    /// Every identifier of the ledger, paper by paper.
    pub fn all() -> impl Iterator<Item = Self> {
        Paper::ALL.into_iter().flat_map(Self::of_paper)
    }
}

impl fmt::Display for EquationId {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(&format!("{}:{}", self.paper, self.number))
    }
}

impl FromStr for EquationId {
    type Err = IdError;

    fn from_str(text: &str) -> Result<Self, IdError> {
        let Some((key, digits)) = text.split_once(':') else {
            return Err(IdError::Shape { text: text.to_owned() });
        };
        let Some(paper) = Paper::from_key(key) else {
            return Err(IdError::UnknownPaper { text: text.to_owned(), paper: key.to_owned() });
        };
        // One spelling per equation, so that identifiers can be compared as text: `gs25:08` is refused.
        let plain = !digits.is_empty()
            && digits.bytes().all(|byte| byte.is_ascii_digit())
            && (digits == "0" || !digits.starts_with('0'));
        let number = match digits.parse::<u64>() {
            Ok(number) if plain => number,
            _ => {
                return Err(IdError::NotANumber { text: text.to_owned(), paper, number: digits.to_owned() });
            }
        };
        match u16::try_from(number) {
            Ok(small) => Self::new(paper, small),
            Err(_) => Err(IdError::OutOfRange { paper, number }),
        }
    }
}

/// Whether the ledger has an equation of this identifier, without reading the ledger.
///
/// This is what the `#[equation]` macro asks at compile time. The ranges it uses are checked against the files
/// whenever the ledger is loaded.
///
/// # Errors
/// [`IdError`], which says what is wrong and what would be right.
pub fn exists(id: &str) -> Result<EquationId, IdError> {
    id.parse()
}
