//! What a simulation holds at one moment, as plain columns.

use etalon_kernels_gen::Component;
use etalon_reference::domain::Domain;
use etalon_reference::engine::{Engine, EngineError};
use etalon_reference::fields;

/// The fields that are compared, in the order in which they are shown.
pub const COMPARED: [&str; 4] = ["density", "velocity_x", "pressure", "internal_energy"];

/// All particles at one moment, in their original order.
#[derive(Clone, Debug)]
pub struct State {
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
}

impl State {
    /// Reads it from an engine.
    pub fn read<const D: usize, E: Engine<D>>(engine: &mut E, domain: &Domain<D>) -> Result<Self, EngineError> {
        let position = |axis: usize, engine: &mut E| -> Result<Vec<f64>, EngineError> {
            Ok(engine.coordinates(axis)?.into_iter().map(|c| domain.decode(axis, c)).collect())
        };
        Ok(State {
            position: (0..D).map(|axis| position(axis, engine)).collect::<Result<_, _>>()?,
            velocity: engine.read_all(fields::VELOCITY)?,
            density: engine.read_scalar(fields::DENSITY)?,
            pressure: engine.read_scalar(fields::PRESSURE)?,
            internal_energy: engine.read_scalar(fields::INTERNAL_ENERGY)?,
            smoothing_length: engine.read_scalar(fields::SMOOTHING_LENGTH)?,
        })
    }

    /// The compared fields, in the order of [`COMPARED`].
    pub fn compared(&self) -> [&[f64]; 4] {
        [&self.density, &self.velocity[0], &self.pressure, &self.internal_energy]
    }
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
