//! What a run left, as the scene looks at it.

use etalon_reference::scenes::{Solution, State, View};
use std::sync::Arc;

/// How many fields are compared.
pub const FIELDS: usize = 4;
/// Where the velocity stands among them.
pub const VELOCITY: usize = 1;
/// Where the internal energy stands.
pub const ENERGY: usize = 3;

/// The fields that are compared, in the order in which they are shown.
pub fn names(view: View) -> [&'static str; FIELDS] {
    ["density", view.velocity(), "pressure", "internal_energy"]
}

/// A state with every particle's coordinate and the component of its velocity that is compared.
#[derive(Clone, Debug)]
pub struct Seen {
    /// The particles; shared, for several may keep them.
    pub state: Arc<State>,
    /// Where each is along the view.
    pub coordinate: Vec<f64>,
    velocity: Vec<f64>,
}

impl Seen {
    /// Looks at a state.
    pub fn new(state: State, view: View) -> Self {
        let (coordinate, velocity) = state.seen(view);
        Seen { state: Arc::new(state), coordinate, velocity }
    }

    /// The compared fields, in the order of [`names`].
    pub fn compared(&self) -> [&[f64]; FIELDS] {
        [&self.state.density, &self.velocity, &self.state.pressure, &self.state.internal_energy]
    }
}

/// The four fields of a solution at many places, field by field.
pub fn columns(solution: &dyn Solution, places: &[f64]) -> [Vec<f64>; FIELDS] {
    let rows: Vec<[f64; FIELDS]> = places.iter().map(|&x| solution.at(x)).collect();
    std::array::from_fn(|k| rows.iter().map(|row| row[k]).collect())
}
