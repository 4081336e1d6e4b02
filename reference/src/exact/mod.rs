//! Analytic solutions that simulations are compared with.

pub mod riemann;
