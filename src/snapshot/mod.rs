//! Files that outlast a run: snapshots that other programs open, time series, and restart files.
//!
//! A [`Snapshot`] is the particles at one moment, as columns. It is written and read as HDF5 in the layout of GADGET and SWIFT, as VTK
//! unstructured grid, or as comma-separated values ([`Format`]); `docs/output.md` describes each. Whatever is written is complete or not
//! there: files are made beside and renamed.
//!
//! | file | what lives there |
//! |---|---|
//! | `table.rs` | the particles as columns, checked |
//! | `capture.rs` | the particles of an engine |
//! | `format.rs` | which format a file has |
//! | `names.rs` | columns and how other codes call them |
//! | `hdf5/` | HDF5, written and read |
//! | `vtu.rs`, `csv.rs` | the other two |
//! | `series.rs` | time series |
//! | `restart.rs` | a checkpoint as a file |
//! | `compare/` | two snapshots beside each other |
//! | `atomic.rs`, `error.rs` | what they share |

mod atomic;
mod capture;
pub mod compare;
mod csv;
mod error;
mod format;
mod hdf5;
mod names;
pub mod restart;
pub mod series;
mod table;
#[cfg(test)]
pub(crate) mod testing;
mod vtu;

pub(crate) use atomic::begun;
pub use atomic::write_bytes as write_file;
pub use capture::capture;
pub(crate) use csv::problem as csv_problem;
pub use error::SnapshotError;
pub use format::Format;
pub use table::{Column, Frame, PARTICLE_TYPE, Snapshot};
