//! Particles that a user made, read from comma-separated values.

use super::failure::Failure;
use crate::snapshot::csv_problem;
use csv::{ReaderBuilder, StringRecord, Trim};
use etalon_reference::particles::Particle;
use std::io::Read;
use std::path::{Path, PathBuf};

const POSITION: [&str; 3] = ["x", "y", "z"];
const VELOCITY: [&str; 3] = ["velocity_x", "velocity_y", "velocity_z"];
const MASS: &str = "mass";
const SMOOTHING_LENGTH: &str = "smoothing_length";
const INTERNAL_ENERGY: &str = "internal_energy";
const MOBILE: &str = "mobile";

/// The tube's units are of order one: what is beyond this, or below its inverse, leaves single precision sooner or later.
const LARGEST: f64 = 1e12;

/// Initial particles from a file, checked number by number.
///
/// The first line that is no comment (`#`) names the columns, in any order: `x` (`y`, `z`), `mass`, `smoothing_length`,
/// `internal_energy`; `velocity_x` (`_y`, `_z`) where it is not zero; `mobile`, 1 or 0, where walls are among them. Others are passed over.
#[derive(Clone, Debug)]
pub struct StartFile {
    path: PathBuf,
    particles: Vec<Particle<3>>,
}

impl StartFile {
    /// Reads the columns that so many dimensions need.
    ///
    /// # Errors
    /// Exit code 2, naming file, line and column: a file that cannot be read, a column missing or there twice, a line cut short, a number
    /// that is none or not finite, one that must be positive and is not.
    pub fn read(path: &Path, dimension: usize) -> Result<Self, Failure> {
        let file = std::fs::File::open(path).map_err(|error| {
            Failure::BadInput(format!("--start-file {}: it cannot be read ({error})", path.display()))
        })?;
        Self::parse(path, dimension, file)
    }

    fn parse(path: &Path, dimension: usize, file: impl Read) -> Result<Self, Failure> {
        let shown = path.display();
        let unreadable =
            |error: csv::Error| Failure::BadInput(format!("--start-file {shown}: {}", csv_problem(&error)));
        let mut reader = ReaderBuilder::new().comment(Some(b'#')).trim(Trim::All).from_reader(file);
        let columns = Columns::of(reader.headers().map_err(unreadable)?, dimension)
            .map_err(|text| Failure::BadInput(format!("--start-file {shown}: {text}")))?;
        let mut particles = Vec::new();
        let mut record = StringRecord::new();
        while reader.read_record(&mut record).map_err(unreadable)? {
            let line = record.position().map_or(0, csv::Position::line);
            let particle = columns
                .particle(&record)
                .map_err(|text| Failure::BadInput(format!("--start-file {shown}, line {line}: {text}")))?;
            particles.push(particle);
        }
        if !particles.iter().any(|p| p.mobile) {
            return Err(Failure::BadInput(format!(
                "--start-file {shown}: no particle in it can move; give at least one"
            )));
        }
        Ok(StartFile { path: path.to_path_buf(), particles })
    }

    /// Where it was read from.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// How many particles move.
    pub fn mobile(&self) -> usize {
        self.particles.iter().filter(|p| p.mobile).count()
    }

    /// The particles, with as many axes as were read.
    pub fn particles<const D: usize>(&self) -> Vec<Particle<D>> {
        let axes = |all: [f64; 3]| std::array::from_fn(|axis| all[axis]);
        let particle = |p: &Particle<3>| Particle {
            position: axes(p.position),
            velocity: axes(p.velocity),
            mass: p.mass,
            smoothing_length: p.smoothing_length,
            internal_energy: p.internal_energy,
            mobile: p.mobile,
        };
        self.particles.iter().map(particle).collect()
    }
}

/// Where the columns are.
struct Columns {
    position: Vec<usize>,
    velocity: Vec<Option<usize>>,
    mass: usize,
    smoothing_length: usize,
    internal_energy: usize,
    mobile: Option<usize>,
}

impl Columns {
    fn of(header: &StringRecord, dimension: usize) -> Result<Self, String> {
        let optional = |name: &str| {
            let mut places = header.iter().enumerate().filter(|(_, column)| *column == name).map(|(place, _)| place);
            let place = places.next();
            match places.next() {
                Some(_) => Err(format!("there are two columns `{name}`; keep one")),
                None => Ok(place),
            }
        };
        let required = |name: &str| {
            optional(name)?.ok_or_else(|| {
                let found: Vec<&str> = header.iter().collect();
                format!("there is no column `{name}` in its first line, which has {}; add it", found.join(", "))
            })
        };
        Ok(Columns {
            position: POSITION[..dimension].iter().map(|name| required(name)).collect::<Result<_, _>>()?,
            velocity: VELOCITY[..dimension].iter().map(|name| optional(name)).collect::<Result<_, _>>()?,
            mass: required(MASS)?,
            smoothing_length: required(SMOOTHING_LENGTH)?,
            internal_energy: required(INTERNAL_ENERGY)?,
            mobile: optional(MOBILE)?,
        })
    }

