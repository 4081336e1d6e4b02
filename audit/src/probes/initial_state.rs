//! Profiles that scenes start from.

use crate::{Probe, between, positive, probe};
use etalon_reference::equations::initial_state;

pub(super) fn probes() -> Vec<Probe> {
    probe! {
        initial_state::smoothed_pressure(x, centre, width, amplitude, offset);
        x: R = "x", "L", between(0.0, 1.0);
        centre: R = "x_c", "L", between(0.25, 0.75).with(&[0.5]);
        width: R = r"\delta", "L", positive(1e-3, 1e-1);
        amplitude: R = "A", "M L^(2-nu) T^-2", positive(1e-2, 1e2);
        offset: R = "B", "M L^(2-nu) T^-2", positive(1e-2, 1e2);
        => pressure: R = "P_0", "M L^(2-nu) T^-2";
    }
}
