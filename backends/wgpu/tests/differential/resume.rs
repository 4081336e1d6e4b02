//! A run on the device that is interrupted goes on bit for bit.

use etalon_reference::conformance::resume::differing;
use etalon_reference::conformance::sets::Difficulty;
use etalon_reference::schemes::Dissipation;

use crate::adapter::device;
use crate::scene::{physics, set};

fn check<const D: usize>(dissipation: Dissipation) {
    let Some(device) = device() else { return };
    let physics = physics::<D>(dissipation);
    let set = set::<D>(Difficulty::None, &physics);
    let make = |set: &_, fields: &[_]| etalon_wgpu::WgpuEngine::<D>::new(set, fields, device.clone()).unwrap();
    // The start takes 11 searches; particles are put in order at every tenth: once in the second half.
    let found = differing(make, &set, physics, [4, 6], Ok).unwrap();
    assert!(found.is_empty(), "{D}-D, {dissipation}: {found:?} differ after a resumed run");
}

#[test]
fn a_run_on_the_device_resumes_bit_for_bit() {
    check::<1>(Dissipation::AvSw);
    check::<2>(Dissipation::AvSlrB2);
}
