//! Whether the device computes what the equations say. Without an adapter every test says SKIPPED, or fails if
//! ETALON_REQUIRE_ADAPTER is set.

#[path = "../support/adapter.rs"]
mod adapter;
mod behaviour;
mod bits;
mod conservation;
mod external;
mod passes;
#[path = "../support/random.rs"]
mod random;
mod resume;
mod runs;
mod scene;
mod updates;
