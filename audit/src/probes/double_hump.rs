//! Double-humped kernels.

use super::kernels::distances;
use crate::{Probe, own, probe};
use etalon_reference::equations::double_hump;
use etalon_reference::schemes::Kernel;

macro_rules! humps {
    ($list:ident: $($variant:literal, $kernel:ident;)*) => {
        $($list.extend(probe! {
            in 1, 2, 3;
            as $variant;
            double_hump::double_hump::<R, D>(Kernel::$kernel, q_squared);
            q_squared: R = own("q^2", "squared distance over the squared smoothing length"), "1", distances(Kernel::$kernel.support());
            => hump: R = own("h^{\\nu} D", "double-humped kernel, in units of an inverse volume of the smoothing length"), "1";
        });)*
    };
}

pub(super) fn probes() -> Vec<Probe> {
    let mut list = Vec::new();
    humps! { list:
        "sinc49", MixedSinc;
        "M4", CubicSpline;
        "M6", QuinticSpline;
        "C2", WendlandC2;
        "C4", WendlandC4;
        "C6", WendlandC6;
    }
    list
}
