//! How the smoothing length follows the density.

use etalon_kernels_gen::functions::dimension_root;
use etalon_kernels_gen::{Real, equation};

/// The number of neighbours the density implies, the particle included: the volume of the support over the particle's own volume.
///
/// `n = omega_nu (R h)^nu / V`. Unlike the count it is smooth: a neighbour that crosses the support's edge, where it has no weight, changes
/// nothing, and two precisions agree on it. Source: GS25 (16), C25 (13), read the other way round.
#[equation("gs25:16", "c25:13")]
pub fn effective_neighbours<R: Real, const D: usize>(inverse_h: R, volume: R, support_volume: R) -> R {
    support_volume / (volume * inverse_h.power(D as u32))
}

/// The smoothing length at which the support would hold the wanted number, `h_* = h [1 + ((n_0 / n)^(1/nu) - 1) / max(1, Omega)]`.
///
/// Its fixed point is `n = n_0` exactly. The volume changes with `h` too, so that `n` grows as `h^(nu Omega)`: next to a denser gas faster
/// than `h^nu`, for the support reaches into it. Dividing by Omega is Newton's method; without it the step overshoots there, and with
/// [`next_smoothing_length`] it would settle for `Omega < 4/3` only, which a contact exceeds. `grad_h` is Omega in either form.
/// Source: Hernquist & Katz 1989, with the effective number of neighbours, without their averaging over two steps, and with the
/// derivative (Price & Monaghan 2007); `docs/sod.md` has the limits.
#[equation(unnumbered = "smoothing-length update")]
pub fn settled_smoothing_length<R: Real, const D: usize>(h: R, neighbours: R, wanted: R, grad_h: R) -> R {
    let omega = 1.0.max(grad_h);
    h * ((dimension_root::<R, D>(wanted / neighbours) + (omega - 1.0)) / omega)
}

/// The smoothing length of the next step, `h_* h_* / h_*'`, with `h_*'` the settled one a step ago; the ratio is kept within 0.8 and 1.25.
///
/// A smoothing length that only follows the density lags behind it by a step or two, and pressure waves feed on the lag: in the
/// shock tube's rarefaction that doubles the error of the velocity. Carrying on the last change
/// takes the lag away to first order. Source: ours; `docs/sod.md` has the experiment.
#[equation(unnumbered = "smoothing-length update")]
pub fn next_smoothing_length<R: Real>(settled: R, settled_before: R) -> R {
    let change = 1.25.min(0.8.max(settled / settled_before));
    settled * change
}
