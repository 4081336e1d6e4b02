//! `etalon run`: what it compares, prints and leaves.

use super::place::{Place, code, json, stderr, stdout};
use super::{TINY, refused, tiny};
use serde_json::Value;
use std::fs;

#[test]
fn a_run_compares_all_backends_and_leaves_a_report() {
    let place = Place::new("run");
    let output = place.etalon(&TINY);
    let (table, log) = (stdout(&output), stderr(&output));
    assert_eq!(code(&output), Some(0), "{table}{log}");
    for row in ["reference  f64", "simd       f64", "simd       f32", "wgpu       f32"] {
        assert!(table.contains(row), "{row} is missing:\n{table}");
    }
    assert!(table.contains(" ok (") && !table.contains("FAIL"), "{table}");
    assert!(table.contains("etalon-out/sod-1d/report.html"), "{table}");
    // No driver here: said in the table and on stderr, not passed over. Elsewhere drivers cannot be hidden.
    if cfg!(target_os = "linux") {
        let reason = if cfg!(feature = "wgpu") { "no graphics adapter" } else { "without graphics" };
        assert!(table.contains("skipped: ") && table.contains(reason), "{table}");
        assert!(log.contains("wgpu f32 skipped"), "{log}");
    }
    assert!(log.contains("reference f64: ") && log.contains(" steps to t = 0.2"), "{log}");

    let folder = place.path("etalon-out/sod-1d");
    for file in ["report.html", "report.json", "particles.csv", "particles.vtu", "profile_velocity_x.svg"] {
        assert!(fs::metadata(folder.join(file)).is_ok_and(|m| m.len() > 1000), "{file}");
    }
    let report = fs::read_to_string(folder.join("report.json")).unwrap();
    let report = etalon::report::from_json(&report).unwrap();
    let (_, reference) = report.reference().unwrap();
    let velocity = reference.error_of("velocity_x").unwrap();
    // 100 particles resolve the tube with about 90 and 11 on its sides; a wrong plateau or wave would be off by more than a tenth.
    assert!(velocity.l1 < 0.05 && velocity.particles > 50, "{velocity:?}");
    assert!(report.kernel_approximation.iter().all(|a| a.passes()));
    for (_, run, measured) in report.measured() {
        assert_eq!(measured.arithmetic_difference.len(), if run.is_reference() { 0 } else { 4 });
        assert!(measured.conservation.iter().all(|c| c.passes()));
        assert_eq!(measured.time, 0.2);
        assert!(measured.stages.iter().any(|s| s.name == "reconstructed_momentum" && s.count == measured.steps));
    }
}

#[test]
fn the_same_command_gives_the_same_numbers_and_its_report_names_it() {
    let place = Place::new("again");
    let arguments = tiny(&["--backend", "simd", "--precision", "f64", "--alone", "--json"]);
    let first = json(stdout(&place.etalon(&arguments)));
    let command = first["command"].as_str().unwrap().to_string();
    let words: Vec<&str> = command.split(' ').skip(1).collect();
    let again = place.etalon(&[&words[..], &["--json"]].concat());
    assert_eq!(code(&again), Some(0), "{command}: {}", stderr(&again));
    let again = json(stdout(&again));
    assert_eq!(again["command"], first["command"]);
    let errors = |report: &Value| report["runs"][0]["outcome"]["ran"]["discretisation_error"].clone();
    assert!(errors(&first)[0]["l1"].is_f64());
    assert_eq!(errors(&first), errors(&again));
}

#[test]
fn json_on_stdout_is_the_report() {
    let place = Place::new("json");
    let output = place.etalon(&tiny(&["--backend", "simd", "--json", "--out", "here"]));
    assert_eq!(code(&output), Some(0), "{}", stderr(&output));
    assert_eq!(stdout(&output), fs::read_to_string(place.path("here/report.json")).unwrap());
    let report = json(stdout(&output));
    let runs: Vec<String> =
        report["runs"].as_array().unwrap().iter().map(|r| format!("{} {}", r["backend"], r["precision"])).collect();
    // The reference comes along to compare with; the other backend does not.
    assert_eq!(runs, ["\"reference\" \"f64\"", "\"simd\" \"f64\"", "\"simd\" \"f32\""]);
}

/// A coefficient that depends on time, and conduction: the run holds against the reference, and has the stages it needs.
#[test]
fn switches_and_conduction_run() {
    let place = Place::new("switch");
    for scheme in ["AVSW", "AVSWSLR"] {
        let output = place.etalon(&tiny(&["--scheme", scheme, "--conduction", "--backend", "simd", "--json"]));
        assert_eq!(code(&output), Some(0), "{}", stderr(&output));
        let report = json(stdout(&output));
        assert!(report["command"].as_str().unwrap().contains("--conduction 0.1"), "{}", report["command"]);
        for run in report["runs"].as_array().unwrap() {
            let stages = run["outcome"]["ran"]["stages"].to_string();
            for stage in ["\"switch\"", "\"switched_momentum\"", "\"conduction\"", "\"decay\""] {
                assert!(stages.contains(stage), "{stage} is missing: {stages}");
            }
        }
    }
}

