//! How far a shear instability has grown: the amplitude of one wave in the velocity across the layers.

use crate::sum::CompensatedSum;

/// Particles of a periodic box, in two or three dimensions, and what weighs them.
#[derive(Clone, Copy, Debug)]
pub struct ShearColumns<'a> {
    /// Places along the flow.
    pub x: &'a [f64],
    /// Places across it.
    pub y: &'a [f64],
    /// Velocities across it.
    pub velocity_y: &'a [f64],
    /// Volumes. Masses instead would count the denser layer more often.
    pub volume: &'a [f64],
}

/// What an amplitude cannot be taken of.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum AmplitudeError {
    /// The lists belong to different particles.
    #[error("lists of {0:?} entries for x, y, velocity and volume: give one entry for each particle")]
    Lengths([usize; 4]),
    /// Nothing to sum over.
    #[error("no particle has weight: give particles of positive volume within the box")]
    Empty,
    /// NaN or infinite.
    #[error("the sums are not finite: a run that has diverged has no amplitude")]
    NotFinite,
}

/// The amplitude of the wave of this length in the velocity across two shear layers at a quarter and three quarters of a box of height 1,
/// $A = 2 \sqrt{(\sum s)^2 + (\sum c)^2} / \sum d$ with $s = V v_y \sin(kx) E$, $c = V v_y \cos(kx) E$, $d = V E$ and $E = e^{-k |y - y_l|}$, `y_l` being the layer
/// of the particle's half.
///
/// A sine of amplitude `A` that has the same size at all heights gives `A`. Source: McNally, Lyra & Passy 2012, section 5, their equations 10 to 13, where the wave
/// is half as long as the box and `k` stands as `4 pi`.
pub fn mode_amplitude(gas: ShearColumns, wavelength: f64) -> Result<f64, AmplitudeError> {
    let lengths = [gas.x.len(), gas.y.len(), gas.velocity_y.len(), gas.volume.len()];
    if lengths.iter().any(|n| *n != lengths[0]) {
        return Err(AmplitudeError::Lengths(lengths));
    }
    let k = std::f64::consts::TAU / wavelength;
    let [mut sine, mut cosine, mut weight] = [CompensatedSum::new(), CompensatedSum::new(), CompensatedSum::new()];
    for i in 0..lengths[0] {
        let layer = if gas.y[i] < 0.5 { 0.25 } else { 0.75 };
        let share = gas.volume[i] * (-k * (gas.y[i] - layer).abs()).exp();
        let moved = share * gas.velocity_y[i];
        sine.add(moved * (k * gas.x[i]).sin());
        cosine.add(moved * (k * gas.x[i]).cos());
        weight.add(share);
    }
    let amplitude = 2.0 * sine.value().hypot(cosine.value()) / weight.value();
    match amplitude {
        _ if weight.value() == 0.0 => Err(AmplitudeError::Empty),
        a if a.is_finite() => Ok(a),
        _ => Err(AmplitudeError::NotFinite),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// A lattice in the unit box with this velocity across.
    fn amplitude(velocity: impl Fn(f64, f64) -> f64, volume: impl Fn(f64) -> f64, wavelength: f64) -> f64 {
        let places: Vec<[f64; 2]> =
            (0..6400).map(|i| [(f64::from(i % 80) + 0.5) / 80.0, (f64::from(i / 80) + 0.5) / 80.0]).collect();
        let column = |of: &dyn Fn(&[f64; 2]) -> f64| places.iter().map(of).collect::<Vec<f64>>();
        let (x, y) = (column(&|p| p[0]), column(&|p| p[1]));
        let (velocity_y, volume) = (column(&|p| velocity(p[0], p[1])), column(&|p| volume(p[1])));
        mode_amplitude(ShearColumns { x: &x, y: &y, velocity_y: &velocity_y, volume: &volume }, wavelength).unwrap()
    }

    #[test]
    fn a_sine_has_its_own_amplitude_whatever_its_phase_and_the_volumes() {
        for phase in [0.0, 0.7, 2.0] {
            let wave = |x: f64, _: f64| 0.01 * (2.0 * TAU * x + phase).sin();
            // Whole waves on a lattice: the sums of sin^2 and cos^2 are exactly half.
            for found in [amplitude(wave, |_| 1.0, 0.5), amplitude(wave, |y| 1.0 + y, 0.5)] {
                assert!((found - 0.01).abs() < 1e-14, "{found} where 0.01 is due");
            }
        }
    }

    #[test]
    fn other_waves_and_common_motion_do_not_count() {
        assert!(amplitude(|x, _| (TAU * x).sin() + (3.0 * TAU * x).cos() + 5.0, |_| 1.0, 0.5) < 1e-13);
        // The same wave in opposite phase in both layers cancels: the estimator adds them.
        let sign = |y: f64| if y < 0.5 { 1.0 } else { -1.0 };
        assert!(amplitude(|x, y| sign(y) * (2.0 * TAU * x).sin(), |_| 1.0, 0.5) < 1e-14);
        // Another length has another weight across, but a full wave is one still.
        assert!((amplitude(|x, _| 0.3 * (TAU * x).cos(), |_| 1.0, 1.0) - 0.3).abs() < 1e-13);
    }

    /// What is far from both layers counts less: within an eighth of them is 1 - e^(-pi/2) of all weight.
    #[test]
    fn weight_falls_away_from_the_layers() {
        let near = |y: f64| (y - 0.25).abs() < 0.125 || (y - 0.75).abs() < 0.125;
        let found = amplitude(|x, y| if near(y) { (2.0 * TAU * x).sin() } else { 0.0 }, |_| 1.0, 0.5);
        let due = (1.0 - (-0.5 * std::f64::consts::PI).exp()) / (1.0 - (-std::f64::consts::PI).exp());
        // The midpoint rule with 80 rows: (k / 80)^2 / 24.
        assert!((found / due - 1.0).abs() < 1.1e-3, "{found} where {due} is due");
    }

    #[test]
    fn bad_lists_are_refused() {
        let gas =
            |x: &'static [f64], velocity_y: &'static [f64]| ShearColumns { x, y: &[0.1], velocity_y, volume: &[1.0] };
        assert_eq!(mode_amplitude(gas(&[], &[1.0]), 0.5), Err(AmplitudeError::Lengths([0, 1, 1, 1])));
        assert_eq!(mode_amplitude(gas(&[0.0], &[f64::NAN]), 0.5), Err(AmplitudeError::NotFinite));
        let none = ShearColumns { x: &[], y: &[], velocity_y: &[], volume: &[] };
        assert_eq!(mode_amplitude(none, 0.5), Err(AmplitudeError::Empty));
    }
}
