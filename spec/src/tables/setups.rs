//! GS25, Table 2: boxes and particle numbers.

use serde::Deserialize;

use super::{TableError, domain, loaded, rows_in_order};

/// A test of GS25, in the paper's order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Test {
    /// Sod's shock tube.
    ShockTube,
    /// Sedov's blast wave.
    Sedov,
    /// The steady vortex of Gresho and Chan.
    GreshoChanVortex,
    /// The Kelvin-Helmholtz instability.
    KelvinHelmholtz,
    /// The Rayleigh-Taylor instability.
    RayleighTaylor,
    /// A cloud in a supersonic wind.
    WindCloud,
    /// Driven subsonic turbulence.
    Turbulence,
}

impl Test {
    /// Every test, in the paper's order.
    pub const ALL: [Self; 7] = [
        Self::ShockTube,
        Self::Sedov,
        Self::GreshoChanVortex,
        Self::KelvinHelmholtz,
        Self::RayleighTaylor,
        Self::WindCloud,
        Self::Turbulence,
    ];
}

/// What the printed particle number per axis counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PerAxis {
    /// The particles along the edge of a unit cube of the same mean spacing.
    CubeRoot,
    /// The particles along the box's first side.
    AlongX,
}

/// The set-up of one test, in the paper's code units.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Setup {
    /// The test.
    pub test: Test,
    /// The letters before the scheme's number in the paper's run names, such as `ST` in `ST6`.
    pub prefix: String,
    /// The sides of the box; unit: length.
    #[serde(rename = "box")]
    pub box_size: [f64; 3],
    /// The number of particles in millions, as printed and so rounded.
    pub particles_in_millions: f64,
    /// The particle number per axis, as printed.
    pub particles_per_axis: u32,
    /// What that number counts.
    pub per_axis: PerAxis,
}

/// GS25, Table 2: the seven set-ups, each once and in the paper's order.
#[derive(Clone, Debug, PartialEq)]
pub struct Setups {
    setups: Vec<Setup>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    setup: Vec<Setup>,
}

loaded!(Setups, 2, "gs25_table2.toml", Setups::checked);

impl Setups {
    /// Checks the rows.
    fn checked(file: &str, File { setup: setups }: File) -> Result<Self, TableError> {
        let tests: Vec<Test> = setups.iter().map(|setup| setup.test).collect();
        rows_in_order(file, "test", &tests, &Test::ALL)?;
        for Setup { test, box_size, particles_in_millions: particles, particles_per_axis: per_axis, .. } in &setups {
            let positive = |field, value: f64| {
                domain(file, test, field, value, value.is_finite() && value > 0.0, "a positive number")
            };
            for side in box_size {
                positive("box", *side)?;
            }
            positive("particles_in_millions", *particles)?;
            positive("particles_per_axis", f64::from(*per_axis))?;
        }
        Ok(Self { setups })
    }

    /// The set-ups in the paper's order.
    pub fn iter(&self) -> impl Iterator<Item = &Setup> {
        self.setups.iter()
    }

    /// One test's set-up.
    #[must_use]
    pub fn get(&self, test: Test) -> &Setup {
        // Parsing has checked that every test stands at its place.
        &self.setups[test as usize]
    }
}
