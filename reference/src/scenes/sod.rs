//! Sod's shock tube (GS25 section 3.1): two gases at rest, eight times denser and ten times the pressure on the left.

use super::{Arrangement, Tube, lattice::Side};
use crate::domain::Domain;
use crate::equations::initial_state::smoothed_pressure;
use crate::equations::reconstruction::support_volume;
use crate::exact::riemann::{RiemannError, RiemannProblem, State};
use crate::particles::{Particle, ParticleError, ParticleSet};
use crate::passes::Physics;
use crate::schemes::{Dissipation, GradH, Kernel, Viscosity};

/// Where the two gases meet (GS25 21).
pub const INTERFACE: f64 = 0.5;
/// The tube's width in two and three dimensions (GS25 Table 2).
pub const WIDTH: f64 = 0.125;
/// Density left and right (GS25 section 3.1).
pub const DENSITY: [f64; 2] = [1.0, 0.125];
/// Pressure left and right (GS25 section 3.1).
pub const PRESSURE: [f64; 2] = [1.0, 0.1];
/// When the paper looks (GS25 Fig. 1).
pub const END_TIME: f64 = 0.2;
/// Where errors are measured (GS25 section 3.1).
pub const MEASURED: (f64, f64) = (0.05, 0.868);
/// The fixed layers beyond both ends, in smoothing lengths of their side: more than a support and what a particle at the end moves.
const WALL: f64 = 4.0;

/// The choices of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sod {
    /// About how many particles, the walls not counted.
    pub particles: usize,
    /// How they start.
    pub arrangement: Arrangement,
    /// Whether the pressure is smoothed across the interface (GS25 21); sharp otherwise.
    pub smoothed: bool,
    /// The adiabatic index; the paper's is 5/3.
    pub gamma: f64,
    /// The kernel.
    pub kernel: Kernel,
    /// The number of neighbours, the particle included.
    pub neighbours: f64,
    /// The dissipation scheme.
    pub dissipation: Dissipation,
    /// The grad-h form.
    pub grad_h: GradH,
}

