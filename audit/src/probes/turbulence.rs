//! Driven turbulence.

use crate::{Name, Probe, any, between, not_negative, own, positive, probe};
use etalon_reference::equations::turbulence;
use etalon_reference::schemes::{MachReading, Profile};

const X: Name = own(r"\mathbf{x}_k", "amplitude of a driving mode");
const ZETA: Name = own(r"\zeta", "weight of the solenoidal part");

macro_rules! mach_numbers {
    ($list:ident: $($variant:literal, $reading:ident;)*) => {
        $($list.extend(probe! {
            as $variant;
            turbulence::scale_mach_number(structure_function, sound_speed, MachReading::$reading);
            structure_function: R = "S_2", "L^2 T^-2", not_negative(1e-3, 1e3);
            sound_speed: R = "c_s", "L T^-1", not_negative(1e-3, 1e3);
            => mach: R = r"\mathcal{M}", "1";
        });)*
    };
}

macro_rules! amplitudes {
    ($list:ident: $($variant:literal, $profile:ident;)*) => {
        $($list.extend(probe! {
            in 1, 2, 3;
            as $variant;
            turbulence::driving_amplitude::<R, D>(wave_number, peak, Profile::$profile);
            wave_number: R = own("n", "wave number, in box lengths"), "1", between(0.0, 5.0).with(&[1.0, 2.0, 3.0]);
            peak: R = own("n_c", "wave number that is driven most"), "1", between(1.0, 4.0).with(&[2.0]);
            => amplitude: R = own("a_n", "amplitude of a mode before normalisation"), "1";
        });)*
    };
}

pub(super) fn probes() -> Vec<Probe> {
    let mut list = probe! {
        in 1, 2, 3;
        turbulence::squared_velocity_difference(v_ab);
        v_ab: Vector<R, D> = own(r"\mathbf{v}_{ab}", "velocity difference of the pair"), "L T^-1", any(1e-3, 1e3);
        => squared: R = own(r"|\mathbf{v}_{ab}|^2", "the pair's contribution to the structure function"), "L^2 T^-2";
    };
    mach_numbers! { list:
        "halved", Halved;
        "whole", Whole;
    }
    amplitudes! { list:
        "power", Power;
        "amplitude", Amplitude;
    }
    list.extend(probe! {
        turbulence::ornstein_uhlenbeck_step(x, decay, sigma, normal);
        x: R = own("x", "value of the process"), "L T^-2", any(1e-3, 1e3);
        decay: R = own(r"\frac{\Delta t}{T}", "step over the correlation time"), "1", positive(1e-8, 1e2);
        sigma: R = own(r"\sigma", "standard deviation that the process settles at"), "L T^-2", positive(1e-3, 1e3);
        normal: R = own("z", "normal deviate"), "1", any(1e-3, 5.0);
        => next: R = own("x'", "value of the process a step later"), "L T^-2";
    });
    list.extend(probe! {
        in 1, 2, 3;
        turbulence::project_mode(x, wave_vector, solenoidal_weight);
        x: Vector<R, D> = X, "L T^-2", any(1e-3, 1e3);
        wave_vector: Vector<R, D> = own(r"\mathbf{k}", "wave vector"), "L^-1", any(0.1, 1e2);
        solenoidal_weight: R = ZETA, "1", between(0.0, 1.0).with(&[0.5]);
        => projected: Vector<R, D> = own(r"\mathbf{x}'_k", "amplitude split along and across the wave vector"), "L T^-2";
    });
    list.extend(probe! {
        in 1, 2, 3;
        turbulence::projection_norm_squared::<R, D>(solenoidal_weight);
        solenoidal_weight: R = ZETA, "1", between(0.0, 1.0).with(&[0.5]);
        => norm: R = own("N^2", "squared normalisation of the projection"), "1";
    });
    list.extend(probe! {
        in 1, 2, 3;
        turbulence::driving_term(amplitude, real, imaginary, cosine, sine);
        amplitude: R = own("a", "amplitude of the mode"), "1", positive(1e-3, 1e3);
        real: Vector<R, D> = own(r"\Re\mathbf{x}_k", "real part of the mode"), "L T^-2", any(1e-3, 1e3);
        imaginary: Vector<R, D> = own(r"\Im\mathbf{x}_k", "imaginary part of the mode"), "L T^-2", any(1e-3, 1e3);
        cosine: R = own(r"\cos(\mathbf{k}\cdot\mathbf{x})", "cosine of the phase"), "1", between(-1.0, 1.0);
        sine: R = own(r"\sin(\mathbf{k}\cdot\mathbf{x})", "sine of the phase"), "1", between(-1.0, 1.0);
        => term: Vector<R, D> = own(r"\mathbf{f}_k", "the mode's part of the driving force"), "L T^-2";
    });
    list.extend(probe! {
        in 1, 2, 3;
        turbulence::squared_mach_number(v, sound_speed);
        v: Vector<R, D> = own(r"\mathbf{v}", "velocity"), "L T^-1", any(1e-3, 1e3);
        sound_speed: R = own("c", "speed of sound"), "L T^-1", not_negative(1e-3, 1e3);
        => squared: R = own(r"\mathcal{M}^2", "squared Mach number"), "1";
    });
    list
}
