//! GS25, Table 7: one figure of merit a test for each scheme.

use serde::Deserialize;

use super::schemes::SchemeName;
use super::setups::Test;
use super::{TableError, domain, published, rows_in_order};
use crate::text::one_line;

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
}

/// Which of two values of a metric is the better one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Better {
    /// The lower value.
    Lower,
    /// The higher value.
    Higher,
    /// The one closer to the metric's target.
    CloserTo,
}

/// What a column of Table 7 measures.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Metric {
    /// The column.
    pub key: MetricKey,
    /// The test it belongs to.
    pub test: Test,
    /// What is measured, in plain words.
    pub meaning: String,
    /// The printed values are to be multiplied by ten to this power.
    pub power_of_ten: i8,
    /// Which value is better.
    pub better: Better,
    /// The value aimed at, in the scale of the printed values; present with [`Better::CloserTo`] only.
    pub target: Option<f64>,
    /// What to beware of when comparing with these values.
    pub caveat: Option<String>,
}

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

published!(Results, 7, "gs25_table7.toml", Results::checked);

impl Results {
    /// Checks the rows.
    fn checked(file: &str, File { metric: mut metrics, result: rows }: File) -> Result<Self, TableError> {
        let keys: Vec<MetricKey> = metrics.iter().map(|metric| metric.key).collect();
        rows_in_order(file, "key", &keys, &MetricKey::ALL)?;
        let schemes: Vec<SchemeName> = rows.iter().map(|row| row.scheme).collect();
        rows_in_order(file, "scheme", &schemes, &SchemeName::ALL)?;
        for metric in &mut metrics {
            metric.meaning = one_line(&metric.meaning);
            metric.caveat = metric.caveat.as_deref().map(one_line);
            let power = metric.power_of_ten;
            // Ten to the power 22 is the last one that double precision holds exactly; see `value`.
            let exact = (-22..=0).contains(&power);
            domain(file, &metric.key, "power_of_ten", power.into(), exact, "between -22 and 0")?;
            let aims = metric.better == Better::CloserTo;
            let target = metric.target.unwrap_or(f64::NAN);
            domain(
                file,
                &metric.key,
                "target",
                target,
                target.is_finite() == aims,
                "given just where better = \"closer-to\"",
            )?;
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
        let power = i32::from(self.metric(key).power_of_ten);
        // The inverse of the power is exact, so dividing rounds once where multiplying would round twice.
        self.printed(scheme, key) / 10_f64.powi(-power)
    }
}
