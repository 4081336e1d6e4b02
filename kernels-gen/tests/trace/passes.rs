//! Drawings of passes and updates compute what the passes compute, under the agreed names.

use crate::toys::{Density, Drift, Momentum};
use etalon_kernels_gen::trace::{Drawing, Single, interpret};
use etalon_kernels_gen::{Pass, Quantity, Reduction, Separation, Update, Vector};

/// Numbers that differ from one another and have inexact products.
fn values(count: usize, seed: f32) -> Vec<f32> {
    (0..count).map(|i| ((i as f32 + seed) * 0.7310586).sin() * 3.0 + 0.1).collect()
}
fn take<Q: Quantity<f32>>(values: &[f32]) -> Q {
    let mut values = values.iter();
    Q::take(&mut || *values.next().expect("as many values as components"))
}
fn give<Q: Quantity<f32>>(record: Q) -> Vec<f32> {
    let mut values = Vec::new();
    record.give(&mut |value| values.push(value));
    values
}

fn same_as_direct<const D: usize, P: Pass<D>>(pass: &P) {
    let drawing = Drawing::of_pass::<D, P, Single>(pass).unwrap();
    let (own, other) = (values(drawing.own.len(), 1.0), values(drawing.other.len(), 2.0));
    let sums = values(drawing.sums.len(), 3.0);
    let x_ab: Vector<f32, D> = Vector::from_fn(|i| 0.3 - 0.2 * i as f32);
    let separation = Separation { x_ab, r_squared: x_ab.norm_squared() };

    let direct = give(pass.pair::<f32>(&take(&own), &take(&other), &separation));
    let inputs = [own.clone(), other, x_ab.0.to_vec(), vec![separation.r_squared]].concat();
    assert_eq!(interpret(&drawing.pair, &inputs).unwrap(), direct, "{} pair in {D}-D", P::NAME);
    assert_eq!(interpret(&drawing.simplified().pair, &inputs).unwrap(), direct, "{} pair in {D}-D", P::NAME);

    let direct = give(pass.finish::<f32>(&take(&own), &take(&sums)));
    let inputs = [own, sums].concat();
    assert_eq!(interpret(&drawing.finish, &inputs).unwrap(), direct, "{} finish in {D}-D", P::NAME);
}

#[test]
fn passes_compute_what_they_compute_directly() {
    same_as_direct::<1, _>(&Density);
    same_as_direct::<2, _>(&Density);
    same_as_direct::<3, _>(&Density);
    same_as_direct::<1, _>(&Momentum { heats: true });
    same_as_direct::<2, _>(&Momentum { heats: true });
    same_as_direct::<3, _>(&Momentum { heats: true });
}

#[test]
fn updates_compute_what_they_compute_directly() {
    let drawing = Drawing::of_update::<3, _, Single>(&Drift).unwrap();
    let own = values(6, 1.0);
    let direct = give(<Drift as Update<3>>::apply::<f32>(&Drift, &take(&own), 0.01));
    let inputs = [own, vec![0.01]].concat();
    assert_eq!(interpret(&drawing.simplified().apply, &inputs).unwrap(), direct);
    assert_eq!(drawing.apply.inputs().last().unwrap(), "time_step");
    // Three multiply-adds and nothing else.
    assert_eq!((drawing.count().flops(), drawing.count().multiply_add), (6, 3));
}

#[test]
fn inputs_and_outputs_have_the_agreed_names() {
    let drawing = Drawing::of_pass::<2, _, Single>(&Momentum { heats: true }).unwrap();
    let inputs = [
        "a_density",
        "a_velocity_x",
        "a_velocity_y",
        "a_inverse_matrix_xx",
        "a_inverse_matrix_xy",
        "a_inverse_matrix_yy",
        "a_velocity_gradient_xx",
        "a_velocity_gradient_xy",
        "a_velocity_gradient_yx",
        "a_velocity_gradient_yy",
        "b_mass",
        "b_density",
        "b_velocity_x",
        "b_velocity_y",
        "b_velocity_gradient_xx",
        "b_velocity_gradient_xy",
        "b_velocity_gradient_yx",
        "b_velocity_gradient_yy",
        "x_ab_x",
        "x_ab_y",
        "r_squared",
    ];
    assert_eq!(drawing.pair.inputs(), inputs);
    let outputs = |drawing: &Drawing| drawing.outputs().iter().map(|o| o.name.clone()).collect::<Vec<_>>();
    assert_eq!(outputs(&drawing.pair), ["acceleration_x", "acceleration_y", "heating", "signal_speed"]);
    assert_eq!(outputs(&drawing.finish), drawing.out);
    assert_eq!(drawing.sums[3].reduction, Reduction::Max);
    assert_eq!(
        drawing.finish.inputs()[10..],
        ["sum_acceleration_x", "sum_acceleration_y", "sum_heating", "sum_signal_speed"]
    );
}

/// A choice of the scene leaves no trace in the drawing: not in the sums, not in the epilogue, not in the count.
#[test]
fn a_sum_that_vanishes_is_found() {
    let pass = |heats| Drawing::of_pass::<3, _, Single>(&Momentum { heats }).unwrap().simplified();
    let (with, without) = (pass(true), pass(false));
    assert!(with.zero_sums().is_empty());
    assert_eq!(without.zero_sums(), ["heating"]);
    assert_eq!(with.finish.zero_outputs(), Vec::<&str>::new());
    assert_eq!(without.finish.zero_outputs(), ["heating"]);
    assert_eq!(without.count_pair().flops(), with.count_pair().flops() - 1, "one multiplication less");
    let unused =
        ["a_velocity_gradient_xz", "b_velocity_gradient_yy"].map(|name| with.pair.unused_inputs().contains(&name));
    assert_eq!(unused, [false, false], "these are read");
    assert!(
        with.pair.unused_inputs().contains(&"r_squared")
            && with.pair.unused_inputs().contains(&"a_velocity_gradient_yz")
    );
}
