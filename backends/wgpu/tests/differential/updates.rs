//! Every update by itself, for particles that move and for walls, within the running bound of the reference.

use etalon_kernels_gen::trace::Single;
use etalon_reference::conformance::check_updates;
use etalon_wgpu::WgpuEngine;

use crate::adapter::device;

fn conforms<const D: usize>() {
    let Some(device) = device() else { return };
    let summary = check_updates::<D, Single, _>(|set, fields| WgpuEngine::new(set, fields, device.clone())).unwrap();
    let (place, worst) = summary.worst.expect("nothing was compared");
    eprintln!("{D}-D: {} numbers; nearest to its bound: {place}: {worst}", summary.compared);
    assert!(summary.failures.is_empty(), "{} failures:\n{}", summary.failures.len(), summary.failures.join("\n"));
}

#[test]
fn updates_stay_within_the_bound() {
    conforms::<1>();
    conforms::<2>();
    conforms::<3>();
}
