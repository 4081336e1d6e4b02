//! Components of a velocity around an axis.

use crate::{Probe, any, own, probe};
use etalon_reference::equations::polar;

pub(super) fn probes() -> Vec<Probe> {
    let mut list = probe! {
        in 1, 2, 3;
        polar::radial_velocity(v, x);
        v: Vector<R, D> = own(r"\mathbf{v}", "velocity"), "L T^-1", any(1e-3, 1e3);
        x: Vector<R, D> = own(r"\mathbf{x}", "position from the centre"), "L", any(1e-3, 1e3);
        => radial: R = own("v_r", "velocity away from the centre"), "L T^-1";
    };
    list.extend(probe! {
        polar::azimuthal_velocity(v, x);
        v: Vector<R, 2> = own(r"\mathbf{v}", "velocity"), "L T^-1", any(1e-3, 1e3);
        x: Vector<R, 2> = own(r"\mathbf{x}", "position from the axis"), "L", any(1e-3, 1e3);
        => azimuthal: R = own(r"v_\varphi", "velocity around the axis"), "L T^-1";
    });
    list
}
