//! The oscillating membrane (GS25 section 5.2): a thin cylinder in gas at rest that swells and shrinks and sends out waves.
//!
//! The paper states the cylinder's radius and length, the period, the largest velocity, the gas, the box and the number of particles. It does not
//! state how the oscillation starts, what the cylinder is made of, nor how particles are laid out; `docs/membrane.md` says what was taken.

mod symmetry;

use super::scene::{Description, GivenMomentum, Glasses, Measured, Quantity, Scene, Solution};
use super::{Block, Definition, Method, SceneError, State, View};
use crate::domain::Domain;
use crate::equations::equation_of_state::sound_speed;
use crate::exact::finite_volume::{End, FiniteVolume};
use crate::exact::outgoing_wave::OutgoingWave;
use crate::exact::riemann::State as Gas;
use crate::norms::mean;
use crate::particles::{Particle, ParticleSet};
use crate::passes::{Driver, Physics};
use crate::schemes::Viscosity;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// The cylinder's radius (GS25 section 5.2).
pub const RADIUS: f64 = 0.035;
/// The period of its oscillation (GS25 section 5.2).
pub const PERIOD: f64 = 0.05;
/// Its largest velocity (GS25 section 5.2).
pub const VELOCITY: f64 = 0.16;
/// A hundredth of it, at which the wave is that of linear acoustics to 0.2 %.
pub const FAINT_VELOCITY: f64 = 0.0016;
/// Density of the gas (GS25 section 5.2).
pub const DENSITY: f64 = 1.0;
/// Pressure of the gas (GS25 section 5.2).
pub const PRESSURE: f64 = 1.0;
/// The side of the periodic box (GS25 section 5.2, by reference to the blast's).
pub const SIDE: f64 = 1.0;
/// When the paper looks (GS25 Fig. 12).
pub const END_TIME: f64 = 0.35;
/// Where errors are measured in the paper's setting, in distances from the axis: all that is not cylinder and not nearer to a neighbouring box. Ours.
pub const MEASURED: (f64, f64) = (0.036, 0.5);
/// Where the axis is.
const AXIS: [f64; 2] = [0.5 * SIDE; 2];
/// The depth of the box in three dimensions, as that of the other flat problems (GS25 Table 2). Waves do not depend on it.
const DEPTH: f64 = 0.1;
/// Cells of the finite-volume solution: the mean error of the radial velocity changes by less than a part in a hundred beyond.
const CELLS: usize = 2400;
/// Places along the radius at which the linear wave is computed; between them it is drawn straight, a 25th of a wave apart.
const SAMPLES: usize = 200;
/// Fewer show no cylinder.
const LEAST: usize = 400;

/// What a run is compared with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Wave {
    /// The wave of the full equations around a surface that really moves, by finite volumes.
    Full,
    /// That of linear acoustics around one that keeps its place, as in the paper. At the paper's amplitude it is not the solution (`docs/membrane.md`).
    Linear,
}

/// The membrane: what is a choice of the problem.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Membrane {
    /// How it is computed.
    #[serde(skip)]
    pub method: Method,
    /// The cylinder's radius; the paper's is [`RADIUS`].
    pub radius: f64,
    /// The period of its oscillation; the paper's is [`PERIOD`].
    pub period: f64,
    /// The largest velocity of its surface; the paper's is [`VELOCITY`].
    pub velocity: f64,
    /// Whether the surface moves with its velocity; it stays in place otherwise.
    pub moves: bool,
    /// The adiabatic index; the paper's is 5/3.
    pub gamma: f64,
    /// What the wave is compared with.
    pub compared_with: Wave,
    /// How deep the box is in three dimensions.
    pub depth: f64,
}

impl Default for Membrane {
    fn default() -> Self {
        Self::standard(2)
    }
}

impl Membrane {
    /// The same with another method.
    pub fn with(mut self, change: impl FnOnce(&mut Method)) -> Self {
        change(&mut self.method);
        self
    }

    fn block<const D: usize>(&self) -> Block<D> {
        let upper = std::array::from_fn(|axis| if axis < 2 { SIDE } else { self.depth });
        Block { lower: [0.0; D], upper }
    }

    fn driver(&self) -> Driver {
        Driver { period: self.period, moves: self.moves }
    }

    fn sound_speed(&self) -> f64 {
        sound_speed(self.gamma - 1.0, PRESSURE / ((self.gamma - 1.0) * DENSITY))
    }

    /// The wave of linear acoustics with the same surface, kept in place.
    ///
    /// # Errors
    /// A velocity that is not positive, an index not above 1.
    pub fn linear(&self) -> Result<OutgoingWave, SceneError> {
        OutgoingWave::new(self.radius, TAU / self.period, self.velocity, self.sound_speed())
            .map_err(|error| SceneError::Solution(error.to_string()))
    }

