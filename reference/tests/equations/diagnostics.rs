//! GS25 (29), (30): the share of pairs whose viscosity cools, and the change of entropy.

use crate::check::{UNIT, assert_close};
use crate::cloud::Recipe;
use etalon_kernels_gen::Symmetric;
use etalon_reference::diagnostics::entropy::{ColdGas, EntropyError, GasColumns, entropy_change, entropy_changes};
use etalon_reference::diagnostics::sign_reversal::{ReversedShares, reversed_shares};
use etalon_reference::domain::separation;
use etalon_reference::engine::{Engine, PlainEngine};
use etalon_reference::equations::dissipation::sign_is_reversed;
use etalon_reference::fields;
use etalon_reference::passes::Physics;
use etalon_reference::pipeline::Pipeline;
use etalon_reference::scenes::sod::Sod;
use etalon_reference::schemes::{Dissipation, Viscosity};

#[test]
fn signs_are_compared_without_a_product() {
    for tiny in [1.0, 1e-200, 1e-308] {
        assert_eq!((sign_is_reversed(tiny, -tiny), sign_is_reversed(-tiny, tiny)), (1.0, 1.0));
        assert_eq!((sign_is_reversed(tiny, tiny), sign_is_reversed(-tiny, -tiny)), (0.0, 0.0));
        for size in [tiny, -tiny] {
            let with_zero = (sign_is_reversed(size, 0.0), sign_is_reversed(0.0, size));
            assert_eq!(with_zero, (0.0, 0.0), "nothing has no sign to be opposite to");
        }
    }
}

/// Both shares against a double loop that reconstructs by the printed formulas.
#[test]
fn reversed_pairs_are_counted() {
    let set = Recipe::unequal::<2>(95).particles::<2>(true);
    let physics = Physics { viscosity: Viscosity::of(Dissipation::AvSlr), ..Sod::standard(2).physics() };
    let mut engine = PlainEngine::<f64, 2>::new(&set);
    engine.find_neighbours(2.0).unwrap();
    Pipeline::of_scene::<2>(&physics).run(&mut engine, physics).unwrap();
    let shares = reversed_shares(&mut engine, physics).unwrap();

    let strain = engine.read_all(fields::STRAIN_RATE).unwrap();
    let q_crit = engine.read_scalar(fields::CRITICAL_SEPARATION).unwrap();
    let coordinates = [set.coordinates(0), set.coordinates(1)];
    let [mut pairs, mut approaching, mut reversed, mut both] = [0_u32; 4];
    for (a, p) in set.particles().iter().enumerate() {
        for &b in engine.neighbours().of(a) {
            let b = b as usize;
            let other = &set.particles()[b];
            let x: [f64; 2] = std::array::from_fn(|i| separation(coordinates[i][a], coordinates[i][b], 1.0));
            let v: [f64; 2] = std::array::from_fn(|i| p.velocity[i] - other.velocity[i]);
            let r = (x[0] * x[0] + x[1] * x[1]).sqrt();
            let omega = (x[0] * v[0] + x[1] * v[1]) / r;
            let slope = |of: usize| {
                let s = |i, j| strain[Symmetric::<f64, 2>::position(i, j)][of];
                x[0] * x[0] * s(0, 0) + 2.0 * x[0] * x[1] * s(0, 1) + x[1] * x[1] * s(1, 1)
            };
            let f = slope(a) / slope(b);
            let limiter = (4.0 * f / (1.0 + f).powi(2)).clamp(0.0, 1.0);
            let q = r / p.smoothing_length.max(other.smoothing_length);
            let kappa = |of: usize| if q < q_crit[of] { (-((q - q_crit[of]) / 0.2).powi(2)).exp() } else { 1.0 };
            let omega_prime = omega - limiter * (kappa(a) * slope(a) + kappa(b) * slope(b)) / (2.0 * r);
            pairs += 1;
            approaching += u32::from(omega < 0.0);
            reversed += u32::from(omega * omega_prime < 0.0);
            both += u32::from(omega < 0.0 && omega_prime > 0.0);
        }
    }
    assert!(both > 20 && reversed > both, "{reversed} reversed, {both} of them approaching, of {pairs}");
    // Whole numbers on both sides; a pair on the edge of either sign would show as a whole one.
    let due = ReversedShares {
        of_all: f64::from(reversed) / f64::from(pairs),
        of_approaching: f64::from(both) / f64::from(approaching),
    };
    assert_eq!(shares, due);
    println!("{shares:?}");
}

/// A flow that is linear has no reversed pair to speak of, and a scheme that reconstructs nothing has none.
#[test]
fn no_reconstruction_reverses_nothing() {
    let set = Recipe::unequal::<2>(96).particles::<2>(true);
    let physics = Physics { viscosity: Viscosity::of(Dissipation::AvB), ..Sod::standard(2).physics() };
    let mut engine = PlainEngine::<f64, 2>::new(&set);
    engine.find_neighbours(2.0).unwrap();
    Pipeline::of_scene::<2>(&physics).run(&mut engine, physics).unwrap();
    let shares = reversed_shares(&mut engine, physics).unwrap();
    assert_eq!(shares, ReversedShares { of_all: 0.0, of_approaching: 0.0 });
}

