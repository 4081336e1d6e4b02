//! Even gas in a periodic box, where nothing should happen: cold flow at a high Mach number, a lattice that is neither even nor cubic, and so many neighbours
//! that particles may pair.
//!
//! Ours: equations that cancel to nothing in print do not in a sum over particles, and these are the states in which one sees it.

use super::measures::nearest_distances;
use super::scene::{Description, GivenMomentum, Glasses, Measured, Quantity, Scene, Solution};
use super::{Block, Definition, Method, SceneError, State, View};
use crate::domain::Domain;
use crate::equations::time_step::COURANT;
use crate::particles::{Particle, ParticleSet};
use crate::passes::Physics;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use serde::{Deserialize, Serialize};
use std::fmt::Debug;
use std::marker::PhantomData;

/// Density.
pub const DENSITY: f64 = 1.0;
/// Pressure.
pub const PRESSURE: f64 = 1.0;
/// The adiabatic index (GS25 section 3).
const GAMMA: f64 = 5.0 / 3.0;
/// Nearer than this share of the mean distance to the nearest particle of a lattice, two particles are a pair.
const PAIRED: f64 = 0.5;
/// Fewer have no inside.
const LEAST: usize = 20;
/// Wider jitter lets particles pass each other.
const MOST_JITTER: f64 = 0.45;
/// Longer cells than these leave neighbours along one axis only.
const MOST_STRETCH: f64 = 3.0;

/// Half of the way around nobody can tell forwards from backwards.
const FARTHEST: f64 = 0.45;

/// What tells one from another: its standard choices.
pub trait Kind: Copy + Debug + PartialEq + Send + Sync + 'static {
    /// Its word.
    const NAME: &'static str;
    /// For people.
    const TITLE: &'static str;
    /// The Mach number of the flow along x.
    const MACH: f64 = 0.0;
    /// How far particles are moved from the lattice along each axis, in spacings.
    const JITTER: f64 = 0.0;
    /// By how much cells are longer along y than along x.
    const STRETCH: f64 = 1.0;
    /// How wide the box is along the other axes in two and three dimensions.
    const WIDTH: [f64; 2] = [1.0, 1.0];
    /// How many times as many neighbours as usual in three dimensions; the same support in the others.
    const MORE_NEIGHBOURS: f64 = 1.0;
    /// When one looks, in times that sound takes through the box.
    const CROSSINGS: f64 = 1.0;
}

/// A flow at Mach 100: it must stay even, with an internal energy of a six-thousandth of the kinetic.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColdFlow;
/// A stretched and jittered lattice of even pressure: it should settle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoisyLattice;
/// A slightly jittered lattice with four times the usual neighbours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pairing;

impl Kind for ColdFlow {
    const NAME: &'static str = "cold-flow";
    const TITLE: &'static str = "Even flow at Mach 100";
    const MACH: f64 = 100.0;
    /// So narrow that a step, which only sound limits, does not take gas halfway around the box.
    const WIDTH: [f64; 2] = [0.5, 0.2];
    const CROSSINGS: f64 = 0.05;
}
impl Kind for NoisyLattice {
    const NAME: &'static str = "noisy-lattice";
    const TITLE: &'static str = "A stretched and jittered lattice";
    const JITTER: f64 = 0.2;
    const STRETCH: f64 = 1.3;
}
impl Kind for Pairing {
    const NAME: &'static str = "pairing";
    const TITLE: &'static str = "Many neighbours";
    const JITTER: f64 = 0.1;
    /// 400 in three dimensions, the most that GS25 section 3 calls safe with its kernel.
    const MORE_NEIGHBOURS: f64 = 4.0;
}

/// Even gas: what is a choice of the problem.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, bound = "")]
pub struct EvenGas<K: Kind> {
    /// How it is computed.
    #[serde(skip)]
    pub method: Method,
    /// The Mach number of the flow along x.
    pub mach: f64,
    /// How far particles are moved from the lattice along each axis, at most, in spacings.
    pub jitter: f64,
    /// By how much the lattice's cells are longer along the other axes than along x.
    pub stretch: f64,
    /// How wide the box is along the other axes; along x it is 1 long.
    pub width: f64,
    /// Which of the random starts.
    pub seed: u64,
    /// The adiabatic index.
    pub gamma: f64,
    #[serde(skip)]
    kind: PhantomData<K>,
}

