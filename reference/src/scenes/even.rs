//! Places that fill a box evenly.

/// The middles of so many cells along each axis, all of this width, from the origin on.
pub(crate) fn lattice<const D: usize>(cells: [usize; D], width: f64) -> Vec<[f64; D]> {
    let place = |mut i: usize| {
        cells.map(|along| {
            let cell = i % along;
            i /= along;
            (cell as f64 + 0.5) * width
        })
    };
    (0..cells.iter().product()).map(place).collect()
}
