//! What an equation's evaluation gains over the form that a textbook or the paper writes: the error of both on the same inputs against the same
//! oracle, and what either costs.
//!
//! A [`Textbook`] form is a second formula for something that has one. It is here on purpose: it is not used for anything but this
//! comparison, is named for what it is, and says where it stands.

mod elementary;
mod forms;

pub use elementary::Elementary;

use crate::probe::Probe;
use crate::probes::probes;
use crate::quad::Quad;
use crate::sample::{BLOCK, all_inputs};
use crate::target::Target;
use etalon_kernels_gen::trace::{Count, Single, Symbol, TraceError, draw};
use rayon::prelude::*;
use std::sync::LazyLock;

/// A form that the code does not use.
pub struct Textbook {
    /// The key of the probe whose results it gives too.
    pub probe: &'static str,
    /// The form in LaTeX.
    pub formula: &'static str,
    /// Who writes it so.
    pub source: &'static str,
    /// What goes wrong with it, and what the code does instead.
    pub trouble: &'static str,
    /// What the probe's inputs are multiplied by, in words, where it shows outside of the declared domain only. Powers of two: ours does not
    /// care.
    pub stretched: Option<&'static str>,
    /// Which of the inputs are compared, in words, if not all are.
    pub restricted: Option<&'static str>,
    prepare: fn(&mut [f64]) -> bool,
    single: fn(&[f32]) -> Vec<f32>,
    double: fn(&[f64]) -> Vec<f64>,
    quad: fn(&[Quad]) -> Vec<Quad>,
    symbol: fn(&[Symbol<Single>]) -> Vec<Symbol<Single>>,
}

/// The errors of a form and of the code.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Errors {
    /// How many inputs were compared.
    pub inputs: usize,
    /// The largest error of the textbook's form, in ulps of the natural scale of ours.
    pub textbook: f64,
    /// The largest error of ours.
    pub ours: f64,
    /// For how many inputs the textbook's form gave infinity or NaN.
    pub textbook_not_finite: usize,
    /// For how many ours did.
    pub ours_not_finite: usize,
}

macro_rules! textbook {
    ($probe:literal: |$x:ident| $form:expr; $formula:literal; $source:literal; $trouble:literal;
     $(@stretched $stretched:literal;)? $(@restricted $restricted:literal;)? $prepare:expr) => {{
        fn evaluate<R: Elementary>($x: &[R]) -> Vec<R> {
            Vec::from($form)
        }
        Textbook {
            probe: $probe,
            formula: $formula,
            source: $source,
            trouble: $trouble,
            stretched: None$(.or(Some($stretched)))?,
            restricted: None$(.or(Some($restricted)))?,
            prepare: $prepare,
            single: evaluate::<f32>,
            double: evaluate::<f64>,
            quad: evaluate::<Quad>,
            symbol: evaluate::<Symbol<Single>>,
        }
    }};
}

/// Two results as a list.
fn pair<R>((a, b): (R, R)) -> [R; 2] {
    [a, b]
}

fn scale(x: &mut [f64], exponent: i32) {
    x.iter_mut().for_each(|x| *x *= 2_f64.powi(exponent));
}

