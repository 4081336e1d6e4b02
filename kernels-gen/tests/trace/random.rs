//! Nothing is lost between a function and the evaluation of its drawing. Would catch: a swapped operand, a wrong
//! comparison, a rule of the simplifier that changes a value, a common subexpression that is none.

use crate::programs::{INPUTS, drawn, inputs, program, run};
use etalon_kernels_gen::Fused;
use etalon_kernels_gen::trace::{Double, Single, first_not_finite, interpret};
use proptest::prelude::*;
use proptest::strategy::ValueTree;

/// Equal bits; two NaNs are equal.
fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan())
}
/// Equal bits but for the sign of zero.
fn equal(a: f64, b: f64) -> bool {
    same(a, b) || (a == 0.0 && b == 0.0)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_drawing_computes_what_the_function_computes(program in program(), inputs in inputs()) {
        let single: [f32; INPUTS] = inputs.map(|v| v as f32);
        let direct = run(&program, single);
        let through = interpret(&drawn::<Single>(&program), &single).unwrap();
        prop_assert!(direct.iter().zip(&through).all(|(a, b)| same(*a as f64, *b as f64)), "{direct:?} {through:?}");

        let direct = run(&program, inputs);
        let through = interpret(&drawn::<Double>(&program), &inputs).unwrap();
        prop_assert!(direct.iter().zip(&through).all(|(a, b)| same(*a, *b)), "{direct:?} {through:?}");

        let fused = inputs.map(Fused);
        let direct = run(&program, fused);
        let through = interpret(&drawn::<Double>(&program), &fused).unwrap();
        prop_assert!(direct.iter().zip(&through).all(|(a, b)| same(a.0, b.0)), "{direct:?} {through:?}");
    }

    #[test]
    fn simplification_changes_no_bit(program in program(), inputs in inputs()) {
        let single: [f32; INPUTS] = inputs.map(|v| v as f32);
        let drawing = drawn::<Single>(&program);
        // Finite by construction is what the rules rely on; programs that are not are skipped, on these inputs.
        if first_not_finite(&drawing, &single).unwrap().is_none() {
            let direct = run(&program, single);
            let simple = interpret(&drawing.simplified(), &single).unwrap();
            prop_assert!(direct.iter().zip(&simple).all(|(a, b)| equal(*a as f64, *b as f64)), "{direct:?} {simple:?}");
        }
        let drawing = drawn::<Double>(&program);
        if first_not_finite(&drawing, &inputs).unwrap().is_none() {
            let direct = run(&program, inputs);
            let simple = interpret(&drawing.simplified(), &inputs).unwrap();
            prop_assert!(direct.iter().zip(&simple).all(|(a, b)| equal(*a, *b)), "{direct:?} {simple:?}");
        }
    }

    #[test]
    fn simplification_is_done_at_once(program in program()) {
        let once = drawn::<Single>(&program).simplified();
        let twice = once.simplified();
        prop_assert_eq!(once.count(), twice.count());
        prop_assert_eq!(once.graph().len(), twice.graph().len());
        prop_assert!(once.count().flops() <= drawn::<Single>(&program).count().flops());
    }
}

/// Would catch a generator whose programs all blow up, so that the comparison above never runs.
#[test]
fn most_random_programs_are_finite() {
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    let strategy = (program(), inputs());
    let finite = (0..500).filter(|_| {
        let (program, inputs) = strategy.new_tree(&mut runner).unwrap().current();
        first_not_finite(&drawn::<Double>(&program), &inputs).unwrap().is_none()
    });
    let finite = finite.count();
    assert!(finite > 250, "{finite} of 500 random programs are finite; at least half should be");
}
