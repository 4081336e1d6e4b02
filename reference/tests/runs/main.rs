//! What only a run through time shows: the integrator's order, that scenes converge to their exact solutions, and that a run stops
//! that has gone wrong.

mod bad_input;
mod external;
mod glass;
mod membrane;
mod mirror;
mod misuse;
mod order;
mod resume;
mod sod;
mod turbulence;
