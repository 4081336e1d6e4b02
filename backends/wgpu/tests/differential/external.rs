//! What acts from outside acts on the device as it does on the reference: gravity, driven walls, a force of the host.

use etalon_kernels_gen::Field;
use etalon_kernels_gen::trace::Single;
use etalon_reference::conformance::external::{check_driven_walls, check_forcing, check_free_fall};
use etalon_reference::particles::ParticleSet;
use etalon_wgpu::WgpuEngine;

use crate::adapter::device;

fn holds<const D: usize>() {
    let Some(device) = device() else { return };
    let make = |set: &ParticleSet<D>, fields: &[Field]| WgpuEngine::<D>::new(set, fields, device.clone());
    let fall = check_free_fall::<D, Single, _>(make).unwrap();
    let driven = check_driven_walls::<D, Single, _>(make).unwrap();
    let pushed = check_forcing::<D, Single, _>(make).unwrap();
    for distance in fall.into_iter().chain(driven).chain(pushed) {
        eprintln!("{distance}");
        assert!(distance.holds(), "{distance}");
    }
}

#[test]
fn gas_falls_walls_are_driven_and_forces_push() {
    holds::<1>();
    holds::<2>();
    holds::<3>();
}
