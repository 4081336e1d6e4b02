//! Progress on stderr: a bar on a terminal, one line a run elsewhere.

use crate::report::plain;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;

/// Parts of the simulated time that the bar tells apart.
const PARTS: f64 = 1e6;

/// The progress of one run through simulated time.
pub struct Progress {
    bar: ProgressBar,
    label: String,
    end_time: f64,
    steps: u64,
}

impl Progress {
    /// A bar at zero; not `shown` if another run beside it has one.
    pub fn new(label: &str, end_time: f64, shown: bool) -> Self {
        let target = if shown { ProgressDrawTarget::stderr() } else { ProgressDrawTarget::hidden() };
        let bar = ProgressBar::with_draw_target(Some(PARTS as u64), target);
        if let Ok(style) = ProgressStyle::with_template("{prefix} [{wide_bar}] {msg}, {eta} left") {
            bar.set_style(style.progress_chars("=> "));
        }
        bar.set_prefix(label.to_string());
        bar.set_message("set-up");
        bar.tick();
        Progress { bar, label: label.to_string(), end_time, steps: 0 }
    }

    /// Which run it is.
    pub fn label(&self) -> &str {
        &self.label
    }

    /// Goes on where an earlier attempt was.
    pub fn go_on(&mut self, steps: u64, time: f64) {
        self.steps = steps;
        self.bar.set_position((time / self.end_time * PARTS) as u64);
        self.bar.reset_eta();
        self.bar.suspend(|| note(&format!("{}: goes on from t = {}, step {steps}", self.label, plain(time))));
    }

    /// A step was made.
    pub fn step(&mut self, time: f64) {
        self.steps += 1;
        self.bar.set_message(format!("t = {}, step {}", plain(time), self.steps));
        self.bar.set_position((time / self.end_time * PARTS) as u64);
    }

    /// The run is over.
    pub fn done(self, wall_seconds: f64) {
        self.bar.finish_and_clear();
        let (label, steps, end) = (&self.label, self.steps, plain(self.end_time));
        note(&format!("{label}: {steps} steps to t = {end} in {wall_seconds:.1} s"));
    }
}

/// A line on stderr.
pub fn note(text: &str) {
    let mark = if std::io::stderr().is_terminal() { "  " } else { "" };
    eprintln!("{mark}{text}");
}
