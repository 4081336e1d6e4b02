//! Would the tests notice? Switches on one fault of an equation after the other and runs the tests that reach it.
//!
//! `docs/mutants.md` says how to use it and has the last result.
#![forbid(unsafe_code)]

mod arguments;
mod binary;
mod coverage;
mod equivalent;
mod error;
mod judge;
mod mutant;
mod page;
mod places;
mod record;
mod run;
mod source;
mod summary;

use arguments::Arguments;
use clap::Parser;
use error::Error;
use std::process::ExitCode;

fn main() -> ExitCode {
    match work(&Arguments::parse()) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::from(1),
        Err(error) => {
            eprintln!("{error}");
            ExitCode::from(2)
        }
    }
}

/// Whether all is well: every mutant caught or equivalent, and every file as it should be.
fn work(arguments: &Arguments) -> Result<bool, Error> {
    let equations = source::equations()?;
    let chosen: Vec<_> = equations.iter().filter(|equation| arguments.wants(&equation.path)).collect();
    if chosen.is_empty() {
        return Err(Error::NothingChosen { only: arguments.only.join(", ") });
    }
    if arguments.list {
        for equation in chosen {
            for mutant in &equation.mutants {
                let (path, file) = (&equation.path, &equation.file);
                println!("{path}#{}  {file}:{}  {}  {}", mutant.number, mutant.line, mutant.operator, mutant.change);
            }
        }
        return Ok(true);
    }
    let mut record = record::Record::read()?;
    if !arguments.check {
        let binary = binary::Binary::build()?;
        if binary.equations()? != equations {
            return Err(Error::Differs);
        }
        run::run(&binary, &equations, &chosen, arguments, &mut record)?;
    }
    let summary = summary::Summary::new(&equations, &record, &equivalent::read()?, &source::Tests::read()?);
    if arguments.json {
        let text = serde_json::to_string_pretty(&summary).map_err(|e| Error::Unreadable { what: e.to_string() })?;
        println!("{text}");
    } else {
        print!("{}", summary.text());
    }
    let page = page::page(&summary);
    let is_current = if arguments.check {
        let current = page::is_current(&page)?;
        if !current {
            println!("docs/mutants.md is not what the record says: run `cargo run -p etalon-mutants`");
        }
        current
    } else {
        page::write(&page)?;
        true
    };
    Ok(summary.is_good() && is_current)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As `--check` does. It reads source and record and compiles nothing, so that it can be one of the workspace's tests.
    #[test]
    fn every_mutant_is_caught_or_excused_and_the_page_says_so() {
        let equations = source::equations().unwrap();
        assert!(equations.len() > 100, "{} equations", equations.len());
        let record = record::Record::read().unwrap();
        let tests = source::Tests::read().unwrap();
        let summary = summary::Summary::new(&equations, &record, &equivalent::read().unwrap(), &tests);
        assert!(summary.is_good(), "run `cargo run -p etalon-mutants`, see docs/mutants.md:\n{}", summary.text());
        let is_current = page::is_current(&page::page(&summary)).unwrap();
        assert!(is_current, "docs/mutants.md is not what the record says: run `cargo run -p etalon-mutants`");
    }
}
