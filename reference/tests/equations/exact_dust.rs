//! Exact solutions with dust: the box, the wave, the shock in the limit of strong drag.

// Figures are given with all their digits.
#![allow(clippy::excessive_precision)]

use crate::check::{UNIT, assert_close, gamma};
use etalon_kernels_gen::Vector;
use etalon_reference::equations::drag::{
    continuum_drag, continuum_drag_heating, drag_rate, stopping_rate, stopping_time,
};
use etalon_reference::exact::dust::{DustError, Mixture};
use etalon_reference::exact::dustybox::DustyBox;
use etalon_reference::exact::dustyshock::{gas_of, mixture};
use etalon_reference::exact::dustywave::{Disturbance, DustyWave};
use etalon_reference::exact::riemann::{RiemannProblem, State};
use nalgebra::{Complex, DMatrix, Matrix3};
use std::f64::consts::TAU;

#[test]
fn box_with_equal_densities_decays_as_published() {
    // K = 0.35, unit densities, dust at speed one: v_g = (1 - exp(-2 K t)) / 2.
    let dusty = DustyBox::new(Mixture::new(1.0, 1.0, 0.35).unwrap(), 0.0, 1.0).unwrap();
    for t in [0.0, 0.1, 1.0, 5.0] {
        let due = 0.5 * (1.0 - (-0.7_f64 * t).exp());
        let (gas, dust) = dusty.velocities(t);
        assert_close("gas", gas, due, gamma(10, UNIT));
        assert_close("dust", dust, 1.0 - due, gamma(10, UNIT));
        assert_close("difference", dusty.difference(t), -(-0.7 * t).exp(), gamma(10, UNIT));
    }
}

/// PL20 (1)-(3) without gradients, with densities, velocities and drag all different; slopes by central differences.
#[test]
fn box_obeys_the_continuum_equations_and_keeps_energy() {
    let (rho_g, rho_d, k) = (2.0, 0.5, 3.0);
    let dusty = DustyBox::new(Mixture::new(rho_g, rho_d, k).unwrap(), 4.0, -1.0).unwrap();
    let step = 1e-4;
    for t in [0.0, 0.05, 0.2, 0.7] {
        let slope = |f: &dyn Fn(f64) -> f64| (f(t + step) - f(t - step)) / (2.0 * step);
        let (v_g, v_d) = dusty.velocities(t);
        let difference = Vector([v_g - v_d]);
        // Third derivatives are at most 5 * 7.5^3, over six times the squared step; rounding of 1e-16 / 1e-4.
        let tolerance = 5.0 * 7.5_f64.powi(3) / 6.0 * step * step * 2.0;
        let gas = continuum_drag(drag_rate(k, rho_g), difference)[0];
        assert_close("gas", slope(&|t| dusty.velocities(t).0), gas, tolerance);
        let dust = continuum_drag(drag_rate(k, rho_d), -difference)[0];
        assert_close("dust", slope(&|t| dusty.velocities(t).1), dust, tolerance);
        let heating = rho_g * continuum_drag_heating(drag_rate(k, rho_g), difference);
        // The square decays twice as fast.
        assert_close("heat", slope(&|t| dusty.heat(t)), heating, 40.0 * tolerance);
        let total = dusty.kinetic_energy(t) + dusty.heat(t);
        assert_close("energy", total, dusty.kinetic_energy(0.0), gamma(30, UNIT) * 20.0);
        assert_close("momentum", rho_g * v_g + rho_d * v_d, rho_g * 4.0 - rho_d, gamma(20, UNIT) * 10.0);
    }
    assert_close(
        "e-folding",
        dusty.difference(stopping_time(stopping_rate(k, rho_g, rho_d))),
        5.0 / 1_f64.exp(),
        1e-14,
    );
    // Late, the heat is half the reduced density times the square; early it keeps its digits.
    assert_close("all heat", dusty.heat(1e3), 0.5 * 0.4 * 25.0, gamma(10, UNIT) * 5.0);
    let early = 1e-18;
    let rate = stopping_rate(k, rho_g, rho_d);
    assert_close("early heat", dusty.heat(early) / early, 0.4 * 25.0 * rate, gamma(10, UNIT) * 75.0);
}

