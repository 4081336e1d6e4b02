//! Time series: one row a moment, as comma-separated values, each row on the disk before the run goes on.

use super::SnapshotError;
use std::fs::{File, OpenOptions};
use std::io::{Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// A quantity that is followed through time.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quantity {
    /// Its name: ASCII letters, digits and `_`.
    pub name: String,
    /// Its unit; empty for a pure number. No `[`, `]`, comma or line break.
    pub unit: String,
}

impl Quantity {
    /// A quantity.
    pub fn new(name: impl Into<String>, unit: impl Into<String>) -> Self {
        Quantity { name: name.into(), unit: unit.into() }
    }

    /// As the first line has it: `time [T]`.
    fn heading(&self) -> String {
        if self.unit.is_empty() { self.name.clone() } else { format!("{} [{}]", self.name, self.unit) }
    }

    fn from_heading(text: &str) -> Self {
        match text.strip_suffix(']').and_then(|rest| rest.split_once(" [")) {
            Some((name, unit)) => Quantity::new(name, unit),
            None => Quantity::new(text, ""),
        }
    }

    fn checked(&self, path: &Path) -> Result<(), SnapshotError> {
        let plain = |c: char| c.is_ascii_alphanumeric() || c == '_';
        if self.name.is_empty() || !self.name.chars().all(plain) || self.unit.contains(['[', ']', ',', '\n', '\r', '"'])
        {
            return Err(SnapshotError::file(
                path,
                format!(
                    "a column is called `{}`; a name is made of ASCII letters, digits and `_`, a unit has no brackets or commas",
                    self.heading()
                ),
            ));
        }
        Ok(())
    }
}

/// A file that grows by a row at a time.
#[derive(Debug)]
pub struct SeriesWriter {
    path: PathBuf,
    file: File,
    columns: usize,
}

impl SeriesWriter {
    /// Begins a file with these columns; one that is there is replaced.
    ///
    /// # Errors
    /// [`SnapshotError`]: a name or unit that a line of headings cannot hold; what the system refuses.
    pub fn create(path: &Path, columns: &[Quantity]) -> Result<Self, SnapshotError> {
        columns.iter().try_for_each(|column| column.checked(path))?;
        let mut file = File::create(path).map_err(SnapshotError::io("write", path))?;
        let headings: Vec<String> = columns.iter().map(Quantity::heading).collect();
        writeln!(file, "{}", headings.join(",")).map_err(SnapshotError::io("write", path))?;
        Ok(SeriesWriter { path: path.to_owned(), file, columns: columns.len() })
    }

    /// Goes on with a file that a run left behind: keeps the rows whose first column is at most `until`, which are those the run that is
    /// resumed had written, and drops later ones and a last line that was cut.
    ///
    /// # Errors
    /// As [`Series::read`]; [`SnapshotError::File`] if the file has other columns.
    pub fn resume(path: &Path, columns: &[Quantity], until: f64) -> Result<Self, SnapshotError> {
        let known = Series::read(path)?;
        if known.columns != columns {
            let names = |all: &[Quantity]| all.iter().map(Quantity::heading).collect::<Vec<_>>().join(",");
            let problem = format!("its columns are {}, those of this run {}", names(&known.columns), names(columns));
            return Err(SnapshotError::file(path, format!("{problem}; name another file")));
        }
        let kept = known.rows.iter().take_while(|row| row.first().is_some_and(|time| *time <= until)).count();
        let end = known.ends.get(kept).copied().unwrap_or(0);
        let mut file = OpenOptions::new().write(true).open(path).map_err(SnapshotError::io("write", path))?;
        file.set_len(end).and_then(|()| file.seek(SeekFrom::End(0))).map_err(SnapshotError::io("write", path))?;
        Ok(SeriesWriter { path: path.to_owned(), file, columns: columns.len() })
    }

    /// Appends a row, and hands it to the system before it returns.
    ///
    /// # Errors
    /// [`SnapshotError`]: another number of values than there are columns, one that is not finite; what the system refuses.
    pub fn append(&mut self, row: &[f64]) -> Result<(), SnapshotError> {
        if row.len() != self.columns {
            let problem = format!("a row of {} values was given for {} columns", row.len(), self.columns);
            return Err(SnapshotError::file(&self.path, problem));
        }
        if let Some(place) = row.iter().position(|value| !value.is_finite()) {
            let problem = format!("value {place} of a row is {}; it must be a finite number", row[place]);
            return Err(SnapshotError::file(&self.path, problem));
        }
        let words: Vec<String> = row.iter().map(|value| format!("{value:?}")).collect();
        // In one piece, so that a stop cuts no line but the last.
        let written = self.file.write_all((words.join(",") + "\n").as_bytes()).and_then(|()| self.file.flush());
        written.map_err(SnapshotError::io("write", &self.path))
    }
}

/// A time series that was read back.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// The columns.
    pub columns: Vec<Quantity>,
    /// The rows that are complete.
    pub rows: Vec<Vec<f64>>,
    /// What was cut off the last line, if it was: it is not among the rows.
    pub cut: Option<String>,
    /// Where the headings and each row end, in bytes.
    ends: Vec<u64>,
}

impl Series {
    /// Reads a file. A last line without its end was cut when the program was stopped: it is left out, and said in [`Series::cut`].
    ///
    /// # Errors
    /// [`SnapshotError`] naming the line: no headings; a complete line with other than so many finite numbers.
    pub fn read(path: &Path) -> Result<Self, SnapshotError> {
        let mut text = String::new();
        File::open(path)
            .and_then(|mut file| file.read_to_string(&mut text))
            .map_err(SnapshotError::io("read", path))?;
        Self::parse(&text).map_err(|problem| SnapshotError::file(path, problem))
    }

