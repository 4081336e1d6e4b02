//! The driving of turbulence and what is measured on it: exact values where there are any, statistics with the scatter they must have where not.

#[path = "../support/check.rs"]
mod check;
mod density_pdf;
mod forcing;
mod forcing_statistics;
mod grid;
mod places;
mod power_law;
mod refusals;
mod spectrum;
mod structure_function;