#[test]
fn instruction_sets_and_threads_do_not_change_a_bit() {
    let place = Place::new("bits");
    let run = |out: &str, more: &[&str]| {
        let common = ["--backend", "simd", "--precision", "f32", "--alone", "--out", out];
        let output = place.etalon(&tiny(&[&common[..], more].concat()));
        assert_eq!(code(&output), Some(0), "{}", stderr(&output));
        fs::read_to_string(place.path(out).join("particles.csv")).unwrap()
    };
    let best = run("best", &["--threads", "1"]);
    assert_eq!(best, run("portable", &["--threads", "3", "--instructions", "portable"]));
}

/// What a run measures on the way, and its particles, as files that other programs read.
#[test]
fn a_run_leaves_series_and_hdf5() {
    let place = Place::new("files");
    let run =
        ["run", "noh", "--dim", "1", "--n", "100", "--end-time", "0.1", "--backend", "simd", "--precision", "f64"];
    let output = place.etalon(&[&run[..], &["--alone", "--observe-every", "0.02"]].concat());
    assert_eq!(code(&output), Some(0), "{}", stderr(&output));
    let folder = place.path("etalon-out/noh-1d");
    let series = fs::read_to_string(folder.join("series_simd_f64.csv")).unwrap();
    assert!(series.starts_with("time [T],plateau_density ["), "{series}");
    // The start, five marks, the last of them the end.
    assert_eq!(series.lines().count(), 7, "{series}");
    let snapshot = etalon::snapshot::Snapshot::read(&folder.join("particles.hdf5")).unwrap();
    assert!(snapshot.len() >= 100 && snapshot.time() == Some(0.1));
    let compared = place.etalon(&["compare", "etalon-out/noh-1d/particles.hdf5", "etalon-out/noh-1d/particles.csv"]);
    assert_eq!(code(&compared), Some(0), "{}", stderr(&compared));
}

/// What a run measures at its end: numbers, or why there is none, and curves as plots and tables.
#[test]
fn a_run_leaves_what_its_end_is_measured_for() {
    let place = Place::new("ending");
    let run = ["run", "turbulence", "--dim", "1", "--n", "64", "--end-time", "1", "--precision", "f64", "--json"];
    let output = place.etalon(&[&run[..], &["--backend", "simd"]].concat());
    assert_eq!(code(&output), Some(0), "{}", stderr(&output));
    let report = json(stdout(&output));
    let folder = place.path("etalon-out/turbulence-1d");
    for run in report["runs"].as_array().unwrap() {
        let ending = &run["outcome"]["ran"]["ending"];
        let quantities = ending["quantities"].as_array().unwrap();
        let names: Vec<&str> = quantities.iter().map(|q| q["name"].as_str().unwrap()).collect();
        assert_eq!(names, ["k_max", "spectrum_slope", "mach_slope"]);
        assert!(quantities.iter().all(|q| q["value"].is_f64() != q["missing"].is_string()), "{ending}");
        // In 1-D two waves a side are driven and their harmonics follow: shells between them hold only rounding.
        assert!(quantities[1]["missing"].as_str().unwrap().contains("run for longer"), "{ending}");
        assert!(quantities[2]["value"].is_f64(), "{ending}");
        let curves = ending["curves"].as_array().unwrap();
        assert_eq!(curves.len(), 4, "{ending}");
        for curve in curves {
            let name = curve["name"].as_str().unwrap();
            let file =
                format!("curve_{name}_{}_{}.csv", run["backend"].as_str().unwrap(), run["precision"].as_str().unwrap());
            let table = fs::read_to_string(folder.join(&file)).unwrap();
            assert_eq!(table.lines().count(), 1 + curve["x"]["value"].as_array().unwrap().len(), "{file}");
            assert!(folder.join(format!("curve_{name}.svg")).exists());
        }
    }
    let page = fs::read_to_string(folder.join("report.html")).unwrap();
    assert!(page.contains("What is there at the end?") && page.contains("Spectrum of the velocity"));
}

/// Where a device must be there, the command must use it and judge it.
#[test]
fn a_graphics_adapter_is_used_where_there_is_one() {
    if std::env::var_os("ETALON_REQUIRE_ADAPTER").is_none() {
        println!("SKIPPED: only where ETALON_REQUIRE_ADAPTER says that there is an adapter");
        return;
    }
    let place = Place::new("adapter");
    let arguments = ["run", "sod", "--dim", "1", "--n", "60", "--end-time", "0.02", "--backend", "wgpu", "--json"];
    let output = place.etalon_with_drivers(&arguments);
    assert_eq!(code(&output), Some(0), "{}", stderr(&output));
    let report = json(stdout(&output));
    let runs = report["runs"].as_array().unwrap();
    let run = runs.iter().find(|run| run["backend"] == "wgpu").unwrap_or_else(|| panic!("no such run in {report}"));
    let text = run.to_string();
    assert!(text.contains("arithmetic_difference") && !text.contains("\"pass\":false"), "{text}");
}