impl<K: Kind> Default for EvenGas<K> {
    fn default() -> Self {
        Self::standard(2)
    }
}

impl<K: Kind> EvenGas<K> {
    /// The box, and that which is filled with cubes before it is squeezed along x.
    fn blocks<const D: usize>(&self) -> [Block<D>; 2] {
        let long = |first: f64| Block {
            lower: [0.0; D],
            upper: std::array::from_fn(|axis| if axis == 0 { first } else { self.width }),
        };
        [long(1.0), long(self.stretch)]
    }
    /// The speed of sound.
    pub fn sound_speed(&self) -> f64 {
        (self.gamma * PRESSURE / DENSITY).sqrt()
    }
    /// The speed of the flow.
    pub fn speed(&self) -> f64 {
        self.mach * self.sound_speed()
    }
    fn internal_energy(&self) -> f64 {
        PRESSURE / ((self.gamma - 1.0) * DENSITY)
    }
}

impl<K: Kind> Definition for EvenGas<K> {
    const TITLE: &'static str = K::TITLE;
    const SOURCE: &'static str = "ours";
    const DIMENSIONS: &'static [usize] = &[2, 3, 1];
    const SOLUTION: &'static str = "even gas";

    fn standard(dimension: usize) -> Self {
        let mut method = Method::standard(dimension, [400, 4_000, 14_000][dimension - 1]);
        method.neighbours *= K::MORE_NEIGHBOURS.powf(dimension as f64 / 3.0);
        let stretch = if dimension == 1 { 1.0 } else { K::STRETCH };
        let width = if dimension == 3 { K::WIDTH[1] } else { K::WIDTH[0] };
        EvenGas { method, mach: K::MACH, jitter: K::JITTER, stretch, width, seed: 1, gamma: GAMMA, kind: PhantomData }
    }
    fn end_time(&self) -> f64 {
        K::CROSSINGS / self.sound_speed()
    }
    fn method(&self) -> &Method {
        &self.method
    }
    fn method_mut(&mut self) -> &mut Method {
        &mut self.method
    }
}

