//! Interpolating kernels.

use crate::domain::Domain;
use crate::{Name, Probe, between, own, positive, probe};
use etalon_reference::equations::kernels;
use etalon_reference::equations::kernels::Shape;

const Q_SQUARED: Name = own("q^2", "squared distance over the squared smoothing length");
const VALUE: Name = own("w", "kernel, in units of an inverse volume of the smoothing length");
const SLOPE: Name = own(r"\frac{w'}{q}", "slope of the kernel over the distance");

/// From the centre to beyond the support; knots, the edge, and their neighbours in `f32`.
pub(super) fn distances(support: f64) -> Domain {
    let edge = support * support;
    let beside = |value: f64| [f64::from((value as f32).next_down()), f64::from((value as f32).next_up())];
    let near: Vec<f64> = [1.0, 4.0, edge].into_iter().flat_map(beside).collect();
    between(0.0, 1.1 * edge).with(&[1e-30, 1e-6, 1.0, 4.0, edge, 0.99 * edge]).with(&near)
}

macro_rules! kernels {
    ($list:ident: $($kernel:ident, $support:literal;)*) => {
        $($list.extend(probe! {
            in 1, 2, 3;
            kernels::$kernel::<R, D>(q_squared) -> |shape| { (shape.value, shape.slope_over_q) };
            q_squared: R = Q_SQUARED, "1", distances($support);
            => value: R = VALUE, "1";
               slope_over_q: R = SLOPE, "1";
        });)*
    };
}

pub(super) fn probes() -> Vec<Probe> {
    let mut list = probe! {
        kernels::sinc_half_pi(t) -> |pair| { pair };
        t: R = own("t", "a quarter of the squared distance over the squared smoothing length"), "1", between(0.0, 1.0).with(&[1e-30, 0.99, f64::from(1.0_f32.next_down())]);
        => sinc: R = own("s", "sinc of pi q / 2"), "1";
           slope: R = own(r"\frac{\mathrm{d}s}{\mathrm{d}t}", "its derivative by t"), "1";
    };
    kernels! { list:
        mixed_sinc, 2.0;
        cubic_spline, 2.0;
        quintic_spline, 3.0;
        wendland_c2, 2.0;
        wendland_c4, 2.0;
        wendland_c6, 2.0;
    }
    list.extend(probe! {
        in 1, 2, 3;
        kernels::smoothing_length_derivative::<R, D>(Shape { value, slope_over_q }, q_squared);
        value: R = VALUE, "1", positive(1e-6, 1.0).with(&[0.0]);
        slope_over_q: R = SLOPE, "1", between(-3.0, 0.0);
        q_squared: R = Q_SQUARED, "1", distances(2.0);
        => derivative: R = own(r"h^{\nu+1}\frac{\partial W}{\partial h}", "derivative of the kernel by the smoothing length, without its power of it"), "1";
    });
    list
}
