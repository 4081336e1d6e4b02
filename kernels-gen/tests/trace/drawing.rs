//! Drawing itself: names, equations, precision, misuse; and counting.

use etalon_kernels_gen::trace::{
    Count, Double, Drawing, Op, Scope, Significand, Single, Symbol, TraceError, draw, interpret,
};
use etalon_kernels_gen::{Mask, Nameable, Precision, Real, Vector};

fn counted(body: impl FnOnce(Symbol<Double>, Symbol<Double>) -> Symbol<Double>) -> Count {
    let drawing = draw::<Double>(|pen| {
        let (x, y) = (pen.input("x"), pen.input("y"));
        pen.output("result", body(x, y));
    });
    drawing.unwrap().simplified().count()
}

#[test]
fn counts_are_exact() {
    let none = Count::default();
    let lit = Symbol::<Double>::lit;
    assert_eq!(counted(|x, y| x * x + y * y), Count { multiply: 2, add: 1, ..none });
    assert_eq!(counted(|x, y| (x - y) / (x + y)), Count { add: 2, divide: 1, ..none });
    assert_eq!(
        counted(|x, y| x.mul_add(y, x).sqrt().abs()),
        Count { multiply_add: 1, square_root: 1, sign: 1, ..none }
    );
    assert_eq!(counted(|x, y| x.min(y).max(-x)), Count { min_max: 2, sign: 1, ..none });
    let chosen = |x: Symbol<Double>, y: Symbol<Double>| x.lt(y).and(x.gt(lit(0.0))).choose(|| x + y, || x * y);
    assert_eq!(counted(chosen), Count { compare: 2, select: 1, add: 1, multiply: 1, mask: 1, ..none });
    // The same product twice is one, whichever way round; what nobody needs is none.
    assert_eq!(
        counted(|x, y| {
            let _ = x / y;
            x * y + y * x
        }),
        Count { multiply: 1, add: 1, ..none }
    );
    // x^5 by repeated squaring: x^2, x^4, x^4 x.
    assert_eq!(counted(|x, _| x.power(5)), Count { multiply: 3, ..none });
    assert_eq!(counted(|x, y| x.mul_add(y, x)).flops(), 2);
    assert_eq!(counted(|x, y| x * x + y / x).to_string(), "3 (1 add, 1 multiply, 1 divide)");
}

#[test]
fn simplification_removes_what_changes_nothing() {
    let lit = Symbol::<Double>::lit;
    type Expression = fn(Symbol<Double>, Symbol<Double>) -> Symbol<Double>;
    let nothing: [Expression; 14] = [
        |x, _| x + Symbol::zero(),
        |x, _| Symbol::zero() + x,
        |x, _| x - Symbol::zero(),
        |x, _| x * Symbol::one() / Symbol::one(),
        |x, _| -(-x),
        |x, y| x + Symbol::zero() * y,
        |x, y| x - (y - y),
        |x, y| y.mul_add(Symbol::zero(), x),
        |x, y| x.lt(x).choose(|| y, || x),
        |x, y| Symbol::<Double>::lit(1.0).lt(Symbol::lit(2.0)).choose(|| x, || y),
        |x, y| x.lt(y).choose(|| x, || x),
        |x, _| x.min(x).max(x),
        |x, _| x * (Symbol::<Double>::lit(2.0) - Symbol::one()),
        |x, y| y.lt(x).or(x.le(x)).choose(|| x, || y),
    ];
    for (i, expression) in nothing.into_iter().enumerate() {
        let drawing = draw::<Double>(|pen| {
            let (x, y) = (pen.input("x"), pen.input("y"));
            pen.output("result", expression(x, y));
        });
        let simple = drawing.unwrap().simplified();
        let result = simple.graph().op(simple.outputs()[0].id);
        assert_eq!(result, Op::Input(0), "expression {i} should be x alone");
    }
    // Division by a power of two is a multiplication; by anything else it must stay.
    assert_eq!(counted(|x, _| x / lit(8.0)), Count { multiply: 1, ..Count::default() });
    assert_eq!(counted(|x, _| x / lit(3.0)), Count { divide: 1, ..Count::default() });
    // What is not finite is not folded: the printers refuse it, with its name.
    assert_eq!(counted(|x, _| x + lit(1.0) / lit(0.0)), Count { divide: 1, add: 1, ..Count::default() });
}

