//! The force that drives turbulence: a few long waves whose amplitudes are processes of Ornstein and Uhlenbeck (C25 section 2, GS25 section 4;
//! Federrath et al. 2010).
//!
//! The papers give the range of waves, the parabola and the process. Strength, memory and normalisation are SPH-EXA's. Where
//! that code and the papers differ, or the code's choice has a side effect, both are there: [`Profile`], [`ModeWeights`].

mod field;
mod modes;

pub use modes::{Mode, PEAK, modes};

use super::error::{TurbulenceError, check_column, check_length};
use super::snapshot::{Snapshot, periodic_side};
use crate::domain::Domain;
use crate::equations::turbulence::{driving_term, ornstein_uhlenbeck_step, project_mode, projection_norm_squared};
use crate::schemes::{ModeWeights, Profile};
use etalon_kernels_gen::functions::ratio_or_zero;
use etalon_kernels_gen::{Vector, equation};
use rand::SeedableRng;
use rand_distr::{Distribution, StandardNormal};
use rand_pcg::Pcg64Mcg;
use std::f64::consts::TAU;

/// Energy put in per unit of `v^3 / L` (SPH-EXA).
const ENERGY_RATE: f64 = 5e-3;

/// What the driving is like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Driving {
    /// The velocity aimed at, `v`; the Mach number where the sound speed is one.
    pub velocity: f64,
    /// The weight of the part without divergence, `zeta`, from 0 to 1; one half is the natural mixture, two thirds of it solenoidal.
    pub solenoidal_weight: f64,
    /// What is a parabola.
    pub profile: Profile,
    /// How directions are weighted.
    pub weights: ModeWeights,
}

impl Driving {
    /// Subsonic turbulence of Mach number 0.3, naturally mixed (C25, GS25), all directions alike.
    pub const fn subsonic() -> Self {
        Driving { velocity: 0.3, solenoidal_weight: 0.5, profile: Profile::Power, weights: ModeWeights::Even }
    }
    /// How long the force remembers, `T = L / (2 v)`: the time it takes to cross half the box.
    pub fn correlation_time(&self, side: f64) -> f64 {
        side / (2.0 * self.velocity)
    }
    /// The standard deviation of the process, `sigma = sqrt(E / T)` with `E = 0.005 v^3 / L`. (SPH-EXA calls it the variance.)
    pub fn deviation(&self, side: f64) -> f64 {
        (ENERGY_RATE * self.velocity.powi(3) / side / self.correlation_time(side)).sqrt()
    }
}

/// The amplitudes of one wave: two independent processes for each component.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Wave<const D: usize> {
    wave_vector: [i32; D],
    amplitude: f64,
    real: [f64; D],
    imaginary: [f64; D],
}

/// A wave of the force as it stands now: `real cos(2 pi n.x / L) - imaginary sin(2 pi n.x / L)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ForceWave<const D: usize> {
    /// Waves along each side of the box.
    pub wave_vector: [i32; D],
    /// Factor of the cosine.
    pub real: Vector<f64, D>,
    /// Factor of the sine, with the minus.
    pub imaginary: Vector<f64, D>,
}

/// The force on particles.
#[derive(Clone, Debug, PartialEq)]
pub struct Drive<const D: usize> {
    /// By axis and particle, without its mean.
    pub acceleration: [Vec<f64>; D],
    /// The mean over mass that was taken away.
    ///
    /// No wave has a mean over the box, but particles that are not evenly spread sample one, and the gas would drift.
    pub mean: [f64; D],
}

/// Where the processes of a force stand.
#[derive(Clone, Debug, PartialEq)]
pub struct ForcingState {
    /// Wave by wave, the components of the real part, then those of the imaginary one.
    pub amplitudes: Vec<f64>,
    /// The state of the random numbers.
    pub random: u128,
}

/// The driving force and its state.
#[derive(Clone, Debug)]
pub struct Forcing<const D: usize> {
    driving: Driving,
    side: f64,
    waves: Vec<Wave<D>>,
    random: Pcg64Mcg,
}

impl<const D: usize> Forcing<D> {
    /// A force that has been going on for ever: amplitudes are drawn from the distribution they settle in.
    ///
    /// # Errors
    /// A box that is not a periodic cube, a velocity that is not positive, a weight outside 0 to 1, or 1 in one dimension, where every wave
    /// has a divergence.
    pub fn new(domain: &Domain<D>, driving: Driving, seed: u64) -> Result<Self, TurbulenceError> {
        let side = periodic_side(domain)?;
        let refused = |name, value, rule| Err(TurbulenceError::Parameter { name, value, rule });
        let Driving { velocity, solenoidal_weight, profile, weights } = driving;
        if !(velocity.is_finite() && velocity > 0.0) {
            return refused("driving velocity", velocity, "it must be finite and positive");
        }
        if !(0.0..=1.0).contains(&solenoidal_weight) {
            return refused("solenoidal weight", solenoidal_weight, "it must lie between 0 and 1");
        }
        if D == 1 && solenoidal_weight == 1.0 {
            return refused(
                "solenoidal weight",
                solenoidal_weight,
                "in one dimension nothing is solenoidal: take less",
            );
        }
        let sigma = driving.deviation(side);
        let mut random = Pcg64Mcg::seed_from_u64(seed);
        let waves = modes::weighted::<D>(profile, weights)
            .into_iter()
            .map(|(wave_vector, amplitude)| {
                let mut draw = || std::array::from_fn(|_| sigma * normal(&mut random));
                Wave { wave_vector, amplitude, real: draw(), imaginary: draw() }
            })
            .collect();
        Ok(Forcing { driving, side, waves, random })
    }

