//! What a simulation holds at one moment, as plain columns.

use super::{Scene, SceneError, View};
use crate::domain::Domain;
use crate::engine::{Engine, EngineError};
use crate::fields;
use etalon_kernels_gen::{Component, Field};

/// All particles at one moment, in their original order.
#[derive(Clone, Debug)]
pub struct State {
    /// The time.
    pub time: f64,
    /// Positions, axis by axis.
    pub position: Vec<Vec<f64>>,
    /// Velocities, axis by axis.
    pub velocity: Vec<Vec<f64>>,
    /// Density.
    pub density: Vec<f64>,
    /// Pressure.
    pub pressure: Vec<f64>,
    /// Specific internal energy.
    pub internal_energy: Vec<f64>,
    /// Smoothing length.
    pub smoothing_length: Vec<f64>,
    /// Mass.
    pub mass: Vec<f64>,
    /// One where a particle moves, zero in a wall.
    pub mobility: Vec<f64>,
    /// Zero for gas, one for dust; empty where there is gas only.
    pub species: Vec<f64>,
    /// What a scene asks for besides; empty for most.
    pub further: Vec<(Field, Vec<f64>)>,
}

impl State {
    /// Reads it from an engine that has run a step's passes.
    pub fn read<const D: usize, E: Engine<D>>(
        engine: &mut E,
        domain: &Domain<D>,
        time: f64,
    ) -> Result<Self, EngineError> {
        let position = |axis: usize, engine: &mut E| -> Result<Vec<f64>, EngineError> {
            Ok(engine.coordinates(axis)?.into_iter().map(|c| domain.decode(axis, c)).collect())
        };
        Ok(State {
            time,
            position: (0..D).map(|axis| position(axis, engine)).collect::<Result<_, _>>()?,
            velocity: engine.read_all(fields::VELOCITY)?,
            density: engine.read_scalar(fields::DENSITY)?,
            pressure: engine.read_scalar(fields::PRESSURE)?,
            internal_energy: engine.read_scalar(fields::INTERNAL_ENERGY)?,
            smoothing_length: engine.read_scalar(fields::SMOOTHING_LENGTH)?,
            mass: engine.read_scalar(fields::MASS)?,
            mobility: engine.read_scalar(fields::MOBILITY)?,
            // An engine that was made without the field has none to read.
            species: engine.read_scalar(fields::SPECIES).unwrap_or_default(),
            further: Vec::new(),
        })
    }

    /// The same with what a scene asks for besides.
    pub fn read_for<const D: usize, E: Engine<D>>(
        scene: &dyn Scene<D>,
        engine: &mut E,
        domain: &Domain<D>,
        time: f64,
    ) -> Result<Self, EngineError> {
        let mut state = Self::read(engine, domain, time)?;
        for &field in scene.further_fields() {
            state.further.push((field, engine.read_scalar(field)?));
        }
        Ok(state)
    }

    /// A field that a scene asked for.
    ///
    /// # Errors
    /// It was not read.
    pub fn further(&self, field: Field) -> Result<&[f64], SceneError> {
        let found = self.further.iter().find(|(of, _)| *of == field);
        found.map(|(_, column)| column.as_slice()).ok_or(SceneError::Unread { field: field.name })
    }

    /// How many particles there are.
    pub fn len(&self) -> usize {
        self.mass.len()
    }
    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.mass.is_empty()
    }
    /// The numbers of those that move.
    pub fn moving(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.len()).filter(|&i| self.mobility[i] > 0.0)
    }
    /// The numbers of the gas that moves.
    pub fn moving_gas(&self) -> impl Iterator<Item = usize> + '_ {
        self.moving().filter(|&i| self.species.get(i).is_none_or(|species| *species < 0.5))
    }
    /// Where a particle is; zero along axes there are not.
    pub fn place(&self, particle: usize) -> [f64; 3] {
        padded(&self.position, particle)
    }
    /// How fast a particle goes; zero along axes there are not.
    pub fn speed(&self, particle: usize) -> [f64; 3] {
        padded(&self.velocity, particle)
    }

    /// Coordinates and velocities of all particles as a view has them.
    pub fn seen(&self, view: View) -> (Vec<f64>, Vec<f64>) {
        (0..self.len()).map(|i| view.of(self.place(i), self.speed(i), self.position.len())).unzip()
    }
}

fn padded(columns: &[Vec<f64>], particle: usize) -> [f64; 3] {
    std::array::from_fn(|axis| columns.get(axis).map_or(0.0, |column| column[particle]))
}

/// Sums over the particles that move.
#[derive(Clone, Debug, PartialEq)]
pub struct Totals {
    /// Mass.
    pub mass: f64,
    /// Momentum, axis by axis.
    pub momentum: Vec<f64>,
    /// The sum of `m |v|`: what a drift of momentum is measured in.
    pub momentum_magnitude: f64,
    /// Kinetic and internal energy.
    pub energy: f64,
}

impl Totals {
    /// Reads and adds.
    pub fn read<const D: usize, E: Engine<D>>(engine: &mut E, mobile: &[bool]) -> Result<Self, EngineError> {
        let mass = engine.read(Component { field: fields::MASS, index: 0 })?;
        let energy = engine.read_scalar(fields::INTERNAL_ENERGY)?;
        let velocity = engine.read_all(fields::VELOCITY)?;
        let mut totals = Totals { mass: 0.0, momentum: vec![0.0; D], momentum_magnitude: 0.0, energy: 0.0 };
        for i in (0..mass.len()).filter(|&i| mobile[i]) {
            let squared: f64 = velocity.iter().map(|column| column[i] * column[i]).sum();
            totals.mass += mass[i];
            totals.energy += mass[i] * (0.5 * squared + energy[i]);
            totals.momentum_magnitude += mass[i] * squared.sqrt();
            for (sum, column) in totals.momentum.iter_mut().zip(&velocity) {
                *sum += mass[i] * column[i];
            }
        }
        Ok(totals)
    }
}
