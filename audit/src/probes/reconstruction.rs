//! Slope-limited reconstruction.

use crate::{Name, Probe, any, between, not_negative, own, positive, probe};
use etalon_reference::equations::reconstruction;
use etalon_reference::schemes::{Dissipation, Viscosity};

const SLOPE_A: Name = own("A_{ab}", "velocity slope of particle a along the pair, times the distance squared");
const SLOPE_B: Name = own("B_{ab}", "velocity slope of particle b along the pair, times the distance squared");
const SUPPORT: Name = own(r"\omega_\nu R^\nu", "volume of the support in units of the smoothing length");

macro_rules! reconstructed {
    ($list:ident: $($variant:literal, $towards_b:literal, $v:literal, $phi:literal, $j:literal, $out:literal;)*) => {
        $($list.extend(probe! {
            in 1, 2, 3;
            as $variant;
            reconstruction::reconstructed_velocity(velocity, phi, jacobian, x_ab, $towards_b);
            velocity: Vector<R, D> = $v, "L T^-1", any(1e-3, 1e3);
            phi: R = $phi, "1", between(0.0, 1.0);
            jacobian: Matrix<R, D> = $j, "T^-1", any(1e-3, 1e3);
            x_ab: Vector<R, D> = r"\mathbf{x}_{ab}", "L", any(1e-3, 1e3);
            => reconstructed: Vector<R, D> = $out, "L T^-1";
        });)*
    };
}

macro_rules! shares {
    ($list:ident: $($variant:literal, $scheme:ident;)*) => {
        $($list.extend(probe! {
            as $variant;
            reconstruction::reconstruction_share(&Viscosity::of(Dissipation::$scheme), balsara_ab);
            balsara_ab: R = r"\mathcal{B}_{ab}", "1", between(0.0, 1.0);
            => share: R = own(r"(1 - \mathcal{B}_{ab}^{\,p})", "what the Balsara factor leaves of the reconstruction"), "1";
        });)*
    };
}

pub(super) fn probes() -> Vec<Probe> {
    let mut list = Vec::new();
    reconstructed! { list:
        "a", true, r"\mathbf{v}_a", r"\phi_{ab}", r"\mathbf{J}_a", r"\mathbf{v}'_a";
        "b", false, r"\mathbf{v}_b", r"\phi_{ba}", r"\mathbf{J}_b", r"\mathbf{v}'_b";
    }
    list.extend(probe! {
        reconstruction::reconstructed_approach_velocity(omega_ab, phi_ab, slope_a, phi_ba, slope_b, inverse_r);
        omega_ab: R = own(r"\omega_{ab}", "relative velocity along the line of the pair"), "L T^-1", any(1e-3, 1e3);
        phi_ab: R = r"\phi_{ab}", "1", between(0.0, 1.0);
        slope_a: R = SLOPE_A, "L^2 T^-1", any(1e-3, 1e3);
        phi_ba: R = r"\phi_{ba}", "1", between(0.0, 1.0);
        slope_b: R = SLOPE_B, "L^2 T^-1", any(1e-3, 1e3);
        inverse_r: R = own(r"|\mathbf{x}_{ab}|^{-1}", "inverse distance of the pair; zero for coincident particles"), "L^-1", not_negative(1e-3, 1e3);
        => omega: R = own(r"\omega'_{ab}", "reconstructed relative velocity along the line of the pair"), "L T^-1";
    });
    list.extend(probe! {
        reconstruction::slope_limiter(slope_a, slope_b);
        slope_a: R = SLOPE_A, "L^2 T^-1", any(1e-6, 1e6);
        slope_b: R = SLOPE_B, "L^2 T^-1", any(1e-6, 1e6);
        => limiter: R = own(r"\frac{\phi_{ab}}{\kappa_{ab}}", "slope limiter, without its damping for close pairs"), "1";
    });
    list.extend(probe! {
        reconstruction::short_range_factor(q_ab, q_crit, inverse_q_fold);
        q_ab: R = "q_{ab}", "1", between(0.0, 3.0);
        q_crit: R = r"q_{\mathrm{crit}}", "1", between(0.2, 2.0);
        inverse_q_fold: R = own(r"q_{\mathrm{fold}}^{-1}", "inverse width of the damping"), "1", between(1.0, 10.0).with(&[5.0]);
        => kappa: R = r"\kappa_{ab}", "1";
    });
    list.extend(probe! {
        reconstruction::pair_separation(r, inverse_h_a, inverse_h_b);
        r: R = own(r"|\mathbf{x}_{ab}|", "distance of the pair"), "L", not_negative(1e-3, 1e3);
        inverse_h_a: R = own("h_a^{-1}", "inverse smoothing length of particle a"), "L^-1", positive(1e-3, 1e3);
        inverse_h_b: R = own("h_b^{-1}", "inverse smoothing length of particle b"), "L^-1", positive(1e-3, 1e3);
        => q_ab: R = "q_{ab}", "1";
    });
    list.extend(probe! {
        in 1, 2, 3;
        reconstruction::critical_separation::<R, D>(neighbours, support_volume);
        neighbours: R = "n_{b,a}", "1", positive(1.0, 1e3);
        support_volume: R = SUPPORT, "1", between(2.0, 120.0);
        => q_crit: R = r"q_{\mathrm{crit}}", "1";
    });
    shares! { list:
        "AV", Av;
        "AVSLR", AvSlr;
        "AVSLRB", AvSlrB;
        "AVSLRB2", AvSlrB2;
        "AVSLRB2F", AvSlrB2F;
    }
    list
}
