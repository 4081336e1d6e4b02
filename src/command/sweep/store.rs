//! The file of what is done: a JSON object a line, written line by line.

use super::Record;
use crate::command::failure::Failure;
use std::fs::{File, OpenOptions};
use std::io::{Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// Records of runs, those of before included.
pub struct Store {
    path: PathBuf,
    file: File,
    records: Vec<Record>,
}

impl Store {
    /// Opens a file, or makes it, in a folder that is made if it is not there.
    ///
    /// A last line that was cut short by an interruption is taken off; its run is made again.
    ///
    /// # Errors
    /// Exit code 2: a folder that cannot be written, a file that holds something else.
    pub fn open(path: &Path) -> Result<Self, Failure> {
        let wrong = |error: std::io::Error| {
            Failure::BadInput(format!("cannot use {}: {error}; choose another folder with --out", path.display()))
        };
        if let Some(folder) = path.parent() {
            std::fs::create_dir_all(folder).map_err(wrong)?;
        }
        let mut file =
            OpenOptions::new().read(true).write(true).create(true).truncate(false).open(path).map_err(wrong)?;
        let mut text = String::new();
        file.read_to_string(&mut text).map_err(wrong)?;
        let whole = text.rfind('\n').map_or(0, |end| end + 1);
        let mut records = Vec::new();
        for (number, line) in text[..whole].lines().enumerate() {
            records.push(serde_json::from_str(line).map_err(|error| {
                Failure::BadInput(format!(
                    "{}, line {}: it is no record of a run ({error}); choose another folder with --out, or delete the file",
                    path.display(),
                    number + 1
                ))
            })?);
        }
        file.set_len(whole as u64).and_then(|()| file.seek(SeekFrom::End(0))).map_err(wrong)?;
        Ok(Store { path: path.to_path_buf(), file, records })
    }

    /// The folder that the file lies in.
    pub fn folder(&self) -> &Path {
        self.path.parent().unwrap_or(Path::new("."))
    }

    /// The record of a run, if it was made.
    pub fn find(&self, id: &str) -> Option<&Record> {
        self.records.iter().find(|record| record.id == id)
    }

    /// Remembers a run.
    pub fn add(&mut self, record: Record) -> Result<(), Failure> {
        let wrong = |error: &dyn std::fmt::Display| {
            Failure::Broken(format!("cannot write {}: {error}; what is in it so far is kept", self.path.display()))
        };
        let line = serde_json::to_string(&record).map_err(|error| wrong(&error))? + "\n";
        self.file.write_all(line.as_bytes()).and_then(|()| self.file.sync_data()).map_err(|error| wrong(&error))?;
        self.records.push(record);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::snapshot::testing::Place;
    use std::collections::BTreeMap;

    fn record(id: &str) -> Record {
        Record {
            id: id.into(),
            particles: 100,
            steps: 7,
            wall_seconds: 0.1,
            operations: 1e6,
            bytes_per_particle: 500.0,
            l1: BTreeMap::from([("density".into(), 0.1 + 0.2)]),
            energy_drift: -1e-16,
            time: vec![0.0, 0.1],
            measured: BTreeMap::new(),
        }
    }

    #[test]
    fn what_was_done_is_there_again_and_a_cut_line_is_not() {
        let place = Place::new("again");
        let path = place.path("deep/results.jsonl");
        let mut store = Store::open(&path).unwrap();
        store.add(record("a")).unwrap();
        store.add(record("b")).unwrap();
        drop(store);
        let whole = std::fs::read_to_string(&path).unwrap();
        std::fs::write(&path, format!("{whole}{}", &whole[..40])).unwrap();
        let mut store = Store::open(&path).unwrap();
        assert_eq!(store.find("a"), Some(&record("a")));
        assert_eq!(store.find("c"), None);
        store.add(record("c")).unwrap();
        drop(store);
        let store = Store::open(&path).unwrap();
        assert_eq!((store.records.len(), store.find("c")), (3, Some(&record("c"))));
    }

    #[test]
    fn a_foreign_file_is_refused_and_kept() {
        let place = Place::new("foreign");
        let path = place.path("results.jsonl");
        std::fs::write(&path, "my notes\n").unwrap();
        let error = Store::open(&path).err().unwrap().to_string();
        assert!(error.contains("line 1") && error.contains("--out"), "{error}");
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "my notes\n");
    }
}
