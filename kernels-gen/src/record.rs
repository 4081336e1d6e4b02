//! Fields of a particle, and records: the handful of fields that one pass reads, sums or writes.
//!
//! A record is declared with [`record!`](crate::record!) as a struct with one member per field. What a backend needs to know
//! about it (names, number of components, how to fill it from anywhere) follows from that one declaration.

use crate::real::Real;
use crate::vector::{Matrix, Symmetric, Vector, symmetric_count};

/// How many numbers a field has in `D` dimensions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Rank {
    /// One.
    Scalar,
    /// One per axis.
    Vector,
    /// The upper triangle of a symmetric matrix.
    Symmetric,
    /// A full matrix, row by row.
    Matrix,
}

impl Rank {
    /// Number of components in the given dimension.
    pub const fn components(self, dimension: usize) -> usize {
        match self {
            Rank::Scalar => 1,
            Rank::Vector => dimension,
            Rank::Symmetric => symmetric_count(dimension),
            Rank::Matrix => dimension * dimension,
        }
    }
}

/// How the contributions of the neighbours to a field are put together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Reduction {
    /// Added up, from zero.
    Sum,
    /// The largest, from zero.
    Max,
}

/// One quantity a particle carries.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Field {
    /// Spelled out in snake case: `smoothing_length`.
    pub name: &'static str,
    /// As in the papers: `h`.
    pub symbol: &'static str,
    /// Unit in mass, length and time, `nu` being the dimension: `M L^-nu`.
    pub unit: &'static str,
    /// How many numbers it has.
    pub rank: Rank,
    /// How neighbours' contributions combine, where it is a sum over neighbours.
    pub reduction: Reduction,
}

/// One number of a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Component {
    /// The field.
    pub field: Field,
    /// Which of its numbers, from 0.
    pub index: usize,
}

impl Component {
    /// A name for text that is read by people and compilers: `velocity_x`, `gradient_matrix_xy`.
    pub fn name(&self, dimension: usize) -> String {
        const AXIS: [&str; 3] = ["x", "y", "z"];
        let field = self.field.name;
        match self.field.rank {
            Rank::Scalar => field.to_string(),
            Rank::Vector => format!("{field}_{}", AXIS[self.index]),
            Rank::Matrix => format!("{field}_{}{}", AXIS[self.index / dimension], AXIS[self.index % dimension]),
            Rank::Symmetric => {
                let pairs = (0..dimension).flat_map(|i| (i..dimension).map(move |j| (i, j)));
                let (i, j) = pairs.into_iter().nth(self.index).unwrap_or((0, 0));
                format!("{field}_{}{}", AXIS[i], AXIS[j])
            }
        }
    }
}

/// Something made of a fixed number of reals, in a fixed order.
pub trait Quantity<R>: Copy {
    /// How many.
    const COUNT: usize;
    /// Takes its numbers from `next`, in order.
    fn take(next: &mut impl FnMut() -> R) -> Self;
    /// Gives its numbers to `put`, in order.
    fn give(self, put: &mut impl FnMut(R));
    /// Number by number, what `f` makes of this and another.
    fn zip(self, other: Self, f: &mut impl FnMut(R, R) -> R) -> Self;

    /// [`zip`](Quantity::zip) with a closure given by value.
    #[inline(always)]
    fn zip_with(self, other: Self, mut f: impl FnMut(R, R) -> R) -> Self {
        self.zip(other, &mut f)
    }
    /// [`take`](Quantity::take) from a closure given by value.
    #[inline(always)]
    fn from_each(mut next: impl FnMut() -> R) -> Self {
        Self::take(&mut next)
    }
    /// [`give`](Quantity::give) to a closure given by value.
    #[inline(always)]
    fn for_each(self, mut put: impl FnMut(R)) {
        self.give(&mut put);
    }
}

impl<R: Real> Quantity<R> for R {
    const COUNT: usize = 1;
    #[inline(always)]
    fn take(next: &mut impl FnMut() -> R) -> Self {
        next()
    }
    #[inline(always)]
    fn give(self, put: &mut impl FnMut(R)) {
        put(self);
    }
    #[inline(always)]
    fn zip(self, other: Self, f: &mut impl FnMut(R, R) -> R) -> Self {
        f(self, other)
    }
}
impl<R: Real, const D: usize> Quantity<R> for Vector<R, D> {
    const COUNT: usize = D;
    #[inline(always)]
    fn take(next: &mut impl FnMut() -> R) -> Self {
        Vector::from_fn(
            #[inline(always)]
            |_| next(),
        )
    }
    #[inline(always)]
    fn give(self, put: &mut impl FnMut(R)) {
        put(self.0[0]);
        if D > 1 {
            put(self.0[1]);
        }
        if D > 2 {
            put(self.0[2]);
        }
    }
    #[inline(always)]
    fn zip(self, other: Self, f: &mut impl FnMut(R, R) -> R) -> Self {
        Vector::from_fn(
            #[inline(always)]
            |i| f(self.0[i], other.0[i]),
        )
    }
}
impl<R: Real, const D: usize> Quantity<R> for Matrix<R, D> {
    const COUNT: usize = D * D;
    #[inline(always)]
    fn take(next: &mut impl FnMut() -> R) -> Self {
        Matrix::from_fn(
            #[inline(always)]
            |_, _| next(),
        )
    }
    #[inline(always)]
    fn give(self, put: &mut impl FnMut(R)) {
        Vector(self.0[0]).give(put);
        if D > 1 {
            Vector(self.0[1]).give(put);
        }
        if D > 2 {
            Vector(self.0[2]).give(put);
        }
    }
    #[inline(always)]
    fn zip(self, other: Self, f: &mut impl FnMut(R, R) -> R) -> Self {
        Matrix::from_fn(
            #[inline(always)]
            |i, j| f(self.0[i][j], other.0[i][j]),
        )
    }
}
impl<R: Real, const D: usize> Quantity<R> for Symmetric<R, D> {
    const COUNT: usize = symmetric_count(D);
    #[inline(always)]
    fn take(next: &mut impl FnMut() -> R) -> Self {
        Symmetric::from_fn(
            #[inline(always)]
            |_, _| next(),
        )
    }
    #[inline(always)]
    fn give(self, put: &mut impl FnMut(R)) {
        put(self.0[0]);
        if D > 1 {
            put(self.0[1]);
            put(self.0[2]);
        }
        if D > 2 {
            put(self.0[3]);
            put(self.0[4]);
            put(self.0[5]);
        }
    }
    #[inline(always)]
    fn zip(self, other: Self, f: &mut impl FnMut(R, R) -> R) -> Self {
        Symmetric::from_fn(
            #[inline(always)]
            |i, j| f(self.at(i, j), other.at(i, j)),
        )
    }
}

