//! Any sweep among particles of one species: what makes the sweeps of a gas those of gas and dust.
//!
//! In a mixture densities, volumes and gradients come from neighbours of the same species (PL20 section 2.2), and only gas has pressure, viscosity
//! and conduction. The pair bodies are the gas's own; pairs that do not count are masked.

use crate::fields::SPECIES;
use etalon_kernels_gen::{Field, Part, Pass, Quantity, Real, Record, Separation};

/// A sweep in which each particle sees the neighbours of its own species only.
#[derive(Clone, Copy, Debug)]
pub struct SameSpecies<P>(pub P);

/// A sweep in which gas sees gas, and dust nothing.
///
/// Dust gets what the sweep makes of sums of zero: no force but gravity, no heat, the longest step.
#[derive(Clone, Copy, Debug)]
pub struct GasOnly<P>(pub P);

/// Another record and, behind it, the species.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OfSpecies<R, Q> {
    /// All but the species.
    pub record: Q,
    /// The field [`SPECIES`].
    pub species: R,
}

impl<R: Real, Q: Quantity<R>> Quantity<R> for OfSpecies<R, Q> {
    const COUNT: usize = Q::COUNT + 1;
    #[inline(always)]
    fn take(next: &mut impl FnMut() -> R) -> Self {
        OfSpecies { record: Q::take(next), species: next() }
    }
    #[inline(always)]
    fn give(self, put: &mut impl FnMut(R)) {
        self.record.give(put);
        put(self.species);
    }
    #[inline(always)]
    fn zip(self, other: Self, f: &mut impl FnMut(R, R) -> R) -> Self {
        OfSpecies { record: self.record.zip(other.record, f), species: f(self.species, other.species) }
    }
}

impl<R: Real, Q: Record<R>> Record<R> for OfSpecies<R, Q> {
    fn fields() -> Vec<Field> {
        let mut fields = Q::fields();
        fields.push(SPECIES);
        fields
    }
    #[inline(always)]
    fn combine(self, other: Self) -> Self {
        OfSpecies {
            record: self.record.combine(other.record),
            species: SPECIES.reduction.combine(self.species, other.species),
        }
    }
}

/// Half-way between gas, zero, and dust, one.
const BETWEEN: f64 = 0.5;

/// Whether this species is gas.
#[inline(always)]
pub fn is_gas<R: Real>(species: R) -> R::Mask {
    species.lt(R::lit(BETWEEN))
}

/// Whether these species are two.
#[inline(always)]
pub(super) fn differ<R: Real>(a: R, b: R) -> R::Mask {
    (a - b).abs().gt(R::lit(BETWEEN))
}

/// What a pair contributes where it counts; elsewhere zero, with which sums and maxima begin.
#[inline(always)]
fn counted<R: Real, Q: Quantity<R>>(counts: R::Mask, terms: Q) -> Q {
    let zero = Q::from_each(
        #[inline(always)]
        || R::zero(),
    );
    terms.zip_with(
        zero,
        #[inline(always)]
        |term, zero| R::pick(counts, term, zero),
    )
}

macro_rules! masked {
    ($name:ident: |$a:ident, $b:ident| $counts:expr) => {
        impl<P: Pass<D>, const D: usize> Pass<D> for $name<P> {
            type Own<R: Real> = OfSpecies<R, P::Own<R>>;
            type Other<R: Real> = OfSpecies<R, P::Other<R>>;
            type Sums<R: Real> = P::Sums<R>;
            type Out<R: Real> = P::Out<R>;
            const NAME: &'static str = P::NAME;

            fn uses(&self, part: Part, field: Field) -> bool {
                self.0.uses(part, field)
            }

            #[inline(always)]
            fn pair<R: Real>(
                &self,
                own: &Self::Own<R>,
                other: &Self::Other<R>,
                at: &Separation<R, D>,
            ) -> Self::Sums<R> {
                let ($a, $b) = (own.species, other.species);
                counted($counts, self.0.pair(&own.record, &other.record, at))
            }

            #[inline(always)]
            fn finish<R: Real>(&self, own: &Self::Own<R>, sums: &Self::Sums<R>) -> Self::Out<R> {
                self.0.finish(&own.record, sums)
            }
        }
    };
}

masked!(SameSpecies: |a, b| (a - b).abs().lt(R::lit(BETWEEN)));
// The sum of the two is zero for two of gas, else one or two.
masked!(GasOnly: |a, b| is_gas(a + b));
