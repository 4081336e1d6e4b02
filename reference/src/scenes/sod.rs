//! Sod's shock tube (GS25 section 3.1): two gases at rest, eight times denser and ten times the pressure on the left.

use super::scene::{Description, GivenMomentum, Glasses, Measured, Scene, Solution};
use super::{Arrangement, Definition, GlassError, Method, SceneError, Tube, View, lattice::Side};
use crate::domain::Domain;
use crate::equations::initial_state::smoothed_pressure;
use crate::exact::riemann::{RiemannError, RiemannProblem, State, Wave};
use crate::particles::{Particle, ParticleError, ParticleSet};
use crate::passes::Physics;
use serde::{Deserialize, Serialize};

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

/// The tube: what is a choice of the problem.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Sod {
    /// How it is computed.
    #[serde(skip)]
    pub method: Method,
    /// Whether the pressure is smoothed across the interface (GS25 21); sharp otherwise.
    pub smoothed: bool,
    /// The adiabatic index; the paper's is 5/3.
    pub gamma: f64,
}

impl Default for Sod {
    fn default() -> Self {
        Sod::standard(3)
    }
}

impl Sod {
    /// The paper's settings in `dimension` dimensions, with a size that the scalar reference runs within a minute.
    pub fn standard(dimension: usize) -> Self {
        let method = Method::standard(dimension, [450, 6_000, 14_000][dimension - 1]);
        Sod { method, smoothed: false, gamma: 5.0 / 3.0 }
    }

    /// The same with another method.
    pub fn with(mut self, change: impl FnOnce(&mut Method)) -> Self {
        change(&mut self.method);
        self
    }

    /// The physics of all passes.
    pub fn physics(&self) -> Physics {
        self.method.physics(self.gamma)
    }

