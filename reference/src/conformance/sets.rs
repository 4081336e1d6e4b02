//! Particle sets that engines are tried on.

use crate::domain::Domain;
use crate::equations::reconstruction::smoothing_length_holding;
use crate::particles::{Particle, ParticleError, ParticleSet};
use crate::passes::Physics;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// What a set is made to try.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Difficulty {
    /// Nothing in particular: disordered, with unequal masses (x4) and smoothing lengths (x1.5).
    None,
    /// Several particles at the very same place.
    Coincident,
    /// Neighbours on one line.
    Collinear,
    /// Neighbours in one plane.
    Coplanar,
    /// One particle without neighbours.
    Isolated,
    /// A box a million lengths from the origin, open on all sides.
    FarAway,
    /// One half of the particles a million times lighter.
    NearVacuum,
    /// Smoothing lengths from a third to three times the fitting one, in an open box, which the largest supports fill.
    UnequalLengths,
    /// A unit of length of 2^16. In `f32` and three dimensions `h^-4` leaves the range of normal numbers beyond 2^30 either way.
    ///
    /// Scenes use units of order one.
    Huge,
    /// A unit of length of 2^-16.
    Tiny,
    /// Walls: the outer layers along the first axis do not move, in a box that is open along it and periodic across.
    FixedLayers,
}

/// How thick each of the two walls is, in sides of the box.
const WALL: f64 = 0.2;

/// The share of particles for which a comparison may be too close to call: a time step where the energy neither rises nor falls.
const RARELY: f64 = 0.02;

impl Difficulty {
    /// All of them.
    pub const ALL: &'static [Difficulty] = &[
        Difficulty::None,
        Difficulty::Coincident,
        Difficulty::Collinear,
        Difficulty::Coplanar,
        Difficulty::Isolated,
        Difficulty::FarAway,
        Difficulty::NearVacuum,
        Difficulty::UnequalLengths,
        Difficulty::Huge,
        Difficulty::Tiny,
        Difficulty::FixedLayers,
    ];

    /// The share of particles that may be without an error bound, in so many dimensions.
    ///
    /// In single precision a matrix that is all but singular is one within its own rounding. Exactly flat neighbourhoods are lifted by a
    /// number that is far from zero, and in one dimension nothing is flat. But a support of a third of the usual length holds a few
    /// neighbours or none, which hardly span a plane or space: of a third of all particles some have no bound, 12 % of all in two
    /// dimensions and 24 % in three.
    pub fn most_unbounded(self, dimension: usize) -> f64 {
        match (self, dimension) {
            (Difficulty::UnequalLengths, 2) => 0.2,
            (Difficulty::UnequalLengths, 3) => 0.33,
            _ => RARELY,
        }
    }
}

/// About `across^D` particles with this difficulty, in a box of side one unless the difficulty says otherwise.
pub fn set<const D: usize>(
    difficulty: Difficulty,
    across: usize,
    physics: &Physics,
    seed: u64,
) -> Result<ParticleSet<D>, ParticleError> {
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    let mut uniform = move |low: f64, high: f64| low + (high - low) * random.random::<f64>();
    let spacing = 1.0 / across as f64;
    let h = smoothing_length_holding(physics.neighbours, spacing.powi(D as i32), D, physics.kernel.support());
    let mut particles: Vec<Particle<D>> = (0..across.pow(D as u32))
        .map(|i| Particle {
            position: std::array::from_fn(|axis| {
                let cell = (i / across.pow(axis as u32) % across) as f64 + 0.5;
                (cell + uniform(-0.4, 0.4)) * spacing
            }),
            velocity: std::array::from_fn(|_| uniform(-0.5, 0.5)),
            mass: spacing.powi(D as i32) * uniform(0.5, 2.0),
            smoothing_length: h * uniform(0.8, 1.2),
            internal_energy: uniform(0.5, 1.5),
            mobile: true,
        })
        .collect();

    let unit = match difficulty {
        Difficulty::Huge => 65_536.0,
        Difficulty::Tiny => 1.0 / 65_536.0,
        _ => 1.0,
    };
    let mut origin = 0.0;
    let count = particles.len();
    match difficulty {
        Difficulty::Coincident => {
            let (first, rest) = particles.split_at_mut(1);
            rest.iter_mut().step_by(7).take(count / 8).for_each(|p| p.position = first[0].position);
        }
        Difficulty::Collinear => particles.iter_mut().for_each(|p| p.position[1..].fill(0.5)),
        Difficulty::Coplanar => particles.iter_mut().for_each(|p| {
            if D == 3 {
                p.position[D - 1] = 0.5;
            }
        }),
        Difficulty::Isolated => {
            // Everyone else moves to one side, farther than any support.
            let reach = 1.3 * h * physics.kernel.support();
            for p in &mut particles[1..] {
                p.position[0] = 0.5 + (p.position[0] - 0.5) * (0.9 - 2.0 * reach).max(0.1);
            }
            particles[0].position[0] = 0.0;
            particles[0].smoothing_length = 0.05 * h;
        }
        Difficulty::FarAway => origin = 1e6,
        Difficulty::NearVacuum => particles.iter_mut().step_by(2).for_each(|p| p.mass *= 1e-6),
        Difficulty::UnequalLengths => particles.iter_mut().enumerate().for_each(|(i, p)| {
            p.smoothing_length *= match i % 9 {
                0 | 3 | 6 => 1.0 / 3.0,
                4 => 3.0,
                _ => 1.0,
            };
        }),
        // Their velocities stay: if they keep their places, it is because they are said to be fixed.
        Difficulty::FixedLayers => {
            particles.iter_mut().for_each(|p| p.mobile = (WALL..=1.0 - WALL).contains(&p.position[0]))
        }
        Difficulty::None | Difficulty::Huge | Difficulty::Tiny => {}
    }
    for p in &mut particles {
        p.position = p.position.map(|x| origin + unit * x);
        p.smoothing_length *= unit;
        // Density stays of order one.
        p.mass *= unit.powi(D as i32);
    }
    // The torus behind an open box is wide enough for any support here.
    let open = matches!(difficulty, Difficulty::FarAway | Difficulty::UnequalLengths);
    let periodic = std::array::from_fn(|axis| !(open || difficulty == Difficulty::FixedLayers && axis == 0));
    let domain = Domain::new([origin; D], [origin + unit; D], periodic)?;
    ParticleSet::new(domain, particles)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenes::sod::Sod;

    fn has_walls<const D: usize>() {
        let set = set::<D>(Difficulty::FixedLayers, 10, &Sod::standard(D).physics(), 1).unwrap();
        assert!(set.domain().periodic().iter().enumerate().all(|(axis, periodic)| *periodic == (axis > 0)));
        let count = |low: f64, high: f64| {
            let here = || set.particles().iter().filter(|p| (low..high).contains(&p.position[0]));
            (here().filter(|p| !p.mobile).count(), here().filter(|p| p.mobile).count())
        };
        // Two layers in each of the walls; the jitter of 0.4 carries nobody across an edge between layers.
        let (left, middle, right) = (count(0.0, 0.2), count(0.2, 0.8), count(0.8, 1.0));
        let layer = 10usize.pow(D as u32 - 1);
        assert_eq!((left, middle, right), ((2 * layer, 0), (0, 6 * layer), (2 * layer, 0)), "{D}-D");
    }

    /// Without particles that stay, no comparison would notice an engine that moves its walls.
    #[test]
    fn fixed_layers_are_at_both_ends_of_an_open_axis() {
        has_walls::<1>();
        has_walls::<2>();
        has_walls::<3>();
    }
}
