//! DUSTYWAVE: a linear sound wave in gas with as much dust, under strong drag (PL20 section 3.1; Laibe & Price 2011).
//!
//! What the paper does not say, and what is taken:
//! - *the box:* one wavelength, one long, periodic;
//! - *10 wave periods:* ten times wavelength over `c_s`, so t = 10 (in periods of the mixture's own, slower wave it would be 14.1);
//! - *the start:* velocities of both species, relative density of both and the gas's energy all in phase, as PHANTOM's `setup_wave`
//!   has it. That is not one travelling wave of the mixture but two and a fast mode; the exact solution has all of them;
//! - *how particles show the density:* by their masses. Moved places would be off by the grid of places, 2^-32 of the box: at an amplitude of
//!   10^-6 and 1024 particles that is noise of a tenth of the wave. A lattice of a power of two lies on that grid exactly.

use super::gas_and_dust::{
    DustySceneError, KERNEL, check_neighbours, enough_across, lattice, mixture, physics, usual_neighbours,
};
use crate::domain::Domain;
use crate::equations::reconstruction::smoothing_length_holding;
use crate::exact::dust::Mixture;
use crate::exact::dustywave;
use crate::exact::dustywave::Disturbance;
use crate::particles::{Particle, ParticleError, ParticleSet};
use crate::passes::Physics;
use crate::schemes::{Dissipation, Drag, Kernel};
use std::f64::consts::TAU;

/// When the paper looks, as we read its ten periods.
pub const END_TIME: f64 = 10.0;
/// The drag coefficient (PL20 section 3.1).
pub const DRAG_COEFFICIENT: f64 = 1000.0;
/// The amplitude of the start (PL20 section 3.1), of velocities in units of the sound speed and of densities.
pub const AMPLITUDE: f64 = 1e-6;
/// The wavelength and the box's length.
const WAVELENGTH: f64 = 1.0;

/// The choices of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DustyWave {
    /// Particles of each species along the wave, `n_x`. A power of two lies on the grid of places exactly.
    pub particles: usize,
    /// Particles of each species across, in two and three dimensions (PL20 section 3.1: 12).
    pub rows: usize,
    /// The amplitude, of velocities in units of the sound speed and of densities.
    pub amplitude: f64,
    /// Density of the gas.
    pub gas_density: f64,
    /// Density of the dust.
    pub dust_density: f64,
    /// The gas's adiabatic sound speed.
    pub sound_speed: f64,
    /// The adiabatic index.
    pub gamma: f64,
    /// Drag.
    pub drag: Drag,
    /// The kernel, whose double-humped partner is drag's.
    pub kernel: Kernel,
    /// The number of neighbours of the same species, the particle included.
    pub neighbours: f64,
    /// The gas's dissipation scheme.
    pub dissipation: Dissipation,
}

impl DustyWave {
    /// The paper's wave in `dimension` dimensions, with its resolution of Fig. 3.
    pub fn standard(dimension: usize) -> Self {
        DustyWave {
            particles: 128,
            rows: 12,
            amplitude: AMPLITUDE,
            gas_density: 1.0,
            dust_density: 1.0,
            sound_speed: 1.0,
            gamma: 5.0 / 3.0,
            drag: Drag::of(DRAG_COEFFICIENT),
            kernel: KERNEL,
            neighbours: usual_neighbours(dimension),
            dissipation: Dissipation::AvSlrB2,
        }
    }

    /// The physics of all passes.
    pub fn physics(&self) -> Physics {
        physics(self.kernel, self.neighbours, self.dissipation, self.gamma, self.drag)
    }

    /// The exact solution, to be asked with [`initial`](Self::initial).
    ///
    /// # Errors
    /// Numbers that no mixture has.
    pub fn exact(&self) -> Result<dustywave::DustyWave<f64>, DustySceneError> {
        let mixture = Mixture::new(self.gas_density, self.dust_density, self.drag.coefficient)?;
        Ok(dustywave::DustyWave::new(mixture, self.sound_speed, WAVELENGTH)?)
    }

    /// The wave at the start: these times `sin kx`.
    pub fn initial(&self) -> Disturbance<f64> {
        let velocity = self.amplitude * self.sound_speed;
        Disturbance {
            gas_velocity: velocity,
            dust_velocity: velocity,
            gas_density: self.amplitude,
            dust_density: self.amplitude,
        }
    }

    /// The initial particles, gas first.
    ///
    /// # Errors
    /// Numbers that no mixture has, or so few particles that a support would meet itself.
    pub fn particles<const D: usize>(&self) -> Result<ParticleSet<D>, DustySceneError> {
        self.exact()?;
        check_neighbours(self.neighbours, D)?;
        let enough = enough_across(self.kernel, self.neighbours, D);
        let fewest = if D == 1 { self.particles } else { self.particles.min(self.rows) };
        if fewest < enough {
            return Err(DustySceneError::TooFew { given: fewest, enough });
        }
        let spacing = WAVELENGTH / self.particles as f64;
        let volume = spacing.powi(D as i32);
        let h = smoothing_length_holding(self.neighbours, volume, D, self.kernel.support());
        let counts = std::array::from_fn(|axis| if axis == 0 { self.particles } else { self.rows });
        let quiet = self.sound_speed * self.sound_speed / (self.gamma * (self.gamma - 1.0));
        let start = self.initial();
        let of = |density: f64, rise: f64, velocity: f64| {
            lattice(counts, spacing, 0.0).into_iter().map(move |position| {
                let wave = (TAU * position[0] / WAVELENGTH).sin();
                Particle {
                    position,
                    velocity: std::array::from_fn(|axis| if axis == 0 { velocity * wave } else { 0.0 }),
                    mass: density * volume * (1.0 + rise * wave),
                    smoothing_length: h,
                    // Along the adiabat, du = (P / rho^2) drho.
                    internal_energy: quiet * (1.0 + (self.gamma - 1.0) * rise * wave),
                    mobile: true,
                }
            })
        };
        let upper = counts.map(|count| count as f64 * spacing);
        let domain = Domain::new([0.0; D], upper, [true; D]).map_err(ParticleError::from)?;
        let gas = of(self.gas_density, start.gas_density, start.gas_velocity);
        Ok(mixture(domain, gas, of(self.dust_density, start.dust_density, start.dust_velocity))?)
    }
}
