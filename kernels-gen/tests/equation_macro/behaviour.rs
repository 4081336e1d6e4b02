//! The same function at every kind of number.

use crate::equations::*;
use crate::pair::{Both, Pair, notes};
use etalon_kernels_gen::{Fused, Real, Vector};

/// Runs an equation of one number at f64, f32, their fused kinds and both halves of a pair, which all must give exactly
/// `expected`: the inputs are chosen so that every step is exact in 24 bits.
macro_rules! exactly {
    ($x:expr => $expected:expr, |$v:ident: $r:ident| $equation:expr) => {{
        fn run<$r: Real>($v: $r) -> $r {
            $equation
        }
        let (x, expected): (f64, f64) = ($x, $expected);
        assert_eq!(run(x), expected, "f64 at {x}");
        assert_eq!(run(x as f32), expected as f32, "f32 at {x}");
        assert_eq!(run(Fused(x)), Fused(expected), "fused f64 at {x}");
        assert_eq!(run(Fused(x as f32)), Fused(expected as f32), "fused f32 at {x}");
        assert_eq!(run(Pair([x, x])), Pair([expected; 2]), "pair at {x}");
    }};
}

#[test]
fn branches_pick_the_same_side_everywhere() {
    for (x, expected) in [(-3.0, -2.0), (-1.0, -1.0), (0.5, 0.5), (1.0, 1.0), (1.5, 3.0)] {
        exactly!(x => expected, |x: R| pieces(x));
    }
    for (x, expected) in [(-3.0, 9.0), (-2.0, 4.0), (1.5, 1.5), (2.0, 4.0)] {
        exactly!(x => expected, |x: R| rarely_squared(x, R::lit(2.0)));
    }
}

#[test]
fn lanes_pick_for_themselves() {
    assert_eq!(pieces(Pair([-3.0, 0.5])), Pair([-2.0, 0.5]));
    assert_eq!(rarely_squared(Pair([3.0, 1.0]), Pair([2.0, 2.0])), Pair([9.0, 1.0]));
    let (kept, sign) = sorted_out(Pair([3.0, 4.0]), Both([true, false]));
    assert_eq!((kept, sign), (Pair([3.0, 0.0]), Pair([1.0, -1.0])));
    assert_eq!(sorted_out(-3.0, true), (0.0, -1.0));
    assert_eq!(nested(Vector([Pair([0.25, 1.0])]), Pair([0.0, 0.75])), Vector([Pair([0.125, -1.0])]));
    assert_eq!(nested(Vector([1.0, 4.0, 9.0]), 0.0), Vector([0.2, 0.8, 9.0 * 0.2]));
}

#[test]
fn literals_are_constants_of_the_type() {
    exactly!(2.0 => 1.0, |x: R| balsara_limiter(x, R::lit(0.0), R::lit(0.0), R::lit(1.0)));
    // 1e-4 is not a number of either type: each takes its own nearest, and rounds the sum and the quotient itself.
    assert_eq!(balsara_limiter(1.0_f64, 1.0, 1.0, 1.0), 1.0 / (2.0 + 1e-4));
    assert_eq!(balsara_limiter(1.0_f32, 1.0, 1.0, 1.0), 1.0 / (2.0 + 1e-4));
}

#[test]
fn early_decisions_stay_early() {
    let flat = |x: Vector<f64, 2>| decided_early(x, Slope::Flat, false);
    assert_eq!(flat(Vector([1.0, 2.0])), (9.5_f64).powi(2));
    assert_eq!(decided_early(Vector([1.0]), Slope::Steep { factor: 3 }, false), 2.25);
    assert_eq!(decided_early(Vector([1.0]), Slope::Steep { factor: 1 }, true), 5.5);
    assert_eq!(decided_early(Vector([1.0, 1.0, 7.0]), Slope::Steep { factor: 1 }, false), 64.0);
    // Nothing of it is left for a drawing to choose.
    let noted = notes(|| _ = decided_early(Vector([Pair([1.0; 2])]), Slope::Flat, true));
    assert!(!noted.contains(&"choose".to_string()), "{noted:?}");
    assert_eq!(Shift::<1>.shifted(1.0), 2.0);
    assert_eq!(Shift::<7>.shifted(1.0), 3.0);
}

#[test]
fn values_get_their_names() {
    let mut total = Pair([0.0; 2]);
    let noted = notes(|| total = every_let(Pair([1.0; 2]), Vector([Pair([2.0; 2]); 2]), true));
    // number = 2, vector = (4, 4), trace = 32, array[1] = 2 twice, type = 1
    assert_eq!(total, Pair([39.0; 2]));
    let expected = [
        "c25:2 every_let {",
        "number",
        "vector_x",
        "vector_y",
        "matrix_xx",
        "matrix_xy",
        "matrix_yy",
        "type",
        "total",
        "}",
    ];
    assert_eq!(noted, expected);
}

#[test]
fn equations_and_rare_branches_say_so() {
    let noted = notes(|| _ = rarely_squared(Pair([1.0; 2]), Pair([2.0; 2])));
    assert_eq!(noted, ["a test of rare branches rarely_squared {", "choose_rare", "}"]);
    let noted = notes(|| _ = pieces(Pair([1.0; 2])));
    assert_eq!(noted, ["gs25:11, gs25:12 pieces {", "choose", "choose", "inside", "}"]);
}
