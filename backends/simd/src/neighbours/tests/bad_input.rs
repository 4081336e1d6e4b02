//! Input that cannot be searched is refused with a message that says what to do.

use crate::neighbours::{NeighbourError, NeighbourList, Order};
use fearless_simd::Level;

fn list(reach: &[f32], length: [f64; 2]) -> Result<usize, NeighbourError> {
    let x: Vec<u32> = (0..reach.len() as u32).map(|n| n << 20).collect();
    let mut list = NeighbourList::<u32, 2>::default();
    list.build([&x, &x], reach, &length, Level::new())?;
    Ok(list.pairs())
}

fn message(reach: &[f32], length: [f64; 2]) -> String {
    list(reach, length).expect_err("an error").to_string()
}

#[test]
fn support_radii() {
    for bad in [0.0, -0.1, f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 1e-30, 1e30] {
        let message = message(&[0.1, 0.1, bad, bad], [1.0; 2]);
        assert!(message.contains("particle 2 has support radius"), "{bad}: {message}");
    }
    // NaN beside others is not lost in a maximum.
    assert!(message(&[f32::NAN, 0.1], [1.0; 2]).contains("particle 0"));
}

#[test]
fn thin_boxes() {
    assert!(list(&[0.1, 0.5], [1.0, 1.0]).is_ok(), "half of the box still fits");
    let message = message(&[0.1, 0.5, 0.6], [2.0, 0.75]);
    assert!(message.starts_with("box too thin for the support along axis y: particle 1"), "{message}");
}

#[test]
fn box_lengths() {
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-40, 1e300] {
        assert!(message(&[0.1], [1.0, bad]).contains("along axis y"), "{bad}");
        let order = Order::default().compute::<u32, 2>([&[1], &[1]], &[bad, 1.0], Level::new());
        assert!(matches!(order, Err(NeighbourError::BoxLength { axis: 'x', .. })), "{bad}");
    }
}

#[test]
fn array_lengths() {
    let mut list = NeighbourList::<u64, 3>::default();
    let unequal = list.build([&[1, 2], &[1, 2], &[1]], &[0.1, 0.1], &[1.0; 3], Level::new());
    let error = NeighbourError::ArrayLength { array: "z", expected: 2, found: 1 };
    assert_eq!(unequal, Err(error));
    let too_few = list.build([&[1, 2], &[1, 2], &[1, 2]], &[0.1], &[1.0; 3], Level::new());
    assert!(matches!(too_few, Err(NeighbourError::ArrayLength { array: "reach", expected: 2, found: 1 })));
}

#[test]
fn too_many_pairs() {
    // 1000 particles at one place are 999 000 pairs.
    let x = vec![5u32; 1000];
    let reach = vec![0.1f32; 1000];
    let build = |limit: usize| {
        let mut list = NeighbourList::<u32, 1>::with_pair_limit(limit);
        let result = list.build([&x], &reach, &[1.0], Level::new());
        (result, list.pairs(), list.segments().len(), list.particles())
    };
    assert_eq!(build(999_000), (Ok(()), 999_000, 4, 1000));
    let error = NeighbourError::TooManyPairs { limit: 998_999, particles: 1000 };
    assert_eq!(build(998_999), (Err(error), 0, 0, 0));
}

#[test]
fn after_an_error_the_list_is_empty_and_can_be_used_again() {
    let x = [1u32, 2];
    let mut list = NeighbourList::<u32, 1>::default();
    list.build([&x], &[0.1, 0.1], &[1.0], Level::new()).expect("a list");
    assert_eq!(list.pairs(), 2);
    list.build([&x], &[0.1, f32::NAN], &[1.0], Level::new()).expect_err("an error");
    assert_eq!((list.pairs(), list.particles(), list.segments().len()), (0, 0, 0));
    list.build([&x], &[0.1, 0.1], &[1.0], Level::new()).expect("a list");
    assert_eq!(list.neighbours(0), [1]);
}
