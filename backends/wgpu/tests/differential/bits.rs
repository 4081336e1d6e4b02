//! How near the device comes to the scalar reference in the same precision and the same unfused arithmetic.

use etalon_kernels_gen::{Footprint, Pass, components};
use etalon_reference::conformance::runs::FACTOR;
use etalon_reference::conformance::sets::Difficulty;
use etalon_reference::engine::{Engine, EngineError, PlainEngine};
use etalon_reference::pipeline::{PassVisitor, Pipeline};
use etalon_reference::schemes::Dissipation;
use etalon_wgpu::WgpuEngine;

use crate::adapter::device;
use crate::scene::{all_fields, physics, set};

struct Compare<'e, const D: usize> {
    /// Where each pass's inputs come from.
    exact: PlainEngine<f64, D>,
    plain: PlainEngine<f32, D>,
    device: &'e mut WgpuEngine<D>,
}

fn rms(differences: impl Iterator<Item = f64>) -> f64 {
    let squares: Vec<f64> = differences.map(|difference| difference * difference).collect();
    (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
}

impl<const D: usize> PassVisitor<D> for Compare<'_, D> {
    type Output = Result<(), EngineError>;

    fn visit<P: Pass<D>>(&mut self, pass: &P) -> Self::Output {
        let footprint = Footprint::of_pass::<D, P>(pass);
        for component in components(&[footprint.own, footprint.other].concat(), D) {
            let values = self.exact.read(component)?;
            self.plain.write(component, &values)?;
            self.device.write(component, &values)?;
            // The exact sums get the same rounded inputs.
            let rounded = self.plain.read(component)?;
            self.exact.write(component, &rounded)?;
        }
        self.exact.run_pass(pass)?;
        self.plain.run_pass(pass)?;
        self.device.run_pass(pass)?;
        let (mut identical, mut all) = (0, 0);
        for component in components(&footprint.out, D) {
            let exact = self.exact.read(component)?;
            let plain = self.plain.read(component)?;
            let found = self.device.read(component)?;
            all += found.len();
            // As numbers: the sign of a zero is nobody's business.
            identical += found.iter().zip(&plain).filter(|(a, b)| a == b).count();
            let apart = rms(found.iter().zip(&plain).map(|(a, b)| a - b));
            let tolerance = FACTOR * rms(plain.iter().zip(&exact).map(|(a, b)| a - b));
            let name = component.name(D);
            assert!(apart <= tolerance, "{D}-D {}: {name} rms {apart:e}, tolerance {tolerance:e}", P::NAME);
        }
        let share = 100.0 * identical as f64 / all as f64;
        eprintln!("{D}-D {}: {identical} of {all} outputs, {share:.2} %, are those of scalar f32", P::NAME);
        Ok(())
    }
}

fn check<const D: usize>(dissipation: Dissipation) {
    let Some(device) = device() else { return };
    let physics = physics::<D>(dissipation);
    // The sides are 1: lengths of a unit are powers of two, and separations the same however they are formed.
    let set = set::<D>(Difficulty::None, &physics);
    let fields = all_fields::<D>(&physics);
    let mut engine = WgpuEngine::in_original_order(&set, &fields, device.clone()).unwrap();
    let mut compare = Compare { exact: PlainEngine::new(&set), plain: PlainEngine::new(&set), device: &mut engine };
    let support = physics.kernel.support();
    compare.exact.find_neighbours(support).unwrap();
    compare.plain.find_neighbours(support).unwrap();
    compare.device.find_neighbours(support).unwrap();
    for pass in Pipeline::of_scene::<D>(&physics).passes() {
        pass.visit(physics, &mut compare).unwrap();
    }
}

#[test]
fn the_device_is_as_near_to_scalar_f32_as_wgsl_promises() {
    check::<1>(Dissipation::Av);
    check::<1>(Dissipation::AvSlrB2F);
    check::<2>(Dissipation::AvSlrB2F);
    check::<3>(Dissipation::Av);
    check::<3>(Dissipation::AvSlrB2);
}
