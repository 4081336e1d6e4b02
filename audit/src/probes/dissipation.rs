//! Artificial viscosity.

use crate::{Probe, any, between, not_negative, own, positive, probe};
use etalon_reference::equations::dissipation;
use etalon_reference::schemes::{Dissipation, Viscosity};

const PI_AB: &str = r"\Pi_{ab}";
const OMEGA_AB: &str = r"\omega_{ab}";
const RHO_AB: &str = r"\bar{\rho}_{ab}";

pub(super) fn probes() -> Vec<Probe> {
    let mut list = probe! {
        in 1, 2, 3;
        dissipation::approach_velocity(v_ab, x_ab, inverse_r);
        v_ab: Vector<R, D> = r"\mathbf{v}_{ab}", "L T^-1", any(1e-3, 1e3);
        x_ab: Vector<R, D> = own(r"\mathbf{r}_{ab}", "position of particle a less that of particle b"), "L", any(1e-3, 1e3);
        inverse_r: R = own(r"|\mathbf{r}_{ab}|^{-1}", "inverse distance of the pair; zero for coincident particles"), "L^-1", not_negative(1e-3, 1e3);
        => omega_ab: R = OMEGA_AB, "L T^-1";
    };
    list.extend(probe! {
        dissipation::signal_velocity(sound_speed_a, sound_speed_b, omega_ab);
        sound_speed_a: R = "c_a", "L T^-1", not_negative(1e-3, 1e3);
        sound_speed_b: R = "c_b", "L T^-1", not_negative(1e-3, 1e3);
        omega_ab: R = OMEGA_AB, "L T^-1", any(1e-3, 1e3);
        => signal_velocity: R = r"v^{\mathrm{sig}}_{ab}", "L T^-1";
    });
    list.extend(probe! {
        dissipation::riemann_viscosity(alpha, v_sig, omega_ab, mean_density);
        alpha: R = r"\alpha", "1", not_negative(1e-2, 1e1);
        v_sig: R = r"v^{\mathrm{sig}}_{ab}", "L T^-1", not_negative(1e-3, 1e3);
        omega_ab: R = OMEGA_AB, "L T^-1", any(1e-3, 1e3);
        mean_density: R = RHO_AB, "M L^-nu", positive(1e-3, 1e3);
        => viscosity: R = PI_AB, "M^-1 L^(2+nu) T^-2";
    });
    list.extend(probe! {
        dissipation::pair_viscosity(alpha, beta, mean_sound_speed, omega_ab, mean_density);
        alpha: R = r"\bar{\alpha}_{ab}", "1", not_negative(1e-2, 1e1);
        beta: R = r"\beta", "1", not_negative(1e-2, 1e1);
        mean_sound_speed: R = r"\bar{c}_{ab}", "L T^-1", not_negative(1e-3, 1e3);
        omega_ab: R = OMEGA_AB, "L T^-1", any(1e-3, 1e3);
        mean_density: R = RHO_AB, "M L^-nu", positive(1e-3, 1e3);
        => viscosity: R = PI_AB, "M^-1 L^(2+nu) T^-2";
    });
    list.extend(probe! {
        dissipation::pair_balsara(balsara_a, balsara_b);
        balsara_a: R = r"\mathcal{B}_a", "1", between(0.0, 1.0);
        balsara_b: R = r"\mathcal{B}_b", "1", between(0.0, 1.0);
        => balsara_ab: R = r"\mathcal{B}_{ab}", "1";
    });
    list.extend(probe! {
        dissipation::balsara_limiter(divergence, curl, sound_speed, inverse_h);
        divergence: R = own(r"(\nabla\cdot\mathbf{v})_a", "velocity divergence at particle a"), "T^-1", any(1e-3, 1e3);
        curl: R = r"|\nabla\times\mathbf{v}|_a", "T^-1", not_negative(1e-3, 1e3);
        sound_speed: R = "c_a", "L T^-1", not_negative(1e-3, 1e3);
        inverse_h: R = own("h_a^{-1}", "inverse smoothing length of particle a"), "L^-1", positive(1e-3, 1e3);
        => balsara: R = r"\mathcal{B}_a", "1";
    });
    list.extend(probe! {
        dissipation::regularised_approach(v_dot_r, r_squared, mean_h);
        v_dot_r: R = own(r"(\mathbf{v}_{ab}\cdot\mathbf{r}_{ab})", "scalar product of velocity and position of the pair"), "L^2 T^-1", any(1e-3, 1e3);
        r_squared: R = own(r"|\mathbf{r}_{ab}|^2", "squared distance of the pair"), "L^2", not_negative(1e-3, 1e3);
        mean_h: R = r"\bar{h}_{ab}", "L", positive(1e-3, 1e3);
        => approach: R = r"\mu_{ab}", "L T^-1";
    });
    list.extend(probe! {
        dissipation::limited_viscosity(balsara_ab, viscosity);
        balsara_ab: R = r"\mathcal{B}_{ab}", "1", between(0.0, 1.0);
        viscosity: R = PI_AB, "M^-1 L^(2+nu) T^-2", any(1e-3, 1e3);
        => limited: R = own(r"\mathcal{B}_{ab}\Pi_{ab}", "limited viscosity of the pair"), "M^-1 L^(2+nu) T^-2";
    });
    list.extend(probe! {
        dissipation::wave_aware_limiter(divergence, curl, sound_speed, inverse_h, angular_frequency);
        divergence: R = own(r"(\nabla\cdot\mathbf{v})_a", "velocity divergence at particle a"), "T^-1", any(1e-3, 1e3);
        curl: R = r"|\nabla\times\mathbf{v}|_a", "T^-1", not_negative(1e-3, 1e3);
        sound_speed: R = "c_a", "L T^-1", not_negative(1e-3, 1e3);
        inverse_h: R = own("h_a^{-1}", "inverse smoothing length of particle a"), "L^-1", positive(1e-3, 1e3);
        angular_frequency: R = own(r"\frac{2\pi}{T_a}", "angular frequency of the wave's driver"), "T^-1", not_negative(1e-3, 1e3);
        => balsara: R = r"\mathcal{B}^{*}_a", "1";
    });
    list.extend(probe! {
        dissipation::sign_is_reversed(omega_ab, omega_prime);
        omega_ab: R = own(r"\omega_{ab}", "relative velocity along the line of the pair"), "L T^-1", any(1e-3, 1e3);
        omega_prime: R = own(r"\omega'_{ab}", "reconstructed relative velocity along the line of the pair"), "L T^-1", any(1e-3, 1e3);
        => reversed: R = own(r"n_{\omega\omega'<0}", "one if the signs differ, else zero"), "1";
    });
    list.extend(probe! {
        as "AV";
        dissipation::linear_coefficient(&Viscosity::of(Dissipation::Av), balsara_ab);
        balsara_ab: R = r"\bar{\mathcal{B}}_{ab}", "1", between(0.0, 1.0);
        => coefficient: R = own(r"\bar{\alpha}_{ab}", "linear viscosity coefficient of the pair"), "1";
    });
    list.extend(probe! {
        as "AVSLRB2F";
        dissipation::linear_coefficient(&Viscosity::of(Dissipation::AvSlrB2F), balsara_ab);
        balsara_ab: R = r"\bar{\mathcal{B}}_{ab}", "1", between(0.0, 1.0).with(&[0.5]);
        => coefficient: R = own(r"\bar{\alpha}_{ab}", "linear viscosity coefficient of the pair"), "1";
    });
    list
}
