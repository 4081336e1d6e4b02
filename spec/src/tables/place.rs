//! Where in a paper a number stands.

use std::fmt;

use crate::paper::Paper;

/// A numbered place in a paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Place {
    /// A table.
    Table(u16),
    /// A figure, with its caption and what the text says of it.
    Figure(u16),
    /// A numbered equation.
    Equation(u16),
}

impl Place {
    /// The key by which the head of a file names such a place.
    pub(super) const fn key(self) -> &'static str {
        match self {
            Self::Table(_) => "table",
            Self::Figure(_) => "figure",
            Self::Equation(_) => "equation",
        }
    }

    /// The number.
    #[must_use]
    pub const fn number(self) -> u16 {
        match self {
            Self::Table(number) | Self::Figure(number) | Self::Equation(number) => number,
        }
    }

    /// The file of `tables/` that holds what stands there.
    pub(super) fn file(self, paper: Paper) -> String {
        format!("spec/tables/{paper}_{}{}.toml", self.key(), self.number())
    }
}

impl fmt::Display for Place {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let short = match self {
            Self::Table(_) => "Table",
            Self::Figure(_) => "Fig.",
            Self::Equation(_) => "Eq.",
        };
        write!(formatter, "{short} {}", self.number())
    }
}
