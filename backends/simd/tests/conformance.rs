//! The vector engine against the equations, at every instruction-set level this processor has.

use etalon_kernels_gen::bounded::Roundoff;
use etalon_kernels_gen::lanes::{available_levels, level_name};
use etalon_kernels_gen::trace::{Double, Single};
use etalon_reference::conformance::{Summary, check_dimension, check_mixtures, check_updates};
use etalon_simd::{LaneEngine, Number, Options};

fn conforms<const D: usize, T: Number, P: Roundoff>() {
    for level in available_levels() {
        let summary =
            check_dimension::<D, P, _>(|set, fields| Ok(LaneEngine::<T, D>::new(set, fields, Options { level })));
        holds::<D, T>(level_name(level), summary.unwrap());
    }
}

/// What makes no difference between levels of instructions is tried on one (`same_bits.rs`).
fn mixtures_conform<const D: usize, T: Number, P: Roundoff>() {
    let level = available_levels()[0];
    let make = |set: &_, fields: &_| Ok(LaneEngine::<T, D>::new(set, fields, Options { level }));
    holds::<D, T>(level_name(level), check_mixtures::<D, P, _>(make).unwrap());
}

fn holds<const D: usize, T: Number>(level: &str, summary: Summary) {
    let (place, worst) = summary.worst.expect("nothing was compared");
    println!("{} {level} {D}-D: {} numbers; nearest to its bound: {place}: {worst}", T::NAME, summary.compared);
    let (place, loosest) = summary.loosest.expect("no set without difficulty");
    println!("  widest bound: {place}: {} {}, {:.1e} of the value", loosest.pass, loosest.component, loosest.looseness);
    assert!(summary.failures.is_empty(), "{} failures:\n{}", summary.failures.len(), summary.failures.join("\n"));
}

#[test]
fn double_precision_conforms_in_one_dimension() {
    conforms::<1, f64, Double>();
}
#[test]
fn double_precision_conforms_in_two_dimensions() {
    conforms::<2, f64, Double>();
}
#[test]
fn double_precision_conforms_in_three_dimensions() {
    conforms::<3, f64, Double>();
}
#[test]
fn single_precision_conforms_in_one_dimension() {
    conforms::<1, f32, Single>();
}
#[test]
fn single_precision_conforms_in_two_dimensions() {
    conforms::<2, f32, Single>();
}
#[test]
fn single_precision_conforms_in_three_dimensions() {
    conforms::<3, f32, Single>();
}

#[test]
fn gas_with_dust_conforms_in_double_precision() {
    mixtures_conform::<1, f64, Double>();
    mixtures_conform::<2, f64, Double>();
    mixtures_conform::<3, f64, Double>();
}
#[test]
fn gas_with_dust_conforms_in_single_precision() {
    mixtures_conform::<1, f32, Single>();
    mixtures_conform::<2, f32, Single>();
    mixtures_conform::<3, f32, Single>();
}

fn updates_conform<const D: usize, T: Number, P: Roundoff>() {
    for level in available_levels() {
        let make = |set: &_, fields: &_| Ok(LaneEngine::<T, D>::new(set, fields, Options { level }));
        let summary = check_updates::<D, P, _>(make).unwrap();
        let (place, worst) = summary.worst.expect("nothing was compared");
        println!(
            "{} {}: {} numbers; nearest to its bound: {place}: {worst}",
            T::NAME,
            level_name(level),
            summary.compared
        );
        assert!(summary.failures.is_empty(), "{} failures:\n{}", summary.failures.len(), summary.failures.join("\n"));
    }
}

#[test]
fn updates_conform_in_double_precision() {
    updates_conform::<1, f64, Double>();
    updates_conform::<2, f64, Double>();
    updates_conform::<3, f64, Double>();
}
#[test]
fn updates_conform_in_single_precision() {
    updates_conform::<1, f32, Single>();
    updates_conform::<2, f32, Single>();
    updates_conform::<3, f32, Single>();
}
