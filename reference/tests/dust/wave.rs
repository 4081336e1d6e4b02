//! DUSTYWAVE: what drag does to a sound wave, with and without reconstruction, against the exact solution and against the linear theory of
//! the discrete drag itself.

use etalon_reference::engine::{Engine, PlainEngine};
use etalon_reference::equations::double_hump::double_hump;
use etalon_reference::equations::kernels::kernel_shape;
use etalon_reference::equations::reconstruction::smoothing_length_holding;
use etalon_reference::fields;
use etalon_reference::norms::l1_error;
use etalon_reference::scenes::dustywave::{DRAG_COEFFICIENT, DustyWave};
use etalon_reference::schemes::{CommonPoint, Drag, DragReconstruction, SlopeLimiter};
use etalon_reference::simulation::Simulation;
use num_complex::Complex;
use std::f64::consts::TAU;

fn drag(point: CommonPoint, limiter: SlopeLimiter) -> Drag {
    Drag { reconstruction: DragReconstruction { point, limiter }, ..Drag::of(DRAG_COEFFICIENT) }
}

/// What is left of a wave.
struct Left {
    /// `L_1` of the velocities of both species, in amplitudes.
    error: f64,
    /// Kinetic energy over the exact one.
    energy: f64,
    /// Amplitudes of gas and dust in units of the first, with their phases.
    amplitudes: [Complex<f64>; 2],
}

fn left<const D: usize>(scene: &DustyWave, until: f64) -> Left {
    let set = scene.particles::<D>().unwrap();
    let half = set.len() / 2;
    let mut simulation = Simulation::new(PlainEngine::<f64, D>::new(&set), scene.physics()).unwrap();
    simulation.run(until, |_| {}).unwrap();
    let engine = simulation.engine();
    let x: Vec<f64> = engine.coordinates(0).unwrap().iter().map(|&x| set.domain().decode(0, x)).collect();
    let velocity = engine.read_all(fields::VELOCITY).unwrap().swap_remove(0);
    let mass = engine.read_scalar(fields::MASS).unwrap();
    let (exact, start) = (scene.exact().unwrap(), scene.initial());
    let due: Vec<f64> = (0..set.len())
        .map(|i| {
            let at = exact.at(x[i], until, start);
            if i < half { at.gas_velocity } else { at.dust_velocity }
        })
        .collect();
    let volume: f64 = set.domain().torus_length().iter().product();
    let energy: f64 = (0..set.len()).map(|i| 0.5 * mass[i] * velocity[i] * velocity[i]).sum::<f64>() / volume;
    let amplitude = |particles: std::ops::Range<usize>| {
        let count = particles.len() as f64;
        // A wave starts as the imaginary part of e^{ikx}.
        let part = |i: usize| Complex::from_polar(velocity[i], -TAU * x[i]);
        particles.map(part).sum::<Complex<f64>>() * Complex::new(0.0, 2.0 / (count * scene.amplitude))
    };
    Left {
        error: l1_error(&velocity, &due, &x, (0.0, 1.0)).unwrap() / scene.amplitude,
        energy: energy / exact.kinetic_energy(until, start),
        amplitudes: [amplitude(0..half), amplitude(half..set.len())],
    }
}

