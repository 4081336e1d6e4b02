//! Every pass by itself, on difficult particles, with every scheme, kernel and grad-h form, against the scalar reference in double
//! precision, which carries a running bound of the error that single precision may make. The bound is proven to first order, so no
//! tolerance is chosen here.

use etalon_kernels_gen::trace::Single;
use etalon_reference::conformance::{Summary, check_dimension, check_mixtures};
use etalon_wgpu::WgpuEngine;

use crate::adapter::device;

fn conforms<const D: usize>() {
    let Some(device) = device() else { return };
    let summary = check_dimension::<D, Single, _>(|set, fields| WgpuEngine::new(set, fields, device.clone()));
    holds::<D>(summary.unwrap());
}

fn mixtures_conform<const D: usize>() {
    let Some(device) = device() else { return };
    let summary = check_mixtures::<D, Single, _>(|set, fields| WgpuEngine::new(set, fields, device.clone()));
    holds::<D>(summary.unwrap());
}

fn holds<const D: usize>(summary: Summary) {
    let (place, worst) = summary.worst.expect("nothing was compared");
    eprintln!("{D}-D: {} numbers; nearest to its bound: {place}: {worst}", summary.compared);
    let (place, loosest) = summary.loosest.expect("no set without difficulty");
    let (pass, component, looseness) = (loosest.pass, loosest.component, loosest.looseness);
    eprintln!("{D}-D: widest bound: {place}: {pass} {component}, {looseness:.1e} of the value");
    assert!(summary.failures.is_empty(), "{} failures:\n{}", summary.failures.len(), summary.failures.join("\n"));
}

#[test]
fn passes_in_one_dimension_stay_within_the_bound() {
    conforms::<1>();
}

#[test]
fn passes_in_two_dimensions_stay_within_the_bound() {
    conforms::<2>();
}

#[test]
fn passes_in_three_dimensions_stay_within_the_bound() {
    conforms::<3>();
}

#[test]
fn passes_of_gas_with_dust_stay_within_the_bound() {
    mixtures_conform::<1>();
    mixtures_conform::<2>();
    mixtures_conform::<3>();
}
