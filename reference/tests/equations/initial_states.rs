//! GS25 (22)-(26) and the wind and its cloud: what the test problems start from.

use crate::check::{UNIT, assert_close};
use crate::dual::Dual;
use etalon_kernels_gen::{Real, Vector};
use etalon_reference::equations::initial_state::gresho_chan::{
    CENTRAL_PRESSURE, DENSITY, RADIUS, VELOCITY, gresho_chan, vortex_pressure, vortex_velocity,
};
use etalon_reference::equations::initial_state::kelvin_helmholtz::{
    Contact, kelvin_helmholtz, layered_profile, shear_seed,
};
use etalon_reference::equations::initial_state::rayleigh_taylor::{
    Balance, layered_pressure, plume_seed, rayleigh_taylor,
};
use etalon_reference::equations::initial_state::wind_cloud::{Wind, wind_cloud, wind_speed};
use std::f64::consts::{LN_2, TAU};

#[test]
fn vortex_of_whole_numbers() {
    for (psi, due) in [(0.0, 0.0), (0.5, 1.5), (1.0, 3.0), (1.5, 1.5), (2.0, 0.0), (5.0, 0.0)] {
        assert_eq!(vortex_velocity(psi, 3.0), due, "psi = {psi}");
    }
    // 7 + 4 * 5 * 9 * psi^2 / 8
    assert_eq!(vortex_pressure(0.0, 7.0, 5.0, 3.0), 7.0);
    assert_eq!(vortex_pressure(0.5, 7.0, 5.0, 3.0), 12.625);
    // The published figures for unit density: 5 on the axis, 5.5 at r = 0.2, 5.772588722 from 0.4 on.
    let pressure = |r: f64| vortex_pressure(r / RADIUS, CENTRAL_PRESSURE, DENSITY, VELOCITY);
    assert_eq!((pressure(0.0), pressure(0.2)), (5.0, 5.5));
    for r in [0.4, 0.41, 0.5, 10.0] {
        assert_close("P outside", pressure(r), 5.772588722, 3e-10);
        assert_close("P outside", pressure(r), 5.0 + 4.0 * (LN_2 - 0.5), 10.0 * UNIT * 5.0);
    }
    // Continuous where the zones meet.
    for r in [0.2, 0.4] {
        assert_close("P across", pressure(r * (1.0 + 1e-12)), pressure(r * (1.0 - 1e-12)), 1e-11);
    }
}

/// The pressure's derivative holds the flow on its circle: `dP/dr = rho v^2 / r`, exactly, for any density and velocity.
#[test]
fn pressure_balances_the_centrifugal_force() {
    let (rho, v_0) = (3.0, 0.7);
    for k in 1..300 {
        let psi = f64::from(k) * 0.01;
        if [100, 200].contains(&k) {
            continue;
        }
        let [p_0, density, largest] = [5.0, rho, v_0].map(Dual::lit);
        let slope = vortex_pressure(Dual::variable(psi), p_0, density, largest).slope;
        let v = vortex_velocity(psi, v_0);
        let due = rho * v * v / psi;
        // Outside, terms of order one cancel: the logarithm's derivative 1/psi, psi/4 and one, times 4 rho v^2; a polynomial's slope is good to
        // some 20 roundings.
        assert_close(&format!("dP/dpsi at {psi}"), slope, due, 4.0 * rho * v_0 * v_0 * 40.0 * UNIT);
    }
}

#[test]
fn vortex_turns_counterclockwise_and_is_still_on_its_axis() {
    let at = |x: f64, y: f64| gresho_chan::<f64, 3>(Vector([x, y, 0.3]));
    assert_eq!(at(0.0, 0.0).velocity.0, [0.0; 3]);
    let state = at(0.06, 0.08);
    // psi = 1/2, along (-0.8, 0.6).
    for (got, due) in state.velocity.0.into_iter().zip([-0.4, 0.3, 0.0]) {
        assert_close("v", got, due, 4.0 * UNIT);
    }
    assert_close("P", state.pressure, 5.125, 20.0 * UNIT);
    assert_eq!(state.density, 1.0);
    assert_eq!(gresho_chan::<f64, 2>(Vector([0.0, -0.2])).velocity.0, [1.0, 0.0]);
    // psi = 3/2, along (-0.6, 0.8); and beyond psi = 2 nothing.
    for (got, due) in at(0.24, 0.18).velocity.0.into_iter().zip([-0.3, 0.4, 0.0]) {
        assert_close("v", got, due, 6.0 * UNIT);
    }
    assert_eq!(at(0.3, 0.3).velocity.0, [0.0; 3]);
}

