//! An engine's fields as the records that passes take.

use etalon_kernels_gen::{Part, Pass, Quantity, used_components};
use etalon_reference::engine::{Engine, PlainEngine};

/// One of a pass's records, for every particle; zero for what the pass has no use for.
pub fn records<Q: Quantity<f64>, P: Pass<D>, const D: usize>(
    engine: &mut PlainEngine<f64, D>,
    pass: &P,
    part: Part,
) -> Vec<Q> {
    let columns: Vec<Option<Vec<f64>>> = used_components::<D, P>(pass, part)
        .into_iter()
        .map(|used| used.map(|component| engine.read(component).unwrap()))
        .collect();
    (0..engine.particle_count())
        .map(|particle| {
            let mut next = columns.iter();
            Q::from_each(|| next.next().unwrap().as_ref().map_or(0.0, |column| column[particle]))
        })
        .collect()
}
