//! Boxes filled evenly, on a lattice or with copies of a glass.

use super::scene::Glasses;
use super::{Arrangement, Method, SceneError};

/// Particles across a glass that is tiled, by dimension: enough that its supports do not meet themselves while it is relaxed.
const GLASS_ACROSS: [usize; 3] = [64, 24, 12];
/// A periodic side must be so many times a support's diameter: smoothing lengths grow a little where a gas is stirred.
const LATTICE_ROOM: f64 = 1.2;
/// The same while a glass is relaxed, where smoothing lengths overshoot: by 1.3 at most, as found.
const GLASS_ROOM: f64 = 1.35;

/// A box to be filled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block<const D: usize> {
    /// Its lower corner.
    pub lower: [f64; D],
    /// Its upper corner.
    pub upper: [f64; D],
}

/// Places that fill a block evenly.
#[derive(Clone, Debug, PartialEq)]
pub struct Filling<const D: usize> {
    /// The places.
    pub places: Vec<[f64; D]>,
    /// The volume that belongs to each.
    pub volume: f64,
}

impl<const D: usize> Block<D> {
    /// Its sides.
    pub fn sides(&self) -> [f64; D] {
        std::array::from_fn(|axis| self.upper[axis] - self.lower[axis])
    }
    /// Its volume.
    pub fn volume(&self) -> f64 {
        self.sides().iter().product()
    }

    /// How many particles lie along each side, if there are about `count` and they are to be as far apart along one axis as along another.
    fn rows(&self, count: usize) -> [usize; D] {
        let spacing = (self.volume() / count as f64).powf(1.0 / D as f64);
        self.sides().map(|side| ((side / spacing).round() as usize).max(1))
    }

    /// A lattice of about `count` places whose cells fill the block exactly, in the order of x, then y, then z.
    pub fn lattice(&self, count: usize) -> Filling<D> {
        let rows = self.rows(count);
        let sides = self.sides();
        let total: usize = rows.iter().product();
        let place = |number: usize| {
            let mut rest = number;
            std::array::from_fn(|axis| {
                let row = rest % rows[axis];
                rest /= rows[axis];
                self.lower[axis] + (row as f64 + 0.5) / rows[axis] as f64 * sides[axis]
            })
        };
        Filling { places: (0..total).map(place).collect(), volume: self.volume() / total as f64 }
    }

    /// How many particles a glass for this block has across, and how many copies of it fit along each side.
    fn tiles(&self, count: usize) -> (usize, [usize; D]) {
        let rows = self.rows(count);
        let across = rows.iter().copied().min().unwrap_or(1).min(GLASS_ACROSS[D - 1]);
        (across, rows.map(|n| ((n as f64 / across as f64).round() as usize).max(1)))
    }

    /// The block filled as the method says. `glasses` is asked for a glass if the method wants one.
    pub fn filled(&self, method: &Method, count: usize, glasses: &mut Glasses<D>) -> Result<Filling<D>, SceneError> {
        if method.arrangement == Arrangement::Lattice {
            return Ok(self.lattice(count));
        }
        let (across, copies) = self.tiles(count);
        let glass = glasses(across)?;
        let sides = self.sides();
        let total: usize = copies.iter().product();
        let tile = |number: usize| -> [usize; D] {
            let mut rest = number;
            std::array::from_fn(|axis| {
                let row = rest % copies[axis];
                rest /= copies[axis];
                row
            })
        };
        let places = (0..total).flat_map(|number| {
            let tile = tile(number);
            glass.iter().map(move |point| {
                std::array::from_fn(|axis| {
                    self.lower[axis] + (tile[axis] as f64 + point[axis]) / copies[axis] as f64 * sides[axis]
                })
            })
        });
        let places: Vec<[f64; D]> = places.collect();
        let volume = self.volume() / places.len() as f64;
        Ok(Filling { places, volume })
    }

