//! GS25, Table 7: one figure of merit a test for each scheme.

use serde::Deserialize;

use super::quantity::Quantity;
use super::schemes::SchemeName;
use super::setups::Test;
use super::{TableError, domain, loaded, rows_in_order};

/// A column of Table 7, in the paper's order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum MetricKey {
    /// Mean absolute error of the shock tube's velocity.
    ShockTubeVelocityL1,
    /// Largest density of the blast wave.
    SedovLargestDensity,
    /// Mean absolute error of the blast wave's radial velocity.
    SedovRadialVelocityL1,
    /// Mean absolute error of the vortex' azimuthal velocity.
    VortexAzimuthalVelocityL1,
    /// Amplitude of the Kelvin-Helmholtz mode.
    KelvinHelmholtzAmplitude,
    /// Vertical kinetic energy of the Rayleigh-Taylor instability.
    RayleighTaylorKineticEnergy,
    /// Rate at which the cloud loses mass.
    WindCloudDestructionRate,
    /// Wavenumber of the turbulent bottleneck.
    TurbulenceBottleneckWavenumber,
}

impl MetricKey {
    /// Every column, in the paper's order.
    pub const ALL: [Self; 8] = [
        Self::ShockTubeVelocityL1,
        Self::SedovLargestDensity,
        Self::SedovRadialVelocityL1,
        Self::VortexAzimuthalVelocityL1,
        Self::KelvinHelmholtzAmplitude,
        Self::RayleighTaylorKineticEnergy,
        Self::WindCloudDestructionRate,
        Self::TurbulenceBottleneckWavenumber,
    ];

    /// The key as the file of the table writes it.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::ShockTubeVelocityL1 => "shock_tube_velocity_l1",
            Self::SedovLargestDensity => "sedov_largest_density",
            Self::SedovRadialVelocityL1 => "sedov_radial_velocity_l1",
            Self::VortexAzimuthalVelocityL1 => "vortex_azimuthal_velocity_l1",
            Self::KelvinHelmholtzAmplitude => "kelvin_helmholtz_amplitude",
            Self::RayleighTaylorKineticEnergy => "rayleigh_taylor_kinetic_energy",
            Self::WindCloudDestructionRate => "wind_cloud_destruction_rate",
            Self::TurbulenceBottleneckWavenumber => "turbulence_bottleneck_wavenumber",
        }
    }
}

/// What a column of Table 7 measures.
pub type Metric = Quantity<MetricKey, Test>;

/// GS25, Table 7: eight metrics for each of the seven schemes.
#[derive(Clone, Debug, PartialEq)]
pub struct Results {
    metrics: Vec<Metric>,
    rows: Vec<Row>,
}

#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct Row {
    scheme: SchemeName,
    shock_tube_velocity_l1: f64,
    sedov_largest_density: f64,
    sedov_radial_velocity_l1: f64,
    vortex_azimuthal_velocity_l1: f64,
    kelvin_helmholtz_amplitude: f64,
    rayleigh_taylor_kinetic_energy: f64,
    wind_cloud_destruction_rate: f64,
    turbulence_bottleneck_wavenumber: f64,
}

impl Row {
    const fn printed(&self, key: MetricKey) -> f64 {
        match key {
            MetricKey::ShockTubeVelocityL1 => self.shock_tube_velocity_l1,
            MetricKey::SedovLargestDensity => self.sedov_largest_density,
            MetricKey::SedovRadialVelocityL1 => self.sedov_radial_velocity_l1,
            MetricKey::VortexAzimuthalVelocityL1 => self.vortex_azimuthal_velocity_l1,
            MetricKey::KelvinHelmholtzAmplitude => self.kelvin_helmholtz_amplitude,
            MetricKey::RayleighTaylorKineticEnergy => self.rayleigh_taylor_kinetic_energy,
            MetricKey::WindCloudDestructionRate => self.wind_cloud_destruction_rate,
            MetricKey::TurbulenceBottleneckWavenumber => self.turbulence_bottleneck_wavenumber,
        }
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    metric: Vec<Metric>,
    result: Vec<Row>,
}

loaded!(Results, 7, "gs25_table7.toml", Results::checked);

impl Results {
    /// Checks the rows.
    fn checked(file: &str, File { metric: mut metrics, result: rows }: File) -> Result<Self, TableError> {
        let keys: Vec<MetricKey> = metrics.iter().map(|metric| metric.key).collect();
        rows_in_order(file, "key", &keys, &MetricKey::ALL)?;
        let schemes: Vec<SchemeName> = rows.iter().map(|row| row.scheme).collect();
        rows_in_order(file, "scheme", &schemes, &SchemeName::ALL)?;
        for metric in &mut metrics {
            metric.checked(file)?;
        }
        for row in &rows {
            for key in MetricKey::ALL {
                let value = row.printed(key);
                domain(
                    file,
                    &(row.scheme, key),
                    "value",
                    value,
                    value.is_finite() && value != 0.0,
                    "a finite number other than zero",
                )?;
            }
        }
        Ok(Self { metrics, rows })
    }

    /// What the columns measure, in the paper's order.
    pub fn metrics(&self) -> impl Iterator<Item = &Metric> {
        self.metrics.iter()
    }

    /// What one column measures.
    #[must_use]
    pub fn metric(&self, key: MetricKey) -> &Metric {
        // Parsing has checked that every metric stands at its place.
        &self.metrics[key as usize]
    }

    /// The value as printed, before the metric's power of ten.
    #[must_use]
    pub fn printed(&self, scheme: SchemeName, key: MetricKey) -> f64 {
        self.rows[usize::from(scheme.number()) - 1].printed(key)
    }

    /// The value itself: the printed one times ten to the metric's power.
    #[must_use]
    pub fn value(&self, scheme: SchemeName, key: MetricKey) -> f64 {
        self.metric(key).scaled(self.printed(scheme, key))
    }
}
