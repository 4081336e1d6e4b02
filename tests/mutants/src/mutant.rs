//! The mutants of the equations.

use crate::error::Error;
use crate::places;
use serde::Deserialize;
use std::collections::HashMap;

/// An equation and its mutants.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Equation {
    /// Module and name, such as `dissipation::pair_viscosity`.
    pub path: String,
    /// As the test program knows it.
    pub full_path: String,
    /// The source file, from the root.
    pub file: String,
    /// All mutants; number 1 first.
    pub mutants: Vec<Mutant>,
}

/// One fault.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mutant {
    /// Its number within the equation, from 1.
    pub number: u32,
    /// What kind of fault.
    pub operator: String,
    /// The line it is on, from 1.
    pub line: usize,
    /// The text of that line.
    pub code: String,
    /// What becomes of what: `a + b → a - b`; with ` (2)` where that is the second such change on the line.
    pub change: String,
}

#[derive(Deserialize)]
struct Listed {
    equation: String,
    file: String,
    mutants: Vec<ListedMutant>,
}

/// One fault as the macro knows it.
#[derive(Clone, Debug, Deserialize)]
pub struct ListedMutant {
    /// What kind of fault.
    pub operator: String,
    /// What the author wrote.
    pub original: String,
    /// What it becomes.
    pub mutated: String,
    /// The line it is on, from 1.
    pub line: usize,
}

impl Equation {
    /// Reads one line of the test program's list.
    pub fn parse(line: &str) -> Result<Self, Error> {
        let listed: Listed =
            serde_json::from_str(line).map_err(|error| Error::Unreadable { what: format!("{line}: {error}") })?;
        let path = places::root().join(&listed.file);
        let source = std::fs::read_to_string(&path).map_err(Error::file(path))?;
        Ok(Equation::new(listed.equation, listed.file, &source, listed.mutants))
    }

    /// An equation by its full path, in a file with this text.
    pub fn new(full_path: String, file: String, source: &str, listed: Vec<ListedMutant>) -> Self {
        let lines: Vec<&str> = source.lines().collect();
        let mut seen: HashMap<(usize, String), usize> = HashMap::new();
        let mutants = listed.into_iter().zip(1..).map(|(mutant, number)| {
            let change = format!("{} → {}", mutant.original, mutant.mutated);
            let times = seen.entry((mutant.line, change.clone())).or_default();
            *times += 1;
            let change = if *times > 1 { format!("{change} ({times})") } else { change };
            let code = lines.get(mutant.line.wrapping_sub(1)).map_or("", |line| line.trim()).to_string();
            Mutant { number, operator: mutant.operator, line: mutant.line, code, change }
        });
        let mutants = mutants.collect();
        Equation { path: short(&full_path), full_path, file, mutants }
    }

    /// Changes when any of its mutants does, so that results of another text are not taken for results of this one.
    pub fn fingerprint(&self) -> String {
        // FNV-1a, 64 bits: the same on every machine and with every version of the standard library.
        let mut hash = 0xcbf2_9ce4_8422_2325_u64;
        for mutant in &self.mutants {
            for byte in mutant.code.bytes().chain([0]).chain(mutant.change.bytes()).chain([0]) {
                hash = (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
            }
        }
        format!("{hash:016x}")
    }
}

/// Without the crate and the folder that all equations are in.
fn short(path: &str) -> String {
    let without_crate = path.split_once("::").map_or(path, |(_, rest)| rest);
    without_crate.strip_prefix("equations::").unwrap_or(without_crate).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_changes_on_a_line_are_told_apart() {
        let change = r#"{"operator":"constant","original":"0.0","mutated":"1.0","line":1,"column":1}"#;
        let line = format!(
            r#"{{"equation":"etalon_reference::equations::a::b","file":"reference/src/lib.rs","mutants":[{change},{change}]}}"#
        );
        let equation = Equation::parse(&line).unwrap();
        assert_eq!(equation.path, "a::b");
        let changes: Vec<_> = equation.mutants.iter().map(|mutant| mutant.change.as_str()).collect();
        assert_eq!(changes, ["0.0 → 1.0", "0.0 → 1.0 (2)"]);
        assert_eq!(equation.mutants[1].number, 2);
        let mut other = equation.clone();
        other.mutants[0].change.push('!');
        assert_ne!(equation.fingerprint(), other.fingerprint());
    }
}
