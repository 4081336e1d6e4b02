//! The ledger: one record for every numbered equation of the three papers, and the published tables as data.
//!
//! A record says what the equation is (LaTeX, symbols, units), how Etalon reads it, how sure that reading is, and where
//! the paper departs from physics or from published codes. It does not say whether Rust code for it exists: the caller
//! brings the set of encoded equations and [`Ledger::status`] joins the two.
//!
//! ```
//! use etalon_spec::{EquationId, Ledger};
//!
//! let ledger = Ledger::load()?;
//! let balsara: EquationId = "gs25:8".parse()?;
//! assert_eq!(ledger.get(balsara).title, "Balsara factor of a particle");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
#![forbid(unsafe_code)]

mod bad_input;
mod entry;
mod error;
mod identifier;
mod latex;
mod ledger;
mod paper;
mod status;
pub mod tables;
mod text;
mod unit;
mod validate;

pub use bad_input::{BadInput, BadValue, Caught};
pub use entry::{Confidence, Entry, Index, Kind, Symbol};
pub use error::LedgerError;
pub use identifier::{EquationId, IdError, exists};
pub use ledger::{Ledger, PaperLedger};
pub use paper::Paper;
pub use status::{Encoding, EntryStatus};
pub use unit::{Base, Exponent, Unit, UnitError};
