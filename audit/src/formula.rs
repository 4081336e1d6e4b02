//! The formula as the code computes it, in the symbols of the probe.

use crate::probe::Probe;
use etalon_kernels_gen::emit::latex;
use etalon_kernels_gen::trace::{Double, TraceError};

/// A probe's equation printed back from its drawing: an `aligned` environment for LaTeX's display mode.
///
/// # Errors
/// [`TraceError`], as for [`Probe::draw`].
pub fn formula(probe: &Probe) -> Result<String, TraceError> {
    Ok(latex::formula(&probe.draw::<Double>()?, &probe.input_symbols(), &probe.output_symbols()))
}