/// `K`, densities, sound speed, wavelength such that `k c_s = 1` and the drag rates are `gas` and `dust`.
fn wave_with_rates(gas: f64, dust: f64) -> DustyWave<f64> {
    // Without drag any density will do; otherwise K = gas and the densities 1 and gas / dust.
    let (k, dust_density) = if gas > 0.0 && dust > 0.0 { (gas, gas / dust) } else { (0.0, 1.0) };
    DustyWave::new(Mixture::new(1.0, dust_density, k).unwrap(), 1.0, TAU).unwrap()
}

/// From 60-digit arithmetic. Cardano's formula loses six digits and more of the wave in the first and in the strongly coupled ones.
#[test]
fn dispersion_roots_keep_their_digits_from_no_drag_to_infinite_drag() {
    let cases = [
        (1e-12, 2e-12, [(-1.9999999999999999598e-12, 0.0), (-4.9999999999999998994e-13, 1.0)]),
        (1e-3, 5e-4, [(-0.00050000025000018751055, 0.0), (-0.00049999987499990626034, 0.9999996249999296875)]),
        (0.5, 2.0, [(-2.4274579284407467362, 0.0), (-0.036271035779626631912, 0.90696834851688606564)]),
        (1e6, 1e6, [(-1999999.99999975, 0.0), (-1.25e-7, 0.70710678118658067003)]),
        (1e9, 1e3, [(-1000000999.999999999, 0.0), (-4.999990000014999985e-10, 0.00099999950000025000062)]),
        (1e3, 1e9, [(-1000001000.0, 0.0), (-4.999990000014999975e-16, 0.99999950000037499969)]),
        (0.0, 0.0, [(0.0, 0.0), (0.0, 1.0)]),
    ];
    for (gas, dust, due) in cases {
        let roots = wave_with_rates(gas, dust).growth_rates();
        let what = format!("rates {gas}, {dust}");
        // Each part of each root by itself, however small: the set-up rounds the rates by 4 units, the root and the factors by some ten each.
        let close = |name: &str, got: f64, due: f64| {
            assert_close(&format!("{name} with {what}"), got, due, gamma(40, UNIT) * due.abs());
        };
        close("real root", roots[0].re, due[0].0);
        close("damping", roots[1].re, due[1].0);
        close("frequency", roots[1].im, due[1].1);
        assert_eq!(roots[0].im, 0.0);
        assert_eq!(roots[2], roots[1].conj(), "{what}");
    }
}

/// Heavy dust and gas strongly held: no wave is left, the three roots are real.
#[test]
fn overdamped_waves_have_three_real_roots() {
    for (gas, dust, mut due) in [
        (3.0, 0.01, [-2.6314214253446259215, -0.36825913624533292271, -0.010319438410041155968]),
        (2.5, 1e-14, [-2.0000000000000166667, -0.49999999999998333333, -1.0000000000000249988e-14]),
    ] {
        let mut roots = wave_with_rates(gas, dust).growth_rates().map(|y| (y.re, y.im));
        roots.sort_by(|x, y| x.0.total_cmp(&y.0));
        due.sort_by(f64::total_cmp);
        for ((re, im), due) in roots.into_iter().zip(due) {
            assert_eq!(im, 0.0);
            // As above; the discriminant 1.7 of 1.7 and more loses no more than a factor of two.
            assert_close(&format!("root with {gas}, {dust}"), re, due, gamma(60, UNIT) * due.abs());
        }
    }
}

/// The problem of PL20 section 3.1: K = 1000, unit densities, sound speed and wavelength.
fn published() -> DustyWave<f64> {
    DustyWave::new(Mixture::new(1.0, 1.0, 1000.0).unwrap(), 1.0, 1.0).unwrap()
}

