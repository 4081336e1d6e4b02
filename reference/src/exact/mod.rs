//! Analytic solutions that simulations are compared with.

pub mod dust;
pub mod dustybox;
pub mod dustyshock;
pub mod dustywave;
pub mod finite_volume;
pub mod noh;
pub mod outgoing_wave;
pub mod radial;
pub mod riemann;
pub mod sedov;
