//! One side of the problem, as if it were the left one: its wave runs towards negative x.

use super::{State, Wave};
use num_traits::Float;

/// A state, and what becomes of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Side<F> {
    pub(super) state: State<F>,
    pub(super) gamma: F,
    /// c = sqrt(gamma p / rho), 0 in vacuum.
    pub(super) sound_speed: F,
    /// What follows behind the wave; vacuum until the side has met the other one.
    behind: State<F>,
    /// Head and tail of a fan, or twice the speed of a shock.
    edges: (F, F),
    shocked: bool,
}

impl<F: Float> Side<F> {
    /// A side that expands into vacuum.
    pub(super) fn new(state: State<F>, gamma: F) -> Self {
        let cold = state.pressure.is_zero();
        // Roots first: neither gamma p nor p / rho need fit where c does.
        let sound_speed = if cold { F::zero() } else { gamma.sqrt() * (state.pressure.sqrt() / state.density.sqrt()) };
        let front = state.velocity + two::<F>() * sound_speed / (gamma - F::one());
        let edges = (state.velocity - sound_speed, front);
        let behind = State { velocity: front, ..State::vacuum() };
        Side { state, gamma, sound_speed, behind, edges, shocked: false }
    }

    /// Find the wave for the pressure and velocity between the two sides.
    pub(super) fn meet(&mut self, pressure: F, velocity: F) {
        let (gamma, one) = (self.gamma, F::one());
        let State { density: rho, velocity: u, pressure: p } = self.state;
        self.shocked = pressure > p;
        self.behind = State { density: self.density_behind(pressure), velocity, pressure };
        self.edges = if self.shocked {
            let momentum = (gamma + one) * pressure + (gamma - one) * p;
            let speed = u - momentum.sqrt() / (two::<F>() * rho).sqrt();
            (speed, speed)
        } else {
            // By the Riemann invariant and not by the pressure, which may have become too small for the number type.
            let sound_speed = self.sound_speed - (gamma - one) / two() * (velocity - u);
            (u - self.sound_speed, velocity - sound_speed.max(F::zero()))
        };
    }

    /// The density behind the wave to this pressure.
    pub(super) fn density_behind(&self, pressure: F) -> F {
        let State { density: rho, pressure: p, .. } = self.state;
        if pressure > p {
            // Rankine-Hugoniot; in this form p may be 0.
            let mu = (self.gamma - F::one()) / (self.gamma + F::one());
            return rho * ((pressure + mu * p) / (mu * pressure + p));
        }
        rho * (self.log_ratio(pressure) / self.gamma).exp()
    }

    /// The state at `xi`, for `xi` up to the contact or the front.
    pub(super) fn sample(&self, xi: F) -> State<F> {
        let (head, tail) = self.edges;
        if xi <= head {
            self.state
        } else if xi >= tail {
            self.behind
        } else {
            self.fan(xi - head)
        }
    }

    /// The state in the fan, `depth` behind its head: the Riemann invariant u + 2c/(gamma - 1) and the entropy are those of
    /// the undisturbed gas, and u - c = xi. Written with `depth` so that nothing cancels for gamma close to 1.
    fn fan(&self, depth: F) -> State<F> {
        let (gamma, one) = (self.gamma, F::one());
        let lost = (gamma - one) / (gamma + one) * depth / self.sound_speed;
        let log_sound = (-lost).max(-one).ln_1p();
        let log_density = two::<F>() / (gamma - one) * log_sound;
        State {
            density: self.state.density * log_density.exp(),
            velocity: self.state.velocity + two::<F>() / (gamma + one) * depth,
            pressure: self.state.pressure * (gamma * log_density).exp(),
        }
    }

    /// The wave; none in vacuum.
    pub(super) fn wave(&self) -> Option<Wave<F>> {
        let (head, tail) = self.edges;
        let wave = if self.shocked { Wave::Shock { speed: head } } else { Wave::Rarefaction { head, tail } };
        (!self.state.is_vacuum()).then_some(wave)
    }

    /// Where the gas ends that expands into vacuum; none in vacuum.
    pub(super) fn front(&self) -> Option<F> {
        (!self.state.is_vacuum()).then_some(self.edges.1)
    }

    /// The velocity change across the wave to pressure `p`, $f_K(p)$: negative for a fan, positive for a shock.
    pub(super) fn velocity_change(&self, p: F) -> F {
        if p > self.state.pressure {
            return (p - self.state.pressure) / self.mass_flux(p);
        }
        two::<F>() * self.sound_speed / (self.gamma - F::one()) * (self.exponent() * self.log_ratio(p)).exp_m1()
    }

    /// $p\,f_K'(p)$.
    pub(super) fn velocity_slope(&self, p: F) -> F {
        if p > self.state.pressure {
            let half_share = (p - self.state.pressure) / (two::<F>() * (p + self.shock_offset()));
            return p / self.mass_flux(p) * (F::one() - half_share);
        }
        self.sound_speed / self.gamma * (self.exponent() * self.log_ratio(p)).exp()
    }

    /// ln(p/p_K), accurate where the two are close.
    pub(super) fn log_ratio(&self, p: F) -> F {
        let reference = self.state.pressure;
        if p == reference {
            return F::zero(); // also where both are 0
        }
        let ratio = p / reference;
        if ratio + ratio > F::one() { ((p - reference) / reference).ln_1p() } else { ratio.ln() }
    }

    /// (gamma - 1)/(2 gamma), the power of the pressure that the sound speed follows at constant entropy.
    pub(super) fn exponent(&self) -> F {
        (self.gamma - F::one()) / (two::<F>() * self.gamma)
    }

    fn shock_offset(&self) -> F {
        (self.gamma - F::one()) / (self.gamma + F::one()) * self.state.pressure
    }

    /// Mass that a shock to pressure `p` sweeps up per time and area. Roots first, so that no product underflows.
    fn mass_flux(&self, p: F) -> F {
        let density = self.state.density * (self.gamma + F::one()) / two();
        density.sqrt() * (p + self.shock_offset()).sqrt()
    }
}

/// 2, without a conversion that could fail.
pub(super) fn two<F: Float>() -> F {
    F::one() + F::one()
}
