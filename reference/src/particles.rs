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
    /// A particle of dust with what only gas has.
    #[error("particle {particle} is dust and has internal_energy = {value}; dust has no pressure, so give it 0")]
    WarmDust {
        /// Which particle, from 0.
        particle: usize,
        /// Its internal energy.
        value: f64,
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
    dust: Option<Vec<bool>>,
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
        Ok(ParticleSet { domain, particles, dust: None })
    }

    /// The same particles, of two species: for each whether it is dust. To be run with [`Physics::drag`](crate::passes::Physics::drag); a physics
    /// without has one species only.
    ///
    /// # Errors
    /// Another number of entries than particles, or dust with an internal energy.
    pub fn with_dust(self, dust: Vec<bool>) -> Result<Self, ParticleError> {
        if dust.len() != self.particles.len() {
            let (found, expected) = (dust.len(), self.particles.len());
            return Err(ParticleError::Length { field: "species", found, expected });
        }
        let warm = |(p, is_dust): (&Particle<D>, &bool)| *is_dust && p.internal_energy != 0.0;
        if let Some(particle) = self.particles.iter().zip(&dust).position(warm) {
            return Err(ParticleError::WarmDust { particle, value: self.particles[particle].internal_energy });
        }
        Ok(ParticleSet { dust: Some(dust), ..self })
    }

    /// The box.
    pub fn domain(&self) -> &Domain<D> {
        &self.domain
    }
    /// The particles, in the order that gives them their numbers.
    pub fn particles(&self) -> &[Particle<D>] {
        &self.particles
    }
    /// For each whether it is dust, if the set was given two species.
    pub fn dust(&self) -> Option<&[bool]> {
        self.dust.as_deref()
    }
    /// The value of the field [`SPECIES`](crate::fields::SPECIES) for a particle: one if it is dust, else zero.
    pub fn species(&self, particle: usize) -> f64 {
        match &self.dust {
            Some(dust) if dust[particle] => 1.0,
            _ => 0.0,
        }
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
    fn dust_is_cold_and_every_particle_has_a_species() {
        let domain = Domain::new([0.0], [1.0], [true]).unwrap();
        let set = ParticleSet::new(domain, vec![particle(), Particle { internal_energy: 0.0, ..particle() }]).unwrap();
        assert_eq!((set.dust(), set.species(1)), (None, 0.0));
        let mixed = set.clone().with_dust(vec![false, true]).unwrap();
        assert_eq!((mixed.species(0), mixed.species(1)), (0.0, 1.0));
        let warm = set.clone().with_dust(vec![true, true]).unwrap_err();
        assert_eq!(warm, ParticleError::WarmDust { particle: 0, value: 1.0 });
        assert!(warm.to_string().contains("give it 0"), "{warm}");
        let error = set.with_dust(vec![true]).unwrap_err().to_string();
        assert!(error.contains("species has 1 entries for 2"), "{error}");
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
