//! The number types a probe can be evaluated with.
//!
//! A probe's body is generic over [`Real`], so it has no single address that a list of probes could hold. The types it is
//! evaluated with are few, though, and [`Evaluators`] holds the body once for each. A type is entered here, and nowhere else.

use crate::gauge::{Gauge, Wgsl};
use crate::interval::Interval;
use crate::quad::Quad;
use etalon_kernels_gen::dual::Dual;
use etalon_kernels_gen::trace::{Double, Single, Symbol};
use etalon_kernels_gen::{Fused, Real};

/// The call of an equation on plain lists of numbers: what [`probe!`](crate::probe!) writes.
pub trait Body: 'static {
    /// The outputs, component by component, for the arguments, component by component.
    fn evaluate<R: Real>(arguments: &[R]) -> Vec<R>;
}

/// A number type that probes can be evaluated with.
pub trait Number: Real {
    /// The body for this type.
    #[doc(hidden)]
    fn of(evaluators: &Evaluators) -> fn(&[Self]) -> Vec<Self>;
}

macro_rules! numbers {
    ($($field:ident: $type:ty,)*) => {
        /// One body, once for each number type.
        #[derive(Clone, Copy, Debug)]
        pub struct Evaluators { $($field: fn(&[$type]) -> Vec<$type>,)* }
        impl Evaluators {
            /// Of a body.
            #[must_use]
            pub fn new<B: Body>() -> Self {
                Evaluators { $($field: B::evaluate::<$type>,)* }
            }
        }
        $(impl Number for $type {
            fn of(evaluators: &Evaluators) -> fn(&[Self]) -> Vec<Self> {
                evaluators.$field
            }
        })*
    };
}
numbers! {
    single: f32,
    double: f64,
    fused_single: Fused<f32>,
    fused_double: Fused<f64>,
    quad: Quad,
    gauge_single: Gauge<Single>,
    gauge_double: Gauge<Double>,
    gauge_wgsl: Gauge<Wgsl>,
    interval: Interval,
    dual: Dual,
    symbol_single: Symbol<Single>,
    symbol_double: Symbol<Double>,
}
