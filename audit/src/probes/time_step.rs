//! How long a step may be.

use crate::{Probe, any, not_negative, own, positive, probe};
use etalon_reference::equations::time_step;

pub(super) fn probes() -> Vec<Probe> {
    let mut list = probe! {
        time_step::courant_step(h, signal_velocity);
        h: R = own("h_a", "smoothing length"), "L", positive(1e-3, 1e3);
        signal_velocity: R = own(r"v_{\mathrm{sig,max}}", "largest signal velocity to any neighbour"), "L T^-1", not_negative(1e-3, 1e3);
        => step: R = own(r"\Delta t", "time step"), "T";
    };
    list.extend(probe! {
        time_step::acceleration_step(h, acceleration);
        h: R = own("h_a", "smoothing length"), "L", positive(1e-3, 1e3);
        acceleration: R = own(r"|\dot{\mathbf{v}}_a|", "size of the acceleration"), "L T^-2", not_negative(1e-3, 1e3);
        => step: R = own(r"\Delta t", "time step"), "T";
    });
    list.extend(probe! {
        time_step::cooling_step(internal_energy, energy_rate);
        internal_energy: R = own("u_a", "specific internal energy"), "L^2 T^-2", any(1e-3, 1e3);
        energy_rate: R = own(r"\dot{u}_a", "rate of change of the specific internal energy"), "L^2 T^-3", any(1e-3, 1e3);
        => step: R = own(r"\Delta t", "time step"), "T";
    });
    list
}
