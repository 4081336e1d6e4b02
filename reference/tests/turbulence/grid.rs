//! From particles to a grid.

use crate::check::{UNIT, assert_close};
use crate::places::{lattice, particles, scattered};
use etalon_kernels_gen::Vector;
use etalon_reference::schemes::Kernel;
use etalon_reference::turbulence::grid::VelocityGrid;
use etalon_reference::turbulence::spectrum::velocity_spectrum;
use etalon_reference::turbulence::{Snapshot, TurbulenceError};
use std::f64::consts::TAU;

fn velocity_of<const D: usize>(grid: &VelocityGrid<D>, point: usize) -> Vector<f64, D> {
    Vector::from_fn(|axis| grid.component(axis)[point])
}

/// A particle in the middle of each cell gives its cell its velocity, in the order of the grid.
#[test]
fn particles_on_the_grid_are_found_as_they_are() {
    fn check<const D: usize>(across: usize) {
        let cloud =
            particles(1.0, &lattice::<D>(across), |i| std::array::from_fn(|axis| i as f64 + 0.25 * axis as f64));
        let grid = VelocityGrid::nearest(&cloud, across).unwrap();
        for point in 0..across.pow(D as u32) {
            assert_eq!(velocity_of(&grid, point), cloud.velocity(point), "{across}^{D}, point {point}");
        }
    }
    check::<1>(5);
    check::<2>(4);
    check::<3>(3);
}

/// Against looking at every particle, where there are many a cell, few, and a single one.
#[test]
fn nearest_particle_is_nearest() {
    fn check<const D: usize>(across: usize, count: usize) {
        let places = scattered::<D>(count, 5 + count as u64);
        let cloud = particles(1.0, &places, |i| [i as f64; D]);
        let grid = VelocityGrid::nearest(&cloud, across).unwrap();
        for (point, middle) in lattice::<D>(across).into_iter().enumerate() {
            let distance = |i: usize| -> f64 {
                let along = |axis: usize| {
                    let d = cloud.coordinates(i)[axis] as f64 / 2_f64.powi(64) - middle[axis];
                    d - d.round()
                };
                (0..D).map(|axis| along(axis).powi(2)).sum::<f64>().sqrt()
            };
            let nearest = (0..count).map(distance).fold(f64::INFINITY, f64::min);
            let found = distance(grid.component(0)[point] as usize);
            assert_close(&format!("distance at point {point}, {count} in {across}^{D}"), found, nearest, 8.0 * UNIT);
        }
    }
    for count in [1, 2, 30, 300] {
        check::<1>(10, count);
        check::<2>(7, count);
        check::<3>(6, count);
    }
}

/// Weighted means of a uniform velocity are that velocity, however uneven the cloud.
#[test]
fn smoothing_keeps_a_uniform_velocity() {
    let count = 400;
    let cloud = particles(1.0, &scattered::<2>(count, 8), |_| [3.0, -7.0]);
    let h: Vec<f64> = (0..count).map(|i| 0.1 + 0.05 * (i % 3) as f64).collect();
    let volume: Vec<f64> = (0..count).map(|i| 1.0 + (i % 5) as f64).collect();
    let grid = VelocityGrid::smoothed(&cloud, Kernel::MixedSinc, &h, &volume, 12).unwrap();
    for point in 0..144 {
        // Two sums of up to 400 terms.
        assert_close("v_x", grid.component(0)[point], 3.0, 3.0 * 820.0 * UNIT);
        assert_close("v_y", grid.component(1)[point], -7.0, 7.0 * 820.0 * UNIT);
    }
}

/// Two particles and one point between: the weights are V W(h), each with its own smoothing length.
#[test]
fn smoothing_weighs_with_volume_and_the_particles_own_kernel() {
    use etalon_reference::equations::kernels::kernel_shape;
    let cloud = particles(1.0, &[[0.4375], [0.625]], |i| [[1.0], [5.0]][i]);
    let (h, volume) = ([0.25, 0.125], [2.0, 3.0]);
    let grid = VelocityGrid::smoothed(&cloud, Kernel::CubicSpline, &h, &volume, 1).unwrap();
    // The only point is at 0.5: distances 1/16 and 1/8.
    let weight =
        |i: usize, r: f64| volume[i] * kernel_shape::<f64, 1>(Kernel::CubicSpline, (r / h[i]).powi(2)).value / h[i];
    let (a, b) = (weight(0, 0.0625), weight(1, 0.125));
    let due = (a + 5.0 * b) / (a + b);
    assert_close("v", grid.component(0)[0], due, 20.0 * UNIT * due);
    assert!(a > b && b > 0.0);
}

/// Smoothing takes power from short waves and keeps long ones; the nearest particle keeps both on its own lattice.
#[test]
fn smoothing_damps_short_waves() {
    let across = 32;
    let wave = |i: usize| {
        let x = TAU * (i as f64 + 0.5) / across as f64;
        [x.cos() + (10.0 * x).cos()]
    };
    let cloud = particles(1.0, &lattice::<1>(across), wave);
    let energy = |grid: &VelocityGrid<1>, k: usize| velocity_spectrum(grid).unwrap().shells()[k].energy;
    let nearest = VelocityGrid::nearest(&cloud, across).unwrap();
    let (h, volume) = (vec![0.05; across], vec![1.0 / across as f64; across]);
    let smooth = VelocityGrid::smoothed(&cloud, Kernel::MixedSinc, &h, &volume, across).unwrap();
    assert_close("long wave, nearest", energy(&nearest, 1), 0.25, 1e-13);
    assert_close("short wave, nearest", energy(&nearest, 10), 0.25, 1e-13);
    // The kernel's second moment along an axis is 0.247 h^2: exp(-k^2 sigma^2) of the power, 0.976 and 0.087.
    let kept = |k: f64| (-(TAU * k * 0.05).powi(2) * 0.2474).exp();
    assert_close("long wave, smoothed", energy(&smooth, 1) / 0.25, kept(1.0), 0.01);
    assert!(energy(&smooth, 10) < 0.25 * 2.0 * kept(10.0), "{} {}", energy(&smooth, 10) / 0.25, kept(10.0));
}

#[test]
fn points_without_particles_are_refused_by_smoothing() {
    let cloud = particles(1.0, &[[0.25, 0.25]], |_| [1.0; 2]);
    let refused = VelocityGrid::smoothed(&cloud, Kernel::MixedSinc, &[0.1], &[1.0], 8).unwrap_err();
    assert!(matches!(refused, TurbulenceError::OutOfReach { points } if points > 40 && points < 64), "{refused}");
    let one: Snapshot<2> = cloud;
    assert!(VelocityGrid::nearest(&one, 8).unwrap().component(0).iter().all(|v| *v == 1.0), "the only one is nearest");
}
