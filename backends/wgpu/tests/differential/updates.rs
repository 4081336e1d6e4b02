//! Every update by itself, within the running bound of the reference.

use etalon_kernels_gen::bounded::Bounded;
use etalon_kernels_gen::trace::Single;
use etalon_kernels_gen::{Component, Footprint, Update, components};
use etalon_reference::conformance::sets::Difficulty;
use etalon_reference::engine::{Engine, PlainEngine};
use etalon_reference::passes::{Correct, Decay, KickDrift};
use etalon_reference::schemes::Dissipation;
use etalon_reference::simulation::Simulation;

use crate::adapter::device;
use crate::scene::{engine, physics, set};

/// A power of two: as exact in one precision as in the other.
const TIME_STEP: f64 = 1.0 / 1024.0;

fn judge<const D: usize, U: Update<D>>(
    update: &U,
    inputs: &mut PlainEngine<f64, D>,
    bounded: &mut PlainEngine<Bounded<Single>, D>,
    device: &mut impl Engine<D>,
) {
    let footprint = Footprint::of_update::<D, U>();
    for component in components(&footprint.own, D) {
        let rounded: Vec<f64> = inputs.read(component).unwrap().iter().map(|&value| f64::from(value as f32)).collect();
        bounded.write(component, &rounded).unwrap();
        device.write(component, &rounded).unwrap();
    }
    bounded.run_update(update, TIME_STEP).unwrap();
    device.run_update(update, TIME_STEP).unwrap();
    for component in components(&footprint.out, D) {
        let found = device.read(component).unwrap();
        let expected = bounded.column(component).unwrap();
        let mut worst = (0.0, 0.0, 0.0);
        for (value, expected) in found.iter().zip(expected) {
            let (error, bound) = ((value - expected.value()).abs(), expected.error());
            let what = name::<D>(component, U::NAME);
            assert!(error <= bound, "{what} is {value:e}: error {error:e}, bound {bound:e}");
            if error > worst.0 * bound {
                worst = (error / bound, error, bound);
            }
        }
        let (ratio, error, bound) = worst;
        let what = name::<D>(component, U::NAME);
        eprintln!("{what}: worst error {error:.2e}, bound {bound:.2e}, {:.0} % of it", 100.0 * ratio);
    }
}

fn name<const D: usize>(component: Component, update: &str) -> String {
    format!("{D}-D {update}: {}", component.name(D))
}

fn check<const D: usize>() {
    let Some(device) = device() else { return };
    let physics = physics::<D>(Dissipation::AvSw);
    let set = set::<D>(Difficulty::None, &physics);
    // A step makes rates and predecessors that differ.
    let mut run = Simulation::new(PlainEngine::<f64, D>::new(&set), physics).unwrap();
    run.step(1.0).unwrap();
    let mut bounded = PlainEngine::new(&set);
    let mut engine = engine(&set, &physics, device);
    judge(&KickDrift(physics), run.engine(), &mut bounded, &mut engine);
    judge(&Correct, run.engine(), &mut bounded, &mut engine);
    judge(&Decay(physics), run.engine(), &mut bounded, &mut engine);
}

#[test]
fn updates_stay_within_the_bound() {
    check::<1>();
    check::<2>();
    check::<3>();
}