#[test]
fn published_wave_has_its_roots() {
    let roots = published().growth_rates();
    for (got, due) in [
        (roots[0].re, -1999.990130395599151),
        (roots[1].re, -0.00493480220042450447),
        (roots[1].im, 4.44289115998554353),
    ] {
        assert_close("root", got, due, gamma(40, UNIT) * due.abs());
    }
    assert_close("phase speed", roots[1].im / TAU, 0.70710808973, 1e-11);
    // Strong coupling: -1/t_s, and (1/2) k^2 c^2 t_s eps / (1 + eps) of damping, to second order in k c t_s = 0.003.
    assert_close("damping", roots[1].re, -0.25 * TAU * TAU * 5e-4, 2e-5 * 0.005);
}

/// Roots and companion matrix by another route, at moderate drag; and the polynomial itself at each root.
#[test]
fn roots_are_eigenvalues_of_the_companion_matrix() {
    for (rho_g, rho_d, k, c, wavelength) in
        [(1.0, 1.0, 1.0, 1.0, 1.0), (2.0, 0.5, 30.0, 1.5, 0.75), (0.3, 4.0, 2.0, 3.0, 5.0)]
    {
        let wave = DustyWave::new(Mixture::new(rho_g, rho_d, k).unwrap(), c, wavelength).unwrap();
        let (a_g, a_d): (f64, f64) = (k / rho_g, k / rho_d);
        let kc2 = (TAU / wavelength * c).powi(2);
        let companion = Matrix3::new(0.0, 0.0, -kc2 * a_d, 1.0, 0.0, -kc2, 0.0, 1.0, -(a_g + a_d));
        let eigenvalues = companion.complex_eigenvalues();
        for y in wave.growth_rates() {
            let nearest = eigenvalues.iter().map(|e| (e - y).norm()).fold(f64::MAX, f64::min);
            // Backward stable to some tens of units of the matrix, whose eigenvalues here have condition numbers below ten.
            let bound = 500.0 * UNIT * companion.norm();
            assert!(nearest < bound, "{y} is {nearest:e} from an eigenvalue, tolerance {bound:e}");
        }
    }
}

fn parts(d: Disturbance<Complex<f64>>) -> [Complex<f64>; 4] {
    [d.gas_velocity, d.dust_velocity, d.gas_density, d.dust_density]
}

/// Amplitudes against 60-digit solutions of the four linear equations by eigenvectors.
#[test]
fn amplitudes_are_those_of_the_linear_equations() {
    let equal = Disturbance { gas_velocity: 1.0, dust_velocity: 1.0, gas_density: 1.0, dust_density: 1.0 };
    let unequal = Disturbance { gas_velocity: 1.0, dust_velocity: -2.0, gas_density: 3.0, dust_density: 4.0 };
    let other = DustyWave::new(Mixture::new(2.0, 0.5, 3.0).unwrap(), 1.5, 0.75).unwrap();
    let cases = [
        (
            published(),
            10.0,
            equal,
            [
                (0.85803478071074016939, -0.29205428537342513093),
                (0.8598528569503501723, -0.28935582045185708192),
                (0.85803478071074016939, -0.58141010582528221285),
                (0.8598528569503501723, -0.58229067629533496835),
            ],
        ),
        (
            other,
            0.7,
            unequal,
            [
                (-0.5136092048933398808, -2.2202215449129588908),
                (0.011864722449557722201, -1.2557031406866621741),
                (-1.3105658070764367089, -0.23590666289920411906),
                (1.4427265315328292836, 2.5731864180181287312),
            ],
        ),
        (
            other,
            1e-6,
            unequal,
            [
                (0.99999549993791828052, -0.000056548625351733183219),
                (-1.9999820000674999892, -1.696455791774033668e-10),
                (2.9999999997631296128, -8.377561559843495484e-6),
                (3.9999999999999995263, 0.00001675508542111037332),
            ],
        ),
    ];
    for (wave, t, initial, due) in cases {
        for (got, due) in parts(wave.amplitudes(t, initial)).into_iter().zip(due) {
            // Phases up to 60, each root good to 40 units; amplitudes below ten.
            let bound = gamma(100, UNIT) * 60.0 * 10.0;
            assert_close("real part", got.re, due.0, bound);
            assert_close("imaginary part", got.im, due.1, bound);
        }
    }
    let start = parts(other.amplitudes(0.0, unequal));
    for (got, due) in start.into_iter().zip([1.0, -2.0, 3.0, 4.0]) {
        assert!((got - due).norm() < gamma(200, UNIT) * 10.0, "{got} where {due} is due");
    }
}

