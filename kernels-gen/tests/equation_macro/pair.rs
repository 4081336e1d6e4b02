//! Two numbers at once, whose masks are no `bool`s and whose names and equations are noted: a lane type and a symbol in small.

use etalon_kernels_gen::{Choose, Mask, Nameable, Precision, Real};
use std::cell::RefCell;
use std::ops::{Add, Div, Mul, Neg, Sub};

thread_local! {
    static NOTES: RefCell<Vec<String>> = const { RefCell::new(Vec::new()) };
}

fn note(what: String) {
    NOTES.with_borrow_mut(|notes| notes.push(what));
}

/// What was noted while `run` ran.
pub fn notes(run: impl FnOnce()) -> Vec<String> {
    NOTES.take();
    run();
    NOTES.take()
}

/// Two numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair(pub [f64; 2]);

/// Two truth values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Both(pub [bool; 2]);

fn each(f: impl Fn(usize) -> f64) -> Pair {
    Pair([f(0), f(1)])
}

impl Mask for Both {
    fn and(self, other: Self) -> Self {
        Both([self.0[0] && other.0[0], self.0[1] && other.0[1]])
    }
    fn or(self, other: Self) -> Self {
        Both([self.0[0] || other.0[0], self.0[1] || other.0[1]])
    }
    fn not(self) -> Self {
        Both(self.0.map(|b| !b))
    }
    fn choose<T: Choose<Self>>(self, yes: impl FnOnce() -> T, no: impl FnOnce() -> T) -> T {
        note("choose".into());
        T::pick(self, yes(), no())
    }
    fn choose_rare<T: Choose<Self>>(self, yes: impl FnOnce() -> T, no: impl FnOnce() -> T) -> T {
        note("choose_rare".into());
        T::pick(self, yes(), no())
    }
}
impl Choose<Both> for Pair {
    fn pick(mask: Both, yes: Self, no: Self) -> Self {
        each(|i| if mask.0[i] { yes.0[i] } else { no.0[i] })
    }
}
impl Nameable for Pair {
    const NAMES: bool = true;
    fn named(self, name: &str) -> Self {
        note(name.into());
        self
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident) => {
        impl $trait for Pair {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                each(|i| self.0[i].$method(other.0[i]))
            }
        }
    };
}
operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);
impl Neg for Pair {
    type Output = Self;
    fn neg(self) -> Self {
        each(|i| -self.0[i])
    }
}

impl Real for Pair {
    type Mask = Both;
    const PRECISION: Precision = Precision::Double;
    fn lit(value: f64) -> Self {
        Pair([value; 2])
    }
    fn sqrt(self) -> Self {
        each(|i| self.0[i].sqrt())
    }
    fn abs(self) -> Self {
        each(|i| self.0[i].abs())
    }
    fn min(self, other: Self) -> Self {
        each(|i| Real::min(self.0[i], other.0[i]))
    }
    fn max(self, other: Self) -> Self {
        each(|i| Real::max(self.0[i], other.0[i]))
    }
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        each(|i| Real::mul_add(self.0[i], factor.0[i], addend.0[i]))
    }
    fn lt(self, other: Self) -> Both {
        Both([self.0[0] < other.0[0], self.0[1] < other.0[1]])
    }
    fn le(self, other: Self) -> Both {
        Both([self.0[0] <= other.0[0], self.0[1] <= other.0[1]])
    }
    fn equation<T>(id: &'static str, name: &'static str, body: impl FnOnce() -> T) -> T {
        note(format!("{id} {name} {{"));
        let value = body();
        note("}".into());
        value
    }
}
