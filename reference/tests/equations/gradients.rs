//! C25 (1)-(5): gradients by the integral approach.

use crate::check::{UNIT, assert_close};
use crate::cloud::Recipe;
use crate::float::Float;
use etalon_kernels_gen::{Matrix, Symmetric, Vector};
use etalon_reference::domain::separation;
use etalon_reference::equations::gradients::{
    gradient, gradient_term, integral_gradient, integral_term, inverse_moments, moment_term,
};
use etalon_reference::equations::kernels::kernel_shape;
use etalon_reference::schemes::Kernel;
use nalgebra::{DMatrix, DVector};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// A symmetric matrix with these eigenvalues and random axes, and the axes as columns.
fn with_eigenvalues<const D: usize>(values: [f64; D], random: &mut Pcg64Mcg) -> (DMatrix<f64>, DMatrix<f64>) {
    let mut axes = DMatrix::from_fn(D, D, |_, _| 2.0 * random.random::<f64>() - 1.0);
    for i in 0..D {
        // Gram and Schmidt, twice.
        for _ in 0..2 {
            for j in 0..i {
                let along = axes.column(j).dot(&axes.column(i));
                let other = axes.column(j).into_owned();
                axes.column_mut(i).axpy(-along, &other, 1.0);
            }
            let norm = axes.column(i).norm();
            axes.column_mut(i).unscale_mut(norm);
        }
    }
    (&axes * diagonal(values) * axes.transpose(), axes)
}

fn diagonal<const D: usize>(values: [f64; D]) -> DMatrix<f64> {
    DMatrix::from_diagonal(&DVector::from_column_slice(&values))
}

fn symmetric<T: Float, const D: usize>(m: &DMatrix<f64>) -> Symmetric<T, D> {
    Symmetric::from_fn(|i, j| T::lit(m[(i, j)]))
}

/// Error bound of an inverse by cofactors, per unit of `nu / tr(tau)`, where the scaled determinant is `quality`.
///
/// Scaled entries are at most 1.5 off the diagonal's mean and carry 2u; a cofactor (two products of at most 2.25) is
/// good to 20u, the determinant (three cofactors times entries of at most 3, trace 3) to 200u; `c = cof / det`, `|cof|
/// <= 2.25`.
fn inverse_error(quality: f64, unit: f64) -> f64 {
    (20.0 + 2.25 * 200.0 / quality) * unit / quality
}

fn inverse_agrees_with_nalgebra<T: Float, const D: usize>() {
    let mut random = Pcg64Mcg::seed_from_u64(7);
    let mut lifted = 0;
    for round in 0..300 {
        let condition = 10_f64.powf(4.0 * f64::from(round) / 300.0);
        let values: [f64; D] = std::array::from_fn(|i| match i {
            0 => 1.0,
            _ if i + 1 == D => 1.0 / condition,
            _ => condition.powf(-random.random::<f64>()),
        });
        let size = 10_f64.powf(6.0 * random.random::<f64>() - 3.0);
        let (matrix, axes) = with_eigenvalues(values.map(|v| v * size), &mut random);
        // What the function is given, rounding included.
        let tau = symmetric::<T, D>(&matrix);
        let rounded = DMatrix::from_fn(D, D, |i, j| tau.at(i, j).to_f64());
        let scale = D as f64 / rounded.trace();
        let quality = (&rounded * scale).determinant();
        let c = inverse_moments(tau);
        let (expected, smallest) = if quality > 1.01e-3 {
            (rounded.try_inverse().unwrap(), quality)
        } else if quality < 0.99e-3 && T::UNIT == UNIT {
            // From the eigenvalues: what lacks in quality is added to each.
            lifted += 1;
            let trace: f64 = values.iter().sum();
            let exact = values.map(|v| v * D as f64 / trace);
            let lift = 1e-3 - exact.iter().product::<f64>();
            let inverse = diagonal(exact.map(|v| 1.0 / (v + lift)));
            (&axes * inverse * axes.transpose() * scale, exact.iter().map(|v| v + lift).product())
        } else {
            continue;
        };
        // The oracle has the same kind of error in double precision; hence the second term.
        let bound = (inverse_error(smallest, T::UNIT) + inverse_error(smallest, UNIT)) * scale;
        for i in 0..D {
            for j in 0..D {
                let what = format!("c_{i}{j} in {D}-D, condition {condition:e}, quality {quality:e}");
                assert_close(&what, c.at(i, j).to_f64(), expected[(i, j)], bound);
            }
        }
    }
    assert!(D == 1 || T::UNIT > UNIT || lifted > 10, "{lifted} matrices below the quality floor");
}

