//! DUSTYSHOCK: Sod's tube with as much dust as gas, under strong drag (PL20 section 3.2; Laibe & Price 2012a).
//!
//! The exact solution is that of instant coupling: one gas, heavier by its dust. What the paper does not say, and what is taken:
//! - *the drag coefficient:* 1000, that of its wave and of Laibe & Price 2012a;
//! - *the adiabatic index and the time:* 5/3 and 0.2. Only these two put the end of the rarefaction where the paper sees a defect, at -0.02;
//! - *the ends:* fixed layers of both species beyond them, as in [`Sod`](super::sod::Sod)'s tube.
//!
//! The tube runs from 0 to 1, the paper's from -0.5 to 0.5.

use super::Tube;
use super::gas_and_dust::{DustySceneError, KERNEL, check_neighbours, mixture, physics, usual_neighbours};
use super::lattice::wall_depth;
use crate::domain::Domain;
use crate::equations::reconstruction::smoothing_length_holding;
use crate::exact::dust::Mixture;
use crate::exact::dustyshock;
use crate::exact::riemann::{RiemannProblem, State};
use crate::particles::{Particle, ParticleError, ParticleSet};
use crate::passes::Physics;
use crate::schemes::{Dissipation, Drag, Kernel};

/// Where the two sides meet.
pub const INTERFACE: f64 = 0.5;
/// Gas left and right (PL20 section 3.2): density, velocity, pressure.
pub const GAS: [State<f64>; 2] =
    [State { density: 1.0, velocity: 0.0, pressure: 1.0 }, State { density: 0.125, velocity: 0.0, pressure: 0.1 }];
/// When to look.
pub const END_TIME: f64 = 0.2;
/// The drag coefficient.
pub const DRAG_COEFFICIENT: f64 = 1000.0;

/// The choices of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DustyShock {
    /// Particles of each species left of the interface along the tube, `n_x`.
    pub particles: usize,
    /// The same across, in two and three dimensions (PL20 section 3.2: 24).
    pub rows: usize,
    /// Density of the dust over that of the gas.
    pub dust_to_gas: f64,
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

impl DustyShock {
    /// The paper's tube in `dimension` dimensions, at its lowest resolution.
    pub fn standard(dimension: usize) -> Self {
        DustyShock {
            particles: 128,
            rows: 24,
            dust_to_gas: 1.0,
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

    /// The exact solution of instant coupling, whose densities are those of gas and dust together.
    ///
    /// # Errors
    /// A ratio or an index that no mixture has.
    pub fn exact(&self) -> Result<RiemannProblem<f64>, DustySceneError> {
        let [left, right] = GAS;
        let both = [left, right].map(|gas| dustyshock::mixture(gas, self.dust_to_gas));
        let [left, right] = both;
        Ok(RiemannProblem::new(left?, right?, self.gamma)?)
    }

    /// The gas at a place and time, by the exact solution; the dust has its velocity and `dust_to_gas` times its density.
    ///
    /// # Errors
    /// As [`exact`](Self::exact).
    pub fn gas_at(&self, x: f64, time: f64) -> Result<State<f64>, DustySceneError> {
        Ok(dustyshock::gas_of(self.exact()?.sample((x - INTERFACE) / time), self.dust_to_gas)?)
    }

    /// The tube; with the left side's spacing across as along.
    fn tube(&self) -> Tube {
        let spacing = INTERFACE / self.particles as f64;
        Tube { interface: INTERFACE, width: self.rows as f64 * spacing, density: GAS.map(|gas| gas.density) }
    }

    /// The initial particles, gas first: all gas of one mass, and a copy of each as dust.
    ///
    /// # Errors
    /// Numbers that no mixture has, or so few particles that a support would meet itself around the tube.
    pub fn particles<const D: usize>(&self) -> Result<ParticleSet<D>, DustySceneError> {
        self.exact()?;
        check_neighbours(self.neighbours, D)?;
        // Also refuses a ratio of zero, with which dust would have no mass.
        Mixture::new(GAS[1].density, self.dust_to_gas * GAS[1].density, self.drag.coefficient)?;
        let fits = |particles: usize, rows: usize| DustyShock { particles, rows, ..*self }.fits::<D>();
        if !fits(self.particles, self.rows) {
            let (given, of) = if D == 1 { (self.particles, 0) } else { (self.rows, self.particles.max(LEAST)) };
            let works = |n: &usize| if D == 1 { fits(*n, self.rows) } else { fits(of, *n) };
            let enough = (1..).find(works).unwrap_or(given);
            return Err(DustySceneError::TooFew { given, enough });
        }
        let tube = self.tube();
        let (sides, mass) = tube.sides::<D>(self.count::<D>());
        let mut gas = Vec::new();
        let mut ends = [0.0, 1.0];
        for (side, lattice) in sides.into_iter().enumerate() {
            let State { density, velocity, pressure } = GAS[side];
            let h = smoothing_length_holding(self.neighbours, mass / density, D, self.kernel.support());
            let depth = wall_depth(self.kernel, h);
            ends[side] += [-1.0, 1.0][side] * (depth + lattice.along);
            gas.extend(tube.places::<D>(side, lattice, depth).into_iter().map(|position| Particle {
                position,
                velocity: std::array::from_fn(|axis| if axis == 0 { velocity } else { 0.0 }),
                mass,
                smoothing_length: h,
                internal_energy: pressure / ((self.gamma - 1.0) * density),
                mobile: (0.0..=1.0).contains(&position[0]),
            }));
        }
        let dust: Vec<_> = gas.iter().map(|p| Particle { mass: self.dust_to_gas * p.mass, ..*p }).collect();
        let lower = std::array::from_fn(|axis| if axis == 0 { ends[0] } else { 0.0 });
        let upper = std::array::from_fn(|axis| if axis == 0 { ends[1] } else { tube.width });
        let domain = Domain::new(lower, upper, std::array::from_fn(|axis| axis > 0)).map_err(ParticleError::from)?;
        Ok(mixture(domain, gas, dust)?)
    }

    /// How many particles of gas there are between both ends.
    fn count<const D: usize>(&self) -> usize {
        let left = self.particles * self.rows.pow(D as u32 - 1);
        let [dense, thin] = GAS.map(|gas| gas.density);
        (left as f64 * (1.0 + thin * (1.0 - INTERFACE) / (dense * INTERFACE))).round() as usize
    }

    /// Whether so many particles leave room across for the widest support, that of the thin side.
    fn fits<const D: usize>(&self) -> bool {
        if self.particles < LEAST || self.rows == 0 {
            return false;
        }
        let tube = self.tube();
        let (_, mass) = tube.sides::<D>(self.count::<D>());
        let h = smoothing_length_holding(self.neighbours, mass / GAS[1].density, D, self.kernel.support());
        D == 1 || 2.0 * self.kernel.support() * h * ROOM <= tube.width
    }
}

/// Fewer show no waves.
const LEAST: usize = 16;
/// The tube's width must be so many times a support's diameter: smoothing lengths grow a little where the thin side is stirred.
const ROOM: f64 = 1.2;
