//! An engine's fields as the records that passes take.

use etalon_kernels_gen::{Record, components};
use etalon_reference::engine::{Engine, PlainEngine};

/// A record of every particle.
pub fn records<Q: Record<f64>, const D: usize>(engine: &mut PlainEngine<f64, D>) -> Vec<Q> {
    let columns: Vec<Vec<f64>> =
        components(&Q::fields(), D).into_iter().map(|component| engine.read(component).unwrap()).collect();
    (0..engine.particle_count())
        .map(|particle| {
            let mut next = columns.iter();
            Q::from_each(|| next.next().unwrap()[particle])
        })
        .collect()
}
