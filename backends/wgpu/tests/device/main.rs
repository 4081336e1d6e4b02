//! What needs a device: every test here runs on the adapter that ETALON_ADAPTER names, or else the first one. Without an
//! adapter they say SKIPPED, or fail if ETALON_REQUIRE_ADAPTER is set.

#[path = "../support/adapter.rs"]
mod adapter;
mod common;
mod drift;
mod errors;
mod functions;
mod neighbours;
mod passes;
#[path = "../support/random.rs"]
mod random;
mod reduce;
