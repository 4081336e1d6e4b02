//! Legal but hard values for every equation: zero where zero is allowed, and contrasts of many powers of ten. Nothing
//! may turn into NaN or infinity.

use crate::float::Float;
use etalon_kernels_gen::Vector;
use etalon_reference::diagnostics::entropy::entropy_change;
use etalon_reference::equations::conduction::*;
use etalon_reference::equations::dissipation::*;
use etalon_reference::equations::equation_of_state::*;
use etalon_reference::equations::grad_h::*;
use etalon_reference::equations::hydrodynamics::*;
use etalon_reference::equations::initial_state::gresho_chan::*;
use etalon_reference::equations::initial_state::kelvin_helmholtz::*;
use etalon_reference::equations::initial_state::rayleigh_taylor::*;
use etalon_reference::equations::initial_state::wind_cloud::*;
use etalon_reference::equations::initial_state::*;
use etalon_reference::equations::polar::*;
use etalon_reference::equations::reconstruction::*;
use etalon_reference::equations::smoothing_length::*;
use etalon_reference::equations::switch::*;
use etalon_reference::equations::time_step::*;
use etalon_reference::equations::turbulence::*;
use etalon_reference::equations::volume_elements::*;
use etalon_reference::schemes::{Dissipation, MachReading, Profile, Viscosity};

/// What values an argument may have.
#[derive(Clone, Copy)]
pub enum Domain {
    /// Masses, densities, volumes, smoothing lengths.
    Positive,
    /// Energies, sound speeds, distances.
    NotNegative,
    /// Velocities and rates.
    Any,
}
use Domain::{Any, NotNegative, Positive};

/// Calls `f` with every combination of hard values of its arguments.
pub fn try_all<T: Float, const N: usize>(name: &str, domains: [Domain; N], extreme: f64, f: impl Fn([T; N]) -> T) {
    let positive = [1.0 / extreme, 1e-3, 1.0, extreme];
    let values = |domain: Domain| -> Vec<f64> {
        let mut values = positive.to_vec();
        match domain {
            Positive => {}
            NotNegative => values.push(0.0),
            Any => values.extend([0.0, -0.0, -1.0 / extreme, -1.0, -extreme]),
        }
        values
    };
    let choices = domains.map(values);
    let total: usize = choices.iter().map(Vec::len).product();
    for mut index in 0..total {
        let arguments: [f64; N] = std::array::from_fn(|i| {
            let choice = &choices[i];
            let value = choice[index % choice.len()];
            index /= choice.len();
            value
        });
        let result = f(arguments.map(T::lit)).to_f64();
        assert!(result.is_finite(), "{name}{arguments:?} = {result}");
    }
}

