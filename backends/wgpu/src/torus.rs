//! The torus on which positions are fixed-point fractions.

use crate::{Error, Result};

/// The number of units round the torus.
const UNITS: f64 = etalon_reference::domain::SINGLE_PLACES;

/// A periodic box of 1, 2 or 3 axes, on which a coordinate is an unsigned 32-bit fraction of the axis' length.
///
/// Differences of coordinates wrap as the torus does, so the separation of two points is exact up to one conversion to a
/// float and one multiplication, and is the shorter way round. An axis that is not periodic is laid on a torus at least
/// twice as long as the particles need, so that nothing meets itself round the back.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Torus {
    dimension: usize,
    lengths: [f64; 3],
}

impl Torus {
    /// A torus of the given axis lengths (1 to 3 of them, in the unit of the scene).
    ///
    /// # Errors
    /// [`Error::BadTorus`] unless every length is within 1e-15 to 1e15: beyond, squares of separations leave the range of f32.
    pub fn new(lengths: &[f64]) -> Result<Self> {
        let usable = (1..=3).contains(&lengths.len()) && lengths.iter().all(|length| (1e-15..=1e15).contains(length));
        if !usable {
            return Err(Error::BadTorus { lengths: lengths.to_vec() });
        }
        let mut all = [1.0; 3];
        all[..lengths.len()].copy_from_slice(lengths);
        Ok(Self { dimension: lengths.len(), lengths: all })
    }

    /// Number of axes, 1 to 3.
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// The axes' lengths.
    pub fn lengths(&self) -> &[f64] {
        &self.lengths[..self.dimension]
    }

    /// The length of one coordinate unit along each axis, length / 2^32, rounded once to f32; zero beyond the dimension.
    pub fn length_per_unit(&self) -> [f32; 3] {
        self.per_axis(|length| length / UNITS)
    }

    /// Coordinate units in a length of one along each axis, 2^32 / length, rounded once to f32; zero beyond the dimension.
    pub fn units_per_length(&self) -> [f32; 3] {
        self.per_axis(|length| UNITS / length)
    }

    /// Half of each axis' length as f32; zero beyond the dimension.
    pub fn half_length(&self) -> [f32; 3] {
        self.per_axis(|length| 0.5 * length)
    }

    /// The separation a - b along an axis, the shorter way round, in the arithmetic of the kernels:
    /// `f32(i32(a - b)) * length_per_unit`.
    ///
    /// Where a and b are exactly half the torus apart the sign is negative for both orders.
    pub fn separation(&self, axis: usize, a: u32, b: u32) -> f32 {
        a.wrapping_sub(b).cast_signed() as f32 * self.length_per_unit()[axis]
    }

    fn per_axis(&self, value: impl Fn(f64) -> f64) -> [f32; 3] {
        let mut all = [0.0; 3];
        for (slot, length) in all.iter_mut().zip(self.lengths()) {
            *slot = value(*length) as f32;
        }
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn separations_wrap_the_shorter_way() {
        let torus = Torus::new(&[2.0, 8.0]).unwrap();
        assert_eq!(torus.separation(0, 1 << 30, 0), 0.5);
        assert_eq!(torus.separation(1, 0, 3 << 30), 2.0);
        assert_eq!(torus.separation(1, 3 << 30, 0), -2.0);
        // Half-way round: i32::MIN both ways.
        assert_eq!(torus.separation(0, 1 << 31, 0), -1.0);
        assert_eq!(torus.separation(0, 0, 1 << 31), -1.0);
    }

    #[test]
    fn impossible_tori_are_refused() {
        for lengths in [&[][..], &[1.0; 4], &[0.0], &[-1.0], &[f64::NAN], &[1.0, f64::INFINITY], &[1e-16]] {
            assert!(matches!(Torus::new(lengths), Err(Error::BadTorus { .. })), "{lengths:?}");
        }
    }
}
