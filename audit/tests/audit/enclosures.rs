//! Intervals hold the truth, and prove what the equations promise.

use etalon_audit::{Enclosure, Interval, Probe, Quad, enclose, hard_inputs, probes, random_inputs};
use proptest::prelude::*;

fn named<'a>(key: &str) -> &'a Probe {
    probes().iter().find(|probe| probe.key() == key).unwrap_or_else(|| panic!("no probe {key}"))
}

/// A box around each input: as wide as `width` times its size on either side.
fn around(inputs: &[f64], width: f64) -> Vec<Interval> {
    inputs.iter().map(|x| Interval::new(x - width * x.abs(), x + width * x.abs())).collect()
}

#[test]
fn the_truth_is_always_inside() {
    let mut checked = 0_usize;
    for probe in probes() {
        let hard = hard_inputs(probe).into_iter().step_by(23);
        for inputs in random_inputs(probe, 0).into_iter().step_by(37).chain(hard) {
            let exact: Vec<Quad> = inputs.iter().map(|x| Quad::exact(*x)).collect();
            let truths = probe.evaluate(&exact).unwrap();
            for width in [0.0, 1e-9, 0.3] {
                let bounds = probe.evaluate(&around(&inputs, width)).unwrap();
                for ((name, truth), bounds) in probe.output_names().iter().zip(&truths).zip(bounds) {
                    assert!(bounds.contains(*truth), "{probe} {name}: {truth} is not in {bounds} at {inputs:?}");
                    checked += 1;
                }
            }
        }
    }
    assert!(checked > 50_000, "only {checked} numbers");
}

proptest! {
    #[test]
    fn sums_products_quotients_and_roots_hold_the_truth(a in -1e3..1e3_f64, b in -1e3..1e3_f64, w in 0.0..2.0_f64) {
        use etalon_kernels_gen::Real;
        let (x, y) = (Interval::new(a - w, a + w), Interval::new(b - w, b + w));
        for place in [-1.0, -0.3, 0.0, 0.7, 1.0] {
            let (p, q) = (a + place * w, b - place * w);
            let (p, q) = (p.clamp(x.low(), x.high()), q.clamp(y.low(), y.high()));
            let (s, t) = (Quad::exact(p), Quad::exact(q));
            prop_assert!((x + y).contains(s + t) && (x - y).contains(s - t) && (x * y).contains(s * t));
            prop_assert!(t == Quad::exact(0.0) || (x / y).contains(s / t));
            prop_assert!(x.abs().sqrt().contains(s.abs().sqrt()));
            prop_assert!(x.min(y).contains(s.min(t)) && x.max(y).contains(s.max(t)));
            prop_assert!(x.power(3).contains(s * s * s) && x.power(4).contains(s * s * s * s));
        }
    }
}

/// The bounds of a result, which must hold the sample.
fn bounds(key: &str, boxes: usize, output: usize) -> Interval {
    let Enclosure { bounds, seen, output: name, .. } = enclose(named(key), boxes).swap_remove(output);
    println!("{key} {name}: proven {bounds}, seen {seen}");
    assert!(
        bounds.low() <= seen.low() && seen.high() <= bounds.high(),
        "{key} {name}: {seen} was seen outside of {bounds}"
    );
    bounds
}

/// What the pages of the equations promise of their range, for every real input of the domain. The slack is what is left of intervals' forgetting
/// at this number of boxes.
#[test]
fn promised_ranges_are_proven() {
    let within = |key: &str, low: f64, high: f64, slack: f64| {
        let bounds = bounds(key, 4096, 0);
        assert!(
            bounds.low() >= low - slack && bounds.high() <= high + slack,
            "{key}: {bounds}, promised {low} .. {high}"
        );
    };
    within("dissipation::pair_balsara", 0.0, 1.0, 1e-9);
    within("reconstruction::critical_separation 2-D", (2e-3_f64).sqrt(), 120_f64.sqrt(), 1e-9);
    within("kernels::mixed_sinc 3-D", 0.0, 0.5522, 0.01);
    within("kernels::wendland_c6 2-D", 0.0, 39.0 / (14.0 * std::f64::consts::PI), 0.15);
    within("dissipation::linear_coefficient AVSLRB2F", 0.5, 1.0, 1e-9);
    within("smoothing_length::next_smoothing_length", 0.8 * 1e-3, 1.25 * 1e3, 1e-6);
    // Viscosity only repels: no slack at all.
    assert!(bounds("dissipation::pair_viscosity", 1024, 0).low() >= 0.0);
    assert!(bounds("dissipation::riemann_viscosity", 1024, 0).low() >= 0.0);
}

/// More boxes, closer bounds: with enough of them it is proven that the quintic spline never rises.
#[test]
fn cutting_helps() {
    let largest_slope = |boxes| bounds("kernels::quintic_spline 2-D", boxes, 1).high();
    let (few, many) = (largest_slope(16), largest_slope(1024));
    assert!(few > 1e-3 && many < 1e-300, "{few:e} and {many:e}");
}
