//! Measures every equation on every target and writes `audit/budgets.toml`: `cargo run --release -p etalon-audit --example record`.

use etalon_audit::{Budgets, FULL_SAMPLES, measure_all};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let measurements = measure_all(FULL_SAMPLES, |probe, done, all| eprintln!("{done}/{all} {probe}"));
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/budgets.toml");
    std::fs::write(path, Budgets::of(&measurements).to_toml()?)?;
    let violations: usize = measurements.iter().map(|measurement| measurement.violation_count).sum();
    eprintln!("{} measurements, {violations} results outside of their budget", measurements.len());
    Ok(())
}
