//! Noh's implosion: cold gas that falls onto a point, a line or a plane at unit speed, and is stopped by a shock that grows from there.

use super::radial::{self, RadialError};
use super::riemann::State;

/// The implosion of gas of even density, checked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Noh {
    dimension: usize,
    gamma: f64,
    density: f64,
    speed: f64,
}

impl Noh {
    /// Gas of this density that falls inwards at this speed everywhere.
    ///
    /// # Errors
    /// Dimensions other than 1 to 3; an index not above 1; a density or speed that is not finite and positive.
    pub fn new(dimension: usize, gamma: f64, density: f64, speed: f64) -> Result<Self, RadialError> {
        radial::check(dimension, &[("density", density), ("speed", speed)])?;
        if !(gamma > 1.0 && gamma.is_finite()) {
            return Err(RadialError::Gamma { gamma, allowed: "above 1" });
        }
        Ok(Noh { dimension, gamma, density, speed })
    }

    /// Where the shock is at time `t`: it goes outwards at $\frac{\gamma-1}{2} v$.
    pub fn shock_radius(&self, t: f64) -> f64 {
        0.5 * (self.gamma - 1.0) * self.speed * t
    }

    /// Density, radial velocity and pressure at distance `r` and time `t`; at the shock those behind it.
    ///
    /// Behind the shock the gas rests, with all its motion turned to heat ($u = v^2/2$) and
    /// $\rho = \rho_0 (\frac{\gamma+1}{\gamma-1})^\nu$; before it, it is crowded by its own convergence, $\rho = \rho_0 (1 + v t/r)^{\nu-1}$.
    /// Source: Noh 1987, section 3.
    pub fn at(&self, r: f64, t: f64) -> State<f64> {
        if r > self.shock_radius(t) {
            let crowded = (1.0 + self.speed * t / r).powi(self.dimension as i32 - 1);
            return State { density: self.density * crowded, velocity: -self.speed, pressure: 0.0 };
        }
        let gamma = self.gamma;
        let density = self.density * ((gamma + 1.0) / (gamma - 1.0)).powi(self.dimension as i32);
        State { density, velocity: 0.0, pressure: 0.5 * (gamma - 1.0) * density * self.speed * self.speed }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The plateaus for gamma = 5/3 that the literature quotes: 4, 16, 64, within a shock at t/3.
    #[test]
    fn plateaus_are_four_to_the_dimension() {
        for dimension in 1..=3 {
            let noh = Noh::new(dimension, 5.0 / 3.0, 1.0, 1.0).unwrap();
            let inside = noh.at(0.1, 0.6);
            assert!((noh.shock_radius(0.6) - 0.2).abs() < 1e-15);
            assert!((inside.density / 4_f64.powi(dimension as i32) - 1.0).abs() < 1e-14, "{inside:?}");
            assert!((inside.pressure / (inside.density / 3.0) - 1.0).abs() < 1e-14, "{inside:?}");
            assert_eq!(inside.velocity, 0.0);
        }
    }

    /// What the shock has swept is what is inside; and mass, momentum and energy go through it unchanged.
    #[test]
    fn shock_keeps_mass_momentum_and_energy() {
        for dimension in 1..=3 {
            let (gamma, density, speed) = (1.4, 0.7, 2.5);
            let noh = Noh::new(dimension, gamma, density, speed).unwrap();
            let (t, radius) = (0.8, noh.shock_radius(0.8));
            let (inner, outer) = (noh.at(radius, t), noh.at(radius * (1.0 + 1e-13), t));
            let front = radius / t;
            let flux = |s: State<f64>| {
                let relative = s.velocity - front;
                let energy = 0.5 * s.density * s.velocity * s.velocity + s.pressure / (gamma - 1.0);
                [
                    s.density * relative,
                    s.density * s.velocity * relative + s.pressure,
                    energy * relative + s.pressure * s.velocity,
                ]
            };
            for (a, b) in flux(inner).into_iter().zip(flux(outer)) {
                assert!((a - b).abs() <= 1e-11 * a.abs(), "{dimension}-D: {a} inside, {b} outside");
            }
            // All that began within r + v t has arrived within r.
            let began = (radius + speed * t).powi(dimension as i32) * density;
            let inside = inner.density * radius.powi(dimension as i32);
            assert!((inside / began - 1.0).abs() < 1e-13, "{dimension}-D: {inside} inside of {began}");
        }
    }

    #[test]
    fn what_is_no_implosion_is_refused() {
        assert!(Noh::new(0, 1.4, 1.0, 1.0).is_err());
        assert!(Noh::new(3, 1.0, 1.0, 1.0).is_err());
        let message = Noh::new(3, 1.4, 1.0, -1.0).unwrap_err().to_string();
        assert!(message.contains("speed is -1"), "{message}");
    }
}