#[test]
fn inverse_moments_is_the_inverse() {
    inverse_agrees_with_nalgebra::<f64, 1>();
    inverse_agrees_with_nalgebra::<f64, 2>();
    inverse_agrees_with_nalgebra::<f64, 3>();
    inverse_agrees_with_nalgebra::<f32, 1>();
    inverse_agrees_with_nalgebra::<f32, 2>();
    inverse_agrees_with_nalgebra::<f32, 3>();
}

/// By hand, so that no oracle is needed: tau = [[4, 2], [2, 3]] has c = [[3, -2], [-2, 4]] / 8.
#[test]
fn inverse_moments_of_whole_numbers() {
    let c = inverse_moments::<f64, 2>(Symmetric([4.0, 2.0, 3.0, 0.0, 0.0, 0.0]));
    for (got, due) in c.0.into_iter().zip([0.375, -0.25, 0.5]) {
        assert_close("c", got, due, 16.0 * UNIT);
    }
    let c = inverse_moments::<f64, 1>(Symmetric([4.0, 0.0, 0.0, 0.0, 0.0, 0.0]));
    assert_eq!(c.0[0], 0.25);
}

#[test]
fn inverse_moments_scales_exactly() {
    fn check<const D: usize>() {
        let mut random = Pcg64Mcg::seed_from_u64(11);
        for round in 0..40 {
            let flat = if round % 2 == 0 { 0.3 } else { 1e-5 };
            let values: [f64; D] =
                std::array::from_fn(|i| if i + 1 == D { flat } else { 1.0 + random.random::<f64>() });
            let tau = symmetric::<f64, D>(&with_eigenvalues(values, &mut random).0);
            let c = inverse_moments(tau);
            for exponent in [-200, -3, 1, 200] {
                let factor = 2_f64.powi(exponent);
                // Every operation is a product, a quotient, or a sum of things without a unit.
                assert_eq!(inverse_moments(tau.scale(factor)).scale(factor), c, "2^{exponent} in {D}-D");
            }
        }
    }
    check::<1>();
    check::<2>();
    check::<3>();
}

/// The moments of a few neighbours at unit weight.
fn moments<T: Float, const D: usize>(neighbours: &[[f64; D]]) -> Symmetric<T, D> {
    let mut sum = Symmetric::<T, D>::zero();
    for x in neighbours {
        let term = moment_term(T::one(), Vector(x.map(T::lit)), T::one());
        sum = Symmetric::from_fn(|i, j| sum.at(i, j) + term.at(i, j));
    }
    sum
}