/// The four exponentials of McNally et al., zone by zone.
#[test]
fn layers_are_those_of_mcnally() {
    let (outer, inner, width) = (0.5, -0.5, 0.025);
    let middle = 0.5 * (outer - inner);
    for k in 0..1000 {
        let y = (f64::from(k) + 0.5) * 1e-3;
        let due = if y < 0.25 {
            outer - middle * ((y - 0.25) / width).exp()
        } else if y < 0.5 {
            inner + middle * ((0.25 - y) / width).exp()
        } else if y < 0.75 {
            inner + middle * ((y - 0.75) / width).exp()
        } else {
            outer - middle * ((0.75 - y) / width).exp()
        };
        // The exponent, up to 10, has 4u; the exponential 16u.
        assert_close(&format!("v_x at {y}"), layered_profile(y, outer, inner, width), due, 30.0 * UNIT);
    }
    // Half-way at both interfaces, whichever the values.
    for y in [0.25, 0.75] {
        assert_close("at the interface", layered_profile(y, 1.0, 2.0, width), 1.5, 2.0 * UNIT);
    }
}

#[test]
fn shear_seed_is_a_sine() {
    // A twelfth of a wavelength.
    assert_close("v_y", shear_seed(0.5 / 12.0, 0.01, 0.5), 0.005, 4.0 * UNIT * 0.005);
    assert_eq!(shear_seed(0.125, 0.01, 0.5), 0.01);
    assert_eq!(shear_seed(0.375, 0.01, 0.5), -0.01);
    for k in 0..100 {
        let x = f64::from(k) * 0.01;
        // The sine's argument, up to 4 pi, is rounded twice.
        let bound = (8.0 + 2.0 * 2.0 * TAU) * UNIT * 0.01;
        assert_close(&format!("v_y at {x}"), shear_seed(x, 0.01, 0.5), 0.01 * (TAU * x / 0.5).sin(), bound);
    }
}

/// The densities differ, the velocities do not, between the two readings.
#[test]
fn contact_is_sharp_or_smooth() {
    let at = |y: f64, contact| kelvin_helmholtz::<f64, 3>(Vector([0.125, y, 0.0]), contact);
    for y in [0.0, 0.1, 0.24, 0.26, 0.5, 0.74, 0.76, 0.99] {
        let (sharp, smooth) = (at(y, Contact::Sharp), at(y, Contact::Smooth));
        assert_eq!(sharp.density, if (0.25..0.75).contains(&y) { 2.0 } else { 1.0 }, "y = {y}");
        assert_eq!((sharp.velocity, sharp.pressure), (smooth.velocity, smooth.pressure));
        assert_eq!((sharp.velocity.0[1], sharp.velocity.0[2], sharp.pressure), (0.01, 0.0, 2.5));
        let decay = (-((y - 0.5).abs() - 0.25).abs() / 0.025).exp();
        assert_close("smooth density", (smooth.density - sharp.density).abs(), 0.5 * decay, 40.0 * UNIT);
        assert!((1.0..=2.0).contains(&smooth.density));
    }
    assert!((at(0.26, Contact::Smooth).density - 2.0).abs() > 0.3, "the readings differ near the interface");
    // The interfaces belong to the middle layer, and stand where they should.
    for (y, due) in [(0.249, 1.0), (0.25, 2.0), (0.251, 2.0), (0.749, 2.0), (0.75, 2.0), (0.751, 1.0)] {
        assert_eq!(at(y, Contact::Sharp).density, due, "y = {y}");
    }
}

