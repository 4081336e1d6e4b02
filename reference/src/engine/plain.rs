//! The scalar reference: direct loops over particles and their neighbours, in any scalar type.

use super::{Engine, EngineError, PlainNeighbours, smaller};
use crate::domain::{moved, separation};
use crate::fields;
use crate::particles::ParticleSet;
use etalon_kernels_gen::bounded::{Bounded, Roundoff};
use etalon_kernels_gen::{
    Component, Field, Part, Pass, Quantity, Real, Record, Reduction, Separation, Update, Vector, components,
    used_components,
};
use std::collections::HashMap;

/// Particles in columns of `T`; coordinates in fixed point, separations formed in `f64` before they are rounded to `T`.
pub struct PlainEngine<T, const D: usize> {
    count: usize,
    length: [f64; D],
    coordinates: [Vec<u64>; D],
    columns: HashMap<Component, Vec<T>>,
    neighbours: PlainNeighbours,
}

/// A scalar that passes can run on and the host can read.
pub trait Scalar: Real<Mask = bool> + PartialOrd {
    /// As `f64`.
    fn to_f64(self) -> f64;
    /// From a separation that fixed point gave exactly.
    fn from_separation(exact: f64) -> Self {
        Self::lit(exact)
    }
    /// A sum over neighbours with one more term.
    fn accumulate(self, term: Self) -> Self {
        self + term
    }
}
impl Scalar for f32 {
    fn to_f64(self) -> f64 {
        self as f64
    }
}
impl Scalar for f64 {
    fn to_f64(self) -> f64 {
        self
    }
}

/// Roundings between the exact separation and the one an engine forms: of the difference, the length of a unit, their product.
const SEPARATION_ROUNDINGS: f64 = 3.0;

impl<P: Roundoff> Scalar for Bounded<P> {
    fn to_f64(self) -> f64 {
        self.value()
    }
    fn from_separation(exact: f64) -> Self {
        Bounded::new(exact, SEPARATION_ROUNDINGS * P::UNIT * exact.abs())
    }
    fn accumulate(self, term: Self) -> Self {
        Bounded::accumulate(self, term)
    }
}

impl<T: Scalar, const D: usize> PlainEngine<T, D> {
    /// Takes over the particles.
    pub fn new(set: &ParticleSet<D>) -> Self {
        let mut engine = PlainEngine {
            count: set.len(),
            length: set.domain().torus_length(),
            coordinates: std::array::from_fn(|axis| set.coordinates(axis)),
            columns: HashMap::new(),
            neighbours: PlainNeighbours::default(),
        };
        let mut put = |field: Field, index: usize, value: &dyn Fn(&crate::particles::Particle<D>) -> f64| {
            let column = set.particles().iter().map(|p| T::lit(value(p))).collect();
            engine.columns.insert(Component { field, index }, column);
        };
        put(fields::MASS, 0, &|p| p.mass);
        put(fields::SMOOTHING_LENGTH, 0, &|p| p.smoothing_length);
        put(fields::SETTLED_SMOOTHING_LENGTH, 0, &|p| p.smoothing_length);
        put(fields::INTERNAL_ENERGY, 0, &|p| p.internal_energy);
        put(fields::MOBILITY, 0, &|p| if p.mobile { 1.0 } else { 0.0 });
        for axis in 0..D {
            put(fields::VELOCITY, axis, &|p| p.velocity[axis]);
        }
        if set.dust().is_some() {
            let column = (0..set.len()).map(|i| T::lit(set.species(i))).collect();
            engine.columns.insert(Component { field: fields::SPECIES, index: 0 }, column);
        }
        engine
    }

    /// A component as it is kept, if anything wrote it.
    pub fn column(&self, component: Component) -> Option<&[T]> {
        self.columns.get(&component).map(Vec::as_slice)
    }
    /// The neighbours last found.
    pub fn neighbours(&self) -> &PlainNeighbours {
        &self.neighbours
    }

    /// The columns behind a pass's record, in its order; none for what the pass has no use for.
    fn used_columns<P: Pass<D>>(&self, pass: &P, part: Part) -> Result<Vec<Option<&[T]>>, EngineError> {
        let column = |used: Option<Component>| used.map(|component| self.column_of(component)).transpose();
        used_components::<D, P>(pass, part).into_iter().map(column).collect()
    }

    /// The columns behind a list of fields, in the order records take them.
    fn columns(&self, fields: &[Field]) -> Result<Vec<Option<&[T]>>, EngineError> {
        components(fields, D).into_iter().map(|component| self.column_of(component).map(Some)).collect()
    }

    fn column_of(&self, component: Component) -> Result<&[T], EngineError> {
        let unknown = || EngineError(format!("{} is read before anything wrote it", component.name(D)));
        self.column(component).ok_or_else(unknown)
    }

    /// Keeps what was written; what has no component goes nowhere.
    fn store(&mut self, components: Vec<Option<Component>>, values: Vec<Vec<T>>) {
        for (component, column) in components.into_iter().zip(values) {
            if let Some(component) = component {
                self.columns.insert(component, column);
            }
        }
    }
}

/// A record's values at one particle, zero where there is no column.
fn gather<T: Real, Q: Quantity<T>>(columns: &[Option<&[T]>], particle: usize) -> Q {
    let mut next = columns.iter();
    Q::take(&mut || next.next().copied().flatten().map_or_else(T::zero, |column| column[particle]))
}

fn scatter<T: Real, Q: Quantity<T>>(columns: &mut [Vec<T>], record: Q) {
    let mut k = 0;
    record.give(&mut |value| {
        columns[k].push(value);
        k += 1;
    });
}