static TEXTBOOKS: LazyLock<Vec<Textbook>> = LazyLock::new(|| {
    vec![
        textbook! {
            "kernels::sinc_half_pi": |x| pair(forms::sinc(x[0]));
            r"\frac{\sin x}{x},\quad \left(\cos x - \frac{\sin x}{x}\right)\frac{\pi^2}{2x^2},\quad x = \pi\sqrt{t}";
            "Cabezón, García-Senz & Relaño 2008, the kernel as it is defined";
            "0/0 at the centre, a difference of nearly equal numbers near it, and at the edge the rounding of $x$; the code has a polynomial in $t$ with the edge as a factor";
            |_| true
        },
        textbook! {
            "kernels::quintic_spline 3-D": |x| pair(forms::quintic_spline(x[0]));
            r"B\,(243 - 405 q + 270 q^2 - 90 q^3 + 15 q^4 - q^5)\ \ldots";
            "the piecewise polynomial of Morris 1996, multiplied out";
            "near the edge hundreds cancel to almost nothing; the code keeps the truncated powers";
            |_| true
        },
        textbook! {
            "reconstruction::slope_limiter": |x| [forms::slope_limiter(x[0], x[1])];
            r"\max\left[0, \min\left(1, \frac{4F}{(1+F)^2}\right)\right],\quad F = \frac{A}{B}";
            "GS25 (13) and (17), as printed";
            "0/0 where both slopes vanish, infinity over infinity where one does or they are far apart; the code divides the smaller size by the sum of both";
            @stretched "$A$ by $2^{70}$";
            |x| { scale(&mut x[..1], 70); true }
        },
        textbook! {
            "limiters::slope_van_leer": |x| [forms::van_leer(x[0], x[1])];
            r"\frac{2ab}{a+b}\ \text{where}\ ab > 0";
            "PL20 (14), as printed";
            "the product leaves the number's range long before the slopes do; the code compares signs one by one and forms a ratio";
            @stretched "both slopes by $2^{-70}$";
            |x| { scale(x, -70); true }
        },
        textbook! {
            "gradients::inverse_moments 3-D": |x| forms::inverse([x[0], x[1], x[2], x[3], x[4], x[5]]);
            r"\tau^{-1} = \frac{\operatorname{adj}\tau}{\det\tau}";
            "C25 (1), the inverse by Cramer's rule";
            "the determinant is of the size of $h^6$ and leaves the number's range; the code divides by the trace first";
            @stretched "the matrix by $2^{-44}$, as for smoothing lengths of $2^{-22}$";
            @restricted "neighbourhoods that span the space: elsewhere ours is another matrix on purpose";
            |x| { let spans = quality(x) > 2e-3; scale(x, -44); spans }
        },
        textbook! {
            "hydrodynamics::pressure_coefficient": |x| [forms::pressure_coefficient(x[0], x[1], x[2], x[3])];
            r"\frac{P_a}{\Omega_a k_a (\rho^0_a)^2}";
            "C25 (22), as printed";
            "the square of the density leaves the number's range; the code divides twice";
            @stretched "pressure and density by $2^{64}$";
            @restricted "$\\Omega_a > 0$: elsewhere ours is zero on purpose";
            |x| { scale(&mut x[..1], 64); scale(&mut x[3..], 64); x[1] > 0.0 }
        },
        textbook! {
            "equation_of_state::pressure": |x| [forms::pressure(x[0], x[1], x[2])];
            r"(\gamma - 1)\,\rho\,u";
            "GS25 section 4, with its $\\gamma = 1.001$";
            "an adiabatic index near one loses its digits to the one; the code is given $\\gamma - 1$";
            |_| true
        },
        textbook! {
            "stiff_drag::decayed_share": |x| [forms::decayed_share(x[0], x[1])];
            r"1 - e^{-w\,\Delta t}";
            "the decay of PL20 (4), (5) solved, as one writes it";
            "a short step rounds to nothing; the code has $e^{-y} - 1$ as such";
            |_| true
        },
        textbook! {
            "turbulence::ornstein_uhlenbeck_step": |x| [forms::ornstein_uhlenbeck(x[0], x[1], x[2], x[3])];
            r"f x + \sigma\sqrt{1 - f^2}\,z,\quad f = e^{-\Delta t/T}";
            "Uhlenbeck & Ornstein 1930; SPH-EXA's driving";
            "the noise of a short step vanishes; the code has $e^{-y} - 1$ as such";
            |_| true
        },
    ]
});

/// `det(3 tau / tr tau)`, as the code has it: one for an isotropic neighbourhood, zero for a flat one.
fn quality(m: &[f64]) -> f64 {
    let [xx, xy, xz, yy, yz, zz] = [m[0], m[1], m[2], m[3], m[4], m[5]];
    let third = (xx + yy + zz) / 3.0;
    let determinant = xx * (yy * zz - yz * yz) + xy * (xz * yz - xy * zz) + xz * (xy * yz - xz * yy);
    if third > 0.0 { determinant / third.powi(3) } else { 0.0 }
}

