//! The motion of the particles: exact against the same arithmetic, so no tolerance.

use etalon_wgpu::{Coordinates, Drift, Error, FieldStore, Timer, Torus};

use crate::common::{Random, device};

#[test]
fn coordinates_move_by_the_rounded_displacement() {
    let Some(device) = device() else { return };
    let mut random = Random(30);
    for lengths in [&[1.0][..], &[0.3, 7.0], &[1e-6, 2.0, 1e6]] {
        let (dimension, count) = (lengths.len(), 1000);
        let torus = Torus::new(lengths).unwrap();
        let coordinates = Coordinates::new(device, torus, count).unwrap();
        let fields = FieldStore::new(device, dimension + 2, count).unwrap();
        let drift = Drift::new(device, &coordinates, &fields, 2).unwrap();
        let mut expected = Vec::new();
        for (axis, length) in lengths.iter().enumerate() {
            let start: Vec<u32> = (0..count).map(|_| random.word()).collect();
            let unit = f64::from(torus.length_per_unit()[axis]);
            let displacement: Vec<f32> = (0..count)
                .map(|k| match k % 4 {
                    // Up to half the torus; a few units, rounding to each side; exact halves of a unit; a step's worth.
                    0 => random.between(-0.4999, 0.4999) * length,
                    1 => random.between(-3.0, 3.0) * unit,
                    2 => ((k % 9) as f64 - 4.5) * unit,
                    _ => random.between(-1e-3, 1e-3) * length,
                } as f32)
                .collect();
            let scale = torus.units_per_length()[axis];
            expected.push(
                start
                    .iter()
                    .zip(&displacement)
                    .map(|(place, d)| place.wrapping_add_signed((d * scale).round_ties_even() as i32))
                    .collect::<Vec<u32>>(),
            );
            coordinates.upload(device, axis, &start).unwrap();
            fields.upload(device, 2 + axis, &displacement).unwrap();
        }
        drift.run(device, &mut Timer::off()).unwrap();
        drift.check(device).unwrap();
        for axis in 0..dimension {
            let found = coordinates.download(device, axis).unwrap();
            for (particle, (found, expected)) in found.iter().zip(&expected[axis]).enumerate() {
                assert_eq!(found, expected, "axis {axis} of particle {particle} on the torus {lengths:?}");
            }
        }
    }
}

#[test]
fn impossible_displacements_are_reported_and_left_out() {
    let Some(device) = device() else { return };
    let torus = Torus::new(&[2.0, 4.0]).unwrap();
    let coordinates = Coordinates::new(device, torus, 200).unwrap();
    let fields = FieldStore::new(device, 2, 200).unwrap();
    let drift = Drift::new(device, &coordinates, &fields, 0).unwrap();
    for bad in [f32::NAN, -f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 2.0, -2.0, 1e30] {
        let mut y = vec![0.0; 200];
        y[150] = bad;
        y[151] = bad;
        let before = coordinates.download(device, 1).unwrap();
        fields.upload(device, 1, &y).unwrap();
        drift.run(device, &mut Timer::off()).unwrap();
        match drift.check(device) {
            Err(Error::DisplacementTooLarge { particle, displacement, half_length }) => {
                assert_eq!(particle, 150, "{bad}");
                assert_eq!(displacement[1].to_bits(), bad.to_bits());
                assert_eq!(half_length, [1.0, 2.0]);
            }
            other => panic!("{bad}: {other:?}"),
        }
        assert_eq!(coordinates.download(device, 1).unwrap(), before, "{bad} moved something");
        // Reported once; the largest possible displacement is none of them.
        drift.check(device).unwrap();
        y[150] = 2f32.next_down();
        y[151] = -2f32.next_down();
        fields.upload(device, 1, &y).unwrap();
        drift.run(device, &mut Timer::off()).unwrap();
        drift.check(device).unwrap();
    }
}
