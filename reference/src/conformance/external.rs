//! Whether what acts on particles from outside acts on an engine's as it should: gravity, driven walls, a force of the host.
//!
//! Gas at rest on a lattice has no accelerations but those of rounding, so that what is added to them can be seen by itself.

use super::runs::Distance;
use super::sets::{self, Difficulty};
use crate::domain::{Domain, SINGLE_PLACES, separation};
use crate::engine::{Engine, EngineError};
use crate::equations::reconstruction::smoothing_length_holding;
use crate::fields;
use crate::particles::{Particle, ParticleSet};
use crate::passes::{Driver, Physics};
use crate::pipeline::Pipeline;
use crate::scenes::Block;
use crate::scenes::sod::Sod;
use crate::simulation::Simulation;
use crate::turbulence::forcing::{Driving, Forcing};
use etalon_kernels_gen::bounded::Roundoff;
use etalon_kernels_gen::{Component, Field};

/// Half the spacing of the places that the coarsest engine keeps, in sides of the box.
const HALF_GRID_STEP: f64 = 0.5 / SINGLE_PLACES;
/// Gas at rest has this internal energy.
const ENERGY: f64 = 1.0;
/// How it is pulled.
const GRAVITY: [f64; 3] = [0.5, -0.25, 0.125];
const STEPS: usize = 4;
/// To where steps are asked for: farther than they get.
const FAR: f64 = 10.0;

/// A unit box of gas at rest on a lattice.
fn even<const D: usize>(physics: &Physics) -> Result<ParticleSet<D>, EngineError> {
    // Powers of two, whose places the grid of coordinates has exactly.
    let across: usize = [32, 16, 8][D - 1];
    let spacing = 1.0 / across as f64;
    let particle = |position| Particle {
        position,
        velocity: [0.0; D],
        mass: spacing.powi(D as i32),
        smoothing_length: smoothing_length_holding(
            physics.neighbours,
            spacing.powi(D as i32),
            D,
            physics.kernel.support(),
        ),
        internal_energy: ENERGY,
        mobile: true,
    };
    let domain = Domain::new([0.0; D], [1.0; D], [true; D]).map_err(EngineError::from_display)?;
    let block = Block { lower: [0.0; D], upper: [1.0; D] };
    let particles = block.lattice(across.pow(D as u32)).places.into_iter().map(particle).collect();
    ParticleSet::new(domain, particles).map_err(EngineError::from_display)
}

/// The accelerations that rounding makes in gas at rest: of as many terms as there are neighbours, whose sizes add up to less than twice
/// `c^2/h`, each is off by some ten roundings, and so is their sum by one a term.
fn noise<const D: usize, P: Roundoff>(set: &ParticleSet<D>, physics: &Physics) -> f64 {
    let h = set.particles().iter().map(|p| p.smoothing_length).fold(f64::INFINITY, f64::min);
    let squared = physics.gamma_minus_one * (1.0 + physics.gamma_minus_one) * ENERGY;
    (10.0 + physics.neighbours) * P::UNIT * 2.0 * squared / h
}

fn rms(values: impl Iterator<Item = f64>) -> f64 {
    let (mut sum, mut count) = (0.0, 0.0_f64);
    values.for_each(|value| {
        sum += value * value;
        count += 1.0;
    });
    (sum / count.max(1.0)).sqrt()
}

/// Gas in a constant gravity falls as `v = g t`, `x = x_0 + g t^2 / 2`, and walls in it do not.
///
/// # Errors
/// What the engine refuses.
pub fn check_free_fall<const D: usize, P: Roundoff, E: Engine<D>>(
    mut make: impl FnMut(&ParticleSet<D>, &[Field]) -> Result<E, EngineError>,
) -> Result<Vec<Distance>, EngineError> {
    let physics = Physics { gravity: GRAVITY, ..Sod::standard(D).physics() };
    let fields = Pipeline::of_scene::<D>(&physics).fields::<D>();
    let set = even::<D>(&physics)?;
    let mut run = Simulation::new(make(&set, &fields)?, physics)?;
    for _ in 0..STEPS {
        run.step(FAR)?;
    }
    let time = run.time();
    let mut all = Vec::new();
    let lost = noise::<D, P>(&set, &physics);
    for (axis, g) in GRAVITY.into_iter().enumerate().take(D) {
        let velocity = run.engine().read(Component { field: fields::VELOCITY, index: axis })?;
        let error = rms(velocity.into_iter().map(|v| v - g * time));
        // Three roundings of the velocity a step, and as many of the step in the engine's precision.
        let tolerance = lost * time + 6.0 * STEPS as f64 * P::UNIT * g.abs() * time;
        all.push(Distance { what: format!("{D}-D: velocity of fall along axis {axis}"), error, tolerance });
        let fallen = run.engine().coordinates(axis)?.into_iter().zip(set.coordinates(axis));
        let way = 0.5 * g * time * time;
        let error = rms(fallen.map(|(x, x_0)| separation(x, x_0, 1.0) - way));
        let tolerance = tolerance * time + STEPS as f64 * HALF_GRID_STEP;
        all.push(Distance { what: format!("{D}-D: way of fall along axis {axis}"), error, tolerance });
    }
    all.extend(walls_at_rest(make(&walled::<D>(&physics)?, &fields)?, physics)?);
    Ok(all)
}

