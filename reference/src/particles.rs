//! Particles as scenes make them and engines take them.

use crate::domain::{Domain, DomainError};

/// Why a set of particles cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ParticleError {
    /// A number is not finite, or not positive where it must be.
    #[error("particle {particle} has {field} = {value}; {rule}")]
    Value {
        /// Which particle, from 0.
        particle: usize,
        /// Which field.
        field: &'static str,
        /// What it has.
        value: f64,
        /// What is allowed.
        rule: &'static str,
    },
    /// Columns of different length.
    #[error("field {field} has {found} entries for {expected} particles")]
    Length {
        /// Which field.
        field: &'static str,
        /// How many entries it has.
        found: usize,
        /// How many it should have.
        expected: usize,
    },
    /// No particles at all.
    #[error("the scene has no particles; ask for at least one")]
    Empty,
    /// A particle outside its box.
    #[error(transparent)]
    Domain(#[from] DomainError),
}

/// One particle of an initial state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Particle<const D: usize> {
    /// Where it is.
    pub position: [f64; D],
    /// How fast it goes.
    pub velocity: [f64; D],
    /// Mass.
    pub mass: f64,
    /// Smoothing length.
    pub smoothing_length: f64,
    /// Specific internal energy.
    pub internal_energy: f64,
    /// Whether it moves; wall particles do not.
    pub mobile: bool,
}

/// A box with particles in it, checked.
#[derive(Clone, Debug, PartialEq)]
pub struct ParticleSet<const D: usize> {
    domain: Domain<D>,
    particles: Vec<Particle<D>>,
}

impl<const D: usize> ParticleSet<D> {
    /// Takes particles that are inside the box and have finite values, positive masses and smoothing lengths, and no negative energies.
    pub fn new(domain: Domain<D>, particles: Vec<Particle<D>>) -> Result<Self, ParticleError> {
        if particles.is_empty() {
            return Err(ParticleError::Empty);
        }
        for (i, p) in particles.iter().enumerate() {
            let bad = |field, value, rule| Err(ParticleError::Value { particle: i, field, value, rule });
            if !(p.mass.is_finite() && p.mass > 0.0) {
                return bad("mass", p.mass, "it must be finite and positive");
            }
            if !(p.smoothing_length.is_finite() && p.smoothing_length > 0.0) {
                return bad("smoothing_length", p.smoothing_length, "it must be finite and positive");
            }
            if !(p.internal_energy.is_finite() && p.internal_energy >= 0.0) {
                return bad("internal_energy", p.internal_energy, "it must be finite and not negative");
            }
            for axis in 0..D {
                let (x, v) = (p.position[axis], p.velocity[axis]);
                if !v.is_finite() {
                    return bad("velocity", v, "it must be finite");
                }
                let (lower, upper) = (domain.lower()[axis], domain.upper()[axis]);
                if !(x >= lower && x <= upper) {
                    return Err(DomainError::Outside { particle: i, axis, value: x, lower, upper }.into());
                }
            }
        }
        Ok(ParticleSet { domain, particles })
    }

    /// The box.
    pub fn domain(&self) -> &Domain<D> {
        &self.domain
    }
    /// The particles, in the order that gives them their numbers.
    pub fn particles(&self) -> &[Particle<D>] {
        &self.particles
    }
    /// How many there are; never zero.
    #[allow(clippy::len_without_is_empty)]
    pub fn len(&self) -> usize {
        self.particles.len()
    }
    /// The fixed-point coordinates along one axis.
    pub fn coordinates(&self, axis: usize) -> Vec<u64> {
        self.particles.iter().map(|p| self.domain.encode(axis, p.position[axis])).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn particle() -> Particle<1> {
        Particle {
            position: [0.5],
            velocity: [0.0],
            mass: 1.0,
            smoothing_length: 0.1,
            internal_energy: 1.0,
            mobile: true,
        }
    }

    #[test]
    fn each_bad_value_is_named_with_its_particle() {
        let domain = Domain::new([0.0], [1.0], [true]).unwrap();
        let cases = [
            (Particle { mass: f64::NAN, ..particle() }, "mass"),
            (Particle { smoothing_length: 0.0, ..particle() }, "smoothing_length"),
            (Particle { internal_energy: -1.0, ..particle() }, "internal_energy"),
            (Particle { velocity: [f64::INFINITY], ..particle() }, "velocity"),
            (Particle { position: [f64::NAN], ..particle() }, "outside the box"),
        ];
        for (bad, expected) in cases {
            let error = ParticleSet::new(domain, vec![particle(), bad]).unwrap_err().to_string();
            assert!(error.contains(expected) && error.contains("particle 1"), "{error}");
        }
        assert_eq!(ParticleSet::new(domain, vec![]).unwrap_err(), ParticleError::Empty);
    }
}