    /// Whether so many particles leave supports room along the sides that are periodic. The widest support belongs to particles that are
    /// `thinnest` times as voluminous as those of an even filling.
    pub fn has_room(&self, method: &Method, periodic: [bool; D], count: usize, thinnest: f64) -> bool {
        let volume = self.volume() / count as f64 * thinnest;
        let room = match method.arrangement {
            Arrangement::Lattice => LATTICE_ROOM,
            Arrangement::Glass => GLASS_ROOM,
        };
        let diameter = 2.0 * method.reach(D, volume) * room;
        let (across, _) = self.tiles(count);
        // A glass is relaxed in a box of its own.
        let glass_fits = method.arrangement == Arrangement::Lattice
            || 2.0 * method.reach(D, (across as f64).powi(-(D as i32))) * room <= 1.0;
        glass_fits && self.sides().iter().zip(periodic).all(|(side, periodic)| !periodic || diameter <= *side)
    }

    /// Refuses too few particles, naming a number that is enough.
    pub fn check_room(
        &self,
        method: &Method,
        periodic: [bool; D],
        least: usize,
        thinnest: f64,
    ) -> Result<(), SceneError> {
        method.check_number(D, least, |count| self.has_room(method, periodic, count, thinnest))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A lattice of `across^D` in the unit cube, as a glass would be given.
    fn regular<const D: usize>(across: usize) -> Vec<[f64; D]> {
        let place = |i: usize| {
            std::array::from_fn(|axis| ((i / across.pow(axis as u32) % across) as f64 + 0.5) / across as f64)
        };
        (0..across.pow(D as u32)).map(place).collect()
    }

    fn fills<const D: usize>(arrangement: Arrangement) {
        let lower = std::array::from_fn(|axis| -0.5 + axis as f64);
        let block = Block { lower, upper: std::array::from_fn(|axis| lower[axis] + [2.0, 1.0, 0.5][axis]) };
        let method = Method { arrangement, ..Method::standard(D, 9000) };
        let filling = block.filled(&method, 9000, &mut |across| Ok(regular(across))).unwrap();
        let total = filling.volume * filling.places.len() as f64;
        assert!((total / block.volume() - 1.0).abs() < 1e-12, "{D}-D {arrangement:?}: volume {total}");
        // A row more or less along each axis.
        let share = filling.places.len() as f64 / 9000.0;
        assert!((0.7..1.4).contains(&share), "{D}-D {arrangement:?}: {} places", filling.places.len());
        let inside = |p: &[f64; D]| (0..D).all(|axis| p[axis] > block.lower[axis] && p[axis] < block.upper[axis]);
        assert!(filling.places.iter().all(inside));
        let mut keys: Vec<_> = filling.places.iter().map(|p| p.map(f64::to_bits)).collect();
        keys.sort_unstable();
        keys.dedup();
        assert_eq!(keys.len(), filling.places.len(), "{D}-D {arrangement:?}: places coincide");
    }

    #[test]
    fn fillings_are_even_inside_and_without_coincidence() {
        for arrangement in [Arrangement::Lattice, Arrangement::Glass] {
            fills::<1>(arrangement);
            fills::<2>(arrangement);
            fills::<3>(arrangement);
        }
    }

    #[test]
    fn a_refusal_names_a_number_that_works() {
        let block = Block { lower: [0.0; 2], upper: [1.0, 0.25] };
        for arrangement in [Arrangement::Lattice, Arrangement::Glass] {
            let mut method = Method { arrangement, ..Method::standard(2, 50) };
            let error = block.check_room(&method, [true; 2], 1, 2.0).unwrap_err();
            let SceneError::TooFew { enough, .. } = error else { panic!("{error}") };
            method.particles = enough;
            assert!(block.check_room(&method, [true; 2], 1, 2.0).is_ok(), "{enough}");
        }
        let method = Method::standard(2, 50);
        assert!(block.check_room(&method, [false; 2], 1, 2.0).is_ok(), "an open box has room");
    }
}
