//! What only a run through time shows: the integrator's order, and that scenes converge to their exact solutions.

mod misuse;
mod order;
mod sod;
