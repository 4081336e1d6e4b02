//! PL20 (8)-(12) and the entropy fix: velocities of gas and dust at a common point.

use crate::check::{UNIT, assert_close, gamma};
use crate::float::Float;
use crate::hard_inputs::Domain::{Any, NotNegative, Positive};
use crate::hard_inputs::try_all;
use etalon_kernels_gen::{Matrix, Symmetric, Vector};
use etalon_reference::equations::dust_reconstruction::*;
use etalon_reference::equations::gradients::{gradient, inverse_moments};
use etalon_reference::equations::kernels::kernel_shape;
use etalon_reference::schemes::{CommonPoint, DragReconstruction, Kernel, SlopeLimiter};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

fn unlimited(point: CommonPoint) -> DragReconstruction {
    DragReconstruction { point, limiter: SlopeLimiter::Unlimited }
}

#[test]
fn whole_numbers() {
    assert_eq!((mass_share(3.0, 1.0), mass_share(1.0, 3.0)), (0.75, 0.25));
    // J is not symmetric: J x = (5, 11), its transpose would give (7, 10).
    let jacobian = Matrix([[1.0, 2.0], [3.0, 4.0]]);
    assert_eq!(carried_velocity(Vector([100.0, 200.0]), jacobian, Vector([1.0, 2.0])).0, [105.0, 211.0]);
    // (1, 2) (5, 11)
    assert_eq!(slope_along_pair(jacobian, Vector([1.0, 2.0])), 27.0);
    // Shares 3/4 of the gas, 1/4 of the dust; 100 - 2 times: 1/4 8 + 3/4 16 = 14, or (8 + 16) / 2, or 3/4 (8 + 16).
    let at = |point| reconstructed_drag_velocity(unlimited(point), 100.0, 2.0, 8.0, 16.0, 0.75, 0.25);
    assert_eq!(CommonPoint::ALL.iter().map(|&p| at(p)).collect::<Vec<_>>(), [100.0, 76.0, 72.0, 64.0]);
    // Limited by minmod the slope is 8; as printed 2 times 3/4 of it.
    let limited = |point| DragReconstruction { point, limiter: SlopeLimiter::Minmod };
    let at = |point| reconstructed_drag_velocity(limited(point), 100.0, 2.0, 8.0, 16.0, 0.75, 0.25);
    assert_eq!(CommonPoint::ALL.iter().map(|&p| at(p)).collect::<Vec<_>>(), [100.0, 84.0, 84.0, 76.0]);
    // Mass 2, slope -3: m r r^T 3 = 6 r r^T, with r = (1, 2); dv = (5, 7).
    let (r_ba, v_ba) = (Vector([1.0, 2.0]), Vector([5.0, 7.0]));
    assert_eq!(correction_term(2.0, -3.0, r_ba), Symmetric([6.0, 12.0, 24.0, 0.0, 0.0, 0.0]));
    assert_eq!(gradient_sum_term(2.0, -3.0, v_ba, r_ba).0, [[30.0, 60.0], [42.0, 84.0]]);
    assert_eq!(DragReconstruction::RECOMMENDED.limiter, SlopeLimiter::MonotonizedCentral);
    assert_eq!(DragReconstruction::RECOMMENDED.point, CommonPoint::Barycentre);
    assert_eq!(DragReconstruction::NONE, unlimited(CommonPoint::Particles));
}

fn random_vector<const D: usize>(random: &mut Pcg64Mcg) -> Vector<f64, D> {
    Vector::from_fn(|_| 2.0 * random.random::<f64>() - 1.0)
}
fn random_matrix<const D: usize>(random: &mut Pcg64Mcg) -> Matrix<f64, D> {
    Matrix::from_fn(|_, _| 2.0 * random.random::<f64>() - 1.0)
}