/// The same amplitudes by the linear equations, but with the discrete drag of particles on a lattice: a gas particle is dragged towards
/// `G v_d` instead of `v_d`, at `N` times the rate, and likewise dust. With `x` the separation along the wave, the sums over neighbours of the other species are
///
/// `N = nu sum V D (x/r)^2`, `G = nu sum V D (x/r)^2 cos kx` without reconstruction, `cos kx + s j kx sin kx` instead of the cosine with,
/// where `j` is what the discrete gradient makes of a wave's slope and `s` the share of the other's slope. With halves `1 - G/N` is of the order `(kh)^2` in the first case and `(kh)^4` in the second: that is
/// the overdamping and its cure.
fn linear_theory<const D: usize>(scene: &DustyWave, until: f64) -> [Complex<f64>; 2] {
    let spacing = 1.0 / scene.particles as f64;
    let volume = spacing.powi(D as i32);
    let h = smoothing_length_holding(scene.neighbours, volume, D, scene.kernel.support());
    // Seven spacings are more than a support.
    let places = (0..15_usize.pow(D as u32)).map(|i| {
        let place = |axis: usize| ((i / 15_usize.pow(axis as u32) % 15) as f64 - 7.0) * spacing;
        (place(0), (0..D).map(|axis| place(axis).powi(2)).sum::<f64>())
    });
    let places: Vec<(f64, f64)> = places.filter(|(_, r_squared)| *r_squared > 0.0).collect();
    let sum = |term: &dyn Fn(f64, f64) -> f64| places.iter().map(|&(x, r_squared)| term(x, r_squared)).sum::<f64>();
    let hump = |x: f64, r_squared: f64| {
        let shape = double_hump::<f64, D>(scene.kernel, r_squared / (h * h));
        D as f64 * volume * shape / h.powi(D as i32) * x * x / r_squared
    };
    let slope = |r_squared: f64| -kernel_shape::<f64, D>(scene.kernel, r_squared / (h * h)).slope_over_q;
    let gradient = sum(&|x, s| slope(s) * x * (TAU * x).sin()) / sum(&|x, s| slope(s) * x * TAU * x);
    // The share of the other's slope in the reconstruction, at a gas and at a dust particle.
    let gas_share = scene.gas_density / (scene.gas_density + scene.dust_density);
    let shares = match scene.drag.reconstruction.point {
        CommonPoint::Particles => [0.0, 0.0],
        CommonPoint::Midpoint => [0.5, 0.5],
        CommonPoint::Barycentre => [gas_share, 1.0 - gas_share],
        CommonPoint::AsPrinted => [gas_share, gas_share],
    };
    let n = sum(&hump);
    let [g_gas, g_dust] =
        shares.map(|share| sum(&|x, s| hump(x, s) * ((TAU * x).cos() + share * gradient * TAU * x * (TAU * x).sin())));
    let (a_g, a_d) = (scene.drag.coefficient / scene.gas_density, scene.drag.coefficient / scene.dust_density);
    let ik = Complex::new(0.0, TAU);
    let rates = |[v_g, v_d, delta]: [Complex<f64>; 3]| {
        let push = -ik * (scene.sound_speed * scene.sound_speed) * delta;
        [push - (v_g * n - v_d * g_gas) * a_g, -(v_d * n - v_g * g_dust) * a_d, -ik * v_g]
    };
    let add = |state: [Complex<f64>; 3], rate: [Complex<f64>; 3], step: f64| {
        std::array::from_fn::<_, 3, _>(|i| state[i] + rate[i] * step)
    };
    // Runge and Kutta's fourth order; a step is a fiftieth of the stopping time.
    let steps = (until * 50.0 * (a_g + a_d)).ceil() as usize;
    let step = until / steps as f64;
    let mut state = [Complex::from(1.0); 3];
    for _ in 0..steps {
        let one = rates(state);
        let two = rates(add(state, one, 0.5 * step));
        let three = rates(add(state, two, 0.5 * step));
        let four = rates(add(state, three, step));
        state = std::array::from_fn(|i| state[i] + (one[i] + two[i] * 2.0 + three[i] * 2.0 + four[i]) * (step / 6.0));
    }
    [state[0], state[1]]
}

/// Amplitudes of both species against that theory.
///
/// It leaves out what particles make of the pressure, an error of `(kh)^2` at most in the frequency. A wave that runs one way would keep its
/// amplitude; of the two here (0.854 and 0.146 in a mixture of equal parts) the sum changes by up to 0.3 for a phase of one.
fn assert_linear_theory<const D: usize>(scene: &DustyWave, until: f64) -> [f64; 2] {
    let (found, due) = (left::<D>(scene, until), linear_theory::<D>(scene, until));
    let tolerance = 0.3 * (TAU / scene.particles as f64).powi(2) * TAU * scene.sound_speed * until;
    for (species, (found, due)) in ["gas", "dust"].into_iter().zip(found.amplitudes.iter().zip(due)) {
        let error = (found.norm() - due.norm()).abs();
        println!("{D}-D {}: {species} {:.5}, theory {:.5}", scene.drag.reconstruction.point, found.norm(), due.norm());
        assert!(error < tolerance, "{D}-D: {species} {found}, theory {due}: off by {error}, tolerance {tolerance}");
    }
    let exact = scene.exact().unwrap().amplitudes(until, scene.initial());
    [found.amplitudes[0].norm(), exact.gas_velocity.norm() / scene.amplitude]
}

