//! Driven turbulence, value by value: C25 (32), (33), and the driving of C25 section 2.
//!
//! The sums over particles and modes that these belong to are in [`crate::turbulence`].

use crate::schemes::{MachReading, Profile};
use etalon_kernels_gen::functions::{expm1_negative, ratio_or_zero};
use etalon_kernels_gen::{Real, Vector, equation};

/// A pair's contribution to the structure function, `|v_b - v_a|^2` (L^2 T^-2).
///
/// `S_2(l)` is its mean over the pairs at distance `l`: all components, not the one along the line of centres.
/// Source: C25 (32).
#[equation("c25:32")]
pub fn squared_velocity_difference<R: Real, const D: usize>(v_ab: Vector<R, D>) -> R {
    v_ab.norm_squared()
}

/// The Mach number of the velocity differences at a scale, `M(l) = sqrt(S_2 / 2) / c`, or `sqrt(S_2) / c` in the other reading.
///
/// With the half, points too far apart to know of one another give the root-mean-square Mach number. Zero without a sound speed.
/// Source: C25 (33).
#[equation("c25:33")]
pub fn scale_mach_number<R: Real>(structure_function: R, sound_speed: R, reading: MachReading) -> R {
    let squared = match reading {
        MachReading::Halved => 0.5 * structure_function,
        MachReading::Whole => structure_function,
    };
    ratio_or_zero(squared.sqrt(), sound_speed)
}

/// The amplitude of a driving mode before any normalisation, for a wave vector of `n` box lengths: a parabola around `peak` that is zero at
/// `peak - 1` and `peak + 1`.
///
/// In [`Profile::Power`] it is `2 sqrt(1 - (n - n_c)^2) (n_c / n)^((nu - 1) / 2)`: with `n^(nu - 1)` modes at a wave number the power per shell is the
/// parabola. In [`Profile::Amplitude`] the amplitude itself is. Zero outside. Source: C25 section 2 and GS25 section 4, which print the parabola;
/// SPH-EXA for the power.
#[equation(unnumbered = "amplitudes of the driving, C25 section 2")]
pub fn driving_amplitude<R: Real, const D: usize>(wave_number: R, peak: R, profile: Profile) -> R {
    let off = wave_number - peak;
    let parabola = 0.0.max(1.0 - off * off);
    match profile {
        Profile::Amplitude => parabola,
        Profile::Power => {
            let fewer = ratio_or_zero(peak, wave_number).power(D as u32 - 1);
            2.0 * (parabola * fewer).sqrt()
        }
    }
}

/// One step of a process of Ornstein and Uhlenbeck, `x <- f x + s z`, with `f = exp(-dt/T)` and `s = sigma sqrt(1 - f^2)`.
///
/// `decay` is `dt/T`, `sigma` the standard deviation the process settles at, `z` a normal deviate. Exact for any step: the spread and
/// the correlation in time do not depend on it. `1 - f^2` is `-expm1(-2 dt/T)`, else the noise of a short step would round to nothing.
/// Source: Uhlenbeck & Ornstein 1930, which C25 section 2 names.
#[equation(unnumbered = "Ornstein-Uhlenbeck process, C25 section 2")]
pub fn ornstein_uhlenbeck_step<R: Real>(x: R, decay: R, sigma: R, normal: R) -> R {
    let faded = x + x * expm1_negative(decay);
    let spread = sigma * (-expm1_negative(decay + decay)).sqrt();
    faded + spread * normal
}

/// A mode's amplitude split along and across its wave vector, `zeta (1 - k k^T / k^2) x + (1 - zeta) (k k^T / k^2) x`.
///
/// With `zeta = 1` the force has no divergence, with 0 no curl; one half halves `x` and leaves its direction, so that in 3-D two thirds of
/// the power are solenoidal. A wave vector of zero has no direction and gives nothing. Source: Federrath et al. 2010, which C25 section 2 names.
#[equation(unnumbered = "Helmholtz projection of the driving, C25 section 2")]
pub fn project_mode<R: Real, const D: usize>(
    x: Vector<R, D>,
    wave_vector: Vector<R, D>,
    solenoidal_weight: R,
) -> Vector<R, D> {
    let k_squared = wave_vector.norm_squared();
    let along = wave_vector.scale(ratio_or_zero(x.dot(wave_vector), k_squared));
    let across = x - along;
    let mixed = across.scale(solenoidal_weight) + along.scale(1.0 - solenoidal_weight);
    let present = if k_squared > 0.0 { R::one() } else { R::zero() };
    mixed.scale(present)
}

/// What makes the size of the projected amplitude independent of the weight, squared: `nu / (1 - 2 zeta + nu zeta^2)`.
///
/// Source: Federrath et al. 2010; it is the inverse of the mean square of [`project_mode`] on isotropic noise, times `nu`.
#[equation(unnumbered = "normalisation of the projection, C25 section 2")]
pub fn projection_norm_squared<R: Real, const D: usize>(solenoidal_weight: R) -> R {
    let nu = R::lit(D as f64);
    let kept = 1.0 + solenoidal_weight * (nu * solenoidal_weight - 2.0);
    ratio_or_zero(nu, kept)
}

/// One mode's part of the driving force, `a (Re x cos(k.x) - Im x sin(k.x))` (L T^-2), the real part of `a x exp(i k.x)`.
///
/// Source: Federrath et al. 2010, which C25 section 2 names.
#[equation(unnumbered = "force of a driving mode, C25 section 2")]
pub fn driving_term<R: Real, const D: usize>(
    amplitude: R,
    real: Vector<R, D>,
    imaginary: Vector<R, D>,
    cosine: R,
    sine: R,
) -> Vector<R, D> {
    real.scale(amplitude * cosine) - imaginary.scale(amplitude * sine)
}

/// A particle's squared Mach number, `v^2 / c^2`; its mean over particles is the square of the root-mean-square Mach number.
///
/// Zero without a sound speed. Source: C25 section 2, GS25 section 4.
#[equation(unnumbered = "Mach number, C25 section 2")]
pub fn squared_mach_number<R: Real, const D: usize>(v: Vector<R, D>, sound_speed: R) -> R {
    let ratio = v.scale(ratio_or_zero(R::one(), sound_speed));
    ratio.norm_squared()
}
