//! One mutant before its tests.

use crate::binary::Binary;
use crate::coverage::Reach;
use crate::error::Error;
use serde::{Deserialize, Serialize};
use std::process::ExitStatus;
use std::time::{Duration, Instant};

/// The status with which the test program says that the mutant makes no sense for the types it met.
const NO_MUTANT: i32 = 77;

/// What became of a mutant.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Outcome {
    /// This test failed.
    Caught(String),
    /// This test did not end.
    TimedOut(String),
    /// All tests passed that reach the equation.
    Missed,
    /// It makes no sense for the types in question, so it is none.
    None,
}

/// Runs the tests that reach the equation, one by one, until one fails.
pub fn judge(binary: &Binary, mutant: &str, tests: &[&Reach]) -> Result<Outcome, Error> {
    for reach in tests {
        let mut command = binary.command(&["--exact", &reach.test, "--test-threads", "1"]);
        let mut child = command.env("ETALON_MUTANT", mutant).spawn().map_err(|source| binary.start(source))?;
        // A fault may cost time, but not this much.
        let limit = Duration::from_secs(10) + reach.duration * 20;
        let start = Instant::now();
        let status = loop {
            match child.try_wait().map_err(|source| binary.start(source))? {
                Some(status) => break Some(status),
                None if start.elapsed() > limit => break None,
                None => std::thread::sleep(Duration::from_millis(1)),
            }
        };
        match status.map(verdict) {
            Some(Verdict::Passed) => {}
            Some(Verdict::NoMutant) => return Ok(Outcome::None),
            Some(Verdict::Failed) => return Ok(Outcome::Caught(reach.test.clone())),
            None => {
                child.kill().and_then(|()| child.wait()).map_err(|source| binary.start(source))?;
                return Ok(Outcome::TimedOut(reach.test.clone()));
            }
        }
    }
    Ok(Outcome::Missed)
}

enum Verdict {
    Passed,
    Failed,
    NoMutant,
}

/// A crash is a failure too.
fn verdict(status: ExitStatus) -> Verdict {
    match status.code() {
        Some(0) => Verdict::Passed,
        Some(NO_MUTANT) => Verdict::NoMutant,
        _ => Verdict::Failed,
    }
}