    fn parse(text: &str) -> Result<Self, String> {
        let Some((headings, _)) = text.split_once('\n') else {
            return Err("it has no line of column names; was it cut short?".into());
        };
        let columns: Vec<Quantity> = headings.trim_end().split(',').map(Quantity::from_heading).collect();
        let mut series = Series { columns, rows: Vec::new(), cut: None, ends: vec![headings.len() as u64 + 1] };
        let mut end = series.ends[0];
        for (line, text) in text.split_inclusive('\n').enumerate().skip(1) {
            end += text.len() as u64;
            let Some(complete) = text.strip_suffix('\n') else {
                series.cut = Some(text.into());
                break;
            };
            let number = |(column, word): (&Quantity, &str)| match word.trim().parse::<f64>() {
                Ok(value) if value.is_finite() => Ok(value),
                _ => Err(format!("line {}: {} is `{word}`; it must be a finite number", line + 1, column.name)),
            };
            let words: Vec<&str> = complete.split(',').collect();
            if words.len() != series.columns.len() {
                let wanted = series.columns.len();
                return Err(format!(
                    "line {} has {} values where the first line names {wanted}",
                    line + 1,
                    words.len()
                ));
            }
            series.rows.push(series.columns.iter().zip(words).map(number).collect::<Result<_, _>>()?);
            series.ends.push(end);
        }
        Ok(series)
    }

    /// The values of a column.
    pub fn column(&self, name: &str) -> Option<Vec<f64>> {
        let place = self.columns.iter().position(|column| column.name == name)?;
        Some(self.rows.iter().map(|row| row[place]).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::Place;
    use super::*;

    fn columns() -> Vec<Quantity> {
        vec![Quantity::new("time", "T"), Quantity::new("kinetic_energy", "M L^2 T^-2"), Quantity::new("steps", "")]
    }

    #[test]
    fn rows_are_there_as_soon_as_they_are_appended() {
        let place = Place::new("series");
        let path = place.path("a.csv");
        let mut writer = SeriesWriter::create(&path, &columns()).unwrap();
        writer.append(&[0.0, 1.0 / 3.0, 0.0]).unwrap();
        writer.append(&[0.1, 5e-324, 7.0]).unwrap();
        // The writer is still open: nothing waits in it.
        let found = Series::read(&path).unwrap();
        assert_eq!(found.columns, columns());
        assert_eq!(found.rows, [[0.0, 1.0 / 3.0, 0.0], [0.1, 5e-324, 7.0]]);
        assert_eq!((found.column("steps"), found.column("mass"), found.cut), (Some(vec![0.0, 7.0]), None, None));
        assert!(std::fs::read_to_string(&path).unwrap().starts_with("time [T],kinetic_energy [M L^2 T^-2],steps\n"));
    }

    /// Wherever a stop cuts the file, all rows before are kept and the last is not taken for one.
    #[test]
    fn a_cut_last_line_is_left_out_and_said() {
        let whole = "time [T],energy\n0.0,1.5\n0.1,2.5\n";
        for length in 16..whole.len() {
            let found = Series::parse(&whole[..length]).unwrap();
            let complete = whole[..length].matches('\n').count() - 1;
            assert_eq!(found.rows, [[0.0, 1.5], [0.1, 2.5]][..complete]);
            assert_eq!(found.cut.is_some(), !whole[..length].ends_with('\n'), "{length}");
        }
        assert!(Series::parse("time [T]").unwrap_err().contains("no line of column names"));
    }

    #[test]
    fn a_resumed_series_has_no_row_twice_and_none_of_a_lost_future() {
        let place = Place::new("series-resume");
        let path = place.path("a.csv");
        let mut writer = SeriesWriter::create(&path, &columns()).unwrap();
        for step in 0..4 {
            writer.append(&[0.1 * f64::from(step), 1.0, f64::from(step)]).unwrap();
        }
        writer.file.write_all(b"0.4,1").unwrap();
        drop(writer);
        // The restart file was written at step 2.
        let mut writer = SeriesWriter::resume(&path, &columns(), 0.2).unwrap();
        writer.append(&[0.3, 9.0, 3.0]).unwrap();
        let found = Series::read(&path).unwrap();
        assert_eq!(found.column("steps").unwrap(), [0.0, 1.0, 2.0, 3.0]);
        assert_eq!(found.column("kinetic_energy").unwrap()[3], 9.0);
        let error = SeriesWriter::resume(&path, &columns()[..2], 0.2).unwrap_err().to_string();
        assert!(error.contains("name another file"), "{error}");
    }

    #[test]
    fn what_is_wrong_is_named_with_its_line() {
        assert_eq!(Series::parse("time,e\n0,1\n0\n").unwrap_err(), "line 3 has 1 values where the first line names 2");
        assert_eq!(Series::parse("time,e\n0,NaN\n").unwrap_err(), "line 2: e is `NaN`; it must be a finite number");
        let place = Place::new("series-bad");
        let path = place.path("a.csv");
        let named =
            |name: &str, unit: &str| SeriesWriter::create(&path, &[Quantity::new(name, unit)]).unwrap_err().to_string();
        assert!(named("a b", "").contains("`a b`") && named("a", "x,y").contains("no brackets or commas"));
        let mut writer = SeriesWriter::create(&path, &columns()).unwrap();
        assert!(writer.append(&[0.0]).unwrap_err().to_string().contains("a row of 1 values was given for 3 columns"));
        assert!(writer.append(&[0.0, f64::INFINITY, 0.0]).unwrap_err().to_string().contains("value 1 of a row is inf"));
    }
}
