//! What scenes measure on a state: sums, norms, how even it is.

use super::scene::Solution;
use super::{SceneError, State, View};
use crate::diagnostics::entropy::{ColdGas, EntropyChanges, GasColumns, entropy_changes};
use crate::domain::{Domain, separation};
use crate::engine::PlainNeighbours;
use crate::norms::l1_error;
use crate::sum::CompensatedSum;

/// One of the four fields of a [`Solution`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Compared {
    /// Density.
    Density,
    /// The velocity that the view looks at.
    Velocity,
    /// Pressure.
    Pressure,
    /// Specific internal energy.
    InternalEnergy,
}

impl State {
    fn total(&self, of: impl Fn(usize) -> f64) -> f64 {
        self.moving().map(of).collect::<CompensatedSum<f64>>().value()
    }

    /// The kinetic energy of all that moves.
    pub fn kinetic_energy(&self) -> f64 {
        (0..self.velocity.len()).map(|axis| self.kinetic_energy_along(axis)).sum()
    }

    /// The part of it that belongs to the velocity along one axis; none along an axis there is not.
    pub fn kinetic_energy_along(&self, axis: usize) -> f64 {
        self.total(|i| 0.5 * self.mass[i] * self.speed(i)[axis].powi(2))
    }

    /// The internal energy of all that moves.
    pub fn thermal_energy(&self) -> f64 {
        self.total(|i| self.mass[i] * self.internal_energy[i])
    }

    /// The angular momentum about a line along z.
    pub fn angular_momentum(&self, centre: [f64; 2]) -> f64 {
        self.total(|i| {
            let (x, v) = (self.place(i), self.speed(i));
            self.mass[i] * ((x[0] - centre[0]) * v[1] - (x[1] - centre[1]) * v[0])
        })
    }

    /// `L_1` (GS25 20) of one field against a solution, over the particles that move and lie in a range of the view's coordinate.
    ///
    /// # Errors
    /// No particle in the range; a state that is not finite.
    pub fn l1(
        &self,
        view: View,
        solution: &dyn Solution,
        what: Compared,
        range: (f64, f64),
    ) -> Result<f64, SceneError> {
        let (mut found, mut due, mut coordinates) = (Vec::new(), Vec::new(), Vec::new());
        for i in self.moving() {
            let (coordinate, velocity) = view.of(self.place(i), self.speed(i), self.position.len());
            let [density, speed, pressure, energy] = solution.at(coordinate);
            let (measured, exact) = match what {
                Compared::Density => (self.density[i], density),
                Compared::Velocity => (velocity, speed),
                Compared::Pressure => (self.pressure[i], pressure),
                Compared::InternalEnergy => (self.internal_energy[i], energy),
            };
            // Beyond the range a solution may have no finite value.
            if (range.0..=range.1).contains(&coordinate) {
                found.push(measured);
                due.push(exact);
                coordinates.push(coordinate);
            }
        }
        Ok(l1_error(&found, &due, &coordinates, range)?)
    }

    /// The mean change of `ln(u / rho^(gamma-1))` since a start (GS25 30), over the particles that move and are warmer than `floor`.
    ///
    /// # Errors
    /// States of different particles; no warm particle; a state that is not finite.
    pub fn entropy_gain(&self, start: &State, gamma_minus_one: f64, floor: f64) -> Result<f64, SceneError> {
        Ok(self.entropy_changes(start, gamma_minus_one, floor)?.mean)
    }

    /// The same, particle by particle.
    ///
    /// # Errors
    /// As [`Self::entropy_gain`].
    pub fn entropy_changes(
        &self,
        start: &State,
        gamma_minus_one: f64,
        floor: f64,
    ) -> Result<EntropyChanges, SceneError> {
        let columns = |state: &State| {
            let pick = |column: &[f64]| self.moving().filter_map(|i| column.get(i).copied()).collect::<Vec<f64>>();
            (pick(&state.internal_energy), pick(&state.density))
        };
        let ((u_0, rho_0), (u, rho)) = (columns(start), columns(self));
        let gas = |energy, density| GasColumns { energy, density };
        let cold = ColdGas::Excluded { floor };
        Ok(entropy_changes(gas(&u_0, &rho_0), gas(&u, &rho), gamma_minus_one, cold)?)
    }

    /// The root of the mean square of a number by particle, over those that move; zero where none does.
    pub fn root_mean_square(&self, of: impl Fn(usize) -> f64) -> f64 {
        let count = self.moving().count().max(1) as f64;
        (self.total(|i| of(i).powi(2)) / count).sqrt()
    }

    /// By how much a field scatters about what it should be everywhere, relative to that: the root of the mean square, over those that move.
    pub fn scatter(&self, column: &[f64], due: f64) -> f64 {
        self.root_mean_square(|i| column[i] / due - 1.0)
    }