/// All textbook forms.
#[must_use]
pub fn textbooks() -> &'static [Textbook] {
    &TEXTBOOKS
}

impl Textbook {
    /// The probe of the code's own form.
    #[must_use]
    pub fn of_probe(&self) -> Option<&'static Probe> {
        probes().iter().find(|probe| probe.key() == self.probe)
    }

    /// The probe's inputs as they are compared: all hard ones and at least so many random ones, stretched, those left out that are not compared.
    #[must_use]
    pub fn inputs(&self, probe: &Probe, samples: usize) -> Vec<Vec<f64>> {
        let mut inputs = all_inputs(probe, samples);
        inputs.retain_mut(|x| (self.prepare)(x));
        inputs
    }

    /// The form with the oracle's digits.
    #[must_use]
    pub fn exact(&self, inputs: &[f64]) -> Vec<Quad> {
        (self.quad)(&inputs.iter().map(|x| Quad::exact(*x)).collect::<Vec<_>>())
    }

    /// The errors of both forms in `f32` and in `f64`, in the scalar arithmetic.
    #[must_use]
    pub fn measure(&self, samples: usize) -> [Errors; 2] {
        let Some(probe) = self.of_probe() else { return Default::default() };
        let inputs = self.inputs(probe, samples);
        [Target::ScalarSingle, Target::ScalarDouble].map(|target| {
            let blocks = inputs.par_chunks(BLOCK).map(|block| self.measure_block(probe, target, block));
            blocks.reduce(Errors::default, Errors::and)
        })
    }

    fn measure_block(&self, probe: &Probe, target: Target, inputs: &[Vec<f64>]) -> Errors {
        let mut errors = Errors::default();
        for raw in inputs {
            let inputs: Vec<f64> = raw.iter().map(|x| target.round(*x)).collect();
            let exact: Vec<Quad> = inputs.iter().map(|x| Quad::exact(*x)).collect();
            let truths = probe.evaluate(&exact).unwrap_or_default(); // as many inputs as the probe has
            let gauges = target.gauge(probe, &inputs);
            let textbook: Vec<f64> = match target {
                Target::ScalarSingle => {
                    let inputs: Vec<f32> = inputs.iter().map(|x| *x as f32).collect();
                    (self.single)(&inputs).into_iter().map(f64::from).collect()
                }
                _ => (self.double)(&inputs),
            };
            let ours = target.run(probe, &inputs);
            errors.inputs += 1;
            errors.textbook_not_finite += usize::from(!textbook.iter().all(|x| x.is_finite()));
            errors.ours_not_finite += usize::from(!ours.iter().all(|x| x.is_finite()));
            for ((truth, (scale, _)), (textbook, ours)) in truths.iter().zip(gauges).zip(textbook.iter().zip(&ours)) {
                let ulps = |found: f64| {
                    let error = if found.is_finite() { truth.distance(found) / target.ulp(scale) } else { 0.0 };
                    if error.is_finite() { error } else { 0.0 }
                };
                errors.textbook = errors.textbook.max(ulps(*textbook));
                errors.ours = errors.ours.max(ulps(*ours));
            }
        }
        errors
    }

    /// What the form costs in `f32`, as its drawing counts.
    ///
    /// # Errors
    /// [`TraceError`] from inside another drawing.
    pub fn operations(&self) -> Result<Count, TraceError> {
        let names = self.of_probe().map(Probe::input_names).unwrap_or_default();
        let drawing = draw::<Single>(|pen| {
            let inputs: Vec<_> = names.iter().map(|name| pen.input(name)).collect();
            for (place, value) in (self.symbol)(&inputs).into_iter().enumerate() {
                pen.output(&format!("result_{place}"), value);
            }
        })?;
        Ok(Count::of(&drawing.simplified()))
    }
}

impl Errors {
    fn and(self, other: Self) -> Self {
        Errors {
            inputs: self.inputs + other.inputs,
            textbook: self.textbook.max(other.textbook),
            ours: self.ours.max(other.ours),
            textbook_not_finite: self.textbook_not_finite + other.textbook_not_finite,
            ours_not_finite: self.ours_not_finite + other.ours_not_finite,
        }
    }
}
