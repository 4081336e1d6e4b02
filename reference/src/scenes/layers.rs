//! Parts of a scene that have different densities, filled with particles of as nearly the same mass as whole rows allow.

use super::scene::Glasses;
use super::{Block, Method, SceneError};
use crate::domain::Domain;
use crate::equations::initial_state::GasState;
use crate::particles::{Particle, ParticleSet};

/// A part with one density.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layer<const D: usize> {
    /// Where it is.
    pub block: Block<D>,
    /// Its density.
    pub density: f64,
}

/// A part, filled.
#[derive(Clone, Debug, PartialEq)]
pub struct FilledLayer<const D: usize> {
    /// The places of its particles.
    pub places: Vec<[f64; D]>,
    /// The mass of each: the density is exact.
    pub mass: f64,
    /// The smoothing length of each.
    pub smoothing_length: f64,
}

/// How the particles are shared out: by mass.
fn counts<const D: usize>(layers: &[Layer<D>], count: usize) -> Vec<usize> {
    let mass = |layer: &Layer<D>| layer.density * layer.block.volume();
    let total: f64 = layers.iter().map(mass).sum();
    layers.iter().map(|layer| ((mass(layer) / total * count as f64).round() as usize).max(1)).collect()
}

/// Fills layers with about as many particles as the method wants in all.
pub fn fill<const D: usize>(
    layers: &[Layer<D>],
    method: &Method,
    glasses: &mut Glasses<D>,
) -> Result<Vec<FilledLayer<D>>, SceneError> {
    let mut filled = Vec::with_capacity(layers.len());
    for (layer, count) in layers.iter().zip(counts(layers, method.particles)) {
        let filling = layer.block.filled(method, count, glasses)?;
        filled.push(FilledLayer {
            mass: layer.density * filling.volume,
            smoothing_length: method.smoothing_length(D, filling.volume),
            places: filling.places,
        });
    }
    Ok(filled)
}

/// Refuses too few particles for supports in any of the layers along the axes that are periodic, naming a number that is enough.
pub fn check_room<const D: usize>(
    layers: &[Layer<D>],
    method: &Method,
    periodic: [bool; D],
    least: usize,
) -> Result<(), SceneError> {
    let room = |total: usize| {
        let each = layers.iter().zip(counts(layers, total));
        each.into_iter().all(|(layer, count)| layer.block.has_room(method, periodic, count, 1.0))
    };
    method.check_number(D, least, room)
}

/// Layers one above the other along y, from below, with fixed layers of the same gas beyond the lowest and the highest; periodic along the other axes.
/// `gas` says what it is like at a place, in the walls too.
pub fn between_walls<const D: usize>(
    layers: &[Layer<D>],
    method: &Method,
    gamma: f64,
    glasses: &mut Glasses<D>,
    gas: impl Fn([f64; D]) -> GasState<f64, D>,
) -> Result<ParticleSet<D>, SceneError> {
    let filled = fill(layers, method, glasses)?;
    let [Some(first), Some(last)] = [layers.first(), layers.last()] else {
        return Err(SceneError::Given("a scene without layers has no particles; give it one at least".into()));
    };
    let (mut lower, mut upper) = (first.block.lower, last.block.upper);
    let mut particles = Vec::new();
    for (number, (layer, filled)) in layers.iter().zip(&filled).enumerate() {
        let depth = method.wall(filled.smoothing_length);
        let mut walls = Vec::new();
        if number == 0 {
            walls.extend(filled.beyond(&layer.block, 1, false, depth));
            lower[1] -= depth;
        }
        if number + 1 == layers.len() {
            walls.extend(filled.beyond(&layer.block, 1, true, depth));
            upper[1] += depth;
        }
        let all = filled.places.iter().map(|&x| (x, true)).chain(walls.into_iter().map(|x| (x, false)));
        particles.extend(all.map(|(position, mobile)| {
            let gas = gas(position);
            Particle {
                position,
                velocity: gas.velocity.0,
                mass: filled.mass,
                smoothing_length: filled.smoothing_length,
                internal_energy: gas.pressure / ((gamma - 1.0) * gas.density),
                mobile,
            }
        }));
    }
    Ok(ParticleSet::new(Domain::new(lower, upper, std::array::from_fn(|axis| axis != 1))?, particles)?)
}

impl<const D: usize> FilledLayer<D> {
    /// The same arrangement continued beyond one end of its block along an axis, so many lengths deep: what a wall of the same gas is made of. No
    /// deeper than the block itself.
    pub fn beyond(&self, block: &Block<D>, axis: usize, upper: bool, depth: f64) -> Vec<[f64; D]> {
        let side = block.sides()[axis];
        let shifted = self.places.iter().map(|place| {
            let mut place = *place;
            place[axis] += if upper { side } else { -side };
            place
        });
        let near = |place: &[f64; D]| match upper {
            true => place[axis] < block.upper[axis] + depth,
            false => place[axis] > block.lower[axis] - depth,
        };
        shifted.filter(near).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn halves() -> [Layer<2>; 2] {
        let block = |lower: f64| Block { lower: [0.0, lower], upper: [1.0, lower + 0.5] };
        [Layer { block: block(0.0), density: 1.0 }, Layer { block: block(0.5), density: 2.0 }]
    }

    #[test]
    fn densities_are_exact_and_masses_nearly_alike() {
        let method = Method::standard(2, 3000);
        let filled = fill(&halves(), &method, &mut |_| Ok(Vec::new())).unwrap();
        for (layer, filled) in halves().iter().zip(&filled) {
            let density = filled.mass * filled.places.len() as f64 / layer.block.volume();
            assert!((density / layer.density - 1.0).abs() < 1e-12, "{density}");
        }
        // 22 and 32 rows across: half a row at most is rounded away along each axis.
        let ratio = filled[0].mass / filled[1].mass;
        assert!((ratio - 1.0).abs() < 0.04, "{ratio}");
    }

    #[test]
    fn a_wall_continues_the_rows() {
        let method = Method::standard(2, 3000);
        let [lower, _] = halves();
        let filled = fill(&[lower], &method, &mut |_| Ok(Vec::new())).unwrap().remove(0);
        let spacing = filled.places.iter().map(|p| p[1]).fold(f64::INFINITY, f64::min) * 2.0;
        for (upper, edge) in [(false, 0.0), (true, 0.5)] {
            let wall = filled.beyond(&lower.block, 1, upper, 0.1);
            let nearest = wall.iter().map(|p| (p[1] - edge).abs()).fold(f64::INFINITY, f64::min);
            let farthest = wall.iter().map(|p| (p[1] - edge).abs()).fold(0.0, f64::max);
            assert!((nearest - 0.5 * spacing).abs() < 1e-12, "{nearest}");
            assert!(farthest <= 0.1 && farthest > 0.1 - spacing, "{farthest}");
        }
    }

    #[test]
    fn a_refusal_names_a_number_that_works() {
        let mut method = Method::standard(2, 20);
        let SceneError::TooFew { enough, .. } = check_room(&halves(), &method, [true, false], 1).unwrap_err() else {
            panic!("another refusal");
        };
        method.particles = enough;
        assert!(check_room(&halves(), &method, [true, false], 1).is_ok(), "{enough}");
    }
}
