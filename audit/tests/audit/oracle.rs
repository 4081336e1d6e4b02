//! The oracle against tables that mpmath made: thirty digits, from fitted polynomials to whole kernels.

use etalon_audit::{Probe, Quad, probes};
use etalon_kernels_gen::functions::{cube_root, exp_negative, horner};
use etalon_kernels_gen::polynomials::ARTANH;
use etalon_kernels_gen::{Precision, Real};
use etalon_reference::equations::kernels::sinc_half_pi;
use serde::Deserialize;

/// What is promised: thirty significant digits.
const PROMISED: f64 = 1e-30;

#[derive(Deserialize)]
struct Functions {
    function: Vec<Function>,
}
#[derive(Deserialize)]
struct Function {
    name: String,
    values: Vec<At>,
}
#[derive(Deserialize)]
struct At {
    x: f64,
    value: String,
}

#[test]
fn functions_have_thirty_digits() {
    assert_eq!(Quad::PRECISION, Precision::Extended);
    let text = include_str!("../../../kernels-gen/coefficients/function_values.toml");
    let functions = toml::from_str::<Functions>(text).unwrap().function;
    assert_eq!(functions.len(), 6);
    for function in functions {
        let evaluate = |x: Quad| match function.name.as_str() {
            "sinc" => sinc_half_pi(x).0,
            "sinc_slope" => sinc_half_pi(x).1,
            "exp_negative" => exp_negative(x),
            "artanh" => x * horner(&ARTANH, Quad::exact(4.0) * x * x),
            "square_root" => x.sqrt(),
            "cube_root" => cube_root(x),
            other => panic!("no function {other}"),
        };
        let error = |at: &At| {
            let expected: Quad = at.value.parse().unwrap();
            ((evaluate(Quad::exact(at.x)) - expected) / expected).abs().to_f64()
        };
        let worst = function.values.iter().map(error).fold(0.0, f64::max);
        println!("{}: {worst:e} relative, promised {PROMISED:e}", function.name);
        assert!(worst < PROMISED && function.values.len() > 15, "{}: {worst:e}", function.name);
    }
}

#[derive(Deserialize)]
struct Kernels {
    kernel: Vec<Kernel>,
}
#[derive(Deserialize)]
struct Kernel {
    name: String,
    dimension: usize,
    values: Vec<Shape>,
}
#[derive(Deserialize)]
struct Shape {
    q: f64,
    w: String,
    dw: String,
}

#[test]
fn kernels_have_thirty_digits() {
    let text = include_str!("../../../kernels-gen/coefficients/kernel_values.toml");
    let kernels = toml::from_str::<Kernels>(text).unwrap().kernel;
    assert_eq!(kernels.len(), 18);
    for kernel in kernels {
        let function = match kernel.name.as_str() {
            "sinc_4_9" => "mixed_sinc",
            "m4" => "cubic_spline",
            "m6" => "quintic_spline",
            other => other,
        };
        let of = |probe: &&Probe| probe.function == function && probe.dimension == Some(kernel.dimension);
        let probe = probes().iter().find(of).unwrap_or_else(|| panic!("no probe of {function}"));
        let mut worst = 0.0_f64;
        for Shape { q, w, dw } in &kernel.values {
            let q = Quad::exact(*q);
            let shape = probe.evaluate(&[q * q]).unwrap();
            let (w, dw): (Quad, Quad) = (w.parse().unwrap(), dw.parse().unwrap());
            // Near the edge a power of a small distance is what is left; the square that goes in has its own rounding.
            // Relative to the value, and below 1e-20 of the central value, to that.
            let floor = Quad::exact(1e-20);
            let error = |found: Quad, expected: Quad| ((found - expected).abs() / expected.abs().max(floor)).to_f64();
            worst = worst.max(error(shape[0], w)).max(error(shape[1] * q, dw));
        }
        println!("{} {}-D: {worst:e}, promised {PROMISED:e}", kernel.name, kernel.dimension);
        assert!(worst < 10.0 * PROMISED, "{} {}-D: {worst:e}", kernel.name, kernel.dimension);
    }
}
