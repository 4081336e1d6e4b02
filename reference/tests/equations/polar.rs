//! Velocities about an axis.

use crate::check::{UNIT, assert_close};
use etalon_kernels_gen::Vector;
use etalon_reference::equations::polar::{azimuthal_velocity, radial_velocity};

#[test]
fn whole_numbers() {
    // x = (3, 4), v = (5, 10): (15 + 40) / 5 outwards, (30 - 20) / 5 round.
    let (v, x) = (Vector([5.0, 10.0]), Vector([3.0, 4.0]));
    assert_eq!((radial_velocity::<f64, 2>(v, x), azimuthal_velocity::<f64>(v, x)), (11.0, 2.0));
    assert_eq!(radial_velocity::<f64, 1>(Vector([-2.0]), Vector([-3.0])), 2.0);
    assert_eq!(radial_velocity::<f64, 3>(Vector([9.0, 0.0, 0.0]), Vector([2.0, -1.0, 2.0])), 6.0);
    // Counter-clockwise is positive.
    assert_eq!(azimuthal_velocity::<f64>(Vector([0.0, 1.0]), Vector([7.0, 0.0])), 1.0);
}

#[test]
fn the_two_components_make_the_velocity() {
    for k in 0..100 {
        let angle = f64::from(k) * 0.37;
        let (v, x) = (Vector([angle.sin(), 0.3 - angle.cos()]), Vector([0.1 + angle.cos(), 2.0 * angle.sin()]));
        let squared = radial_velocity::<f64, 2>(v, x).powi(2) + azimuthal_velocity(v, x).powi(2);
        assert_close("v^2", squared, v.norm_squared(), 20.0 * UNIT * v.norm_squared());
    }
}

/// Row 52: on the axis a velocity has neither direction.
#[test]
fn on_the_axis_there_is_no_direction() {
    let v = Vector([3.0, -4.0]);
    assert_eq!(
        (radial_velocity::<f64, 2>(v, Vector([0.0; 2])), azimuthal_velocity::<f64>(v, Vector([0.0; 2]))),
        (0.0, 0.0)
    );
    let v = Vector([3.0_f32, -4.0]);
    assert_eq!((radial_velocity::<f32, 2>(v, Vector([-0.0; 2])), azimuthal_velocity(v, Vector([-0.0; 2]))), (0.0, 0.0));
}