    /// The wave of the full equations at a time, by finite volumes in so many cells.
    ///
    /// # Errors
    /// As [`FiniteVolume::new`] and [`FiniteVolume::run`].
    pub fn full(&self, cells: usize, time: f64) -> Result<FiniteVolume, SceneError> {
        let inner = End::Driven { velocity: self.velocity, driver: self.driver() };
        let rest = |_: f64| Gas { density: DENSITY, velocity: 0.0, pressure: PRESSURE };
        let made = FiniteVolume::new(2, self.gamma, (self.radius, 0.5 * SIDE), cells, [inner, End::Open], rest);
        made.and_then(|mut gas| gas.run(time).map(|()| gas)).map_err(|error| SceneError::Solution(error.to_string()))
    }

    /// The linear wave as a table over the radius.
    fn linear_at(&self, time: f64) -> Result<LinearWave, SceneError> {
        let wave = self.linear()?;
        let step = (0.5 * SIDE - self.radius) / (SAMPLES - 1) as f64;
        let rows = (0..SAMPLES).map(|i| wave.at(self.radius + i as f64 * step, time));
        let rows = rows.map(|row| [row.velocity, row.density_contrast]).collect();
        Ok(LinearWave { from: self.radius, step, rows, gamma: self.gamma })
    }
}

/// The linear wave at one time.
struct LinearWave {
    from: f64,
    step: f64,
    /// Velocity and relative change of the density.
    rows: Vec<[f64; 2]>,
    gamma: f64,
}

impl Solution for LinearWave {
    fn at(&self, r: f64) -> [f64; 4] {
        let place = ((r - self.from) / self.step).clamp(0.0, (self.rows.len() - 1) as f64);
        let below = (place as usize).min(self.rows.len() - 2);
        let part = place - below as f64;
        let [velocity, contrast] = [0, 1].map(|k| {
            let (low, high) = (self.rows[below][k], self.rows[below + 1][k]);
            low + part * (high - low)
        });
        // Small changes of state along the adiabat.
        let (density, pressure) = (DENSITY * (1.0 + contrast), PRESSURE * (1.0 + self.gamma * contrast));
        [density, velocity, pressure, pressure / ((self.gamma - 1.0) * density)]
    }
}

/// The full wave at one time.
struct FullWave {
    gas: FiniteVolume,
    gamma_minus_one: f64,
}

impl Solution for FullWave {
    fn at(&self, r: f64) -> [f64; 4] {
        let Gas { density, velocity, pressure } = self.gas.at(r);
        [density, velocity, pressure, pressure / (self.gamma_minus_one * density)]
    }
}

impl Definition for Membrane {
    const TITLE: &'static str = "Oscillating membrane";
    const SOURCE: &'static str = "GS25, section 5.2";
    const DIMENSIONS: &'static [usize] = &[2, 3];
    const SOLUTION: &'static str = "cylindrical finite volumes with a moving inner end, or the linear outgoing wave";
    const DRIVES_WAVES: bool = true;

