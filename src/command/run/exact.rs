//! The exact solution of the tube, where and how the report wants it.

use super::state::COMPARED;
use crate::command::failure::Failure;
use crate::command::setup::Setup;
use crate::report::model::{Curve, CurveField};
use etalon_reference::exact::riemann::{RiemannProblem, Wave};
use etalon_reference::scenes::sod;

/// The exact solution at the end time.
pub struct Exact {
    problem: RiemannProblem<f64>,
    end_time: f64,
    gamma_minus_one: f64,
}

impl Exact {
    /// Of a settled scene.
    pub fn new(setup: &Setup) -> Result<Self, Failure> {
        Ok(Exact { problem: setup.sod.exact()?, end_time: setup.end_time, gamma_minus_one: setup.sod.gamma - 1.0 })
    }

    /// Density, velocity, pressure and internal energy at a place.
    pub fn at(&self, x: f64) -> [f64; 4] {
        self.along((x - sod::INTERFACE) / self.end_time)
    }

    fn along(&self, xi: f64) -> [f64; 4] {
        let state = self.problem.sample(xi);
        let energy = state.pressure / (self.gamma_minus_one * state.density);
        [state.density, state.velocity, state.pressure, energy]
    }

    /// The four fields at many places, field by field.
    pub fn columns(&self, places: &[f64]) -> [Vec<f64>; 4] {
        let rows: Vec<[f64; 4]> = places.iter().map(|&x| self.at(x)).collect();
        std::array::from_fn(|k| rows.iter().map(|row| row[k]).collect())
    }

    /// The solution as a line from 0 to 1: evenly, with the edges of the fan, and both sides of each jump.
    pub fn curve(&self) -> Curve {
        const SAMPLES: u32 = 400;
        let place = |speed: f64| sod::INTERFACE + speed * self.end_time;
        let mut jumps: Vec<f64> = self.problem.contact().into_iter().collect();
        let mut edges = Vec::new();
        for wave in [self.problem.left_wave(), self.problem.right_wave()].into_iter().flatten() {
            match wave {
                Wave::Shock { speed } => jumps.push(speed),
                Wave::Rarefaction { head, tail } => edges.extend([head, tail]),
            }
        }
        let mut points: Vec<(f64, [f64; 4])> = (0..=SAMPLES)
            .map(|i| f64::from(i) / f64::from(SAMPLES))
            .chain(edges.into_iter().map(place))
            .map(|x| (x, self.at(x)))
            .collect();
        for speed in jumps {
            // At a jump a sample is that of its left side.
            points.extend([(place(speed), self.along(speed)), (place(speed), self.along(speed.next_up()))]);
        }
        points.retain(|(x, _)| (0.0..=1.0).contains(x));
        // Stable: left of a jump stays before right of it.
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        let field = |k: usize| CurveField {
            field: COMPARED[k].into(),
            value: points.iter().map(|(_, values)| values[k]).collect(),
        };
        Curve { x: points.iter().map(|(x, _)| *x).collect(), fields: (0..4).map(field).collect() }
    }
}
