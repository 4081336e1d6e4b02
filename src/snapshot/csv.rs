//! Snapshots as comma-separated values: the table of a report, or one that `--start-file` takes.

use super::table::{AXES, Column, Snapshot};
use super::{SnapshotError, atomic};
use ::csv::{ErrorKind, Position, ReaderBuilder, StringRecord, Trim};
use std::collections::HashMap;
use std::io::BufRead;
use std::path::Path;

/// The column of particles' numbers.
const ID: &str = "id";

/// Writes all columns, each number in the fewest digits that give it back exactly. The box is not written.
///
/// # Errors
/// [`SnapshotError::Io`].
pub fn write(snapshot: &Snapshot, path: &Path) -> Result<(), SnapshotError> {
    let table = snapshot.table()?;
    atomic::write(path, |out| crate::report::write_csv(&table, out))
}

/// Reads a table whose first line that is no comment (`#`) names the columns. Dimensions are as many as there are columns `x`, `y`, `z`;
/// time and units are taken from comments as [`write`] leaves them.
///
/// # Errors
/// [`SnapshotError`] naming line and column.
pub fn read(path: &Path) -> Result<Snapshot, SnapshotError> {
    let bad = |problem: String| SnapshotError::file(path, problem);
    let open = || std::fs::File::open(path).map_err(SnapshotError::io("read", path));
    let comments = Comments::read(std::io::BufReader::new(open()?));
    let mut reader = ReaderBuilder::new().comment(Some(b'#')).trim(Trim::All).from_reader(open()?);
    let names: Vec<String> = reader.headers().map_err(|e| bad(problem(&e)))?.iter().map(String::from).collect();
    if !names.iter().any(|name| name == AXES[0]) {
        let found = names.join(", ");
        return Err(bad(format!("there is no column `x` in its first line, which has {found}; a snapshot needs one")));
    }
    let (mut columns, mut ids) = (vec![Vec::new(); names.len()], Vec::new());
    let mut record = StringRecord::new();
    while reader.read_record(&mut record).map_err(|e| bad(problem(&e)))? {
        let line = record.position().map_or(0, Position::line);
        for ((name, text), values) in names.iter().zip(&record).zip(&mut columns) {
            if name == ID {
                let id = text
                    .parse()
                    .map_err(|_| bad(format!("line {line}: id is `{text}`; it must be a whole number from 0 on")))?;
                ids.push(id);
                continue;
            }
            match text.parse::<f64>() {
                Ok(value) if value.is_finite() => values.push(value),
                _ => return Err(bad(format!("line {line}: {name} is `{text}`; it must be a finite number"))),
            }
        }
    }
    let dimension = AXES.iter().take_while(|axis| names.iter().any(|name| name == *axis)).count();
    let named = names.iter().zip(columns).filter(|(name, _)| *name != ID);
    let columns = named.map(|(name, values)| Column::new(name, comments.unit(name), values)).collect();
    let told = |error: SnapshotError| error.in_file(path);
    let mut snapshot = Snapshot::new(dimension, columns).map_err(told)?;
    if names.iter().any(|name| name == ID) {
        snapshot = snapshot.with_ids(ids).map_err(told)?;
    }
    Ok(match comments.time {
        Some(time) => snapshot.at_time(time),
        None => snapshot,
    })
}

/// What stands before the table.
#[derive(Default)]
struct Comments {
    time: Option<f64>,
    units: HashMap<String, String>,
}

impl Comments {
    fn read(reader: impl BufRead) -> Self {
        let mut comments = Comments::default();
        for line in reader.lines().map_while(Result::ok).take_while(|line| line.starts_with('#')) {
            let line = line.trim_start_matches('#').trim();
            if let Some(time) = line.strip_prefix("time:") {
                comments.time = time.trim().parse().ok();
            }
            if let Some(units) = line.strip_prefix("units:") {
                let entries = units.trim().trim_end_matches(']').split("], ");
                let pairs = entries.filter_map(|entry| entry.split_once(" ["));
                comments.units.extend(pairs.map(|(name, unit)| (name.to_string(), unit.to_string())));
            }
        }
        comments
    }

    fn unit(&self, name: &str) -> String {
        self.units.get(name).cloned().unwrap_or_default()
    }
}

/// What is wrong with a table, in words.
pub fn problem(error: &::csv::Error) -> String {
    let line = |pos: &Option<Position>| pos.as_ref().map_or(0, Position::line);
    match error.kind() {
        ErrorKind::Io(error) => format!("it cannot be read ({error})"),
        ErrorKind::UnequalLengths { pos, expected_len, len } => {
            format!(
                "line {} has {len} values where the first line names {expected_len}; was the file cut short?",
                line(pos)
            )
        }
        ErrorKind::Utf8 { pos, .. } => {
            format!("line {} is not text (UTF-8); is it a table of comma-separated values?", line(pos))
        }
        _ => error.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::{Place, small};
    use super::*;

    fn refused(text: &str) -> String {
        let place = Place::new("csv");
        let path = place.path("a.csv");
        std::fs::write(&path, text).unwrap();
        read(&path).unwrap_err().to_string().split_once("a.csv: ").unwrap().1.to_string()
    }

    #[test]
    fn units_and_time_come_from_the_comments() {
        let place = Place::new("csv-units");
        let path = place.path("a.csv");
        write(&small(2), &path).unwrap();
        let found = read(&path).unwrap();
        assert_eq!(found.time(), Some(0.1));
        assert_eq!(found.columns(), small(2).columns());
        // A start file has neither, nor ids.
        std::fs::write(&path, "mass, x, smoothing_length,internal_energy,mobile\n1,0.5,0.1,2,1\n").unwrap();
        let found = read(&path).unwrap();
        assert_eq!((found.time(), found.ids(), found.column("x")), (None, None, Some(&[0.5][..])));
    }

    #[test]
    fn what_is_wrong_is_named_with_line_and_column() {
        let head = "# made by hand\nid,x,mass\n0,0.5,1\n";
        for (rest, expected) in [
            ("1,0.5,NaN", "line 4: mass is `NaN`; it must be a finite number"),
            ("1,0.5,", "line 4: mass is ``; it must be a finite number"),
            ("-1,0.5,1", "line 4: id is `-1`; it must be a whole number from 0 on"),
            ("1,0.5", "line 4 has 2 values where the first line names 3; was the file cut short?"),
            ("0,0.5,1", "two particles have the id 0; each needs its own"),
        ] {
            assert_eq!(refused(&format!("{head}{rest}\n")), expected);
        }
        assert!(refused("mass,y\n1,2\n").contains("there is no column `x` in its first line, which has mass, y"));
        assert!(refused("x,z\n1,2\n").contains("there is a column `z` in 1 dimensions"));
        assert!(refused("x,x\n1,2\n").contains("two columns `x`"));
        assert!(refused("x\n").contains("there is no particle in it"));
    }
}
