//! Many numbers at once: 16 `f32` or 8 `f64` lanes, whatever the processor.
//!
//! The number of lanes is fixed, not the processor's: an AVX-512 register holds them all, AVX2 uses two, NEON four, and where
//! there is none of these they are computed one by one, as [`Fused`](crate::Fused) scalars. As every lane rounds each operation
//! once (`mul_add` is fused everywhere), the results are the same bits on every level.

mod token;

use crate::real::{Choose, Mask, Nameable, Precision, Real};
use fearless_simd::{Level, Select, SimdBase, SimdFloat, SimdMask, f32x16, f64x8, mask32x16, mask64x8};
pub use token::LaneLevel;

macro_rules! lanes {
    ($vector:ident, $mask:ident, $element:ty, $precision:expr) => {
        impl<S: LaneLevel> Mask for $mask<S> {
            #[inline(always)]
            fn and(self, other: Self) -> Self {
                self & other
            }
            #[inline(always)]
            fn or(self, other: Self) -> Self {
                self | other
            }
            #[inline(always)]
            fn not(self) -> Self {
                !self
            }
            #[inline(always)]
            fn choose<T: Choose<Self>>(self, yes: impl FnOnce() -> T, no: impl FnOnce() -> T) -> T {
                T::pick(self, yes(), no())
            }
            #[inline(always)]
            fn choose_rare<T: Choose<Self>>(self, yes: impl FnOnce() -> T, no: impl FnOnce() -> T) -> T {
                let usual = no();
                if self.any_true() { T::pick(self, yes(), usual) } else { usual }
            }
        }
        impl<S: LaneLevel> Nameable for $vector<S> {}
        impl<S: LaneLevel> Choose<$mask<S>> for $vector<S> {
            #[inline(always)]
            fn pick(mask: $mask<S>, yes: Self, no: Self) -> Self {
                mask.select(yes, no)
            }
        }
        impl<S: LaneLevel> Real for $vector<S> {
            type Mask = $mask<S>;
            const PRECISION: Precision = $precision;
            #[inline(always)]
            fn lit(value: f64) -> Self {
                Self::splat(<S as LaneLevel>::token(), value as $element)
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                <Self as SimdFloat<S>>::sqrt(self)
            }
            #[inline(always)]
            fn abs(self) -> Self {
                <Self as SimdBase<S>>::abs(self)
            }
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                <Self as SimdBase<S>>::min(self, other)
            }
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                <Self as SimdBase<S>>::max(self, other)
            }
            #[inline(always)]
            fn mul_add(self, factor: Self, addend: Self) -> Self {
                <Self as SimdFloat<S>>::mul_add_precise(self, factor, addend)
            }
            #[inline(always)]
            fn lt(self, other: Self) -> Self::Mask {
                self.simd_lt(other)
            }
            #[inline(always)]
            fn le(self, other: Self) -> Self::Mask {
                self.simd_le(other)
            }
        }
    };
}
lanes!(f32x16, mask32x16, f32, Precision::Single);
lanes!(f64x8, mask64x8, f64, Precision::Double);

/// A computation that can be run at any lane level.
pub trait LaneProgram {
    /// What it returns.
    type Output;
    /// Runs it. Implementations must be `#[inline(always)]`, as everything they call on lanes, so that the whole is compiled
    /// for the level's instructions.
    fn run<S: LaneLevel>(self, level: S) -> Self::Output;
    /// The same on scalars, for processors without vector instructions we use.
    fn one_by_one(self) -> Self::Output;
}

/// Runs a program with the instructions of `level`, which the caller detected or asked for.
#[inline]
pub fn dispatch<P: LaneProgram>(level: Level, program: P) -> P::Output {
    use fearless_simd::Simd;
    match level {
        #[cfg(target_arch = "x86_64")]
        Level::Avx512(s) => s.vectorize(
            #[inline(always)]
            || program.run(s),
        ),
        #[cfg(target_arch = "x86_64")]
        Level::Avx2(s) => s.vectorize(
            #[inline(always)]
            || program.run(s),
        ),
        #[cfg(target_arch = "aarch64")]
        Level::Neon(s) => s.vectorize(
            #[inline(always)]
            || program.run(s),
        ),
        _ => program.one_by_one(),
    }
}

/// The levels this processor can run, best first; on x86-64 the last one is the portable one.
pub fn available_levels() -> Vec<Level> {
    let mut levels = Vec::new();
    #[cfg(target_arch = "x86_64")]
    {
        let best = Level::new();
        levels.extend(best.as_avx512().map(Level::Avx512));
        levels.extend(best.as_avx2().map(Level::Avx2));
        levels.push(Level::baseline());
    }
    // Every AArch64 processor that Rust supports has NEON.
    #[cfg(not(target_arch = "x86_64"))]
    levels.push(Level::new());
    levels
}

/// The level's name as users write it.
pub fn level_name(level: Level) -> &'static str {
    match level {
        #[cfg(target_arch = "x86_64")]
        Level::Avx512(_) => "avx512",
        #[cfg(target_arch = "x86_64")]
        Level::Avx2(_) => "avx2",
        #[cfg(target_arch = "aarch64")]
        Level::Neon(_) => "neon",
        _ => "portable",
    }
}
