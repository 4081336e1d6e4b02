//! Random programs of the language that equations are written in.

use etalon_kernels_gen::trace::{Drawing, Significand, Symbol, draw};
use etalon_kernels_gen::{Mask, Real};
use proptest::prelude::*;

/// The number of inputs of every program.
pub const INPUTS: usize = 4;

/// One step. Operands are places in the list of values so far, taken modulo its length.
#[derive(Clone, Debug)]
pub enum Step {
    Literal(f64),
    Unary(u8, usize),
    Binary(u8, usize, usize),
    MulAdd(usize, usize, usize),
    Power(usize, u32),
    Choose { tests: [(u8, usize, usize); 3], joins: (u8, u8), yes: (u8, usize, usize), no: (u8, usize, usize) },
    Named(usize, u8),
    Equation(u8, Box<Step>),
}

/// A list of steps; the last three values are the results.
pub type Program = Vec<Step>;

const LITERALS: [f64; 12] = [0.0, 1.0, -1.0, 0.5, 2.0, -2.0, 3.0, 0.1, -0.3, 1e-7, 1234.5, 0.0625];
// Among them words that WGSL or C keep for themselves, and what no language takes.
const NAMES: [&str; 8] = ["q", "target", "min", "double", "_x", "gradient_x", "v_ab", "2nd"];
const EQUATIONS: [(&str, &str); 3] = [("toy:1", "limiter"), ("toy:2, toy:3", "sqrt"), ("a book, page 7", "kernel")];

/// What a program does, on any number type.
pub fn run<R: Real>(program: &[Step], inputs: [R; INPUTS]) -> Vec<R> {
    let mut values = inputs.to_vec();
    for step in program {
        let value = run_step(step, &values);
        values.push(value);
    }
    values.split_off(values.len().saturating_sub(3))
}

fn run_step<R: Real>(step: &Step, values: &[R]) -> R {
    let at = |place: &usize| values[place % values.len()];
    match step {
        Step::Literal(value) => R::lit(*value),
        Step::Unary(kind, a) => match kind % 4 {
            0 => -at(a),
            1 => at(a).abs(),
            2 => at(a).abs().sqrt(),
            _ => at(a).squared(),
        },
        Step::Binary(kind, a, b) => binary(*kind, at(a), at(b)),
        Step::MulAdd(a, b, c) => at(a).mul_add(at(b), at(c)),
        Step::Power(a, exponent) => at(a).power(*exponent),
        Step::Choose { tests, joins, yes, no } => {
            let [first, second, third] = tests.map(|(kind, a, b)| compare(kind, at(&a), at(&b)));
            let mask = join(joins.0, first, join(joins.1, second, third));
            mask.choose(|| binary(yes.0, at(&yes.1), at(&yes.2)), || binary(no.0, at(&no.1), at(&no.2)))
        }
        Step::Named(a, name) => at(a).named(NAMES[*name as usize % NAMES.len()]),
        Step::Equation(which, inner) => {
            let (id, name) = EQUATIONS[*which as usize % EQUATIONS.len()];
            R::equation(id, name, || run_step(inner, values))
        }
    }
}

fn binary<R: Real>(kind: u8, a: R, b: R) -> R {
    match kind % 7 {
        0 => a + b,
        1 => a - b,
        2 => a * b,
        3 => a / b,
        4 => a.min(b),
        5 => a.max(b),
        _ => R::pick(a.lt(b), a, b),
    }
}

fn join<M: Mask>(kind: u8, a: M, b: M) -> M {
    match kind % 5 {
        0 => a.and(b),
        1 => a.or(b),
        2 => b.or(a.and(b.not())),
        3 => a.not(),
        _ => b,
    }
}

fn compare<R: Real>(kind: u8, a: R, b: R) -> R::Mask {
    match kind % 4 {
        0 => a.lt(b),
        1 => a.le(b),
        2 => a.gt(b),
        _ => a.ge(b),
    }
}

/// The program's drawing.
pub fn drawn<F: Significand>(program: &[Step]) -> Drawing {
    let drawing = draw::<F>(|pen| {
        let inputs: [Symbol<F>; INPUTS] = std::array::from_fn(|i| pen.input(&format!("input_{i}")));
        for (i, value) in run(program, inputs).into_iter().enumerate() {
            pen.output(&format!("result_{i}"), value);
        }
    });
    drawing.expect("a program uses only its own symbols")
}

/// Programs of up to thirty steps.
pub fn program() -> impl Strategy<Value = Program> {
    let place = 0..64_usize;
    let operation = || (any::<u8>(), place.clone(), place.clone());
    let plain = prop_oneof![
        2 => prop::sample::select(&LITERALS[..]).prop_map(Step::Literal),
        2 => (any::<u8>(), place.clone()).prop_map(|(kind, a)| Step::Unary(kind, a)),
        4 => operation().prop_map(|(kind, a, b)| Step::Binary(kind, a, b)),
        2 => (place.clone(), place.clone(), place.clone()).prop_map(|(a, b, c)| Step::MulAdd(a, b, c)),
        1 => (place.clone(), 0..4_u32).prop_map(|(a, n)| Step::Power(a, n)),
        2 => ([operation(), operation(), operation()], any::<(u8, u8)>(), operation(), operation())
            .prop_map(|(tests, joins, yes, no)| Step::Choose { tests, joins, yes, no }),
        2 => (place.clone(), any::<u8>()).prop_map(|(a, name)| Step::Named(a, name)),
    ];
    let step = (plain, prop::option::of(any::<u8>())).prop_map(|(step, equation)| match equation {
        Some(which) if which < 100 => Step::Equation(which, Box::new(step)),
        _ => step,
    });
    prop::collection::vec(step, 3..30)
}

/// Inputs: small whole numbers (which meet often), and anything of moderate size.
pub fn inputs() -> impl Strategy<Value = [f64; INPUTS]> {
    let number = prop_oneof![(-3..4_i32).prop_map(f64::from), -10.0..10.0_f64];
    [number.clone(), number.clone(), number.clone(), number].prop_map(|values| values.map(|v| v as f32 as f64))
}
