//! Writing a file so that it is there complete or not at all.

use super::SnapshotError;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// Fills a new file beside `path`, which then takes its place. After a failure what was there before is still there.
///
/// # Errors
/// [`SnapshotError::Io`], whichever step of it fails.
pub fn write(path: &Path, fill: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>) -> Result<(), SnapshotError> {
    let Some(name) = path.file_name() else {
        return Err(SnapshotError::file(path, "it is no name of a file"));
    };
    let hidden = format!("{}{}", begun(&name.to_string_lossy()), std::process::id());
    let fresh = Fresh(path.with_file_name(hidden));
    let filled = File::create(&fresh.0).map(BufWriter::new).and_then(|mut out| {
        fill(&mut out)?;
        // On the disk before the name is: a machine that stops must not leave an empty file under it.
        out.into_inner().map_err(io::IntoInnerError::into_error)?.sync_all()
    });
    filled.map_err(SnapshotError::io("write", path))?;
    fs::rename(&fresh.0, path).map_err(SnapshotError::io("write", path))
}

/// As [`write`], of bytes.
///
/// # Errors
/// As [`write`].
pub fn write_bytes(path: &Path, bytes: &[u8]) -> Result<(), SnapshotError> {
    write(path, |out| out.write_all(bytes))
}

/// What the name of a file begins with that has been begun to take the place of `name`: a program that is killed leaves it behind.
pub fn begun(name: &str) -> String {
    format!(".{name}.partial-")
}

/// A file that is removed when it goes out of use; nothing to do once it has been renamed.
struct Fresh(PathBuf);

impl Drop for Fresh {
    fn drop(&mut self) {
        let _ = fs::remove_file(&self.0);
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::Place;
    use super::*;

    #[test]
    fn a_failure_leaves_what_was_there_and_nothing_else() {
        let place = Place::new("atomic");
        let path = place.path("out.csv");
        write_bytes(&path, b"old").unwrap();
        let error = write(&path, |out| {
            out.write_all(b"half")?;
            Err(io::Error::other("the disk is full"))
        });
        assert!(error.unwrap_err().to_string().ends_with("out.csv: the disk is full"));
        assert_eq!(fs::read(&path).unwrap(), b"old");
        write_bytes(&path, b"new").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"new");
        assert_eq!(place.listing(), ["out.csv"]);
    }

    #[test]
    fn a_folder_that_is_not_there_is_named() {
        let error = write_bytes(Path::new("/no/such/folder/out.csv"), b"").unwrap_err().to_string();
        assert!(error.starts_with("cannot write /no/such/folder/out.csv: "), "{error}");
    }
}
