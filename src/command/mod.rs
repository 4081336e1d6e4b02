//! The program `etalon`: `run`, `scenes`, `explain`, `emit`, `bench`, `compare`, `audit`, `show`, `pages`.
//!
//! Results go to stdout, progress and errors to stderr. Nothing is written to disk before it is complete.

mod arguments;
mod audit;
mod bench;
mod choices;
mod compare;
mod emit;
mod explain;
mod failure;
mod machine;
mod memory;
mod pages;
mod pareto;
mod reproduce;
mod restarts;
mod run;
mod scene_file;
mod scenes;
mod setup;
mod show;
mod start_file;
mod sweep;

use arguments::{Arguments, Command};
use clap::Parser;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use failure::Failure;
use std::error::Error;
use std::ffi::OsString;
use std::io::{ErrorKind as IoErrorKind, Write};
use std::process::ExitCode;

/// Runs the program with these arguments, the program's name first; returns its exit code.
///
/// 0: done, and every comparison lies within its tolerance; 1: one does not, or a run broke down, or a record or page is no longer
/// true; 2: bad input.
pub fn main(arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    let arguments = match Arguments::try_parse_from(arguments) {
        Ok(arguments) => arguments,
        Err(error) => return refused(&error),
    };
    let done = match arguments.command {
        Command::Run(arguments) => run::run(&arguments),
        Command::Scenes(arguments) => scenes::scenes(&arguments).map(Done::passed),
        Command::Explain(arguments) => explain::explain(&arguments).map(Done::passed),
        Command::Emit(arguments) => emit::emit(&arguments).map(Done::passed),
        Command::Bench(arguments) => bench::bench(&arguments).map(Done::passed),
        Command::Compare(arguments) => compare::compare(&arguments),
        Command::Audit(arguments) => audit::audit(&arguments),
        Command::Show(arguments) => show::show(&arguments).map(Done::passed),
        Command::Pages(arguments) => pages::pages(&arguments),
        Command::Pareto(arguments) => pareto::pareto(&arguments),
        Command::Reproduce(arguments) => reproduce::reproduce(&arguments),
    };
    finished(done)
}

/// Prints what a command came to; its exit code.
fn finished(done: Result<Done, Failure>) -> ExitCode {
    match done {
        Ok(done) => match print(&done.text) {
            Ok(()) if done.passed => ExitCode::SUCCESS,
            Ok(()) => ExitCode::from(1),
            Err(failure) => say(&failure),
        },
        Err(failure) => say(&failure),
    }
}

/// What a command came to.
struct Done {
    /// For stdout.
    text: String,
    /// Whether every comparison lies within its tolerance.
    passed: bool,
}

impl Done {
    fn passed(text: String) -> Self {
        Done { text, passed: true }
    }
}

/// To stdout; a reader who has seen enough (`| head`) is no error.
fn print(text: &str) -> Result<(), Failure> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != IoErrorKind::BrokenPipe => {
            Err(Failure::Broken(format!("cannot write to standard output: {error}")))
        }
        _ => Ok(()),
    }
}

fn say(failure: &Failure) -> ExitCode {
    eprintln!("etalon: {failure}");
    failure.exit_code()
}

/// What the command line's reader refused, in one sentence; help and version, which are no errors, as clap prints them.
fn refused(error: &clap::Error) -> ExitCode {
    let context = |kind| match error.get(kind) {
        Some(ContextValue::String(text)) => Some(text.as_str()),
        _ => None,
    };
    let (argument, value) = (context(ContextKind::InvalidArg), context(ContextKind::InvalidValue));
    if let (ErrorKind::ValueValidation, Some(argument), Some(value), Some(reason)) =
        (error.kind(), argument, value, error.source())
    {
        // `--n <N>` and `<SCENE>`, as users write them.
        let option = argument.split(' ').next().filter(|option| option.starts_with('-'));
        let sentence = option.map_or_else(|| reason.to_string(), |option| format!("{option} {value}: {reason}"));
        return say(&Failure::BadInput(sentence));
    }
    let is_help = matches!(
        error.kind(),
        ErrorKind::DisplayHelp | ErrorKind::DisplayVersion | ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand
    );
    if is_help {
        // Clap knows where it goes.
        return match error.print() {
            Ok(()) if !error.use_stderr() => ExitCode::SUCCESS,
            _ => ExitCode::from(2),
        };
    }
    say(&Failure::BadInput(one_sentence(&error.to_string())))
}

/// Clap's several lines as one: what is wrong, what is meant perhaps, and where to look.
fn one_sentence(rendered: &str) -> String {
    let mut parts = rendered.split("\n\n").map(|part| part.split_whitespace().collect::<Vec<_>>().join(" "));
    let wrong = parts.next().unwrap_or_default();
    let tip = parts.find_map(|part| part.strip_prefix("tip: ").map(|tip| format!("; {tip}"))).unwrap_or_default();
    format!("{}{tip}; `etalon help` lists what there is", wrong.strip_prefix("error: ").unwrap_or(&wrong))
}

/// Enters all keys of something into a JSON object.
fn extend(object: &mut serde_json::Value, more: &impl serde::Serialize) -> Result<(), Failure> {
    let broken = |error: &dyn std::fmt::Display| Failure::Broken(format!("the result has no JSON form: {error}"));
    let more = serde_json::to_value(more).map_err(|error| broken(&error))?;
    match (object.as_object_mut(), more) {
        (Some(object), serde_json::Value::Object(more)) => object.extend(more),
        _ => return Err(broken(&"it is no object")),
    }
    Ok(())
}

/// Pretty JSON with a line break at its end.
fn to_text(value: &serde_json::Value) -> Result<String, Failure> {
    let text = serde_json::to_string_pretty(value);
    text.map(|text| text + "\n").map_err(|error| Failure::Broken(format!("the result has no JSON form: {error}")))
}
