//! The equations of motion.

use crate::{Name, Probe, any, between, not_negative, own, positive, probe};
use etalon_reference::equations::hydrodynamics;

const A_AB_A: &str = r"\boldsymbol{\mathcal{A}}_{ab}";
const A_AB_B: Name =
    own(r"\boldsymbol{\mathcal{A}}^b_{ab}", "integral-approach vector with the neighbour's smoothing length");
const MEAN_A_AB: Name = own(r"\bar{\boldsymbol{\mathcal{A}}}_{ab}", "mean of the two integral-approach vectors");
const Y_A: Name = own("Y_a", "pressure coefficient of the particle");
const Y_B: Name = own("Y_b", "pressure coefficient of the neighbour");
const CROSSED: Name = own("g_{ab}", "weight of the crossed form of the pair");
const PI_AB: Name = own(r"\Pi_{ab}", "artificial viscosity of the pair");

pub(super) fn probes() -> Vec<Probe> {
    let mut list = probe! {
        hydrodynamics::pressure_coefficient(pressure, grad_h, normalisation, standard_density);
        pressure: R = "P_a", "M L^(2-nu) T^-2", not_negative(1e-3, 1e3);
        grad_h: R = r"\Omega_a", "1", any(1e-2, 1e1);
        normalisation: R = "k_a", "1", positive(0.1, 1e1);
        standard_density: R = own(r"\rho^0_a", "standard density estimate"), "M L^-nu", positive(1e-3, 1e3);
        => coefficient: R = Y_A, "M^-1 L^(2+nu) T^-2";
    };
    list.extend(probe! {
        hydrodynamics::crossed_weight(density_a, density_b, standard_a, standard_b);
        density_a: R = own(r"\rho_a", "density of the particle"), "M L^-nu", positive(0.5, 2.0);
        density_b: R = own(r"\rho_b", "density of the neighbour"), "M L^-nu", positive(0.5, 2.0).with(&[1e3]);
        standard_a: R = own(r"\rho^0_a", "standard density estimate of the particle"), "M L^-nu", between(0.8, 1.25);
        standard_b: R = own(r"\rho^0_b", "standard density estimate of the neighbour"), "M L^-nu", between(0.8, 1.25);
        => crossed: R = CROSSED, "1";
        @arrange "the standard densities are the densities times 0.8 to 1.25" |x| {
            x[2] *= x[0];
            x[3] *= x[1];
        };
    });
    list.extend(probe! {
        in 1, 2, 3;
        hydrodynamics::pressure_acceleration(mass_b, coefficient_a, coefficient_b, crossed, a_ab_a, a_ab_b);
        mass_b: R = "m_b", "M", positive(1e-3, 1e3);
        coefficient_a: R = Y_A, "M^-1 L^(2+nu) T^-2", not_negative(1e-3, 1e3);
        coefficient_b: R = Y_B, "M^-1 L^(2+nu) T^-2", not_negative(1e-3, 1e3);
        crossed: R = CROSSED, "1", positive(0.1, 1e1);
        a_ab_a: Vector<R, D> = A_AB_A, "L^(-1-nu)", any(1e-3, 1e3);
        a_ab_b: Vector<R, D> = A_AB_B, "L^(-1-nu)", any(1e-3, 1e3);
        => acceleration: Vector<R, D> = r"\dot{\mathbf{v}}_a", "L T^-2";
    });
    list.extend(probe! {
        in 1, 2, 3;
        hydrodynamics::pressure_work(mass_b, coefficient_a, crossed, v_ab, a_ab_a);
        mass_b: R = "m_b", "M", positive(1e-3, 1e3);
        coefficient_a: R = Y_A, "M^-1 L^(2+nu) T^-2", not_negative(1e-3, 1e3);
        crossed: R = CROSSED, "1", positive(0.1, 1e1);
        v_ab: Vector<R, D> = r"\mathbf{v}_{ab}", "L T^-1", any(1e-3, 1e3);
        a_ab_a: Vector<R, D> = A_AB_A, "L^(-1-nu)", any(1e-3, 1e3);
        => work: R = r"\dot{u}_a", "L^2 T^-3";
    });
    list.extend(probe! {
        in 1, 2, 3;
        hydrodynamics::viscous_acceleration(mass_b, viscosity, mean_a_ab);
        mass_b: R = "m_b", "M", positive(1e-3, 1e3);
        viscosity: R = PI_AB, "M^-1 L^(2+nu) T^-2", any(1e-3, 1e3);
        mean_a_ab: Vector<R, D> = MEAN_A_AB, "L^(-1-nu)", any(1e-3, 1e3);
        => acceleration: Vector<R, D> = r"\mathbf{a}^{\mathrm{AV}}_a", "L T^-2";
    });
    list.extend(probe! {
        in 1, 2, 3;
        hydrodynamics::viscous_heating(mass_b, viscosity, v_ab, mean_a_ab);
        mass_b: R = "m_b", "M", positive(1e-3, 1e3);
        viscosity: R = PI_AB, "M^-1 L^(2+nu) T^-2", any(1e-3, 1e3);
        v_ab: Vector<R, D> = r"\mathbf{v}_{ab}", "L T^-1", any(1e-3, 1e3);
        mean_a_ab: Vector<R, D> = MEAN_A_AB, "L^(-1-nu)", any(1e-3, 1e3);
        => heating: R = r"\dot{u}^{\mathrm{AV}}_a", "L^2 T^-3";
    });
    list
}
