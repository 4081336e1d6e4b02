//! What flows that depend on the distance from a point, a line or a plane have in common.

/// Why there is no solution.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum RadialError {
    /// Not 1, 2 or 3.
    #[error("a flow in {0} dimensions: there are 1, 2 and 3")]
    Dimension(usize),
    /// No gas, or none that the solution holds for.
    #[error("the adiabatic index gamma is {gamma}: give a number {allowed}")]
    Gamma {
        /// What was given.
        gamma: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// Not positive or not finite.
    #[error("the {field} is {value}: give a finite number above 0")]
    NotPositive {
        /// Which number.
        field: &'static str,
        /// What was given.
        value: f64,
    },
}

/// Refuses dimensions other than 1 to 3, and any of these numbers that is not finite and positive.
pub(super) fn check(dimension: usize, numbers: &[(&'static str, f64)]) -> Result<(), RadialError> {
    if !(1..=3).contains(&dimension) {
        return Err(RadialError::Dimension(dimension));
    }
    match numbers.iter().find(|(_, value)| !(value.is_finite() && *value > 0.0)) {
        Some(&(field, value)) => Err(RadialError::NotPositive { field, value }),
        None => Ok(()),
    }
}