/// The same by nalgebra's matrix exponential of the real equations for sine and cosine parts, at a place and time.
#[test]
fn field_is_that_of_the_matrix_exponential() {
    let (rho_g, rho_d, k_drag, c, wavelength) = (2.0, 0.5, 3.0, 1.5, 0.75);
    let wave = DustyWave::new(Mixture::new(rho_g, rho_d, k_drag).unwrap(), c, wavelength).unwrap();
    let initial = Disturbance { gas_velocity: 1.0, dust_velocity: -2.0, gas_density: 3.0, dust_density: 4.0 };
    let k = TAU / wavelength;
    let (x, t) = (0.2, 0.35);
    // Unknowns: sine parts of the four fields, then cosine parts; d/dx turns sine into k cosine and cosine into -k sine.
    let mut m = DMatrix::<f64>::zeros(8, 8);
    for part in [0, 4] {
        m[(part, part)] = -k_drag / rho_g;
        m[(part, part + 1)] = k_drag / rho_g;
        m[(part + 1, part)] = k_drag / rho_d;
        m[(part + 1, part + 1)] = -k_drag / rho_d;
        let (other, sign) = if part == 0 { (4, 1.0) } else { (0, -1.0) };
        m[(part, other + 2)] = sign * k * c * c;
        m[(part + 2, other)] = sign * k;
        m[(part + 3, other + 1)] = sign * k;
    }
    let start = nalgebra::DVector::from_vec(vec![1.0, -2.0, 3.0, 4.0, 0.0, 0.0, 0.0, 0.0]);
    let now = (m * t).exp() * start;
    let field = |row: usize| now[row] * (k * x).sin() + now[row + 4] * (k * x).cos();
    let got = wave.at(x, t, initial);
    // Entries up to k c^2 t = 6.6: scaling and squaring keeps some thousand units.
    let bound = 1e4 * UNIT * 10.0;
    for (row, got) in [got.gas_velocity, got.dust_velocity, got.gas_density, got.dust_density].into_iter().enumerate() {
        assert_close(&format!("field {row}"), got, field(row), bound);
    }
    let mean = |row: usize| 0.5 * (now[row].powi(2) + now[row + 4].powi(2));
    let energy = 0.5 * (rho_g * mean(0) + rho_d * mean(1));
    assert_close("kinetic energy", wave.kinetic_energy(t, initial), energy, 10.0 * bound);
}

/// No drag: sound in the gas, dust at its own speed. Infinite drag: one fluid with the sound speed c / sqrt(1 + eps).
#[test]
fn limits_of_the_wave() {
    let gas_wave = Disturbance { gas_velocity: 1.5, dust_velocity: 0.25, gas_density: 1.0, dust_density: 0.0 };
    let free = DustyWave::new(Mixture::new(1.0, 1.0, 0.0).unwrap(), 1.5, 2.0).unwrap();
    let (x, t) = (0.3, 0.7);
    let k = TAU / 2.0;
    let got = free.at(x, t, gas_wave);
    let close = |what: &str, got: f64, due: f64| assert_close(what, got, due, gamma(100, UNIT) * 5.0);
    // v = c delta rho / rho travels to the right.
    close("gas velocity", got.gas_velocity, 1.5 * (k * (x - 1.5 * t)).sin());
    close("gas density", got.gas_density, (k * (x - 1.5 * t)).sin());
    close("dust velocity", got.dust_velocity, 0.25 * (k * x).sin());
    close("dust density", got.dust_density, -k * t * 0.25 * (k * x).cos());
    let bound = DustyWave::new(Mixture::new(1.0, 3.0, 1e12).unwrap(), 1.5, 2.0).unwrap();
    let together = Disturbance { gas_velocity: 0.75, dust_velocity: 0.75, gas_density: 1.0, dust_density: 1.0 };
    let got = bound.at(x, t, together);
    // Corrections are of order k c t_s = 4e-12.
    for (got, due) in [
        (got.gas_velocity, 0.75 * (k * (x - 0.75 * t)).sin()),
        (got.dust_velocity, 0.75 * (k * (x - 0.75 * t)).sin()),
        (got.gas_density, (k * (x - 0.75 * t)).sin()),
        (got.dust_density, (k * (x - 0.75 * t)).sin()),
    ] {
        assert_close("mixture", got, due, 2e-11);
    }
}