/// `extreme` is as far as the deepest product or quotient stays within the number's range.
fn all_equations<T: Float>(extreme: f64) {
    let line = |x: T| Vector([x]);
    try_all("volume_estimator", [Positive; 2], extreme, |[a, b]: [T; 2]| volume_estimator(a, b));
    try_all("volume_element", [Positive; 2], extreme, |[a, b]: [T; 2]| volume_element(a, b));
    try_all("density", [Positive; 2], extreme, |[a, b]: [T; 2]| density(a, b));
    try_all("pressure", [Positive, Positive, NotNegative], extreme, |[a, b, c]: [T; 3]| pressure(a, b, c));
    try_all("sound_speed", [Positive, Any], extreme, |[a, b]: [T; 2]| sound_speed(a, b));
    try_all("grad_h_factor", [Positive, Positive, Any], extreme, |[a, b, c]: [T; 3]| grad_h_factor::<T, 3>(a, b, c));
    try_all("pressure_coefficient", [NotNegative, Any, Positive, Positive], extreme, |[a, b, c, d]: [T; 4]| {
        pressure_coefficient(a, b, c, d)
    });
    try_all("crossed_weight", [NotNegative, NotNegative, Positive, Positive], extreme, |[a, b, c, d]: [T; 4]| {
        crossed_weight(a, b, c, d)
    });
    try_all("approach_velocity", [Any, Any, NotNegative], extreme, |[a, b, c]: [T; 3]| {
        approach_velocity(line(a), line(b), c)
    });
    try_all("signal_velocity", [NotNegative, NotNegative, Any], extreme, |[a, b, c]: [T; 3]| signal_velocity(a, b, c));
    try_all("riemann_viscosity", [Positive, NotNegative, Any, Positive], extreme, |[a, b, c, d]: [T; 4]| {
        riemann_viscosity(a, b, c, d)
    });
    try_all("pair_viscosity", [Positive, Positive, NotNegative, Any, Positive], extreme, |[a, b, c, d, e]: [T; 5]| {
        pair_viscosity(a, b, c, d, e)
    });
    try_all("balsara_limiter", [Any, NotNegative, NotNegative, Positive], extreme, |[a, b, c, d]: [T; 4]| {
        balsara_limiter(a, b, c, d)
    });
    try_all("slope_limiter", [Any, Any], extreme, |[a, b]: [T; 2]| slope_limiter(a, b));
    try_all("short_range_factor", [NotNegative, Positive], extreme, |[a, b]: [T; 2]| {
        short_range_factor(a, b, T::lit(5.0))
    });
    try_all("pair_separation", [NotNegative, Positive, Positive], extreme, |[a, b, c]: [T; 3]| {
        pair_separation(a, b, c)
    });
    try_all("critical_separation", [Positive, Positive], extreme, |[a, b]: [T; 2]| critical_separation::<T, 3>(a, b));
    try_all(
        "reconstructed_approach_velocity",
        [Any, NotNegative, Any, NotNegative, Any, NotNegative],
        extreme,
        |v: [T; 6]| reconstructed_approach_velocity(v[0], v[1], v[2], v[3], v[4], v[5]),
    );
    try_all("effective_neighbours", [Positive; 3], extreme, |[a, b, c]: [T; 3]| effective_neighbours::<T, 3>(a, b, c));
    try_all("settled_smoothing_length", [Positive, Positive, Positive, Any], extreme, |[a, b, c, d]: [T; 4]| {
        settled_smoothing_length::<T, 3>(a, b, c, d)
    });
    try_all("courant_step", [Positive, NotNegative], extreme, |[a, b]: [T; 2]| courant_step(a, b));
    try_all("acceleration_step", [Positive, NotNegative], extreme, |[a, b]: [T; 2]| acceleration_step(a, b));
    try_all("cooling_step", [Any, Any], extreme, |[a, b]: [T; 2]| cooling_step(a, b));
    try_all("smoothed_pressure", [Any, Any, Positive], extreme, |[a, b, c]: [T; 3]| {
        smoothed_pressure(a, b, c, T::lit(0.45), T::lit(0.55))
    });
    driving_and_polar::<T>(extreme);
    switches_and_conduction::<T>(extreme);
    initial_states::<T>(extreme);
}

/// Those of turbulence and of round tests.
fn driving_and_polar<T: Float>(extreme: f64) {
    let plane = |x: T, y: T| Vector([x, y]);
    try_all("radial_velocity", [Any; 4], extreme, |v: [T; 4]| radial_velocity(plane(v[0], v[1]), plane(v[2], v[3])));
    try_all("azimuthal_velocity", [Any; 4], extreme, |v: [T; 4]| {
        azimuthal_velocity(plane(v[0], v[1]), plane(v[2], v[3]))
    });
    try_all("squared_velocity_difference", [Any; 2], extreme, |[a, b]: [T; 2]| {
        squared_velocity_difference(plane(a, b))
    });
    try_all("squared_mach_number", [Any, Any, NotNegative], extreme, |[a, b, c]: [T; 3]| {
        squared_mach_number(plane(a, b), c)
    });
    for &reading in MachReading::ALL {
        try_all("scale_mach_number", [NotNegative; 2], extreme, |[a, b]: [T; 2]| scale_mach_number(a, b, reading));
    }
    for &profile in Profile::ALL {
        try_all("driving_amplitude", [NotNegative, Positive], extreme, |[a, b]: [T; 2]| {
            driving_amplitude::<T, 3>(a, b, profile)
        });
    }
    try_all("ornstein_uhlenbeck_step", [Any, NotNegative, NotNegative, Any], extreme, |[a, b, c, d]: [T; 4]| {
        ornstein_uhlenbeck_step(a, b, c, d)
    });
    try_all("project_mode", [Any; 4], extreme, |v: [T; 4]| {
        project_mode(plane(v[0], v[1]), plane(v[2], v[3]), T::lit(0.3)).norm()
    });
    try_all("driving_term", [Any; 3], extreme, |[a, b, c]: [T; 3]| {
        driving_term(a, plane(b, c), plane(c, b), T::lit(0.6), T::lit(-0.8)).norm()
    });
}