#[test]
fn neighbours_that_do_not_span_the_space_give_a_finite_inverse() {
    fn check<T: Float, const D: usize>(neighbours: &[[f64; D]], directions: &[[f64; D]]) {
        let tau = moments::<T, D>(neighbours);
        let c = inverse_moments(tau);
        assert!(c.0.iter().all(|v| v.to_f64().is_finite()), "{D}-D, {neighbours:?}: {c:?}");
        // Along the neighbours c tau is one but for the lift, 1e-3 in units of the mean eigenvalue, over the
        // eigenvalue: at least 0.92 here. On a line cofactors of 1e-6 are formed from products of one, so single
        // precision keeps them to a third.
        for &x in directions {
            let v = Vector(x.map(T::lit));
            let back = c.apply(tau.apply(v));
            let share = back.dot(v).to_f64() / v.norm_squared().to_f64();
            let tolerance = if T::UNIT == UNIT { 1.2e-3 } else { 0.33 };
            assert_close(&format!("c tau along {x:?} of {neighbours:?}"), share, 1.0, tolerance);
        }
    }
    fn both<const D: usize>(neighbours: &[[f64; D]], directions: &[[f64; D]]) {
        check::<f64, D>(neighbours, directions);
        check::<f32, D>(neighbours, directions);
    }
    let mut random = Pcg64Mcg::seed_from_u64(3);
    let mut next = || 2.0 * random.random::<f64>() - 1.0;
    for _ in 0..200 {
        let line = [next(), next()];
        both::<2>(&[line, line.map(|x| -0.3 * x)], &[line]);
        let p = [next(), next(), next()];
        both::<3>(&[p, p.map(|x| 0.7 * x)], &[p]);
        // A second direction across the first and as long: the moments of these three have eigenvalues 1 and 9/4 in
        // the plane.
        let q = [next(), next(), next()];
        let cross = [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
        let size = |v: [f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
        let across = cross.map(|x| x * size(p) / size(cross));
        both::<3>(&[p, across, std::array::from_fn(|i| 0.5 * p[i] - across[i])], &[p, across]);
    }
    // Axes and diagonals, where cofactors cancel exactly.
    both::<3>(&[[0.0, 0.0, 1.0]], &[[0.0, 0.0, 1.0]]);
    both::<3>(&[[1.0, 1.0, 1.0]], &[[1.0, 1.0, 1.0]]);
    both::<2>(&[[1.0, 0.0]], &[[1.0, 0.0]]);
}

#[test]
fn a_particle_without_neighbours_has_no_gradient() {
    assert_eq!(inverse_moments(Symmetric::<f64, 1>::zero()), Symmetric::zero());
    assert_eq!(inverse_moments(Symmetric::<f64, 2>::zero()), Symmetric::zero());
    assert_eq!(inverse_moments(Symmetric::<f64, 3>::zero()), Symmetric::zero());
    assert_eq!(inverse_moments(Symmetric::<f32, 3>::zero()), Symmetric::zero());
}

#[test]
fn terms_of_whole_numbers() {
    let tau = moment_term::<f64, 3>(2.0, Vector([1.0, -2.0, 3.0]), 5.0);
    assert_eq!(tau.0, [10.0, -20.0, 30.0, 40.0, -60.0, 90.0]);
    // Rows are components of the field, columns axes.
    let integral = integral_term::<f64, 2>(2.0, Vector([1.0, 7.0]), Vector([3.0, -5.0]), 0.5);
    assert_eq!(integral.0, [[3.0, -5.0], [21.0, -35.0]]);
    let c = Symmetric::<f64, 2>([2.0, 1.0, 3.0, 0.0, 0.0, 0.0]);
    assert_eq!(gradient(Matrix([[1.0, 2.0], [3.0, 4.0]]), c).0, [[4.0, 7.0], [10.0, 15.0]]);
    assert_eq!(gradient_term::<f64, 2>(2.0, -3.0, Vector([1.0, 5.0])).0, [-6.0, -30.0]);
    assert_eq!(integral_gradient(c, Vector([1.0, -5.0]), 2.0).0, [-6.0, -28.0]);
}

/// A linear field with an offset a million times its variation, on a cloud unequal in everything: both routes give its
/// gradient.
#[test]
fn linear_fields_have_their_exact_gradient() {
    fn check<const D: usize>(kernel: Kernel) {
        let set = Recipe { jitter: 0.6, support: kernel.support(), ..Recipe::unequal::<D>(5) }.particles::<D>(true);
        let coordinates: [Vec<u64>; D] = std::array::from_fn(|axis| set.coordinates(axis));
        let slope = Matrix::<f64, D>::from_fn(|i, j| 1.0 + i as f64 - 2.5 * j as f64);
        let offset = 1e6;
        let mut checked = 0;
        for a in (0..set.len()).step_by(1 + set.len() / 20) {
            let inverse_h = 1.0 / set.particles()[a].smoothing_length;
            let mut tau = Symmetric::<f64, D>::zero();
            let mut neighbours = Vec::new();
            for (b, other) in set.particles().iter().enumerate() {
                let x_ba =
                    Vector::<f64, D>::from_fn(|axis| separation(coordinates[axis][b], coordinates[axis][a], 1.0));
                let kernel = kernel_shape::<f64, D>(kernel, x_ba.norm_squared() * inverse_h * inverse_h).value;
                if kernel > 0.0 && a != b {
                    // Any positive weights will do; masses are as unequal as volumes.
                    let term = moment_term(other.mass, x_ba, kernel);
                    tau = Symmetric::from_fn(|i, j| tau.at(i, j) + term.at(i, j));
                    neighbours.push((other.mass, x_ba, kernel));
                }
            }
            let quality = DMatrix::from_fn(D, D, |i, j| tau.at(i, j) * D as f64 / tau.trace()).determinant();
            if quality < 0.05 {
                continue;
            }
            checked += 1;
            let c = inverse_moments(tau);
            let mut integral = Matrix::<f64, D>::from_fn(|_, _| 0.0);
            let mut summed = Matrix::<f64, D>::from_fn(|_, _| 0.0);
            let mut weight = 0.0;
            for &(volume, x_ba, kernel) in &neighbours {
                // The field at either end is rounded at the size of its offset.
                let f_ba = Vector::from_fn(|i| (offset + slope.apply(x_ba)[i]) - offset);
                let term = integral_term(volume, f_ba, x_ba, kernel);
                integral = Matrix::from_fn(|i, j| integral.0[i][j] + term.0[i][j]);
                let a_ab = integral_gradient(c, x_ba, kernel);
                assert!(a_ab.dot(x_ba) > 0.0, "A_ab points away from the neighbour");
                for i in 0..D {
                    let term = gradient_term(volume, f_ba[i], a_ab);
                    summed.0[i] = std::array::from_fn(|j| summed.0[i][j] + term[j]);
                }
                weight += volume * a_ab.norm();
            }
            let got = gradient(integral, c);
            // Each difference is wrong by up to u times the offset (and its own rounding); it enters with the weight V
            // |A|. The inverse has its error, relative to c, times |tau| <= trace; sums of n terms have theirs,
            // relative to sum V |A| |x| <= weight times the support.
            let n = neighbours.len() as f64;
            let reach = kernel.support() / inverse_h;
            let biggest = 10.0;
            let from_field = 1.01 * UNIT * offset * weight;
            let from_inverse = D as f64 * inverse_error(quality, UNIT) * D as f64 * biggest;
            let from_sums = 2.0 * (n + 10.0) * UNIT * weight * reach * biggest;
            let bound = from_field + from_inverse + from_sums;
            for i in 0..D {
                for j in 0..D {
                    let what = format!("df_{i}/dx_{j} in {D}-D, {n} neighbours, quality {quality}");
                    assert_close(&what, got.0[i][j], slope.0[i][j], bound);
                    assert_close(&format!("{what}, summed"), summed.0[i][j], slope.0[i][j], bound);
                    assert_close(&format!("{what}, two routes"), summed.0[i][j], got.0[i][j], from_inverse + from_sums);
                }
            }
        }
        assert!(checked >= 10, "{D}-D: only {checked} particles with enough neighbours");
    }
    check::<1>(Kernel::MixedSinc);
    check::<2>(Kernel::MixedSinc);
    check::<3>(Kernel::MixedSinc);
    check::<2>(Kernel::WendlandC2);
}
