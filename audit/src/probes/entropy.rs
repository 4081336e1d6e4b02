//! The change of entropy since the start.

use crate::{Probe, own, positive, probe};
use etalon_reference::diagnostics::entropy;

pub(super) fn probes() -> Vec<Probe> {
    probe! {
        entropy::entropy_change(u, u_0, rho, rho_0, gamma_minus_one);
        u: R = "u_a", "L^2 T^-2", positive(1e-3, 1e3);
        u_0: R = "u_{a,0}", "L^2 T^-2", positive(1e-3, 1e3);
        rho: R = r"\rho_a", "M L^-nu", positive(1e-3, 1e3);
        rho_0: R = r"\rho_{a,0}", "M L^-nu", positive(1e-3, 1e3);
        gamma_minus_one: R = own(r"(\gamma - 1)", "adiabatic index less one"), "1", positive(1e-3, 1.0).with(&[2.0 / 3.0, 0.4]);
        => change: R = own(r"\frac{S_a - S_{a,0}}{c_v}", "change of entropy over the specific heat"), "1";
    }
}
