//! The test program of the equations, built once with all mutants in it.

use crate::error::Error;
use crate::mutant::Equation;
use crate::places;
use std::path::PathBuf;
use std::process::{Command, Stdio};

/// The test that lists the mutants; it is none itself.
const LIST: &str = "mutants::list";

/// The test program.
#[derive(Debug)]
pub struct Binary {
    path: PathBuf,
}

impl Binary {
    /// Builds it, with cargo's messages on standard error.
    pub fn build() -> Result<Self, Error> {
        let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_string());
        let output = Command::new(&cargo)
            .current_dir(places::root())
            .args(["test", "-p", "etalon-reference", "--features", "mutants", "--test", "equations", "--no-run"])
            // A folder of its own, so that what is built without mutants stays built.
            .args(["--target-dir", "target/mutants", "--message-format", "json-render-diagnostics"])
            .stderr(Stdio::inherit())
            .output()
            .map_err(|source| Error::Start { program: cargo, source })?;
        if !output.status.success() {
            return Err(Error::Build);
        }
        let text = String::from_utf8_lossy(&output.stdout);
        let path = text.lines().rev().find_map(executable).ok_or(Error::Build)?;
        Ok(Binary { path })
    }

    /// The program with some arguments, run where cargo would run it.
    pub fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(&self.path);
        // Tests must not write into the tree because a fault made them fail.
        command.current_dir(places::reference()).args(arguments);
        command.env("INSTA_UPDATE", "no").env("PROPTEST_DISABLE_FAILURE_PERSISTENCE", "1");
        command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
        command
    }

    fn output(&self, arguments: &[&str]) -> Result<String, Error> {
        let output = self.command(arguments).stdout(Stdio::piped()).output().map_err(|source| self.start(source))?;
        Ok(String::from_utf8_lossy(&output.stdout).into_owned())
    }

    /// It could not be started.
    pub fn start(&self, source: std::io::Error) -> Error {
        Error::Start { program: self.path.display().to_string(), source }
    }

    /// All equations with their mutants, by path.
    pub fn equations(&self) -> Result<Vec<Equation>, Error> {
        let text = self.output(&["--exact", LIST, "--ignored", "--nocapture"])?;
        let lines = text.lines().filter_map(|line| line.find("{\"equation\"").map(|start| &line[start..]));
        let equations = lines.map(Equation::parse).collect::<Result<Vec<_>, _>>()?;
        match equations.is_empty() {
            true => Err(Error::Unreadable { what: format!("no equation in the list of `{LIST}`: {text}") }),
            false => Ok(equations),
        }
    }

    /// The names of all tests.
    pub fn tests(&self) -> Result<Vec<String>, Error> {
        let text = self.output(&["--list", "--format", "terse"])?;
        let names = text.lines().filter_map(|line| line.strip_suffix(": test"));
        Ok(names.filter(|name| *name != LIST).map(str::to_string).collect())
    }
}

/// The test program, if this line of cargo's messages is the one that names it.
fn executable(line: &str) -> Option<PathBuf> {
    let message: serde_json::Value = serde_json::from_str(line).ok()?;
    let is_test = message["target"]["name"] == "equations" && message["reason"] == "compiler-artifact";
    if is_test { message["executable"].as_str().map(PathBuf::from) } else { None }
}
