//! How often reconstruction turns the sign of a pair's velocity of approach: GS25 (29).

use crate::engine::{Engine, EngineError};
use crate::fields;
use crate::passes::{Physics, SignReversal};
use etalon_kernels_gen::equation;

/// Shares of pairs in which the raw and the reconstructed velocity of approach have opposite signs, so that viscosity cools.
///
/// The paper found at most 0.06 in one run, KH6. It does not say whether pairs that fly apart count.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReversedShares {
    /// Of all pairs of neighbours.
    pub of_all: f64,
    /// Of those that approach.
    pub of_approaching: f64,
}

/// The shares among the particles of an engine that has run a step's passes; none of no pairs are reversed.
///
/// # Errors
/// A scheme without velocity gradients, or an engine that carries no room for the counts ([`fields::PAIRS`] and the three after it).
#[equation("gs25:29", host)]
pub fn reversed_shares<const D: usize, E: Engine<D>>(
    engine: &mut E,
    physics: Physics,
) -> Result<ReversedShares, EngineError> {
    engine.run_pass(&SignReversal(physics))?;
    let mut total = |field| Ok::<f64, EngineError>(engine.read_scalar(field)?.into_iter().sum());
    // Every pair is counted from both ends.
    let (pairs, approaching) = (total(fields::PAIRS)?, total(fields::APPROACHING_PAIRS)?);
    let share = |part: f64, whole: f64| if whole > 0.0 { part / whole } else { 0.0 };
    Ok(ReversedShares {
        of_all: share(total(fields::REVERSED_PAIRS)?, pairs),
        of_approaching: share(total(fields::REVERSED_APPROACHING_PAIRS)?, approaching),
    })
}
