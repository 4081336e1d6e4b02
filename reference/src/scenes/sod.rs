//! Sod's shock tube (GS25 section 3.1): two gases at rest, eight times denser and ten times the pressure on the left.

use super::{Arrangement, Tube, lattice::Side};
use crate::domain::Domain;
use crate::equations::initial_state::smoothed_pressure;
use crate::equations::reconstruction::smoothing_length_holding;
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
/// Over what width GS25 (21) smooths the pressure.
pub const SMOOTHING_WIDTH: f64 = 0.01;
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
    /// The coefficient of artificial conduction; zero for none.
    pub conduction: f64,
}

/// What is wrong with the choices.
#[derive(Debug, thiserror::Error)]
pub enum SodError {
    /// So few particles that a support would meet itself around the tube.
    #[error(
        "--n {given}: too few for {neighbours} neighbours in the {dimension}-D tube, whose supports would meet themselves around it; \
         --n {enough} is enough"
    )]
    TooFew {
        /// What was asked for.
        given: usize,
        /// In how many dimensions.
        dimension: usize,
        /// What works.
        enough: usize,
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
    /// The gas is no gas: of all that the exact solution takes, only gamma is a choice.
    #[error("--gamma: {0}")]
    Riemann(#[from] RiemannError),
    /// Particles of which none counts.
    #[error(
        "no particle that moves is between x = {} and x = {}, where errors are measured; give a tube from 0 to 1",
        MEASURED.0, MEASURED.1
    )]
    NothingMeasured,
    /// Supports that would meet themselves around the tube.
    #[error("a particle's support reaches {reach} far, and the tube leaves it {most}; give smaller smoothing lengths")]
    Wide {
        /// The widest support's radius.
        reach: f64,
        /// Half the tube's width.
        most: f64,
    },
    /// The particles were refused.
    #[error(transparent)]
    Particles(#[from] ParticleError),
    /// The glass failed.
    #[error(transparent)]
    Glass(#[from] super::GlassError),
}

impl Sod {
    /// The paper's settings in `dimension` dimensions, with a size that the scalar reference runs within a minute.
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
            conduction: 0.0,
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
            viscosity: Viscosity { conduction: self.conduction, ..Viscosity::of(self.dissipation) },
            gamma_minus_one: self.gamma - 1.0,
            neighbours: self.neighbours,
            ..Physics::STANDARD
        }
    }

    /// The exact solution of the sharp start.
    pub fn exact(&self) -> Result<RiemannProblem<f64>, SodError> {
        let state = |side: usize| State { density: DENSITY[side], velocity: 0.0, pressure: PRESSURE[side] };
        Ok(RiemannProblem::new(state(0), state(1), self.gamma)?)
    }

    fn pressure(&self, side: usize, x: f64) -> f64 {
        if self.smoothed { self.pressure_at(x) } else { PRESSURE[side] }
    }

    /// The initial pressure at a place: a jump, or GS25 (21).
    pub fn pressure_at(&self, x: f64) -> f64 {
        let [left, right] = PRESSURE;
        match self.smoothed {
            true => smoothed_pressure(x, INTERFACE, SMOOTHING_WIDTH, 0.5 * (left - right), 0.5 * (left + right)),
            false if x < INTERFACE => left,
            false => right,
        }
    }

    /// The initial particles. `glass` gives a relaxed cube of `across^D` particles when one is asked for.
    pub fn particles<const D: usize>(
        &self,
        mut glass: impl FnMut(usize) -> Result<Vec<[f64; D]>, super::GlassError>,
    ) -> Result<ParticleSet<D>, SodError> {
        self.check::<D>()?;
        let (sides, mass) = TUBE.sides::<D>(self.particles);
        let reach = self.kernel.support();
        let mut particles = Vec::new();
        let mut depth = [0.0; 2];
        for (side, lattice) in sides.into_iter().enumerate() {
            let density = DENSITY[side];
            let h = smoothing_length_holding(self.neighbours, mass / density, D, self.kernel.support());
            depth[side] = WALL.max(2.0 * reach) * h;
            let places = match self.arrangement {
                Arrangement::Lattice => TUBE.places::<D>(side, lattice, depth[side]),
                Arrangement::Glass => tiles(side, lattice, depth[side], &glass(lattice.across)?),
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
        Ok(ParticleSet::new(domain(ends[0], ends[1])?, particles)?)
    }

    /// Whether there are such a gas and so many neighbours.
    pub fn check_physics(&self, dimension: usize) -> Result<(), SodError> {
        self.exact()?;
        let (least, most) = [(4.0, 40.0), (10.0, 150.0), (30.0, 600.0)][dimension - 1];
        if !(least..=most).contains(&self.neighbours) {
            return Err(SodError::Neighbours { given: self.neighbours, dimension, least, most });
        }
        Ok(())
    }

    /// Particles made elsewhere in the tube's box: periodic across it, and as long as they and their supports reach.
    pub fn particles_given<const D: usize>(&self, particles: Vec<Particle<D>>) -> Result<ParticleSet<D>, SodError> {
        let reach = |p: &Particle<D>| self.kernel.support() * p.smoothing_length;
        let measured = particles.iter().any(|p| p.mobile && (MEASURED.0..=MEASURED.1).contains(&p.position[0]));
        if !measured {
            return Err(SodError::NothingMeasured);
        }
        let widest = particles.iter().map(reach).fold(0.0, f64::max);
        if D > 1 && 2.0 * widest > WIDTH {
            return Err(SodError::Wide { reach: widest, most: 0.5 * WIDTH });
        }
        let lowest = particles.iter().map(|p| p.position[0] - reach(p)).fold(f64::INFINITY, f64::min);
        let highest = particles.iter().map(|p| p.position[0] + reach(p)).fold(f64::NEG_INFINITY, f64::max);
        Ok(ParticleSet::new(domain(lowest, highest)?, particles)?)
    }

    /// Whether these choices make a tube in `D` dimensions.
    pub fn check<const D: usize>(&self) -> Result<(), SodError> {
        self.check_physics(D)?;
        if !self.fits::<D>(self.particles) {
            let (given, neighbours) = (self.particles, self.neighbours);
            // Rows across the tube are whole: somewhat more particles are not always closer, so each number is tried.
            let mut enough = given.max(LEAST);
            while !self.fits::<D>(enough) {
                enough += 1 + enough / 100;
            }
            return Err(SodError::TooFew { given, dimension: D, enough, neighbours });
        }
        Ok(())
    }

    /// Whether so many particles leave room for the widest support, that of the thin gas.
    fn fits<const D: usize>(&self, particles: usize) -> bool {
        if particles < LEAST {
            return false;
        }
        let (_, mass) = TUBE.sides::<D>(particles);
        let h = smoothing_length_holding(self.neighbours, mass / DENSITY[1], D, self.kernel.support());
        let room = match self.arrangement {
            Arrangement::Lattice => LATTICE_ROOM,
            Arrangement::Glass => GLASS_ROOM,
        };
        D == 1 || 2.0 * self.kernel.support() * h * room <= WIDTH
    }
}

/// The tube's box between two ends: open along it, periodic across.
fn domain<const D: usize>(low: f64, high: f64) -> Result<Domain<D>, ParticleError> {
    let lower = std::array::from_fn(|axis| if axis == 0 { low } else { 0.0 });
    let upper = std::array::from_fn(|axis| if axis == 0 { high } else { WIDTH });
    Ok(Domain::new(lower, upper, std::array::from_fn(|axis| axis > 0))?)
}

const TUBE: Tube = Tube { interface: INTERFACE, width: WIDTH, density: DENSITY };
/// Fewer show no waves in one dimension either.
const LEAST: usize = 40;
/// The tube's width must be so many times a support's diameter: smoothing lengths grow a little where the thin gas is stirred.
const LATTICE_ROOM: f64 = 1.2;
/// The same while a glass is relaxed, where smoothing lengths overshoot: by 1.3 at most, as found.
const GLASS_ROOM: f64 = 1.35;

/// A side filled with copies of a glass, one after the other, scaled so that its density is right. In two and three dimensions the
/// glass has as many particles across as the side.
fn tiles<const D: usize>(side: usize, lattice: Side, depth: f64, glass: &[[f64; D]]) -> Vec<[f64; D]> {
    let across = (glass.len() as f64).powf(1.0 / D as f64).round();
    let (direction, length) = if side == 0 { (-1.0, INTERFACE) } else { (1.0, 1.0 - INTERFACE) };
    let tile = lattice.along * across;
    let copies = ((length + depth) / tile).ceil() as usize;
    let places = (0..copies).flat_map(|k| glass.iter().map(move |point| (k, point))).filter_map(|(k, point)| {
        let x = (k as f64 + point[0]) * tile;
        let place = |axis| if axis == 0 { INTERFACE + direction * x } else { point[axis] * WIDTH };
        (x < length + depth).then(|| std::array::from_fn(place))
    });
    places.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A lattice of `across^D` in the unit cube, as a glass would be given.
    fn regular<const D: usize>(across: usize) -> Vec<[f64; D]> {
        let place = |i: usize| {
            std::array::from_fn(|axis| ((i / across.pow(axis as u32) % across) as f64 + 0.5) / across as f64)
        };
        (0..across.pow(D as u32)).map(place).collect()
    }

    fn a_refusal_names_a_number_that_works<const D: usize>(arrangement: Arrangement) {
        for given in [0, 1, 39, 100, 500, 1000, 1700, 13_000] {
            let sod = Sod { particles: given, arrangement, ..Sod::standard(D) };
            if let Err(SodError::TooFew { enough, .. }) = sod.check::<D>() {
                assert!(enough > given);
                let more = Sod { particles: enough, ..sod };
                assert!(more.check::<D>().is_ok(), "{D}-D: {enough} for {given}");
                assert!(more.particles::<D>(|across| Ok(regular(across))).is_ok(), "{D}-D: {enough} for {given}");
            }
        }
        assert!(Sod::standard(D).check::<D>().is_ok());
    }

    #[test]
    fn refusals_name_a_number_that_works() {
        for arrangement in [Arrangement::Lattice, Arrangement::Glass] {
            a_refusal_names_a_number_that_works::<1>(arrangement);
            a_refusal_names_a_number_that_works::<2>(arrangement);
            a_refusal_names_a_number_that_works::<3>(arrangement);
        }
    }

    /// Both starts put the same mass on either side; a glass may be cut short by one layer at the end.
    fn a_glass_has_the_density_of_the_lattice<const D: usize>(across_in_1d: usize) {
        let sod = Sod { particles: 20_000, ..Sod::standard(D) };
        let count = |arrangement| {
            let across = |across: usize| if D == 1 { across_in_1d } else { across };
            let set = Sod { arrangement, ..sod }.particles::<D>(|n| Ok(regular(across(n)))).unwrap();
            let inside = |p: &&Particle<D>| (0.05..0.95).contains(&p.position[0]);
            let left = set.particles().iter().filter(inside).filter(|p| p.position[0] < INTERFACE).count();
            [left, set.particles().iter().filter(inside).count() - left]
        };
        let (lattice, glass) = (count(Arrangement::Lattice), count(Arrangement::Glass));
        for side in 0..2 {
            let off = glass[side] as f64 / lattice[side] as f64 - 1.0;
            assert!(off.abs() < 0.03, "{D}-D side {side}: {} and {} particles", lattice[side], glass[side]);
        }
    }

    #[test]
    fn glasses_have_the_density_of_lattices() {
        a_glass_has_the_density_of_the_lattice::<1>(64);
        a_glass_has_the_density_of_the_lattice::<2>(0);
        a_glass_has_the_density_of_the_lattice::<3>(0);
    }
}
