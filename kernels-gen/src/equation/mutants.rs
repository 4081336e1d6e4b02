//! What the [`equation`](crate::equation) macro's mutants need at run time; only with the feature `mutants`.
//!
//! Each equation carries a numbered list of faults. `ETALON_MUTANT` names the one that is active, as
//! `etalon_reference::equations::dissipation::pair_viscosity#7`; without it, all equations are as written. With
//! `ETALON_MUTANTS_REACHED` set to a file, each equation that runs appends its path to that file, once.

use crate::real::Real;
use crate::vector::{Matrix, Symmetric};
use std::io::Write;
use std::marker::PhantomData;
use std::ops::{Add, Deref, Div, Mul, Neg, Sub};
use std::sync::OnceLock;

/// The environment variable that names the active mutant.
pub const ACTIVE: &str = "ETALON_MUTANT";

/// The environment variable that names the file of equations that ran.
pub const REACHED: &str = "ETALON_MUTANTS_REACHED";

/// The status a program ends with when the active mutant makes no sense for the types it meets: nothing was tested.
pub const NO_MUTANT: i32 = 77;

/// A fault that can be switched on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mutant {
    /// What kind of fault.
    pub operator: &'static str,
    /// What the author wrote.
    pub original: &'static str,
    /// What it becomes.
    pub mutated: &'static str,
    /// Its line in the file, from 1.
    pub line: u32,
    /// Its column, from 1.
    pub column: u32,
}

/// An equation with its mutants; the first has number 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MutatedEquation {
    /// The module it is in.
    pub module_path: &'static str,
    /// The function's name.
    pub name: &'static str,
    /// The source file, as the compiler was given it.
    pub file: &'static str,
    /// All its mutants, in order.
    pub mutants: &'static [Mutant],
}

inventory::collect!(MutatedEquation);

/// Every equation of this program with its mutants, by path.
pub fn registered() -> Vec<&'static MutatedEquation> {
    let mut all: Vec<_> = inventory::iter::<MutatedEquation>.into_iter().collect();
    all.sort_by_key(|equation| (equation.module_path, equation.name, equation.file));
    all
}

/// Which mutant of one equation is active.
pub struct Switch {
    module_path: &'static str,
    name: &'static str,
    active: OnceLock<u32>,
}

impl Switch {
    /// The switch of the function `name` in a module.
    pub const fn new(module_path: &'static str, name: &'static str) -> Self {
        Switch { module_path, name, active: OnceLock::new() }
    }

    /// The equation runs.
    pub fn reach(&self) {
        self.active();
    }

    /// Whether mutant number `number` is active.
    #[inline]
    pub fn is(&self, number: u32) -> bool {
        self.active() == number
    }

    #[inline]
    fn active(&self) -> u32 {
        *self.active.get_or_init(|| self.read())
    }

    /// Zero if none of this equation's is.
    fn read(&self) -> u32 {
        let path = format!("{}::{}", self.module_path, self.name);
        if let Some(file) = std::env::var_os(REACHED) {
            let file = std::fs::OpenOptions::new().append(true).create(true).open(file);
            // One write, so that lines of several threads do not mix.
            if let Err(error) = file.and_then(|mut file| file.write_all(format!("{path}\n").as_bytes())) {
                eprintln!("{REACHED}: {error}");
            }
        }
        let wanted = std::env::var(ACTIVE).unwrap_or_default();
        match wanted.rsplit_once('#') {
            Some((equation, number)) if equation == path => number.parse().unwrap_or(0),
            _ => 0,
        }
    }
}

/// The active mutant has no meaning here. Ends the program: whoever started it must not count this as a result.
fn no_mutant() -> ! {
    std::process::exit(NO_MUTANT)
}

