//! Particles where a test wants them.

use etalon_reference::domain::Domain;
use etalon_reference::turbulence::Snapshot;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// A periodic box of this side.
pub fn cube<const D: usize>(side: f64) -> Domain<D> {
    Domain::new([0.0; D], [side; D], [true; D]).unwrap()
}

/// Particles of equal mass at these places in a periodic box.
pub fn particles<const D: usize>(side: f64, places: &[[f64; D]], velocity: impl Fn(usize) -> [f64; D]) -> Snapshot<D> {
    weighed(side, places, velocity, vec![1.0; places.len()])
}

/// Particles of any mass.
pub fn weighed<const D: usize>(
    side: f64,
    places: &[[f64; D]],
    velocity: impl Fn(usize) -> [f64; D],
    mass: Vec<f64>,
) -> Snapshot<D> {
    let domain = cube::<D>(side);
    let coordinates = std::array::from_fn(|axis| places.iter().map(|x| domain.encode(axis, x[axis])).collect());
    let velocity = std::array::from_fn(|axis| (0..places.len()).map(|i| velocity(i)[axis]).collect());
    Snapshot::new(domain, coordinates, velocity, mass).unwrap()
}

/// The middles of `across^D` cells of the unit cube, in the order of a grid's points.
pub fn lattice<const D: usize>(across: usize) -> Vec<[f64; D]> {
    let place =
        |i: usize| std::array::from_fn(|axis| ((i / across.pow(axis as u32) % across) as f64 + 0.5) / across as f64);
    (0..across.pow(D as u32)).map(place).collect()
}

/// So many places anywhere in the unit cube.
pub fn scattered<const D: usize>(count: usize, seed: u64) -> Vec<[f64; D]> {
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    (0..count).map(|_| std::array::from_fn(|_| random.random::<f64>())).collect()
}
