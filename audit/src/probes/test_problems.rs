//! Test problems that scenes start from. What is a whole state at a place has its constants in the scene's own units, so its
//! arguments and results are pure numbers.

use crate::{Name, Probe, any, between, not_negative, own, positive, probe};
use etalon_reference::equations::initial_state::kelvin_helmholtz::Contact;
use etalon_reference::equations::initial_state::rayleigh_taylor::Balance;
use etalon_reference::equations::initial_state::wind_cloud::Wind;
use etalon_reference::equations::initial_state::{gresho_chan, kelvin_helmholtz, rayleigh_taylor, wind_cloud};

const PLACE: Name = own(r"\mathbf{x}", "place, in the scene's unit of length");
const DENSITY: Name = own(r"\rho", "density, in the scene's unit");
const VELOCITY: Name = own(r"\mathbf{v}", "velocity, in the scene's unit");
const PRESSURE: Name = own(r"\tilde{P}", "pressure, in the scene's unit");

macro_rules! states {
    ($list:ident: $($variant:literal: $module:ident::$function:ident($choice:expr), $low:literal, $high:literal;)*) => {
        $($list.extend(probe! {
            in 2, 3;
            as $variant;
            $module::$function(place, $choice) -> |state| { (state.density, state.velocity, state.pressure) };
            place: Vector<R, D> = PLACE, "1", between($low, $high);
            => density: R = DENSITY, "1";
               velocity: Vector<R, D> = VELOCITY, "1";
               pressure: R = PRESSURE, "1";
        });)*
    };
}

macro_rules! winds {
    ($list:ident: $($variant:literal, $wind:ident;)*) => {
        $($list.extend(probe! {
            in 2, 3;
            as $variant;
            wind_cloud::wind_cloud(place, gamma, Wind::$wind) -> |state| { (state.density, state.velocity, state.pressure) };
            place: Vector<R, D> = PLACE, "1", between(0.0, 10.0).with(&[5.0]);
            gamma: R = own(r"\gamma", "adiabatic index"), "1", between(1.001, 2.0).with(&[5.0 / 3.0]);
            => density: R = DENSITY, "1";
               velocity: Vector<R, D> = VELOCITY, "1";
               pressure: R = PRESSURE, "1";
        });)*
    };
}

pub(super) fn probes() -> Vec<Probe> {
    let mut list = probe! {
        gresho_chan::vortex_velocity(psi, largest_velocity);
        psi: R = r"\psi", "1", between(0.0, 3.0).with(&[1.0, 2.0]);
        largest_velocity: R = "v_0", "L T^-1", positive(1e-3, 1e3);
        => velocity: R = r"v_\varphi", "L T^-1";
    };
    list.extend(probe! {
        gresho_chan::vortex_pressure(psi, central_pressure, density, largest_velocity);
        psi: R = r"\psi", "1", between(0.0, 3.0).with(&[1.0, 2.0]);
        central_pressure: R = "P_0", "M L^(2-nu) T^-2", not_negative(1e-2, 1e2);
        density: R = r"\rho_0", "M L^-nu", positive(1e-2, 1e2);
        largest_velocity: R = "v_0", "L T^-1", positive(1e-2, 1e2);
        => pressure: R = "P", "M L^(2-nu) T^-2";
    });
    list.extend(probe! {
        in 2, 3;
        gresho_chan::gresho_chan(place) -> |state| { (state.density, state.velocity, state.pressure) };
        place: Vector<R, D> = PLACE, "1", between(-0.5, 0.5).with(&[0.0]);
        => density: R = DENSITY, "1";
           velocity: Vector<R, D> = VELOCITY, "1";
           pressure: R = PRESSURE, "1";
    });
    list.extend(probe! {
        kelvin_helmholtz::layered_profile(y, outer, inner, width);
        y: R = own("y", "height, in box heights"), "1", between(0.0, 1.0).with(&[0.25, 0.5, 0.75]);
        outer: R = own("f_1", "value outside"), "F", any(1e-2, 1e2);
        inner: R = own("f_2", "value inside"), "F", any(1e-2, 1e2);
        width: R = own("L", "length of the change, in box heights"), "1", positive(1e-3, 1.0).with(&[0.025]);
        => profile: R = own("f", "layered profile"), "F";
    });
    list.extend(probe! {
        kelvin_helmholtz::shear_seed(x, amplitude, wavelength);
        x: R = "x", "L", between(0.0, 1.0);
        amplitude: R = r"\Delta v_y", "L T^-1", positive(1e-3, 1.0);
        wavelength: R = r"\lambda", "L", between(0.1, 1.0).with(&[0.5]);
        => seed: R = "v_y", "L T^-1";
    });
    list.extend(probe! {
        rayleigh_taylor::layered_pressure(y, bottom_pressure, [lower, upper], gravity, interface, layer);
        y: R = "y", "L", between(0.0, 2.0).with(&[0.8, 1.0, 1.2]);
        bottom_pressure: R = own("P(0)", "pressure at the bottom"), "M L^(2-nu) T^-2", positive(1e-2, 1e2);
        lower: R = r"\rho_d", "M L^-nu", positive(1e-2, 1e2);
        upper: R = r"\rho_u", "M L^-nu", positive(1e-2, 1e2);
        gravity: R = "g", "L T^-2", between(-1.0, 0.0);
        interface: R = "y_b", "L", between(0.5, 1.5).with(&[1.0]);
        layer: R = r"\delta", "L", between(0.0, 0.5).with(&[0.4]);
        => pressure: R = "P", "M L^(2-nu) T^-2";
    });
    list.extend(probe! {
        rayleigh_taylor::plume_seed(x, y, amplitude, interface, layer);
        x: R = "x", "1", between(-1.0, 1.0).with(&[0.0, 0.5]);
        y: R = "y", "L", between(0.0, 2.0);
        amplitude: R = r"\Delta v_y", "L T^-1", positive(1e-3, 1.0);
        interface: R = "y_b", "L", between(0.5, 1.5).with(&[1.0]);
        layer: R = r"\delta", "L", between(0.1, 0.5).with(&[0.4]);
        => seed: R = "v_y", "L T^-1";
    });
    list.extend(probe! {
        wind_cloud::wind_speed(mach, gamma, pressure, density);
        mach: R = own("M", "Mach number"), "1", positive(1e-2, 1e2).with(&[2.7]);
        gamma: R = own(r"\gamma", "adiabatic index"), "1", between(1.001, 2.0).with(&[5.0 / 3.0]);
        pressure: R = own("P", "pressure"), "M L^(2-nu) T^-2", positive(1e-3, 1e3);
        density: R = own(r"\rho", "density"), "M L^-nu", positive(1e-3, 1e3);
        => speed: R = own("v", "speed of the wind"), "L T^-1";
    });
    states! { list:
        "sharp": kelvin_helmholtz::kelvin_helmholtz(Contact::Sharp), 0.0, 1.0;
        "smooth": kelvin_helmholtz::kelvin_helmholtz(Contact::Smooth), 0.0, 1.0;
        "hydrostatic": rayleigh_taylor::rayleigh_taylor(Balance::Hydrostatic), 0.0, 2.0;
        "printed": rayleigh_taylor::rayleigh_taylor(Balance::Printed), 0.0, 2.0;
    }
    winds! { list:
        "mach", Mach;
        "speed", Speed;
    }
    list
}