/// Two linear flows, one of gas and one of dust: (10) is their difference at the common point, as (8) and (9) have it and as the flows have it.
/// The printed (10) is not, unless the masses are equal.
#[test]
fn two_linear_flows_are_compared_at_one_point() {
    let mut random = Pcg64Mcg::seed_from_u64(3);
    let mut wrong = 0;
    for equal_masses in [false, true] {
        for _ in 0..500 {
            let (j_g, j_d) = (random_matrix::<3>(&mut random), random_matrix::<3>(&mut random));
            let [offset_g, offset_d, r_a, r_i] = std::array::from_fn(|_| random_vector::<3>(&mut random));
            let gas = |x| offset_g + j_g.apply(x);
            let dust = |x| offset_d + j_d.apply(x);
            let m_a = 0.1 + random.random::<f64>();
            let m_i = if equal_masses { m_a } else { 3.0 * random.random::<f64>() + 0.1 };
            let (share_a, share_i) = (mass_share(m_a, m_i), mass_share(m_i, m_a));
            let r_ai = r_a - r_i;
            let r = r_ai.norm();
            let direction = r_ai.scale(1.0 / r);
            let omega = (gas(r_a) - dust(r_i)).dot(direction);
            let (s_a, s_i) = (slope_along_pair(j_g, direction), slope_along_pair(j_d, direction));
            // Components of at most one, gradients times separations of at most 6; some fifty roundings.
            let bound = gamma(50, UNIT) * 20.0;
            for (point, place) in [
                (CommonPoint::Midpoint, (r_a + r_i).scale(0.5)),
                (CommonPoint::Barycentre, (r_a.scale(m_a) + r_i.scale(m_i)).scale(1.0 / (m_a + m_i))),
            ] {
                let due = (gas(place) - dust(place)).dot(direction);
                let (from_a, from_i) = common_point(point, share_a, share_i);
                for axis in 0..3 {
                    assert_close("point from the gas", r_a[axis] + from_a * r_ai[axis], place[axis], bound);
                    assert_close("point from the dust", r_i[axis] + from_i * r_ai[axis], place[axis], bound);
                }
                let v_a = carried_velocity(gas(r_a), j_g, r_ai.scale(from_a));
                let v_i = carried_velocity(dust(r_i), j_d, r_ai.scale(from_i));
                assert_close("(8) less (9)", (v_a - v_i).dot(direction), due, bound);
                let got = reconstructed_drag_velocity(unlimited(point), omega, r, s_a, s_i, share_a, share_i);
                assert_close(&format!("(10), {point}"), got, due, bound);
            }
            let printed =
                reconstructed_drag_velocity(unlimited(CommonPoint::AsPrinted), omega, r, s_a, s_i, share_a, share_i);
            let due = omega - share_a * r * (s_a + s_i);
            assert_close("(10) as printed", printed, due, bound);
            let right =
                reconstructed_drag_velocity(unlimited(CommonPoint::Barycentre), omega, r, s_a, s_i, share_a, share_i);
            if equal_masses {
                assert_close("(10) as printed, equal masses", printed, right, bound);
            } else {
                wrong += usize::from((printed - right).abs() > 1e6 * bound);
            }
        }
    }
    assert!(wrong > 450, "the printed (10) was told apart in {wrong} of 500 cases only");
}

/// Gas and dust that move together do not drag each other, with every limiter; in the printed form they do.
#[test]
fn a_common_linear_flow_has_no_drag() {
    let mut random = Pcg64Mcg::seed_from_u64(4);
    for _ in 0..200 {
        let jacobian = random_matrix::<3>(&mut random);
        let r_ai = random_vector::<3>(&mut random);
        let r = r_ai.norm();
        let direction = r_ai.scale(1.0 / r);
        let omega = jacobian.apply(r_ai).dot(direction);
        let slope = slope_along_pair(jacobian, direction);
        let (share_a, share_i) = (mass_share(2.0, 0.5), mass_share(0.5, 2.0));
        for &limiter in SlopeLimiter::ALL {
            for point in [CommonPoint::Midpoint, CommonPoint::Barycentre] {
                let scheme = DragReconstruction { point, limiter };
                let left = reconstructed_drag_velocity(scheme, omega, r, slope, slope, share_a, share_i);
                // Sums of nine products of at most one times r.
                assert_close(&format!("{point}, {limiter}"), left, 0.0, gamma(20, UNIT) * 9.0 * r);
            }
            let scheme = DragReconstruction { point: CommonPoint::AsPrinted, limiter };
            let left = reconstructed_drag_velocity(scheme, omega, r, slope, slope, share_a, share_i);
            // One less twice the gas's share, 4/5.
            assert_close(&format!("as printed, {limiter}"), left, -0.6 * omega, gamma(20, UNIT) * 9.0 * r);
        }
    }
}