/// In single precision 0.1 + 0.2 is 0.3 rounded to `f32`, in double it is not 0.3.
#[test]
fn constants_are_folded_in_the_drawings_precision() {
    fn folded<F: Significand>() -> f64 {
        let drawing = draw::<F>(|pen| {
            let sum = Symbol::<F>::lit(0.1) + Symbol::lit(0.2);
            pen.output("sum", sum);
        });
        let simple = drawing.unwrap().simplified();
        simple.graph().literal(simple.outputs()[0].id).unwrap()
    }
    assert_eq!(folded::<Single>(), (0.1_f32 + 0.2_f32) as f64);
    assert_eq!(folded::<Double>(), 0.1 + 0.2);
    assert_eq!((Symbol::<Single>::PRECISION, Symbol::<Double>::PRECISION), (Precision::Single, Precision::Double));
}

#[test]
fn names_and_equations_are_remembered() {
    let drawing = draw::<Single>(|pen| {
        let v = Vector([pen.input("v_x"), pen.input("v_y")]);
        let outer = Symbol::<Single>::equation("toy:1", "outer", || {
            let squared = v.norm_squared().named("v_squared");
            Symbol::<Single>::equation("toy:2", "inner", || squared.sqrt()) + Symbol::one()
        });
        pen.output("result", outer * v.named("velocity")[0]);
    });
    let drawing = drawing.unwrap();
    let origin = |wanted: fn(&Op) -> bool| {
        let id = drawing.graph().ids().find(|id| wanted(&drawing.graph().op(*id))).unwrap();
        let node = drawing.graph().node(id);
        (node.name.clone(), node.scope.map(|scope| scope.id))
    };
    assert_eq!(origin(|op| matches!(op, Op::MulAdd(..))), (Some("v_squared".to_string()), Some("toy:1")));
    assert_eq!(origin(|op| matches!(op, Op::Sqrt(_))), (None, Some("toy:2")));
    assert_eq!(origin(|op| matches!(op, Op::Add(..))), (None, Some("toy:1")));
    // Inputs keep the name they came with, and belong to no equation.
    assert_eq!(origin(|op| matches!(op, Op::Input(_))), (None, None));
    let equations: Vec<&str> = drawing.equations().iter().map(|scope| scope.name).collect();
    assert_eq!(equations, ["outer", "inner"]);
    let scope = |id| Scope { id, name: "f" }.to_string();
    assert_eq!([scope("gs25:8"), scope("a book, page 7"), scope("")], ["gs25:8 f", "f (a book, page 7)", "f"]);
}

fn square() -> Result<Drawing, TraceError> {
    draw::<Single>(|pen| {
        let x = pen.input("x");
        pen.output("square", x * x);
    })
}

#[test]
fn misuse_is_an_error_and_leaves_nothing_behind() {
    let outer = draw::<Single>(|pen| {
        assert_eq!(square().unwrap_err(), TraceError::Nested);
        let x = pen.input("x");
        pen.output("same", x);
    });
    assert!(outer.is_ok(), "a refused inner drawing must not harm the outer one");

    let mut stolen = None;
    draw::<Single>(|pen| stolen = Some(pen.input("x"))).unwrap();
    let stolen = stolen.unwrap();
    let used = draw::<Single>(|pen| {
        let x = pen.input("x");
        pen.output("sum", x + stolen);
    });
    assert_eq!(used.unwrap_err(), TraceError::ForeignSymbol);
    let given = draw::<Single>(|pen| pen.output("stolen", stolen));
    assert_eq!(given.unwrap_err(), TraceError::ForeignSymbol);
    // Outside of any drawing a symbol is inert.
    let _ = (stolen + Symbol::one()).sqrt().lt(stolen).choose(|| stolen, || -stolen);

    let twice = draw::<Single>(|pen| {
        let x = pen.input("x");
        pen.output("x", x);
        pen.output("x", x);
    });
    assert_eq!(twice.unwrap_err(), TraceError::DuplicateOutput { name: "x".to_string() });

    let panicked = std::panic::catch_unwind(|| draw::<Single>(|_| panic!("on purpose")));
    assert!(panicked.is_err());
    assert_eq!(square().unwrap().graph().len(), 2, "a panic must leave a clean sheet");

    let error = interpret(&square().unwrap(), &[1.0_f32, 2.0]).unwrap_err();
    assert_eq!(error.to_string(), "the drawing has 1 inputs but 2 values were given; give one per input, in order");
}

/// Drawings on several threads at once do not see each other.
#[test]
fn threads_draw_independently() {
    let one = |factor: u32| {
        let drawing = draw::<Double>(|pen| {
            let x = pen.input("x");
            let product = (0..factor).fold(Symbol::one(), |product, _| product * x);
            pen.output("power", product);
        });
        interpret(&drawing.unwrap(), &[2.0_f64]).unwrap()[0]
    };
    std::thread::scope(|threads| {
        let running: Vec<_> = (1..9).map(|n| threads.spawn(move || one(n))).collect();
        let found: Vec<f64> = running.into_iter().map(|thread| thread.join().unwrap()).collect();
        assert_eq!(found, [2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0, 256.0]);
    });
}