#[test]
fn entropy_of_simple_changes() {
    // Heated e-fold at constant volume, compressed e-fold at constant energy.
    assert_close("heated", entropy_change(3.0 * 1_f64.exp(), 3.0, 2.0, 2.0, 0.4), 1.0, 8.0 * UNIT);
    assert_close("compressed", entropy_change(5.0, 5.0, 2.0 * 1_f64.exp(), 2.0, 0.4), -0.4, 8.0 * UNIT);
    assert_eq!(entropy_change(7.0, 7.0, 3.0, 3.0, 0.4), 0.0);
    // An adiabat, u ~ rho^(gamma - 1), far from the start.
    for (rho, gamma_minus_one) in [(100.0_f64, 2.0 / 3.0), (1e-6, 0.4), (3.7, 0.001)] {
        let u = rho.powf(gamma_minus_one);
        // Each logarithm has 12 roundings of itself, and they cancel; the power is rounded in its last place.
        let size = 2.0 * gamma_minus_one * rho.ln().abs();
        let bound = (size * 16.0 + 2.0) * UNIT;
        assert_close("adiabatic", entropy_change(u, 1.0, rho, 1.0, gamma_minus_one), 0.0, bound);
    }
    // A small change keeps its digits, which the difference of two logarithms of large numbers would not.
    let small = 1e-9;
    let due = small - 0.5 * small * small;
    let got = entropy_change(1e8 * (1.0 + small), 1e8, 1.0, 1.0, 0.4);
    // 1 + small, its product and the quotient round in the last place of one.
    assert_close("a small change", got, due, 4.0 * UNIT);
}

#[test]
fn cold_gas_is_excluded_or_floored() {
    let (energy_0, density_0) = ([1.0, 1e-8, 0.0, 2.0], [1.0, 1.0, 1.0, 4.0]);
    let (energy, density) = ([2.0, 3.0, 5.0, 4.0], [1.0, 1.0, 1.0, 4.0]);
    let start = GasColumns { energy: &energy_0, density: &density_0 };
    let now = GasColumns { energy: &energy, density: &density };
    let ln2 = std::f64::consts::LN_2;
    let excluded = entropy_changes(start, now, 0.4, ColdGas::Excluded { floor: 1e-6 }).unwrap();
    assert_eq!((excluded.cold, excluded.changes[1], excluded.changes[2]), (2, None, None));
    assert_close("mean of the warm", excluded.mean, ln2, 12.0 * UNIT);
    // A floor of zero leaves out only what has no logarithm, and the ambient's logarithm rules the mean.
    let all = entropy_changes(start, now, 0.4, ColdGas::Excluded { floor: 0.0 }).unwrap();
    assert_eq!((all.cold, all.changes[2]), (1, None));
    assert!(all.mean > 6.0, "{}", all.mean);
    // Overcooled gas has no logarithm either.
    let overcooled = GasColumns { energy: &[-2.0, 3.0, 5.0, 4.0], density: &density };
    let without = entropy_changes(start, overcooled, 0.4, ColdGas::Excluded { floor: 0.0 }).unwrap();
    assert_eq!((without.cold, without.changes[0]), (2, None));
    let floored = entropy_changes(start, now, 0.4, ColdGas::Floored { floor: 1.0 }).unwrap();
    assert_eq!(floored.cold, 3);
    let due = (2.0 * ln2 + 3_f64.ln() + 5_f64.ln()) / 4.0;
    assert_close("mean of the floored", floored.mean, due, 20.0 * UNIT);
}

#[test]
fn what_has_no_entropy_is_refused() {
    let (one, two) = ([1.0], [1.0, 1.0]);
    let gas = |energy, density| GasColumns { energy, density };
    let usual = ColdGas::Excluded { floor: 0.0 };
    let refuse = |start, now, cold| entropy_changes(start, now, 0.4, cold).unwrap_err().to_string();
    let text = refuse(gas(&two, &two), gas(&two, &one), usual);
    assert_eq!(text, "column the density has 1 entries for 2 particles: give one for each particle");
    let text = refuse(gas(&two, &[1.0, 0.0]), gas(&two, &two), usual);
    assert!(text.starts_with("particle 1 has the starting density = 0: "), "{text}");
    let text = refuse(gas(&two, &two), gas(&[f64::NAN, 1.0], &two), usual);
    assert!(text.starts_with("particle 0 has the energy = NaN: "), "{text}");
    for bad in
        [ColdGas::Floored { floor: 0.0 }, ColdGas::Excluded { floor: -1.0 }, ColdGas::Floored { floor: f64::NAN }]
    {
        let refused = entropy_changes(gas(&one, &one), gas(&one, &one), 0.4, bad);
        assert!(matches!(refused, Err(EntropyError::Floor { .. })), "{bad:?}");
    }
    // Whatever the column: what is not finite is refused; so is a density that is not positive, while such an energy is only cold.
    for (bad, only_cold) in
        [(f64::NAN, false), (f64::INFINITY, false), (f64::NEG_INFINITY, false), (0.0, true), (-1.0, true)]
    {
        for column in 0..4 {
            let values: [[f64; 2]; 4] = std::array::from_fn(|k| if k == column { [1.0, bad] } else { [1.0, 1.0] });
            let [energy_0, density_0, energy, density] = &values;
            let start = GasColumns { energy: energy_0, density: density_0 };
            match entropy_changes(start, GasColumns { energy, density }, 0.4, usual) {
                Ok(changes) => {
                    assert!(only_cold && column % 2 == 0 && changes.changes[1].is_none() && changes.cold == 1)
                }
                Err(error) => assert!(
                    !(only_cold && column % 2 == 0) && error.to_string().starts_with("particle 1 has the "),
                    "{error}"
                ),
            }
        }
    }
    let none = entropy_changes(gas(&one, &one), gas(&one, &one), 0.4, ColdGas::Excluded { floor: 1.0 });
    assert!(matches!(none, Err(EntropyError::AllCold { particles: 1, .. })));
}
