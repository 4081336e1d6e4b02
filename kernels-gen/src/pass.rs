//! What a backend runs: a [`Pass`] (a sum over neighbours with an epilogue) or an [`Update`] (each particle by itself).
//!
//! Both are defined once, generic over the number; every backend has one driver for each. What a pass reads and writes is in
//! the types of its records, so a pipeline can be derived from it and a backend can lay its data out for it.

use crate::real::Real;
use crate::record::{Component, Field, Record, components};
use crate::vector::Vector;

/// A pair on its way through a pass: particle `a`, its neighbour `b`, and what lies between them.
#[derive(Clone, Copy, Debug)]
pub struct Separation<R, const D: usize> {
    /// `x_a - x_b`: the vector from the neighbour to the particle.
    pub x_ab: Vector<R, D>,
    /// `|x_a - x_b|^2`.
    pub r_squared: R,
}

/// Which of its four records a pass has a field in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Part {
    /// [`Pass::Own`].
    Own,
    /// [`Pass::Other`].
    Other,
    /// [`Pass::Sums`].
    Sums,
    /// [`Pass::Out`].
    Out,
}

/// One sweep over all particles: for each, a sum (or maximum) over its neighbours, then an epilogue.
///
/// The driver visits every neighbour `b != a` for which `r` is less than the larger of the two supports, so a pair acts within
/// the support of either. The pair body must return exactly zero contributions where the kernels vanish. The particle itself is
/// not visited: epilogues add self terms by name.
///
/// Fields written by a pass must not be among those it reads of neighbours; each backend's tests check it.
pub trait Pass<const D: usize>: Copy + Send + Sync + 'static {
    /// Read of the particle itself, by the pair body and the epilogue.
    type Own<R: Real>: Record<R>;
    /// Read of each neighbour.
    type Other<R: Real>: Record<R>;
    /// Summed over the neighbours; each field's [`Reduction`](crate::Reduction) says how.
    type Sums<R: Real>: Record<R>;
    /// Written for the particle.
    type Out<R: Real>: Record<R>;

    /// The pass's name, in snake case.
    const NAME: &'static str;

    /// Whether the pass, as its scene has it, has a use for a field of one of its records.
    ///
    /// What it has no use for no particle carries on its account, and no drawing of it has: as an input it is a number without meaning, as
    /// an output it is zero and goes nowhere.
    fn uses(&self, _part: Part, _field: Field) -> bool {
        true
    }
    /// What one neighbour contributes.
    fn pair<R: Real>(&self, own: &Self::Own<R>, other: &Self::Other<R>, separation: &Separation<R, D>)
    -> Self::Sums<R>;
    /// What the particle makes of the sums.
    fn finish<R: Real>(&self, own: &Self::Own<R>, sums: &Self::Sums<R>) -> Self::Out<R>;
}

/// One sweep in which each particle looks only at itself.
pub trait Update<const D: usize>: Copy + Send + Sync + 'static {
    /// Read.
    type Own<R: Real>: Record<R>;
    /// Written.
    type Out<R: Real>: Record<R>;

    /// The update's name, in snake case.
    const NAME: &'static str;

    /// What becomes of the particle in a step of length `time_step`.
    fn apply<R: Real>(&self, own: &Self::Own<R>, time_step: R) -> Self::Out<R>;
}

/// What a pass or update reads and writes, without its types.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Footprint {
    /// The pass's name.
    pub name: &'static str,
    /// Read of the particle itself.
    pub own: Vec<Field>,
    /// Read of each neighbour; empty for an update.
    pub other: Vec<Field>,
    /// Summed over neighbours; empty for an update.
    pub sums: Vec<Field>,
    /// Written.
    pub out: Vec<Field>,
}

impl Footprint {
    /// Of a pass: the fields it has a use for.
    pub fn of_pass<const D: usize, P: Pass<D>>(pass: &P) -> Self {
        let used = |part| {
            let mut fields = fields_of::<D, P>(part);
            fields.retain(|field| pass.uses(part, *field));
            fields
        };
        Footprint {
            name: P::NAME,
            own: used(Part::Own),
            other: used(Part::Other),
            sums: used(Part::Sums),
            out: used(Part::Out),
        }
    }
    /// Of an update.
    pub fn of_update<const D: usize, U: Update<D>>() -> Self {
        Footprint {
            name: U::NAME,
            own: <U::Own<f64> as Record<f64>>::fields(),
            other: Vec::new(),
            sums: Vec::new(),
            out: <U::Out<f64> as Record<f64>>::fields(),
        }
    }
}

/// All fields of one of a pass's records, used or not.
fn fields_of<const D: usize, P: Pass<D>>(part: Part) -> Vec<Field> {
    match part {
        Part::Own => <P::Own<f64> as Record<f64>>::fields(),
        Part::Other => <P::Other<f64> as Record<f64>>::fields(),
        Part::Sums => <P::Sums<f64> as Record<f64>>::fields(),
        Part::Out => <P::Out<f64> as Record<f64>>::fields(),
    }
}

/// Every number of one of a pass's records in the record's order, none in place of those the pass has no use for.
pub fn used_components<const D: usize, P: Pass<D>>(pass: &P, part: Part) -> Vec<Option<Component>> {
    let used = |component: Component| pass.uses(part, component.field).then_some(component);
    components(&fields_of::<D, P>(part), D).into_iter().map(used).collect()
}
