//! The equations of dust as symbols: drawn, simplified and interpreted they give the function's own bits, and they can be printed.

use etalon_kernels_gen::emit::{Header, MulAdd, wgsl};
use etalon_kernels_gen::trace::{Double, Drawing, Significand, Single, Symbol, draw, interpret};
use etalon_kernels_gen::{Matrix, Real, Symmetric, Vector};
use etalon_reference::equations::double_hump::double_hump;
use etalon_reference::equations::drag::*;
use etalon_reference::equations::dust_reconstruction::*;
use etalon_reference::equations::stiff_drag::*;
use etalon_reference::schemes::{CommonPoint, DragReconstruction, DragSigns, Kernel, SlopeLimiter};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

const INPUTS: usize = 24;

/// A gas and a dust particle in two dimensions, from gradients to what a step does to them: every equation of dust but the continuum's.
fn pair<R: Real>(scheme: DragReconstruction, signs: DragSigns, v: &[R]) -> Vec<R> {
    let vector = |i: usize| Vector([v[i], v[i + 1]]);
    let (k, rho_a, rho_i, m_a, m_i, inverse_h, step) = (v[0], v[1], v[2], v[3], v[4], v[5], v[6]);
    let (v_a, v_i, r_ai) = (vector(8), vector(10), vector(12));
    let jacobian = |i: usize| {
        let sum = gradient_sum_term(m_a, -v[7], vector(i), vector(i + 2));
        let correction = correction_term(m_a, -v[7], vector(i + 2));
        let other = correction_term(m_i, -v[7], vector(i + 4));
        linear_gradient(sum, Symmetric::from_fn(|p, q| correction.at(p, q) + other.at(p, q)))
    };
    let (j_a, j_i): (Matrix<R, 2>, Matrix<R, 2>) = (jacobian(14), jacobian(18));
    let r = r_ai.norm();
    let direction = r_ai.scale(R::one() / r);
    let omega = (v_a - v_i).dot(direction);
    let (share_a, share_i) = (mass_share(m_a, m_i), mass_share(m_i, m_a));
    let (slope_a, slope_i) = (slope_along_pair(j_a, direction), slope_along_pair(j_i, direction));
    let star = reconstructed_drag_velocity(scheme, omega, r, slope_a, slope_i, share_a, share_i);
    let hump = double_hump::<R, 2>(Kernel::WendlandC4, r * r * (inverse_h * inverse_h)) * (inverse_h * inverse_h);
    let gas_weight = drag_weight::<R, 2>(drag_rate(k, rho_a), m_i / rho_i, hump);
    let dust_weight = drag_weight::<R, 2>(drag_rate(k, rho_i), m_a / rho_a, hump);
    let rate = stopping_rate(k, rho_a, rho_i);
    let decayed = decayed_share(gas_weight + dust_weight, step);
    let whole = pair_drag(decayed, omega, entropy_fixed(star, omega, decayed), share_a, share_i, direction);
    let (from_a, from_i) = common_point(scheme.point, share_a, share_i);
    let carried = carried_velocity(v_a, j_a, r_ai.scale(from_a)) - carried_velocity(v_i, j_i, r_ai.scale(from_i));
    let gas = drag_acceleration(signs, gas_weight, star, direction);
    let dust = drag_acceleration(signs, dust_weight, star, -direction);
    let vectors = [gas, dust, whole.gas_velocity, whole.dust_velocity, carried];
    let scalars =
        [drag_heating(gas_weight, star, omega), whole.gas_energy, drag_step(rate), mean_drag_share(rate, step)];
    vectors.iter().flat_map(|v| v.0).chain(scalars).collect()
}

fn drawn<P: Significand>(scheme: DragReconstruction, signs: DragSigns) -> Drawing {
    let drawing = draw::<P>(|pen| {
        let inputs: Vec<Symbol<P>> = (0..INPUTS).map(|i| pen.input(&format!("input_{i}"))).collect();
        for (i, value) in pair(scheme, signs, &inputs).into_iter().enumerate() {
            pen.output(&format!("output_{i}"), value);
        }
    });
    drawing.unwrap().simplified()
}

#[test]
fn drawings_give_the_same_bits_and_can_be_printed() {
    let mut random = Pcg64Mcg::seed_from_u64(9);
    let mut compared = 0;
    for (i, &point) in CommonPoint::ALL.iter().enumerate() {
        for &limiter in SlopeLimiter::ALL {
            let (scheme, signs) = (DragReconstruction { point, limiter }, DragSigns::ALL[i % 2]);
            let drawing = drawn::<Double>(scheme, signs);
            for _ in 0..20 {
                let inputs: Vec<f64> = (0..INPUTS)
                    .map(|i| if i < 8 { 0.1 + random.random::<f64>() } else { 2.0 * random.random::<f64>() - 1.0 })
                    .collect();
                let direct = pair(scheme, signs, &inputs);
                let interpreted = interpret(&drawing, &inputs).unwrap();
                // Equal as numbers: simplification may change the sign of a zero.
                assert_eq!(interpreted, direct, "{point}, {limiter}");
                assert!(direct.iter().any(|value| *value != 0.0) && direct.iter().all(|value| value.is_finite()));
                compared += 1;
            }
            let head = Header { command: "cargo test", definition: "a pair of gas and dust" };
            let text = wgsl::function("pair", &drawn::<Single>(scheme, signs), &head, MulAdd::TwoRoundings).unwrap();
            // Without a common point no gradient is needed, and none is printed.
            let gradients = point != CommonPoint::Particles;
            for (id, due) in
                [("pl20:4", true), ("pl20:6", true), ("pl20:7", true), ("pl20:11", gradients), ("pl20:12", gradients)]
            {
                assert_eq!(text.contains(id), due, "{id} in what is printed for {point}, {limiter}");
            }
        }
    }
    assert_eq!(compared, 4 * 5 * 20);
}

/// What the registry has of this paper: all sixteen.
#[test]
fn every_equation_of_the_paper_is_registered() {
    let registered = etalon_kernels_gen::registered();
    for number in 1..=16 {
        let id = format!("pl20:{number}");
        assert!(registered.iter().any(|equation| equation.ids.contains(&id.as_str())), "{id} is not encoded");
    }
}