    /// With the limiter that knows the wave's period (GS25 Table 8).
    fn standard(dimension: usize) -> Self {
        let mut method = Method::standard(dimension, if dimension == 2 { 10_000 } else { 40_000 });
        method.viscosity = Viscosity { wave_period: PERIOD, ..Viscosity::MEMBRANE[4] };
        Membrane {
            method,
            radius: RADIUS,
            period: PERIOD,
            velocity: VELOCITY,
            moves: true,
            gamma: 5.0 / 3.0,
            compared_with: Wave::Full,
            depth: DEPTH,
        }
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

impl<const D: usize> Scene<D> for Membrane {
    fn method(&self) -> &Method {
        &self.method
    }
    /// The limiter is told the period that the walls have, whatever the method's was.
    fn physics(&self) -> Physics {
        let physics = self.method.physics(self.gamma);
        let viscosity = Viscosity { wave_period: self.period, ..physics.viscosity };
        Physics { viscosity, driver: Some(self.driver()), ..physics }
    }
    fn check(&self) -> Result<(), SceneError> {
        SceneError::unless_in::<Self>("membrane", D)?;
        SceneError::unless_above("gamma", self.gamma, 1.0)?;
        SceneError::unless_above("period", self.period, 0.0)?;
        SceneError::unless_above("velocity", self.velocity, 0.0)?;
        SceneError::unless_above("depth", self.depth, 0.0)?;
        SceneError::unless_above("radius", self.radius, 0.0)?;
        if self.radius >= 0.25 * SIDE {
            let rule = format!("give less than {}, so that there is gas around", 0.25 * SIDE);
            return Err(SceneError::Choice { name: "radius", given: self.radius.to_string(), rule });
        }
        self.method.check(D)?;
        let block = self.block::<D>();
        // A cylinder of two spacings across at least.
        let round = |count: usize| (block.volume() / count as f64).powf(1.0 / D as f64) <= 0.5 * self.radius;
        let fits = |count| round(count) && block.has_room(&self.method, [true; D], count, 1.0);
        self.method.check_number(D, LEAST, fits)
    }
    fn particles(&self, glasses: &mut Glasses<D>) -> Result<ParticleSet<D>, SceneError> {
        Scene::<D>::check(self)?;
        let block = self.block::<D>();
        let filling = block.filled(&self.method, self.method.particles, glasses)?;
        let particle = |&position: &[f64; D]| {
            let x = [position[0] - AXIS[0], position[1 % D] - AXIS[1]];
            let r = x[0].hypot(x[1]);
            let mobile = r >= self.radius;
            let outwards = if mobile || r == 0.0 { 0.0 } else { self.velocity / r };
            Particle {
                position,
                velocity: std::array::from_fn(|axis| if axis < 2 { outwards * x[axis] } else { 0.0 }),
                mass: DENSITY * filling.volume,
                smoothing_length: self.method.smoothing_length(D, filling.volume),
                internal_energy: PRESSURE / ((self.gamma - 1.0) * DENSITY),
                mobile,
            }
        };
        let particles = filling.places.iter().map(particle).collect();
        Ok(ParticleSet::new(Domain::new(block.lower, block.upper, [true; D])?, particles)?)
    }
    fn view(&self) -> View {
        View::CylinderRadius(AXIS)
    }
    fn shown(&self) -> (f64, f64) {
        (self.radius, 0.5 * SIDE)
    }
    /// The paper's range, scaled with the cylinder.
    fn measured(&self, _: f64) -> Measured {
        Measured {
            range: (self.radius * MEASURED.0 / RADIUS, MEASURED.1),
            source: "around the cylinder; GS25 states none",
        }
    }
    fn solution(&self, time: f64) -> Result<Option<Box<dyn Solution>>, SceneError> {
        Ok(Some(match self.compared_with {
            Wave::Linear => Box::new(self.linear_at(time)?),
            Wave::Full => Box::new(FullWave { gas: self.full(CELLS, time)?, gamma_minus_one: self.gamma - 1.0 }),
        }))
    }
    /// The boxes around send waves too.
    fn last_time(&self) -> (f64, &'static str) {
        let front = (0.5 * SIDE - self.radius) / self.sound_speed();
        (front, "the wave meets those of the neighbouring boxes then")
    }
    fn given_momentum(&self, _: f64) -> GivenMomentum {
        GivenMomentum::Unknown("the cylinder pushes; by symmetry the sum is zero".into())
    }
    fn quantities(&self) -> Vec<Quantity> {
        let quantity = |name, label, symbol, unit, expected| Quantity { name, label, symbol, unit, expected };
        let round = "the wave is round";
        let faint = "linear acoustics, where the wave is faint";
        vec![
            quantity("kinetic_energy", "kinetic energy of the gas", "E_kin", "M L^2 T^-2", None),
            quantity(
                "entropy_gain",
                "mean change of the entropy over the specific heat",
                "ΔS/c_v",
                "",
                Some((0.0, faint)),
            ),
            quantity("entropy_scatter", "scatter of that change", "σ(ΔS)/c_v", "", Some((0.0, faint))),
            quantity(
                "azimuthal_velocity",
                "velocity around the cylinder, over the largest of its surface",
                "σ(v_φ)/v_m",
                "",
                Some((0.0, round)),
            ),
            quantity(
                "radial_scatter",
                "scatter of the radial velocity at one radius, over the same",
                "σ(v_r)/v_m",
                "",
                Some((0.0, round)),
            ),
        ]
    }
    fn observe(&self, state: &State) -> Result<Vec<f64>, SceneError> {
        Scene::<D>::observe_since(self, state, state)
    }
    fn observe_since(&self, start: &State, now: &State) -> Result<Vec<f64>, SceneError> {
        let gain = now.entropy_changes(start, self.gamma - 1.0, 0.0)?;
        let off: Vec<f64> = gain.changes.iter().flatten().map(|change| (change - gain.mean).powi(2)).collect();
        let scatter = mean(off.into_iter()).sqrt();
        let (around, radial) = symmetry::roundness(now, AXIS, Scene::<D>::measured(self, now.time).range);
        let (around, radial) = (around / self.velocity, radial / self.velocity);
        Ok(vec![now.kinetic_energy(), gain.mean, scatter, around, radial])
    }
    fn description(&self) -> Description {
        Description {
            start: "at rest; the surface moves as a sine from then on".into(),
            boundaries: "periodic; a cylinder of driven particles in the middle".into(),
            settings: vec![
                ("Radius of the cylinder".into(), self.radius.to_string()),
                ("Period, largest velocity".into(), format!("{}, {}", self.period, self.velocity)),
                ("Its surface".into(), if self.moves { "moves" } else { "keeps its place" }.into()),
            ],
        }
    }
}
