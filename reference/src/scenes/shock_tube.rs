//! What tubes have in common in which two gases meet.

use super::lattice::Side;
use super::scene::{GivenMomentum, Solution};
use super::{Arrangement, GlassError, Method, SceneError, Tube};
use crate::domain::Domain;
use crate::exact::riemann::{RiemannError, RiemannProblem, State, Wave};
use crate::particles::{Particle, ParticleError, ParticleSet};

/// Fewer show no waves in one dimension either.
const LEAST: usize = 40;
/// The tube's width must be so many times a support's diameter: smoothing lengths grow a little where the thin gas is stirred.
const LATTICE_ROOM: f64 = 1.2;
/// The same while a glass is relaxed, where smoothing lengths overshoot: by 1.3 at most, as found.
const GLASS_ROOM: f64 = 1.35;
/// How much longer than needed the gas is that comes in or leaves at an end.
const SPARE: f64 = 1.1;

/// A tube along x from 0 to 1, periodic across it, in which two gases meet.
///
/// An end whose gas rests is continued by a fixed layer; one whose gas moves by gas that moves with it, so much that the tube notices no end before
/// `end_time`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShockTube {
    /// How it is computed.
    pub method: Method,
    /// The gas left and right.
    pub states: [State<f64>; 2],
    /// The adiabatic index.
    pub gamma: f64,
    /// Where they meet.
    pub interface: f64,
    /// The width along every other axis.
    pub width: f64,
    /// Until when it is meant to run.
    pub end_time: f64,
}

impl ShockTube {
    /// The exact solution of the sharp start.
    pub fn exact(&self) -> Result<RiemannProblem<f64>, RiemannError> {
        let [left, right] = self.states;
        RiemannProblem::new(left, right, self.gamma)
    }

    fn tube(&self) -> Tube {
        Tube { interface: self.interface, width: self.width, density: self.states.map(|state| state.density) }
    }

    /// The speed at which an end is heard of in the tube, if its gas moves.
    fn comes_in(&self, side: usize) -> Option<f64> {
        let State { density, velocity, pressure } = self.states[side];
        let inwards = if side == 0 { velocity } else { -velocity };
        (velocity != 0.0).then(|| (inwards + (self.gamma * pressure / density).sqrt()).max(0.0))
    }

    /// How far the gas goes on beyond an end.
    fn beyond(&self, side: usize, smoothing_length: f64) -> f64 {
        let wall = self.method.wall(smoothing_length);
        wall + self.comes_in(side).map_or(0.0, |speed| SPARE * speed * self.end_time)
    }

    /// The initial particles, with the pressure as a function of side and place. `glass` gives a relaxed cube of `across^D` particles when one is asked for.
    pub fn particles<const D: usize>(
        &self,
        pressure: impl Fn(usize, f64) -> f64,
        mut glass: impl FnMut(usize) -> Result<Vec<[f64; D]>, GlassError>,
    ) -> Result<ParticleSet<D>, SceneError> {
        let tube = self.tube();
        let (sides, mass) = tube.sides::<D>(self.method.particles);
        let mut particles = Vec::new();
        let mut depth = [0.0; 2];
        for (side, lattice) in sides.into_iter().enumerate() {
            let State { density, velocity, .. } = self.states[side];
            let h = self.method.smoothing_length(D, mass / density);
            depth[side] = self.beyond(side, h);
            let places = match self.method.arrangement {
                Arrangement::Lattice => tube.places::<D>(side, lattice, depth[side]),
                Arrangement::Glass => tiles(&tube, side, lattice, depth[side], &glass(lattice.across)?),
            };
            particles.extend(places.into_iter().map(|position| Particle {
                position,
                velocity: std::array::from_fn(|axis| if axis == 0 { velocity } else { 0.0 }),
                mass,
                smoothing_length: h,
                internal_energy: pressure(side, position[0]) / ((self.gamma - 1.0) * density),
                mobile: velocity != 0.0 || (0.0..=1.0).contains(&position[0]),
            }));
        }
        let ends = [-depth[0] - sides[0].along, 1.0 + depth[1] + sides[1].along];
        Ok(ParticleSet::new(self.domain(ends[0], ends[1])?, particles)?)
    }

    /// The tube's box between two ends: open along it, periodic across.
    pub fn domain<const D: usize>(&self, low: f64, high: f64) -> Result<Domain<D>, ParticleError> {
        let lower = std::array::from_fn(|axis| if axis == 0 { low } else { 0.0 });
        let upper = std::array::from_fn(|axis| if axis == 0 { high } else { self.width });
        Ok(Domain::new(lower, upper, std::array::from_fn(|axis| axis > 0))?)
    }

