//! The linear sound wave in gas with dust (PL20 1-3, linearised).
//!
//! A disturbance $\propto e^{yt + ikx}$ obeys, with $a_g = K/\rho_g$ and $a_d = K/\rho_d$,
//! $y^3 + (a_g + a_d)\,y^2 + k^2c_s^2\,y + k^2c_s^2a_d = 0$. Laibe & Price 2011. Drag heating is of second order and left out; $c_s$ is the adiabatic
//! sound speed of the gas alone.

use super::dust::{DustError, Mixture, positive};
use num_complex::Complex;
use num_traits::{Float, FloatConst};

/// A wave of one wavelength in a mixture at rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DustyWave<F> {
    mixture: Mixture<F>,
    sound_speed: F,
    wave_number: F,
    rates: [Complex<F>; 3],
}

/// Velocities, and densities relative to the undisturbed ones, as amplitudes or at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disturbance<T> {
    /// $v_g$.
    pub gas_velocity: T,
    /// $v_d$.
    pub dust_velocity: T,
    /// $\delta\rho_g/\rho_g$.
    pub gas_density: T,
    /// $\delta\rho_d/\rho_d$.
    pub dust_density: T,
}

impl<F: Float + FloatConst> DustyWave<F> {
    /// A wave of `wavelength` (L) in gas with the adiabatic sound speed `sound_speed` (L T^-1).
    ///
    /// # Errors
    /// A wavelength or sound speed that is not finite and positive, or drag rates that leave the number type in units of $kc_s$.
    pub fn new(mixture: Mixture<F>, sound_speed: F, wavelength: F) -> Result<Self, DustError> {
        positive("sound speed", sound_speed)?;
        positive("wavelength", wavelength)?;
        let wave_number = F::TAU() / wavelength;
        let unit = wave_number * sound_speed;
        let (gas, dust) = (mixture.gas_rate() / unit, mixture.dust_rate() / unit);
        let most = F::max_value().sqrt();
        if !(unit > F::zero() && unit < most && gas + dust < most) {
            return Err(DustError::Overflow);
        }
        let rates = dispersion_roots(gas, dust).map(|root| root * unit);
        Ok(DustyWave { mixture, sound_speed, wave_number, rates })
    }

    /// The wave number $k$.
    pub fn wave_number(&self) -> F {
        self.wave_number
    }

    /// The growth rates $y$ (T^-1): a real one, then the pair of waves, or, if drag leaves no wave, three real ones.
    ///
    /// Frequency and damping of a wave are imaginary and negative real part. Relative accuracy holds from $K = 0$ to $K \to \infty$, except beside a
    /// double root, where the roots themselves are ill-conditioned.
    pub fn growth_rates(&self) -> [Complex<F>; 3] {
        self.rates
    }

    /// The amplitudes at time `t`, from those at time 0.
    ///
    /// The three growing or decaying parts follow from the Laplace transform of the linear equations: their numerators over the polynomial's derivative.
    /// Digits are lost as two growth rates approach one another, in the ratio of their size to their distance.
    pub fn amplitudes(&self, t: F, initial: Disturbance<F>) -> Disturbance<Complex<F>> {
        let i = Complex::i();
        let (a_g, a_d, k) = (self.mixture.gas_rate(), self.mixture.dust_rate(), self.wave_number);
        let kc_squared = k * k * self.sound_speed * self.sound_speed;
        let Disturbance { gas_velocity: v_g, dust_velocity: v_d, gas_density: delta_g, .. } = initial;
        let push = i * (k * self.sound_speed * self.sound_speed * delta_g);
        let zero = Complex::new(F::zero(), F::zero());
        let mut sum = Disturbance {
            gas_velocity: zero,
            dust_velocity: zero,
            gas_density: zero,
            dust_density: Complex::from(initial.dust_density),
        };
        for (j, &y) in self.rates.iter().enumerate() {
            let others = (y - self.rates[(j + 1) % 3]) * (y - self.rates[(j + 2) % 3]);
            let part = (y * t).exp() / others;
            let gas = y * (y + a_d) * v_g + y * (a_g * v_d) - push * (y + a_d);
            let dust = (y * (y + a_g) + kc_squared) * v_d + (y * v_g - push) * a_d;
            let density = y * (y + (a_g + a_d)) * delta_g - i * k * ((y + a_d) * v_g + a_g * v_d);
            sum.gas_velocity = sum.gas_velocity + gas * part;
            sum.dust_velocity = sum.dust_velocity + dust * part;
            sum.gas_density = sum.gas_density + density * part;
            sum.dust_density = sum.dust_density - i * k * dust * integral_of_exp(y, t) / others;
        }
        sum
    }

