//! The records that later audits are held against: built into this program, read from a folder, written anew.

use crate::budgets::Budgets;
use crate::catalogue::Catalogue;
use crate::encoded::Encoded;
use crate::gains::Gains;
use crate::ranges::Ranges;
use crate::state::Survey;
use std::path::{Path, PathBuf};

/// The records' files, below the folder `audit`, with what is built into this program.
pub(crate) const FILES: [(&str, &str); 4] = [
    ("budgets.toml", include_str!("../budgets.toml")),
    ("equations.toml", include_str!("../equations.toml")),
    ("ranges.toml", include_str!("../ranges.toml")),
    ("gains.toml", include_str!("../gains.toml")),
];
/// How a record comes back.
const REMEDY: &str = "write it anew with `etalon audit --record`";

/// A record that cannot be read or written.
#[derive(Debug, thiserror::Error)]
pub enum RecordError {
    /// Its text is not what it should be.
    #[error("{file} cannot be read: {source}; {remedy}")]
    Unreadable {
        /// Which.
        file: String,
        /// What is wrong with it.
        source: Box<toml::de::Error>,
        /// How to get it back.
        remedy: &'static str,
    },
    /// A file cannot be opened.
    #[error("{}: {source}; give a folder with {}", path.display(), FILES.map(|(name, _)| name).join(", "))]
    File {
        /// Which.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// It has no text.
    #[error("{file} cannot be written: {source}")]
    Unwritable {
        /// Which.
        file: &'static str,
        /// What the serialiser says.
        source: toml::ser::Error,
    },
}

impl RecordError {
    /// What makes an error of what TOML's reader says of a file.
    pub(crate) fn unreadable(file: &str, remedy: &'static str) -> impl Fn(toml::de::Error) -> Self {
        let file = file.to_string();
        move |source| RecordError::Unreadable { file: file.clone(), source: Box::new(source), remedy }
    }
    fn file(path: &Path) -> impl FnOnce(std::io::Error) -> Self {
        let path = path.to_path_buf();
        move |source| RecordError::File { path, source }
    }
}

impl Catalogue {
    /// The same with the records that are built into this program.
    pub(crate) fn with_built_in_records(self) -> Result<Self, RecordError> {
        self.with_texts(&FILES.map(|(_, text)| text.to_string()))
    }

    /// The same with the records in a folder, such as `audit` of another version of the sources.
    ///
    /// # Errors
    /// [`RecordError`] if one of the four is not there or cannot be read.
    pub fn with_records(self, folder: &Path) -> Result<Self, RecordError> {
        let mut texts: [String; 4] = Default::default();
        for ((name, _), text) in FILES.iter().zip(&mut texts) {
            let path = folder.join(name);
            *text = std::fs::read_to_string(&path).map_err(RecordError::file(&path))?;
        }
        self.with_texts(&texts)
    }

    fn with_texts(self, [budgets, encoded, ranges, gains]: &[String; 4]) -> Result<Self, RecordError> {
        let wrong = |place: usize| RecordError::unreadable(FILES[place].0, REMEDY);
        Ok(Catalogue {
            budgets: toml::from_str(budgets).map_err(wrong(0))?,
            encoded: toml::from_str(encoded).map_err(wrong(1))?,
            ranges: toml::from_str(ranges).map_err(wrong(2))?,
            gains: toml::from_str(gains).map_err(wrong(3))?,
            ..self
        })
    }

    /// Takes what a survey of everything found for the record, with all that needs no survey: what is encoded in the tree at `root`, ranges, gains.
    /// Figures of devices that were not there this time are kept as long as the text they ran is.
    ///
    /// # Errors
    /// If the tree cannot be read.
    pub fn record(&mut self, survey: &Survey, samples: usize, root: &Path) -> Result<(), RecordError> {
        let tests = root.join("reference/tests");
        self.budgets = survey.budgets().with_absent_devices(&self.budgets);
        self.encoded = Encoded::now(root, &self.reach).map_err(RecordError::file(&tests))?;
        self.ranges = Ranges::now();
        self.gains = Gains::now(samples);
        Ok(())
    }

    /// Writes the records into the folder `audit` of the tree at `root`; the files' names.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub fn write_records(&self, root: &Path) -> Result<Vec<PathBuf>, RecordError> {
        let texts = [self.budgets.to_toml(), self.encoded.to_toml(), self.ranges.to_toml(), self.gains.to_toml()];
        let mut written = Vec::new();
        for ((name, _), text) in FILES.into_iter().zip(texts) {
            let path = root.join("audit").join(name);
            let text = text.map_err(|source| RecordError::Unwritable { file: name, source })?;
            std::fs::write(&path, text).map_err(RecordError::file(&path))?;
            written.push(path);
        }
        Ok(written)
    }

    /// Whether the folder `audit` of the tree at `root` has the records.
    #[must_use]
    pub fn has_records(root: &Path) -> bool {
        FILES.iter().all(|(name, _)| root.join("audit").join(name).exists())
    }
}

impl Budgets {
    /// The record that is checked in.
    ///
    /// # Errors
    /// What TOML's reader says; none in a build whose tests pass.
    pub fn recorded() -> Result<Self, toml::de::Error> {
        toml::from_str(FILES[0].1)
    }
}

impl Encoded {
    /// The record that is checked in.
    ///
    /// # Errors
    /// What TOML's reader says; none in a build whose tests pass.
    pub fn recorded() -> Result<Self, toml::de::Error> {
        toml::from_str(FILES[1].1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn records_are_written_and_read_back() {
        let catalogue = Catalogue::load().unwrap();
        let root = std::env::temp_dir().join(format!("etalon-records-{}", std::process::id()));
        let folder = root.join("audit");
        std::fs::create_dir_all(&folder).unwrap();
        assert!(!Catalogue::has_records(&root));
        assert_eq!(catalogue.write_records(&root).unwrap().len(), FILES.len());
        assert!(Catalogue::has_records(&root));
        for (name, text) in FILES {
            assert_eq!(std::fs::read_to_string(folder.join(name)).unwrap(), text, "{name} is not as it is written");
        }
        let mut tampered = Catalogue::load().unwrap();
        tampered.budgets.records.clear();
        let again = tampered.with_records(&folder).unwrap();
        assert_eq!((&again.budgets, &again.encoded), (&catalogue.budgets, &catalogue.encoded));
        assert_eq!((&again.ranges, &again.gains), (&catalogue.ranges, &catalogue.gains));

        std::fs::write(folder.join("gains.toml"), "nothing = 1").unwrap();
        let wrong = Catalogue::load().unwrap().with_records(&folder).unwrap_err().to_string();
        assert!(wrong.starts_with("gains.toml cannot be read") && wrong.ends_with(REMEDY), "{wrong}");
        std::fs::remove_file(folder.join("gains.toml")).unwrap();
        assert!(Catalogue::load().unwrap().with_records(&folder).unwrap_err().to_string().contains("give a folder"));
        std::fs::remove_dir_all(&root).unwrap();
    }
}
