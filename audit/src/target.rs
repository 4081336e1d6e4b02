//! What equations are measured on.

use crate::gauge::{Gauge, Promise, Wgsl};
use crate::number::Number;
use crate::probe::Probe;
use etalon_kernels_gen::trace::{Double, Single};
use etalon_kernels_gen::{Fused, Precision};
use std::fmt;
use std::str::FromStr;

/// How a bound or a figure is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Label {
    /// It follows from the operations.
    Proven,
    /// It was found by trying, and holds for what was tried.
    Measured,
    /// It rests on what others promise, or were seen to do.
    Believed,
}

impl fmt::Display for Label {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Label::Proven => "proven",
            Label::Measured => "measured",
            Label::Believed => "believed",
        })
    }
}

/// An arithmetic in which equations run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Target {
    /// The scalar reference in `f32`: two roundings in a multiply-add. WGSL's text asks for the same.
    ScalarSingle,
    /// The scalar reference in `f64`.
    ScalarDouble,
    /// A lane of the vector engine in `f32`: one rounding in a multiply-add.
    LanesSingle,
    /// A lane of the vector engine in `f64`.
    LanesDouble,
    /// The equation's WGSL, run by a [`Device`](crate::Device).
    WgslSingle,
}

impl Target {
    /// All of them.
    pub const ALL: [Target; 5] =
        [Target::ScalarSingle, Target::ScalarDouble, Target::LanesSingle, Target::LanesDouble, Target::WgslSingle];
    /// Those that any machine can run.
    pub const HERE: [Target; 4] =
        [Target::ScalarSingle, Target::ScalarDouble, Target::LanesSingle, Target::LanesDouble];

    /// Its name, as records and tables write it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Target::ScalarSingle => "scalar f32",
            Target::ScalarDouble => "scalar f64",
            Target::LanesSingle => "lanes f32",
            Target::LanesDouble => "lanes f64",
            Target::WgslSingle => "wgsl f32",
        }
    }
    /// Its precision.
    #[must_use]
    pub const fn precision(self) -> Precision {
        match self {
            Target::ScalarSingle | Target::LanesSingle | Target::WgslSingle => Precision::Single,
            Target::ScalarDouble | Target::LanesDouble => Precision::Double,
        }
    }
    /// How the budget on it is known: it follows from the operations, but what WGSL promises of these a driver has to be believed.
    #[must_use]
    pub const fn budget_label(self) -> Label {
        match self {
            Target::WgslSingle => Label::Believed,
            _ => Label::Proven,
        }
    }
    /// What else computes the very same bits, with how that is known.
    #[must_use]
    pub const fn stands_for(self) -> &'static [(&'static str, Label)] {
        match self {
            Target::ScalarSingle => &[
                ("C99 in float without contraction", Label::Measured),
                ("WGSL, on a device that rounds + - * / and sqrt correctly and rewrites nothing", Label::Believed),
            ],
            Target::ScalarDouble => &[("C99 in double without contraction", Label::Measured)],
            Target::LanesSingle | Target::LanesDouble => {
                &[("AVX-512, AVX2, portable lanes", Label::Measured), ("NEON lanes", Label::Believed)]
            }
            Target::WgslSingle => &[],
        }
    }
    /// A number as this target holds it.
    #[must_use]
    pub fn round(self, value: f64) -> f64 {
        match self.precision() {
            Precision::Single => f64::from(value as f32),
            Precision::Double | Precision::Extended => value,
        }
    }
    /// The distance between neighbouring numbers of this target's precision at `value`.
    #[must_use]
    pub fn ulp(self, value: f64) -> f64 {
        let (digits, least) = match self.precision() {
            Precision::Single => (24, f64::from(f32::from_bits(1))),
            Precision::Double | Precision::Extended => (53, f64::from_bits(1)),
        };
        if value == 0.0 || !value.is_finite() {
            return if value == 0.0 { least } else { f64::INFINITY };
        }
        // The exponent of a subnormal f64 reads as -1023, which is below every floor.
        let exponent = ((value.to_bits() >> 52) & 0x7ff) as i32 - 1023;
        power_of_two(exponent - digits + 1).max(least)
    }
    /// Runs the equation on numbers this target holds exactly, in its arithmetic; nothing of what only a device can run.
    pub(crate) fn run(self, probe: &Probe, inputs: &[f64]) -> Vec<f64> {
        match self {
            Target::WgslSingle => Vec::new(),
            Target::ScalarSingle => values(probe, inputs, |x| x as f32, f64::from),
            Target::ScalarDouble => values(probe, inputs, |x| x, |x: f64| x),
            Target::LanesSingle => values(probe, inputs, |x| Fused(x as f32), |x| f64::from(x.0)),
            Target::LanesDouble => values(probe, inputs, Fused, |x| x.0),
        }
    }
    /// The natural scale of each result, and the bound of its error.
    pub(crate) fn gauge(self, probe: &Probe, inputs: &[f64]) -> Vec<(f64, f64)> {
        fn gauged<P: Promise>(probe: &Probe, inputs: &[f64]) -> Vec<(f64, f64)>
        where
            Gauge<P>: Number,
        {
            let inputs: Vec<_> = inputs.iter().map(|x| Gauge::<P>::exact(*x)).collect();
            let results = probe.evaluate(&inputs).unwrap_or_default();
            results.into_iter().map(|result| (result.scale(), result.bound())).collect()
        }
        match self {
            Target::ScalarSingle | Target::LanesSingle => gauged::<Single>(probe, inputs),
            Target::ScalarDouble | Target::LanesDouble => gauged::<Double>(probe, inputs),
            Target::WgslSingle => gauged::<Wgsl>(probe, inputs),
        }
    }
}

fn values<N: Number>(probe: &Probe, inputs: &[f64], into: impl Fn(f64) -> N, out: impl Fn(N) -> f64) -> Vec<f64> {
    let inputs: Vec<N> = inputs.iter().map(|x| into(*x)).collect();
    probe.evaluate(&inputs).unwrap_or_default().into_iter().map(out).collect()
}

/// `2^exponent`, subnormal ones included.
fn power_of_two(exponent: i32) -> f64 {
    match exponent {
        ..=-1075 => 0.0,
        -1074..=-1023 => f64::from_bits(1 << (exponent + 1074)),
        -1022..=1023 => f64::from_bits(((exponent + 1023) as u64) << 52),
        1024.. => f64::INFINITY,
    }
}

impl fmt::Display for Target {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// A name that is no target's.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("there is no target `{0}`; choose one of scalar f32, scalar f64, lanes f32, lanes f64, wgsl f32")]
pub struct UnknownTarget(String);

impl FromStr for Target {
    type Err = UnknownTarget;
    fn from_str(name: &str) -> Result<Self, UnknownTarget> {
        Self::ALL.into_iter().find(|target| target.name() == name).ok_or_else(|| UnknownTarget(name.to_string()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_ulp_is_the_distance_to_the_next_number() {
        for value in [1.0_f64, 1.5, 0.1, 3e-40, 7e30, 2.0_f64.powi(-126), 1e-45] {
            let single = value as f32;
            let expected = f64::from(single.next_up()) - f64::from(single);
            assert_eq!(Target::ScalarSingle.ulp(f64::from(single)), expected, "{value:e}");
        }
        for value in [1.0_f64, 1.5, -0.1, 3e-310, 7e300, f64::MIN_POSITIVE, 5e-324] {
            assert_eq!(Target::LanesDouble.ulp(value), value.abs().next_up() - value.abs(), "{value:e}");
        }
    }
}
