//! The work: every mutant that is asked for and not known yet.

use crate::arguments::Arguments;
use crate::binary::Binary;
use crate::coverage::{Reach, coverage};
use crate::error::Error;
use crate::judge::{Outcome, judge};
use crate::mutant::Equation;
use crate::record::Record;
use indicatif::{ProgressBar, ProgressStyle};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

/// The record is written this often, so that little is lost when a run is broken off.
const SAVE: Duration = Duration::from_secs(10);

struct Task<'a> {
    equation: &'a Equation,
    number: u32,
    tests: Vec<&'a Reach>,
}

/// Runs what is not known and enters it into the record.
pub fn run(
    binary: &Binary,
    equations: &[Equation],
    chosen: &[&Equation],
    arguments: &Arguments,
    record: &mut Record,
) -> Result<(), Error> {
    let tests = binary.tests()?;
    record.refresh(equations, &tests);
    let bar = progress(tests.len(), "each test alone");
    let reaches = coverage(binary, &tests, &|| bar.inc(1))?;
    bar.finish_and_clear();
    for equation in equations {
        let names = reaching(&reaches, equation).iter().map(|reach| reach.test.clone()).collect();
        record.equation.entry(equation.path.clone()).or_default().tests = names;
    }

    let mut tasks = Vec::new();
    for equation in chosen {
        let tests = reaching(&reaches, equation);
        for mutant in &equation.mutants {
            let known = record.equation.get(&equation.path).and_then(|found| found.outcome(mutant.number));
            // What was missed is tried again: there may be new tests.
            if arguments.fresh || matches!(known, None | Some(Outcome::Missed)) {
                tasks.push(Task { equation, number: mutant.number, tests: tests.clone() });
            }
        }
    }
    if let Some(part) = arguments.part {
        let mut n = 0;
        tasks.retain(|_| {
            n += 1;
            part.has(n - 1)
        });
    }
    let processors = std::thread::available_parallelism().map_or(1, usize::from);
    let jobs = arguments.jobs.map_or(processors, usize::from);
    let bar = progress(tasks.len(), "mutants");
    let next = AtomicUsize::new(0);
    let shared = Mutex::new((record, Instant::now()));
    let results: Vec<Result<(), Error>> = std::thread::scope(|scope| {
        let worker = || -> Result<(), Error> {
            while let Some(task) = tasks.get(next.fetch_add(1, Ordering::Relaxed)) {
                let name = format!("{}#{}", task.equation.full_path, task.number);
                let outcome = judge(binary, &name, &task.tests)?;
                // A poisoned lock: another worker has panicked, and its panic will be heard.
                let Ok(mut shared) = shared.lock() else { return Ok(()) };
                shared.0.enter(&task.equation.path, task.number, outcome);
                if shared.1.elapsed() > SAVE {
                    shared.0.write()?;
                    shared.1 = Instant::now();
                }
                bar.inc(1);
            }
            Ok(())
        };
        let workers: Vec<_> = (0..jobs).map(|_| scope.spawn(worker)).collect();
        let join = |worker: std::thread::ScopedJoinHandle<'_, Result<(), Error>>| {
            worker.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
        };
        workers.into_iter().map(join).collect()
    });
    bar.finish_and_clear();
    if let Ok((record, _)) = shared.into_inner() {
        record.write()?;
    }
    results.into_iter().collect()
}

/// The tests that reach an equation.
fn reaching<'a>(reaches: &'a [Reach], equation: &Equation) -> Vec<&'a Reach> {
    reaches.iter().filter(|reach| reach.equations.contains(&equation.full_path)).collect()
}

/// A bar on standard error with an estimate; none where nobody looks.
fn progress(length: usize, what: &'static str) -> ProgressBar {
    let style = ProgressStyle::with_template("{msg} [{bar:40}] {pos}/{len}, {eta} left");
    let bar = ProgressBar::new(length as u64).with_message(what);
    style.map_or_else(|_| bar.clone(), |style| bar.clone().with_style(style))
}
