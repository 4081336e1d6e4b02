//! Scenes: that each starts from what the paper says, and that a short run of it does what is known of it.

mod all;
mod ending;
mod gresho_chan;
mod kelvin_helmholtz;
mod noh;
mod rayleigh_taylor;
mod sedov;
mod still;
mod support;
mod tubes;
mod wind_cloud;
