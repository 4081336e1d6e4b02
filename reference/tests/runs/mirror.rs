//! Walls that reflect: images stay images, and what is between the walls stays there.

use etalon_reference::domain::{Domain, separation};
use etalon_reference::engine::{Engine, PlainEngine};
use etalon_reference::fields;
use etalon_reference::norms::l1_error;
use etalon_reference::particles::{Particle, ParticleSet};
use etalon_reference::scenes::double_blast::{DoubleBlast, END_TIME, MEASURED, reference};
use etalon_reference::scenes::mirror::{MirrorError, mirrored};
use etalon_reference::scenes::sod::Sod;
use etalon_reference::scenes::{Definition, Scene, SceneError};
use etalon_reference::simulation::Simulation;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// Gas that is stirred at random, between walls along the first axis.
fn stirred<const D: usize>(across: usize) -> ParticleSet<D> {
    let mut random = Pcg64Mcg::seed_from_u64(1);
    let mut uniform = |low: f64, high: f64| low + (high - low) * random.random::<f64>();
    let spacing = 1.0 / across as f64;
    let particle = |i: usize| Particle {
        position: std::array::from_fn(|axis| {
            ((i / across.pow(axis as u32) % across) as f64 + 0.5 + uniform(-0.3, 0.3)) * spacing
        }),
        velocity: std::array::from_fn(|_| uniform(-0.5, 0.5)),
        mass: spacing.powi(D as i32),
        smoothing_length: 1.4 * spacing,
        internal_energy: 1.0,
        mobile: true,
    };
    let periodic = std::array::from_fn(|axis| axis > 0);
    let domain = Domain::new([0.0; D], [1.0; D], periodic).unwrap();
    ParticleSet::new(domain, (0..across.pow(D as u32)).map(particle).collect()).unwrap()
}

fn images_stay_images<const D: usize>(across: usize) {
    let set = mirrored(&stirred::<D>(across), 0).unwrap();
    let count = set.len() / 2;
    let physics = Sod::standard(D).physics();
    let mut run = Simulation::new(PlainEngine::<f64, D>::new(&set), physics).unwrap();
    run.run(0.1, |_| {}).unwrap();
    assert!(run.steps() > 5, "{} steps", run.steps());
    let velocity = run.engine().read_all(fields::VELOCITY).unwrap();
    // The order of sums rounds some 26 terms otherwise; the flow magnifies that by less than ten in so short a time.
    let tolerance = 10.0 * 26.0 * f64::EPSILON;
    let (mut moved, mut worst) = (0.0_f64, 0.0_f64);
    for (axis, column) in velocity.iter().enumerate() {
        let places = run.engine().coordinates(axis).unwrap();
        for i in 0..count {
            let (here, there) = (places[i], places[i + count]);
            let sign = if axis == 0 { -1.0 } else { 1.0 };
            let off = (column[i + count] - sign * column[i]).abs();
            worst = worst.max(off);
            assert!(
                off < tolerance,
                "{D}-D, axis {axis}, particle {i}: velocity off by {off:e}, tolerance {tolerance:e}"
            );
            let image = if axis == 0 { here.wrapping_neg() } else { here };
            let off = separation(there, image, 2.0).abs();
            assert!(off < tolerance, "{D}-D, axis {axis}, particle {i}: place off by {off:e}, tolerance {tolerance:e}");
            if axis == 0 {
                // Between the walls: the first half of the doubled box.
                assert!(here < 1 << 63, "{D}-D: particle {i} has passed a wall");
            }
            moved = moved.max(column[i].abs());
        }
    }
    println!("{D}-D: velocities of images are off by {worst:e} at most");
    assert!(moved > 0.1, "the gas does not move: {moved}");
}

#[test]
fn images_stay_images_and_nothing_passes_the_walls() {
    images_stay_images::<1>(40);
    images_stay_images::<2>(14);
}

#[test]
fn images_are_exact_at_the_start() {
    let set = mirrored(&stirred::<2>(10), 1).unwrap();
    let [x, y] = [0, 1].map(|axis| set.coordinates(axis));
    for i in 0..100 {
        assert_eq!((x[i + 100], y[i + 100]), (x[i], y[i].wrapping_neg()), "particle {i}");
        let (here, there) = (set.particles()[i], set.particles()[i + 100]);
        assert_eq!(there.velocity, [here.velocity[0], -here.velocity[1]]);
    }
}

#[test]
fn what_has_no_image_is_refused() {
    let set = stirred::<1>(10);
    assert_eq!(mirrored(&set, 1), Err(MirrorError::Axis { axis: 1, dimension: 1 }));
    for wall in [0.0, 1.0] {
        let mut particles = set.particles().to_vec();
        particles[3].position = [wall];
        let on_wall = ParticleSet::new(*set.domain(), particles).unwrap();
        let message = mirrored(&on_wall, 0).unwrap_err().to_string();
        assert!(message.contains("particle 3 lies on a wall"), "{message}");
    }
    assert!(matches!(Scene::<2>::check(&DoubleBlast::standard(1)), Err(SceneError::Dimension { given: 2, .. })));
    let few = DoubleBlast::standard(1).with(|m| m.particles = 5);
    assert!(Scene::<1>::check(&few).unwrap_err().to_string().contains("--n 40 is enough"));
}

/// `L_1` of the density at the end, against the finite-volume solution.
fn blast_error(particles: usize) -> f64 {
    let problem = DoubleBlast::standard(1).with(|m| m.particles = particles);
    let scene: &dyn Scene<1> = &problem;
    let set = scene.particles(&mut |_| unreachable!("a lattice asks for no glass")).unwrap();
    let mut run = Simulation::new(PlainEngine::<f64, 1>::new(&set), scene.physics()).unwrap();
    run.run(END_TIME, |_| {}).unwrap();
    let gas = reference(800, END_TIME).unwrap();
    let places = run.engine().coordinates(0).unwrap();
    let x: Vec<f64> = places[..particles].iter().map(|&x| set.domain().decode(0, x)).collect();
    let density = run.engine().read_scalar(fields::DENSITY).unwrap();
    let due: Vec<f64> = x.iter().map(|x| gas.at(*x).density).collect();
    println!(
        "{particles} particles: {} steps, densest {:e}",
        run.steps(),
        density.iter().fold(0.0, |a: f64, b| a.max(*b))
    );
    l1_error(&density[..particles], &due, &x, MEASURED).unwrap()
}

#[test]
fn two_blasts_collide_as_they_should() {
    let [coarse, fine] = [60, 120].map(blast_error);
    println!("L1 of the density {coarse:e}, {fine:e}");
    // Jumps spread over a fixed number of particles: the error halves with the spacing, and the gas between the blasts is but a few particles wide.
    let order = (coarse / fine).log2();
    assert!((0.8..1.5).contains(&order), "order {order}");
    // The order says nothing of a factor; a twentieth lets a change of arithmetic pass, and not one of the scheme.
    assert!((fine / 0.622 - 1.0).abs() < 0.05, "{fine:e} where 0.622 is recorded");
}