    /// The exact solution of the sharp start.
    pub fn exact(&self) -> Result<RiemannProblem<f64>, SceneError> {
        let state = |side: usize| State { density: DENSITY[side], velocity: 0.0, pressure: PRESSURE[side] };
        // Of all that the exact solution takes, only gamma is a choice.
        let refused = |error: RiemannError| SceneError::Choice {
            name: "gamma",
            given: self.gamma.to_string(),
            rule: error.to_string(),
        };
        RiemannProblem::new(state(0), state(1), self.gamma).map_err(refused)
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
        mut glass: impl FnMut(usize) -> Result<Vec<[f64; D]>, GlassError>,
    ) -> Result<ParticleSet<D>, SceneError> {
        self.check::<D>()?;
        let (sides, mass) = TUBE.sides::<D>(self.method.particles);
        let reach = self.method.kernel.support();
        let mut particles = Vec::new();
        let mut depth = [0.0; 2];
        for (side, lattice) in sides.into_iter().enumerate() {
            let density = DENSITY[side];
            let h = self.method.smoothing_length(D, mass / density);
            depth[side] = WALL.max(2.0 * reach) * h;
            let places = match self.method.arrangement {
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
    pub fn check_physics(&self, dimension: usize) -> Result<(), SceneError> {
        self.exact()?;
        self.method.check(dimension)
    }

    /// Particles made elsewhere in the tube's box: periodic across it, and as long as they and their supports reach.
    pub fn particles_given<const D: usize>(&self, particles: Vec<Particle<D>>) -> Result<ParticleSet<D>, SceneError> {
        let reach = |p: &Particle<D>| self.method.kernel.support() * p.smoothing_length;
        let measured = particles.iter().any(|p| p.mobile && (MEASURED.0..=MEASURED.1).contains(&p.position[0]));
        if !measured {
            return Err(SceneError::Given(format!(
                "no particle that moves is between x = {} and x = {}, where errors are measured; give a tube from 0 to 1",
                MEASURED.0, MEASURED.1
            )));
        }
        let widest = particles.iter().map(reach).fold(0.0, f64::max);
        if D > 1 && 2.0 * widest > WIDTH {
            let most = 0.5 * WIDTH;
            return Err(SceneError::Given(format!(
                "a particle's support reaches {widest} far, and the tube leaves it {most}; give smaller smoothing lengths"
            )));
        }
        let lowest = particles.iter().map(|p| p.position[0] - reach(p)).fold(f64::INFINITY, f64::min);
        let highest = particles.iter().map(|p| p.position[0] + reach(p)).fold(f64::NEG_INFINITY, f64::max);
        Ok(ParticleSet::new(domain(lowest, highest)?, particles)?)
    }

    /// Whether these choices make a tube in `D` dimensions.
    pub fn check<const D: usize>(&self) -> Result<(), SceneError> {
        self.check_physics(D)?;
        if !self.fits::<D>(self.method.particles) {
            let (given, neighbours) = (self.method.particles, self.method.neighbours);
            // Rows across the tube are whole: somewhat more particles are not always closer, so each number is tried.
            let mut enough = given.max(LEAST);
            while !self.fits::<D>(enough) {
                enough += 1 + enough / 100;
            }
            return Err(SceneError::TooFew { given, dimension: D, enough, neighbours });
        }
        Ok(())
    }

    /// Whether so many particles leave room for the widest support, that of the thin gas.
    fn fits<const D: usize>(&self, particles: usize) -> bool {
        if particles < LEAST {
            return false;
        }
        let (_, mass) = TUBE.sides::<D>(particles);
        let h = self.method.smoothing_length(D, mass / DENSITY[1]);
        let room = match self.method.arrangement {
            Arrangement::Lattice => LATTICE_ROOM,
            Arrangement::Glass => GLASS_ROOM,
        };
        D == 1 || 2.0 * self.method.kernel.support() * h * room <= WIDTH
    }
}

impl Definition for Sod {
    const TITLE: &'static str = "Sod shock tube";
    const SOURCE: &'static str = "GS25, section 3.1";
    const DIMENSIONS: &'static [usize] = &[3, 2, 1];
    const SOLUTION: &'static str = "Riemann problem";

    fn standard(dimension: usize) -> Self {
        Sod::standard(dimension)
    }
    fn end_time(&self) -> f64 {
        END_TIME
    }
    fn method(&self) -> &Method {
        &self.method
    }
    fn method_mut(&mut self) -> &mut Method {
        &mut self.method
    }
}

impl<const D: usize> Scene<D> for Sod {
    fn method(&self) -> &Method {
        &self.method
    }
    fn physics(&self) -> Physics {
        Sod::physics(self)
    }
    fn check(&self) -> Result<(), SceneError> {
        Sod::check::<D>(self)
    }
    fn particles(&self, glasses: &mut Glasses<D>) -> Result<ParticleSet<D>, SceneError> {
        Sod::particles::<D>(self, glasses)
    }
    fn view(&self) -> View {
        View::Along(0)
    }
    fn shown(&self) -> (f64, f64) {
        (0.0, 1.0)
    }
    fn measured(&self, _: f64) -> Measured {
        Measured { range: MEASURED, source: "GS25, section 3.1 and Eq. 20" }
    }
    fn solution(&self, time: f64) -> Result<Option<Box<dyn Solution>>, SceneError> {
        Ok(Some(Box::new(TubeAt { problem: self.exact()?, time, gamma_minus_one: self.gamma - 1.0 })))
    }
    /// When the first wave reaches an end of the tube.
    fn last_time(&self) -> (f64, &'static str) {
        let Ok(exact) = self.exact() else { return (0.0, "there is no exact solution") };
        let room = [INTERFACE, 1.0 - INTERFACE];
        let reaches = |wave: Option<Wave<f64>>, room: f64| wave.map_or(f64::INFINITY, |w| room / w.head().abs());
        let last = reaches(exact.left_wave(), room[0]).min(reaches(exact.right_wave(), room[1]));
        (last, "a wave reaches the end of the tube then")
    }
    fn given_momentum(&self, time: f64) -> GivenMomentum {
        let area = WIDTH.powi(D as i32 - 1);
        let pressure = PRESSURE[0] - PRESSURE[1];
        GivenMomentum::Along {
            axis: 0,
            momentum: pressure * area * time,
            by: format!(
                "the fixed layers push with the pressure of the gas at rest, P_L − P_R = {pressure} on an area of {area}"
            ),
        }
    }
    fn description(&self) -> Description {
        let pair = |[left, right]: [f64; 2]| format!("{left}, {right}");
        Description {
            start: match self.smoothed {
                true => format!(
                    "pressure smoothed over {SMOOTHING_WIDTH} (GS25, Eq. 21), while the exact solution is that of the sharp start"
                ),
                false => "sharp".into(),
            },
            boundaries: match D {
                1 => "fixed layers at both ends".into(),
                _ => "fixed layers at both ends of the tube, periodic across it".into(),
            },
            settings: vec![
                ("Density, left and right".into(), pair(DENSITY)),
                ("Pressure, left and right".into(), pair(PRESSURE)),
            ],
        }
    }
}

/// The exact solution of the sharp start at one time.
struct TubeAt {
    problem: RiemannProblem<f64>,
    time: f64,
    gamma_minus_one: f64,
}

impl TubeAt {
    fn waves(&self) -> impl Iterator<Item = Wave<f64>> {
        [self.problem.left_wave(), self.problem.right_wave()].into_iter().flatten()
    }
    fn place(&self, speed: f64) -> f64 {
        INTERFACE + speed * self.time
    }
}

impl Solution for TubeAt {
    fn at(&self, x: f64) -> [f64; 4] {
        let state = self.problem.sample((x - INTERFACE) / self.time);
        let energy = state.pressure / (self.gamma_minus_one * state.density);
        [state.density, state.velocity, state.pressure, energy]
    }
    fn corners(&self) -> Vec<f64> {
        let ends = self.waves().flat_map(|wave| match wave {
            Wave::Rarefaction { head, tail } => vec![head, tail],
            Wave::Shock { .. } => Vec::new(),
        });
        ends.map(|speed| self.place(speed)).collect()
    }
    fn jumps(&self) -> Vec<f64> {
        let shocks = self.waves().filter_map(|wave| wave.shock());
        self.problem.contact().into_iter().chain(shocks).map(|speed| self.place(speed)).collect()
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
            let sod = Sod::standard(D).with(|m| (m.particles, m.arrangement) = (given, arrangement));
            if let Err(SceneError::TooFew { enough, .. }) = sod.check::<D>() {
                assert!(enough > given);
                let more = sod.with(|m| m.particles = enough);
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
        let sod = Sod::standard(D).with(|m| m.particles = 20_000);
        let count = |arrangement| {
            let across = |across: usize| if D == 1 { across_in_1d } else { across };
            let set = sod.with(|m| m.arrangement = arrangement).particles::<D>(|n| Ok(regular(across(n)))).unwrap();
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