/// Strong drag, dust to gas one: Sod's tube with all speeds divided by the square root of two.
#[test]
fn shock_in_the_limit_of_strong_drag() {
    let tube = |density, pressure| mixture(State { density, velocity: 0.0, pressure }, 1.0).unwrap();
    for (gamma, due) in [
        (5.0 / 3.0, [-0.182574186, -0.023956963, 0.118962917, 0.260847925]),
        (1.4, [-0.167332, -0.009938, 0.131162, 0.247792]),
    ] {
        let problem = RiemannProblem::new(tube(1.0, 1.0), tube(0.125, 0.1), gamma).unwrap();
        let left = problem.left_wave().unwrap();
        let right = problem.right_wave().unwrap();
        let places = [left.head(), left.tail(), problem.contact().unwrap(), right.head()].map(|speed| 0.2 * speed);
        for (got, due) in places.into_iter().zip(due) {
            // The digits given.
            assert_close("place at t = 0.2", got, due, 6e-7);
        }
        if gamma > 1.5 {
            let star = problem.star().unwrap();
            assert_close("pressure", star.pressure, 0.293945187666018, 1e-14);
            assert_close("velocity", star.velocity, 0.59481458426778, 1e-14);
            let behind = gas_of(problem.sample(star.velocity * 1.01), 1.0).unwrap();
            assert_close("gas density", behind.density, 0.229805749311947, 1e-14);
            assert_close("gas pressure", behind.pressure, 0.293945187666018, 1e-14);
        }
    }
}

#[test]
fn impossible_mixtures_are_refused() {
    let message = |result: Result<Mixture<f64>, DustError>| result.unwrap_err().to_string();
    assert_eq!(message(Mixture::new(0.0, 1.0, 1.0)), "the gas density is 0: give a number above 0");
    assert_eq!(message(Mixture::new(1.0, -2.0, 1.0)), "the dust density is -2: give a number above 0");
    assert_eq!(message(Mixture::new(1.0, 1.0, -3.0)), "the drag coefficient is -3: give 0 or a positive number");
    assert_eq!(message(Mixture::new(1.0, f64::NAN, 1.0)), "the dust density is NaN: give a finite number");
    assert!(message(Mixture::new(1e-300, 1.0, 1e300)).contains("leave the number type"));
    let mixture = Mixture::new(1.0, 1.0, 1.0).unwrap();
    assert_eq!(
        DustyBox::new(mixture, f64::INFINITY, 0.0).unwrap_err().to_string(),
        "the gas velocity is inf: give a finite number"
    );
    assert_eq!(
        DustyWave::new(mixture, 0.0, 1.0).unwrap_err().to_string(),
        "the sound speed is 0: give a number above 0"
    );
    assert_eq!(
        DustyWave::new(mixture, 1.0, -1.0).unwrap_err().to_string(),
        "the wavelength is -1: give a number above 0"
    );
    assert!(DustyWave::new(mixture, 1e-200, 1.0).is_err());
    let gas = State { density: 1.0, velocity: 0.0, pressure: 1.0 };
    assert_eq!(
        etalon_reference::exact::dustyshock::mixture(gas, -0.5).unwrap_err().to_string(),
        "the dust-to-gas ratio is -0.5: give 0 or a positive number"
    );
}
