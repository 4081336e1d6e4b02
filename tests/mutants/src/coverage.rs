//! Which equations each test reaches, found by running each test once.

use crate::binary::Binary;
use crate::error::Error;
use std::collections::BTreeSet;
use std::time::{Duration, Instant};

/// What one test does.
#[derive(Clone, Debug)]
pub struct Reach {
    /// Its name.
    pub test: String,
    /// Full paths of the equations that ran.
    pub equations: BTreeSet<String>,
    /// How long it took.
    pub duration: Duration,
}

/// Runs every test by itself. The most particular come first: those that reach the fewest equations.
pub fn coverage(binary: &Binary, tests: &[String], done: &dyn Fn()) -> Result<Vec<Reach>, Error> {
    let file = std::env::temp_dir().join(format!("etalon-mutants-{}", std::process::id()));
    let mut all = Vec::new();
    for test in tests {
        std::fs::write(&file, "").map_err(Error::file(&file))?;
        let start = Instant::now();
        let mut command = binary.command(&["--exact", test, "--test-threads", "1"]);
        let status = command.env("ETALON_MUTANTS_REACHED", &file).env_remove("ETALON_MUTANT").status();
        if !status.map_err(|source| binary.start(source))?.success() {
            return Err(Error::Failing { test: test.clone() });
        }
        let duration = start.elapsed();
        let text = std::fs::read_to_string(&file).map_err(Error::file(&file))?;
        let equations = text.lines().map(str::to_string).collect();
        all.push(Reach { test: test.clone(), equations, duration });
        done();
    }
    std::fs::remove_file(&file).map_err(Error::file(&file))?;
    // Not by duration, which would make every record another.
    all.sort_by(|a: &Reach, b| (a.equations.len(), &a.test).cmp(&(b.equations.len(), &b.test)));
    Ok(all)
}
