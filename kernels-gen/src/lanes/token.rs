//! Constants inside a lane computation: where a lane value exists, its instruction set has been proven to exist.
//!
//! `fearless_simd` asks for a token, a value of size zero that proves the processor has the instructions. Equations make
//! constants with `R::lit(0.5)`, where there is nowhere to carry the token, so it is made again here. This is the only module
//! of the crate with unsafe code.
#![allow(unsafe_code)]

use fearless_simd::Simd;

/// A vector instruction set that lane computations can be compiled for.
///
/// # Safety
/// [`token`](LaneLevel::token) conjures the proof that the instructions exist, so it may be called only from code that was
/// entered with such a proof. [`LaneProgram`](super::LaneProgram)s are: `dispatch` has a token of that very type in hand when it calls them, and
/// nothing else in this crate names a lane type.
pub unsafe trait LaneLevel: Simd {
    /// The token again.
    fn token() -> Self;
}

macro_rules! level {
    ($type:ty) => {
        unsafe impl LaneLevel for $type {
            #[inline(always)]
            fn token() -> Self {
                // SAFETY: called only below `dispatch`, which held a token of this type (see the trait).
                unsafe { <$type>::assume_supported() }
            }
        }
    };
}

#[cfg(target_arch = "x86_64")]
level!(fearless_simd::x86::Avx512);
#[cfg(target_arch = "x86_64")]
level!(fearless_simd::x86::Avx2);
#[cfg(target_arch = "aarch64")]
level!(fearless_simd::aarch64::Neon);
