//! Total momentum and energy of the sums that the device forms.

use etalon_kernels_gen::bounded::Bounded;
use etalon_kernels_gen::trace::Single;
use etalon_kernels_gen::{Component, Field, Footprint, Pass, components};
use etalon_reference::conformance::sets::Difficulty;
use etalon_reference::engine::{Engine, EngineError, PlainEngine};
use etalon_reference::fields;
use etalon_reference::pipeline::{PassVisitor, Pipeline};
use etalon_reference::schemes::Dissipation;
use etalon_wgpu::WgpuEngine;

use crate::adapter::device;
use crate::scene::{engine, physics, set};

type BoundedEngine<const D: usize> = PlainEngine<Bounded<Single>, D>;

/// Runs one pass on the device and with bounds, on the inputs of the exact engine rounded to `f32`.
struct Last<'e, const D: usize> {
    exact: PlainEngine<f64, D>,
    bounded: BoundedEngine<D>,
    device: &'e mut WgpuEngine<D>,
}

impl<const D: usize> PassVisitor<D> for Last<'_, D> {
    type Output = Result<(), EngineError>;

    fn visit<P: Pass<D>>(&mut self, pass: &P) -> Self::Output {
        let footprint = Footprint::of_pass::<D, P>(pass);
        for component in components(&[footprint.own, footprint.other].concat(), D) {
            let rounded: Vec<f64> = self.exact.read(component)?.iter().map(|&x| f64::from(x as f32)).collect();
            self.bounded.write(component, &rounded)?;
            self.device.write(component, &rounded)?;
        }
        self.bounded.run_pass(pass)?;
        self.device.run_pass(pass)
    }
}

fn errors<const D: usize>(engine: &BoundedEngine<D>, field: Field, index: usize) -> Vec<f64> {
    engine.column(Component { field, index }).unwrap().iter().map(|bounded| bounded.error()).collect()
}

/// The change of a total, and how much of it the rounding of each particle's own sums can make.
fn judge(what: &str, terms: &[f64], allowed: &[f64]) {
    let total: f64 = terms.iter().sum();
    let size: f64 = terms.iter().map(|term| term.abs()).sum();
    let tolerance: f64 = allowed.iter().sum();
    eprintln!("{what}: total {total:.2e} of terms that sum to {size:.2e} in size; tolerance {tolerance:.2e}");
    assert!(size > 0.0 && tolerance < 1e-3 * size, "{what}: nothing is tested, tolerance {tolerance:e} of {size:e}");
    assert!(total.abs() <= tolerance, "{what}: total {total:e}, tolerance {tolerance:e}");
}

fn check<const D: usize>(dissipation: Dissipation) {
    let Some(device) = device() else { return };
    let physics = physics::<D>(dissipation);
    let support = physics.kernel.support();
    let set = set::<D>(Difficulty::None, &physics);
    let mut engine = engine(&set, &physics, device);
    let mut last = Last { exact: PlainEngine::new(&set), bounded: PlainEngine::new(&set), device: &mut engine };
    last.exact.find_neighbours(support).unwrap();
    last.bounded.find_neighbours(support).unwrap();
    last.device.find_neighbours(support).unwrap();
    let pipeline = Pipeline::of_scene::<D>(&physics);
    pipeline.run(&mut last.exact, physics).unwrap();
    pipeline.passes().last().unwrap().visit(physics, &mut last).unwrap();

    // The particles' masses and velocities are what the device has. Pairs act oppositely up to rounding, so a total is at
    // most the sum of what rounding does to each particle.
    let Last { bounded, device, .. } = last;
    let mass = device.read_scalar(fields::MASS).unwrap();
    let velocity = device.read_all(fields::VELOCITY).unwrap();
    let acceleration = device.read_all(fields::ACCELERATION).unwrap();
    let heating = device.read_scalar(fields::ENERGY_RATE).unwrap();
    let mut power: Vec<f64> = mass.iter().zip(&heating).map(|(m, rate)| m * rate).collect();
    let mut power_allowed: Vec<f64> =
        mass.iter().zip(errors(&bounded, fields::ENERGY_RATE, 0)).map(|(m, error)| m * error).collect();
    for axis in 0..D {
        let error = errors(&bounded, fields::ACCELERATION, axis);
        let force: Vec<f64> = mass.iter().zip(&acceleration[axis]).map(|(m, a)| m * a).collect();
        let allowed: Vec<f64> = mass.iter().zip(&error).map(|(m, error)| m * error).collect();
        judge(&format!("{D}-D {dissipation} force along axis {axis}"), &force, &allowed);
        for i in 0..mass.len() {
            power[i] += force[i] * velocity[axis][i];
            power_allowed[i] += allowed[i] * velocity[axis][i].abs();
        }
    }
    judge(&format!("{D}-D {dissipation} power"), &power, &power_allowed);
}

#[test]
fn momentum_and_energy_are_conserved_by_the_sums() {
    check::<1>(Dissipation::Av);
    check::<2>(Dissipation::AvSlrB2F);
    check::<3>(Dissipation::AvSlrB2);
}
