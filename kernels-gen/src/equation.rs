//! What the [`equation`](crate::equation) macro leaves behind: an entry per equation, and the names of values.

#[cfg(feature = "mutants")]
pub mod mutants;

use crate::real::Choose;

/// An equation of this program, as it was written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EquationEntry {
    /// Its ids in the ledger, such as `gs25:8`; empty for a definition without a number.
    pub ids: &'static [&'static str],
    /// The function's name.
    pub name: &'static str,
    /// The module it is in.
    pub module_path: &'static str,
    /// The source file, as the compiler was given it.
    pub file: &'static str,
    /// The line of the attribute, from 1.
    pub line: u32,
    /// The function as its author wrote it, documentation included.
    pub source: &'static str,
    /// Where a definition without a number stands.
    pub unnumbered: Option<&'static str>,
}

inventory::collect!(EquationEntry);

/// Every equation that is linked into this program, by id (papers by key, numbers as numbers; definitions without a number
/// last), then by name.
pub fn registered() -> Vec<&'static EquationEntry> {
    let mut entries: Vec<_> = inventory::iter::<EquationEntry>.into_iter().collect();
    entries.sort_by_key(|entry| {
        let ids: Vec<_> = entry.ids.iter().map(|id| sort_key(id)).collect();
        (ids.is_empty(), ids, entry.name, entry.module_path)
    });
    entries
}

/// `gs25:10` comes after `gs25:8`.
fn sort_key(id: &'static str) -> (&'static str, u32) {
    let (paper, number) = id.split_once(':').unwrap_or((id, ""));
    (paper, number.parse().unwrap_or(u32::MAX))
}

// A data-dependent `if` may give several values at once.
macro_rules! choose_tuple {
    ($($name:ident: $place:tt),*) => {
        impl<M: Copy, $($name: Choose<M>),*> Choose<M> for ($($name,)*) {
            #[inline(always)]
            fn pick(mask: M, yes: Self, no: Self) -> Self {
                ($($name::pick(mask, yes.$place, no.$place),)*)
            }
        }
    };
}
choose_tuple!(A: 0, B: 1);
choose_tuple!(A: 0, B: 1, C: 2);
choose_tuple!(A: 0, B: 1, C: 2, D: 3);

impl<M: Copy, T: Choose<M>, const N: usize> Choose<M> for [T; N] {
    #[inline(always)]
    fn pick(mask: M, yes: Self, no: Self) -> Self {
        std::array::from_fn(|i| T::pick(mask, yes[i], no[i]))
    }
}

/// What the macro's output refers to. Not for direct use.
pub mod private {
    pub use super::EquationEntry;
    #[cfg(feature = "mutants")]
    pub use super::mutants;
    use crate::real::Nameable;
    pub use inventory;
    use std::marker::PhantomData;
    use std::ops::Deref;

    /// Names a value of type `T` if that type is [`Nameable`], and else leaves it alone.
    ///
    /// The macro knows no types. It writes `Naming::of(&value).name(value, "x")`, and the compiler takes the method of
    /// `Naming<T>` where its bound holds, and goes on to that of [`Unnamed`] where it does not: also inside a generic function,
    /// where `R: Real` says enough.
    pub struct Naming<T>(PhantomData<T>);

    /// See [`Naming`].
    pub struct Unnamed;

    impl<T> Naming<T> {
        /// For a value of this type.
        #[inline(always)]
        pub fn of(_: &T) -> Self {
            Naming(PhantomData)
        }
    }

    impl<T: Nameable> Naming<T> {
        /// The value under its name.
        #[inline(always)]
        pub fn name(&self, value: T, name: &str) -> T {
            value.named(name)
        }
    }

    impl<T> Deref for Naming<T> {
        type Target = Unnamed;
        #[inline(always)]
        fn deref(&self) -> &Unnamed {
            &Unnamed
        }
    }

    impl Unnamed {
        /// The value itself.
        #[inline(always)]
        pub fn name<T>(&self, value: T, _name: &str) -> T {
            value
        }
    }
}

#[cfg(test)]
mod tests {
    use super::sort_key;

    #[test]
    fn ids_sort_by_number() {
        let mut ids = ["gs25:10", "pl20:1", "gs25:8", "c25:33"];
        ids.sort_by_key(|id| sort_key(id));
        assert_eq!(ids, ["c25:33", "gs25:8", "gs25:10", "pl20:1"]);
    }
}
