//! Lanes and devices compute both sides of an `if` on data and pick one. So both must be numbers, wherever the values lie:
//! the side that is not taken too, which a scalar never sees.
//!
//! Every equation with such an `if` is drawn, and every node of its drawing evaluated.

use etalon_kernels_gen::trace::{Double, Significand, Single, Symbol, draw, first_not_finite};
use etalon_kernels_gen::{Real, Symmetric};
use etalon_reference::equations::dissipation::balsara_limiter;
use etalon_reference::equations::gradients::inverse_moments;
use etalon_reference::equations::hydrodynamics::{crossed_weight, pressure_coefficient};
use etalon_reference::equations::initial_state::smoothed_pressure;
use etalon_reference::equations::kernels::kernel_shape;
use etalon_reference::equations::reconstruction::{short_range_factor, slope_limiter};
use etalon_reference::equations::time_step::{acceleration_step, cooling_step, courant_step};
use etalon_reference::schemes::Kernel;

/// Draws `f` and evaluates all of it on every combination of the values.
fn try_drawn<P: Significand, T: Real<Mask = bool> + Into<f64>, const N: usize>(
    name: &str,
    values: [&[f64]; N],
    f: impl Fn([Symbol<P>; N]) -> Vec<Symbol<P>>,
) {
    let drawing = draw::<P>(|pen| {
        let inputs: [Symbol<P>; N] = std::array::from_fn(|i| pen.input(&format!("x_{i}")));
        for (i, value) in f(inputs).into_iter().enumerate() {
            pen.output(&format!("y_{i}"), value);
        }
    })
    .unwrap();
    let total: usize = values.iter().map(|choice| choice.len()).product();
    assert!(total > 0);
    for mut index in 0..total {
        let inputs: [f64; N] = std::array::from_fn(|i| {
            let value = values[i][index % values[i].len()];
            index /= values[i].len();
            value
        });
        let broken = first_not_finite(&drawing, &inputs.map(T::lit)).unwrap();
        let node = broken.map(|id| drawing.graph().node(id));
        assert!(node.is_none(), "{name}{inputs:?}: {node:?} is not finite");
    }
}

/// `extreme` is as far as the deepest product or quotient stays within the number's range.
fn all<P: Significand, T: Real<Mask = bool> + Into<f64>>(extreme: f64) {
    let least = 1.0 / extreme;
    let any: &[f64] = &[0.0, -0.0, least, -least, 0.3, 1.0, -1.0, extreme, -extreme];
    let not_negative: &[f64] = &[0.0, least, 0.3, 1.0, extreme];
    let positive: &[f64] = &[least, 0.3, 1.0, extreme];
    // Around the centre, the knots and the edges.
    let q_squared: &[f64] = &[0.0, least, 1e-3, 0.5, 1.0, 1.0001, 3.9999, 4.0, 8.9999, 9.0, 20.0, extreme];
    for &kernel in Kernel::ALL {
        let both = |shape: etalon_reference::equations::kernels::Shape<_>| vec![shape.value, shape.slope_over_q];
        let name = format!("{kernel} at q^2 = ");
        try_drawn::<P, T, 1>(&name, [q_squared], |[q]| both(kernel_shape::<_, 1>(kernel, q)));
        try_drawn::<P, T, 1>(&name, [q_squared], |[q]| both(kernel_shape::<_, 2>(kernel, q)));
        try_drawn::<P, T, 1>(&name, [q_squared], |[q]| both(kernel_shape::<_, 3>(kernel, q)));
    }
    try_drawn::<P, T, 2>("slope_limiter", [any; 2], |[a, b]| vec![slope_limiter(a, b)]);
    try_drawn::<P, T, 3>("short_range_factor", [not_negative, positive, positive], |[q, crit, fold]| {
        vec![short_range_factor(q, crit, fold)]
    });
    try_drawn::<P, T, 4>("balsara_limiter", [any, not_negative, not_negative, positive], |[d, c, s, h]| {
        vec![balsara_limiter(d, c, s, h)]
    });
    try_drawn::<P, T, 4>("pressure_coefficient", [not_negative, any, positive, positive], |[p, o, k, r]| {
        vec![pressure_coefficient(p, o, k, r)]
    });
    // Voids too, and a ratio of six, at which the part beyond a ratio of three would be zero in the side that smooth flow leaves.
    let densities: &[f64] = &[0.0, least, 0.3, 1.0, 6.0, extreme];
    try_drawn::<P, T, 4>("crossed_weight", [densities; 4], |[a, b, c, d]| vec![crossed_weight(a, b, c, d)]);
    try_drawn::<P, T, 3>("smoothed_pressure", [any, any, positive], |[x, c, w]| {
        vec![smoothed_pressure(x, c, w, Symbol::lit(0.45), Symbol::lit(0.55))]
    });
    try_drawn::<P, T, 2>("courant_step", [positive, not_negative], |[h, v]| vec![courant_step(h, v)]);
    try_drawn::<P, T, 2>("acceleration_step", [positive, not_negative], |[h, a]| vec![acceleration_step(h, a)]);
    try_drawn::<P, T, 2>("cooling_step", [any, any], |[u, rate]| vec![cooling_step(u, rate)]);
    // Moments of neighbours along two directions in space, of any weight: flat, on a line, or none at all.
    try_drawn::<P, T, 2>("inverse_moments", [not_negative; 2], |[a, b]| {
        let zero = Symbol::zero();
        inverse_moments::<_, 3>(Symmetric([a, zero, zero, a + b, b, b])).0.to_vec()
    });
}

#[test]
fn both_sides_of_every_choice_are_finite() {
    all::<Double, f64>(1e40);
    all::<Single, f32>(1e5);
}
