//! GS25, Table 1: the dissipation schemes.

use std::fmt;

use serde::Deserialize;

use super::{TableError, domain, loaded, rows_in_order};

/// The name of a dissipation scheme of GS25, Table 1, in the paper's order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Deserialize)]
#[serde(rename_all = "UPPERCASE")]
pub enum SchemeName {
    /// Constant coefficients.
    Av,
    /// Time-dependent linear coefficient.
    Avsw,
    /// Slope-limited reconstruction.
    Avslr,
    /// Time-dependent coefficient and slope-limited reconstruction.
    Avswslr,
    /// Slope-limited reconstruction modulated by the Balsara factor.
    Avslrb,
    /// As before with the factor's square.
    Avslrb2,
    /// As before with a linear term limited by the factor above a floor.
    Avslrb2f,
}

impl SchemeName {
    /// Every scheme, in the paper's order.
    pub const ALL: [Self; 7] =
        [Self::Av, Self::Avsw, Self::Avslr, Self::Avswslr, Self::Avslrb, Self::Avslrb2, Self::Avslrb2f];

    /// The paper's name, with a plain F for its calligraphic one.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Av => "AV",
            Self::Avsw => "AVSW",
            Self::Avslr => "AVSLR",
            Self::Avswslr => "AVSWSLR",
            Self::Avslrb => "AVSLRB",
            Self::Avslrb2 => "AVSLRB2",
            Self::Avslrb2f => "AVSLRB2F",
        }
    }

    /// The paper's number, 1 to 7.
    #[must_use]
    pub const fn number(self) -> u8 {
        self as u8 + 1
    }
}

impl fmt::Display for SchemeName {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(self.as_str())
    }
}

/// The linear viscosity coefficient of a scheme. All its numbers are dimensionless.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub enum LinearCoefficient {
    /// The same for all particles at all times.
    Constant {
        /// The coefficient.
        value: f64,
    },
    /// A coefficient for each particle that follows GS25 equations 9 and 10.
    Switch {
        /// The smallest coefficient.
        smallest: f64,
        /// The largest coefficient.
        largest: f64,
    },
    /// The pair's Balsara factor, but not below a floor, times the largest coefficient: GS25 equation 27.
    BalsaraAboveFloor {
        /// The largest coefficient.
        largest: f64,
        /// The floor.
        floor: f64,
    },
}

/// One scheme.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Scheme {
    /// The paper's number, 1 to 7.
    pub number: u8,
    /// The paper's name.
    pub name: SchemeName,
    /// Whether the velocity difference is reconstructed, GS25 equations 11 to 17.
    pub slope_limited: bool,
    /// The power of the Balsara factor that modulates the reconstruction, GS25 equations 18 and 19; none where it does not.
    pub balsara_power: Option<u8>,
    /// The linear viscosity coefficient.
    pub linear_coefficient: LinearCoefficient,
}

/// GS25, Table 1: the seven schemes, each once and in the paper's order.
#[derive(Clone, Debug, PartialEq)]
pub struct Schemes {
    schemes: Vec<Scheme>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    scheme: Vec<Scheme>,
}

loaded!(Schemes, 1, "gs25_table1.toml", Schemes::checked);

impl Schemes {
    /// Checks the rows.
    fn checked(file: &str, File { scheme: schemes }: File) -> Result<Self, TableError> {
        let names: Vec<SchemeName> = schemes.iter().map(|scheme| scheme.name).collect();
        rows_in_order(file, "name", &names, &SchemeName::ALL)?;
        for scheme in &schemes {
            let Scheme { number, name, slope_limited, balsara_power, linear_coefficient } = *scheme;
            let right = number == name.number();
            domain(file, &name, "number", number.into(), right, "the scheme's number in the paper")?;
            if let Some(power) = balsara_power {
                domain(file, &name, "balsara_power", power.into(), power >= 1, "a power of at least 1")?;
                domain(
                    file,
                    &name,
                    "balsara_power",
                    power.into(),
                    slope_limited,
                    "of use without slope_limited = true",
                )?;
            }
            let share =
                |field, value: f64| domain(file, &name, field, value, (0.0..=1.0).contains(&value), "between 0 and 1");
            match linear_coefficient {
                LinearCoefficient::Constant { value } => share("linear_coefficient.value", value)?,
                LinearCoefficient::Switch { smallest, largest } => {
                    share("linear_coefficient.largest", largest)?;
                    let ordered = (0.0..=largest).contains(&smallest);
                    domain(file, &name, "linear_coefficient.smallest", smallest, ordered, "between 0 and the largest")?;
                }
                LinearCoefficient::BalsaraAboveFloor { largest, floor } => {
                    share("linear_coefficient.largest", largest)?;
                    share("linear_coefficient.floor", floor)?;
                }
            }
        }
        Ok(Self { schemes })
    }

    /// The schemes in the paper's order.
    pub fn iter(&self) -> impl Iterator<Item = &Scheme> {
        self.schemes.iter()
    }

    /// One scheme.
    #[must_use]
    pub fn get(&self, name: SchemeName) -> &Scheme {
        // Parsing has checked that every name stands at its place.
        &self.schemes[usize::from(name.number()) - 1]
    }
}