impl<K: Kind, const D: usize> Scene<D> for EvenGas<K> {
    fn method(&self) -> &Method {
        &self.method
    }
    fn physics(&self) -> Physics {
        self.method.physics(self.gamma)
    }
    fn check(&self) -> Result<(), SceneError> {
        SceneError::unless_in::<Self>(K::NAME, D)?;
        SceneError::unless_above("gamma", self.gamma, 1.0)?;
        for (name, value, (least, most)) in [
            ("mach", self.mach, (-1e4, 1e4)),
            ("jitter", self.jitter, (0.0, MOST_JITTER)),
            ("stretch", self.stretch, (1.0 / MOST_STRETCH, MOST_STRETCH)),
            ("width", self.width, (0.01, 1.0)),
        ] {
            if !(least..=most).contains(&value) {
                let rule = format!("give a number from {least} to {most}");
                return Err(SceneError::Choice { name, given: value.to_string(), rule });
            }
        }
        self.method.check(D)?;
        let [block, _] = self.blocks::<D>();
        block.check_room(&self.method, [true; D], LEAST, 1.0)?;
        // Half of h / v_sig, with v_sig of two particles that move alike: twice the speed of sound.
        let h = self.method.smoothing_length(D, block.volume() / self.method.particles as f64);
        let step = 0.5 * COURANT * h * self.mach.abs();
        if step > FARTHEST {
            let rule = format!(
                "a step would take the gas {step} of the way around the box, and {FARTHEST} is the most; give more particles, \
                 a narrower box or a lower Mach number"
            );
            return Err(SceneError::Choice { name: "mach", given: self.mach.to_string(), rule });
        }
        Ok(())
    }
    fn particles(&self, glasses: &mut Glasses<D>) -> Result<ParticleSet<D>, SceneError> {
        Scene::<D>::check(self)?;
        let [block, long] = self.blocks::<D>();
        let filling = long.filled(&self.method, self.method.particles, glasses)?;
        let volume = block.volume() / filling.places.len() as f64;
        let h = self.method.smoothing_length(D, volume);
        let spacing = filling.volume.powf(1.0 / D as f64);
        let mut random = Pcg64Mcg::seed_from_u64(self.seed);
        let mut place = |cube: &[f64; D]| -> [f64; D] {
            std::array::from_fn(|axis| {
                let shift = self.jitter * spacing * (2.0 * random.random::<f64>() - 1.0);
                let share = (cube[axis] + shift) / long.upper[axis];
                (share - share.floor()) * block.upper[axis]
            })
        };
        let particles = filling.places.iter().map(|cube| Particle {
            position: place(cube),
            velocity: std::array::from_fn(|axis| if axis == 0 { self.speed() } else { 0.0 }),
            mass: DENSITY * volume,
            smoothing_length: h,
            internal_energy: self.internal_energy(),
            mobile: true,
        });
        Ok(ParticleSet::new(Domain::new(block.lower, block.upper, [true; D])?, particles.collect())?)
    }
    fn view(&self) -> View {
        View::Along(0)
    }
    fn shown(&self) -> (f64, f64) {
        (0.0, 1.0)
    }
    fn measured(&self, _: f64) -> Measured {
        Measured { range: (0.0, 1.0), source: "the whole box" }
    }
    fn solution(&self, _: f64) -> Result<Option<Box<dyn Solution>>, SceneError> {
        Ok(Some(Box::new(Same([DENSITY, self.speed(), PRESSURE, self.internal_energy()]))))
    }
    fn given_momentum(&self, _: f64) -> GivenMomentum {
        GivenMomentum::None
    }
    fn quantities(&self) -> Vec<Quantity> {
        let even = Some((0.0, "even gas"));
        let quantity = |name, label, symbol, expected| Quantity { name, label, symbol, unit: "", expected };
        vec![
            quantity("velocity_noise", "scatter of the velocity, over the speed of sound", "σ(v)/c", even),
            quantity("density_noise", "scatter of the density", "σ(ρ)/ρ", even),
            quantity("energy_drift", "change of the energy, over the internal energy", "ΔE/U", even),
            quantity("entropy_gain", "mean change of the entropy over the specific heat", "ΔS/c_v", even),
            quantity("nearest", "mean distance to the nearest particle, in spacings of a lattice", "⟨d⟩", None),
            quantity("closest", "smallest distance of two particles, in such spacings", "d_min", None),
            quantity("paired", "share of the particles closer than half a spacing to another", "", even),
        ]
    }
    fn observe(&self, state: &State) -> Result<Vec<f64>, SceneError> {
        Scene::<D>::observe_since(self, state, state)
    }
    fn observe_since(&self, start: &State, now: &State) -> Result<Vec<f64>, SceneError> {
        let speed = self.speed();
        let off = |i: usize| {
            let v = now.speed(i);
            ((v[0] - speed).powi(2) + v[1] * v[1] + v[2] * v[2]).sqrt()
        };
        let energy = |state: &State| state.kinetic_energy() + state.thermal_energy();
        let [block, _] = self.blocks::<D>();
        let spacing = (block.volume() / now.len() as f64).powf(1.0 / D as f64);
        let nearest = nearest_distances(now, &Domain::new(block.lower, block.upper, [true; D])?);
        let count = nearest.len() as f64;
        Ok(vec![
            now.root_mean_square(off) / self.sound_speed(),
            now.scatter(&now.density, DENSITY),
            (energy(now) - energy(start)) / now.thermal_energy(),
            now.entropy_gain(start, self.gamma - 1.0, 0.0)?,
            nearest.iter().sum::<f64>() / count / spacing,
            nearest.iter().copied().fold(f64::INFINITY, f64::min) / spacing,
            nearest.iter().filter(|d| **d < PAIRED * spacing).count() as f64 / count,
        ])
    }
    fn description(&self) -> Description {
        Description {
            start: "even gas; what it does is error".into(),
            boundaries: "periodic".into(),
            settings: vec![
                ("Density, pressure".into(), format!("{DENSITY}, {PRESSURE}")),
                ("Mach number".into(), self.mach.to_string()),
                ("Jitter, in spacings".into(), self.jitter.to_string()),
                ("Stretch of the lattice".into(), self.stretch.to_string()),
            ],
        }
    }
}

struct Same([f64; 4]);

impl Solution for Same {
    fn at(&self, _: f64) -> [f64; 4] {
        self.0
    }
}
