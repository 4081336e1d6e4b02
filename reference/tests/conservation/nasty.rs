//! Particles where no flow would put them: every number that comes out is finite, in double and in single precision.

use crate::{all_physics, physics};
use etalon_kernels_gen::components;
use etalon_reference::domain::Domain;
use etalon_reference::engine::{Engine, PlainEngine};
use etalon_reference::fields;
use etalon_reference::particles::{Particle, ParticleSet};
use etalon_reference::passes::{Decay, KickDrift, Physics};
use etalon_reference::pipeline::Pipeline;
use etalon_reference::schemes::{Dissipation, GradH, Kernel, Viscosity};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// A particle of the unit box, at rest.
fn at<const D: usize>(position: [f64; D]) -> Particle<D> {
    Particle { position, velocity: [0.0; D], mass: 1e-3, smoothing_length: 0.1, internal_energy: 1.0, mobile: true }
}

fn along<const D: usize>(direction: [f64; D], s: f64) -> Particle<D> {
    Particle { velocity: direction.map(|d| -d * s), ..at(direction.map(|d| 0.5 + d * s)) }
}

/// The sets, each with its name.
fn nasty_sets<const D: usize>(support: f64) -> Vec<(&'static str, Vec<Particle<D>>)> {
    let mut random = Pcg64Mcg::seed_from_u64(99);
    let mut next = || random.random::<f64>();
    let mut cloud = |count: usize| -> Vec<Particle<D>> {
        (0..count)
            .map(|_| Particle {
                velocity: std::array::from_fn(|_| next() - 0.5),
                ..at(std::array::from_fn(|_| 0.3 + 0.4 * next()))
            })
            .collect()
    };
    let x: [f64; D] = std::array::from_fn(|axis| if axis == 0 { 1.0 } else { 0.0 });
    let diagonal = [1.0; D];
    let steps = [-0.11, -0.07, -0.03, 0.0, 0.02, 0.06, 0.1];

    let mut coincident = cloud(20);
    coincident.extend((0..5).map(|i| Particle { velocity: [f64::from(i); D], ..at([0.5; D]) }));
    let mut contrast = cloud(30);
    for (i, p) in contrast.iter_mut().enumerate() {
        p.mass *= if i % 2 == 0 { 1.0 } else { 1e-9 };
    }
    let mut lengths = cloud(30);
    for (i, p) in lengths.iter_mut().enumerate() {
        p.smoothing_length = [0.16, 1e-2, 1e-6][i % 3];
    }
    let mut cold = cloud(30);
    for (i, p) in cold.iter_mut().enumerate() {
        p.internal_energy = 0.0;
        if i % 2 == 0 {
            p.velocity = [0.0; D];
        }
    }
    let mut hot = cloud(30);
    for (i, p) in hot.iter_mut().enumerate() {
        p.internal_energy = if i % 2 == 0 { 1e6 } else { 1e-12 };
        p.velocity = p.velocity.map(|v| v * 1e3);
    }
    let plane = |i: usize| {
        std::array::from_fn(|axis| if axis + 1 == D { 0.5 } else { 0.3 + 0.07 * ((i >> (2 * axis)) % 4) as f64 })
    };
    let mut sets = vec![
        ("coincident", coincident),
        ("all in one place", vec![at([0.5; D]); 4]),
        ("on an axis", steps.iter().map(|&s| along(x, s)).collect()),
        ("on the diagonal", steps.iter().map(|&s| along(diagonal, s)).collect()),
        ("in a plane", (0..16).map(|i| at(plane(i))).collect()),
        ("alone", vec![at([0.5; D])]),
        ("isolated", vec![at([0.1; D]), at([0.6; D])]),
        ("a pair", vec![along(x, -0.05), along(x, 0.05)]),
        (
            "seen by one only",
            vec![
                Particle { smoothing_length: 0.16, ..along(x, -0.05) },
                Particle { smoothing_length: 1e-3, ..along(x, 0.05) },
            ],
        ),
        ("near vacuum", contrast),
        ("huge and tiny smoothing lengths", lengths),
        ("cold", cold),
        ("hot and fast", hot),
    ];
    // A sole neighbour closer and closer to the edge of the support, where its weight is 1e-6, ..., 1e-60 and rounding.
    for inside in [1e-2, 1e-3, 1e-4, 1e-5, 3e-6, 1e-6, 3e-7, 1e-7, 1e-8, 1e-9] {
        sets.push(("at the edge", vec![at([0.5; D]), along(x, support * 0.1 * (1.0 - inside))]));
    }
    sets
}

