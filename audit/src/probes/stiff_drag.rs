//! Drag over a whole step.

use crate::{Name, Probe, any, between, not_negative, own, positive, probe};
use etalon_reference::equations::stiff_drag;

const STEP: Name = own(r"\Delta t", "time step");

pub(super) fn probes() -> Vec<Probe> {
    let mut list = probe! {
        stiff_drag::decayed_share(rate, time_step);
        rate: R = own("w", "sum of the pair's two drag weights"), "T^-1", not_negative(1e-6, 1e6);
        time_step: R = STEP, "T", positive(1e-3, 1e3);
        => decayed: R = own("d", "part of the velocity difference that decays in the step"), "1";
    };
    list.extend(probe! {
        stiff_drag::mean_drag_share(stopping_rate, time_step);
        stopping_rate: R = own("t_s^{-1}", "inverse stopping time"), "T^-1", not_negative(1e-6, 1e6);
        time_step: R = STEP, "T", positive(1e-3, 1e3);
        => share: R = own(r"\bar{e}", "mean of the decaying exponential over the step"), "1";
    });
    list.extend(probe! {
        in 1, 2, 3;
        stiff_drag::pair_drag(decayed, omega, omega_star, share_a, share_i, direction)
            -> |drag| { (drag.gas_velocity, drag.dust_velocity, drag.gas_energy) };
        decayed: R = own("d", "part of the velocity difference that decays in the step"), "1", between(0.0, 1.0);
        omega: R = own(r"\omega_{ai}", "velocity difference along the pair"), "L T^-1", any(1e-3, 1e3);
        omega_star: R = own(r"\omega^*_{ai}", "reconstructed velocity difference along the pair"), "L T^-1", any(1e-3, 1e3);
        share_a: R = own(r"\mu_{ai}", "share of the gas particle in the mass of the pair"), "1", positive(1e-3, 1.0);
        share_i: R = own(r"\mu_{ia}", "share of the dust particle in the mass of the pair"), "1", positive(1e-3, 1.0);
        direction: Vector<R, D> = own(r"\hat{\mathbf{r}}_{ai}", "unit vector from the dust to the gas particle"), "1", any(1e-3, 1.0);
        => gas_velocity: Vector<R, D> = own(r"\Delta\mathbf{v}_a", "change of the gas velocity"), "L T^-1";
           dust_velocity: Vector<R, D> = own(r"\Delta\mathbf{v}_i", "change of the dust velocity"), "L T^-1";
           gas_energy: R = own(r"\Delta u_a", "change of the gas energy"), "L^2 T^-2";
    });
    list
}
