//! How the smoothing length follows the density.

use crate::{Probe, any, between, own, positive, probe};
use etalon_reference::equations::smoothing_length;

pub(super) fn probes() -> Vec<Probe> {
    let mut list = probe! {
        in 1, 2, 3;
        smoothing_length::effective_neighbours::<R, D>(inverse_h, volume, support_volume);
        inverse_h: R = own("h_a^{-1}", "inverse smoothing length"), "L^-1", positive(1e-2, 1e2);
        volume: R = own("V_a", "volume element"), "L^nu", positive(1e-3, 1e3);
        support_volume: R = own(r"\omega_\nu R^\nu", "volume of the support in units of the smoothing length"), "1", between(2.0, 120.0);
        => neighbours: R = "n_{b,a}", "1";
    };
    list.extend(probe! {
        in 1, 2, 3;
        smoothing_length::settled_smoothing_length::<R, D>(h, neighbours, wanted, grad_h);
        h: R = own("h_a", "smoothing length"), "L", positive(1e-3, 1e3);
        neighbours: R = own("n_{b,a}", "neighbour number"), "1", positive(1.0, 1e3);
        wanted: R = own("n_0", "wanted neighbour number"), "1", positive(1.0, 1e3);
        grad_h: R = own(r"\Omega_a", "grad-h factor"), "1", any(1e-2, 1e1);
        => settled: R = own("h_*", "smoothing length at which the support would hold the wanted number"), "L";
    });
    list.extend(probe! {
        smoothing_length::next_smoothing_length(settled, settled_before);
        settled: R = own("h_*", "settled smoothing length"), "L", positive(1e-3, 1e3);
        settled_before: R = own("h_*'", "settled smoothing length a step ago"), "L", positive(1e-3, 1e3);
        => h: R = own("h_a", "smoothing length of the next step"), "L";
    });
    list
}
