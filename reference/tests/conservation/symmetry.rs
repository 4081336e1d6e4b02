//! Place, orientation and order of the particles do not matter.

use crate::check::{UNIT, assert_close, gamma};
use crate::cloud::Recipe;
use crate::pairs::Pairs;
use crate::{all_mixtures, all_physics, cloud_for, physics, run, with_species_of};
use etalon_kernels_gen::{Component, Rank, components};
use etalon_reference::engine::{Engine, PlainEngine};
use etalon_reference::fields;
use etalon_reference::particles::{Particle, ParticleSet};
use etalon_reference::passes::{Density, Physics, ReconstructedMomentum, VolumeElements};
use etalon_reference::pipeline::Pipeline;
use etalon_reference::schemes::{Dissipation, GradH};
use etalon_reference::simulation::Simulation;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

fn changed<const D: usize>(set: &ParticleSet<D>, change: impl Fn(&Particle<D>) -> Particle<D>) -> ParticleSet<D> {
    let particles = set.particles().iter().map(change).collect();
    with_species_of(set, ParticleSet::new(*set.domain(), particles).unwrap())
}

/// Every component that a round of passes leaves behind.
fn everything<const D: usize>(set: &ParticleSet<D>, physics: Physics) -> Vec<(Component, Vec<f64>)> {
    let mut engine = run(set, physics);
    components(&Pipeline::of_scene::<D>(&physics).fields::<D>(), D)
        .into_iter()
        .filter_map(|component| Some((component, engine.read(component).ok()?)))
        .collect()
}

/// Coordinates are whole numbers modulo the box, so a shift by a whole number changes no separation at all.
#[test]
fn translation_changes_not_a_bit() {
    fn check<const D: usize>(physics: Physics) {
        let set = cloud_for::<D>(&physics, 41);
        // Multiples of 2^-32, the grid of positions.
        let shift = [0.343_75, 0.811_035_156_25, 1.0 - 1.0 / 4_294_967_296.0];
        let moved = changed(&set, |p| Particle {
            position: std::array::from_fn(|axis| (p.position[axis] + shift[axis]).rem_euclid(1.0)),
            ..*p
        });
        assert_ne!(set.coordinates(0), moved.coordinates(0));
        assert!(everything(&set, physics) == everything(&moved, physics), "{D}-D, {physics:?}");
    }
    for physics in all_physics().chain(all_mixtures()) {
        check::<1>(physics);
        check::<2>(physics);
        check::<3>(physics);
    }
}

/// Nor does it through time.
#[test]
fn translation_changes_no_step() {
    let physics = Physics { neighbours: 20.0, ..physics(Dissipation::AvSlrB2, GradH::Corrected) };
    let set = Recipe { h_spread: 1.0, neighbours: 20.0, jitter: 0.4, ..Recipe::unequal::<2>(43) }.particles::<2>(true);
    let moved = changed(&set, |p| Particle { position: p.position.map(|x| (x + 0.625) % 1.0), ..*p });
    let run = |set: &ParticleSet<2>| {
        let mut simulation = Simulation::new(PlainEngine::<f64, 2>::new(set), physics).unwrap();
        for _ in 0..3 {
            simulation.step(1.0).unwrap();
        }
        let coordinates: [Vec<u64>; 2] = std::array::from_fn(|axis| simulation.engine().coordinates(axis).unwrap());
        (coordinates, simulation.engine().read_all(fields::VELOCITY).unwrap())
    };
    let (here, there) = (run(&set), run(&moved));
    assert_eq!(here.1, there.1);
    for axis in 0..2 {
        let shift = set.domain().encode(axis, 0.625);
        assert!(here.0[axis].iter().zip(&there.0[axis]).all(|(a, b)| a.wrapping_add(shift) == *b), "axis {axis}");
    }
}

