//! Velocities of a gas and a dust particle at a common point.

use super::gradients::positive_definite;
use crate::{Name, Probe, any, between, own, positive, probe};
use etalon_reference::equations::dust_reconstruction;
use etalon_reference::schemes::{CommonPoint, DragReconstruction, SlopeLimiter};

const SHARE_A: Name = own(r"\mu_{ai}", "share of the gas particle in the mass of the pair");
const SHARE_I: Name = own(r"\mu_{ia}", "share of the dust particle in the mass of the pair");
const OMEGA: Name = own(r"\omega_{ai}", "velocity difference along the pair");
const OMEGA_STAR: Name = own(r"\omega^*_{ai}", "reconstructed velocity difference along the pair");
const SLOPE: Name = own(r"\frac{1}{r}\frac{\partial W}{\partial r}", "slope of the kernel over the distance");
const R_BA: Name = own(r"\mathbf{r}_{ba}", "position of the neighbour less that of the particle");

macro_rules! points {
    ($list:ident: $($variant:literal, $point:ident;)*) => {
        $($list.extend(probe! {
            as $variant;
            dust_reconstruction::common_point(CommonPoint::$point, share_a, share_i) -> |pair| { pair };
            share_a: R = SHARE_A, "1", positive(1e-3, 1.0);
            share_i: R = SHARE_I, "1", positive(1e-3, 1.0);
            => from_gas: R = own("t_a", "where the common point lies from the gas particle, in separations"), "1";
               from_dust: R = own("t_i", "where the common point lies from the dust particle, in separations"), "1";
        });)*
    };
}

macro_rules! reconstructed {
    ($list:ident: $($variant:literal, $point:ident, $limiter:ident;)*) => {
        $($list.extend(probe! {
            as $variant;
            dust_reconstruction::reconstructed_drag_velocity(
                DragReconstruction { point: CommonPoint::$point, limiter: SlopeLimiter::$limiter },
                omega, r, slope_a, slope_i, share_a, share_i
            );
            omega: R = OMEGA, "L T^-1", any(1e-3, 1e3);
            r: R = own(r"|\mathbf{r}_{ai}|", "distance of the pair"), "L", positive(1e-3, 1e3).with(&[0.0]);
            slope_a: R = "S_{ai}", "T^-1", any(1e-3, 1e3);
            slope_i: R = "S_{ia}", "T^-1", any(1e-3, 1e3);
            share_a: R = r"\mu_{ai}", "1", positive(1e-3, 1.0);
            share_i: R = r"\mu_{ia}", "1", positive(1e-3, 1.0);
            => omega_star: R = OMEGA_STAR, "L T^-1";
        });)*
    };
}

pub(super) fn probes() -> Vec<Probe> {
    let mut list = probe! {
        dust_reconstruction::mass_share(own_mass, other_mass);
        own_mass: R = "m_a", "M", positive(1e-3, 1e3);
        other_mass: R = own("m_i", "mass of the dust particle"), "M", positive(1e-3, 1e3);
        => share: R = r"\mu_{ai}", "1";
    };
    points! { list:
        "particles", Particles;
        "midpoint", Midpoint;
        "barycentre", Barycentre;
        "as-printed", AsPrinted;
    }
    list.extend(probe! {
        in 1, 2, 3;
        dust_reconstruction::carried_velocity(velocity, jacobian, to_point);
        velocity: Vector<R, D> = r"\mathbf{v}_a", "L T^-1", any(1e-3, 1e3);
        jacobian: Matrix<R, D> = own(r"\mathbf{J}_a", "velocity Jacobian at the gas particle, row component and column direction"), "T^-1", any(1e-3, 1e3);
        to_point: Vector<R, D> = own(r"(\mathbf{r}^* - \mathbf{r}_a)", "the common point seen from the particle"), "L", any(1e-3, 1e3);
        => carried: Vector<R, D> = r"\mathbf{v}^*_a", "L T^-1";
    });
    list.extend(probe! {
        in 1, 2, 3;
        dust_reconstruction::slope_along_pair(jacobian, direction);
        jacobian: Matrix<R, D> = own(r"\mathbf{J}_a", "velocity Jacobian at the gas particle, row component and column direction"), "T^-1", any(1e-3, 1e3);
        direction: Vector<R, D> = r"\hat{\mathbf{r}}_{ai}", "1", any(1e-3, 1.0);
        => slope: R = "S_{ai}", "T^-1";
    });
    reconstructed! { list:
        "particles none", Particles, Unlimited;
        "midpoint van-leer", Midpoint, VanLeer;
        "barycentre none", Barycentre, Unlimited;
        "barycentre MC", Barycentre, MonotonizedCentral;
        "as-printed superbee", AsPrinted, Superbee;
    }
    list.extend(probe! {
        dust_reconstruction::entropy_fixed(omega_star, omega, decayed);
        omega_star: R = OMEGA_STAR, "L T^-1", any(1e-3, 1e3);
        omega: R = OMEGA, "L T^-1", any(1e-3, 1e3);
        decayed: R = own("d", "part of the velocity difference that decays in the step"), "1", between(0.0, 1.0);
        => fixed: R = own(r"\omega^{**}_{ai}", "velocity difference that does not cool the gas"), "L T^-1";
    });
    list.extend(probe! {
        in 1, 2, 3;
        dust_reconstruction::gradient_sum_term(mass, slope, v_ba, r_ba);
        mass: R = "m_b", "M", positive(1e-3, 1e3);
        slope: R = SLOPE, "L^(-2-nu)", between(-10.0, 0.0);
        v_ba: Vector<R, D> = own(r"\mathbf{v}_{ba}", "velocity of the neighbour less that of the particle"), "L T^-1", any(1e-3, 1e3);
        r_ba: Vector<R, D> = R_BA, "L", any(1e-3, 1e3);
        => term: Matrix<R, D> = own("B_{ab}", "one neighbour's part of the right-hand side"), "M L^-nu T^-1";
    });
    list.extend(probe! {
        in 1, 2, 3;
        dust_reconstruction::correction_term(mass, slope, r_ba);
        mass: R = "m_b", "M", positive(1e-3, 1e3);
        slope: R = SLOPE, "L^(-2-nu)", between(-10.0, 0.0);
        r_ba: Vector<R, D> = R_BA, "L", any(1e-3, 1e3);
        => term: Symmetric<R, D> = own("R_{ab}", "one neighbour's part of the correction matrix"), "M L^-nu";
    });
    list.extend(probe! {
        in 1, 2, 3;
        dust_reconstruction::linear_gradient(sum, correction);
        sum: Matrix<R, D> = own("B", "right-hand side of the equation"), "M L^-nu T^-1", any(1e-3, 1e3);
        correction: Symmetric<R, D> = own("R", "correction matrix of the gradient"), "M L^-nu", between(-1.0, 1.0).with(&[0.0]);
        => gradient: Matrix<R, D> = own(r"\mathbf{J}", "velocity gradient, row component and column axis"), "T^-1";
        @arrange "R = L L^T for a triangular L with a diagonal between 0 and 2, flat neighbourhoods included" |x| {
            positive_definite(&mut x[D * D..], D);
        };
    });
    list
}
