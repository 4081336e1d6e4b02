//! Toro's tubes: the wave that reaches the ends, walls where gas rests and more gas where it moves, and solutions that are approached.

use crate::support::{mass_and_energy, near, particles, states};
use etalon_reference::scenes::gas_tube::{GasTube, Kind, NearVacuum, Sonic, StrongShock};
use etalon_reference::scenes::{Compared, Definition, GivenMomentum, Scene};

fn tube<K: Kind>(particles: usize) -> GasTube<K> {
    let mut scene = GasTube::<K>::standard(1);
    scene.method.particles = particles;
    scene
}

/// `L_1` of density, velocity and pressure at the paper's time, over the jumps of the start.
fn errors<K: Kind>(count: usize) -> [f64; 3] {
    let scene = tube::<K>(count);
    let state = states::<1>(&scene, &[K::END_TIME]).remove(0);
    let solution = Scene::<1>::solution(&scene, K::END_TIME).unwrap().unwrap();
    let range = Scene::<1>::measured(&scene, K::END_TIME).range;
    let scale = [1.0, 1.0, K::GASES[0].pressure];
    let what = [Compared::Density, Compared::Velocity, Compared::Pressure];
    std::array::from_fn(|k| state.l1(Scene::<1>::view(&scene), solution.as_ref(), what[k], range).unwrap() / scale[k])
}

fn converges<K: Kind>(coarse: usize, fine: usize, least_order: f64) {
    let (rough, close) = (errors::<K>(coarse), errors::<K>(fine));
    println!("{}: {rough:?} {close:?}", K::NAME);
    for (rough, close) in rough.iter().zip(close) {
        let order = (rough / close).ln() / (fine as f64 / coarse as f64).ln();
        assert!(order > least_order, "{}: {rough} and {close}: order {order}", K::NAME);
    }
}

#[test]
fn toros_tubes_converge() {
    converges::<Sonic>(80, 240, 0.6);
    converges::<NearVacuum>(80, 240, 0.4);
}

/// The gas behind the shock is a layer of a twentieth of the tube: with few particles it is not there.
#[test]
fn a_jump_of_a_hundred_thousand_converges() {
    converges::<StrongShock>(100, 250, 0.3);
}

#[test]
fn ends_are_walls_where_gas_rests_and_gas_where_it_moves() {
    let strong = particles::<1>(&tube::<StrongShock>(200));
    near("mass", mass_and_energy(&strong).0, 1.0, 1e-12);
    assert!(strong.particles().iter().all(|p| p.mobile == (0.0..=1.0).contains(&p.position[0])));
    let GivenMomentum::Along { momentum, .. } = Scene::<1>::given_momentum(&tube::<StrongShock>(200), 0.01) else {
        panic!("walls push");
    };
    near("momentum", momentum, 999.99 * 0.01, 1e-12);
    let vacuum = particles::<1>(&tube::<NearVacuum>(200));
    assert!(vacuum.particles().iter().all(|p| p.mobile && p.velocity[0].abs() == 2.0));
    assert_eq!(Scene::<1>::given_momentum(&tube::<NearVacuum>(200), 0.1), GivenMomentum::None);
    // Only at the left of the first test does gas come in: 0.75 and sound of 1.18 for a fifth of a unit of time, and some.
    let sonic = particles::<1>(&tube::<Sonic>(200));
    let lowest = sonic.particles().iter().map(|p| p.position[0]).fold(f64::INFINITY, f64::min);
    assert!((-0.7..-0.38).contains(&lowest), "{lowest}");
    for end in [Scene::<1>::last_time(&tube::<Sonic>(200)), Scene::<1>::last_time(&tube::<StrongShock>(200))] {
        assert!(end.0 > 0.012 && end.0.is_finite(), "{end:?}");
    }
    assert!(Scene::<1>::last_time(&tube::<Sonic>(200)).0 > Sonic::END_TIME);
    assert!(Scene::<1>::last_time(&tube::<NearVacuum>(200)).0 > NearVacuum::END_TIME);
}

#[test]
fn what_is_no_gas_is_refused() {
    let mut scene = tube::<Sonic>(200);
    scene.left.density = 0.0;
    assert!(Scene::<1>::check(&scene).unwrap_err().to_string().starts_with("left = "));
    let mut scene = tube::<Sonic>(200);
    scene.interface = 1.5;
    assert!(Scene::<1>::check(&scene).unwrap_err().to_string().starts_with("interface = 1.5"));
}
