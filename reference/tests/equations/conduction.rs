//! Artificial conduction in the form of Price et al. 2018.

use crate::check::{UNIT, assert_close, gamma};
use crate::cloud::Recipe;
use etalon_kernels_gen::{Symmetric, Vector};
use etalon_reference::domain::separation;
use etalon_reference::engine::{Engine, PlainEngine};
use etalon_reference::equations::conduction::*;
use etalon_reference::equations::kernels::kernel_shape;
use etalon_reference::fields;
use etalon_reference::particles::{Particle, ParticleSet};
use etalon_reference::passes::Physics;
use etalon_reference::pipeline::Pipeline;
use etalon_reference::scenes::sod::Sod;
use etalon_reference::schemes::{Dissipation, Kernel, Viscosity};

#[test]
fn whole_numbers() {
    // sqrt(|2 - 34| / 2)
    assert_eq!((conduction_velocity(2.0, 34.0, 2.0), conduction_velocity(34.0, 2.0, 2.0)), (4.0, 4.0));
    assert_eq!(conduction_velocity(3.0, 3.0, 2.0), 0.0, "pressure balance");
    assert_eq!(conduction_velocity(0.0, 0.0, 0.0), 0.0);
    assert_eq!(conduction_weight(0.5, 4.0), 0.5);
    assert_eq!(conduction_weight(0.0, 4.0), 0.0, "a particle alone, in the exact form");
    // 1/2 * 3 * 5 * 7 * 2 * (2 * (-3) + 4 * 1) / 2
    let rate = conduction_rate(3.0, 5.0, 7.0, 2.0, Vector([2.0, 4.0]), 0.5, Vector([-3.0, 1.0]));
    assert_eq!(rate, -105.0, "the hotter one loses");
    assert_eq!(conduction_rate(3.0, 5.0, 7.0, 2.0, Vector([0.0, 0.0]), 0.0, Vector([-3.0, 1.0])), 0.0);
}

fn physics<const D: usize>(conduction: f64) -> Physics {
    let physics = Sod::standard(D).physics();
    Physics { viscosity: Viscosity { conduction, ..physics.viscosity }, ..physics }
}

fn run<const D: usize>(set: &ParticleSet<D>, physics: Physics) -> PlainEngine<f64, D> {
    let mut engine = PlainEngine::<f64, D>::new(set);
    engine.find_neighbours(2.0).unwrap();
    Pipeline::of_scene::<D>(&physics).run(&mut engine, physics).unwrap();
    engine
}

/// What the sweep adds, against a double loop over the published formula; and the total of it, which must be zero.
fn sweep_is_as_published<const D: usize>() {
    let cloud = Recipe::unequal::<D>(91).particles::<D>(true);
    let walled = |(i, p): (usize, &Particle<D>)| Particle { mobile: i % 7 != 0, ..*p };
    for walls in [false, true] {
        let particles = match walls {
            true => cloud.particles().iter().enumerate().map(walled).collect(),
            false => cloud.particles().to_vec(),
        };
        let set = ParticleSet::new(*cloud.domain(), particles).unwrap();
        // So large that it decides the step of some.
        let alpha_u = 128.0;
        let (mut without, mut with) = (run(&set, physics::<D>(0.0)), run(&set, physics::<D>(alpha_u)));
        let mut read = |field| with.read_all(field).unwrap();
        let [pressure, density, omega, rate, step] =
            [fields::PRESSURE, fields::DENSITY, fields::GRAD_H, fields::ENERGY_RATE, fields::TIME_STEP]
                .map(|field| read(field).concat());
        let c = read(fields::GRADIENT_MATRIX);
        let plain = without.read_scalar(fields::ENERGY_RATE).unwrap();
        let plain_step = without.read_scalar(fields::TIME_STEP).unwrap();
        let coordinates: [Vec<u64>; D] = std::array::from_fn(|axis| set.coordinates(axis));
        let (mut total, mut total_size, mut shortened) = (0.0, 0.0, 0);
        for (a, p) in set.particles().iter().enumerate() {
            let (mut due, mut size) = (0.0, 0.0);
            let neighbours = with.neighbours().of(a);
            for &b in neighbours {
                let b = b as usize;
                let x: [f64; D] =
                    std::array::from_fn(|axis| separation(coordinates[axis][a], coordinates[axis][b], 1.0));
                let r = x.iter().map(|x| x * x).sum::<f64>().sqrt();
                // r_ab . A_ab / r, with A_ab along -c x_ab.
                let slope = |i: usize| {
                    let h = set.particles()[i].smoothing_length;
                    let w = kernel_shape::<f64, D>(Kernel::MixedSinc, (r / h).powi(2)).value / h.powi(D as i32);
                    let form: f64 = (0..D)
                        .flat_map(|j| (0..D).map(move |k| (j, k)))
                        .map(|(j, k)| x[j] * c[Symmetric::<f64, D>::position(j, k)][i] * x[k])
                        .sum();
                    -form * w / r / (omega[i] * density[i])
                };
                let q = &set.particles()[b];
                let v = ((pressure[a] - pressure[b]).abs() / (0.5 * (density[a] + density[b]))).sqrt();
                let part = q.mass * alpha_u * v * (p.internal_energy - q.internal_energy) * 0.5 * (slope(a) + slope(b));
                due += part;
                size += part.abs();
            }
            let due = if p.mobile { plain[a] + due } else { 0.0 };
            // Kernels 250 as elsewhere, products 60 of indefinite forms in nine terms that may be larger than their sum; the pressures'
            // difference is formed from the same two numbers on both sides.
            let bound = gamma(neighbours.len() + 400, UNIT) * 4.0 * size + 4.0 * UNIT * plain[a].abs();
            assert_close(&format!("heating of particle {a} in {D}-D"), rate[a], due, bound);
            total += p.mass * (rate[a] - plain[a]);
            total_size += p.mass * (size + plain[a].abs());
            // The step follows the new rate.
            let cooling = if rate[a] < 0.0 { 0.5 * p.internal_energy / -rate[a] } else { f64::INFINITY };
            let due = plain_step[a].min(cooling);
            assert_close(&format!("step of particle {a}"), step[a], due, 4.0 * UNIT * due);
            shortened += usize::from(step[a] < plain_step[a]);
        }
        assert!(shortened > 0, "conduction shortens some steps");
        if !walls {
            let tolerance = gamma(set.len() + 460, UNIT) * total_size;
            assert!(total.abs() <= tolerance, "{D}-D: sum m du/dt = {total:e}, tolerance {tolerance:e}");
        }
    }
}

#[test]
fn conduction_is_as_published_and_keeps_energy() {
    sweep_is_as_published::<1>();
    sweep_is_as_published::<2>();
    sweep_is_as_published::<3>();
}

#[test]
fn without_a_coefficient_there_is_no_sweep() {
    use etalon_reference::pipeline::PassKind;
    for conduction in [0.0, -1.0] {
        let pipeline = Pipeline::of_scene::<3>(&physics::<3>(conduction));
        assert!(!pipeline.passes().contains(&PassKind::Conduction));
    }
    assert_eq!(Viscosity::CONDUCTION, 0.1);
    for &dissipation in Dissipation::ALL {
        assert_eq!(Viscosity::of(dissipation).conduction, 0.0, "{dissipation}: off unless asked for");
    }
}