fn walled<const D: usize>(physics: &Physics) -> Result<ParticleSet<D>, EngineError> {
    sets::set::<D>(Difficulty::FixedLayers, [60, 14, 9][D - 1], physics, 5).map_err(EngineError::from_display)
}

/// Walls keep velocity and place, to the bit.
fn walls_at_rest<const D: usize, E: Engine<D>>(engine: E, physics: Physics) -> Result<Vec<Distance>, EngineError> {
    let mut run = Simulation::new(engine, physics)?;
    let walls = walls(run.engine())?;
    let before = state(run.engine())?;
    for _ in 0..STEPS {
        run.step(FAR)?;
    }
    let after = state(run.engine())?;
    let changed = |part: usize| {
        let pairs = before[part].iter().zip(&after[part]);
        rms(pairs.flat_map(|(a, b)| walls.iter().map(|&i| f64::from(u8::from(a[i] != b[i])))))
    };
    let one =
        |what: &str, part| Distance { what: format!("{D}-D: {what} of a wall"), error: changed(part), tolerance: 0.0 };
    Ok(vec![one("velocity", 0), one("place", 1)])
}

/// The particles that are not mobile.
fn walls<const D: usize>(engine: &mut impl Engine<D>) -> Result<Vec<usize>, EngineError> {
    let mobility = engine.read_scalar(fields::MOBILITY)?;
    let walls: Vec<usize> = (0..mobility.len()).filter(|&i| mobility[i] == 0.0).collect();
    if walls.is_empty() { Err(EngineError("this set has no walls".to_string())) } else { Ok(walls) }
}

/// Velocities and places, as bits, by axis.
fn state<const D: usize>(engine: &mut impl Engine<D>) -> Result<[Vec<Vec<u64>>; 2], EngineError> {
    let velocity = engine.read_all(fields::VELOCITY)?;
    let bits = velocity.into_iter().map(|column| column.into_iter().map(f64::to_bits).collect()).collect();
    let places = (0..D).map(|axis| engine.coordinates(axis)).collect::<Result<_, _>>()?;
    Ok([bits, places])
}

/// Driven walls have their driver's velocity and are where it has brought them; if they are to stay, they stay.
///
/// # Errors
/// What the engine refuses.
pub fn check_driven_walls<const D: usize, P: Roundoff, E: Engine<D>>(
    mut make: impl FnMut(&ParticleSet<D>, &[Field]) -> Result<E, EngineError>,
) -> Result<Vec<Distance>, EngineError> {
    let mut all = Vec::new();
    for moves in [false, true] {
        // So short that it limits the step: four steps are an eighth of it.
        let driver = Driver { period: 0.01, moves };
        let physics = Physics { driver: Some(driver), ..Sod::standard(D).physics() };
        let set = walled::<D>(&physics)?;
        let engine = make(&set, &Pipeline::of_scene::<D>(&physics).fields::<D>())?;
        let mut run = Simulation::new(engine, physics)?;
        let walls = walls(run.engine())?;
        for _ in 0..STEPS {
            run.step(FAR)?;
        }
        let (share, way) = (driver.share(run.time()), if moves { driver.way(0.0, run.time()) } else { 0.0 });
        for axis in 0..D {
            let largest = |i: usize| set.particles()[i].velocity[axis];
            let velocity = run.engine().read(Component { field: fields::VELOCITY, index: axis })?;
            let error = rms(walls.iter().map(|&i| velocity[i] - share * largest(i)));
            // The velocity that it starts with, the share, and their product, each rounded; velocities are below one.
            let what = format!("{D}-D: velocity of a driven wall along axis {axis}, moves: {moves}");
            all.push(Distance { what, error, tolerance: 3.0 * P::UNIT * share.abs() });
            let (places, start) = (run.engine().coordinates(axis)?, set.coordinates(axis));
            let length = set.domain().torus_length()[axis];
            let gone = |i: usize| separation(places[i], start[i], length) - way * largest(i);
            let what = format!("{D}-D: place of a driven wall along axis {axis}, moves: {moves}");
            // The same for each step's way, and the grid.
            let of_grid = STEPS as f64 * HALF_GRID_STEP * length;
            let tolerance = if moves { of_grid + 4.0 * STEPS as f64 * P::UNIT * way.abs() } else { 0.0 };
            all.push(Distance { what, error: rms(walls.iter().map(|&i| gone(i))), tolerance });
        }
        if share.abs() < 0.1 {
            return Err(EngineError(format!("the walls hardly move at time {}", run.time())));
        }
    }
    Ok(all)
}