/// The printed point `r_a + mu_ai r_ai = r_i - mu_ia r_ai` is two points, and neither lies between the particles.
#[test]
fn the_printed_common_point_is_two_points_outside_of_the_pair() {
    // Along r_ai, the gas at 1 and the dust at 0; masses 2 and 1/2.
    let (from_a, from_i) = common_point(CommonPoint::AsPrinted, 0.8, 0.2);
    assert_eq!((1.0 + from_a, 0.0 + from_i), (1.8, -0.2));
    let (from_a, from_i) = common_point(CommonPoint::Barycentre, 0.8, 0.2);
    assert_eq!((1.0 + from_a, 0.0 + from_i), (0.8, 0.8));
    let nowhere = common_point(CommonPoint::Particles, 0.8, 0.2);
    assert_eq!([nowhere.0, nowhere.1].map(f64::to_bits), [0; 2], "nothing, without a sign");
}

#[test]
fn entropy_fix_takes_the_raw_velocity_where_the_signs_differ() {
    // Reconstructed, raw, due; an explicit step.
    for (star, raw, due) in [
        (2.0, 5.0, 2.0),
        (7.0, 5.0, 7.0),
        (-2.0, -5.0, -2.0),
        (-2.0, 5.0, 5.0),
        (2.0, -5.0, -5.0),
        (-0.5, 2.0, 2.0),
        (0.5, -2.0, -2.0),
        (-2.0, 0.5, 0.5),
        (2.0, -0.5, -0.5),
        (0.5, 0.25, 0.5),
        (-0.5, -0.25, -0.5),
        (-0.25, -0.5, -0.25),
        // Zero has no sign to differ.
        (0.0, 5.0, 0.0),
        (0.0, -5.0, 0.0),
        (3.0, 0.0, 3.0),
        (-3.0, 0.0, -3.0),
    ] {
        assert_eq!(entropy_fixed(star, raw, 0.0), due, "{star} for {raw}");
    }
    // A whole step that takes all of 12 from 5 ends at -7: the pair has gained energy. One that takes all of 8 ends at -3.
    assert_eq!(entropy_fixed(12.0, 5.0, 1.0), 5.0);
    assert_eq!(entropy_fixed(8.0, 5.0, 1.0), 8.0);
    assert_eq!(entropy_fixed(-12.0, -5.0, 1.0), -5.0);
    // Half of 12 leaves -1.
    assert_eq!(entropy_fixed(12.0, 5.0, 0.5), 12.0);
    // A little less than twice the difference, just that, a little more: only the last gains energy.
    for (star, due) in [(9.95, 9.95), (10.0, 10.0), (10.05, 5.0)] {
        assert_eq!((entropy_fixed(star, 5.0, 1.0), entropy_fixed(-star, -5.0, 1.0)), (due, -due), "{star}");
    }
}

/// Neighbours around a particle: masses, separations `r_b - r_a`, and `(dW/dr) / r` without the powers of `h`.
fn neighbours<const D: usize>(random: &mut Pcg64Mcg, count: usize, size: f64) -> Vec<(f64, Vector<f64, D>, f64)> {
    (0..count)
        .map(|_| {
            let r_ba = random_vector::<D>(random);
            let slope = kernel_shape::<f64, D>(Kernel::QuinticSpline, r_ba.norm_squared()).slope_over_q;
            (0.2 + random.random::<f64>(), r_ba.scale(size), slope)
        })
        .collect()
}

fn gradient_of<T: Float, const D: usize>(
    neighbours: &[(f64, Vector<f64, D>, f64)],
    velocity: impl Fn(Vector<f64, D>) -> Vector<f64, D>,
) -> Matrix<f64, D> {
    let at = |v: Vector<f64, D>| Vector::<T, D>::from_fn(|axis| T::lit(v[axis]));
    let mut sum = Matrix::<T, D>::from_fn(|_, _| T::zero());
    let mut correction = Symmetric::<T, D>::zero();
    for &(mass, r_ba, slope) in neighbours {
        let v_ba = velocity(r_ba) - velocity(Vector::zero());
        let part = gradient_sum_term(T::lit(mass), T::lit(slope), at(v_ba), at(r_ba));
        sum = Matrix::from_fn(|i, j| sum.0[i][j] + part.0[i][j]);
        let part = correction_term(T::lit(mass), T::lit(slope), at(r_ba));
        correction = Symmetric::from_fn(|i, j| correction.at(i, j) + part.at(i, j));
    }
    let gradient = linear_gradient(sum, correction);
    Matrix::from_fn(|i, j| gradient.0[i][j].to_f64())
}

