//! Small vectors and matrices against nalgebra's.

use approx::assert_relative_eq;
use etalon_kernels_gen::{Matrix, Quantity, Symmetric, Vector};
use nalgebra::{SMatrix, SVector};
use proptest::prelude::*;

/// Products of up to three terms of size ten at most, each rounded once, and their sum twice: a few hundred units of 2^-53.
const TOLERANCE: f64 = 1e-13;

fn numbers(count: usize) -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(-10.0..10.0, count)
}

fn agrees<const D: usize>(values: &[f64]) {
    let v = Vector::<f64, D>::from_fn(|i| values[i]);
    let w = Vector::<f64, D>::from_fn(|i| values[3 + i]);
    let m = Matrix::<f64, D>::from_fn(|i, j| values[6 + 3 * i + j]);
    let s = m.symmetric_part();
    let to_vector = |v: Vector<f64, D>| SVector::<f64, D>::from_fn(|i, _| v[i]);
    let to_matrix = |m: Matrix<f64, D>| SMatrix::<f64, D, D>::from_fn(|i, j| m.0[i][j]);
    let (nv, nw, nm) = (to_vector(v), to_vector(w), to_matrix(m));
    let ns = (nm + nm.transpose()) * 0.5;

    assert_relative_eq!(v.dot(w), nv.dot(&nw), epsilon = 300.0 * TOLERANCE);
    assert_relative_eq!(v.norm(), nv.norm(), epsilon = 300.0 * TOLERANCE);
    assert_relative_eq!(to_vector(v + w.scale(2.0)), nv + nw * 2.0, epsilon = 300.0 * TOLERANCE);
    assert_relative_eq!(to_vector(-(v - w)), nw - nv, epsilon = 300.0 * TOLERANCE);
    assert_relative_eq!(to_vector(m.apply(v)), nm * nv, epsilon = 300.0 * TOLERANCE);
    assert_relative_eq!(m.trace(), nm.trace(), epsilon = 300.0 * TOLERANCE);
    assert_relative_eq!(s.trace(), ns.trace(), epsilon = 300.0 * TOLERANCE);
    assert_relative_eq!(to_vector(s.apply(v)), ns * nv, epsilon = 300.0 * TOLERANCE);
    assert_relative_eq!(s.quadratic_form(v), nv.dot(&(ns * nv)), epsilon = 3e4 * TOLERANCE);
    let outer = Symmetric::outer(v, 0.5);
    let expected = nv * nv.transpose() * 0.5;
    for i in 0..D {
        for j in 0..D {
            assert_eq!(s.at(i, j), s.at(j, i));
            assert_relative_eq!(s.at(i, j), ns[(i, j)], epsilon = 300.0 * TOLERANCE);
            assert_relative_eq!(outer.at(i, j), expected[(i, j)], epsilon = 300.0 * TOLERANCE);
        }
    }
}

/// What is given out in order comes back in order.
fn round_trip<Q: Quantity<f64> + PartialEq + std::fmt::Debug>(values: &[f64]) {
    let mut next = values.iter().copied();
    let quantity = Q::from_each(|| next.next().unwrap());
    let mut given = Vec::new();
    quantity.for_each(|value| given.push(value));
    assert_eq!(given, values[..Q::COUNT]);
}

proptest! {
    #[test]
    fn vectors_and_matrices_agree_with_nalgebra(values in numbers(15)) {
        agrees::<1>(&values);
        agrees::<2>(&values);
        agrees::<3>(&values);
    }

    #[test]
    fn quantities_keep_their_order(values in numbers(9)) {
        round_trip::<Vector<f64, 2>>(&values);
        round_trip::<Vector<f64, 3>>(&values);
        round_trip::<Symmetric<f64, 1>>(&values);
        round_trip::<Symmetric<f64, 2>>(&values);
        round_trip::<Symmetric<f64, 3>>(&values);
        round_trip::<Matrix<f64, 2>>(&values);
        round_trip::<Matrix<f64, 3>>(&values);
    }
}
