//! The fast neighbour search: who is within reach of whom.
//!
//! Before every step an engine
//! 1. sorts its particles along a space-filling curve ([`Order`]) and permutes all its arrays accordingly,
//! 2. lists the neighbours of every particle ([`NeighbourList`]).
//!
//! Positions are fixed-point fractions of a torus ([`Coordinate`]): differences are exact and find the nearest periodic image
//! by themselves. Everything is periodic; an axis that is open or has walls is embedded by the caller in a torus at least twice
//! as long as the particles' extent and reach, so that the wrap is never seen. Empty space costs nothing.
//!
//! Results are identical for any number of threads and any instruction set, and identical to those of [`brute_force`].

mod brute_force;
mod candidates;
mod coordinate;
mod curve;
mod error;
mod lanes;
mod list;
mod order;
mod radix;
mod search;
#[cfg(test)]
mod tests;
mod tree;

pub use brute_force::brute_force;
pub use coordinate::{Coordinate, Scalar, distance_squared};
pub use error::NeighbourError;
pub use lanes::LaneCoordinate;
pub use list::{NeighbourList, PADDING, Segment};
pub use order::Order;
pub use search::SEGMENT;
