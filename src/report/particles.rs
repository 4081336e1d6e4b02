//! The particles at the end, as a table of comma-separated values.

use std::io::{self, Write};

use super::ReportError;

/// One column of the particle table.
#[derive(Clone, Copy, Debug)]
pub struct Column<'a> {
    /// Name, for example `velocity_x`: ASCII letters, digits and `_`.
    pub name: &'a str,
    /// Unit, in words or symbols.
    pub unit: &'a str,
    /// One value a particle.
    pub values: &'a [f64],
}

/// Particles as columns; the row number is the particle's identity, unless it is said otherwise.
#[derive(Clone, Debug)]
pub struct Particles<'a> {
    columns: Vec<Column<'a>>,
    rows: usize,
    /// The particles' numbers, one a row, where they are not those of their rows.
    pub ids: Option<&'a [u64]>,
    /// The time, where it is to be written.
    pub time: Option<f64>,
}

impl<'a> Particles<'a> {
    /// A table of columns of equal length. Columns named `x`, `y` and `z` are positions; those that are missing are
    /// taken as zero where a format wants them.
    ///
    /// # Errors
    /// [`ReportError::Inconsistent`] if lengths differ, a name is not plain or appears twice, or there is no `x`;
    /// [`ReportError::NotFinite`] naming column and row.
    pub fn new(columns: Vec<Column<'a>>) -> Result<Self, ReportError> {
        let Some(x) = columns.iter().find(|column| column.name == "x") else {
            return Err(ReportError::inconsistent("particles", "there is no column `x`"));
        };
        let rows = x.values.len();
        for (index, column) in columns.iter().enumerate() {
            let path = format!("particles.{}", column.name);
            let plain = |c: char| c.is_ascii_alphanumeric() || c == '_';
            if column.name.is_empty() || column.name == "id" || !column.name.chars().all(plain) {
                let problem = "a column's name is made of ASCII letters, digits and `_`, and is not `id`";
                return Err(ReportError::inconsistent(path, problem));
            }
            if columns[..index].iter().any(|other| other.name == column.name) {
                return Err(ReportError::inconsistent(path, "there are two columns of that name"));
            }
            if column.values.len() != rows {
                let problem = format!("it has {} entries where `x` has {rows}", column.values.len());
                return Err(ReportError::inconsistent(path, problem));
            }
            if let Some(row) = column.values.iter().position(|value| !value.is_finite()) {
                return Err(ReportError::NotFinite { path: format!("{path}[{row}]") });
            }
        }
        Ok(Self { columns, rows, ids: None, time: None })
    }

    /// Number of particles.
    pub fn len(&self) -> usize {
        self.rows
    }

    /// Whether there are no particles.
    pub fn is_empty(&self) -> bool {
        self.rows == 0
    }

    /// The number of the particle in a row.
    pub(super) fn id(&self, row: usize) -> u64 {
        self.ids.and_then(|ids| ids.get(row).copied()).unwrap_or(row as u64)
    }

    /// All columns.
    pub fn columns(&self) -> &[Column<'a>] {
        &self.columns
    }

    /// The column of that name.
    pub(super) fn column(&self, name: &str) -> Option<&Column<'a>> {
        self.columns.iter().find(|column| column.name == name)
    }
}

/// Writes a comment line with the time where there is one, another with the units, a line with the names, and one line a particle: `id` and every column, each
/// number in the fewest digits that give it back exactly.
///
/// # Errors
/// Whatever `out` returns.
pub fn write_csv(particles: &Particles, out: &mut impl Write) -> io::Result<()> {
    let names: Vec<&str> = particles.columns().iter().map(|column| column.name).collect();
    // A line break within a unit would end the comment.
    let one_line = |unit: &str| unit.replace(['\n', '\r'], " ");
    let units: Vec<String> =
        particles.columns().iter().map(|column| format!("{} [{}]", column.name, one_line(column.unit))).collect();
    if let Some(time) = particles.time {
        writeln!(out, "# time: {time:?}")?;
    }
    writeln!(out, "# units: {}", units.join(", "))?;
    writeln!(out, "id,{}", names.join(","))?;
    for row in 0..particles.len() {
        write!(out, "{}", particles.id(row))?;
        for column in particles.columns() {
            write!(out, ",{:?}", column.values[row])?;
        }
        writeln!(out)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn column<'a>(name: &'a str, values: &'a [f64]) -> Column<'a> {
        Column { name, unit: "L", values }
    }

    #[test]
    fn csv_has_units_names_and_exact_numbers() {
        let (x, density) = ([0.1, -2.0], [1.0 / 3.0, 5e-324]);
        let density_column = Column { name: "density", unit: "ρ₀\n1,2", values: &density };
        let table = Particles::new(vec![column("x", &x), density_column]).unwrap();
        let mut out = Vec::new();
        write_csv(&table, &mut out).unwrap();
        let text = String::from_utf8(out).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines[0], "# units: x [L], density [ρ₀ 1,2]");
        assert_eq!(lines[1], "id,x,density");
        assert_eq!(lines.len(), 4);
        let last: Vec<&str> = lines[3].split(',').collect();
        assert_eq!((last[0], last[1]), ("1", "-2.0"));
        assert_eq!(last[2].parse::<f64>().unwrap(), 5e-324);
        assert_eq!(lines[2].split(',').nth(2).unwrap().parse::<f64>().unwrap(), 1.0 / 3.0);
    }

    #[test]
    fn bad_tables_are_refused_by_name() {
        let message = |columns| Particles::new(columns).unwrap_err().to_string();
        let two = [1.0, 2.0];
        assert!(message(vec![column("density", &two)]).contains("no column `x`"));
        assert!(message(vec![column("x", &two), column("density", &[1.0])]).contains("density: it has 1"));
        assert!(message(vec![column("x", &two), column("x", &two)]).contains("two columns"));
        assert!(message(vec![column("x", &two), column("a\"b", &two)]).contains("ASCII letters"));
        let spoilt = [0.0, f64::NAN];
        assert!(message(vec![column("x", &two), column("pressure", &spoilt)]).contains("particles.pressure[1] is not"));
    }
}
