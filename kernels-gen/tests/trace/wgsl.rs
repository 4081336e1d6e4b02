//! WGSL: accepted by naga, readable, the same every time.

use crate::programs::{drawn, program};
use crate::toys::{Density, Drift, Momentum};
use etalon_kernels_gen::emit::{EmitError, Header, MulAdd, wgsl};
use etalon_kernels_gen::trace::{Double, Drawing, Single, Symbol, draw};
use etalon_kernels_gen::{Mask, Nameable, Real};
use naga::valid::{Capabilities, ValidationFlags, Validator};
use proptest::prelude::*;

const HEAD: Header = Header { command: "etalon emit toy --target wgsl", definition: "kernels-gen/tests/trace/toys.rs" };

/// Parses and validates, or says why not, with the text.
fn accepted(text: &str) -> Result<(), String> {
    let module =
        naga::front::wgsl::parse_str(text).map_err(|error| format!("{}\n{text}", error.emit_to_string(text)))?;
    let mut validator = Validator::new(ValidationFlags::all(), Capabilities::empty());
    validator.validate(&module).map_err(|error| format!("{}\n{text}", error.emit_to_string(text)))?;
    Ok(())
}

fn momentum() -> String {
    let pass = Drawing::of_pass::<2, _, Single>(&Momentum { heats: false }).unwrap();
    wgsl::pass(&pass, &HEAD, MulAdd::TwoRoundings).unwrap()
}

#[test]
fn density_reads_like_code() {
    let pass = Drawing::of_pass::<3, _, Single>(&Density).unwrap();
    insta::assert_snapshot!("density", wgsl::pass(&pass, &HEAD, MulAdd::TwoRoundings).unwrap());
}

#[test]
fn momentum_reads_like_code() {
    insta::assert_snapshot!("momentum", momentum());
}

#[test]
fn drift_reads_like_code() {
    let update = Drawing::of_update::<1, _, Single>(&Drift).unwrap();
    insta::assert_snapshot!("drift", wgsl::update(&update, &HEAD, MulAdd::Fused).unwrap());
}

#[test]
fn passes_are_accepted_in_every_dimension() {
    fn check<const D: usize>(mul_add: MulAdd) {
        let density = Drawing::of_pass::<D, _, Single>(&Density).unwrap();
        let momentum = Drawing::of_pass::<D, _, Single>(&Momentum { heats: true }).unwrap();
        let drift = Drawing::of_update::<D, _, Single>(&Drift).unwrap();
        // All in one module, as a driver would have them.
        let text = [
            wgsl::pass(&density, &HEAD, mul_add).unwrap(),
            wgsl::pass(&momentum, &HEAD, mul_add).unwrap(),
            wgsl::update(&drift, &HEAD, mul_add).unwrap(),
        ];
        accepted(&text.concat()).unwrap();
    }
    for mul_add in [MulAdd::TwoRoundings, MulAdd::Fused] {
        check::<1>(mul_add);
        check::<2>(mul_add);
        check::<3>(mul_add);
    }
}

