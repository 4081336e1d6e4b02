//! Where particles live: a torus on which every coordinate is a fixed-point fraction of the side.
//!
//! Fixed point makes separations exact, periodic wrapping free and results independent of where the box stands. An axis that is
//! not periodic is laid on a side at least twice as long as the particles' extent, so that its wrap is never seen.

/// A box that is no box.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum DomainError {
    /// The upper end is not above the lower one, or one of them is not a number.
    #[error("axis {axis} of the box runs from {lower} to {upper}; it needs a finite positive length")]
    Empty {
        /// Which axis, from 0.
        axis: usize,
        /// Its lower end.
        lower: f64,
        /// Its upper end.
        upper: f64,
    },
    /// A particle is outside.
    #[error(
        "particle {particle} is at {value} on axis {axis}, outside the box from {lower} to {upper}; enlarge the box"
    )]
    Outside {
        /// Which particle, from 0.
        particle: usize,
        /// Which axis, from 0.
        axis: usize,
        /// Where it is.
        value: f64,
        /// The box's lower end.
        lower: f64,
        /// The box's upper end.
        upper: f64,
    },
}

/// The box, axis by axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Domain<const D: usize> {
    lower: [f64; D],
    upper: [f64; D],
    periodic: [bool; D],
}

/// 2^32: how many places a side has that are kept beside `f32` arithmetic.
pub const SINGLE_PLACES: f64 = 4_294_967_296.0;
/// 2^53: how many it has beside `f64` arithmetic.
pub const DOUBLE_PLACES: f64 = 9_007_199_254_740_992.0;
/// 2^64: how many positions a side has.
const POSITIONS: f64 = 18_446_744_073_709_551_616.0;
/// The bits of a coordinate below the 53 that an `f64` can tell apart.
pub const UNUSED_BITS: u32 = 11;
/// What is added to either end of an axis that is not periodic, in lengths of the axis.
const MARGIN: f64 = 0.75;

impl<const D: usize> Domain<D> {
    /// A box from `lower` to `upper`, periodic along the axes that say so.
    pub fn new(lower: [f64; D], upper: [f64; D], periodic: [bool; D]) -> Result<Self, DomainError> {
        for axis in 0..D {
            let (low, high) = (lower[axis], upper[axis]);
            if !(low.is_finite() && high.is_finite() && high > low) {
                return Err(DomainError::Empty { axis, lower: low, upper: high });
            }
        }
        Ok(Domain { lower, upper, periodic })
    }

    /// The lower ends.
    pub fn lower(&self) -> [f64; D] {
        self.lower
    }
    /// The upper ends.
    pub fn upper(&self) -> [f64; D] {
        self.upper
    }
    /// Which axes are periodic.
    pub fn periodic(&self) -> [bool; D] {
        self.periodic
    }

    /// The sides of the torus.
    pub fn torus_length(&self) -> [f64; D] {
        std::array::from_fn(|i| {
            let length = self.upper[i] - self.lower[i];
            if self.periodic[i] { length } else { length * (1.0 + 2.0 * MARGIN) }
        })
    }

    fn torus_lower(&self) -> [f64; D] {
        std::array::from_fn(|i| {
            let length = self.upper[i] - self.lower[i];
            if self.periodic[i] { self.lower[i] } else { self.lower[i] - MARGIN * length }
        })
    }

    /// The fixed-point coordinate nearest to a position, on the grid that `f32` arithmetic can also hold (2^-32 of the side).
    ///
    /// All engines start from this grid, so that they start from the same particles.
    pub fn encode(&self, axis: usize, position: f64) -> u64 {
        let fraction = (position - self.torus_lower()[axis]) / self.torus_length()[axis];
        let wrapped = fraction - fraction.floor();
        (((wrapped * SINGLE_PLACES).round() as u64) & 0xffff_ffff) << 32
    }

    /// The position of a fixed-point coordinate, within the box along periodic axes.
    pub fn decode(&self, axis: usize, coordinate: u64) -> f64 {
        self.torus_lower()[axis] + coordinate as f64 / POSITIONS * self.torus_length()[axis]
    }
}

/// `a - b` on a side of this length: the exact difference the short way round, rounded once to `f64` and once in the product.
#[inline(always)]
pub fn separation(a: u64, b: u64, length: f64) -> f64 {
    (a.wrapping_sub(b) as i64) as f64 * (length / POSITIONS)
}

/// A coordinate moved by a displacement shorter than half the side, to the nearest position an `f64` can tell apart.
#[inline(always)]
pub fn moved(coordinate: u64, displacement: f64, length: f64) -> u64 {
    let steps = nearest(displacement / length * DOUBLE_PLACES);
    coordinate.wrapping_add((steps << UNUSED_BITS) as u64)
}

/// The nearest whole number, halves away from zero; without the library call that `round` is on many processors.
#[inline(always)]
pub fn nearest(x: f64) -> i64 {
    (x + 0.5_f64.copysign(x)) as i64
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unit() -> Domain<1> {
        Domain::new([0.0], [1.0], [true]).unwrap()
    }

    #[test]
    fn separations_take_the_short_way_and_are_antisymmetric() {
        let domain = unit();
        let (a, b) = (domain.encode(0, 0.99), domain.encode(0, 0.01));
        let d = separation(a, b, 1.0);
        // Each end is rounded to 2^-32.
        assert!((d + 0.02).abs() < 3e-10, "{d}");
        assert_eq!(d, -separation(b, a, 1.0));
    }

    #[test]
    fn translation_changes_no_separation() {
        let domain = unit();
        let (a, b) = (domain.encode(0, 0.3), domain.encode(0, 0.7));
        let shift = domain.encode(0, 0.81);
        assert_eq!(separation(a, b, 1.0), separation(a.wrapping_add(shift), b.wrapping_add(shift), 1.0));
    }

    #[test]
    fn moving_there_and_back_is_exact() {
        let start = unit().encode(0, 0.4);
        assert_eq!(moved(moved(start, 0.123_456, 1.0), -0.123_456, 1.0), start);
    }

    #[test]
    fn an_open_axis_never_sees_its_wrap() {
        let domain = Domain::new([0.0], [1.0], [false]).unwrap();
        let (a, b) = (domain.encode(0, 0.0), domain.encode(0, 1.0));
        let length = domain.torus_length()[0];
        assert!((separation(b, a, length) - 1.0).abs() < 1e-9);
        assert!((domain.decode(0, b) - 1.0).abs() < 1e-9);
    }

    #[test]
    fn an_empty_axis_is_refused_by_name() {
        let error = Domain::new([0.0, 1.0], [1.0, 1.0], [true, true]).unwrap_err();
        assert!(error.to_string().contains("axis 1"), "{error}");
    }
}