/// The flow along the layers, zone by zone: 1/2 outside, -1/2 inside, with the width of 0.025.
#[test]
fn layers_slide_past_each_other() {
    for (y, side, distance) in
        [(0.0, 1.0, 0.25), (0.24, 1.0, 0.01), (0.27, -1.0, 0.02), (0.5, -1.0, 0.25), (0.78, 1.0, 0.03)]
    {
        let got = kelvin_helmholtz::<f64, 2>(Vector([0.125, y]), Contact::Sharp).velocity.0;
        let due = side * (0.5 - 0.5 * (-distance / 0.025_f64).exp());
        // As in `layers_are_those_of_mcnally`.
        assert_close(&format!("v_x at {y}"), got[0], due, 30.0 * UNIT);
        assert_eq!(got[1], 0.01);
    }
}

/// (25) zone by zone as it is printed, its middle line with both offsets.
#[test]
fn layered_pressure_is_as_printed() {
    let (p_0, lower, upper, g, y_b, delta) = (2.5, 1.0, 2.0, -0.5, 1.0, 0.4);
    let mean = 0.5 * (lower + upper);
    let (floor, ceiling) = (y_b - 0.5 * delta, y_b + 0.5 * delta);
    let at_floor = p_0 + lower * g * floor;
    let at_ceiling = at_floor - mean * g * floor + mean * g * ceiling;
    for k in 0..=200 {
        let y = f64::from(k) * 0.01;
        let due = if y <= floor {
            p_0 + lower * g * y
        } else if y < ceiling {
            at_floor - mean * g * floor + mean * g * y
        } else {
            at_ceiling + upper * g * (y - ceiling)
        };
        assert_close(&format!("P at {y}"), layered_pressure(y, p_0, [lower, upper], g, y_b, delta), due, 40.0 * UNIT);
    }
    // 3 + 2 [5 (1/2)], 3 + 2 [5 * 1 + 6 (1/2)], 3 + 2 [5 * 1 + 6 * 2 + 7 * 1]
    let whole = |y: f64| layered_pressure(y, 3.0, [5.0, 7.0], 2.0, 2.0, 2.0);
    assert_eq!([0.5, 1.5, 4.0].map(whole), [8.0, 19.0, 51.0]);
}

/// `dP/dy = rho g` everywhere in the corrected reading. As printed it fails within the layer, and nowhere else.
#[test]
fn only_one_reading_is_hydrostatic() {
    let excess = |y: f64, balance: Balance| {
        let density = rayleigh_taylor::<f64, 2>(Vector([0.0, y]), balance).density;
        let [p_0, lower, upper, g, y_b, layer] = [2.5, 1.0, 2.0, -0.5, 1.0, balance.layer()].map(Dual::lit);
        let slope = layered_pressure(Dual::variable(y), p_0, [lower, upper], g, y_b, layer).slope;
        // The acceleration that is left.
        -slope / density - 0.5
    };
    for k in 0..200 {
        let y = (f64::from(k) + 0.5) * 0.01;
        assert_close(&format!("hydrostatic, y = {y}"), excess(y, Balance::Hydrostatic), 0.0, 4.0 * UNIT);
        let due = match y {
            y if (y - 1.0).abs() > 0.2 => 0.0,
            y if y < 1.0 => 0.25,
            _ => -0.125,
        };
        assert_close(&format!("as printed, y = {y}"), excess(y, Balance::Printed), due, 4.0 * UNIT);
    }
    let pressure = |y: f64, balance| rayleigh_taylor::<f64, 3>(Vector([0.5, y, 0.0]), balance).pressure;
    assert_eq!(pressure(1.0, Balance::Hydrostatic), 2.0);
    assert_close("as printed", pressure(1.0, Balance::Printed), 1.95, 8.0 * UNIT);
    // Above the layer the two agree: the mean density is right on the whole.
    assert_close("at the top", pressure(2.0, Balance::Printed), pressure(2.0, Balance::Hydrostatic), 8.0 * UNIT);
}

