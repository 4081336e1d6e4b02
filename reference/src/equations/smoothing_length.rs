//! How the smoothing length follows the density.

use etalon_kernels_gen::functions::dimension_root;
use etalon_kernels_gen::{Real, equation};

/// The number of neighbours the density implies, the particle included: the volume of the support over the particle's own volume.
///
/// `n = omega_nu (R h)^nu / V`. Unlike the count it is smooth: a neighbour that crosses the support's edge, where it has no weight, changes
/// nothing, and two precisions agree on it. Source: GS25 (16) read the other way round.
#[equation("gs25:16")]
pub fn effective_neighbours<R: Real, const D: usize>(inverse_h: R, volume: R, support_volume: R) -> R {
    support_volume / (volume * inverse_h.power(D as u32))
}

/// The next smoothing length, `(h/2) [ 1 + (n_0 / n)^(1/nu) ]`: half-way to the one that holds `n_0` neighbours.
///
/// Its fixed point is `n = n_0` exactly. Source: Hernquist & Katz 1989, with the effective number of neighbours.
#[equation(unnumbered = "smoothing-length update")]
pub fn next_smoothing_length<R: Real, const D: usize>(h: R, neighbours: R, wanted: R) -> R {
    let stretch = dimension_root::<R, D>(wanted / neighbours);
    h * (0.5 + 0.5 * stretch)
}