impl<T: Scalar, const D: usize> Engine<D> for PlainEngine<T, D> {
    fn particle_count(&self) -> usize {
        self.count
    }

    fn find_neighbours(&mut self, support: f64) -> Result<(), EngineError> {
        let h = self.read_scalar(fields::SMOOTHING_LENGTH)?;
        let reach: Vec<f64> = h.iter().map(|h| support * h).collect();
        if let Some(i) = reach.iter().position(|r| !(r.is_finite() && *r > 0.0)) {
            return Err(EngineError(format!("particle {i} has smoothing length {}; the run has gone wrong", h[i])));
        }
        for (axis, &length) in self.length.iter().enumerate() {
            let largest = reach.iter().copied().fold(0.0, f64::max);
            if 2.0 * largest > length {
                return Err(EngineError(format!(
                    "the box is {length} long on axis {axis}, less than the support's diameter {}; \
                     use more particles or fewer neighbours",
                    2.0 * largest
                )));
            }
        }
        self.neighbours = PlainNeighbours::find(&self.coordinates, &reach, self.length);
        Ok(())
    }

    fn run_pass<P: Pass<D>>(&mut self, pass: &P) -> Result<(), EngineError> {
        if self.neighbours.particles() != self.count {
            return Err(EngineError(format!("pass {} was asked for before neighbours were found", P::NAME)));
        }
        let own_columns = self.used_columns(pass, Part::Own)?;
        let other_columns = self.used_columns(pass, Part::Other)?;
        let sum_fields = components(&P::Sums::<T>::fields(), D);
        let written = used_components::<D, P>(pass, Part::Out);
        let mut out = vec![Vec::with_capacity(self.count); written.len()];
        // Once for each particle, not once for each pair.
        let others: Vec<P::Other<T>> = (0..self.count).map(|b| gather(&other_columns, b)).collect();
        for a in 0..self.count {
            let own: P::Own<T> = gather(&own_columns, a);
            let mut sums = vec![T::zero(); sum_fields.len()];
            for &b in self.neighbours.of(a) {
                let x_ab = Vector::from_fn(|axis| {
                    let column = &self.coordinates[axis];
                    T::from_separation(separation(column[a], column[b as usize], self.length[axis]))
                });
                let at = Separation { x_ab, r_squared: x_ab.norm_squared() };
                let mut k = 0;
                pass.pair(&own, &others[b as usize], &at).give(&mut |term| {
                    sums[k] = match sum_fields[k].field.reduction {
                        Reduction::Sum => sums[k].accumulate(term),
                        Reduction::Max => sums[k].max(term),
                    };
                    k += 1;
                });
            }
            let mut next = sums.iter();
            let sums = P::Sums::<T>::take(&mut || next.next().copied().unwrap_or_else(T::zero));
            scatter(&mut out, pass.finish(&own, &sums));
        }
        self.store(written, out);
        Ok(())
    }

    fn run_update<U: Update<D>>(&mut self, update: &U, time_step: f64) -> Result<(), EngineError> {
        let own_columns = self.columns(&U::Own::<T>::fields())?;
        let written: Vec<_> = components(&U::Out::<T>::fields(), D).into_iter().map(Some).collect();
        let mut out = vec![Vec::with_capacity(self.count); written.len()];
        for a in 0..self.count {
            let own: U::Own<T> = gather(&own_columns, a);
            scatter(&mut out, update.apply(&own, T::lit(time_step)));
        }
        self.store(written, out);
        Ok(())
    }

    fn drift(&mut self) -> Result<(), EngineError> {
        let displacement = self.read_all(fields::DISPLACEMENT)?;
        for (axis, (column, moves)) in self.coordinates.iter_mut().zip(&displacement).enumerate() {
            let length = self.length[axis];
            for (coordinate, &d) in column.iter_mut().zip(moves) {
                if d.abs() * 2.0 >= length || !d.is_finite() {
                    return Err(EngineError(format!("a particle moves by {d} in one step along axis {axis}")));
                }
                *coordinate = moved(*coordinate, d, length);
            }
        }
        Ok(())
    }

    fn minimum(&mut self, field: Field) -> Result<f64, EngineError> {
        Ok(self.read_scalar(field)?.into_iter().fold(f64::INFINITY, smaller))
    }

    fn read(&mut self, component: Component) -> Result<Vec<f64>, EngineError> {
        let column = self
            .columns
            .get(&component)
            .ok_or_else(|| EngineError(format!("{} is read before anything wrote it", component.name(D))))?;
        Ok(column.iter().map(|v| v.to_f64()).collect())
    }

    fn write(&mut self, component: Component, values: &[f64]) -> Result<(), EngineError> {
        if values.len() != self.count {
            return Err(EngineError(format!(
                "{} has {} values for {} particles",
                component.name(D),
                values.len(),
                self.count
            )));
        }
        self.columns.insert(component, values.iter().map(|&v| T::lit(v)).collect());
        Ok(())
    }

    fn coordinates(&mut self, axis: usize) -> Result<Vec<u64>, EngineError> {
        Ok(self.coordinates[axis].clone())
    }

    fn place(&mut self, axis: usize, coordinates: &[u64]) -> Result<(), EngineError> {
        if coordinates.len() != self.count {
            let (found, wanted) = (coordinates.len(), self.count);
            return Err(EngineError(format!("axis {axis} has {found} coordinates for {wanted} particles")));
        }
        self.coordinates[axis].copy_from_slice(coordinates);
        Ok(())
    }

    fn forget_neighbours(&mut self) {
        self.neighbours = PlainNeighbours::default();
    }
}