/// A mirror changes the sign of what has one index along its axis, and not a bit beyond.
#[test]
fn a_mirror_changes_signs_only() {
    fn check<const D: usize>(physics: Physics, mirror: usize) {
        let set = cloud_for::<D>(&physics, 47);
        let flip =
            |v: [f64; D], f: &dyn Fn(f64) -> f64| std::array::from_fn(|i| if i == mirror { f(v[i]) } else { v[i] });
        let mirrored = changed(&set, |p| Particle {
            position: flip(p.position, &|x| (1.0 - x) % 1.0),
            velocity: flip(p.velocity, &|v| -v),
            ..*p
        });
        let odd = |component: Component| match component.field.rank {
            Rank::Scalar => false,
            Rank::Vector => component.index == mirror,
            Rank::Matrix => (component.index / D == mirror) != (component.index % D == mirror),
            Rank::Symmetric => {
                let mut pairs = (0..D).flat_map(|i| (i..D).map(move |j| (i, j)));
                let (i, j) = pairs.nth(component.index).unwrap();
                (i == mirror) != (j == mirror)
            }
        };
        for ((component, before), (_, after)) in
            everything(&set, physics).into_iter().zip(everything(&mirrored, physics))
        {
            let sign = if odd(component) { -1.0 } else { 1.0 };
            let due: Vec<f64> = before.iter().map(|v| sign * v).collect();
            assert_eq!(after, due, "{} in {D}-D, mirror {mirror}, {physics:?}", component.name(D));
        }
    }
    for physics in all_physics().chain(all_mixtures()) {
        check::<1>(physics, 0);
        for mirror in 0..2 {
            check::<2>(physics, mirror);
        }
        for mirror in 0..3 {
            check::<3>(physics, mirror);
        }
    }
}

/// In another order the same terms are added in another order.
#[test]
fn order_of_particles_matters_to_rounding_only() {
    fn check<const D: usize>() {
        let physics = physics(Dissipation::AvSlrB2F, GradH::Corrected);
        let set = Recipe::unequal::<D>(53).particles::<D>(true);
        let mut random = Pcg64Mcg::seed_from_u64(1);
        let mut order: Vec<usize> = (0..set.len()).collect();
        for last in (1..order.len()).rev() {
            order.swap(last, (random.random::<f64>() * (last + 1) as f64) as usize);
        }
        let shuffled = ParticleSet::new(*set.domain(), order.iter().map(|&i| set.particles()[i]).collect()).unwrap();
        let mut pairs = Pairs::<ReconstructedMomentum, D>::of(&set, physics);

        // The first two sweeps: sums of positive terms, each off by gamma_n on either side; then quotients.
        let mut engine = PlainEngine::<f64, D>::new(&shuffled);
        engine.find_neighbours(2.0).unwrap();
        engine.run_pass(&VolumeElements(physics)).unwrap();
        engine.run_pass(&Density(physics)).unwrap();
        let most = (0..set.len()).map(|a| pairs.engine.neighbours().of(a).len()).max().unwrap();
        let relative = 2.0 * (2.0 * gamma(most, UNIT) + gamma(10, UNIT));
        for field in [
            fields::STANDARD_DENSITY,
            fields::VOLUME_ESTIMATOR,
            fields::KERNEL_NORMALISATION,
            fields::VOLUME,
            fields::DENSITY,
        ] {
            let (due, got) = (pairs.engine.read_scalar(field).unwrap(), engine.read_scalar(field).unwrap());
            for (place, &i) in order.iter().enumerate() {
                assert_close(
                    &format!("{} of particle {i} in {D}-D", field.name),
                    got[place],
                    due[i],
                    relative * due[i],
                );
            }
        }

        // The last sweep, given the very same fields.
        for component in components(&Pipeline::of_scene::<D>(&physics).fields::<D>(), D) {
            if let Ok(values) = pairs.engine.read(component) {
                engine.write(component, &order.iter().map(|&i| values[i]).collect::<Vec<_>>()).unwrap();
            }
        }
        engine.run_pass(&ReconstructedMomentum(physics)).unwrap();
        let (due, got) =
            (pairs.engine.read_all(fields::ACCELERATION).unwrap(), engine.read_all(fields::ACCELERATION).unwrap());
        let mut differing = 0;
        for (place, &i) in order.iter().enumerate() {
            let size: f64 = pairs.engine.neighbours().of(i).iter().map(|&b| pairs.size(i, b as usize)).sum();
            for axis in 0..D {
                let what = format!("acceleration {axis} of particle {i} in {D}-D");
                assert_close(&what, got[axis][place], due[axis][i], 2.0 * gamma(most, UNIT) * size);
                differing += usize::from(got[axis][place] != due[axis][i]);
            }
        }
        assert!(differing > 0, "the order was changed");
    }
    check::<1>();
    check::<2>();
    check::<3>();
}