    /// The size of a particle's velocity.
    pub fn quickness(&self, particle: usize) -> f64 {
        self.speed(particle).iter().map(|v| v * v).sum::<f64>().sqrt()
    }
}

/// The distance of each particle to the nearest other one, in a box.
pub fn nearest_distances<const D: usize>(state: &State, domain: &Domain<D>) -> Vec<f64> {
    let length = domain.torus_length();
    let at = |axis: usize| state.position[axis].iter().map(|&x| domain.encode(axis, x)).collect::<Vec<u64>>();
    let coordinates: [Vec<u64>; D] = std::array::from_fn(at);
    let distance = |a: usize, b: usize| {
        let squares = (0..D).map(|axis| separation(coordinates[axis][a], coordinates[axis][b], length[axis]).powi(2));
        squares.sum::<f64>().sqrt()
    };
    // The nearest is within a support, which has neighbours by the way smoothing lengths are found.
    let shortest = length.iter().copied().fold(f64::INFINITY, f64::min);
    let reach: Vec<f64> = state.smoothing_length.iter().map(|h| (2.0 * h).min(0.5 * shortest)).collect();
    let neighbours = PlainNeighbours::find(&coordinates, &reach, length);
    let nearest = |a: usize| neighbours.of(a).iter().map(|&b| distance(a, b as usize)).fold(f64::INFINITY, f64::min);
    (0..state.len()).map(|a| nearest(a).min(reach[a])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two particles of mass 2 that circle the origin in opposite places, and a wall.
    fn pair() -> State {
        State {
            time: 0.0,
            position: vec![vec![1.0, -1.0, 9.0], vec![0.0, 0.0, 9.0]],
            velocity: vec![vec![0.0, 0.0, 5.0], vec![3.0, -3.0, 5.0]],
            density: vec![1.0, 2.0, 7.0],
            pressure: vec![1.0; 3],
            internal_energy: vec![0.5, 1.5, 7.0],
            smoothing_length: vec![0.1; 3],
            mass: vec![2.0; 3],
            mobility: vec![1.0, 1.0, 0.0],
            species: Vec::new(),
            further: Vec::new(),
        }
    }

    #[test]
    fn sums_are_over_what_moves() {
        let state = pair();
        assert_eq!(state.kinetic_energy(), 18.0);
        assert_eq!(state.kinetic_energy_along(0), 0.0);
        assert_eq!(state.thermal_energy(), 4.0);
        assert_eq!(state.angular_momentum([0.0; 2]), 12.0);
        assert_eq!(state.scatter(&state.density, 1.0), 0.5_f64.sqrt());
        assert_eq!(state.quickness(1), 3.0);
    }

    #[test]
    fn the_nearest_is_found_around_the_box() {
        let mut state = pair();
        state.position = vec![vec![0.05, 0.99, 0.5], vec![0.5; 3]];
        state.smoothing_length = vec![0.2; 3];
        let domain = Domain::new([0.0; 2], [1.0; 2], [true; 2]).unwrap();
        let found = nearest_distances(&state, &domain);
        // Places are on a grid of 2^-32. The third has nobody within its reach of 0.4.
        for (found, due) in found.iter().zip([0.06, 0.06, 0.4]) {
            assert!((found - due).abs() < 1e-9, "{found} where {due} is due");
        }
    }

    struct Still;
    impl Solution for Still {
        fn at(&self, coordinate: f64) -> [f64; 4] {
            [1.0, coordinate, 1.0, 1.0]
        }
    }

    #[test]
    fn errors_are_of_the_field_asked_for() {
        let state = pair();
        let l1 = |what, range| state.l1(View::Azimuth([0.0; 2]), &Still, what, range);
        assert_eq!(l1(Compared::Velocity, (0.0, 2.0)).unwrap(), 2.0);
        assert_eq!(l1(Compared::Density, (0.0, 2.0)).unwrap(), 0.5);
        assert!(l1(Compared::Density, (2.0, 3.0)).unwrap_err().to_string().contains("widen the range"));
    }

    #[test]
    fn entropy_is_gained_by_heat_and_not_by_compression() {
        let start = pair();
        let mut hot = pair();
        hot.internal_energy = vec![1.0, 3.0, 7.0];
        assert!((hot.entropy_gain(&start, 0.4, 0.0).unwrap() - 2.0_f64.ln()).abs() < 1e-14);
        let mut squeezed = pair();
        for i in 0..2 {
            squeezed.density[i] *= 3.0;
            squeezed.internal_energy[i] *= 3.0_f64.powf(0.4);
        }
        // A power, a logarithm, a few roundings each.
        assert!(squeezed.entropy_gain(&start, 0.4, 0.0).unwrap().abs() < 1e-14);
    }
}