/// What is wrong with the choices.
#[derive(Debug, thiserror::Error)]
pub enum SodError {
    /// Too few or too many particles.
    #[error(
        "--n {given}: the {dimension}-D tube needs at least {least} particles for {neighbours} neighbours; give a larger number"
    )]
    TooFew {
        /// What was asked for.
        given: usize,
        /// In how many dimensions.
        dimension: usize,
        /// What it takes.
        least: usize,
        /// With so many neighbours.
        neighbours: f64,
    },
    /// A neighbour number that no kernel can use.
    #[error("--neighbours {given}: {dimension}-D needs between {least} and {most}")]
    Neighbours {
        /// What was asked for.
        given: f64,
        /// In how many dimensions.
        dimension: usize,
        /// At least.
        least: f64,
        /// At most.
        most: f64,
    },
    /// The gas is no gas.
    #[error(transparent)]
    Riemann(#[from] RiemannError),
    /// The particles were refused.
    #[error(transparent)]
    Particles(#[from] ParticleError),
    /// The glass failed.
    #[error(transparent)]
    Glass(#[from] super::GlassError),
}

impl Sod {
    /// The paper's settings in `dimension` dimensions, with a size that runs in well under a minute.
    pub fn standard(dimension: usize) -> Self {
        Sod {
            particles: [450, 6_000, 14_000][dimension - 1],
            arrangement: Arrangement::Lattice,
            smoothed: false,
            gamma: 5.0 / 3.0,
            kernel: Kernel::MixedSinc,
            neighbours: Self::usual_neighbours(dimension),
            dissipation: Dissipation::AvSlrB2,
            grad_h: GradH::Corrected,
        }
    }

    /// About 100 neighbours in 3-D (GS25), and the same support in spacings in the other dimensions.
    pub fn usual_neighbours(dimension: usize) -> f64 {
        [5.8, 26.0, 100.0][dimension - 1]
    }

    /// The physics of all passes.
    pub fn physics(&self) -> Physics {
        Physics {
            kernel: self.kernel,
            grad_h: self.grad_h,
            viscosity: Viscosity::of(self.dissipation),
            gamma_minus_one: self.gamma - 1.0,
            neighbours: self.neighbours,
        }
    }

    /// The exact solution of the sharp start.
    pub fn exact(&self) -> Result<RiemannProblem<f64>, SodError> {
        let state = |side: usize| State { density: DENSITY[side], velocity: 0.0, pressure: PRESSURE[side] };
        Ok(RiemannProblem::new(state(0), state(1), self.gamma)?)
    }

    /// The smoothing length that holds the wanted neighbours where every particle has this volume.
    fn smoothing_length<const D: usize>(&self, volume: f64) -> f64 {
        (self.neighbours * volume / support_volume(D, self.kernel.support())).powf(1.0 / D as f64)
    }

    fn pressure(&self, side: usize, x: f64) -> f64 {
        if self.smoothed { smoothed_pressure(x, INTERFACE, 0.01, 0.45, 0.55) } else { PRESSURE[side] }
    }

    /// The initial particles. `glass` gives a relaxed cube of `across^D` particles when one is asked for.
    pub fn particles<const D: usize>(
        &self,
        mut glass: impl FnMut(usize) -> Result<Vec<[f64; D]>, super::GlassError>,
    ) -> Result<ParticleSet<D>, SodError> {
        self.check::<D>()?;
        let tube = Tube { interface: INTERFACE, width: WIDTH, density: DENSITY };
        let (sides, mass) = tube.sides::<D>(self.particles);
        let reach = self.kernel.support();
        let mut particles = Vec::new();
        let mut depth = [0.0; 2];
        for (side, lattice) in sides.into_iter().enumerate() {
            let density = DENSITY[side];
            let h = self.smoothing_length::<D>(mass / density);
            if D > 1 && 2.0 * reach * h * 1.2 > WIDTH {
                return Err(self.too_few::<D>(mass, h));
            }
            depth[side] = WALL.max(2.0 * reach) * h;
            let places = match self.arrangement {
                Arrangement::Lattice => tube.places::<D>(side, lattice, depth[side]),
                Arrangement::Glass => {
                    tiles(&tube, side, lattice, depth[side], &glass(lattice.across.max(GLASS_LEAST))?)
                }
            };
            particles.extend(places.into_iter().map(|position| {
                let pressure = self.pressure(side, position[0]);
                Particle {
                    position,
                    velocity: [0.0; D],
                    mass,
                    smoothing_length: h,
                    internal_energy: pressure / ((self.gamma - 1.0) * density),
                    mobile: (0.0..=1.0).contains(&position[0]),
                }
            }));
        }
        let ends = [-depth[0] - sides[0].along, 1.0 + depth[1] + sides[1].along];
        let lower = std::array::from_fn(|axis| if axis == 0 { ends[0] } else { 0.0 });
        let upper = std::array::from_fn(|axis| if axis == 0 { ends[1] } else { WIDTH });
        let domain = Domain::new(lower, upper, std::array::from_fn(|axis| axis > 0)).map_err(ParticleError::from)?;
        Ok(ParticleSet::new(domain, particles)?)
    }

    fn check<const D: usize>(&self) -> Result<(), SodError> {
        self.exact()?;
        let (least, most) = [(4.0, 40.0), (10.0, 150.0), (30.0, 600.0)][D - 1];
        if !(least..=most).contains(&self.neighbours) {
            return Err(SodError::Neighbours { given: self.neighbours, dimension: D, least, most });
        }
        let least = [40, 100, 1000][D - 1];
        if self.particles < least {
            let (given, neighbours) = (self.particles, self.neighbours);
            return Err(SodError::TooFew { given, dimension: D, least, neighbours });
        }
        Ok(())
    }

    fn too_few<const D: usize>(&self, mass: f64, h: f64) -> SodError {
        // The support shrinks with the spacing, the spacing with the D-th root of the particle number.
        let shrink = 2.0 * self.kernel.support() * h * 1.25 / WIDTH;
        let total = (DENSITY[0] + DENSITY[1]) * 0.5 * WIDTH.powi(D as i32 - 1) / mass;
        let least = (total * shrink.powi(D as i32)).ceil() as usize;
        SodError::TooFew { given: self.particles, dimension: D, least, neighbours: self.neighbours }
    }
}

/// A glass smaller than this would repeat itself within a support.
const GLASS_LEAST: usize = 6;

/// A side filled with copies of a glass, scaled so that `lattice.across` of its particles lie across the tube and its density is right.
fn tiles<const D: usize>(tube: &Tube, side: usize, lattice: Side, depth: f64, glass: &[[f64; D]]) -> Vec<[f64; D]> {
    let across = (glass.len() as f64).powf(1.0 / D as f64).round();
    let (direction, length) = if side == 0 { (-1.0, tube.interface) } else { (1.0, 1.0 - tube.interface) };
    let tile = lattice.along * across;
    // Across the tube the glass fits as a whole number of times, usually once.
    let copies = (lattice.across as f64 / across).max(1.0).round() as usize;
    let scale = tube.width / copies as f64;
    let mut places = Vec::new();
    for k in 0..((length + depth) / tile).ceil() as usize {
        for row in 0..copies.pow(D as u32 - 1) {
            for point in glass {
                let x = (k as f64 + point[0]) * tile;
                if x < length + depth {
                    places.push(std::array::from_fn(|axis| match axis {
                        0 => tube.interface + direction * x,
                        _ => ((row / copies.pow(axis as u32 - 1) % copies) as f64 + point[axis]) * scale,
                    }));
                }
            }
        }
    }
    places
}