fn switches_and_conduction<T: Float>(extreme: f64) {
    let line = |x: T| Vector([x]);
    let v = Viscosity::of(Dissipation::AvSwSlr);
    try_all("regularised_approach", [Any, NotNegative, Positive], extreme, |[a, b, c]: [T; 3]| {
        regularised_approach(a, b, c)
    });
    try_all("limited_viscosity", [NotNegative, NotNegative], extreme, |[a, b]: [T; 2]| limited_viscosity(a, b));
    try_all("wave_aware_limiter", [Any, NotNegative, NotNegative, Positive, NotNegative], extreme, |v: [T; 5]| {
        wave_aware_limiter(v[0], v[1], v[2], v[3], v[4])
    });
    try_all("sign_is_reversed", [Any, Any], extreme, |[a, b]: [T; 2]| sign_is_reversed(a, b));
    try_all("convergence_indicator", [Any, Positive], extreme, |[a, b]: [T; 2]| convergence_indicator(line(a), b));
    try_all("local_coefficient", [NotNegative, Any, NotNegative, Positive], extreme, |[a, b, c, d]: [T; 4]| {
        local_coefficient(&v, a, b, c, d)
    });
    try_all("decay_rate", [NotNegative, Positive], extreme, |[a, b]: [T; 2]| decay_rate(a, b));
    try_all("decayed_coefficient", [NotNegative; 4], extreme, |[a, b, c, d]: [T; 4]| {
        decayed_coefficient(&v, a, b, c, d)
    });
    try_all("coefficient_rate", [NotNegative; 3], extreme, |[a, b, c]: [T; 3]| coefficient_rate(&v, a, b, c));
    try_all("conduction_velocity", [NotNegative, NotNegative, Positive], extreme, |[a, b, c]: [T; 3]| {
        conduction_velocity(a, b, c)
    });
    try_all("conduction_weight", [Any, Positive], extreme, |[a, b]: [T; 2]| conduction_weight(a, b));
    try_all("conduction_rate", [Positive, NotNegative, Any, NotNegative, Any], extreme, |v: [T; 5]| {
        conduction_rate(v[0], T::lit(0.1), v[1], v[2], line(v[3]), T::one(), line(v[4]))
    });
}

fn initial_states<T: Float>(extreme: f64) {
    try_all("vortex_velocity", [NotNegative, Any], extreme, |[a, b]: [T; 2]| vortex_velocity(a, b));
    try_all("vortex_pressure", [NotNegative, Positive, Positive, Any], extreme, |[a, b, c, d]: [T; 4]| {
        vortex_pressure(a, b, c, d)
    });
    try_all("layered_profile", [Any, Positive, Positive, Positive], extreme, |[a, b, c, d]: [T; 4]| {
        layered_profile(a, b, c, d)
    });
    // Positions within a few box widths.
    for x in [-7.5, -1.0, -1e-30, 0.0, 1e-30, 0.25, 0.5, 1.0, 8.0] {
        try_all("shear_seed", [Any], extreme, |[a]: [T; 1]| shear_seed(T::lit(x), a, T::lit(0.5)));
        try_all("plume_seed", [Any, Any, Positive], extreme, |[a, b, c]: [T; 3]| {
            plume_seed(T::lit(x), a, b, T::one(), c)
        });
    }
    try_all("layered_pressure", [Any, Positive, Positive, Any, NotNegative], extreme, |v: [T; 5]| {
        layered_pressure(v[0], v[1], [v[2], v[2]], v[3], T::one(), v[4])
    });
    try_all("wind_speed", [NotNegative, NotNegative, Positive], extreme, |[a, b, c]: [T; 3]| {
        wind_speed(a, T::lit(1.4), b, c)
    });
    try_all("entropy_change", [Positive; 4], extreme, |[a, b, c, d]: [T; 4]| entropy_change(a, b, c, d, T::lit(0.4)));
}

#[test]
fn no_equation_leaves_the_numbers() {
    // Four factors of 1e60 and a square of one; of 1e6.
    all_equations::<f64>(1e50);
    all_equations::<f32>(1e6);
}