impl Reduction {
    /// Two contributions put together.
    #[inline(always)]
    pub fn combine<R: Real>(self, a: R, b: R) -> R {
        match self {
            Reduction::Sum => a + b,
            Reduction::Max => a.max(b),
        }
    }
}

/// A struct of fields; made by [`record!`](crate::record!).
pub trait Record<R>: Quantity<R> {
    /// The fields, in the order of the members.
    fn fields() -> Vec<Field>;
    /// Two contributions put together, each field by its own [`Reduction`].
    fn combine(self, other: Self) -> Self;
}

/// Every component of a list of fields, in order.
pub fn components(fields: &[Field], dimension: usize) -> Vec<Component> {
    let all = |field: &Field| {
        let field = *field;
        (0..field.rank.components(dimension)).map(move |index| Component { field, index })
    };
    fields.iter().flat_map(all).collect()
}

/// One number, as the type of a record's member: `R` itself, whatever the dimension.
pub type Scalar<R, const D: usize> = R;

/// Declares a record: `pub struct Name { member: Type = FIELD, ... }` with `Type` one of `Scalar`, `Vector`, `Symmetric`, `Matrix` and
/// `FIELD` a constant of type [`Field`]; or `member: Other` for all the fields of another record. The struct is generic over the
/// number `R` and the dimension `D`.
#[macro_export]
macro_rules! record {
    ($(#[$meta:meta])* pub struct $name:ident { $($(#[$member_meta:meta])* $member:ident : $type:ident $(= $field:ident)?),* $(,)? }) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name<R, const D: usize> {
            $(#[doc = $crate::record!(@doc $type $($field)?)] $(#[$member_meta])* pub $member: $type<R, D>,)*
        }
        impl<R: $crate::Real, const D: usize> $crate::Quantity<R> for $name<R, D> {
            const COUNT: usize = 0 $(+ <$type<R, D> as $crate::Quantity<R>>::COUNT)*;
            #[inline(always)]
            fn take(next: &mut impl FnMut() -> R) -> Self {
                Self { $($member: $crate::Quantity::take(next),)* }
            }
            #[inline(always)]
            fn give(self, put: &mut impl FnMut(R)) {
                $($crate::Quantity::give(self.$member, put);)*
            }
            #[inline(always)]
            fn zip(self, other: Self, f: &mut impl FnMut(R, R) -> R) -> Self {
                Self { $($member: $crate::Quantity::zip(self.$member, other.$member, f),)* }
            }
        }
        impl<R: $crate::Real, const D: usize> $crate::Record<R> for $name<R, D> {
            fn fields() -> Vec<$crate::Field> {
                let mut fields = Vec::new();
                $($crate::record!(@fields fields, $type, R, D $(, $field)?);)*
                fields
            }
            #[inline(always)]
            fn combine(self, other: Self) -> Self {
                Self { $($member: $crate::record!(@combine self.$member, other.$member, R $(, $field)?),)* }
            }
        }
    };
    (@combine $a:expr, $b:expr, $r:ident) => { $crate::Record::<$r>::combine($a, $b) };
    (@combine $a:expr, $b:expr, $r:ident, $field:ident) => {
        $crate::Quantity::<$r>::zip_with(
            $a,
            $b,
            #[inline(always)]
            |a, b| $field.reduction.combine(a, b),
        )
    };
    (@doc $type:ident $field:ident) => { concat!("The field [`", stringify!($field), "`].") };
    (@doc $type:ident) => { concat!("The fields of [`", stringify!($type), "`].") };
    (@fields $fields:ident, $type:ident, $r:ident, $d:ident) => {
        $fields.extend(<$type<$r, $d> as $crate::Record<$r>>::fields())
    };
    (@fields $fields:ident, $type:ident, $r:ident, $d:ident, $field:ident) => { $fields.push($field) };
}
