//! Scenes in which nothing should happen, and how much does.

use crate::support::{mass_and_energy, near, particles, series};
use etalon_reference::scenes::even_gas::{ColdFlow, EvenGas, Kind, NoisyLattice, Pairing};
use etalon_reference::scenes::hydrostatic::Hydrostatic;
use etalon_reference::scenes::static_square::StaticSquare;
use etalon_reference::scenes::{Definition, Scene};

fn even<K: Kind>(particles: usize) -> EvenGas<K> {
    let mut scene = EvenGas::<K>::standard(2);
    scene.method.particles = particles;
    scene
}

/// A lattice that flows keeps still: all sums are alike, so what is left is the grid of places, 2^-32 of the side, and what rounding makes of a
/// velocity of 129.
#[test]
fn a_flow_at_mach_100_stays_even() {
    let mut scene = even::<ColdFlow>(1800);
    scene.width = 0.25;
    let set = particles::<2>(&scene);
    near("mass", mass_and_energy(&set).0, 0.25, 1e-12);
    // Mach 100: half of 1e4 gamma P / rho, and P / (gamma - 1).
    near("energy", mass_and_energy(&set).1, 0.25 * (0.5e4 * 5.0 / 3.0 + 1.5), 1e-12);
    let rows = series::<2>(&scene, &[0.0, scene.end_time()]);
    println!("{rows:?}");
    let [velocity, density, energy, entropy] = [rows[1][0], rows[1][1], rows[1][2], rows[1][3]];
    assert!(velocity < 1e-6, "velocity scatters by {velocity} of the speed of sound");
    assert!(density < 5e-3, "density scatters by {density}");
    assert!(energy.abs() < 1e-9, "energy drifts by {energy} of the internal energy");
    assert!(entropy.abs() < 1e-6, "entropy changes by {entropy}");
    assert_eq!(rows[1][6], 0.0, "pairs");
    scene.mach = 1e4;
    assert!(Scene::<2>::check(&scene).unwrap_err().to_string().starts_with("mach = 10000"));
}

#[test]
fn a_noisy_lattice_settles_and_keeps_its_energy() {
    let scene = even::<NoisyLattice>(500);
    let rows = series::<2>(&scene, &[0.0, scene.end_time()]);
    println!("{rows:?}");
    assert!(rows[0][1] > 0.01, "the start is even already: {}", rows[0][1]);
    assert!(rows[1][1] < 0.7 * rows[0][1], "density scatters by {} and then by {}", rows[0][1], rows[1][1]);
    assert!(rows[1][0] > rows[0][0] && rows[1][0] < 0.1, "velocity {}", rows[1][0]);
    // The integrator's error, of second order in the step, of what little moves.
    assert!(rows[1][2].abs() < 1e-4, "energy drifts by {}", rows[1][2]);
    assert!(rows[1][3] > 0.0, "noise that viscosity damps is heat");
    assert!(rows[1][5] > rows[0][5], "particles push each other apart");
}

#[test]
fn the_mixed_kernel_keeps_particles_apart_better_than_the_cubic_spline() {
    use etalon_reference::schemes::Kernel;
    let run = |kernel| {
        let mut scene = even::<Pairing>(350);
        scene.method.kernel = kernel;
        series::<2>(&scene, &[0.0, 1.2 * scene.end_time()]).remove(1)
    };
    let (mixed, cubic) = (run(Kernel::MixedSinc), run(Kernel::CubicSpline));
    println!("{mixed:?}\n{cubic:?}");
    assert_eq!(mixed[6], 0.0, "pairs with the mixed kernel");
    // Pairs take many crossings of sound to form; their approach shows in one.
    assert!(cubic[4] < mixed[4], "nearest at {} and {} spacings in the mean", cubic[4], mixed[4]);
    assert!(cubic[5] < 0.93 * mixed[5], "nearest at {} and {} spacings", cubic[5], mixed[5]);
}

#[test]
fn the_square_stays_where_it_is() {
    let mut scene = StaticSquare::standard(2);
    scene.method.particles = 450;
    let set = particles::<2>(&scene);
    let (mass, energy) = mass_and_energy(&set);
    near("mass", mass, 1.75, 1e-12);
    near("energy", energy, 2.5 * 1.5, 1e-12);
    let masses = set.particles().iter().map(|p| p.mass);
    let (least, most) = masses.fold((f64::INFINITY, 0.0_f64), |(a, b), m| (a.min(m), b.max(m)));
    near("masses", most / least, 1.0, 1e-12);
    let rows = series::<2>(&scene, &[0.0, 0.2]);
    println!("{rows:?}");
    assert!(rows[1][0] < 0.02, "velocity {}", rows[1][0]);
    // Nearly all of so few particles see the contact, where a smooth density and an energy that jumps make pressures as much as twice too high.
    assert!((0.02..0.3).contains(&rows[1][1]), "pressure scatters by {}", rows[1][1]);
    assert!(rows[1][2].abs() < 1e-4, "energy drifts by {}", rows[1][2]);
    assert_eq!(rows[1][4], 0.0, "gas has left the square");
}

#[test]
fn gas_at_rest_in_gravity_stays_at_rest_the_better_the_more_particles_there_are() {
    let run = |count| {
        let mut scene = Hydrostatic::standard(2);
        scene.method.particles = count;
        near("mass", mass_and_energy(&particles::<2>(&scene)).0, 1.0, 1e-12);
        series::<2>(&scene, &[0.0, 0.4])
    };
    let (coarse, fine) = (run(200), run(600));
    println!("{coarse:?}\n{fine:?}");
    // Without the weight all would fall with 0.5 for 0.4: 0.2, a tenth of the speed of sound.
    assert!(fine[1][0] < 0.01, "velocity {}", fine[1][0]);
    assert!(fine[1][0] < coarse[1][0], "velocity {} and {}", coarse[1][0], fine[1][0]);
}