/// Hash maps iterate in a different order in every run; nothing of that may reach the text.
#[test]
fn the_text_is_the_same_every_time() {
    let first = momentum();
    for _ in 0..20 {
        assert_eq!(std::thread::spawn(momentum).join().unwrap(), first);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 500, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_programs_are_accepted(program in program(), fused in any::<bool>()) {
        let mul_add = if fused { MulAdd::Fused } else { MulAdd::TwoRoundings };
        match wgsl::function("random program", &drawn::<Single>(&program), &HEAD, mul_add) {
            Ok(text) => {
                let verdict = accepted(&text);
                prop_assert!(verdict.is_ok(), "{}", verdict.unwrap_err());
                let longest = text.lines().filter(|line| !line.trim_start().starts_with("//")).map(str::len).max();
                prop_assert!(longest <= Some(140), "a line of {longest:?} characters:\n{text}");
            }
            // A random program may divide one constant by another that is zero.
            Err(error) => prop_assert!(matches!(error, EmitError::NotFinite { .. }), "{error}"),
        }
    }
}

fn one(body: impl FnOnce(Symbol<Single>) -> Symbol<Single>) -> String {
    let drawing = draw::<Single>(|pen| {
        let x = pen.input("x");
        pen.output("y", body(x));
    });
    let text = wgsl::function("f", &drawing.unwrap(), &HEAD, MulAdd::TwoRoundings).unwrap();
    accepted(&text).unwrap();
    let assigned = text.lines().find_map(|line| line.trim().strip_prefix("out.y = "));
    assigned.unwrap().trim_end_matches(';').to_string()
}

#[test]
fn expressions_have_the_parentheses_they_need() {
    let c = Symbol::<Single>::lit;
    assert_eq!(one(|x| x - (c(3.0) - x)), "x - (3.0f - x)");
    assert_eq!(one(|x| (x - c(3.0)) - x), "x - 3.0f - x");
    assert_eq!(one(|x| x / (c(3.0) / x)), "x / (3.0f / x)");
    assert_eq!(one(|x| c(3.0) / x / c(7.0)), "3.0f / x / 7.0f");
    assert_eq!(one(|x| (c(3.0) + x) * (c(-5.0) * x)), "(3.0f + x) * (-5.0f * x)");
    assert_eq!(one(|x| -(x + c(3.0))), "-(x + 3.0f)");
    assert_eq!(one(|x| (-x) * c(3.0)), "-x * 3.0f");
    assert_eq!(one(|x| c(3.0) * (-x)), "3.0f * (-x)");
    assert_eq!(one(|x| x * c(3.0) + c(7.0)), "x * 3.0f + 7.0f");
    assert_eq!(one(|x| x.mul_add(c(3.0), c(-7.0))), "(x * 3.0f) - 7.0f");
    assert_eq!(one(|x| x.mul_add(c(3.0), x - c(7.0))), "(x * 3.0f) + (x - 7.0f)");
}

#[test]
fn masks_have_the_parentheses_they_need() {
    let c = Symbol::<Single>::lit;
    let chosen = one(|x| {
        let (low, high, odd) = (x.lt(c(3.0)), x.gt(c(7.0)), x.le(c(5.0)));
        low.or(high).and(odd.not().or(low)).choose(|| x, || c(-1.0))
    });
    assert!(chosen.starts_with("select(-1.0f, x, "), "{chosen}");
    assert!(chosen.contains("|| (7.0f < x)) && ("), "WGSL does not mix && and || without parentheses: {chosen}");
}

/// The shortest decimal that gives back the same bits.
#[test]
fn constants_are_short_and_exact() {
    for (value, text) in [(0.1, "0.1f"), (1e-7, "1.0e-7f"), (2.5e30, "2.5e30f"), (16_777_217.0, "16777216.0f")] {
        assert_eq!(one(|x| x + Symbol::lit(value)), format!("x + {text}"));
        let read: f32 = text.trim_end_matches('f').parse().unwrap();
        assert_eq!(read.to_bits(), (value as f32).to_bits());
    }
}

#[test]
fn what_wgsl_cannot_hold_is_refused_by_name() {
    let double = draw::<Double>(|pen| {
        let x = pen.input("x");
        pen.output("y", x);
    });
    let error = wgsl::function("f", &double.unwrap(), &HEAD, MulAdd::TwoRoundings).unwrap_err();
    assert_eq!(error.to_string(), "`f` was drawn in double precision, which WGSL lacks; draw it with `Single`");

    let infinite = draw::<Single>(|pen| {
        let x = pen.input("x");
        let y =
            Symbol::<Single>::equation("toy:1", "blow_up", || (x * (Symbol::one() / Symbol::zero())).named("blown"));
        pen.output("y", y);
    });
    let error = wgsl::function("f", &infinite.unwrap(), &HEAD, MulAdd::TwoRoundings).unwrap_err();
    let expected = "a constant in `blown` of `f` (toy:1 blow_up) is not finite; change the constants it is made of";
    assert_eq!(error.to_string(), expected);
}
