//! How much of a cloud in a wind is left (GS25 section 3.6).

use crate::sum::CompensatedSum;

/// A particle is of the cloud if its density is above this share of the cloud's (Agertz et al. 2007, section 4.2).
pub const DENSITY_SHARE: f64 = 0.64;
/// And its internal energy below this share of the wind's (same place, where it is the temperature).
pub const ENERGY_SHARE: f64 = 0.9;

/// What the initial gas was like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CloudAndWind {
    /// Density of the cloud.
    pub cloud_density: f64,
    /// Specific internal energy of the wind.
    pub wind_energy: f64,
}

impl CloudAndWind {
    /// Whether gas of this density and specific internal energy is of the cloud: dense and cold.
    pub fn is_cloud(&self, density: f64, energy: f64) -> bool {
        density > DENSITY_SHARE * self.cloud_density && energy < ENERGY_SHARE * self.wind_energy
    }

    /// The mass of the cloud, of particles given by mass, density and specific internal energy.
    ///
    /// At the start this is less than the nominal mass: density is smooth at the cloud's surface. A fraction is to be taken of the mass measured at
    /// the start.
    pub fn mass(&self, particles: impl IntoIterator<Item = [f64; 3]>) -> f64 {
        let of_cloud = particles.into_iter().filter(|[_, density, energy]| self.is_cloud(*density, *energy));
        of_cloud.map(|[mass, ..]| mass).collect::<CompensatedSum<f64>>().value()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_dense_and_cold_gas_counts() {
        let gas = CloudAndWind { cloud_density: 10.0, wind_energy: 1.5 };
        let particles = [
            [1.0, 10.0, 0.15],
            // Just dense and just cold enough.
            [0.25, 6.41, 1.34],
            // Mixed: too thin; shocked: too hot; both limits themselves; nothing known.
            [0.5, 6.39, 0.15],
            [0.5, 20.0, 1.36],
            [0.5, 6.4, 0.15],
            [0.5, 10.0, 1.35],
            [0.5, f64::NAN, 0.15],
        ];
        assert_eq!(gas.mass(particles), 1.25);
        assert_eq!(gas.mass([]), 0.0);
    }
}