    /// Lets a time pass. The result is as random after one long step as after many short ones.
    ///
    /// # Errors
    /// A step that is negative or not finite.
    pub fn advance(&mut self, time_step: f64) -> Result<(), TurbulenceError> {
        if !(time_step.is_finite() && time_step >= 0.0) {
            let rule = "it must be finite and not negative";
            return Err(TurbulenceError::Parameter { name: "time step of the driving", value: time_step, rule });
        }
        let decay = time_step / self.driving.correlation_time(self.side);
        let sigma = self.driving.deviation(self.side);
        for wave in &mut self.waves {
            for x in wave.real.iter_mut().chain(&mut wave.imaginary) {
                *x = ornstein_uhlenbeck_step(*x, decay, sigma, normal(&mut self.random));
            }
        }
        Ok(())
    }

    /// The waves of the force as it stands.
    pub fn waves(&self) -> Vec<ForceWave<D>> {
        let zeta = self.driving.solenoidal_weight;
        let norm = projection_norm_squared::<f64, D>(zeta).sqrt();
        let force = |wave: &Wave<D>| {
            let n = Vector(wave.wave_vector.map(f64::from));
            let projected = |x: [f64; D]| project_mode(Vector(x), n, zeta).scale(norm * wave.amplitude);
            ForceWave {
                wave_vector: wave.wave_vector,
                real: projected(wave.real),
                imaginary: projected(wave.imaginary),
            }
        };
        self.waves.iter().map(force).collect()
    }

    /// The force at each particle, its mean over mass taken away.
    ///
    /// # Errors
    /// Particles in a box of another size.
    pub fn on(&self, snapshot: &Snapshot<D>) -> Result<Drive<D>, TurbulenceError> {
        let side = snapshot.periodic_side()?;
        if side != self.side {
            let rule = "the force was made for another box: make one for this";
            return Err(TurbulenceError::Parameter { name: "side of the particles' box", value: side, rule });
        }
        self.at(snapshot.places(), snapshot.mass())
    }

    /// The force at places given by their fixed-point coordinates in the box, by axis; its mean over these masses is taken away, if there is any mass.
    ///
    /// # Errors
    /// Columns of different length.
    pub fn at(&self, places: &[Vec<u64>; D], mass: &[f64]) -> Result<Drive<D>, TurbulenceError> {
        for column in places {
            check_length("list of coordinates", column.len(), mass.len())?;
        }
        let mut acceleration = field::accelerations(&self.waves(), places);
        let whole: f64 = mass.iter().sum();
        let mean = std::array::from_fn(|axis| {
            let total: f64 = acceleration[axis].iter().zip(mass).map(|(a, m)| a * m).sum();
            ratio_or_zero(total, whole)
        });
        for (axis, column) in acceleration.iter_mut().enumerate() {
            column.iter_mut().for_each(|a| *a -= mean[axis]);
        }
        Ok(Drive { acceleration, mean })
    }

    /// What a force that is to go on later needs, beside what it was made with.
    pub fn state(&self) -> ForcingState {
        let amplitudes = self.waves.iter().flat_map(|wave| wave.real.into_iter().chain(wave.imaginary)).collect();
        ForcingState { amplitudes, random: self.random.state() }
    }

    /// Goes on from a state of a force that was made with the same driving in a box of the same size: as that one would have, bit for bit.
    ///
    /// # Errors
    /// Another number of amplitudes than this force has, or one that is not finite.
    pub fn restore(&mut self, state: &ForcingState) -> Result<(), TurbulenceError> {
        check_length("list of amplitudes", state.amplitudes.len(), 2 * D * self.waves.len())?;
        check_column("amplitudes", &state.amplitudes, false)?;
        let mut next = state.amplitudes.iter().copied();
        for x in self.waves.iter_mut().flat_map(|wave| wave.real.iter_mut().chain(&mut wave.imaginary)) {
            *x = next.next().unwrap_or(*x);
        }
        self.random = Pcg64Mcg::new(state.random);
        Ok(())
    }

    /// The root mean square of the force over the box and over time, `sigma sqrt(nu sum a^2)`, whatever the solenoidal weight is.
    pub fn expected_rms(&self) -> f64 {
        let sum: f64 = self.waves.iter().map(|wave| wave.amplitude * wave.amplitude).sum();
        self.driving.deviation(self.side) * (D as f64 * sum).sqrt()
    }
}

/// The force of these waves at a place given in fixed-point coordinates.
///
/// The phase is formed in whole numbers, so that it is exact anywhere in the box.
#[equation(unnumbered = "the driving force at a place, C25 section 2", host)]
pub fn force_at<const D: usize>(waves: &[ForceWave<D>], coordinates: [u64; D]) -> Vector<f64, D> {
    waves.iter().fold(Vector::zero(), |sum, wave| {
        let turn = (0..D).fold(0_u64, |turn, axis| {
            turn.wrapping_add(coordinates[axis].wrapping_mul(i64::from(wave.wave_vector[axis]) as u64))
        });
        let (sine, cosine) = (turn as i64 as f64 * (TAU / 18_446_744_073_709_551_616.0)).sin_cos();
        sum + driving_term(1.0, wave.real, wave.imaginary, cosine, sine)
    })
}

fn normal(random: &mut Pcg64Mcg) -> f64 {
    StandardNormal.sample(random)
}
