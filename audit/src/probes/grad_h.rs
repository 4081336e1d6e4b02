//! The grad-h factor.

use crate::{Name, Probe, any, own, positive, probe};
use etalon_reference::equations::grad_h;

const MASS_SUM: Name = own(r"\Sigma^m_a", "sum of the kernel's derivatives over the neighbours' masses");
const ESTIMATOR_SUM: Name =
    own(r"\Sigma^X_a", "sum of the kernel's derivatives over the neighbours' volume estimators");
const DERIVATIVE: Name =
    own(r"\frac{\partial\rho_a}{\partial h_a}", "derivative of the density by the smoothing length");

pub(super) fn probes() -> Vec<Probe> {
    let mut list = probe! {
        in 1, 2, 3;
        grad_h::grad_h_factor::<R, D>(h, density, density_derivative);
        h: R = "h_a", "L", positive(1e-3, 1e3);
        density: R = r"\rho_a", "M L^-nu", positive(1e-3, 1e3);
        density_derivative: R = DERIVATIVE, "M L^(-1-nu)", any(1e-3, 1e3);
        => omega: R = r"\Omega_a", "1";
    };
    list.extend(probe! {
        grad_h::plain_density_derivative_term(volume_b, density_ba, d_ab);
        volume_b: R = own("V_b", "volume element of the neighbour"), "L^nu", positive(1e-3, 1e3);
        density_ba: R = own(r"(\rho_b - \rho_a)", "density of the neighbour less that of the particle"), "M L^-nu", any(1e-3, 1e3);
        d_ab: R = "D_{ab}", "L^(-1-nu)", any(1e-3, 1e3);
        => term: R = own(r"\left(\frac{\partial\rho_a}{\partial h_a}\right)_b", "one neighbour's part of the derivative"), "M L^(-1-nu)";
    });
    list.extend(probe! {
        grad_h::partition_derivative_term(volume_b, d_ab);
        volume_b: R = "V_b", "L^nu", positive(1e-3, 1e3);
        d_ab: R = "D_{ab}", "L^(-1-nu)", any(1e-3, 1e3);
        => term: R = own("S_{ab}", "one neighbour's part of the derivative of the partition of unity"), "L^-1";
    });
    list.extend(probe! {
        grad_h::density_derivative_exact(mass, estimator, normalisation, estimator_sum, mass_sum, self_kernel, self_d);
        mass: R = own("m_a", "mass"), "M", positive(1e-2, 1e2);
        estimator: R = own("X_a", "estimator of the volume"), "L^nu", positive(1e-2, 1e2);
        normalisation: R = own("k_a", "normalisation of the volume element"), "1", positive(0.1, 1e1);
        estimator_sum: R = ESTIMATOR_SUM, "L^-1", any(1e-2, 1e2);
        mass_sum: R = MASS_SUM, "M L^(-1-nu)", any(1e-2, 1e2);
        self_kernel: R = own("W_{aa}", "central value of the kernel"), "L^-nu", positive(1e-2, 1e2);
        self_d: R = own("D_{aa}", "derivative of the kernel's central value by the smoothing length"), "L^(-1-nu)", any(1e-2, 1e2);
        => derivative: R = DERIVATIVE, "M L^(-1-nu)";
    });
    list.extend(probe! {
        grad_h::density_derivative_corrected(
            mass, estimator, normalisation, density, estimator_sum, mass_sum, partition_sum, self_kernel
        );
        mass: R = "m_a", "M", positive(1e-2, 1e2);
        estimator: R = "X_a", "L^nu", positive(1e-2, 1e2);
        normalisation: R = "k_a", "1", positive(0.1, 1e1);
        density: R = r"\rho_a", "M L^-nu", positive(1e-2, 1e2);
        estimator_sum: R = ESTIMATOR_SUM, "L^-1", any(1e-2, 1e2);
        mass_sum: R = MASS_SUM, "M L^(-1-nu)", any(1e-2, 1e2);
        partition_sum: R = "S_a", "L^-1", any(1e-2, 1e2);
        self_kernel: R = "W_{aa}", "L^-nu", positive(1e-2, 1e2);
        => derivative: R = DERIVATIVE, "M L^(-1-nu)";
    });
    list
}
