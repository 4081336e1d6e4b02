//! The most fused multiply-adds one core can do: what speeds are measured against.
//!
//! Independent chains of `x <- x f + a` keep every multiplier busy; nothing is loaded or stored. The clock of a core changes
//! with its load and its neighbours', so the peak is measured in the same run as what is compared with it.

use etalon_kernels_gen::Real;
use etalon_kernels_gen::lanes::{LaneLevel, LaneProgram, dispatch};
use fearless_simd::{Level, f32x16, f64x8};
use std::hint::black_box;
use std::time::Instant;

/// Peak of one core in GFLOP/s; one fused multiply-add counts as two operations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FmaPeak {
    /// In 32-bit floats.
    pub single: f64,
    /// In 64-bit floats.
    pub double: f64,
}

/// Rounds of a chain per measurement: some microseconds, short enough to fall between interruptions.
const ROUNDS: usize = 2_000;
/// Measurements; the fastest counts, as everything that disturbs one makes it slower.
const REPEATS: usize = 4_000;
/// No more than so many seconds of them: a level without the instruction calls a function, and is a hundred times slower.
const PATIENCE: f64 = 0.1;

/// Measures the calling thread's core with the instructions of `level`: a fraction of a second.
pub fn measure(level: Level) -> FmaPeak {
    // Twelve chains cover the latency where a vector is one register; six where it takes two or four of them.
    let best = |twelve: f64, six: f64| twelve.max(six);
    FmaPeak {
        single: best(rate(level, SingleChains::<12>), rate(level, SingleChains::<6>)),
        double: best(rate(level, DoubleChains::<12>), rate(level, DoubleChains::<6>)),
    }
}

/// GFLOP/s of the fastest repeat.
fn rate<P: LaneProgram<Output = usize> + Copy>(level: Level, program: P) -> f64 {
    let mut best = 0.0_f64;
    let first = Instant::now();
    for _ in 0..REPEATS {
        let start = Instant::now();
        let operations = 2 * ROUNDS * dispatch(level, program);
        best = best.max(operations as f64 / start.elapsed().as_secs_f64() * 1e-9);
        if first.elapsed().as_secs_f64() > PATIENCE {
            break;
        }
    }
    best
}

macro_rules! chains {
    ($name:ident, $vector:ident, $element:ty, $lanes:literal) => {
        /// `N` independent chains in every lane; returns how many that makes.
        #[derive(Clone, Copy)]
        struct $name<const N: usize>;

        impl<const N: usize> LaneProgram for $name<N> {
            type Output = usize;
            #[inline(always)]
            fn run<S: LaneLevel>(self, _: S) -> usize {
                // Values stay near one: x <- x f + a has the fixed point a / (1 - f) = 1.
                let factor = <$vector<S> as Real>::lit(black_box(0.5));
                let addend = <$vector<S> as Real>::lit(black_box(0.5));
                let mut values = [<$vector<S> as Real>::lit(black_box(1.0)); N];
                for _ in 0..ROUNDS {
                    for value in &mut values {
                        *value = value.mul_add(factor, addend);
                    }
                }
                let sum = values.into_iter().reduce(|a, b| a + b);
                black_box(sum.map(|sum| sum.lt(factor)));
                N * $lanes
            }
            fn one_by_one(self) -> usize {
                let (factor, addend): ($element, $element) = (black_box(0.5), black_box(0.5));
                let mut values = [black_box(1.0); N];
                for _ in 0..ROUNDS {
                    for value in &mut values {
                        *value = factor.mul_add(*value, addend);
                    }
                }
                black_box(values);
                N
            }
        }
    };
}
chains!(SingleChains, f32x16, f32, 16);
chains!(DoubleChains, f64x8, f64, 8);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_level_has_a_peak_and_single_precision_is_no_slower() {
        for level in etalon_kernels_gen::lanes::available_levels() {
            let peak = measure(level);
            // No core of these years does less than a million or more than a thousand thousand million a second.
            assert!((1e-3..1e3).contains(&peak.single) && (1e-3..1e3).contains(&peak.double), "{peak:?}");
        }
    }
}
