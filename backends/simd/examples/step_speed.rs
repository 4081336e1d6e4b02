//! Nanoseconds per particle of each stage of a step, on one thread or many.
use etalon_kernels_gen::lanes::{available_levels, level_name};
use etalon_reference::domain::Domain;
use etalon_reference::engine::{Engine, PlainEngine};
use etalon_reference::particles::{Particle, ParticleSet};
use etalon_reference::passes::Physics;
use etalon_reference::pipeline::Pipeline;
use etalon_reference::schemes::*;
use etalon_reference::simulation::Simulation;
use etalon_reference::fields;
use etalon_simd::{LaneEngine, Number, Options};

fn set(across: usize) -> ParticleSet<3> {
    let spacing = 1.0 / across as f64;
    let mut state = 1u64;
    let mut random = move || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 40) as f64 / (1u64 << 24) as f64 - 0.5
    };
    let h = spacing * (100.0 / (32.0 * std::f64::consts::PI / 3.0)).cbrt();
    let particles = (0..across.pow(3))
        .map(|i| {
            let cell = [i % across, i / across % across, i / across / across];
            Particle {
                position: std::array::from_fn(|k| ((cell[k] as f64 + 0.5 + 0.2 * random()) * spacing).rem_euclid(1.0)),
                velocity: [random(), random(), random()],
                mass: spacing.powi(3),
                smoothing_length: h * (1.0 + 0.05 * random()),
                internal_energy: 1.0 + 0.1 * random(),
                mobile: true,
            }
        })
        .collect();
    ParticleSet::new(Domain::new([0.0; 3], [1.0; 3], [true; 3]).unwrap(), particles).unwrap()
}

fn physics() -> Physics {
    Physics {
        kernel: Kernel::MixedSinc,
        grad_h: GradH::Corrected,
        viscosity: Viscosity::of(Dissipation::AvSlrB2),
        gamma_minus_one: 2.0 / 3.0,
        neighbours: 100.0,
    }
}

fn run<T: Number>(across: usize, steps: usize) {
    let set = set(across);
    let pipeline = Pipeline::of_scene::<3>(&physics());
    for level in available_levels().into_iter().take(1) {
        let engine = LaneEngine::<T, 3>::new(&set, &pipeline.fields::<3>(), Options { level });
        let mut simulation = Simulation::new(engine, physics()).unwrap();
        simulation.engine().clear_timings();
        for _ in 0..steps {
            simulation.step(1e9).unwrap();
        }
        let n = set.len() as f64 * steps as f64;
        println!("{} {} N={} pairs/particle {:.1}", T::NAME, level_name(level), set.len(), simulation.engine().pair_count() as f64 / set.len() as f64);
        let mut total = 0.0;
        for (name, time, _) in simulation.engine().timings().stages() {
            let ns = time.as_nanos() as f64 / n;
            total += ns;
            println!("  {name:24} {ns:8.1} ns/particle");
        }
        println!("  {:24} {total:8.1}", "total");
    }
}

fn compare<T: Number>(across: usize) {
    let set = set(across);
    let pipeline = Pipeline::of_scene::<3>(&physics());
    let mut plain = Simulation::new(PlainEngine::<f64, 3>::new(&set), physics()).unwrap();
    let mut lanes = Simulation::new(LaneEngine::<T, 3>::new(&set, &pipeline.fields::<3>(), Options::default()), physics()).unwrap();
    for field in [fields::DENSITY, fields::GRAD_H, fields::BALSARA, fields::PRESSURE_COEFFICIENT, fields::GRADIENT_MATRIX, fields::STRAIN_RATE, fields::ACCELERATION, fields::ENERGY_RATE, fields::TIME_STEP] {
        let a = plain.engine().read_all(field).unwrap();
        let b = lanes.engine().read_all(field).unwrap();
        let mut diff = 0.0_f64; let mut scale = 0.0_f64;
        for (x, y) in a.iter().flatten().zip(b.iter().flatten()) { diff = diff.max((x - y).abs()); scale = scale.max(x.abs()); }
        println!("{} {:24} max diff {:.2e} of max {:.2e}", T::NAME, field.name, diff / scale, scale);
    }
}

fn main() {
    let across: usize = std::env::args().nth(1).and_then(|a| a.parse().ok()).unwrap_or(48);
    rayon::ThreadPoolBuilder::new().num_threads(1).build_global().unwrap();
    compare::<f64>(12);
    compare::<f32>(12);
    run::<f64>(across, 5);
    run::<f32>(across, 5);
}