/// The paper's wave with a 32nd of the particles that resolve `c_s t_s`: without reconstruction drag of its own making damps it, by just as much
/// as the theory of the discrete sums says.
#[test]
fn overdamping_is_what_smeared_drag_makes() {
    let scene =
        |point| DustyWave { particles: 32, drag: drag(point, SlopeLimiter::Unlimited), ..DustyWave::standard(1) };
    let [without, exact] = assert_linear_theory::<1>(&scene(CommonPoint::Particles), 0.2);
    let [with, _] = assert_linear_theory::<1>(&scene(CommonPoint::Barycentre), 0.2);
    assert!(without < 0.15 * exact && with > 0.9 * exact, "{without} without, {with} with, exact {exact}");
}

/// Where particles of gas and dust have unequal masses, the midpoint and the barycentre do alike; the weights of (10) as printed feed the wave,
/// or damp it if dust is the heavier.
#[test]
fn the_printed_weights_fail_for_unequal_masses() {
    for (dust_density, feeds) in [(0.25, true), (4.0, false)] {
        let amplitude = |point| {
            let drag = Drag { coefficient: 200.0, ..drag(point, SlopeLimiter::Unlimited) };
            let scene = DustyWave { particles: 32, dust_density, drag, ..DustyWave::standard(1) };
            assert_linear_theory::<1>(&scene, 0.25)
        };
        let [midpoint, exact] = amplitude(CommonPoint::Midpoint);
        let [barycentre, _] = amplitude(CommonPoint::Barycentre);
        let [printed, _] = amplitude(CommonPoint::AsPrinted);
        println!(
            "rho_d = {dust_density}: midpoint {midpoint}, barycentre {barycentre}, as printed {printed}, exact {exact}"
        );
        let off = |found: f64| (found / exact - 1.0).abs();
        assert!(off(midpoint) < 0.1 && off(barycentre) < 0.1, "{midpoint}, {barycentre}, exact {exact}");
        assert!(if feeds { printed > 1.2 * exact } else { printed < 0.8 * exact }, "{printed}, exact {exact}");
    }
}

#[test]
fn a_thin_sheet_has_the_same_wave() {
    let drag = drag(CommonPoint::Barycentre, SlopeLimiter::Unlimited);
    let scene = DustyWave { particles: 16, rows: 7, drag, ..DustyWave::standard(2) };
    assert_linear_theory::<2>(&scene, 0.03);
}

/// PL20 Fig. 3: from no limiter over the less dissipative limiters and the entropy fix to no reconstruction the wave keeps less and less, and
/// Superbee feeds it. Drag is a fifth as strong as there, and so are the steps' number and the particles.
#[test]
fn limiters_rank_as_in_the_paper() {
    use SlopeLimiter::*;
    let energy = |drag: Drag| {
        let drag = Drag { coefficient: 200.0, ..drag };
        left::<1>(&DustyWave { particles: 32, drag, ..DustyWave::standard(1) }, 0.5).energy
    };
    let fixed = Drag { entropy_fix: true, ..drag(CommonPoint::Barycentre, Unlimited) };
    let falling = [
        energy(drag(CommonPoint::Barycentre, Superbee)),
        energy(drag(CommonPoint::Barycentre, Unlimited)),
        energy(drag(CommonPoint::Barycentre, MonotonizedCentral)),
        energy(drag(CommonPoint::Barycentre, VanLeer)),
        energy(drag(CommonPoint::Barycentre, Minmod)),
        energy(fixed),
        energy(drag(CommonPoint::Particles, Unlimited)),
    ];
    println!("kinetic energy over the exact one: {falling:.4?}");
    assert!(falling.windows(2).all(|two| two[0] > 1.005 * two[1]), "{falling:?}");
    assert!(falling[0] > 1.05 && falling[1] < 1.0, "{falling:?}");
}

/// PL20 Fig. 4: with reconstruction the error falls at second order at least, to a small part of what it is without, while `h > c_s t_s`.
#[test]
fn reconstruction_makes_drag_second_order() {
    let errors = |point, limiter| {
        let drag = Drag { coefficient: 200.0, ..drag(point, limiter) };
        let of = |particles| left::<1>(&DustyWave { particles, drag, ..DustyWave::standard(1) }, 0.5).error;
        let [coarse, fine] = [32, 64].map(of);
        println!("{point}, {limiter}: {coarse:e}, {fine:e}, order {:.2}", (coarse / fine).log2());
        [coarse, fine]
    };
    let without = errors(CommonPoint::Particles, SlopeLimiter::Unlimited);
    let with = errors(CommonPoint::Barycentre, SlopeLimiter::MonotonizedCentral);
    assert!((with[0] / with[1]).log2() > 1.8, "{with:?}");
    assert!(with[0] < 0.15 * without[0] && with[1] < 0.05 * without[1], "{with:?} with, {without:?} without");
}
