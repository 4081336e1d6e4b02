//! GS25, Table 8: the variants that drive a wave with an oscillating cylinder.

use serde::Deserialize;

use super::{TableError, domain, loaded, rows_in_order};

/// The name of a variant of GS25, Table 8, in the paper's order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Deserialize)]
pub enum MembraneVariant {
    /// A small constant coefficient.
    #[serde(rename = "AV")]
    Av,
    /// Time-dependent linear coefficient.
    #[serde(rename = "AVSW")]
    Avsw,
    /// Slope-limited reconstruction modulated by the square of Balsara's factor.
    #[serde(rename = "AVSLRB2")]
    Avslrb2,
    /// Time-dependent coefficient and slope-limited reconstruction.
    #[serde(rename = "AVSWSLR")]
    Avswslr,
    /// Reconstruction modulated by the square of the factor that knows the wave's period.
    #[serde(rename = "AVSLRB*2")]
    AvslrbStar2,
    /// As before with a linear term limited by that factor above a floor.
    #[serde(rename = "AVSLRB*2F")]
    AvslrbStar2f,
}

impl MembraneVariant {
    /// Every variant, in the paper's order.
    pub const ALL: [Self; 6] =
        [Self::Av, Self::Avsw, Self::Avslrb2, Self::Avswslr, Self::AvslrbStar2, Self::AvslrbStar2f];

    /// The paper's name, with a plain F for its calligraphic one and the floor left out.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Av => "AV",
            Self::Avsw => "AVSW",
            Self::Avslrb2 => "AVSLRB2",
            Self::Avswslr => "AVSWSLR",
            Self::AvslrbStar2 => "AVSLRB*2",
            Self::AvslrbStar2f => "AVSLRB*2F",
        }
    }
}

/// The factor that modulates the reconstruction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Factor {
    /// Balsara's, GS25 equation 8.
    Balsara,
    /// The one that knows the period of a driven wave, GS25 equation 28.
    Waves,
}

/// The factor that modulates the reconstruction, and its power.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Modulation {
    /// The factor.
    pub factor: Factor,
    /// Its power.
    pub power: u8,
}

/// The coefficients of one variant.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MembraneSetting {
    /// The variant.
    pub name: MembraneVariant,
    /// Smallest and largest linear viscosity coefficient, dimensionless.
    pub linear_coefficient: [f64; 2],
    /// What modulates the reconstruction; none where there is none to modulate, or nothing that does.
    pub modulation: Option<Modulation>,
}

/// GS25, Table 8: the six variants, each once and in the paper's order.
#[derive(Clone, Debug, PartialEq)]
pub struct MembraneSettings {
    settings: Vec<MembraneSetting>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    variant: Vec<MembraneSetting>,
}

loaded!(MembraneSettings, 8, "gs25_table8.toml", MembraneSettings::checked);

impl MembraneSettings {
    /// Checks the rows.
    fn checked(file: &str, File { variant: settings }: File) -> Result<Self, TableError> {
        let names: Vec<MembraneVariant> = settings.iter().map(|setting| setting.name).collect();
        rows_in_order(file, "name", &names, &MembraneVariant::ALL)?;
        for MembraneSetting { name, linear_coefficient: [smallest, largest], modulation } in &settings {
            let part = (0.0..=1.0).contains(largest);
            domain(file, name, "linear_coefficient", *largest, part, "between 0 and 1")?;
            let ordered = (0.0..=*largest).contains(smallest);
            domain(file, name, "linear_coefficient", *smallest, ordered, "between 0 and the largest")?;
            if let Some(Modulation { power, .. }) = modulation {
                domain(file, name, "modulation.power", (*power).into(), *power >= 1, "a power of at least 1")?;
            }
        }
        Ok(Self { settings })
    }

    /// The variants in the paper's order.
    pub fn iter(&self) -> impl Iterator<Item = &MembraneSetting> {
        self.settings.iter()
    }

    /// One variant's coefficients.
    #[must_use]
    pub fn get(&self, name: MembraneVariant) -> &MembraneSetting {
        // Parsing has checked that every name stands at its place.
        &self.settings[name as usize]
    }
}