/// The force of the host is that at the particles' places, it is added to what the passes found, and it moves the gas without giving it momentum.
///
/// # Errors
/// What the engine refuses.
pub fn check_forcing<const D: usize, P: Roundoff, E: Engine<D>>(
    make: impl FnOnce(&ParticleSet<D>, &[Field]) -> Result<E, EngineError>,
) -> Result<Vec<Distance>, EngineError> {
    let physics = Physics { forced: true, ..Sod::standard(D).physics() };
    let set = even::<D>(&physics)?;
    let force = Forcing::new(set.domain(), Driving { velocity: 1.0, ..Driving::subsonic() }, 3);
    let engine = make(&set, &Pipeline::of_scene::<D>(&physics).fields::<D>())?;
    let mut run = Simulation::with_forcing(engine, physics, force.map_err(EngineError::from_display)?)?;
    let mut all = Vec::new();
    let forcing = run.engine().read_all(fields::FORCING)?.concat();
    let size = rms(forcing.iter().copied());
    let acceleration = run.engine().read_all(fields::ACCELERATION)?.concat();
    let lost = noise::<D, P>(&set, &physics);
    let error = rms(acceleration.iter().zip(&forcing).map(|(a, f)| a - f));
    let what = format!("{D}-D: acceleration of gas at rest that is pushed by {size:.2}");
    all.push(Distance { what, error, tolerance: lost + 2.0 * P::UNIT * size });

    for _ in 0..STEPS {
        run.step(FAR)?;
    }
    let masses: Vec<f64> = set.particles().iter().map(|p| p.mass).collect();
    let mut places: [Vec<u64>; D] = std::array::from_fn(|_| Vec::new());
    for (axis, places) in places.iter_mut().enumerate() {
        *places = run.engine().coordinates(axis)?;
    }
    let due = run.forcing().map(|force| force.at(&places, &masses)).transpose().map_err(EngineError::from_display)?;
    let due = due.map(|drive| drive.acceleration.concat()).unwrap_or_default();
    let forcing = run.engine().read_all(fields::FORCING)?.concat();
    let error = rms(forcing.iter().zip(&due).map(|(a, b)| a - b));
    all.push(Distance { what: format!("{D}-D: force after {STEPS} steps"), error, tolerance: P::UNIT * 4.0 * size });

    let velocity = run.engine().read_all(fields::VELOCITY)?;
    let speed = rms(velocity.iter().flatten().copied());
    let momentum = velocity.iter().map(|v| v.iter().zip(&masses).map(|(v, m)| v * m).sum::<f64>());
    let what = format!("{D}-D: momentum of gas stirred to {speed:.2e}");
    // Forces of pairs cancel but for rounding, so does the sum of the force; velocities are rounded in each step.
    let tolerance = lost * run.time() + 4.0 * STEPS as f64 * P::UNIT * speed;
    all.push(Distance { what, error: rms(momentum), tolerance });
    let due = 0.2 * size * run.time();
    // The gas must have been moved: by the force, over the time, less what pressure took.
    all.push(Distance {
        what: format!("{D}-D: {due:.2e} over the speed of stirred gas"),
        error: due / speed,
        tolerance: 1.0,
    });
    Ok(all)
}