/// Unequal masses, no symmetry, an offset, any unit of length, both precisions.
#[test]
fn gradient_of_a_linear_flow_is_exact() {
    fn check<T: Float, const D: usize>() {
        let mut random = Pcg64Mcg::seed_from_u64(5);
        for size in [1.0, 1e-7, 1e8] {
            for _ in 0..20 {
                let cloud = neighbours::<D>(&mut random, 40, size);
                let jacobian = random_matrix::<D>(&mut random).scale(1.0 / size);
                let offset = random_vector::<D>(&mut random);
                let got = gradient_of::<T, D>(&cloud, |x| offset + jacobian.apply(x));
                for (i, j) in (0..D).flat_map(|i| (0..D).map(move |j| (i, j))) {
                    // Sums of 40 terms, an inverse whose matrix has a condition below 30 here, and velocities of size 4 that are rounded on subtraction.
                    let bound = gamma(60, T::UNIT) * 30.0 * 4.0 / size;
                    assert_close(&format!("dv_{i}/dx_{j} in {D}-D"), got.0[i][j], jacobian.0[i][j], bound);
                }
            }
        }
    }
    check::<f64, 1>();
    check::<f64, 2>();
    check::<f64, 3>();
    check::<f32, 1>();
    check::<f32, 2>();
    check::<f32, 3>();
}

/// A particle alone, two on a line, a plane: what the neighbours do not span has no gradient, and so the pair no reconstruction.
#[test]
fn without_enough_neighbours_the_gradient_is_zero() {
    fn zero<const D: usize>(what: &str, cloud: &[(f64, Vector<f64, D>, f64)]) {
        for gradient in [gradient_of::<f64, D>(cloud, |x| x.scale(3.0)), gradient_of::<f32, D>(cloud, |x| x.scale(3.0))]
        {
            assert_eq!(gradient, Matrix::from_fn(|_, _| 0.0), "{what} in {D}-D");
        }
    }
    fn flattened<const D: usize>(directions: usize) -> Vec<(f64, Vector<f64, D>, f64)> {
        let mut random = Pcg64Mcg::seed_from_u64(6);
        let along: Vec<Vector<f64, D>> = (0..directions).map(|_| random_vector::<D>(&mut random)).collect();
        (0..30)
            .map(|_| {
                let place = along.iter().fold(Vector::zero(), |x, d| x + d.scale(random.random::<f64>() - 0.5));
                (1.0 + random.random::<f64>(), place, -1.0)
            })
            .collect()
    }
    zero::<1>("alone", &[]);
    zero::<2>("alone", &[]);
    zero::<3>("alone", &[]);
    zero::<1>("coincident", &[(1.0, Vector([0.0]), -1.0)]);
    zero::<2>("one neighbour", &flattened::<2>(1)[..1]);
    zero::<2>("on a line", &flattened::<2>(1));
    zero::<3>("on a line", &flattened::<3>(1));
    zero::<3>("in a plane", &flattened::<3>(2));
}

/// As a slab gets thinner its gradient fades, from all to nothing, without a jump.
#[test]
fn gradient_fades_as_the_neighbourhood_gets_flat() {
    let shares: Vec<f64> = (0..=400)
        .map(|step| {
            // Six neighbours on the axes: det(3 R / tr R) is about 27/8 of the squared thickness, 5e-4 at 0.0122 and
            // 1e-3 at 0.0172.
            let thickness = 0.011 + 0.007 * f64::from(step) / 400.0;
            let cloud: Vec<_> = (0..6)
                .map(|k| {
                    let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
                    let size = if k / 2 == 2 { thickness } else { 1.0 };
                    (1.0, Vector::<f64, 3>::from_fn(|axis| if axis == k / 2 { sign * size } else { 0.0 }), -1.0)
                })
                .collect();
            gradient_of::<f64, 3>(&cloud, |x| x).0[0][0]
        })
        .collect();
    assert_eq!(shares[0], 0.0);
    // Three roundings of the matrix, six of the inverse.
    assert_close("a slab thick enough", shares[400], 1.0, gamma(20, UNIT));
    // The quality grows by 27/4 t dt, 2.2e-6 a step at most: 0.0043 of the floor.
    for pair in shares.windows(2) {
        assert!(pair[1] >= pair[0] - gamma(20, UNIT) && pair[1] - pair[0] < 0.0045, "{} to {}", pair[0], pair[1]);
    }
}

