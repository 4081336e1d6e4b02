//! Gradients by the integral approach.

use crate::{Name, Probe, any, between, own, positive, probe};
use etalon_reference::equations::gradients;

const X_BA: Name = own(r"\mathbf{x}_{ba}", "position of the neighbour less that of the particle");
const F_BA: Name = own(r"\mathbf{f}_{ba}", "the field at the neighbour less that at the particle");
const VECTOR: Name =
    own(r"\boldsymbol{\mathcal{A}}_{ab}", "integral-approach vector that replaces the kernel gradient");

/// Makes the components of a symmetric matrix, upper triangle row by row and between -1 and 1, into those of `L L^T`.
///
/// `L` is triangular with the same components, its diagonal raised by one. At -1 the matrix is singular.
pub(super) fn positive_definite(x: &mut [f64], dimension: usize) {
    let position = |i: usize, j: usize| i * dimension - i * (i + 1) / 2 + j;
    let mut triangular = [[0.0; 3]; 3];
    for i in 0..dimension {
        for j in i..dimension {
            triangular[i][j] = x[position(i, j)] + if i == j { 1.0 } else { 0.0 };
        }
    }
    for i in 0..dimension {
        for j in i..dimension {
            x[position(i, j)] = (0..dimension).map(|k| triangular[k][i] * triangular[k][j]).sum();
        }
    }
}

pub(super) fn probes() -> Vec<Probe> {
    let mut list = probe! {
        in 1, 2, 3;
        gradients::moment_term(volume, x_ba, kernel);
        volume: R = "V_b", "L^nu", positive(1e-3, 1e3);
        x_ba: Vector<R, D> = X_BA, "L", any(1e-3, 1e3);
        kernel: R = "W_{ab}", "L^-nu", positive(1e-3, 1e3);
        => moments: Symmetric<R, D> = own(r"\tau_{ab}", "one neighbour's part of the second-moment matrix"), "L^2";
    };
    list.extend(probe! {
        in 1, 2, 3;
        gradients::integral_term(volume, f_ba, x_ba, kernel);
        volume: R = "V_b", "L^nu", positive(1e-3, 1e3);
        f_ba: Vector<R, D> = F_BA, "F", any(1e-3, 1e3);
        x_ba: Vector<R, D> = X_BA, "L", any(1e-3, 1e3);
        kernel: R = "W_{ab}", "L^-nu", positive(1e-3, 1e3);
        => integral: Matrix<R, D> = own("I_{ab}", "one neighbour's part of the first-moment integral"), "L F";
    });
    list.extend(probe! {
        in 1, 2, 3;
        gradients::inverse_moments(tau);
        tau: Symmetric<R, D> = r"\tau", "L^2", between(-1.0, 1.0).with(&[0.0]);
        => c: Symmetric<R, D> = own("c", "inverse second-moment matrix"), "L^-2";
        @arrange "tau = L L^T for a triangular L with a diagonal between 0 and 2, flat neighbourhoods included" |x| {
            positive_definite(x, D);
        };
    });
    list.extend(probe! {
        in 1, 2, 3;
        gradients::gradient(integral, c);
        integral: Matrix<R, D> = "I", "L F", any(1e-3, 1e3);
        c: Symmetric<R, D> = own(r"\tau^{-1}", "inverse second-moment matrix"), "L^-2", any(1e-3, 1e3);
        => gradient: Matrix<R, D> = own(r"\nabla f", "gradient of the field, row component and column axis"), "L^-1 F";
    });
    list.extend(probe! {
        in 1, 2, 3;
        gradients::gradient_term(volume, f_ba, a_ab);
        volume: R = "V_b", "L^nu", positive(1e-3, 1e3);
        f_ba: R = own("(f_b - f_a)", "the field at the neighbour less that at the particle"), "F", any(1e-3, 1e3);
        a_ab: Vector<R, D> = VECTOR, "L^(-1-nu)", any(1e-3, 1e3);
        => term: Vector<R, D> = own(r"(\nabla f)_{ab}", "one neighbour's part of the gradient"), "L^-1 F";
    });
    list.extend(probe! {
        in 1, 2, 3;
        gradients::integral_gradient(c, x_ba, kernel);
        c: Symmetric<R, D> = "c_a", "L^-2", any(1e-3, 1e3);
        x_ba: Vector<R, D> = X_BA, "L", any(1e-3, 1e3);
        kernel: R = "W_{ab}", "L^-nu", positive(1e-3, 1e3);
        => a_ab: Vector<R, D> = VECTOR, "L^(-1-nu)";
    });
    list
}
