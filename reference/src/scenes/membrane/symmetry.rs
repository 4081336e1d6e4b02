//! How round a wave is that should be.

use super::super::{State, View};
use crate::norms::mean;

/// Width of a shell in spacings. A wave of six spacings bends within it by a hundredth of its height.
const SHELL: f64 = 0.5;
/// A line goes through any two particles.
const LEAST: usize = 3;

/// The root mean square of the velocity around an axis, and by how much velocities away from it scatter at one radius, over the particles that move in a
/// range of the radius; zero for those there are none of.
///
/// The scatter is that about the straight line over the radius which is nearest to the particles of a shell half a spacing thick, so that the slope of
/// the wave itself is none.
pub fn roundness(state: &State, axis: [f64; 2], range: (f64, f64)) -> (f64, f64) {
    let seen = |view: View, i: usize| view.of(state.place(i), state.speed(i), state.position.len());
    let inside: Vec<usize> =
        state.moving().filter(|&i| (range.0..=range.1).contains(&seen(View::CylinderRadius(axis), i).0)).collect();
    if inside.is_empty() {
        return (0.0, 0.0);
    }
    let around = mean(inside.iter().map(|&i| seen(View::Azimuth(axis), i).1.powi(2))).sqrt();
    let volume = mean(inside.iter().map(|&i| state.mass[i] / state.density[i]));
    let width = SHELL * volume.powf(1.0 / state.position.len() as f64);
    let mut shells: Vec<Vec<(f64, f64)>> = Vec::new();
    for &i in &inside {
        let (radius, velocity) = seen(View::CylinderRadius(axis), i);
        let shell = ((radius - range.0) / width) as usize;
        if shells.len() <= shell {
            shells.resize(shell + 1, Vec::new());
        }
        shells[shell].push((radius, velocity));
    }
    // A line takes two freedoms from each shell.
    let (mut squares, mut freedom) = (0.0, 0);
    for shell in shells.iter().filter(|shell| shell.len() >= LEAST) {
        squares += residuals(shell).map(|off| off * off).sum::<f64>();
        freedom += shell.len() - 2;
    }
    (around, if freedom > 0 { (squares / freedom as f64).sqrt() } else { 0.0 })
}

/// What is left of values when the line nearest to them is taken away.
fn residuals(points: &[(f64, f64)]) -> impl Iterator<Item = f64> {
    let (x_mean, y_mean) = (mean(points.iter().map(|p| p.0)), mean(points.iter().map(|p| p.1)));
    let spread: f64 = points.iter().map(|(x, _)| (x - x_mean).powi(2)).sum();
    let together: f64 = points.iter().map(|(x, y)| (x - x_mean) * (y - y_mean)).sum();
    let slope = if spread > 0.0 { together / spread } else { 0.0 };
    points.iter().map(move |(x, y)| y - y_mean - slope * (x - x_mean))
}