/// One round of passes and the time integration's update leave only finite numbers, and a positive time step.
fn all_is_finite<E: Engine<D>, const D: usize>(make: impl Fn(&ParticleSet<D>) -> E, physics: Physics, precision: &str) {
    for (name, particles) in nasty_sets::<D>(physics.kernel.support()) {
        // Once far from the origin: in fixed point that is nowhere special.
        for offset in [0.0, 1e6] {
            for periodic in [true, false] {
                let domain = Domain::new([offset; D], [offset + 1.0; D], [periodic; D]).unwrap();
                let moved =
                    particles.iter().map(|p| Particle { position: p.position.map(|x| x + offset), ..*p }).collect();
                let mut engine = make(&ParticleSet::new(domain, moved).unwrap());
                engine.find_neighbours(physics.kernel.support()).unwrap();
                let pipeline = Pipeline::of_scene::<D>(&physics);
                pipeline.start(&mut engine, physics).unwrap();
                pipeline.run(&mut engine, physics).unwrap();
                assert!(engine.minimum(fields::TIME_STEP).unwrap() > 0.0, "{name}: no time step");
                engine.run_update(&KickDrift(physics), 1e-6).unwrap();
                if pipeline.switches() {
                    engine.run_update(&Decay(physics), 1e-6).unwrap();
                }
                let mut checked = 0;
                for component in components(&pipeline.fields::<D>(), D) {
                    let Ok(values) = engine.read(component) else { continue };
                    checked += 1;
                    let bad = values.iter().position(|v| !v.is_finite());
                    assert!(
                        bad.is_none(),
                        "{name}, {precision}, {D}-D: {} is {values:?}, {physics:?}",
                        component.name(D)
                    );
                }
                assert!(checked > 18, "{checked} components");
            }
        }
    }
}

fn both_precisions(physics: Physics) {
    all_is_finite(PlainEngine::<f64, 1>::new, physics, "f64");
    all_is_finite(PlainEngine::<f64, 2>::new, physics, "f64");
    all_is_finite(PlainEngine::<f64, 3>::new, physics, "f64");
    all_is_finite(PlainEngine::<f32, 1>::new, physics, "f32");
    all_is_finite(PlainEngine::<f32, 2>::new, physics, "f32");
    all_is_finite(PlainEngine::<f32, 3>::new, physics, "f32");
}

#[test]
fn no_set_of_particles_makes_a_nan() {
    all_physics().for_each(both_precisions);
    for dissipation in [Dissipation::Av, Dissipation::AvSwSlr] {
        for grad_h in [GradH::Exact, GradH::Corrected] {
            let viscosity = Viscosity { conduction: Viscosity::CONDUCTION, ..Viscosity::of(dissipation) };
            both_precisions(Physics { viscosity, ..physics(dissipation, grad_h) });
        }
    }
}

#[test]
fn no_kernel_makes_a_nan() {
    for &kernel in Kernel::ALL {
        for grad_h in [GradH::Exact, GradH::Corrected] {
            both_precisions(Physics { kernel, ..physics(Dissipation::AvSlrB2, grad_h) });
        }
    }
}

/// Through a time step the cold and the coincident stay finite too.
#[test]
fn overcooled_gas_is_cold_gas() {
    // A receding pair with no energy left: energies may turn negative, sound speeds may not turn into NaN.
    let set = |u: f64| {
        vec![
            Particle { internal_energy: u, ..along([1.0, 0.0], -0.05) },
            Particle { internal_energy: u, ..along([1.0, 0.0], 0.05) },
        ]
    };
    let domain = Domain::new([0.0; 2], [1.0; 2], [true; 2]).unwrap();
    let physics = physics(Dissipation::AvSlrB2, GradH::Corrected);
    let mut engine = PlainEngine::<f64, 2>::new(&ParticleSet::new(domain, set(1e-9)).unwrap());
    engine.write(etalon_kernels_gen::Component { field: fields::INTERNAL_ENERGY, index: 0 }, &[-1.0, 1e-9]).unwrap();
    engine.find_neighbours(2.0).unwrap();
    Pipeline::of_scene::<2>(&physics).run(&mut engine, physics).unwrap();
    assert_eq!(engine.read_scalar(fields::SOUND_SPEED).unwrap()[0], 0.0);
    for field in [fields::ACCELERATION, fields::ENERGY_RATE, fields::TIME_STEP] {
        assert!(engine.read_all(field).unwrap().concat().iter().all(|v| v.is_finite()), "{}", field.name);
    }
}
