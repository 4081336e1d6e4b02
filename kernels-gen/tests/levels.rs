//! Every operation on every vector level against the scalar with the same rounding, for values that no legal input has: NaN, infinities,
//! zeros of either sign, the smallest and the largest numbers.
//!
//! Equations are made of these operations and nothing else, so where each gives the same on every level, each equation does.

use etalon_kernels_gen::lanes::{LaneLevel, LaneProgram, available_levels, dispatch, level_name};
use etalon_kernels_gen::{Fused, Mask, Real};
use fearless_simd::prelude::*;
use fearless_simd::{f32x16, f64x8};

/// All operations of a number: those of two arguments with the first as third where there is one.
#[inline(always)]
fn all_operations<R: Real>(a: R, b: R) -> [R; 19] {
    let as_number = |mask: R::Mask| R::pick(mask, R::one(), R::zero());
    [
        a + b,
        a - b,
        a * b,
        a / b,
        -a,
        a.abs(),
        a.sqrt(),
        a.min(b),
        a.max(b),
        a.mul_add(b, a),
        as_number(a.lt(b)),
        as_number(a.le(b)),
        as_number(a.gt(b)),
        as_number(a.ge(b)),
        as_number(a.lt(b).not()),
        as_number(a.le(b).and(b.le(a))),
        as_number(a.lt(b).or(b.lt(a))),
        a.lt(b).choose(|| a, || b),
        a.le(b).choose_rare(|| a, || b),
    ]
}

macro_rules! same_on_every_level {
    ($name:ident, $program:ident, $float:ty, $vector:ident, $lanes:literal) => {
        /// All operations on these pairs.
        struct $program<'a>(&'a [($float, $float)]);
        impl LaneProgram for $program<'_> {
            type Output = Vec<[$float; 19]>;
            #[inline(always)]
            fn run<S: LaneLevel>(self, level: S) -> Self::Output {
                let one = |&(a, b): &($float, $float)| {
                    // Other values in other lanes, so that a choice of the rare side is made for one of them only.
                    let mut lanes: [$float; $lanes] = [1.0; $lanes];
                    lanes[0] = a;
                    let first = $vector::<S>::from_slice(level, &lanes);
                    lanes[0] = b;
                    let second = $vector::<S>::from_slice(level, &lanes);
                    all_operations(first, second).map(|lanes| lanes.as_slice()[0])
                };
                self.0.iter().map(one).collect()
            }
            fn one_by_one(self) -> Self::Output {
                self.0.iter().map(|&(a, b)| all_operations(Fused(a), Fused(b)).map(|x| x.0)).collect()
            }
        }

        fn $name() {
            let sizes =
                [0.0, <$float>::from_bits(1), <$float>::MIN_POSITIVE, 0.5, 1.0, <$float>::MAX, <$float>::INFINITY];
            let mut values: Vec<$float> = sizes.iter().flat_map(|&size| [size, -size]).collect();
            values.push(<$float>::NAN);
            let pairs: Vec<_> = values.iter().flat_map(|&a| values.iter().map(move |&b| (a, b))).collect();
            let due = $program(&pairs).one_by_one();
            for level in available_levels() {
                for ((pair, got), due) in pairs.iter().zip(dispatch(level, $program(&pairs))).zip(&due) {
                    for (operation, (got, due)) in got.iter().zip(due).enumerate() {
                        // A NaN is a NaN, whatever its bits.
                        let same = got.to_bits() == due.to_bits() || got.is_nan() && due.is_nan();
                        assert!(
                            same,
                            "operation {operation} on {pair:?}: {got:e} on {}, {due:e} due",
                            level_name(level)
                        );
                    }
                }
            }
            println!(
                "{} pairs on {:?}",
                pairs.len(),
                available_levels().into_iter().map(level_name).collect::<Vec<_>>()
            );
        }
    };
}

same_on_every_level!(single, Single, f32, f32x16, 16);
same_on_every_level!(double, Double, f64, f64x8, 8);

#[test]
fn bad_values_are_alike_on_every_level() {
    single();
    double();
}
