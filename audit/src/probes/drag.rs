//! Drag between gas and dust.

use crate::domain::Domain;
use crate::{Name, Probe, any, not_negative, own, positive, probe};
use etalon_reference::equations::drag;
use etalon_reference::schemes::DragSigns;

const RATE: Name = own(r"\frac{K}{\rho}", "rate at which drag acts on the fluid");
const GAS_RATE: Name = own(r"\frac{K}{\rho_g}", "rate at which drag acts on the gas");
const DIFFERENCE: Name = own(r"\Delta\mathbf{v}", "velocity of the fluid less that of the other one");
const STOPPING_RATE: Name = own("(t_s^{ai})^{-1}", "inverse stopping time of the pair");
const WEIGHT: Name = own("w_{ai}", "what a pair's drag has before its velocities");
const OMEGA: Name = own(r"\omega_{ai}", "velocity difference along the pair");
const OMEGA_STAR: Name = own(r"\omega^*_{ai}", "reconstructed velocity difference along the pair");

/// Components of a unit vector, or zero; that they belong together does not matter to a product.
fn direction() -> Domain {
    any(1e-3, 1.0)
}

pub(super) fn probes() -> Vec<Probe> {
    let mut list = probe! {
        drag::drag_rate(drag_coefficient, density);
        drag_coefficient: R = "K", "M L^-nu T^-1", not_negative(1e-3, 1e3);
        density: R = r"\rho_g", "M L^-nu", positive(1e-3, 1e3);
        => rate: R = GAS_RATE, "T^-1";
    };
    list.extend(probe! {
        in 1, 2, 3;
        drag::continuum_drag(rate, velocity_difference);
        rate: R = RATE, "T^-1", not_negative(1e-3, 1e3);
        velocity_difference: Vector<R, D> = DIFFERENCE, "L T^-1", any(1e-3, 1e3);
        => acceleration: Vector<R, D> = own(r"\dot{\mathbf{v}}", "acceleration by drag"), "L T^-2";
    });
    list.extend(probe! {
        in 1, 2, 3;
        drag::continuum_drag_heating(gas_rate, velocity_difference);
        gas_rate: R = GAS_RATE, "T^-1", not_negative(1e-3, 1e3);
        velocity_difference: Vector<R, D> = own(r"(\mathbf{v}_d - \mathbf{v}_g)", "velocity of the dust less that of the gas"), "L T^-1", any(1e-3, 1e3);
        => heating: R = own(r"\dot{u}_g", "drag heating of the gas"), "L^2 T^-3";
    });
    list.extend(probe! {
        drag::stopping_rate(drag_coefficient, gas_density, dust_density);
        drag_coefficient: R = "K", "M L^-nu T^-1", not_negative(1e-3, 1e3);
        gas_density: R = r"\rho_a", "M L^-nu", positive(1e-3, 1e3);
        dust_density: R = r"\rho_i", "M L^-nu", positive(1e-3, 1e3);
        => rate: R = STOPPING_RATE, "T^-1";
    });
    list.extend(probe! {
        drag::stopping_time(stopping_rate);
        stopping_rate: R = STOPPING_RATE, "T^-1", not_negative(1e-3, 1e3);
        => time: R = "t_s^{ai}", "T";
    });
    list.extend(probe! {
        drag::drag_step(largest_stopping_rate);
        largest_stopping_rate: R = own(r"t_{s,\min}^{-1}", "largest inverse stopping time among the neighbours"), "T^-1", not_negative(1e-3, 1e3);
        => step: R = own(r"\Delta t", "time step"), "T";
    });
    list.extend(probe! {
        in 1, 2, 3;
        drag::drag_weight::<R, D>(own_rate, other_volume, double_hump);
        own_rate: R = own(r"\frac{K}{\rho_a}", "rate at which drag acts on the particle"), "T^-1", not_negative(1e-3, 1e3);
        other_volume: R = own("V_i", "volume of the partner"), "L^nu", positive(1e-3, 1e3);
        double_hump: R = "D_{ai}", "L^-nu", not_negative(1e-3, 1e3);
        => weight: R = WEIGHT, "T^-1";
    });
    list.extend(probe! {
        in 1, 2, 3;
        as "physical";
        drag::drag_acceleration(DragSigns::Physical, weight, omega_star, direction);
        weight: R = WEIGHT, "T^-1", not_negative(1e-3, 1e3);
        omega_star: R = OMEGA_STAR, "L T^-1", any(1e-3, 1e3);
        direction: Vector<R, D> = r"\hat{\mathbf{r}}_{ai}", "1", direction();
        => acceleration: Vector<R, D> = own(r"\dot{\mathbf{v}}_a", "acceleration by drag"), "L T^-2";
    });
    list.extend(probe! {
        in 1, 2, 3;
        as "as-printed";
        drag::drag_acceleration(DragSigns::AsPrinted, weight, omega_star, direction);
        weight: R = WEIGHT, "T^-1", not_negative(1e-3, 1e3);
        omega_star: R = OMEGA_STAR, "L T^-1", any(1e-3, 1e3);
        direction: Vector<R, D> = r"\hat{\mathbf{r}}_{ai}", "1", direction();
        => acceleration: Vector<R, D> = own(r"\dot{\mathbf{v}}_a", "acceleration by drag"), "L T^-2";
    });
    list.extend(probe! {
        drag::drag_heating(gas_weight, omega_star, omega);
        gas_weight: R = WEIGHT, "T^-1", not_negative(1e-3, 1e3);
        omega_star: R = OMEGA_STAR, "L T^-1", any(1e-3, 1e3);
        omega: R = OMEGA, "L T^-1", any(1e-3, 1e3);
        => heating: R = own(r"\dot{u}_a", "drag heating of the gas particle"), "L^2 T^-3";
    });
    list
}
