//! Runs that are stopped on the way.

use super::place::{Place, code, json, stderr};
use std::fs;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// A restart file after every step.
const ALWAYS: &str = "1e-9";

fn implosion<'a>(out: &'a str, restart_every: &'a str, n: &'a str) -> Vec<&'a str> {
    let what = ["run", "noh", "--dim", "1", "--n", n, "--backend", "simd", "--precision", "f64", "--alone"];
    [&what[..], &["--scheme", "AVSW", "--out", out, "--restart-every", restart_every]].concat()
}

/// Killed without a warning, the same command goes on from the restart file: particles and series are those of a run that was never stopped, to the
/// bit. Another run does not take the file, and leaves it alone.
#[test]
fn an_interrupted_run_goes_on_bit_for_bit() {
    let place = Place::new("interrupted");
    let whole = place.etalon(&implosion("whole", "0", "400"));
    assert_eq!(code(&whole), Some(0), "{}", stderr(&whole));
    assert_eq!(place.listing(), ["whole"]);

    let restart = place.path("stopped.restart/simd_f64.h5");
    let mut run = Command::new(env!("CARGO_BIN_EXE_etalon"))
        .args(implosion("stopped", ALWAYS, "400"))
        .current_dir(place.path(""))
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let begun = Instant::now();
    while !restart.exists() {
        assert!(begun.elapsed() < Duration::from_secs(60), "no restart file was written");
        std::thread::sleep(Duration::from_millis(1));
    }
    run.kill().unwrap();
    run.wait().unwrap();
    assert!(!place.path("stopped").exists(), "the run was over before it could be stopped");
    // What a stop in the middle of writing leaves.
    fs::write(place.path("stopped.restart/.simd_f64.h5.partial-1"), "").unwrap();

    let other = place.etalon(&implosion("stopped", ALWAYS, "401"));
    assert_eq!(code(&other), Some(2));
    for words in ["simd_f64.h5", "it was made with", "remove the file"] {
        assert!(stderr(&other).contains(words), "{words} is missing in {}", stderr(&other));
    }

    let resumed = place.etalon(&implosion("stopped", "300", "400"));
    assert_eq!(code(&resumed), Some(0), "{}", stderr(&resumed));
    assert!(stderr(&resumed).contains("goes on from t = "), "{}", stderr(&resumed));
    assert_eq!(place.listing(), ["stopped", "whole"]);
    for file in ["particles.csv", "series_simd_f64.csv"] {
        let [a, b] = ["whole", "stopped"].map(|out| fs::read(place.path(out).join(file)).unwrap());
        assert!(a == b, "{file} differs");
    }
    let [a, b] = ["whole", "stopped"].map(|out| {
        let report = json(&fs::read_to_string(place.path(out).join("report.json")).unwrap());
        let run = &report["runs"][0];
        (run["steps"].clone(), run["stages"][0]["count"].clone(), run["conservation"].clone())
    });
    assert_eq!(a, b);
}

/// A reference that is done is not made again when a later part of the comparison was stopped.
#[test]
fn what_was_done_is_kept_until_the_report_is_written() {
    let place = Place::new("kept");
    let arguments = ["run", "sod", "--dim", "1", "--n", "100", "--end-time", "0.05", "--out", "tube"];
    let restart = place.path("tube.restart/reference_f64.h5");
    let mut run = Command::new(env!("CARGO_BIN_EXE_etalon"))
        .args(arguments)
        .args(["--restart-every", ALWAYS, "--backend", "simd"])
        .current_dir(place.path(""))
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let later = place.path("tube.restart/simd_f64.h5");
    let begun = Instant::now();
    while !later.exists() {
        assert!(begun.elapsed() < Duration::from_secs(120), "no restart file was written");
        std::thread::sleep(Duration::from_millis(1));
    }
    run.kill().unwrap();
    run.wait().unwrap();
    assert!(restart.exists());
    let resumed = place.etalon(&[&arguments[..], &["--backend", "simd"]].concat());
    assert_eq!(code(&resumed), Some(0), "{}", stderr(&resumed));
    let message = stderr(&resumed);
    for line in [
        "reference f64: goes on from t = 0.05",
        "rounded like f64 at random: goes on from t = 0.05",
        "simd f64: goes on",
    ] {
        assert!(message.contains(line), "`{line}` is missing in {message}");
    }
    assert_eq!(place.listing(), ["tube"]);
}
