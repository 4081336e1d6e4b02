//! Disordered particles, made to measure.

use etalon_reference::domain::Domain;
use etalon_reference::equations::reconstruction::smoothing_length_holding;
use etalon_reference::particles::{Particle, ParticleSet};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// What a cloud is like. Masses and smoothing lengths are drawn between a base value and `spread` times it.
#[derive(Clone, Copy, Debug)]
pub struct Recipe {
    /// Particles along each side of the unit cube.
    pub across: usize,
    /// The largest random shift from the lattice along each axis, in spacings.
    pub jitter: f64,
    /// Largest over smallest mass.
    pub mass_spread: f64,
    /// Largest over smallest smoothing length.
    pub h_spread: f64,
    /// Neighbours, the particle included, that a mean smoothing length holds in a support of `support` smoothing
    /// lengths.
    pub neighbours: f64,
    /// The kernel's support.
    pub support: f64,
    /// Which cloud.
    pub seed: u64,
}

impl Recipe {
    /// Unequal in everything: masses by four, smoothing lengths by two, no trace of the lattice.
    pub fn unequal<const D: usize>(seed: u64) -> Self {
        // The largest support must fit into half the box: (n_b / ball)^(1/D) sqrt(2) / across <= 1/4.
        let (across, neighbours) = [(32, 8.0), (14, 24.0), (7, 50.0)][D - 1];
        Recipe { across, jitter: 1.0, mass_spread: 4.0, h_spread: 2.0, neighbours, support: 2.0, seed }
    }

    /// The smoothing length in the middle of the range.
    pub fn mean_h<const D: usize>(&self) -> f64 {
        smoothing_length_holding(self.neighbours, (self.across as f64).powi(-(D as i32)), D, self.support)
    }

    /// The particles, in a unit cube that is periodic along all axes or along none. Velocities are within -1 and 1
    /// along each axis, energies between 1/2 and 3/2. Positions are multiples of 2^-32, so that encoding them is
    /// exact.
    pub fn particles<const D: usize>(&self, periodic: bool) -> ParticleSet<D> {
        let domain = Domain::new([0.0; D], [1.0; D], [periodic; D]).unwrap();
        let mut random = Pcg64Mcg::seed_from_u64(self.seed);
        let spacing = 1.0 / self.across as f64;
        let h = self.mean_h::<D>();
        let particles = (0..self.across.pow(D as u32))
            .map(|i| Particle {
                position: std::array::from_fn(|axis| {
                    let cell = (i / self.across.pow(axis as u32) % self.across) as f64 + 0.5;
                    let place = (cell + self.jitter * (2.0 * random.random::<f64>() - 1.0)) * spacing;
                    let inside = if periodic { place.rem_euclid(1.0) } else { place.clamp(0.0, 1.0) };
                    (inside * 4_294_967_296.0).floor() / 4_294_967_296.0
                }),
                velocity: std::array::from_fn(|_| 2.0 * random.random::<f64>() - 1.0),
                mass: spacing.powi(D as i32) * self.mass_spread.powf(random.random::<f64>()),
                smoothing_length: h * self.h_spread.powf(random.random::<f64>() - 0.5),
                internal_energy: 0.5 + random.random::<f64>(),
                mobile: true,
            })
            .collect();
        ParticleSet::new(domain, particles).unwrap()
    }
}
