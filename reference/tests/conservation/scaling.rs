//! Units do not matter: lengths, velocities and masses times powers of two give results that are scaled to the last
//! bit, as each field's own unit says.

use crate::cloud::Recipe;
use crate::{all_physics, cloud_for, mixtures, physics, run_on, with_species_of};
use etalon_kernels_gen::{Component, components};
use etalon_reference::domain::Domain;
use etalon_reference::engine::{Engine, PlainEngine};
use etalon_reference::particles::{Particle, ParticleSet};
use etalon_reference::passes::Physics;
use etalon_reference::pipeline::Pipeline;
use etalon_reference::schemes::{Dissipation, GradH, Viscosity};
use etalon_reference::simulation::Simulation;

/// Exponents of two for lengths, velocities and masses.
#[derive(Clone, Copy, Debug)]
struct Units {
    length: i32,
    velocity: i32,
    mass: i32,
}

impl Units {
    /// The exponent for a unit such as `M L^(2-nu) T^-2`.
    fn of(&self, unit: &str, dimension: i32) -> i32 {
        let factor = |word: &str| {
            let (base, exponent) = word.split_once('^').unwrap_or((word, "1"));
            let base = match base {
                "M" => self.mass,
                "L" => self.length,
                "T" => self.length - self.velocity,
                _ => panic!("no unit is called {base}"),
            };
            base * exponent_of(exponent.trim_matches(['(', ')']), dimension)
        };
        unit.split_whitespace().map(factor).sum()
    }
}

/// The value of a sum such as `2-nu`.
fn exponent_of(sum: &str, dimension: i32) -> i32 {
    let term = |text: &str| match text {
        "" => 0,
        "nu" => dimension,
        number => number.parse().unwrap(),
    };
    // Every minus begins a new negative term.
    sum.split('+')
        .map(|part| {
            let mut pieces = part.split('-');
            term(pieces.next().unwrap_or("")) - pieces.map(term).sum::<i32>()
        })
        .sum()
}

#[test]
fn units_are_read_right() {
    let units = Units { length: 1, velocity: 10, mass: 100 };
    // T is L over a velocity: 1 - 10 = -9.
    for (unit, due) in
        [("", 0), ("M L^-nu", 97), ("M L^(2-nu) T^-2", 117), ("M^-1 L^(2+nu) T^-2", -77), ("M L^(-nu-1)", 96)]
    {
        assert_eq!(units.of(unit, 3), due, "{unit}");
    }
}

fn scaled<const D: usize>(set: &ParticleSet<D>, units: Units) -> ParticleSet<D> {
    let (length, velocity, mass) = (2_f64.powi(units.length), 2_f64.powi(units.velocity), 2_f64.powi(units.mass));
    let domain = set.domain();
    let corner = |corner: [f64; D]| corner.map(|x| x * length);
    let domain = Domain::new(corner(domain.lower()), corner(domain.upper()), domain.periodic()).unwrap();
    let particles = set.particles().iter().map(|p| Particle {
        position: p.position.map(|x| x * length),
        velocity: p.velocity.map(|v| v * velocity),
        mass: p.mass * mass,
        smoothing_length: p.smoothing_length * length,
        internal_energy: p.internal_energy * velocity * velocity,
        mobile: p.mobile,
    });
    with_species_of(set, ParticleSet::new(domain, particles.collect()).unwrap())
}

/// Every field of one round of passes.
///
/// Sums, products, quotients and square roots of even powers scale exactly; polynomials, roots and thresholds only
/// ever meet numbers without a unit.
fn all_fields_scale<E: Engine<D>, const D: usize>(make: impl Fn(&ParticleSet<D>) -> E, physics: Physics, units: Units) {
    let set = cloud_for::<D>(&physics, 31);
    let run = |set: &ParticleSet<D>, physics: Physics| {
        let mut engine = make(set);
        run_on(&mut engine, physics);
        engine
    };
    // The numbers of a scheme that have a unit.
    let mut in_units = physics;
    in_units.viscosity.wave_period *= 2_f64.powi(units.of("T", D as i32));
    if let Some(drag) = &mut in_units.drag {
        drag.coefficient *= 2_f64.powi(units.of("M L^-nu T^-1", D as i32));
    }
    let (mut before, mut after) = (run(&set, physics), run(&scaled(&set, units), in_units));
    let mut compared = 0;
    for component in components(&Pipeline::of_scene::<D>(&physics).fields::<D>(), D) {
        let (Ok(before), Ok(after)) = (before.read(component), after.read(component)) else { continue };
        compared += 1;
        let factor = 2_f64.powi(units.of(component.field.unit, D as i32));
        for (particle, (before, after)) in before.into_iter().zip(after).enumerate() {
            let Component { field, index } = component;
            assert_eq!(
                before * factor,
                after,
                "{} {index} of particle {particle} in {D}-D for {units:?}, {physics:?}",
                field.name
            );
        }
    }
    assert!(compared > 15 + D, "only {compared} components");
}