// Each helper is asked as `Helper::of(&value).method(value)`. The compiler takes the method of the helper itself where the
// types allow it, and else that of what the helper dereferences to, which ends the program.
macro_rules! helper {
    ($(#[$text:meta])* $helper:ident, $otherwise:ident) => {
        $(#[$text])*
        pub struct $helper<A, B = A>(PhantomData<(A, B)>);

        /// What the other does where its types do not allow it.
        pub struct $otherwise;

        impl<A, B> Deref for $helper<A, B> {
            type Target = $otherwise;
            fn deref(&self) -> &$otherwise {
                &$otherwise
            }
        }
    };
}

helper!(
    /// Operators in place of others.
    Arithmetic, NoArithmetic
);
impl<A, B> Arithmetic<A, B> {
    /// For operands of these types.
    pub fn of(_: &A, _: &B) -> Self {
        Arithmetic(PhantomData)
    }
}
impl<A: Add<B> + Sub<B, Output = <A as Add<B>>::Output>, B> Arithmetic<A, B> {
    /// `-` for `+`.
    pub fn difference(&self, a: A, b: B) -> <A as Add<B>>::Output {
        a - b
    }
    /// `+` for `-`.
    pub fn sum(&self, a: A, b: B) -> <A as Add<B>>::Output {
        a + b
    }
}
impl<A: Sub<B>, B: Sub<A, Output = <A as Sub<B>>::Output>> Arithmetic<A, B> {
    /// `b - a` for `a - b`.
    pub fn reversed_difference(&self, a: A, b: B) -> <A as Sub<B>>::Output {
        b - a
    }
}
impl<A: Mul<B> + Div<B, Output = <A as Mul<B>>::Output>, B> Arithmetic<A, B> {
    /// `/` for `*`.
    pub fn quotient(&self, a: A, b: B) -> <A as Mul<B>>::Output {
        a / b
    }
    /// `*` for `/`.
    pub fn product(&self, a: A, b: B) -> <A as Mul<B>>::Output {
        a * b
    }
}
impl NoArithmetic {
    /// There is no `-`.
    pub fn difference<A: Add<B>, B>(&self, _: A, _: B) -> A::Output {
        no_mutant()
    }
    /// There is no `+`.
    pub fn sum<A: Sub<B>, B>(&self, _: A, _: B) -> A::Output {
        no_mutant()
    }
    /// There is no `-` the other way round.
    pub fn reversed_difference<A: Sub<B>, B>(&self, _: A, _: B) -> A::Output {
        no_mutant()
    }
    /// There is no `/`.
    pub fn quotient<A: Mul<B>, B>(&self, _: A, _: B) -> A::Output {
        no_mutant()
    }
    /// There is no `*`.
    pub fn product<A: Div<B>, B>(&self, _: A, _: B) -> A::Output {
        no_mutant()
    }
}

helper!(
    /// Two values, one in the other's place.
    Exchange, NoExchange
);
impl<A, B> Exchange<A, B> {
    /// For values of these types.
    pub fn of(_: &A, _: &B) -> Self {
        Exchange(PhantomData)
    }
}
impl<A> Exchange<A, A> {
    /// Each in the other's place.
    pub fn exchanged(&self, a: A, b: A) -> (A, A) {
        (b, a)
    }
    /// The second in the first's place.
    pub fn second(&self, _: A, b: A) -> A {
        b
    }
}
impl NoExchange {
    /// Not of the same type.
    pub fn exchanged<A, B>(&self, _: A, _: B) -> (A, B) {
        no_mutant()
    }
    /// Not of the same type.
    pub fn second<A, B>(&self, _: A, _: B) -> A {
        no_mutant()
    }
}

helper!(
    /// Values of the wrong sign.
    Sign, NoSign
);
impl<A> Sign<A> {
    /// For a value of this type.
    pub fn of(_: &A) -> Self {
        Sign(PhantomData)
    }
}
impl<A: Neg<Output = A>> Sign<A> {
    /// With the other sign.
    pub fn negated(&self, a: A) -> A {
        -a
    }
}
impl NoSign {
    /// It has none.
    pub fn negated<A>(&self, _: A) -> A {
        no_mutant()
    }
}
impl<R: Real, const D: usize> Neg for Matrix<R, D> {
    type Output = Self;
    fn neg(self) -> Self {
        self.scale(-R::one())
    }
}
impl<R: Real, const D: usize> Neg for Symmetric<R, D> {
    type Output = Self;
    fn neg(self) -> Self {
        self.scale(-R::one())
    }
}

helper!(
    /// Constants that are not what they should be.
    Constant, NoConstant
);
impl<A> Constant<A> {
    /// For a value of this type.
    pub fn of(_: &A) -> Self {
        Constant(PhantomData)
    }
}
impl Constant<f64> {
    /// Off by a hundredth; a hundredth instead of zero.
    pub fn scaled(&self, value: f64) -> f64 {
        if value == 0.0 { 0.01 } else { 1.01 * value }
    }
    /// Zero; one instead of zero.
    pub fn gone(&self, value: f64) -> f64 {
        if value == 0.0 { 1.0 } else { 0.0 }
    }
}
impl NoConstant {
    /// Not a constant.
    pub fn scaled<A>(&self, _: A) -> A {
        no_mutant()
    }
    /// Not a constant.
    pub fn gone<A>(&self, _: A) -> A {
        no_mutant()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn helpers_do_what_types_allow() {
        assert_eq!(Arithmetic::of(&3.0, &2.0).difference(3.0, 2.0), 1.0);
        assert_eq!(Arithmetic::of(&3.0, &2.0).reversed_difference(3.0, 2.0), -1.0);
        assert_eq!(Arithmetic::of(&3.0, &2.0).quotient(3.0, 2.0), 1.5);
        assert_eq!(Exchange::of(&1, &2).exchanged(1, 2), (2, 1));
        assert_eq!(Exchange::of(&1, &2).second(1, 2), 2);
        assert_eq!(Sign::of(&Symmetric::<f64, 1>([2.0; 6])).negated(Symmetric::<f64, 1>([2.0; 6])).0[0], -2.0);
        assert_eq!(Constant::of(&2.0).scaled(2.0), 2.02);
        assert_eq!(Constant::of(&2.0).gone(2.0), 0.0);
        assert_eq!(Constant::of(&0.0).gone(0.0), 1.0);
    }
}
