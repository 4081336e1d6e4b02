//! Drawings of what backends run: the pair body and the epilogue of a [`Pass`], the body of an [`Update`].
//!
//! Names of inputs: `a_<component>` of the particle itself, `b_<component>` of the neighbour, `x_ab_x` (`_y`, `_z`) and
//! `r_squared` of the separation, `sum_<component>` of the finished sums, `time_step`. Outputs are named for the component
//! alone: `velocity_x`.

use super::count::Count;
use super::drawing::Drawing;
use super::error::TraceError;
use super::lint::Finding;
use super::symbol::{Pen, Significand, Symbol, draw};
use crate::pass::{Part, Pass, Separation, Update, used_components};
use crate::real::Real;
use crate::record::{Component, Field, Quantity, Record, Reduction, components};
use crate::vector::Vector;

/// One number that a pass sums over the neighbours.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sum {
    /// The component's name.
    pub name: String,
    /// How contributions combine.
    pub reduction: Reduction,
}

/// A pass, drawn for one dimension and precision.
#[derive(Clone, Debug)]
pub struct PassDrawing {
    /// The pass's name.
    pub name: &'static str,
    /// The number of dimensions.
    pub dimension: usize,
    /// Components read of the particle itself.
    pub own: Vec<String>,
    /// Components read of each neighbour.
    pub other: Vec<String>,
    /// Components summed over the neighbours.
    pub sums: Vec<Sum>,
    /// Components written.
    pub out: Vec<String>,
    /// What one neighbour contributes; the outputs are `sums`.
    pub pair: Drawing,
    /// What the particle makes of the sums; the outputs are `out`.
    pub finish: Drawing,
}

/// An update, drawn for one dimension and precision.
#[derive(Clone, Debug)]
pub struct UpdateDrawing {
    /// The update's name.
    pub name: &'static str,
    /// The number of dimensions.
    pub dimension: usize,
    /// Components read.
    pub own: Vec<String>,
    /// Components written.
    pub out: Vec<String>,
    /// What becomes of the particle; the outputs are `out`.
    pub apply: Drawing,
}

fn names(fields: &[Field], dimension: usize) -> Vec<String> {
    components(fields, dimension).iter().map(|component| component.name(dimension)).collect()
}

fn names_of_used(components: &[Option<Component>], dimension: usize) -> Vec<Option<String>> {
    components.iter().map(|component| component.map(|component| component.name(dimension))).collect()
}

/// A pass's record whose used components are inputs.
fn take_used<F: Significand, Q: Quantity<Symbol<F>>>(pen: &mut Pen<F>, prefix: &str, names: &[Option<String>]) -> Q {
    let mut names = names.iter();
    Q::take(&mut || match names.next() {
        Some(Some(name)) => pen.input(&format!("{prefix}{name}")),
        _ => Symbol::zero(),
    })
}

/// A pass's record whose used components become outputs.
fn give_used<F: Significand, Q: Quantity<Symbol<F>>>(pen: &mut Pen<F>, names: &[Option<String>], record: Q) {
    let mut names = names.iter();
    record.give(&mut |value| {
        if let Some(Some(name)) = names.next() {
            pen.output(name, value);
        }
    });
}

/// A record whose components are inputs.
fn take<F: Significand, Q: Quantity<Symbol<F>>>(pen: &mut Pen<F>, prefix: &str, names: &[String]) -> Q {
    let mut names = names.iter();
    Q::take(&mut || pen.input(&format!("{prefix}{}", names.next().map_or("", String::as_str))))
}

/// A record's components become outputs.
fn give<F: Significand, Q: Quantity<Symbol<F>>>(pen: &mut Pen<F>, names: &[String], record: Q) {
    let mut names = names.iter();
    record.give(&mut |value| pen.output(names.next().map_or("", String::as_str), value));
}

impl Drawing {
    /// Draws a pass as it was written, not simplified.
    ///
    /// # Errors
    /// See [`draw`]; a record that has the same field twice is the likeliest reason.
    pub fn of_pass<const D: usize, P: Pass<D>, F: Significand>(pass: &P) -> Result<PassDrawing, TraceError> {
        let part = |part| used_components::<D, P>(pass, part);
        let [own, other, sum, out] = [Part::Own, Part::Other, Part::Sums, Part::Out].map(part);
        let sums = sum.iter().flatten().map(|c| Sum { name: c.name(D), reduction: c.field.reduction }).collect();
        let [own, other, sum, out] = [own, other, sum, out].map(|components| names_of_used(&components, D));

        let pair = draw::<F>(|pen| {
            let own = take_used(pen, "a_", &own);
            let other = take_used(pen, "b_", &other);
            let x_ab = Vector::from_fn(|axis| pen.input(&format!("x_ab_{}", ["x", "y", "z"][axis])));
            let separation = Separation { x_ab, r_squared: pen.input("r_squared") };
            give_used(pen, &sum, pass.pair(&own, &other, &separation));
        })?;
        let finish = draw::<F>(|pen| {
            let own = take_used(pen, "a_", &own);
            let sums = take_used(pen, "sum_", &sum);
            give_used(pen, &out, pass.finish(&own, &sums));
        })?;
        let [own, other, out] = [own, other, out].map(|names| names.into_iter().flatten().collect());
        Ok(PassDrawing { name: P::NAME, dimension: D, own, other, sums, out, pair, finish })
    }

    /// Draws an update as it was written, not simplified.
    ///
    /// # Errors
    /// See [`draw`].
    pub fn of_update<const D: usize, U: Update<D>, F: Significand>(update: &U) -> Result<UpdateDrawing, TraceError> {
        let own = names(&U::Own::<Symbol<F>>::fields(), D);
        let out = names(&U::Out::<Symbol<F>>::fields(), D);
        let apply = draw::<F>(|pen| {
            let own = take(pen, "a_", &own);
            let time_step = pen.input("time_step");
            give(pen, &out, update.apply(&own, time_step));
        })?;
        Ok(UpdateDrawing { name: U::NAME, dimension: D, own, out, apply })
    }
}

impl PassDrawing {
    /// Both bodies simplified; the epilogue also knows which sums are zero.
    pub fn simplified(&self) -> PassDrawing {
        let pair = self.pair.simplified();
        let zeros: Vec<String> = pair.zero_outputs().iter().map(|name| format!("sum_{name}")).collect();
        let finish = self.finish.simplified_knowing(|input| zeros.iter().any(|zero| zero == input).then_some(0.0));
        PassDrawing { pair, finish, ..self.clone() }
    }
    /// The sums to which no neighbour contributes anything: a driver can drop their accumulators. Ask a
    /// [simplified](PassDrawing::simplified) drawing.
    pub fn zero_sums(&self) -> Vec<&str> {
        self.pair.zero_outputs()
    }
    /// Operations per pair.
    pub fn count_pair(&self) -> Count {
        self.pair.count()
    }
    /// Operations per particle, beside those of its pairs.
    pub fn count_finish(&self) -> Count {
        self.finish.count()
    }
    /// Rewritable expressions in both bodies.
    pub fn lint(&self) -> Vec<Finding> {
        [self.pair.lint(), self.finish.lint()].concat()
    }
}

impl UpdateDrawing {
    /// The body simplified.
    pub fn simplified(&self) -> UpdateDrawing {
        UpdateDrawing { apply: self.apply.simplified(), ..self.clone() }
    }
    /// Operations per particle.
    pub fn count(&self) -> Count {
        self.apply.count()
    }
    /// Rewritable expressions.
    pub fn lint(&self) -> Vec<Finding> {
        self.apply.lint()
    }
}