const ALL_UNITS: [Units; 4] = [
    Units { length: 5, velocity: 0, mass: 0 },
    Units { length: 0, velocity: -7, mass: 0 },
    Units { length: 0, velocity: 0, mass: 9 },
    Units { length: -3, velocity: 4, mass: -6 },
];

#[test]
fn passes_scale_exactly() {
    for physics in all_physics() {
        for units in ALL_UNITS {
            all_fields_scale(PlainEngine::<f64, 1>::new, physics, units);
            all_fields_scale(PlainEngine::<f64, 2>::new, physics, units);
        }
        all_fields_scale(PlainEngine::<f64, 3>::new, physics, ALL_UNITS[3]);
    }
    for units in ALL_UNITS {
        let physics = physics(Dissipation::AvSlrB2F, GradH::Corrected);
        all_fields_scale(PlainEngine::<f64, 3>::new, physics, units);
        all_fields_scale(PlainEngine::<f32, 1>::new, physics, units);
        all_fields_scale(PlainEngine::<f32, 2>::new, physics, units);
        all_fields_scale(PlainEngine::<f32, 3>::new, physics, units);
    }
    // Lengths of 2^16 either way in single precision, where h^-4 alone is 2^64; densities stay of order one.
    for length in [-16, 16] {
        let physics = physics(Dissipation::AvSlrB2, GradH::Corrected);
        all_fields_scale(PlainEngine::<f32, 1>::new, physics, Units { length, velocity: 0, mass: length });
        all_fields_scale(PlainEngine::<f32, 2>::new, physics, Units { length, velocity: 0, mass: 2 * length });
        all_fields_scale(PlainEngine::<f32, 3>::new, physics, Units { length, velocity: 0, mass: 3 * length });
    }
    let conducting = Viscosity { conduction: 0.1, ..Viscosity::of(Dissipation::AvSw) };
    for units in ALL_UNITS {
        let physics = Physics { viscosity: conducting, ..physics(Dissipation::AvSw, GradH::Corrected) };
        all_fields_scale(PlainEngine::<f64, 2>::new, physics, units);
        all_fields_scale(PlainEngine::<f32, 3>::new, physics, units);
    }
    for drag in mixtures() {
        let physics = Physics { drag, ..physics(Dissipation::AvSlrB2, GradH::Corrected) };
        for units in ALL_UNITS {
            all_fields_scale(PlainEngine::<f64, 1>::new, physics, units);
            all_fields_scale(PlainEngine::<f64, 2>::new, physics, units);
        }
        all_fields_scale(PlainEngine::<f32, 3>::new, physics, ALL_UNITS[3]);
        for length in [-16, 16] {
            all_fields_scale(PlainEngine::<f32, 3>::new, physics, Units { length, velocity: 0, mass: 3 * length });
        }
    }
    // As far as double precision goes in astronomers' units.
    let far = Units { length: 60, velocity: 20, mass: 110 };
    all_fields_scale(PlainEngine::<f64, 3>::new, physics(Dissipation::AvSlrB2, GradH::Corrected), far);
}

/// Through time: steps, drift and the smoothing length's update scale as well.
#[test]
fn time_integration_scales_exactly() {
    steps_scale(Dissipation::AvSlrB2);
    steps_scale(Dissipation::AvSwSlr);
}

fn steps_scale(dissipation: Dissipation) {
    let physics = Physics { neighbours: 20.0, ..physics(dissipation, GradH::Corrected) };
    let set = Recipe { h_spread: 1.0, neighbours: 20.0, jitter: 0.4, ..Recipe::unequal::<2>(37) }.particles::<2>(true);
    let units = ALL_UNITS[3];
    let run = |set: &ParticleSet<2>, until: f64| {
        let mut simulation = Simulation::new(PlainEngine::<f64, 2>::new(set), physics).unwrap();
        for _ in 0..3 {
            simulation.step(until).unwrap();
        }
        let coordinates: [Vec<u64>; 2] = std::array::from_fn(|axis| simulation.engine().coordinates(axis).unwrap());
        let velocity = simulation.engine().read_all(etalon_reference::fields::VELOCITY).unwrap();
        (simulation.time(), coordinates, velocity)
    };
    let until = 1.0;
    let time = 2_f64.powi(units.length - units.velocity);
    let (before, after) = (run(&set, until), run(&scaled(&set, units), until * time));
    assert_eq!(before.0 * time, after.0);
    assert_eq!(before.1, after.1);
    assert_eq!(before.2.concat().iter().map(|v| v * 2_f64.powi(units.velocity)).collect::<Vec<_>>(), after.2.concat());
    assert_ne!(before.1[0], set.coordinates(0), "the particles have moved");
}
