//! Artificial conduction.

use crate::{Probe, any, not_negative, own, positive, probe};
use etalon_reference::equations::conduction;

pub(super) fn probes() -> Vec<Probe> {
    let mut list = probe! {
        conduction::conduction_velocity(pressure_a, pressure_b, mean_density);
        pressure_a: R = own("P_a", "pressure of the particle"), "M L^(2-nu) T^-2", not_negative(1e-3, 1e3);
        pressure_b: R = own("P_b", "pressure of the neighbour"), "M L^(2-nu) T^-2", not_negative(1e-3, 1e3);
        mean_density: R = own(r"\bar{\rho}_{ab}", "mean of the two densities"), "M L^-nu", positive(1e-3, 1e3);
        => velocity: R = own("v^u_{ab}", "speed at which energies are evened out"), "L T^-1";
    };
    list.extend(probe! {
        conduction::conduction_weight(grad_h, density);
        grad_h: R = own(r"\Omega_a", "grad-h factor"), "1", any(1e-2, 1e1);
        density: R = own(r"\rho_a", "density"), "M L^-nu", positive(1e-3, 1e3);
        => weight: R = own(r"(\Omega_a\rho_a)^{-1}", "what the particle brings to the conduction"), "M^-1 L^nu";
    });
    list.extend(probe! {
        in 1, 2, 3;
        conduction::conduction_rate(mass_b, coefficient, velocity, energy_ab, x_ab, inverse_r, weighted_a_ab);
        mass_b: R = own("m_b", "mass of the neighbour"), "M", positive(1e-2, 1e2);
        coefficient: R = own(r"\alpha_u", "coefficient of conduction"), "1", positive(1e-2, 1.0).with(&[0.1]);
        velocity: R = own("v^u_{ab}", "speed at which energies are evened out"), "L T^-1", not_negative(1e-2, 1e2);
        energy_ab: R = own("(u_a - u_b)", "energy of the particle less that of the neighbour"), "L^2 T^-2", any(1e-2, 1e2);
        x_ab: Vector<R, D> = own(r"\mathbf{r}_{ab}", "position of the particle less that of the neighbour"), "L", any(1e-2, 1e2);
        inverse_r: R = own(r"|\mathbf{r}_{ab}|^{-1}", "inverse distance; zero for coincident particles"), "L^-1", not_negative(1e-2, 1e2);
        weighted_a_ab: Vector<R, D> = own(r"\boldsymbol{\mathcal{A}}^{\Omega\rho}_{ab}", "sum of the two integral gradients, each with its particle's weight"), "M^-1 L^-1", any(1e-2, 1e2);
        => rate: R = own(r"\dot{u}^u_{ab}", "one neighbour's part of the conduction"), "L^2 T^-3";
    });
    list
}
