//! Everything that is known of the equations, in one place: the ledger, the registry, the records.

use crate::budgets::Budgets;
use crate::encoded::{Encoded, path_of};
use crate::gains::Gains;
use crate::ranges::Ranges;
use crate::reach::Reach;
use crate::records::RecordError;
use etalon_kernels_gen::{EquationEntry, registered};
use etalon_spec::{EquationId, IdError, Ledger, LedgerError};

/// The ledger, the registry, the records.
#[derive(Clone, Debug)]
pub struct Catalogue {
    /// The papers.
    pub ledger: Ledger,
    /// The equations of this program.
    pub entries: Vec<&'static EquationEntry>,
    /// The recorded figures.
    pub budgets: Budgets,
    /// The recorded equations.
    pub encoded: Encoded,
    /// The recorded ranges.
    pub ranges: Ranges,
    /// The recorded gains over textbook forms.
    pub gains: Gains,
    /// The tests that reach them.
    pub reach: Reach,
}

/// Why a catalogue cannot be made.
#[derive(Debug, thiserror::Error)]
pub enum CatalogueError {
    /// The ledger is damaged.
    #[error(transparent)]
    Ledger(#[from] LedgerError),
    /// A record is.
    #[error(transparent)]
    Record(#[from] RecordError),
}

/// What is asked about: a numbered equation, or a function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Subject {
    /// An equation of a paper.
    Number(EquationId),
    /// Functions of a name: more than one if modules share it.
    Functions(Vec<&'static EquationEntry>),
}

/// A name that neither an equation nor a function has.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{reason}; near it are {}", near.join(", "))]
pub struct Unknown {
    /// What is wrong with it.
    pub reason: String,
    /// Names that exist, the nearest first.
    pub near: Vec<String>,
}

/// How many near names are given.
const NEAR: usize = 4;

impl Catalogue {
    /// What is built into this program.
    ///
    /// # Errors
    /// [`CatalogueError`] if a file was damaged; none occurs in a build whose tests pass.
    pub fn load() -> Result<Self, CatalogueError> {
        let catalogue = Catalogue {
            ledger: Ledger::load()?,
            entries: registered(),
            budgets: Budgets::default(),
            encoded: Encoded::default(),
            ranges: Ranges::default(),
            gains: Gains::default(),
            reach: Reach::recorded().map_err(RecordError::unreadable(
                "tests/mutants/",
                "write it anew with `cargo run -p etalon-mutants`",
            ))?,
        };
        Ok(catalogue.with_built_in_records()?)
    }

    /// The functions that encode an equation: first those that run on all targets.
    pub fn functions(&self, id: EquationId) -> impl Iterator<Item = &'static EquationEntry> {
        let id = id.to_string();
        let encodes = |entry: &&EquationEntry| entry.ids.contains(&id.as_str());
        let mut entries: Vec<_> = self.entries.iter().copied().filter(encodes).collect();
        entries.sort_by_key(|entry| is_host(entry));
        entries.into_iter()
    }
    /// The definitions without a number.
    pub fn unnumbered(&self) -> impl Iterator<Item = &'static EquationEntry> {
        self.entries.iter().copied().filter(|entry| entry.ids.is_empty())
    }
    /// The tests that reach an equation; where the mutation tests do not know, those that call it by name.
    #[must_use]
    pub fn tests(&self, entry: &EquationEntry) -> &[String] {
        let path = path_of(entry);
        self.reach.tests(&path).unwrap_or_else(|| self.encoded.called_by(&path))
    }

    /// What a name means: `gs25:13`, `mixed_sinc` or `kernels::mixed_sinc`.
    ///
    /// # Errors
    /// [`Unknown`], with the names that are near.
    pub fn find(&self, name: &str) -> Result<Subject, Unknown> {
        let of_name = |entry: &&EquationEntry| entry.name == name || path_of(entry) == name;
        let functions: Vec<_> = self.entries.iter().copied().filter(of_name).collect();
        if !functions.is_empty() {
            return Ok(Subject::Functions(functions));
        }
        name.parse().map(Subject::Number).map_err(|error| {
            let reason = match error {
                IdError::Shape { .. } => format!("`{name}` is neither an equation, such as gs25:13, nor a function"),
                other => other.to_string(),
            };
            Unknown { reason, near: self.near(name) }
        })
    }

    fn near(&self, name: &str) -> Vec<String> {
        let numbers = EquationId::all().map(|id| id.to_string());
        let functions = self.entries.iter().map(|entry| entry.name.to_string());
        // Paths only where one is asked for: `kernels::mixed` is far from every plain name.
        let paths = self.entries.iter().filter(|_| name.contains("::")).map(|entry| path_of(entry));
        let mut all: Vec<String> = numbers.chain(functions).chain(paths).collect();
        all.dedup();
        all.sort_by_cached_key(|known| strsim::damerau_levenshtein(&known.to_lowercase(), &name.to_lowercase()));
        all.truncate(NEAR);
        all
    }
}

/// Whether a function runs on the host only: it is not generic over the number that targets are made of.
#[must_use]
pub fn is_host(entry: &EquationEntry) -> bool {
    let signature = entry.source.split("pub fn ").nth(1).and_then(|rest| rest.split('{').next());
    !signature.is_some_and(|signature| signature.contains("Real"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_functions_are_found() {
        let catalogue = Catalogue::load().unwrap();
        assert_eq!(catalogue.find("gs25:13"), Ok(Subject::Number("gs25:13".parse().unwrap())));
        for name in ["mixed_sinc", "kernels::mixed_sinc"] {
            let Ok(Subject::Functions(found)) = catalogue.find(name) else { panic!("{name}") };
            assert_eq!(found.iter().map(|entry| path_of(entry)).collect::<Vec<_>>(), ["kernels::mixed_sinc"]);
        }
    }

    #[test]
    fn what_is_unknown_has_near_names() {
        let catalogue = Catalogue::load().unwrap();
        let far = catalogue.find("gs25:31").unwrap_err();
        assert!(far.to_string().starts_with("gs25 has no equation 31; its equations are 1 to 30; near it are gs25:"));
        assert_eq!(catalogue.find("mixd_sinc").unwrap_err().near[0], "mixed_sinc");
        assert_eq!(catalogue.find("kernels::mixedsinc").unwrap_err().near[0], "kernels::mixed_sinc");
        assert_eq!(catalogue.find("GS25:8").unwrap_err().near[0], "gs25:8");
        assert_eq!(catalogue.find("").unwrap_err().near.len(), NEAR);
    }

    #[test]
    fn norms_run_on_the_host_and_limiters_do_not() {
        let catalogue = Catalogue::load().unwrap();
        for (name, host) in [("l1_error", true), ("slope_limiter", false)] {
            let found: Vec<_> = catalogue.entries.iter().filter(|entry| entry.name == name).collect();
            assert_eq!(found.iter().map(|entry| is_host(entry)).collect::<Vec<_>>(), [host], "{name}");
        }
    }
}