    /// The wave at place `x` and time `t` that starts as `initial` times $\sin kx$.
    pub fn at(&self, x: F, t: F, initial: Disturbance<F>) -> Disturbance<F> {
        let phase = Complex::from_polar(F::one(), self.wave_number * x);
        let now = self.amplitudes(t, initial);
        Disturbance {
            gas_velocity: (now.gas_velocity * phase).im,
            dust_velocity: (now.dust_velocity * phase).im,
            gas_density: (now.gas_density * phase).im,
            dust_density: (now.dust_density * phase).im,
        }
    }

    /// Kinetic energy per volume at time `t`, averaged over a wavelength: $\frac14(\rho_g|\hat v_g|^2 + \rho_d|\hat v_d|^2)$.
    pub fn kinetic_energy(&self, t: F, initial: Disturbance<F>) -> F {
        let now = self.amplitudes(t, initial);
        let gas = self.mixture.gas_density() * now.gas_velocity.norm_sqr();
        let dust = self.mixture.dust_density() * now.dust_velocity.norm_sqr();
        (gas + dust) / F::from(4.0).unwrap_or_else(F::one)
    }
}

/// The roots of $x^3 + (A + B)x^2 + x + B$ for $A, B \ge 0$.
///
/// One root is $-s$ with $s = B + A s^2/(1 + s^2)$, between $B$ and $A + B$. With it the polynomial is $(x + s)(x^2 + px + q)$ where
/// $p = A/(1 + s^2)$ and $q = B/s$: sums of positive terms only, so no digits are lost, however small or large $A$ and $B$ are.
fn dispersion_roots<F: Float>(gas: F, dust: F) -> [Complex<F>; 3] {
    let (zero, one, two) = (F::zero(), F::one(), F::one() + F::one());
    // s^2 / (1 + s^2) and what it lacks to one. The caller keeps squares within the number type.
    let saturation = |s: F| s * s / (one + s * s);
    let complement = |s: F| one / (one + s * s);
    let excess = |s: F| s - (dust + gas * saturation(s));
    let (mut low, mut high) = (dust, dust + gas);
    let mut s = high;
    // Newton's steps, and bisection wherever one leaves the bracket; that ends when the bracket is two neighbouring numbers.
    for _ in 0..2000 {
        if excess(s) > zero {
            high = s
        } else {
            low = s
        }
        let slope = one - if s > zero { two * gas * saturation(s) * complement(s) / s } else { zero };
        let newton = s - excess(s) / slope;
        let next = if newton > low && newton < high { newton } else { low + (high - low) / two };
        if next == s || next <= low || next >= high {
            break;
        }
        s = next;
    }
    let p = gas * complement(s);
    let q = if s > zero { dust / s } else { one };
    let half = p / two;
    let discriminant = half * half - q;
    if discriminant < zero {
        let frequency = (-discriminant).sqrt();
        [Complex::from(-s), Complex::new(-half, frequency), Complex::new(-half, -frequency)]
    } else {
        let outer = half + discriminant.sqrt();
        [Complex::from(-s), Complex::from(-outer), Complex::from(-(q / outer))]
    }
}

/// $\int_0^t e^{yt'}\,dt' = (e^z - 1)/y$ with $z = yt$; where $z$ is small, as $2 e^{z/2}\sinh(z/2)/y$.
fn integral_of_exp<F: Float>(y: Complex<F>, t: F) -> Complex<F> {
    if y.re.is_zero() && y.im.is_zero() {
        return Complex::from(t);
    }
    let two = F::one() + F::one();
    let half = y * (t / two);
    if half.norm() < F::one() { half.exp() * half.sinh() * two / y } else { ((y * t).exp() - F::one()) / y }
}
