//! Single functions called for each row of a table.

use etalon_kernels_gen::Real;
use etalon_kernels_gen::trace::{Drawing, Single, draw};
use etalon_wgpu::{AdapterPreference, Device, DeviceOptions, Error, call_function};

use crate::common::device;

/// `x y + z`, the smaller of `x` and `z`, and the first again; under names of which two are words of WGSL.
fn toy() -> Drawing {
    draw::<Single>(|pen| {
        let [x, y, z] = ["x", "loop", "z"].map(|name| pen.input(name));
        pen.output("sum", x * y + z);
        pen.output("return", x.min(z));
        pen.output("again", x * y + z);
    })
    .unwrap()
}

/// Whole numbers, so that nothing is rounded whatever a driver makes of the text.
fn rows(calls: usize) -> (Vec<f32>, Vec<f32>) {
    let at = |call: usize| [call as f32 - 50.0, (call % 7) as f32, 3.0 - (call % 11) as f32];
    let given = (0..calls).flat_map(at).collect();
    let due = (0..calls).map(at).flat_map(|[x, y, z]| [x * y + z, x.min(z), x * y + z]).collect();
    (given, due)
}

#[test]
fn every_row_gets_its_own_results() {
    let Some(device) = device() else { return };
    for calls in [0, 1, 63, 64, 65, 4097] {
        let (given, due) = rows(calls);
        assert_eq!(call_function(device, "override", &toy(), calls, &given).unwrap(), due, "{calls} calls");
    }
}

#[test]
fn tables_longer_than_a_binding_go_in_parts() {
    if device().is_none() {
        return;
    }
    let preference = AdapterPreference::from_environment();
    let small = Device::open_with(&DeviceOptions { preference, largest_binding: Some(256) }).unwrap();
    let (given, due) = rows(1000);
    assert_eq!(call_function(&small, "toy", &toy(), 1000, &given).unwrap(), due);
}

#[test]
fn a_function_without_inputs_has_its_constants() {
    let Some(device) = device() else { return };
    let drawing = draw::<Single>(|pen| pen.output("half", Real::lit(0.5))).unwrap();
    assert_eq!(call_function(device, "constant", &drawing, 3, &[]).unwrap(), [0.5, 0.5, 0.5]);
}

#[test]
fn a_table_that_is_cut_off_is_refused() {
    let Some(device) = device() else { return };
    let (given, _) = rows(5);
    let error = call_function(device, "toy", &toy(), 5, &given[1..]).unwrap_err();
    assert!(matches!(error, Error::WrongLength { expected: 15, found: 14, .. }), "{error}");
}
