//! The join between the ledger and the equations that code exists for.

use std::collections::BTreeSet;

use crate::entry::Entry;
use crate::identifier::EquationId;
use crate::ledger::Ledger;

/// Whether code exists for an equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// At least one function is registered under the equation's identifier.
    Encoded,
    /// No function is registered under it.
    NotYetEncoded {
        /// Why there may be none, given what the equation is for.
        reason: &'static str,
    },
}

/// An entry together with whether code exists for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EntryStatus<'ledger> {
    /// The ledger's entry.
    pub entry: &'ledger Entry,
    /// Whether it is encoded.
    pub encoding: Encoding,
}

impl Ledger {
    /// Says of every entry, in order, whether it is among the `encoded` equations.
    #[must_use]
    pub fn status(&self, encoded: &BTreeSet<EquationId>) -> Vec<EntryStatus<'_>> {
        self.entries()
            .map(|entry| {
                let encoding = if encoded.contains(&entry.id) {
                    Encoding::Encoded
                } else {
                    Encoding::NotYetEncoded { reason: entry.kind.reason_not_encoded() }
                };
                EntryStatus { entry, encoding }
            })
            .collect()
    }
}