    fn particle(&self, record: &StringRecord) -> Result<Particle<3>, String> {
        let number = |place: usize, name: &str| {
            let text = record.get(place).unwrap_or("");
            match text.parse::<f64>() {
                Ok(value) if value.abs() <= LARGEST => Ok(value),
                Ok(value) if value.is_finite() => {
                    Err(format!("{name} is {value:e}; it must be at most {LARGEST:e} in size"))
                }
                _ => Err(format!("{name} is `{text}`; it must be a finite number")),
            }
        };
        let positive = |place: usize, name: &str| match number(place, name)? {
            value if value <= 0.0 => Err(format!("{name} is {value}; it must be positive")),
            value if !(1.0 / LARGEST..=LARGEST).contains(&value) => {
                Err(format!("{name} is {value}; it must be between {:e} and {LARGEST:e}", 1.0 / LARGEST))
            }
            value => Ok(value),
        };
        let mut particle = Particle {
            position: [0.0; 3],
            velocity: [0.0; 3],
            mass: positive(self.mass, MASS)?,
            smoothing_length: positive(self.smoothing_length, SMOOTHING_LENGTH)?,
            internal_energy: number(self.internal_energy, INTERNAL_ENERGY)?,
            mobile: true,
        };
        if particle.internal_energy < 0.0 {
            return Err(format!("{INTERNAL_ENERGY} is {}; it must not be negative", particle.internal_energy));
        }
        for (axis, &place) in self.position.iter().enumerate() {
            particle.position[axis] = number(place, POSITION[axis])?;
        }
        for (axis, place) in self.velocity.iter().enumerate() {
            particle.velocity[axis] = place.map_or(Ok(0.0), |place| number(place, VELOCITY[axis]))?;
        }
        if let Some(place) = self.mobile {
            particle.mobile = match record.get(place).unwrap_or("") {
                "1" => true,
                "0" => false,
                other => return Err(format!("{MOBILE} is `{other}`; it must be 1, or 0 for a wall")),
            };
        }
        Ok(particle)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str, dimension: usize) -> Result<StartFile, String> {
        StartFile::parse(Path::new("particles.csv"), dimension, text.as_bytes()).map_err(|error| error.to_string())
    }

    #[test]
    fn columns_come_in_any_order_and_others_are_passed_over() {
        let text = "# units: L\nid, mass,x, y,smoothing_length,internal_energy,velocity_y,mobile\n\
                    0, 1.5,0.25,0.5,0.1,2,-3e-1,1\n1,1,-0.25,0.5,0.1,2,0,0\n";
        let file = read(text, 2).unwrap();
        let particles = file.particles::<2>();
        assert_eq!((particles.len(), file.mobile()), (2, 1));
        assert_eq!((particles[0].position, particles[0].velocity, particles[0].mass), ([0.25, 0.5], [0.0, -0.3], 1.5));
        assert!(particles[0].mobile && !particles[1].mobile);
    }

    #[test]
    fn what_is_wrong_is_named_with_line_column_and_remedy() {
        let head = "x,mass,smoothing_length,internal_energy,mobile\n0.5,1,0.1,1,1\n";
        for (text, dimension, expected) in [
            ("0.5,NaN,0.1,1,1", 1, "line 3: mass is `NaN`; it must be a finite number"),
            ("inf,1,0.1,1,1", 1, "line 3: x is `inf`"),
            ("0.5,,0.1,1,1", 1, "line 3: mass is ``"),
            ("0.5,1,0,1,1", 1, "line 3: smoothing_length is 0; it must be positive"),
            ("0.5,1,0.1,-1,1", 1, "internal_energy is -1; it must not be negative"),
            ("0.5,1,0.1,1,yes", 1, "mobile is `yes`; it must be 1, or 0 for a wall"),
            ("1e300,1,0.1,1,1", 1, "line 3: x is 1e300; it must be at most 1e12 in size"),
            (
                "0.5,1e-30,0.1,1,1",
                1,
                "line 3: mass is 0.000000000000000000000000000001; it must be between 1e-12 and 1e12",
            ),
            ("0.5,1,0.1", 1, "line 3 has 3 values where the first line names 5; was the file cut short?"),
            ("0.5,1,0.1,1,1", 2, "there is no column `y`"),
        ] {
            let message = read(&format!("{head}{text}\n"), dimension).unwrap_err();
            assert!(message.contains(expected), "{message}");
        }
        assert!(read("x,x,mass,smoothing_length,internal_energy\n", 1).unwrap_err().contains("two columns `x`"));
        assert!(
            read("x,mass,smoothing_length,internal_energy\n", 1).unwrap_err().contains("no particle in it can move")
        );
        let bytes: &[u8] = &[head.as_bytes(), b"0.5,1,0.1,\xff,1\n"].concat();
        let message = StartFile::parse(Path::new("particles.csv"), 1, bytes).unwrap_err().to_string();
        assert!(message.contains("line 3 is not text"), "{message}");
        assert!(read("", 1).unwrap_err().contains("there is no column `x`"));
        let missing = StartFile::read(Path::new("/no/such/file.csv"), 1).unwrap_err().to_string();
        assert!(missing.contains("/no/such/file.csv: it cannot be read"), "{missing}");
    }
}
