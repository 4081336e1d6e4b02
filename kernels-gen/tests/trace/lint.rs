//! Every rewritable shape is found, with its name and equation; harmless relatives are not.

use etalon_kernels_gen::trace::{Finding, Pattern, Single, Symbol, draw};
use etalon_kernels_gen::{Nameable, Real};

type Number = Symbol<Single>;

fn findings(body: impl FnOnce(Number, Number, Number) -> Number) -> Vec<Finding> {
    let drawing = draw::<Single>(|pen| {
        let (x, y, z) = (pen.input("x"), pen.input("y"), pen.input("z"));
        pen.output("result", Number::equation("toy:1", "equation", || body(x, y, z)));
    });
    drawing.unwrap().simplified().lint()
}
fn patterns(body: impl FnOnce(Number, Number, Number) -> Number) -> Vec<Pattern> {
    findings(body).iter().map(|finding| finding.pattern).collect()
}
fn c(value: f64) -> Number {
    Number::lit(value)
}

#[test]
fn each_pattern_is_found() {
    use Pattern::*;
    assert_eq!(patterns(|x, y, _| (x * y) * c(0.3)), [ProductTimesConstant]);
    assert_eq!(patterns(|x, y, _| c(0.3) * (x * y)), [ProductTimesConstant]);
    assert_eq!(patterns(|x, _, _| x * c(0.3) * c(0.7)), [ProductTimesConstant]);
    assert_eq!(patterns(|x, y, z| (x * y).mul_add(c(0.3), z)), [ProductTimesConstant]);
    assert_eq!(patterns(|x, _, _| (x + c(0.3)) + c(0.7)), [SumPlusConstant]);
    assert_eq!(patterns(|x, _, _| c(0.3) - (x - c(0.7))), [SumPlusConstant]);
    assert_eq!(patterns(|x, y, _| x.mul_add(y, c(0.3)) + c(0.7)), [SumPlusConstant]);
    assert_eq!(patterns(|x, y, z| x * y + x * z), [SharedFactor]);
    assert_eq!(patterns(|x, y, z| y * x - z * x), [SharedFactor]);
    assert_eq!(patterns(|x, y, z| x.mul_add(y, z * x)), [SharedFactor]);
    assert_eq!(patterns(|x, y, _| (x + y) - x), [SumMinusPart]);
    assert_eq!(patterns(|x, y, _| x - (x - y)), [SumMinusPart]);
    assert_eq!(patterns(|x, y, _| (x - y) + y), [SumMinusPart]);
    assert_eq!(patterns(|x, _, _| x.sqrt() * x.sqrt()), [RootSquared]);
    assert_eq!(patterns(|x, y, _| x.sqrt().mul_add(x.sqrt(), y)), [RootSquared]);
    assert_eq!(patterns(|x, _, _| c(1.0) - (c(1.0) - x)), [ConstantMinusDifference]);
    assert_eq!(patterns(|x, _, _| x / c(3.0)), [DivisionByConstant]);
    assert_eq!(patterns(|x, y, _| x / y * y), [QuotientTimesDivisor]);
    assert_eq!(patterns(|x, y, z| (x / y).mul_add(y, z)), [QuotientTimesDivisor]);
    assert_eq!(Pattern::ALL.len(), 8);
}

#[test]
fn what_drivers_leave_alone_is_not_reported() {
    let harmless: [fn(Number, Number, Number) -> Number; 11] = [
        |x, y, _| (x * c(0.3)) * y,
        |x, y, _| (x * y) * c(0.5), // a power of two moves without rounding
        |x, _, _| x / c(4.0),
        |x, _, _| (c(0.3) * x + c(0.7)) * x + c(0.1),
        |x, _, _| c(0.3).mul_add(x, c(0.7)).mul_add(x, c(0.1)),
        |x, y, z| x * y + z * z,
        |x, y, _| x * y + y * x,
        |x, y, _| (x + y) + x,
        |x, y, _| (x - y) - y,
        |x, y, _| x.sqrt() * y.sqrt(),
        |x, y, z| x / y * z,
    ];
    for (i, expression) in harmless.into_iter().enumerate() {
        assert_eq!(patterns(expression), [], "expression {i}");
    }
}

#[test]
fn a_finding_says_where_and_what_to_do() {
    let found = findings(|x, y, _| {
        let force = ((x + y).named("total") * y * c(0.3)).named("force");
        force + y
    });
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].name, "force");
    assert_eq!(
        found[0].to_string(),
        "toy:1 equation: `(total * y) * 0.3` in `force` has the form (x * y) * c, which drivers rewrite; multiply the \
         constant into one factor beforehand"
    );
}
