//! Small vectors and matrices over any [`Real`], in one, two or three dimensions.
//!
//! nalgebra's would be nicer, but every operation here must be inlined into a vector loop and must accept symbols; nalgebra
//! is what these are tested against. For the same reason there are no loops over axes and no closures of the standard library:
//! a call left standing in a vector loop costs a hundred times the work it does.

use crate::real::{Choose, Nameable, Real};
use std::ops::{Add, Index, IndexMut, Mul, Neg, Sub};

/// A vector of `D` components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vector<R, const D: usize>(pub [R; D]);

/// A `D` x `D` matrix, row by row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Matrix<R, const D: usize>(pub [[R; D]; D]);

/// A symmetric `D` x `D` matrix: `D (D + 1) / 2` numbers, the upper triangle row by row (xx, xy, xz, yy, yz, zz).
///
/// The array has room for three dimensions; in fewer, what lies beyond the first `D (D + 1) / 2` entries is zero and unused.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Symmetric<R, const D: usize>(pub [R; 6]);

/// How many numbers a symmetric matrix of this dimension has.
pub const fn symmetric_count(dimension: usize) -> usize {
    dimension * (dimension + 1) / 2
}

const AXIS: [&str; 3] = ["x", "y", "z"];

/// An array with the value of `f` for each of up to three axes, in order. Surely inlined, unlike `std::array::from_fn`.
#[inline(always)]
pub fn axes<T: Copy, const D: usize>(mut f: impl FnMut(usize) -> T) -> [T; D] {
    const { assert!(D >= 1 && D <= 3, "one, two or three dimensions") };
    let mut all = [f(0); D];
    if D > 1 {
        all[1] = f(1);
    }
    if D > 2 {
        all[2] = f(2);
    }
    all
}

impl<R: Real, const D: usize> Vector<R, D> {
    /// All components zero.
    #[inline(always)]
    pub fn zero() -> Self {
        Self([R::zero(); D])
    }
    /// Component by component from a function of the axis.
    #[inline(always)]
    pub fn from_fn(f: impl FnMut(usize) -> R) -> Self {
        Self(axes(f))
    }
    /// The scalar product, summed from the first axis on.
    #[inline(always)]
    pub fn dot(self, other: Self) -> R {
        let mut sum = self.0[0] * other.0[0];
        if D > 1 {
            sum = self.0[1].mul_add(other.0[1], sum);
        }
        if D > 2 {
            sum = self.0[2].mul_add(other.0[2], sum);
        }
        sum
    }
    /// The scalar product with itself.
    #[inline(always)]
    pub fn norm_squared(self) -> R {
        self.dot(self)
    }
    /// The length.
    #[inline(always)]
    pub fn norm(self) -> R {
        self.norm_squared().sqrt()
    }
    /// Each component times the same number.
    #[inline(always)]
    pub fn scale(self, factor: R) -> Self {
        Self::from_fn(
            #[inline(always)]
            |i| self.0[i] * factor,
        )
    }
}

impl<R: Real, const D: usize> Matrix<R, D> {
    /// Entry by entry from a function of row and column.
    #[inline(always)]
    pub fn from_fn(mut f: impl FnMut(usize, usize) -> R) -> Self {
        Self(axes(
            #[inline(always)]
            |i| {
                axes(
                    #[inline(always)]
                    |j| f(i, j),
                )
            },
        ))
    }
    /// The sum of the diagonal.
    #[inline(always)]
    pub fn trace(self) -> R {
        let mut sum = self.0[0][0];
        if D > 1 {
            sum = sum + self.0[1][1];
        }
        if D > 2 {
            sum = sum + self.0[2][2];
        }
        sum
    }
    /// Half the sum of the matrix and its transpose.
    #[inline(always)]
    pub fn symmetric_part(self) -> Symmetric<R, D> {
        Symmetric::from_fn(
            #[inline(always)]
            |i, j| if i == j { self.0[i][i] } else { (self.0[i][j] + self.0[j][i]) * R::lit(0.5) },
        )
    }
    /// Each entry times the same number.
    #[inline(always)]
    pub fn scale(self, factor: R) -> Self {
        Self::from_fn(
            #[inline(always)]
            |i, j| self.0[i][j] * factor,
        )
    }
    /// Matrix times vector.
    #[inline(always)]
    pub fn apply(self, v: Vector<R, D>) -> Vector<R, D> {
        Vector::from_fn(
            #[inline(always)]
            |i| Vector(self.0[i]).dot(v),
        )
    }
}

