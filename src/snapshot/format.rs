//! Which format a file has.

use super::{Snapshot, SnapshotError, csv, hdf5, vtu};
use std::fmt;
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// How a snapshot is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// HDF5 in the layout of GADGET and SWIFT: yt, SPLASH, h5py.
    Hdf5,
    /// VTK unstructured grid: ParaView, VisIt.
    Vtu,
    /// Comma-separated values: spreadsheets, scripts, `--start-file`.
    Csv,
}

/// What an HDF5 file begins with.
const HDF5_SIGNATURE: &[u8] = b"\x89HDF\r\n\x1a\n";

impl Format {
    /// All of them.
    pub const ALL: &'static [Self] = &[Self::Hdf5, Self::Vtu, Self::Csv];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Format::Hdf5 => "HDF5",
            Format::Vtu => "VTU",
            Format::Csv => "CSV",
        }
    }

    /// Endings of files that are written so; the first is the usual one.
    pub fn extensions(self) -> &'static [&'static str] {
        match self {
            Format::Hdf5 => &["hdf5", "h5"],
            Format::Vtu => &["vtu"],
            Format::Csv => &["csv"],
        }
    }

    /// The format that a file's ending asks for.
    ///
    /// # Errors
    /// [`SnapshotError::File`] for any other, with those there are.
    pub fn of_name(path: &Path) -> Result<Self, SnapshotError> {
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or("").to_ascii_lowercase();
        let found = Self::ALL.iter().find(|format| format.extensions().contains(&ending.as_str()));
        found.copied().ok_or_else(|| {
            let known: Vec<String> = Self::ALL.iter().flat_map(|f| f.extensions()).map(|e| format!(".{e}")).collect();
            SnapshotError::file(
                path,
                format!("its ending says no format of a snapshot; the endings are {}", known.join(", ")),
            )
        })
    }

    /// The format of a file, by what it begins with; for text that has no such mark, by its ending.
    ///
    /// # Errors
    /// [`SnapshotError`] for a file that cannot be read, is empty, or has neither.
    pub fn of_file(path: &Path) -> Result<Self, SnapshotError> {
        let mut start = Vec::new();
        let file = File::open(path).map_err(SnapshotError::io("read", path))?;
        file.take(256).read_to_end(&mut start).map_err(SnapshotError::io("read", path))?;
        let text = start.trim_ascii_start();
        if start.is_empty() {
            Err(SnapshotError::file(path, "it is empty; was it cut short?"))
        } else if start.starts_with(HDF5_SIGNATURE) {
            Ok(Format::Hdf5)
        } else if text.starts_with(b"<?xml") || text.starts_with(b"<VTKFile") {
            Ok(Format::Vtu)
        } else {
            match Self::of_name(path)? {
                Format::Csv => Ok(Format::Csv),
                other => {
                    Err(SnapshotError::file(path, format!("it does not begin as {other} does; is its ending right?")))
                }
            }
        }
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl Snapshot {
    /// Reads a file of any [`Format`]: one of ours, or of another program as `docs/output.md` says.
    ///
    /// # Errors
    /// [`SnapshotError`] naming the file, the dataset, column or line, and what is allowed.
    pub fn read(path: &Path) -> Result<Self, SnapshotError> {
        match Format::of_file(path)? {
            Format::Hdf5 => hdf5::read(path),
            Format::Vtu => vtu::read(path),
            Format::Csv => csv::read(path),
        }
    }

    /// Writes a file, complete or not at all.
    ///
    /// # Errors
    /// [`SnapshotError::Io`], or what a format cannot hold.
    pub fn write(&self, path: &Path, format: Format) -> Result<(), SnapshotError> {
        match format {
            Format::Hdf5 => hdf5::write(self, path),
            Format::Vtu => vtu::write(self, path),
            Format::Csv => csv::write(self, path),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::{Place, small};
    use super::*;

    #[test]
    fn every_format_gives_the_same_numbers_back() {
        let place = Place::new("formats");
        for dimension in 1..=3 {
            let snapshot = small(dimension);
            for format in Format::ALL {
                let path = place.path(&format!("a.{}", format.extensions()[0]));
                assert_eq!(Format::of_name(&path).unwrap(), *format);
                snapshot.write(&path, *format).unwrap();
                assert_eq!(Format::of_file(&path).unwrap(), *format);
                let found = Snapshot::read(&path).unwrap();
                assert_eq!(
                    (found.dimension(), found.time(), found.ids()),
                    (dimension, Some(0.1), snapshot.ids()),
                    "{format}"
                );
                for column in snapshot.columns() {
                    assert_eq!(found.column(&column.name), Some(column.values.as_slice()), "{format} {}", column.name);
                }
                assert_eq!(found.columns().len(), snapshot.columns().len(), "{format}");
            }
        }
    }

    #[test]
    fn what_has_no_format_is_refused() {
        let place = Place::new("unknown");
        let refused = |name: &str, content: &[u8]| {
            let path = place.path(name);
            std::fs::write(&path, content).unwrap();
            Snapshot::read(&path).unwrap_err().to_string()
        };
        assert!(refused("a.dat", b"1 2 3").ends_with("the endings are .hdf5, .h5, .vtu, .csv"));
        assert!(refused("a.csv", b"").ends_with("it is empty; was it cut short?"));
        assert!(refused("a.h5", b"1,2,3").ends_with("it does not begin as HDF5 does; is its ending right?"));
        let missing = Snapshot::read(&place.path("none.csv")).unwrap_err().to_string();
        assert!(missing.starts_with("cannot read "), "{missing}");
    }
}
