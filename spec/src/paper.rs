//! The papers the ledger covers.

use std::fmt;

/// A paper whose numbered equations the ledger holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Paper {
    /// García-Senz & Cabezón 2025: dissipation without switches.
    Gs25,
    /// Price & Laibe 2020: drag between gas and dust with reconstructed velocities.
    Pl20,
    /// Cabezón et al. 2025: subsonic turbulence with SPH-EXA.
    C25,
}

impl Paper {
    /// Every paper, in the order in which the ledger lists them.
    pub const ALL: [Self; 3] = [Self::Gs25, Self::Pl20, Self::C25];

    /// The short key used in identifiers, such as `gs25`.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::Gs25 => "gs25",
            Self::Pl20 => "pl20",
            Self::C25 => "c25",
        }
    }

    /// The number of the paper's last numbered equation; the first is 1 and none is left out.
    ///
    /// Loading the ledger checks that the paper's file holds exactly these numbers.
    #[must_use]
    pub const fn last_number(self) -> u16 {
        match self {
            Self::Gs25 => 30,
            Self::Pl20 => 16,
            Self::C25 => 33,
        }
    }

    /// The paper with this key, if the ledger has it.
    #[must_use]
    pub fn from_key(key: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|paper| paper.key() == key)
    }
}

impl fmt::Display for Paper {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.key())
    }
}
