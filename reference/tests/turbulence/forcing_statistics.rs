//! What the force is like on average. Seeds are fixed; tolerances are five standard errors of the mean that is formed.

use crate::check::assert_close;
use crate::places::cube;
use etalon_reference::schemes::ModeWeights;
use etalon_reference::turbulence::forcing::{Driving, ForceWave, Forcing};

/// Five standard errors.
const SIGMAS: f64 = 5.0;

fn forces(driving: Driving, seeds: std::ops::Range<u64>) -> impl Iterator<Item = Forcing<3>> {
    seeds.map(move |seed| Forcing::new(&cube::<3>(1.0), driving, seed).unwrap())
}

/// The amplitudes of one force, each component of each wave, real and imaginary; for a weight of one half they are the processes
/// themselves but for a known factor.
fn numbers(force: &Forcing<3>) -> Vec<f64> {
    force.waves().iter().flat_map(|wave| wave.real.0.into_iter().chain(wave.imaginary.0)).collect()
}

/// Variance and correlation with the start, after one correlation time taken in 1, 4 or 64 steps. Euler's explicit steps would settle
/// 20 % too high in variance with steps of a quarter.
#[test]
fn spread_and_memory_do_not_depend_on_the_step() {
    let driving = Driving::subsonic();
    let memory = driving.correlation_time(1.0);
    for steps in [1_u32, 4, 64] {
        let (mut before, mut after, mut together, mut count) = (0.0, 0.0, 0.0, 0.0);
        for mut force in forces(driving, 0..100) {
            let start = numbers(&force);
            (0..steps).for_each(|_| force.advance(memory / f64::from(steps)).unwrap());
            // Each wave has its own amplitude; in units of it the numbers are alike.
            for (wave, (x, y)) in start.iter().zip(numbers(&force)).enumerate() {
                let unit = (amplitude(wave / 6, &force) * driving.deviation(1.0)).powi(2);
                before += x * x / unit;
                after += y * y / unit;
                together += x * y / unit;
                count += 1.0;
            }
        }
        let (before, after, together) = (before / count, after / count, together / count);
        println!("{steps} steps: {before} -> {after}, together {together}, {count} numbers");
        // The variance of x^2 is 2, that of x y is 1 + e^-2.
        let error = SIGMAS * (2.0_f64 / count).sqrt();
        assert_close("variance at the start", before, 1.0, error);
        assert_close("variance later", after, 1.0, error);
        assert_close("correlation", together, (-1.0_f64).exp(), SIGMAS * (1.135_f64 / count).sqrt());
    }
}

/// The amplitude of a wave, from the list of modes: even weights share the published sum.
fn amplitude(wave: usize, force: &Forcing<3>) -> f64 {
    use etalon_reference::schemes::Profile;
    use etalon_reference::turbulence::forcing::modes;
    let amplitudes: Vec<f64> = modes::<3>(Profile::Power).iter().map(|m| m.amplitude).filter(|a| *a > 0.0).collect();
    let sum: f64 = amplitudes.iter().map(|a| a * a).sum();
    let rms = force.expected_rms() / Driving::subsonic().deviation(1.0);
    amplitudes[wave] * (rms * rms / 3.0 / sum).sqrt()
}

fn power(waves: &[ForceWave<3>], of: impl Fn([f64; 3], [f64; 3]) -> f64) -> f64 {
    let part = |wave: &ForceWave<3>| {
        let n = wave.wave_vector.map(f64::from);
        0.5 * (of(n, wave.real.0) + of(n, wave.imaginary.0))
    };
    waves.iter().map(part).sum()
}

fn square(_: [f64; 3], x: [f64; 3]) -> f64 {
    x.iter().map(|x| x * x).sum()
}
fn along(n: [f64; 3], x: [f64; 3]) -> f64 {
    let dot: f64 = (0..3).map(|i| n[i] * x[i]).sum();
    dot * dot / n.iter().map(|n| n * n).sum::<f64>()
}

/// The root mean square is the expected one for any weight; its compressive share is 0, 1/3, 1 at 1, 1/2, 0. Two thirds as a weight
/// is *not* two thirds of the power.
#[test]
fn strength_does_not_depend_on_the_weight_and_one_half_is_two_thirds() {
    for (weight, compressive) in [(0.0, 1.0), (0.5, 1.0 / 3.0), (1.0, 0.0), (2.0 / 3.0, 1.0 / 9.0)] {
        let driving = Driving { solenoidal_weight: weight, ..Driving::subsonic() };
        let (mut squares, mut shares) = (Vec::new(), Vec::new());
        for force in forces(driving, 100..300) {
            let waves = force.waves();
            let (all, along) = (power(&waves, square), power(&waves, along));
            squares.push(all / force.expected_rms().powi(2));
            shares.push(along / force.expected_rms().powi(2));
        }
        let check = |name: &str, values: &[f64], due: f64| {
            let n = values.len() as f64;
            let mean = values.iter().sum::<f64>() / n;
            let variance = values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / (n - 1.0);
            println!("weight {weight}: {name} {mean} +- {}", (variance / n).sqrt());
            // A share that is nothing by construction has rounding left.
            assert_close(&format!("{name} at {weight}"), mean, due, SIGMAS * (variance / n).sqrt() + 1e-14);
        };
        check("mean square", &squares, 1.0);
        check("compressive share", &shares, compressive);
    }
}

/// Waves along an edge of the box, along a face, and others of the same length class: even weights give each its parabola, the
/// published list four times and twice as much.
#[test]
fn even_weights_are_isotropic_and_published_ones_are_not() {
    for (weights, edge, face) in [(ModeWeights::Even, 1.0, 1.0), (ModeWeights::Published, 4.0, 2.0)] {
        let driving = Driving { weights, ..Driving::subsonic() };
        // Mean square of a kind of wave over 4 (1 - (n - 2)^2) (2/n)^2.
        let mut sums = [(0.0, 0.0); 3];
        for force in forces(driving, 300..400) {
            for wave in force.waves() {
                let squared: i32 = wave.wave_vector.iter().map(|n| n * n).sum();
                let n = f64::from(squared).sqrt();
                let parabola = 4.0 * (1.0 - (n - 2.0).powi(2)) * (2.0 / n).powi(2);
                let zeros = wave.wave_vector.iter().filter(|n| **n == 0).count();
                sums[zeros].0 += (wave.real.norm_squared() + wave.imaginary.norm_squared()) / parabola;
                sums[zeros].1 += 1.0;
            }
        }
        let [generic, on_face, on_edge] = sums.map(|(sum, count)| sum / count);
        println!("{weights}: face {}, edge {}", on_face / generic, on_edge / generic);
        // Six squares a wave; the rarest kind, 3 waves of length 2, has 1800 in 100 draws: 3.3 % each, and the other's.
        let error = SIGMAS * (2.0_f64 / 1800.0).sqrt() * 1.5;
        assert_close("edge over others", on_edge / generic / edge, 1.0, error);
        assert_close("face over others", on_face / generic / face, 1.0, error);
    }
}
