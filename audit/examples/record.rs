//! What `etalon audit --record` does, without building what runs scenes: measures every equation on every target and writes
//! `audit/budgets.toml` and `audit/equations.toml`. Run `cargo run --release -p etalon-audit --example record`.

use etalon_audit::{Budgets, Encoded, FULL_SAMPLES, Reach, measure_all};
use std::path::Path;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let measurements = measure_all(FULL_SAMPLES, |probe, done, all| eprintln!("{done}/{all} {probe}"));
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/budgets.toml");
    std::fs::write(path, Budgets::of(&measurements).to_toml()?)?;
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
    let encoded = Encoded::now(root, &Reach::recorded()?)?;
    std::fs::write(root.join("audit/equations.toml"), encoded.to_toml()?)?;
    let violations: usize = measurements.iter().map(|measurement| measurement.violation_count).sum();
    eprintln!("{} measurements, {violations} results outside of their budget", measurements.len());
    Ok(())
}