/// The README's first command at its own size, for a few steps and without the scalar reference; and the same in the plane, with it.
#[test]
fn the_tube_runs_in_two_and_three_dimensions() {
    let place = Place::new("dimensions");
    let flat = ["run", "sod", "--dim", "2", "--n", "2500", "--end-time", "0.01", "--backend", "simd", "--json"];
    let cube = ["run", "sod", "--end-time", "0.004", "--backend", "simd", "--alone", "--json"];
    for (arguments, dimension, runs) in [(&flat[..], 2, 3), (&cube[..], 3, 2)] {
        let output = place.etalon(arguments);
        assert_eq!(code(&output), Some(0), "{}", stderr(&output));
        let report = json(stdout(&output));
        assert_eq!(report["scene"]["dimension"], dimension);
        let all = report["runs"].as_array().unwrap();
        assert_eq!(all.len(), runs);
        for run in all {
            let ran = &run["outcome"]["ran"];
            assert!(ran["steps"].as_u64().unwrap() >= 3, "{}", ran["steps"]);
            let conserved = ran["conservation"].as_array().unwrap();
            let name = if dimension == 2 { "momentum along y" } else { "momentum along y and z" };
            let across = conserved.iter().find(|c| c["quantity"] == name).unwrap();
            // The start is regular across the tube: what walls take is rounding.
            let drift = across["scaled_drift"].as_f64().unwrap().abs();
            assert!(drift < 1e-4, "momentum across drifts by {drift:e}, tolerance 1e-4");
        }
        let particles = fs::read_to_string(place.path(&format!("etalon-out/sod-{dimension}d/particles.csv"))).unwrap();
        assert_eq!(particles.lines().count() as u64, report["scene"]["particles"].as_u64().unwrap() + 2);
    }
}

#[test]
fn a_glass_is_relaxed_before_it_starts() {
    let place = Place::new("glass");
    let output =
        place.etalon(&tiny(&["--start", "glass", "--backend", "simd", "--alone", "--end-time", "0.02", "--json"]));
    assert_eq!(code(&output), Some(0), "{}", stderr(&output));
    assert!(stderr(&output).contains("relaxing a glass of 64 particles"), "{}", stderr(&output));
    assert_eq!(json(stdout(&output))["scene"]["arrangement"], "glass");
}

/// The tube in one dimension, coarse, with walls: as a user would write it.
fn start_file() -> String {
    let mut text = "# my own tube\nx,mass,smoothing_length,internal_energy,mobile\n".to_string();
    let mut side = |from: f64, spacing: f64, count: i32, density: f64, pressure: f64| {
        for i in 0..count {
            let x = from + (f64::from(i) + 0.5) * spacing;
            let mobile = u8::from((0.0..1.0).contains(&x));
            let energy = 1.5 * pressure / density;
            text += &format!("{x},{},{},{energy},{mobile}\n", density * spacing, 1.45 * spacing);
        }
    };
    // A few layers more at each end are the walls.
    side(-0.05, 0.005, 110, 1.0, 1.0);
    side(0.5, 0.04, 20, 0.125, 0.1);
    text
}

#[test]
fn a_run_starts_from_the_particles_of_a_file() {
    let place = Place::new("startfile");
    fs::write(place.path("my tube.csv"), start_file()).unwrap();
    let run = ["run", "sod", "--dim", "1", "--start-file", "my tube.csv", "--backend", "simd", "--json"];
    let output = place.etalon(&run);
    assert_eq!(code(&output), Some(0), "{}", stderr(&output));
    let report = json(stdout(&output));
    assert_eq!((&report["scene"]["arrangement"], &report["scene"]["particles"]), (&"file".into(), &130.into()));
    assert!(
        report["command"].as_str().unwrap().contains("--start-file 'my tube.csv' --scheme"),
        "{}",
        report["command"]
    );
    // It is that tube: one of as many particles that the program makes has 0.012, too.
    let of_velocity = |run: &Value| {
        let errors = run["outcome"]["ran"]["discretisation_error"].as_array().unwrap();
        errors.iter().find(|e| e["field"] == "velocity_x").unwrap()["l1"].as_f64().unwrap()
    };
    let error = of_velocity(&report["runs"][0]);
    assert!((0.01..0.015).contains(&error), "L1 of the velocity is {error}");

    // One number spoilt, and nothing is written or written over.
    let before = fs::read_to_string(place.path("etalon-out/sod-1d/report.json")).unwrap();
    let spoilt = start_file().replacen(",1.5,", ",NaN,", 1);
    fs::write(place.path("my tube.csv"), spoilt).unwrap();
    let output = place.etalon(&run);
    assert_eq!((code(&output), stdout(&output)), (Some(2), ""));
    let words = ["my tube.csv, line 3", "internal_energy is `NaN`", "must be a finite number"];
    assert!(words.iter().all(|word| stderr(&output).contains(word)), "{}", stderr(&output));
    assert_eq!(fs::read_to_string(place.path("etalon-out/sod-1d/report.json")).unwrap(), before);
    refused("nostart", &["run", "sod", "--start-file", "nowhere.csv"], &["--start-file nowhere.csv", "cannot be read"]);
}
