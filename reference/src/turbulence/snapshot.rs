//! Particles at one moment, as measurements take them.

use super::error::{TurbulenceError, check_column, check_length};
use crate::domain::{Domain, separation};
use crate::engine::Engine;
use crate::fields;
use crate::particles::ParticleSet;
use etalon_kernels_gen::Vector;

/// Places, velocities and masses, checked: at least one particle, finite velocities, positive masses.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot<const D: usize> {
    domain: Domain<D>,
    coordinates: [Vec<u64>; D],
    velocity: [Vec<f64>; D],
    mass: Vec<f64>,
}

impl<const D: usize> Snapshot<D> {
    /// Takes columns, one entry a particle. Coordinates are the domain's fixed-point ones.
    ///
    /// # Errors
    /// No particles, columns of different length, a velocity that is not finite, a mass that is not positive.
    pub fn new(
        domain: Domain<D>,
        coordinates: [Vec<u64>; D],
        velocity: [Vec<f64>; D],
        mass: Vec<f64>,
    ) -> Result<Self, TurbulenceError> {
        if mass.is_empty() {
            return Err(TurbulenceError::Empty { what: "particles", least: 1 });
        }
        for axis in 0..D {
            check_length("list of coordinates", coordinates[axis].len(), mass.len())?;
            check_length("list of velocities", velocity[axis].len(), mass.len())?;
            check_column("velocities", &velocity[axis], false)?;
        }
        check_column("masses", &mass, true)?;
        Ok(Snapshot { domain, coordinates, velocity, mass })
    }

    /// The particles of an initial state.
    ///
    /// # Errors
    /// None that a checked set could cause.
    pub fn of_set(set: &ParticleSet<D>) -> Result<Self, TurbulenceError> {
        let coordinates = std::array::from_fn(|axis| set.coordinates(axis));
        let velocity = std::array::from_fn(|axis| set.particles().iter().map(|p| p.velocity[axis]).collect());
        Snapshot::new(*set.domain(), coordinates, velocity, set.particles().iter().map(|p| p.mass).collect())
    }

    /// The particles that an engine holds now.
    ///
    /// # Errors
    /// What the engine refuses, and as [`Snapshot::new`].
    pub fn of_engine<E: Engine<D>>(domain: Domain<D>, engine: &mut E) -> Result<Self, TurbulenceError> {
        let mut coordinates: [Vec<u64>; D] = std::array::from_fn(|_| Vec::new());
        for (axis, column) in coordinates.iter_mut().enumerate() {
            *column = engine.coordinates(axis)?;
        }
        let mut columns = engine.read_all(fields::VELOCITY)?.into_iter();
        let velocity = std::array::from_fn(|_| columns.next().unwrap_or_default());
        Snapshot::new(domain, coordinates, velocity, engine.read_scalar(fields::MASS)?)
    }

    /// How many particles there are; never zero.
    #[allow(clippy::len_without_is_empty)]
    pub fn len(&self) -> usize {
        self.mass.len()
    }
    /// The box.
    pub fn domain(&self) -> &Domain<D> {
        &self.domain
    }
    /// Masses, by particle.
    pub fn mass(&self) -> &[f64] {
        &self.mass
    }
    /// The fixed-point coordinates, by axis and particle.
    pub fn places(&self) -> &[Vec<u64>; D] {
        &self.coordinates
    }
    /// A particle's fixed-point coordinates.
    pub fn coordinates(&self, particle: usize) -> [u64; D] {
        std::array::from_fn(|axis| self.coordinates[axis][particle])
    }
    /// A particle's velocity.
    pub fn velocity(&self, particle: usize) -> Vector<f64, D> {
        Vector::from_fn(|axis| self.velocity[axis][particle])
    }
    /// The distance of two particles, the short way round.
    pub fn distance(&self, a: usize, b: usize) -> f64 {
        let length = self.domain.torus_length();
        let x_ab = Vector::<f64, D>::from_fn(|axis| {
            separation(self.coordinates[axis][a], self.coordinates[axis][b], length[axis])
        });
        x_ab.norm()
    }

    /// The side of the box.
    ///
    /// # Errors
    /// An axis that is not periodic, or sides of different length.
    pub(crate) fn periodic_side(&self) -> Result<f64, TurbulenceError> {
        periodic_side(&self.domain)
    }
}

/// The side of a periodic box with equal sides.
pub(crate) fn periodic_side<const D: usize>(domain: &Domain<D>) -> Result<f64, TurbulenceError> {
    let sides: [f64; D] = std::array::from_fn(|axis| domain.upper()[axis] - domain.lower()[axis]);
    let periodic = domain.periodic();
    if periodic.contains(&false) || sides.iter().any(|side| *side != sides[0]) {
        return Err(TurbulenceError::NotAPeriodicCube { sides: sides.to_vec(), periodic: periodic.to_vec() });
    }
    Ok(sides[0])
}
