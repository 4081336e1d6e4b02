//! The ideal gas.

use crate::{Probe, any, not_negative, own, positive, probe};
use etalon_reference::equations::equation_of_state;

pub(super) fn probes() -> Vec<Probe> {
    let mut list = probe! {
        equation_of_state::pressure(gamma_minus_one, density, internal_energy);
        gamma_minus_one: R = own(r"(\gamma - 1)", "adiabatic index less one"), "1", positive(1e-3, 1.0).with(&[2.0 / 3.0, 0.4]);
        density: R = own(r"\rho_a", "density"), "M L^-nu", positive(1e-3, 1e3);
        internal_energy: R = own("u_a", "specific internal energy"), "L^2 T^-2", not_negative(1e-3, 1e3);
        => pressure: R = own("P_a", "pressure"), "M L^(2-nu) T^-2";
    };
    list.extend(probe! {
        equation_of_state::sound_speed(gamma_minus_one, internal_energy);
        gamma_minus_one: R = own(r"(\gamma - 1)", "adiabatic index less one"), "1", positive(1e-3, 1.0).with(&[2.0 / 3.0, 0.4]);
        internal_energy: R = own("u_a", "specific internal energy"), "L^2 T^-2", any(1e-3, 1e3);
        => sound_speed: R = own("c_a", "speed of sound"), "L T^-1";
    });
    list
}
