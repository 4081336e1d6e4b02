//! The check on the fast search: every pair, one after the other.

use super::coordinate::{Coordinate, Scalar, distance_squared};

/// For every particle i, the indices j != i with |r_i - r_j|^2 < max(reach_i, reach_j)^2, ascending.
///
/// The direct double loop, in the same arithmetic as [`NeighbourList`](super::NeighbourList). Panics if an array is shorter than
/// `reach`.
pub fn brute_force<C: Coordinate, const D: usize>(
    coordinates: [&[C]; D],
    reach: &[C::Scalar],
    length: &[f64; D],
) -> Vec<Vec<u32>> {
    let unit = length.map(C::unit);
    let position = |i: usize| coordinates.map(|axis| axis[i]);
    let is_pair = |i: usize, j: usize| {
        let reach = larger(reach[i], reach[j]);
        i != j && distance_squared(position(i), position(j), unit) < reach * reach
    };
    let particles = 0..reach.len();
    particles.clone().map(|i| particles.clone().filter(|j| is_pair(i, *j)).map(|j| j as u32).collect()).collect()
}

fn larger<T: Scalar>(a: T, b: T) -> T {
    if a > b { a } else { b }
}
