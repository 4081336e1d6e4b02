//! Third source of error: the polynomials that stand for sine and exponential inside the kernels.

use crate::command::choices::Precision;
use crate::command::setup::Setup;
use crate::report::model::{KernelApproximation, Tolerance};
use etalon_kernels_gen::polynomials::{
    EXPM1_NEGATIVE, Polynomial, SINC, SINC_4_NORMALISATION, SINC_9_NORMALISATION, SINC_SLOPE_DOUBLE_ERROR,
    SINC_SLOPE_SINGLE_ERROR,
};
use etalon_reference::equations::kernels::MIXED_SINC_WEIGHTS;
use etalon_reference::schemes::Kernel;

/// What a scene's kernels approximate, in the precisions that run.
pub fn approximations(setup: &Setup, precisions: &[Precision]) -> Vec<KernelApproximation> {
    let mut all = Vec::new();
    for &precision in precisions {
        if setup.method().kernel == Kernel::MixedSinc {
            all.extend(sinc(setup.dimension, precision));
        }
        let dissipation = setup.method().viscosity.dissipation;
        if dissipation.reconstructs() {
            all.push(exponential("cut-off of the reconstruction exp(−y)", precision));
        }
        if dissipation.switches() {
            all.push(exponential("decay of the viscosity coefficient exp(−y)", precision));
        }
    }
    all
}

fn terms(polynomial: &Polynomial, precision: Precision) -> usize {
    match precision {
        Precision::Single => polynomial.single.len(),
        Precision::Double => polynomial.double.len(),
    }
}

fn tolerance(precision: Precision) -> Tolerance {
    Tolerance::new(precision.unit_roundoff(), "one rounding of the function’s largest value")
}

/// The mixed kernel and its slope. With a relative error e of the sinc, its n-th power is off by (1 + e)^n - 1, and the slope of that power by the
/// error of n - 1 sincs and that of the sinc's slope; no power of a sinc exceeds 1.
fn sinc(dimension: usize, precision: Precision) -> [KernelApproximation; 2] {
    let (error, slope_error) = match precision {
        Precision::Single => (SINC.single_error, SINC_SLOPE_SINGLE_ERROR),
        Precision::Double => (SINC.double_error, SINC_SLOPE_DOUBLE_ERROR),
    };
    // ln and exp keep the digits that 1 + e would lose.
    let power = |n: f64| (n * error.ln_1p()).exp_m1();
    let weights = [
        MIXED_SINC_WEIGHTS[0].times(SINC_4_NORMALISATION[dimension - 1]).value(),
        MIXED_SINC_WEIGHTS[1].times(SINC_9_NORMALISATION[dimension - 1]).value(),
    ];
    let value = (weights[0] * power(4.0) + weights[1] * power(9.0)) / (weights[0] + weights[1]);
    let degree = 2 * terms(&SINC, precision);
    let entry = |function: &str, max| KernelApproximation {
        function: function.into(),
        approximation: format!("sinc(πq/2) as a polynomial of degree {degree} in q, raised to the powers 4 and 9"),
        precision: precision.name().into(),
        max,
        tolerance: tolerance(precision),
    };
    [
        entry("mixed sinc kernel w(q)", value),
        entry("its slope dw/dq", ((8.0 * error.ln_1p()) + slope_error.ln_1p()).exp_m1()),
    ]
}

/// exp(-y) of the reconstruction's cut-off at short range, or of a coefficient's decay. A relative error of the polynomial becomes at most 0.38 of it in the result.
fn exponential(function: &str, precision: Precision) -> KernelApproximation {
    let error = match precision {
        Precision::Single => EXPM1_NEGATIVE.single_error,
        Precision::Double => EXPM1_NEGATIVE.double_error,
    };
    KernelApproximation {
        function: function.into(),
        approximation: format!(
            "polynomial of degree {} in y/32, squared five times",
            terms(&EXPM1_NEGATIVE, precision)
        ),
        precision: precision.name().into(),
        max: 0.38 * error,
        tolerance: tolerance(precision),
    }
}
