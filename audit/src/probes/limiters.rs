//! Limiters of two slopes.

use crate::{Name, Probe, any, not_negative, own, probe};
use etalon_reference::equations::limiters;
use etalon_reference::schemes::SlopeLimiter;

const A: &str = "a";
const B: &str = "b";
const F: &str = "f";
const SLOPE_A: Name = own("S_{ai}", "slope of the gas velocity along the pair");
const SLOPE_I: Name = own("S_{ia}", "slope of the dust velocity along the pair");

macro_rules! limiters {
    ($list:ident: $($function:ident;)*) => {
        $($list.extend(probe! {
            limiters::$function(slope_a, slope_b);
            slope_a: R = A, "F", any(1e-6, 1e6);
            slope_b: R = B, "F", any(1e-6, 1e6);
            => slope: R = F, "F";
        });)*
    };
}

macro_rules! choices {
    ($list:ident: $($variant:literal, $limiter:ident;)*) => {
        $($list.extend(probe! {
            as $variant;
            limiters::limited_slope(SlopeLimiter::$limiter, slope_a, slope_i);
            slope_a: R = SLOPE_A, "T^-1", any(1e-6, 1e6);
            slope_i: R = SLOPE_I, "T^-1", any(1e-6, 1e6);
            => slope: R = own("f(S_{ai},S_{ia})", "limited slope"), "T^-1";
        });)*
    };
}

pub(super) fn probes() -> Vec<Probe> {
    let mut list = Vec::new();
    limiters! { list:
        slope_minmod;
        slope_van_leer;
        slope_monotonized_central;
        slope_superbee;
    }
    list.extend(probe! {
        limiters::with_common_sign(size, slope_a, slope_b);
        size: R = own("|f|", "size of the limited slope"), "F", not_negative(1e-6, 1e6);
        slope_a: R = A, "F", any(1e-6, 1e6);
        slope_b: R = B, "F", any(1e-6, 1e6);
        => slope: R = F, "F";
    });
    choices! { list:
        "none", Unlimited;
        "minmod", Minmod;
        "van-leer", VanLeer;
        "MC", MonotonizedCentral;
        "superbee", Superbee;
    }
    list
}
