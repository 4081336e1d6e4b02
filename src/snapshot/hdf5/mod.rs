//! Snapshots as HDF5, in the layout that GADGET introduced and SWIFT, GIZMO, yt and SPLASH share.

mod read;
mod write;

pub use read::read;
pub use write::write;

/// The group of all that only our files have.
const OWN: &str = "Etalon";
/// What the group says it is, and the version of it.
const SCHEMA: &str = "etalon-snapshot";
const SCHEMA_VERSION: u64 = 1;
/// Kinds of particles that the layout knows: 0 is gas, 1 what only falls, here dust.
const TYPES: usize = 6;

#[cfg(test)]
mod tests;
