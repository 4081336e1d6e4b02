//! Sod's shock tube (GS25 section 3.1): two gases at rest, eight times denser and ten times the pressure on the left.

use super::scene::{Description, GivenMomentum, Glasses, Measured, Quantity, Scene, Solution};
use super::shock_tube::ShockTube;
use super::{AtEnd, Course, Definition, GlassError, Method, SceneError, View};
use crate::equations::initial_state::smoothed_pressure;
use crate::exact::riemann::{RiemannProblem, State};
use crate::particles::{Particle, ParticleSet};
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

    /// The tube that it is one of.
    fn tube(&self) -> ShockTube {
        let state = |side: usize| State { density: DENSITY[side], velocity: 0.0, pressure: PRESSURE[side] };
        ShockTube {
            method: self.method,
            states: [state(0), state(1)],
            gamma: self.gamma,
            interface: INTERFACE,
            width: WIDTH,
            end_time: END_TIME,
        }
    }

    /// The exact solution of the sharp start.
    pub fn exact(&self) -> Result<RiemannProblem<f64>, SceneError> {
        // Of all that the exact solution takes, only gamma is a choice.
        self.tube().exact().map_err(|error| SceneError::Choice {
            name: "gamma",
            given: self.gamma.to_string(),
            rule: error.to_string(),
        })
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
        glass: impl FnMut(usize) -> Result<Vec<[f64; D]>, GlassError>,
    ) -> Result<ParticleSet<D>, SceneError> {
        self.check::<D>()?;
        self.tube().particles(|side, x| self.pressure(side, x), glass)
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
        Ok(ParticleSet::new(self.tube().domain(lowest, highest)?, particles)?)
    }

    /// Whether these choices make a tube in `D` dimensions.
    pub fn check<const D: usize>(&self) -> Result<(), SceneError> {
        self.check_physics(D)?;
        self.tube().check_room::<D>()
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
        Ok(Some(Box::new(self.tube().solution(self.exact()?, time))))
    }
    /// When the first wave reaches an end of the tube.
    fn last_time(&self) -> (f64, &'static str) {
        self.tube().last_time::<D>()
    }
    fn given_momentum(&self, time: f64) -> GivenMomentum {
        self.tube().given_momentum::<D>(time)
    }
    fn quantities_at_end(&self) -> Vec<Quantity> {
        self.tube().quantities_at_end()
    }
    fn at_end(&self, course: &Course) -> Result<AtEnd, SceneError> {
        self.tube().at_end(course.end)
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

#[cfg(test)]
mod tests {
    use super::super::Arrangement;
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