    /// Refuses too few particles, naming a number that is enough.
    pub fn check_room<const D: usize>(&self) -> Result<(), SceneError> {
        self.method.check_number(D, LEAST, |particles| self.fits::<D>(particles))
    }

    /// Whether so many particles leave room for the widest support, that of the thinner gas.
    fn fits<const D: usize>(&self, particles: usize) -> bool {
        let tube = self.tube();
        let (_, mass) = tube.sides::<D>(particles);
        let h = self.method.smoothing_length(D, mass / tube.density[0].min(tube.density[1]));
        let room = match self.method.arrangement {
            Arrangement::Lattice => LATTICE_ROOM,
            Arrangement::Glass => GLASS_ROOM,
        };
        D == 1 || 2.0 * self.method.kernel.support() * h * room <= self.width
    }

    /// When the first wave reaches an end of the tube, or an end is heard of in it.
    pub fn last_time<const D: usize>(&self) -> (f64, &'static str) {
        let Ok(exact) = self.exact() else { return (0.0, "there is no exact solution") };
        let room = [self.interface, 1.0 - self.interface];
        // Outwards only: a wave that goes the other way meets the other end.
        let reaches = |wave: Option<Wave<f64>>| {
            let heads = wave.map(|wave| wave.head());
            heads.map_or(f64::INFINITY, |head| room[usize::from(head > 0.0)] / head.abs())
        };
        let waves = reaches(exact.left_wave()).min(reaches(exact.right_wave()));
        let (_, mass) = self.tube().sides::<D>(self.method.particles);
        let heard = (0..2).filter_map(|side| {
            let h = self.method.smoothing_length(D, mass / self.states[side].density);
            let speed = self.comes_in(side).filter(|speed| *speed > 0.0)?;
            Some((self.beyond(side, h) - self.method.wall(h)) / speed)
        });
        let heard = heard.fold(f64::INFINITY, f64::min);
        match heard < waves {
            true => (heard, "the end of the gas beyond the tube is heard of in it then"),
            false => (waves, "a wave reaches the end of the tube then"),
        }
    }

    /// What the fixed layers give.
    pub fn given_momentum<const D: usize>(&self, time: f64) -> GivenMomentum {
        let area = self.width.powi(D as i32 - 1);
        let push = |side: usize| if self.comes_in(side).is_none() { self.states[side].pressure } else { 0.0 };
        let pressure = push(0) - push(1);
        if [0, 1].iter().all(|&side| self.comes_in(side).is_some()) {
            return GivenMomentum::None;
        }
        GivenMomentum::Along {
            axis: 0,
            momentum: pressure * area * time,
            by: format!(
                "the fixed layers push with the pressure of the gas at rest, P_L − P_R = {pressure} on an area of {area}"
            ),
        }
    }

    /// The exact solution of the sharp start at one time.
    pub fn solution(&self, problem: RiemannProblem<f64>, time: f64) -> impl Solution + use<> {
        TubeAt { problem, interface: self.interface, time, gamma_minus_one: self.gamma - 1.0 }
    }
}

struct TubeAt {
    problem: RiemannProblem<f64>,
    interface: f64,
    time: f64,
    gamma_minus_one: f64,
}

impl TubeAt {
    fn waves(&self) -> impl Iterator<Item = Wave<f64>> {
        [self.problem.left_wave(), self.problem.right_wave()].into_iter().flatten()
    }
    fn place(&self, speed: f64) -> f64 {
        self.interface + speed * self.time
    }
}

impl Solution for TubeAt {
    fn at(&self, x: f64) -> [f64; 4] {
        let state = self.problem.sample((x - self.interface) / self.time);
        // Vacuum has no energy.
        let energy = if state.is_vacuum() { 0.0 } else { state.pressure / (self.gamma_minus_one * state.density) };
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

/// A side filled with copies of a glass, one after the other, scaled so that its density is right. In two and three dimensions the
/// glass has as many particles across as the side.
fn tiles<const D: usize>(tube: &Tube, side: usize, lattice: Side, depth: f64, glass: &[[f64; D]]) -> Vec<[f64; D]> {
    let across = (glass.len() as f64).powf(1.0 / D as f64).round();
    let (direction, length) = if side == 0 { (-1.0, tube.interface) } else { (1.0, 1.0 - tube.interface) };
    let tile = lattice.along * across;
    let copies = ((length + depth) / tile).ceil() as usize;
    let places = (0..copies).flat_map(|k| glass.iter().map(move |point| (k, point))).filter_map(|(k, point)| {
        let x = (k as f64 + point[0]) * tile;
        let place = |axis| if axis == 0 { tube.interface + direction * x } else { point[axis] * tube.width };
        (x < length + depth).then(|| std::array::from_fn(place))
    });
    places.collect()
}
