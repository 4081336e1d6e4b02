//! The change of entropy since the start: GS25 (30).

use etalon_kernels_gen::functions::logarithm;
use etalon_kernels_gen::{Real, equation};

/// The change of a particle's entropy over its specific heat, `ln(u/u_0) - (gamma - 1) ln(rho/rho_0)`.
///
/// For an ideal gas. All four values must be positive, and so must be the two ratios in the number's range. Source: GS25 (30).
#[equation("gs25:30")]
pub fn entropy_change<R: Real>(u: R, u_0: R, rho: R, rho_0: R, gamma_minus_one: R) -> R {
    logarithm(u / u_0) - gamma_minus_one * logarithm(rho / rho_0)
}

/// What is done with a particle whose energy, at the start or now, is not above the given floor.
///
/// The blast wave's surroundings start with an energy of 1e-8: their logarithms drown everything else.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ColdGas {
    /// It has no entropy and is left out of the mean.
    Excluded {
        /// Energies up to this one are cold; zero leaves out only what has no logarithm.
        floor: f64,
    },
    /// Its energy is taken to be the floor, which must be positive.
    Floored {
        /// The floor.
        floor: f64,
    },
}

/// The gas of a run at one time, by particle.
#[derive(Clone, Copy, Debug)]
pub struct GasColumns<'a> {
    /// Specific internal energies.
    pub energy: &'a [f64],
    /// Densities.
    pub density: &'a [f64],
}

/// Entropy changes of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct EntropyChanges {
    /// Of each particle; none where it was excluded.
    pub changes: Vec<Option<f64>>,
    /// Their mean over the particles that have one (GS25 Fig. 13).
    pub mean: f64,
    /// How many particles were excluded or floored.
    pub cold: usize,
}

/// Why there is no entropy.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum EntropyError {
    /// Columns of different length.
    #[error("column {column} has {found} entries for {expected} particles: give one for each particle")]
    Lengths {
        /// Which column.
        column: &'static str,
        /// Its length.
        found: usize,
        /// How many particles there are.
        expected: usize,
    },
    /// A value that no gas has.
    #[error("particle {particle} has {column} = {value}: {rule}")]
    Value {
        /// Which particle, from 0.
        particle: usize,
        /// Which column.
        column: &'static str,
        /// What it has.
        value: f64,
        /// What is allowed.
        rule: &'static str,
    },
    /// A floor that cannot be one.
    #[error("the floor of the energy is {given}: give a finite number, positive if energies are floored")]
    Floor {
        /// What was given.
        given: f64,
    },
    /// A mean over nothing.
    #[error("none of the {particles} particles is warmer than the floor of {floor}: lower it")]
    AllCold {
        /// How many there are.
        particles: usize,
        /// The floor.
        floor: f64,
    },
}

/// The entropy changes of all particles between two times.
///
/// # Errors
/// Columns of different length, values that are not finite or densities that are not positive, a bad floor, no warm particle.
#[equation("gs25:30", host)]
pub fn entropy_changes(
    start: GasColumns<'_>,
    now: GasColumns<'_>,
    gamma_minus_one: f64,
    cold_gas: ColdGas,
) -> Result<EntropyChanges, EntropyError> {
    let columns = [
        ("the starting energy", start.energy),
        ("the starting density", start.density),
        ("the energy", now.energy),
        ("the density", now.density),
    ];
    let expected = start.energy.len();
    for (which, (column, values)) in columns.into_iter().enumerate() {
        if values.len() != expected {
            return Err(EntropyError::Lengths { column, found: values.len(), expected });
        }
        let bad = |v: &f64| !v.is_finite() || which % 2 == 1 && *v <= 0.0;
        if let Some(particle) = values.iter().position(bad) {
            let rule = "energies must be finite, densities finite and positive";
            return Err(EntropyError::Value { particle, column, value: values[particle], rule });
        }
    }
    let (floor, keep) = match cold_gas {
        ColdGas::Excluded { floor } => (floor, false),
        ColdGas::Floored { floor } => (floor, true),
    };
    if !(floor.is_finite() && (floor > 0.0 || floor == 0.0 && !keep)) {
        return Err(EntropyError::Floor { given: floor });
    }
    let cold = |a: usize| start.energy[a] <= floor || now.energy[a] <= floor;
    let change = |a: usize| {
        let (u, u_0) = (now.energy[a].max(floor), start.energy[a].max(floor));
        (keep || !cold(a)).then(|| entropy_change(u, u_0, now.density[a], start.density[a], gamma_minus_one))
    };
    let changes: Vec<Option<f64>> = (0..expected).map(change).collect();
    let known: Vec<f64> = changes.iter().flatten().copied().collect();
    if known.is_empty() {
        return Err(EntropyError::AllCold { particles: expected, floor });
    }
    let mean = crate::norms::mean(known.into_iter());
    Ok(EntropyChanges { changes, mean, cold: (0..expected).filter(|a| cold(*a)).count() })
}