impl<R: Real, const D: usize> Symmetric<R, D> {
    /// Where entry (i, j) is kept.
    #[inline(always)]
    pub const fn position(i: usize, j: usize) -> usize {
        let (i, j) = if i < j { (i, j) } else { (j, i) };
        i * D - i * (i + 1) / 2 + j
    }
    /// All entries zero.
    #[inline(always)]
    pub fn zero() -> Self {
        Self([R::zero(); 6])
    }
    /// Entry by entry of the upper triangle, from a function of row and column.
    #[inline(always)]
    pub fn from_fn(mut f: impl FnMut(usize, usize) -> R) -> Self {
        let mut result = Self::zero();
        result.0[0] = f(0, 0);
        if D > 1 {
            result.0[1] = f(0, 1);
        }
        if D > 2 {
            result.0[2] = f(0, 2);
        }
        if D > 1 {
            result.0[Self::position(1, 1)] = f(1, 1);
        }
        if D > 2 {
            result.0[4] = f(1, 2);
            result.0[5] = f(2, 2);
        }
        result
    }
    /// The entry in row `i`, column `j`.
    #[inline(always)]
    pub fn at(self, i: usize, j: usize) -> R {
        self.0[Self::position(i, j)]
    }
    /// Row `i`.
    #[inline(always)]
    pub fn row(self, i: usize) -> Vector<R, D> {
        Vector::from_fn(
            #[inline(always)]
            |j| self.at(i, j),
        )
    }
    /// The product of a vector with itself, times a weight: `weight * v vᵀ`.
    #[inline(always)]
    pub fn outer(v: Vector<R, D>, weight: R) -> Self {
        let weighted = v.scale(weight);
        Self::from_fn(
            #[inline(always)]
            |i, j| weighted.0[i] * v.0[j],
        )
    }
    /// The sum of the diagonal.
    #[inline(always)]
    pub fn trace(self) -> R {
        let mut sum = self.at(0, 0);
        if D > 1 {
            sum = sum + self.at(1, 1);
        }
        if D > 2 {
            sum = sum + self.at(2, 2);
        }
        sum
    }
    /// Matrix times vector.
    #[inline(always)]
    pub fn apply(self, v: Vector<R, D>) -> Vector<R, D> {
        Vector::from_fn(
            #[inline(always)]
            |i| self.row(i).dot(v),
        )
    }
    /// `vᵀ M v`.
    #[inline(always)]
    pub fn quadratic_form(self, v: Vector<R, D>) -> R {
        v.dot(self.apply(v))
    }
    /// Each entry times the same number.
    #[inline(always)]
    pub fn scale(self, factor: R) -> Self {
        Self::from_fn(
            #[inline(always)]
            |i, j| self.at(i, j) * factor,
        )
    }
}

impl<R: Real, const D: usize> Add for Vector<R, D> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::from_fn(
            #[inline(always)]
            |i| self.0[i] + other.0[i],
        )
    }
}
impl<R: Real, const D: usize> Sub for Vector<R, D> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self::from_fn(
            #[inline(always)]
            |i| self.0[i] - other.0[i],
        )
    }
}
impl<R: Real, const D: usize> Neg for Vector<R, D> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::from_fn(
            #[inline(always)]
            |i| -self.0[i],
        )
    }
}
impl<R: Real, const D: usize> Mul<R> for Vector<R, D> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: R) -> Self {
        self.scale(factor)
    }
}
impl<R, const D: usize> Index<usize> for Vector<R, D> {
    type Output = R;
    #[inline(always)]
    fn index(&self, axis: usize) -> &R {
        &self.0[axis]
    }
}
impl<R, const D: usize> IndexMut<usize> for Vector<R, D> {
    #[inline(always)]
    fn index_mut(&mut self, axis: usize) -> &mut R {
        &mut self.0[axis]
    }
}

impl<M: Copy, R: Choose<M>, const D: usize> Choose<M> for Vector<R, D> {
    #[inline(always)]
    fn pick(mask: M, yes: Self, no: Self) -> Self {
        Self(axes(
            #[inline(always)]
            |i| R::pick(mask, yes.0[i], no.0[i]),
        ))
    }
}
impl<M: Copy, R: Choose<M>, const D: usize> Choose<M> for Matrix<R, D> {
    #[inline(always)]
    fn pick(mask: M, yes: Self, no: Self) -> Self {
        Self(axes(
            #[inline(always)]
            |i| {
                axes(
                    #[inline(always)]
                    |j| R::pick(mask, yes.0[i][j], no.0[i][j]),
                )
            },
        ))
    }
}
impl<M: Copy, R: Choose<M>, const D: usize> Choose<M> for Symmetric<R, D> {
    #[inline(always)]
    fn pick(mask: M, yes: Self, no: Self) -> Self {
        let mut result = no;
        result.0[0] = R::pick(mask, yes.0[0], no.0[0]);
        if D > 1 {
            result.0[1] = R::pick(mask, yes.0[1], no.0[1]);
            result.0[2] = R::pick(mask, yes.0[2], no.0[2]);
        }
        if D > 2 {
            result.0[3] = R::pick(mask, yes.0[3], no.0[3]);
            result.0[4] = R::pick(mask, yes.0[4], no.0[4]);
            result.0[5] = R::pick(mask, yes.0[5], no.0[5]);
        }
        result
    }
}

// Names are built only by symbols; for numbers `named` does nothing, and the format! is never reached.
impl<R: Real, const D: usize> Nameable for Vector<R, D> {
    #[inline(always)]
    fn named(self, name: &str) -> Self {
        if !R::NAMES {
            return self;
        }
        Self(std::array::from_fn(|i| self.0[i].named(&format!("{name}_{}", AXIS[i]))))
    }
}
impl<R: Real, const D: usize> Nameable for Matrix<R, D> {
    #[inline(always)]
    fn named(self, name: &str) -> Self {
        if !R::NAMES {
            return self;
        }
        Self(std::array::from_fn(|i| {
            std::array::from_fn(|j| self.0[i][j].named(&format!("{name}_{}{}", AXIS[i], AXIS[j])))
        }))
    }
}
impl<R: Real, const D: usize> Nameable for Symmetric<R, D> {
    #[inline(always)]
    fn named(self, name: &str) -> Self {
        if !R::NAMES {
            return self;
        }
        Self::from_fn(|i, j| self.at(i, j).named(&format!("{name}_{}{}", AXIS[i], AXIS[j])))
    }
}
