//! What a scene measures while it runs, and at the end.

use crate::report::model::{CurveColumn, EndCurve, EndQuantity, Ending, ExpectedLine, Series, SeriesQuantity};
use etalon_reference::scenes::{Axis, Course, Curve, Quantity, Scene, SceneError, State};

/// Without a choice, how many measurements a run makes beside that of the start.
const USUAL: f64 = 50.0;

/// The measurements of one run: at the start, after the first step past every mark, and at the end. Steps are not cut short to hit a mark, so that a run
/// that is watched is the same as one that is not.
pub struct Observer<'a, const D: usize> {
    scene: &'a dyn Scene<D>,
    every: f64,
    next: f64,
    start: Option<State>,
    times: Vec<f64>,
    values: Vec<Vec<f64>>,
}

impl<'a, const D: usize> Observer<'a, D> {
    /// Of a run until `end`, with so much time between two measurements.
    pub fn new(scene: &'a dyn Scene<D>, every: Option<f64>, end: f64) -> Self {
        let values = scene.quantities().iter().map(|_| Vec::new()).collect();
        Observer { scene, every: every.unwrap_or(end / USUAL), next: 0.0, start: None, times: Vec::new(), values }
    }

    /// Whether something is to be measured at a time; `last` at the end.
    pub fn wants(&self, time: f64, last: bool) -> bool {
        !self.values.is_empty() && (time >= self.next || (last && self.times.last() != Some(&time)))
    }

    /// Measures.
    pub fn measure(&mut self, state: State) -> Result<(), SceneError> {
        let values = self.scene.observe_since(self.start.as_ref().unwrap_or(&state), &state)?;
        self.times.push(state.time);
        for (column, value) in self.values.iter_mut().zip(values) {
            column.push(value);
        }
        // Several marks may have gone by in one step.
        self.next = self.every * ((state.time / self.every).floor() + 1.0);
        self.start.get_or_insert(state);
        Ok(())
    }

    /// What was measured until now: when, and quantity by quantity.
    pub fn so_far(&self) -> (&[f64], &[Vec<f64>]) {
        (&self.times, &self.values)
    }

    /// Takes what was measured before a stop in place of what it has. The start was measured again, for what is compared with it.
    pub fn go_on(&mut self, times: Vec<f64>, values: Vec<Vec<f64>>) {
        let last = times.last().copied().unwrap_or(0.0);
        self.next = self.every * ((last / self.every).floor() + 1.0);
        (self.times, self.values) = (times, values);
    }

    /// Measures what there is at the end alone.
    pub fn ending(&self, end: &State) -> Result<Ending, SceneError> {
        let course = Course { end, time: &self.times, values: &self.values };
        let found = self.scene.at_end(&course)?;
        let quantity = |(quantity, value): (Quantity, Result<f64, String>)| EndQuantity {
            name: quantity.name.into(),
            label: quantity.label.into(),
            symbol: quantity.symbol.into(),
            unit: quantity.unit.into(),
            expected: quantity.expected.map(|(value, _)| value),
            expected_source: quantity.expected.map(|(_, source)| source.into()),
            missing: value.clone().err(),
            value: value.ok(),
        };
        let quantities = self.scene.quantities_at_end().into_iter().zip(found.values).map(quantity).collect();
        Ok(Ending { quantities, curves: found.curves.into_iter().map(curve).collect() })
    }

    /// All that was measured on the way.
    pub fn series(self) -> Series {
        let quantity = |(quantity, value): (Quantity, Vec<f64>)| SeriesQuantity {
            name: quantity.name.into(),
            label: quantity.label.into(),
            symbol: quantity.symbol.into(),
            unit: quantity.unit.into(),
            expected: quantity.expected.map(|(value, _)| value),
            expected_source: quantity.expected.map(|(_, source)| source.into()),
            value,
        };
        let quantities = self.scene.quantities().into_iter().zip(self.values).map(quantity).collect();
        Series { time: self.times, quantities }
    }
}

fn curve(curve: Curve) -> EndCurve {
    let (x, y) = curve.points.into_iter().unzip();
    let column = |axis: Axis, value| CurveColumn {
        name: axis.name.into(),
        label: axis.label.into(),
        unit: axis.unit.into(),
        logarithmic: axis.logarithmic,
        value,
    };
    let expected = curve.expected.map(|line| {
        let (x, y) = line.points.into_iter().unzip();
        ExpectedLine { source: line.source.into(), x, y }
    });
    let (x, y) = (column(curve.x, x), column(curve.y, y));
    EndCurve { name: curve.name.into(), label: curve.label.into(), x, y, expected }
}
