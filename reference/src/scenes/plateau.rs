//! The gas that a wave of a tube has left behind: between the wave and the contact nothing should vary.

use super::scene::{Quantity, Solution};
use super::shock_tube::ShockTube;
use super::{AtEnd, SceneError, State};
use crate::diagnostics::entropy::{ColdGas, GasColumns, entropy_changes};
use crate::exact::riemann::{RiemannProblem, Wave};
use crate::norms::mean;
use std::iter::repeat_n;

/// Which part of the way from the contact to the wave is looked at: the middle half, away from both.
const LOOKED_AT: (f64, f64) = (0.25, 0.75);

/// What a wave has left behind.
struct Plateau {
    /// Speeds of its ends, x/t, ascending.
    between: (f64, f64),
    /// Its pressure over that of the gas at rest before it.
    ratio: f64,
    shock: bool,
}

impl ShockTube {
    fn plateaus(&self, exact: &RiemannProblem<f64>) -> Vec<Plateau> {
        // Where there is vacuum in between, there is no contact and nothing even.
        let (Some(contact), Some(star)) = (exact.contact(), exact.star()) else { return Vec::new() };
        let of = |(wave, before): (Option<Wave<f64>>, f64)| {
            let wave = wave?;
            let at = |part: f64| contact + part * (wave.tail() - contact);
            let (one, other) = (at(LOOKED_AT.0), at(LOOKED_AT.1));
            let between = (one.min(other), one.max(other));
            Some(Plateau { between, ratio: star.pressure / before, shock: wave.shock().is_some() })
        };
        let [left, right] = self.states.map(|state| state.pressure);
        [(exact.left_wave(), left), (exact.right_wave(), right)].into_iter().filter_map(of).collect()
    }

    /// That of the strongest shock and of the strongest rarefaction.
    fn strongest(&self, exact: &RiemannProblem<f64>) -> [Option<Plateau>; 2] {
        let all = self.plateaus(exact);
        let (shocks, fans): (Vec<Plateau>, Vec<Plateau>) = all.into_iter().partition(|plateau| plateau.shock);
        let strength = |plateau: &Plateau| plateau.ratio.ln().abs();
        [shocks, fans].map(|some| some.into_iter().max_by(|a, b| strength(a).total_cmp(&strength(b))))
    }

    /// Noise and entropy behind the strongest shock, entropy behind the strongest rarefaction: what the tube has of these.
    pub fn quantities_at_end(&self) -> Vec<Quantity> {
        let Ok(exact) = self.exact() else { return Vec::new() };
        let [shock, fan] = self.strongest(&exact);
        let even = Some((0.0, "the exact solution"));
        let quantity = |name, label, symbol| Quantity { name, label, symbol, unit: "", expected: even };
        let mut all = Vec::new();
        if shock.is_some() {
            let noise = "scatter of the velocity behind the shock, over the speed of sound there";
            all.push(quantity("post_shock_noise", noise, "σ(v)/c"));
            let entropy = "mean entropy behind the shock less the exact one, over the specific heat";
            all.push(quantity("post_shock_entropy", entropy, "ΔS/c_v"));
        }
        if fan.is_some() {
            let entropy = "mean entropy behind the rarefaction less the exact one, over the specific heat";
            all.push(quantity("rarefaction_entropy", entropy, "ΔS/c_v"));
        }
        all
    }

    /// Their values.
    ///
    /// # Errors
    /// A state that is not finite.
    pub fn at_end(&self, state: &State) -> Result<AtEnd, SceneError> {
        let Ok(exact) = self.exact() else { return Ok(AtEnd::default()) };
        let [shock, fan] = self.strongest(&exact);
        let solution = self.solution(exact, state.time);
        let mut values = Vec::new();
        for plateau in [shock, fan].into_iter().flatten() {
            let place = |speed: f64| self.interface + speed * state.time;
            let range = (place(plateau.between.0), place(plateau.between.1));
            let inside: Vec<usize> =
                state.moving().filter(|&i| (range.0..=range.1).contains(&state.position[0][i])).collect();
            // At the start itself there is no solution to look up.
            if inside.len() < 2 || state.time <= 0.0 {
                let (from, to) = range;
                let none = format!(
                    "fewer than two particles from x = {from:.4} to {to:.4} at t = {:.4}: take more",
                    state.time
                );
                values.extend(repeat_n(Err(none), if plateau.shock { 2 } else { 1 }));
                continue;
            }
            if plateau.shock {
                values.push(Ok(self.noise(state, &inside, solution.at(0.5 * (range.0 + range.1)))));
            }
            values.push(Ok(self.entropy(state, &inside, &solution)?));
        }
        Ok(AtEnd { values, curves: Vec::new() })
    }

    /// How far velocities scatter about their mean, over the exact speed of sound.
    fn noise(&self, state: &State, inside: &[usize], [density, _, pressure, _]: [f64; 4]) -> f64 {
        let variance = |column: &Vec<f64>| {
            let middle = mean(inside.iter().map(|&i| column[i]));
            mean(inside.iter().map(|&i| (column[i] - middle).powi(2)))
        };
        state.velocity.iter().map(variance).sum::<f64>().sqrt() / (self.gamma * pressure / density).sqrt()
    }

    /// GS25 (30) with the exact solution in the place of the start.
    fn entropy(&self, state: &State, inside: &[usize], solution: &dyn Solution) -> Result<f64, SceneError> {
        let exact = inside.iter().map(|&i| solution.at(state.position[0][i]));
        let (u_0, rho_0): (Vec<f64>, Vec<f64>) = exact.map(|[density, _, _, energy]| (energy, density)).unzip();
        let pick = |column: &[f64]| inside.iter().map(|&i| column[i]).collect::<Vec<f64>>();
        let (u, rho) = (pick(&state.internal_energy), pick(&state.density));
        let gas = |energy, density| GasColumns { energy, density };
        let cold = ColdGas::Excluded { floor: 0.0 };
        Ok(entropy_changes(gas(&u_0, &rho_0), gas(&u, &rho), self.gamma - 1.0, cold)?.mean)
    }
}
