//! What `etalon audit --record` does, without building what runs scenes or a graphics adapter: measures every equation on every target that
//! runs here and writes the records in `audit/`. Run `cargo run --release -p etalon-audit --example record`.
//!
//! Figures of adapters stay as they are where the equation's text does.

use etalon_audit::{Catalogue, FULL_SAMPLES, State, Survey};
use std::path::Path;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut catalogue = Catalogue::load()?;
    let progress = |probe: &str, done, all| eprintln!("{done}/{all} {probe}");
    let survey = Survey::of(&catalogue, None, FULL_SAMPLES, None, progress)?;
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
    catalogue.record(&survey, FULL_SAMPLES, root)?;
    for path in catalogue.write_records(root)? {
        eprintln!("{} written", path.display());
    }
    let regressions = State::of(&catalogue, &survey).regressions;
    for worse in &regressions {
        eprintln!("{}: {}", worse.subject, worse.message);
    }
    eprintln!("{} regressions that no record excuses", regressions.len());
    Ok(())
}
