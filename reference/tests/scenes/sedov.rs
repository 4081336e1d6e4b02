//! The blast starts with its energy, whatever the Gaussian, and its shock goes where Sedov says.

use crate::support::{mass_and_energy, near, particles, series, states};
use etalon_reference::scenes::sedov::{COLD, END_TIME, Gaussian, Sedov};
use etalon_reference::scenes::{Arrangement, Compared, Definition, Scene};

fn blast(dimension: usize, particles: usize) -> Sedov {
    let mut scene = Sedov::standard(dimension);
    scene.method.particles = particles;
    scene.method.arrangement = Arrangement::Lattice;
    scene
}

fn starts<const D: usize>(count: usize) {
    let hottest = [Gaussian::Width, Gaussian::Deviation].map(|deposit| {
        let set = particles::<D>(&Sedov { deposit, ..blast(D, count) });
        let (mass, energy) = mass_and_energy(&set);
        near("mass", mass, 1.0, 1e-12);
        near("energy", energy, 1.0 + COLD, 1e-12);
        let coldest = set.particles().iter().map(|p| p.internal_energy).fold(f64::INFINITY, f64::min);
        assert!(coldest >= COLD);
        set.particles().iter().map(|p| p.internal_energy).fold(0.0, f64::max)
    });
    // The same energy over a ball wider by the root of two. Lattice sums of such Gaussians are exact to 1e-4, but the hottest particles
    // lie off the centre, up to half a spacing along each axis: r^2 = D / 4 of 2.88^2 = 8.3 or twice that.
    near("heat in the middle", hottest[0] / hottest[1], 2.0_f64.powf(0.5 * D as f64), 0.06);
}

#[test]
fn it_starts_with_its_energy() {
    starts::<1>(200);
    starts::<2>(2500);
    starts::<3>(8000);
}

/// With 55 rows the one through the middle is shot along itself, and its particles end up in one place: a density of 3000.
#[test]
fn no_row_of_a_lattice_goes_through_the_middle() {
    for count in [3025, 2916, 2500] {
        let set = particles::<2>(&blast(2, count));
        assert!(set.particles().iter().all(|p| p.position.iter().all(|x| x.abs() > 1e-3)), "{count}");
        near("number", set.len() as f64, count as f64, 0.05);
    }
    assert_eq!(Sedov::standard(2).method.arrangement, Arrangement::Glass);
}

#[test]
fn the_line_converges_to_sedov() {
    let run = |count: usize| {
        let scene = blast(1, count);
        let states = states::<1>(&scene, &[0.0, END_TIME]);
        let solution = Scene::<1>::solution(&scene, END_TIME).unwrap().unwrap();
        let range = Scene::<1>::measured(&scene, END_TIME).range;
        let l1 = states[1].l1(Scene::<1>::view(&scene), solution.as_ref(), Compared::Density, range).unwrap();
        (l1, Scene::<1>::observe(&scene, &states[1]).unwrap())
    };
    let (coarse, fine) = (run(150), run(450));
    println!("{coarse:?}\n{fine:?}");
    let order = (coarse.0 / fine.0).ln() / 3.0_f64.ln();
    // The deposit is wide, and its trace goes with the smoothing length; jumps spread over a fixed number of particles would be of order one.
    assert!(order > 0.25, "order {order}");
    // R = 1.18370 (E t^2 / rho)^(1/3).
    // The fastest particle is behind the middle of a shock four smoothing lengths of 1.44/450 wide: 5 % of the radius.
    near("shock", fine.1[1], 1.183_703_989_0 * 0.01_f64.powf(1.0 / 3.0), 0.05);
    near("density", fine.1[0], 4.0, 0.1);
}

#[test]
fn the_disc_grows_as_it_should() {
    let rows = series::<2>(&blast(2, 900), &[0.0, 0.05]);
    println!("{rows:?}");
    // R = 1.15379 t^(1/2), the shock spread over two supports of 0.096; the largest velocity is behind it.
    near("shock", rows[1][1], 1.153_787_087_5 * 0.05_f64.sqrt(), 0.3);
    assert!((1.5..4.2).contains(&rows[1][0]), "density {}", rows[1][0]);
}

#[test]
fn what_is_no_blast_is_refused() {
    let wide = Sedov { width: 20.0, ..blast(2, 1000) };
    assert!(Scene::<2>::check(&wide).unwrap_err().to_string().starts_with("width = 20"));
    let gamma = Sedov { gamma: 2.5, ..blast(2, 1000) };
    assert!(Scene::<2>::check(&gamma).unwrap_err().to_string().contains("below 2"));
    // The box is met by the shock at t = 0.1242 in three dimensions.
    near("last", Scene::<3>::last_time(&blast(3, 8000)).0, 0.1242, 1e-3);
}
