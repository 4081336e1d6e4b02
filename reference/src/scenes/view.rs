//! Along what a scene is looked at: one coordinate, and the velocity that goes with it.

use crate::equations::polar::{azimuthal_velocity, radial_velocity};
use etalon_kernels_gen::Vector;

/// The coordinate of profiles and norms, and which component of the velocity is compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum View {
    /// Along an axis, the velocity along it.
    Along(usize),
    /// Along one axis, the velocity along another.
    Across {
        /// The axis of the coordinate.
        coordinate: usize,
        /// The axis of the velocity.
        velocity: usize,
    },
    /// The distance from a point, the velocity away from it. The axes a scene does not have are not looked at.
    Radius([f64; 3]),
    /// The distance from a line along z, the velocity away from it.
    CylinderRadius([f64; 2]),
    /// The distance from a line along z, the velocity around it.
    Azimuth([f64; 2]),
}

const AXES: [&str; 3] = ["x", "y", "z"];
const VELOCITIES: [&str; 3] = ["velocity_x", "velocity_y", "velocity_z"];

impl View {
    /// The coordinate's name: `x`, `y`, `z` or `r`.
    pub fn coordinate(self) -> &'static str {
        match self {
            View::Along(axis) | View::Across { coordinate: axis, .. } => AXES[axis],
            View::Radius(_) | View::CylinderRadius(_) | View::Azimuth(_) => "r",
        }
    }

    /// The velocity's name: `velocity_x` and so on, `velocity_r`, `velocity_phi`.
    pub fn velocity(self) -> &'static str {
        match self {
            View::Along(axis) | View::Across { velocity: axis, .. } => VELOCITIES[axis],
            View::Radius(_) | View::CylinderRadius(_) => "velocity_r",
            View::Azimuth(_) => "velocity_phi",
        }
    }

    /// Its symbol.
    pub fn velocity_symbol(self) -> &'static str {
        match self {
            View::Along(axis) | View::Across { velocity: axis, .. } => ["vₓ", "v_y", "v_z"][axis],
            View::Radius(_) | View::CylinderRadius(_) => "v_r",
            View::Azimuth(_) => "v_φ",
        }
    }

    /// Coordinate and velocity of a particle.
    pub fn of(self, position: [f64; 3], velocity: [f64; 3], dimension: usize) -> (f64, f64) {
        let from = |centre: [f64; 3], axes: usize| {
            Vector::<f64, 3>::from_fn(|i| if i < axes { position[i] - centre[i] } else { 0.0 })
        };
        let plane = |centre: [f64; 2]| {
            let axes = dimension.min(2);
            (from([centre[0], centre[1], 0.0], axes), axes)
        };
        match self {
            View::Along(axis) => (position[axis], velocity[axis]),
            View::Across { coordinate, velocity: axis } => (position[coordinate], velocity[axis]),
            View::Radius(centre) => {
                let x = from(centre, dimension);
                (x.norm(), radial_velocity(Vector(velocity), x))
            }
            View::CylinderRadius(centre) => {
                let (x, _) = plane(centre);
                (x.norm(), radial_velocity(Vector(velocity), x))
            }
            View::Azimuth(centre) => {
                let (x, _) = plane(centre);
                (x.norm(), azimuthal_velocity(Vector([velocity[0], velocity[1]]), Vector([x[0], x[1]])))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_view_sees_its_own_component() {
        let (x, v) = ([3.0, 4.0, 12.0], [1.0, 2.0, -1.0]);
        assert_eq!(View::Along(1).of(x, v, 3), (4.0, 2.0));
        assert_eq!(View::Across { coordinate: 1, velocity: 0 }.of(x, v, 3), (4.0, 1.0));
        assert_eq!(View::Radius([0.0; 3]).of(x, v, 3), (13.0, (3.0 + 8.0 - 12.0) / 13.0));
        assert_eq!(View::Radius([0.0; 3]).of(x, v, 2), (5.0, 11.0 / 5.0));
        assert_eq!(View::Radius([5.0, 0.0, 0.0]).of(x, v, 1), (2.0, -1.0));
        assert_eq!(View::CylinderRadius([0.0; 2]).of(x, v, 3), (5.0, 11.0 / 5.0));
        assert_eq!(View::Azimuth([0.0; 2]).of(x, v, 3), (5.0, (3.0 * 2.0 - 4.0 * 1.0) / 5.0));
    }
}