/// Between the two qualities the share is `q / 5e-4 - 1`, with `q = det(nu R / tr R)`.
#[test]
fn gradient_has_the_share_that_its_neighbourhood_deserves() {
    fn check<const D: usize>(quality: impl Fn(f64) -> f64, thicknesses: [f64; 3]) {
        for thickness in thicknesses {
            // The identity but for the last axis.
            let correction = Symmetric::<f64, D>::from_fn(|i, j| match (i == j, i == D - 1) {
                (false, _) => 0.0,
                (true, last) => {
                    if last {
                        thickness
                    } else {
                        1.0
                    }
                }
            });
            let sum = Matrix::<f64, D>::from_fn(|i, j| 1.0 + (i + 2 * j) as f64);
            let share = quality(thickness) / 5e-4 - 1.0;
            assert!((0.05..0.95).contains(&share), "{share}: a thickness that would not tell");
            let whole = gradient(sum, inverse_moments(correction));
            let got = linear_gradient(sum, correction);
            for (i, j) in (0..D).flat_map(|i| (0..D).map(move |j| (i, j))) {
                let due = share * whole.0[i][j];
                // The quality, at most twice 5e-4, has some eight roundings on each side, the product two.
                let bound = gamma(20, UNIT) * 2.0 * whole.0[i][j].abs();
                assert_close(&format!("dv_{i}/dx_{j} in {D}-D"), got.0[i][j], due, bound);
            }
        }
    }
    // 4 t / (1 + t)^2 and 27 t / (2 + t)^3.
    check::<2>(|t| 4.0 * t / (1.0 + t).powi(2), [1.4e-4, 1.8e-4, 2.3e-4]);
    check::<3>(|t| 27.0 * t / (2.0 + t).powi(3), [1.6e-4, 2.1e-4, 2.8e-4]);
}

/// With all its factors the correction matrix tends to the density times the unit matrix: the sign of `grad W` and its powers of `h`.
#[test]
fn correction_matrix_tends_to_the_density() {
    fn check<const D: usize>() {
        let (spacing, density) = (0.25_f64, 5.0);
        let h = 4.0 * spacing;
        let mass = density * spacing.powi(D as i32);
        let reach = (3.0 * h / spacing) as i64;
        let across = (2 * reach + 1) as usize;
        let mut correction = Symmetric::<f64, D>::zero();
        for index in 0..across.pow(D as u32) {
            let r_ba = Vector::<f64, D>::from_fn(|axis| {
                spacing * ((index / across.pow(axis as u32) % across) as i64 - reach) as f64
            });
            let shape = kernel_shape::<f64, D>(Kernel::QuinticSpline, r_ba.norm_squared() / (h * h));
            let part = correction_term(mass, shape.slope_over_q / h.powi(D as i32 + 2), r_ba);
            correction = Symmetric::from_fn(|i, j| correction.at(i, j) + part.at(i, j));
        }
        for (i, j) in (0..D).flat_map(|i| (i..D).map(move |j| (i, j))) {
            let due = if i == j { density } else { 0.0 };
            // The slope of M6 is smooth to its third derivative: a lattice four times finer than h errs by some 1 / (8 pi)^5, 1e-7 times jumps of
            // a few hundred.
            assert_close(&format!("R_{i}{j} in {D}-D"), correction.at(i, j), due, 1e-4 * density);
        }
    }
    check::<1>();
    check::<2>();
    check::<3>();
}

fn hard_inputs<T: Float>(extreme: f64) {
    try_all("mass_share", [Positive; 2], extreme, |[a, b]: [T; 2]| mass_share(a, b));
    for &limiter in SlopeLimiter::ALL {
        for &point in CommonPoint::ALL {
            let scheme = DragReconstruction { point, limiter };
            try_all("reconstructed_drag_velocity", [Any, NotNegative, Any, Any], extreme, |[a, b, c, d]: [T; 4]| {
                reconstructed_drag_velocity(scheme, a, b, c, d, T::lit(0.75), T::lit(0.25))
            });
        }
    }
    try_all("entropy_fixed", [Any, Any, NotNegative], extreme, |[a, b, c]: [T; 3]| entropy_fixed(a, b, c));
    try_all("slope_along_pair", [Any, Any], extreme, |[a, b]: [T; 2]| slope_along_pair(Matrix([[a]]), Vector([b])));
}

#[test]
fn reconstruction_never_leaves_the_numbers() {
    hard_inputs::<f64>(1e50);
    hard_inputs::<f32>(1e6);
}