#[test]
fn plume_seed_is_as_printed_and_never_negative() {
    let (dv, y_b, delta) = (0.025, 1.0, 0.4);
    assert_close("at the crest", plume_seed(0.5, 1.0, dv, y_b, delta), 0.1, 0.1 * 10.0 * UNIT);
    let (mut sum, mut energy, n) = (0.0, 0.0, 200);
    for i in 0..n {
        for j in 0..2 * n {
            let (x, y) = ((f64::from(i) + 0.5) / f64::from(n), (f64::from(j) + 0.5) / f64::from(n));
            let got = plume_seed(x, y, dv, y_b, delta);
            let due = match (y - y_b).abs() <= 0.5 * delta {
                true => dv * (1.0 - (TAU * x).cos()) * (1.0 + (TAU * (y - y_b) / delta).cos()),
                false => 0.0,
            };
            // Each printed bracket, up to 2, loses what its cosine rounds; its argument, up to 2 pi, is rounded three times.
            assert_close(&format!("v_y at {x}, {y}"), got, due, dv * 4.0 * (4.0 + 3.0 * TAU) * UNIT);
            assert!(got >= 0.0);
            let density = if y < 1.0 { 1.0 } else { 2.0 };
            sum += density * got / f64::from(n * n);
            energy += 0.5 * density * got * got / f64::from(n * n) * 0.1;
        }
    }
    // Momentum per area and energy of the box of depth 0.1: integrals of products of cosines, exact by the midpoint rule.
    assert_close("momentum", sum, 1.5 * dv * delta, 1e-12);
    assert_close("energy", energy, 0.5 * 1.5 * (1.5 * dv).powi(2) * delta * 0.1, 1e-12);
}

/// The state at a place has the seed of (26) across the layers and no other velocity; the interface belongs to the upper layer.
#[test]
fn plume_rises_across_the_layers() {
    for (x, y) in [(0.25, 0.9), (0.7, 1.05), (0.4, 1.15)] {
        let due = 0.025 * (1.0 - (TAU * x).cos()) * (1.0 + (TAU * (y - 1.0) / 0.4).cos());
        // As in `plume_seed_is_as_printed_and_never_negative`.
        let bound = 0.025 * 4.0 * (4.0 + 3.0 * TAU) * UNIT;
        assert!(due > 100.0 * bound, "a place that would not tell");
        for balance in [Balance::Hydrostatic, Balance::Printed] {
            let velocity = rayleigh_taylor::<f64, 3>(Vector([x, y, 0.3]), balance).velocity.0;
            assert_eq!((velocity[0], velocity[2]), (0.0, 0.0));
            assert_close(&format!("v_y at {x}, {y}"), velocity[1], due, bound);
        }
    }
    for (y, due) in [(0.999, 1.0), (1.0, 2.0), (1.001, 2.0)] {
        assert_eq!(rayleigh_taylor::<f64, 2>(Vector([0.5, y]), Balance::Hydrostatic).density, due, "y = {y}");
    }
}

#[test]
fn wind_is_as_fast_as_its_reading_says() {
    assert_eq!(wind_speed(3.0, 1.25, 20.0, 4.0), 7.5);
    let gamma = 5.0 / 3.0;
    let at = |x: [f64; 3], wind| wind_cloud::<f64, 3>(Vector(x), gamma, wind);
    let wind = at([1.0, 1.0, 1.0], Wind::Mach);
    assert_close("the wind", wind.velocity.0[0], 3.4857, 0.5e-4);
    assert_eq!((wind.density, wind.pressure, wind.velocity.0[1], wind.velocity.0[2]), (1.0, 1.0, 0.0, 0.0));
    assert_eq!(at([1.0; 3], Wind::Speed).velocity.0[0], 2.7);
    assert_close("Mach", 2.7 / wind_speed(1.0, gamma, 1.0, 1.0), 2.09, 0.005);
    for reading in [Wind::Mach, Wind::Speed] {
        let cloud = at([5.5, 4.5, 5.5], reading);
        assert_eq!((cloud.density, cloud.pressure, cloud.velocity.0), (10.0, 1.0, [0.0; 3]));
        assert_eq!(at([6.0, 5.0, 5.0], reading).density, 10.0, "the surface belongs to the cloud");
        assert_eq!(at([5.0, 5.0, 6.0001], reading).density, 1.0);
    }
    // t_KH = 1.6 * 2 R sqrt(10) / v, which the paper gives as 2.9, fixes radius and speed.
    assert_close("t_KH", 1.6 * 2.0 * 10_f64.sqrt() / wind.velocity.0[0], 2.9, 0.05);
    // In two dimensions the cloud is a disc.
    assert_eq!(wind_cloud::<f64, 2>(Vector([5.0, 5.9]), gamma, Wind::Mach).density, 10.0);
}
