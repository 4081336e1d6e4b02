//! The macro that declares probes; `docs/how-to/equation.md` walks through one.

/// Declares the probes of one equation: a list with one [`Probe`](crate::Probe) for each dimension.
///
/// ```
/// use etalon_audit::{any, not_negative, own, positive, probe};
/// use etalon_reference::equations::dissipation;
///
/// let probes = probe! {
///     dissipation::signal_velocity(sound_speed_a, sound_speed_b, omega_ab);
///     sound_speed_a: R = "c_a", "L T^-1", not_negative(1e-3, 1e3);
///     sound_speed_b: R = "c_b", "L T^-1", not_negative(1e-3, 1e3);
///     omega_ab: R = r"\omega_{ab}", "L T^-1", any(1e-3, 1e3);
///     => signal_velocity: R = r"v^{\mathrm{sig}}_{ab}", "L T^-1";
/// };
/// assert_eq!(probes[0].key(), "dissipation::signal_velocity");
/// ```
///
/// The first line is the call, `module::function(arguments)`, with `module` in scope; turbofish and other expressions as
/// arguments are welcome. Then, for each argument: its name in the call, its type (`R`, `Vector<R, D>`, `Symmetric<R, D>`,
/// `Matrix<R, D>`), its symbol (of the ledger's entry, or [`own`](crate::own)), its unit, its domain. Behind `=>` come the results.
///
/// - `in 1, 2, 3;` in front: one probe for each of these dimensions, `D` in the call and the types.
/// - `as "AVSLR";` after that: this is one of several ways to call it.
/// - `-> |shape| { (shape.value, shape.slope_over_q) }` after the call, where it has several results.
/// - `@arrange "b is no larger than a" |x| { .. };` at the end: makes arguments that belong together of independent samples,
///   `x: &mut [f64]`; the text says what they then are.
#[macro_export]
macro_rules! probe {
    (in $($dimension:literal),+; $($rest:tt)*) => {
        $crate::probe!(@variant [$(Some($dimension), $dimension);+] $($rest)*)
    };
    (@variant $dimensions:tt as $variant:literal; $($rest:tt)*) => {
        $crate::probe!(@call $dimensions [Some($variant)] $($rest)*)
    };
    (@variant $dimensions:tt $($rest:tt)*) => { $crate::probe!(@call $dimensions [None] $($rest)*) };
    (@call $dimensions:tt $variant:tt
        $module:ident::$function:ident $(::<$($generic:ty),*>)? ($($given:expr),* $(,)?)
        $(-> |$value:ident| $outcome:block)?;
        $($argument:ident: $type:ty = $symbol:expr, $unit:literal, $domain:expr;)*
        => $($result:ident: $result_type:ty = $result_symbol:expr, $result_unit:literal;)+
        $(@arrange $arranged:literal |$inputs:ident| $arrangement:block;)?
    ) => {{
        #[allow(unused_imports)]
        use $crate::macro_parts::*;
        struct This<const D: usize>;
        impl<const D: usize> Body for This<D> {
            #[allow(unused_variables, unused_mut, unused_assignments)]
            fn evaluate<R: Real>(arguments: &[R]) -> Vec<R> {
                let mut start = 0;
                $(let $argument: $type = take(arguments, &mut start);)*
                let outcome = $module::$function $(::<$($generic),*>)? ($($given),*);
                $crate::probe!(@bind outcome [$($value $outcome)?] $($result)+);
                let mut list = Vec::new();
                $(Shaped::<R>::write($result, &mut list);)+
                list
            }
        }
        impl<const D: usize> Declaration for This<D> {
            fn arguments() -> Vec<Argument> {
                #[allow(dead_code)]
                type R = f64;
                vec![$(Argument {
                    quantity: Quantity::new::<$type>(stringify!($argument), $symbol, $unit),
                    domain: $domain,
                }),*]
            }
            fn results() -> Vec<Quantity> {
                #[allow(dead_code)]
                type R = f64;
                vec![$(Quantity::new::<$result_type>(stringify!($result), $result_symbol, $result_unit)),+]
            }
            $(
                fn arrange($inputs: &mut [f64]) $arrangement
                const ARRANGED: Option<&'static str> = Some($arranged);
            )?
        }
        $crate::probe!(@list $dimensions $variant $module $function)
    }};
    (@bind $whole:ident [] $result:ident) => { let $result = $whole; };
    (@bind $whole:ident [$value:ident $outcome:block] $($result:ident)+) => {
        let ($($result,)+) = { let $value = $whole; $outcome };
    };
    (@list [$($shown:expr, $dimension:expr);+] [$variant:expr] $module:ident $function:ident) => {
        vec![$(Probe::new::<This<$dimension>>(stringify!($module), stringify!($function), $variant, $shown)),+]
    };
    (@$($rest:tt)*) => { compile_error!("not the form of a probe; the documentation of `probe!` shows it") };
    ($($rest:tt)*) => { $crate::probe!(@variant [None, 3] $($rest)*) };
}
