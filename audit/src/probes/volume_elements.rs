//! Volume elements.

use crate::{Probe, positive, probe};
use etalon_reference::equations::volume_elements;

pub(super) fn probes() -> Vec<Probe> {
    let mut list = probe! {
        volume_elements::volume_estimator(mass, standard_density);
        mass: R = "m_a", "M", positive(1e-3, 1e3);
        standard_density: R = r"\rho^0_a", "M L^-nu", positive(1e-3, 1e3);
        => estimator: R = "X_a", "L^nu";
    };
    list.extend(probe! {
        volume_elements::volume_element(estimator, normalisation);
        estimator: R = "X_a", "L^nu", positive(1e-3, 1e3);
        normalisation: R = "k_a", "1", positive(0.1, 1e1);
        => volume: R = "V_a", "L^nu";
    });
    list.extend(probe! {
        volume_elements::density(mass, volume);
        mass: R = "m_a", "M", positive(1e-3, 1e3);
        volume: R = "V_a", "L^nu", positive(1e-3, 1e3);
        => density: R = r"\rho_a", "M L^-nu";
    });
    list
}
