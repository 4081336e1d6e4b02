//! The reduction: exact, so no tolerance.

use etalon_wgpu::{FieldStore, Parameters, Reducer, Timer};

use crate::common::{Random, device};

/// Order of the reduction: by bits, -0 below +0.
fn expected(values: &[f32]) -> (u32, u32) {
    let smallest = values.iter().copied().min_by(f32::total_cmp).unwrap();
    let largest = values.iter().copied().max_by(f32::total_cmp).unwrap();
    (smallest.to_bits(), largest.to_bits())
}

#[test]
fn extremes_of_any_length_and_of_any_numbers() {
    let Some(device) = device() else { return };
    let reducer = Reducer::new(device).unwrap();
    let mut random = Random(20);
    // One thread, one workgroup, several, and more than the first stage has threads (256 * 64).
    for count in [1, 2, 63, 64, 65, 1000, 16384, 16385, 100_003] {
        let fields = FieldStore::new(device, 3, count).unwrap();
        // Neighbouring components hold larger and smaller values, which must not be seen.
        fields.upload(device, 0, &vec![f32::MAX; count]).unwrap();
        fields.upload(device, 2, &vec![f32::MIN; count]).unwrap();
        let reduction = reducer.reduction(device, &fields, 1).unwrap();
        for kind in 0..5 {
            let values: Vec<f32> = (0..count)
                .map(|_| match kind {
                    0 => random.between(-1.0, 1.0) as f32,
                    1 => random.between(1e-3, 1.0) as f32,
                    2 => -(random.between(1e-3, 1.0) as f32),
                    // Denormals: they count, even where the device's arithmetic flushes them.
                    3 => f32::from_bits(random.word() % 0x0080_0000),
                    // Any bits, NaN of either sign and infinities among them.
                    _ => f32::from_bits(random.word()),
                })
                .collect();
            fields.upload(device, 1, &values).unwrap();
            for _ in 0..2 {
                reduction.run(device, &mut Timer::off()).unwrap();
                let found = reduction.read(device).unwrap();
                let bits = (found.smallest.to_bits(), found.largest.to_bits());
                assert_eq!(bits, expected(&values), "{count} values of kind {kind}: {found:?}");
            }
        }
        for place in [0, count / 2, count - 1] {
            let mut values = vec![0.5f32; count];
            values[place] = -7.0;
            fields.upload(device, 1, &values).unwrap();
            reduction.run(device, &mut Timer::off()).unwrap();
            let found = reduction.read(device).unwrap();
            assert_eq!(
                (found.smallest, found.largest),
                (-7.0, if count == 1 { -7.0 } else { 0.5 }),
                "{place} of {count}"
            );
        }
    }
}

#[test]
fn a_result_goes_to_the_parameters_without_the_host() {
    let Some(device) = device() else { return };
    let fields = FieldStore::new(device, 1, 5).unwrap();
    fields.upload(device, 0, &[3.0, -1.0, 2.0, 9.0, 4.0]).unwrap();
    let reduction = Reducer::new(device).unwrap().reduction(device, &fields, 0).unwrap();
    let parameters = Parameters::new(device, 4).unwrap();
    parameters.upload(device, 0, &[1.0, 2.0, 3.0, 4.0]).unwrap();
    reduction.run(device, &mut Timer::off()).unwrap();
    parameters.take(device, 1, &reduction).unwrap();
    assert_eq!(parameters.download(device).unwrap(), [1.0, -1.0, 9.0, 4.0]);
}
