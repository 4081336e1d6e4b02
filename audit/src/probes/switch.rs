//! The time-dependent viscosity coefficient.

use crate::{Name, Probe, any, between, not_negative, own, positive, probe};
use etalon_reference::equations::switch;
use etalon_reference::schemes::{Dissipation, Viscosity};

const SWITCHED: Viscosity = Viscosity::of(Dissipation::AvSw);
const RATE: Name = own(r"\tau_a^{-1}", "rate of decay");
const TARGET: Name = own(r"\alpha_*", "what the coefficient decays to");

pub(super) fn probes() -> Vec<Probe> {
    let mut list = probe! {
        in 1, 2, 3;
        switch::convergence_indicator(divergence_gradient, h);
        divergence_gradient: Vector<R, D> = own(r"\nabla(\nabla\cdot\mathbf{v}_a)", "gradient of the velocity divergence"), "L^-1 T^-1", any(1e-3, 1e3);
        h: R = "h_a", "L", positive(1e-3, 1e3);
        => indicator: R = r"\mathcal{D}_a", "L T^-1";
    };
    list.extend(probe! {
        switch::local_coefficient(&SWITCHED, indicator, divergence, sound_speed, h);
        indicator: R = r"\mathcal{D}_a", "L T^-1", not_negative(1e-3, 1e3);
        divergence: R = r"\nabla\cdot\mathbf{v}_a", "T^-1", any(1e-3, 1e3);
        sound_speed: R = "c_a", "L T^-1", not_negative(1e-3, 1e3);
        h: R = "h_a", "L", positive(1e-3, 1e3);
        => alpha_local: R = r"\alpha_{\mathrm{loc},a}", "1";
    });
    list.extend(probe! {
        switch::raised_coefficient(alpha, alpha_local);
        alpha: R = r"\alpha_a", "1", between(0.05, 1.0);
        alpha_local: R = r"\alpha_{\mathrm{loc},a}", "1", between(0.0, 1.0);
        => raised: R = own(r"\alpha'_a", "coefficient after the rise"), "1";
    });
    list.extend(probe! {
        switch::decay_target(&SWITCHED, alpha_local);
        alpha_local: R = r"\alpha_{\mathrm{loc},a}", "1", between(0.0, 1.0);
        => target: R = TARGET, "1";
    });
    list.extend(probe! {
        switch::decay_rate(largest_signal_velocity, inverse_h);
        largest_signal_velocity: R = r"v_{\mathrm{sig,max}}", "L T^-1", not_negative(1e-3, 1e3);
        inverse_h: R = own("h_a^{-1}", "inverse smoothing length"), "L^-1", positive(1e-3, 1e3);
        => rate: R = RATE, "T^-1";
    });
    list.extend(probe! {
        switch::coefficient_rate(&SWITCHED, alpha, alpha_local, decay_rate);
        alpha: R = r"\alpha_a", "1", between(0.05, 1.0);
        alpha_local: R = r"\alpha_{\mathrm{loc},a}", "1", between(0.0, 1.0);
        decay_rate: R = RATE, "T^-1", not_negative(1e-3, 1e3);
        => rate: R = r"\dot{\alpha}_a", "T^-1";
    });
    list.extend(probe! {
        switch::decayed_coefficient(&SWITCHED, alpha, alpha_local, decay_rate, dt);
        alpha: R = r"\alpha_a", "1", between(0.05, 1.0);
        alpha_local: R = r"\alpha_{\mathrm{loc},a}", "1", between(0.0, 1.0);
        decay_rate: R = RATE, "T^-1", not_negative(1e-3, 1e3);
        dt: R = own(r"\Delta t", "time step"), "T", positive(1e-6, 1e2);
        => decayed: R = own(r"\alpha_a(t+\Delta t)", "coefficient after the step"), "1";
    });
    list.extend(probe! {
        switch::pair_coefficient(alpha_a, alpha_b);
        alpha_a: R = own(r"\alpha_a", "linear viscosity coefficient of the particle"), "1", between(0.05, 1.0);
        alpha_b: R = own(r"\alpha_b", "linear viscosity coefficient of the neighbour"), "1", between(0.05, 1.0);
        => alpha_ab: R = r"\bar{\alpha}_{ab}", "1";
    });
    list
}
