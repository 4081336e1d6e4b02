//! Units as powers of mass, length and time in a space of `nu` dimensions.

use std::fmt;
use std::str::FromStr;

use thiserror::Error;

/// A base of the unit system.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Base {
    /// Mass, written `M`.
    Mass,
    /// Length, written `L`.
    Length,
    /// Time, written `T`.
    Time,
    /// Whatever unit the field has on which a formula acts, written `F`.
    Field,
}

impl Base {
    /// Every base, in the order in which units are written.
    pub const ALL: [Self; 4] = [Self::Mass, Self::Length, Self::Time, Self::Field];

    /// The letter of this base.
    #[must_use]
    pub const fn letter(self) -> char {
        match self {
            Self::Mass => 'M',
            Self::Length => 'L',
            Self::Time => 'T',
            Self::Field => 'F',
        }
    }

    const fn position(self) -> usize {
        match self {
            Self::Mass => 0,
            Self::Length => 1,
            Self::Time => 2,
            Self::Field => 3,
        }
    }
}

/// An exponent `constant + per_dimension * nu`, where `nu` is the number of space dimensions.
///
/// A density is mass over length to the power `nu`, so its length exponent is `-nu`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Exponent {
    /// The part that does not depend on the dimension.
    pub constant: i8,
    /// The factor of `nu`.
    pub per_dimension: i8,
}

impl Exponent {
    /// The exponent's value in `nu` dimensions.
    #[must_use]
    pub fn in_dimensions(self, nu: u8) -> i32 {
        i32::from(self.constant) + i32::from(self.per_dimension) * i32::from(nu)
    }

    const fn is_zero(self) -> bool {
        self.constant == 0 && self.per_dimension == 0
    }
}

/// A unit: one exponent for each [`Base`].
///
/// Written as factors with a space between, for example `M L^-nu`, `L^(2-nu) T^-2`, or `1` for a pure number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Unit {
    exponents: [Exponent; 4],
}

/// Why a text is not a unit.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum UnitError {
    /// Nothing was written.
    #[error("the unit is empty; write `1` for a pure number")]
    Empty,
    /// A factor starts with something else than a base letter.
    #[error("`{factor}` does not start with M (mass), L (length), T (time) or F (the field's own unit)")]
    UnknownBase {
        /// The factor.
        factor: String,
    },
    /// A base occurs twice.
    #[error("`{letter}` occurs twice; gather its exponents into one factor")]
    Repeated {
        /// The base's letter.
        letter: char,
    },
    /// An exponent cannot be read.
    #[error(
        "`{factor}` has an exponent that cannot be read; write a whole number, `nu` or a sum in brackets: L^2, L^-nu, L^(2-nu)"
    )]
    Exponent {
        /// The factor.
        factor: String,
    },
}

impl Unit {
    /// The unit of a pure number.
    pub const DIMENSIONLESS: Self = Self { exponents: [Exponent { constant: 0, per_dimension: 0 }; 4] };

    /// The unit with these exponents, in the order of [`Base::ALL`].
    #[must_use]
    pub const fn new(exponents: [Exponent; 4]) -> Self {
        Self { exponents }
    }

    /// The exponent of a base.
    #[must_use]
    pub const fn exponent(self, base: Base) -> Exponent {
        self.exponents[base.position()]
    }
}

impl FromStr for Unit {
    type Err = UnitError;

    fn from_str(text: &str) -> Result<Self, UnitError> {
        let text = text.trim();
        if text.is_empty() {
            return Err(UnitError::Empty);
        }
        let mut unit = Self::DIMENSIONLESS;
        if text == "1" {
            return Ok(unit);
        }
        let mut seen = [false; 4];
        for factor in text.split_whitespace() {
            let base = Base::ALL.into_iter().find(|base| factor.starts_with(base.letter()));
            let Some(base) = base else {
                return Err(UnitError::UnknownBase { factor: factor.to_owned() });
            };
            if std::mem::replace(&mut seen[base.position()], true) {
                return Err(UnitError::Repeated { letter: base.letter() });
            }
            let unreadable = || UnitError::Exponent { factor: factor.to_owned() };
            let exponent = match &factor[base.letter().len_utf8()..] {
                "" => Exponent { constant: 1, per_dimension: 0 },
                rest => rest.strip_prefix('^').and_then(parse_exponent).ok_or_else(unreadable)?,
            };
            // `L^0` says nothing and would make two spellings of one unit.
            if exponent.is_zero() {
                return Err(unreadable());
            }
            unit.exponents[base.position()] = exponent;
        }
        Ok(unit)
    }
}

/// Reads `2`, `-nu`, `2nu` or, in brackets, a constant followed by a multiple of `nu`: `(2-nu)`, `(-1-nu)`.
fn parse_exponent(text: &str) -> Option<Exponent> {
    let bracketed = text.strip_prefix('(').and_then(|rest| rest.strip_suffix(')'));
    let Some(sum) = bracketed else {
        return match text.strip_suffix("nu") {
            Some(factor) => Some(Exponent { constant: 0, per_dimension: parse_factor(factor)? }),
            None => Some(Exponent { constant: parse_integer(text)?, per_dimension: 0 }),
        };
    };
    let split = sum.char_indices().skip(1).find(|(_, letter)| matches!(letter, '+' | '-'))?.0;
    let (constant, multiple) = sum.split_at(split);
    let factor = multiple.strip_suffix("nu")?;
    let exponent = Exponent {
        constant: parse_integer(constant)?,
        per_dimension: parse_factor(factor.strip_prefix('+').unwrap_or(factor))?,
    };
    (exponent.constant != 0 && exponent.per_dimension != 0).then_some(exponent)
}

/// The factor before `nu`: nothing means one, a bare minus means minus one.
fn parse_factor(text: &str) -> Option<i8> {
    match text {
        "" => Some(1),
        "-" => Some(-1),
        digits => parse_integer(digits),
    }
}

/// A whole number without plus sign or leading zeros.
fn parse_integer(text: &str) -> Option<i8> {
    let number: i8 = text.parse().ok()?;
    (number.to_string() == text).then_some(number)
}

impl fmt::Display for Exponent {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let multiple = match self.per_dimension {
            0 => String::new(),
            1 => "nu".to_owned(),
            -1 => "-nu".to_owned(),
            factor => format!("{factor}nu"),
        };
        match (self.constant, self.per_dimension) {
            (constant, 0) => write!(formatter, "{constant}"),
            (0, _) => formatter.write_str(&multiple),
            (constant, factor) if factor < 0 => write!(formatter, "({constant}{multiple})"),
            (constant, _) => write!(formatter, "({constant}+{multiple})"),
        }
    }
}

impl fmt::Display for Unit {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let factors: Vec<String> = Base::ALL
            .into_iter()
            .filter_map(|base| {
                let exponent = self.exponent(base);
                match (exponent.constant, exponent.per_dimension) {
                    (0, 0) => None,
                    (1, 0) => Some(base.letter().to_string()),
                    _ => Some(format!("{}^{exponent}", base.letter())),
                }
            })
            .collect();
        formatter.pad(if factors.is_empty() { "1".to_owned() } else { factors.join(" ") }.as_str())
    }
}
