//! A picture of the density in the plane of x and y.

use crate::command::failure::Failure;
use crate::report::{FieldMap, Plot, Window, field_map, nearest};
use etalon_reference::domain::Domain;
use etalon_reference::scenes::State;

/// Pixels along the longer side.
const PIXELS: u32 = 400;

/// The density at the end, at every place that of the nearest particle; in three dimensions of those within a smoothing length of the
/// middle plane. None in one dimension.
pub fn picture<const D: usize>(state: &State, domain: &Domain<D>) -> Result<Option<Plot>, Failure> {
    if D < 2 {
        return Ok(None);
    }
    let (lower, upper, periodic) = (domain.lower(), domain.upper(), domain.periodic());
    let near = |i: usize| {
        (2..D).all(|axis| {
            let middle = 0.5 * (lower[axis] + upper[axis]);
            (state.position[axis][i] - middle).abs() <= state.smoothing_length[i]
        })
    };
    let shown: Vec<usize> = (0..state.len()).filter(|&i| near(i)).collect();
    let points: Vec<[f64; 2]> = shown.iter().map(|&i| [state.position[0][i], state.position[1][i]]).collect();
    if points.is_empty() {
        return Ok(None);
    }
    let density: Vec<f64> = shown.iter().map(|&i| state.density[i]).collect();
    // An open box is as large as what is in it by now.
    let extent = |axis: usize| {
        let all = points.iter().map(|point| point[axis]);
        all.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)))
    };
    let side = |axis: usize| if periodic[axis] { (lower[axis], upper[axis]) } else { extent(axis) };
    let (x, y) = (side(0), side(1));
    let window = Window { low: [x.0, y.0], high: [x.1, y.1], periodic: [periodic[0], periodic[1]] };
    let sample = nearest(&points, &density, window)?;
    let map = FieldMap {
        file: "map_density.svg".into(),
        title: "Density at the end".into(),
        caption: "Each place has the density of the particle nearest to it.".into(),
        field: "ρ [ρ₀]".into(),
        axes: ["x [L]".into(), "y [L]".into()],
        window,
        range: None,
        pixels: PIXELS,
    };
    Ok(Some(field_map(&map, sample)?))
}
