//! The program as users run it: what it prints, what it leaves, how it refuses.

#[path = "command/documented.rs"]
mod documented;
#[path = "command/place.rs"]
mod place;

use documented::Page;
use place::{Place, code, json, stderr, stdout};
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};

/// The smallest tube that is one: a second even without optimisation.
const TINY: [&str; 6] = ["run", "sod", "--dim", "1", "--n", "100"];

fn tiny<'a>(more: &[&'a str]) -> Vec<&'a str> {
    [&TINY[..], more].concat()
}

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

#[test]
fn every_scheme_start_and_dimension_can_be_explained() {
    let place = Place::new("explain");
    let mut page = Page::read("explain-schema.md");
    for dimension in ["1", "2", "3"] {
        for scheme in ["AV", "AVSW", "AVSLR", "AVSWSLR", "AVSLRB", "AVSLRB2", "AVSLRB2F", "AVB"] {
            let output = place.etalon(&["explain", "sod", "--dim", dimension, "--scheme", scheme, "--json"]);
            assert_eq!(code(&output), Some(0), "{}", stderr(&output));
            let explained = json(stdout(&output));
            page.check(&explained);
            assert_eq!(explained["dimension"].to_string(), dimension);
            let stages = explained["stages"].as_array().unwrap();
            let names: Vec<&str> = stages.iter().filter_map(|s| s["name"].as_str()).collect();
            let last = match scheme {
                "AV" => "momentum",
                "AVSW" | "AVSWSLR" => "switched_momentum",
                _ => "reconstructed_momentum",
            };
            assert!(names.contains(&last), "{names:?}");
            // A coefficient that decays is carried by those that have one, and by no other.
            let switched = scheme.starts_with("AVSW");
            assert_eq!(names.contains(&"decay"), switched, "{names:?}");
            assert_eq!(explained["fields"].to_string().contains("alpha"), switched, "{scheme}");
            assert!(explained["operations_per_pair"]["f32"].as_u64().unwrap() > 50);
            let memory = explained["bytes_per_particle"].as_array().unwrap();
            assert_eq!(memory.len(), 4);
            assert!(memory.iter().all(|m| (100.0..4000.0).contains(&m["total"].as_f64().unwrap())), "{memory:?}");
        }
    }
    page.all_seen();
}

#[test]
fn the_explanation_names_fields_symbols_units_and_work() {
    let place = Place::new("text");
    let output = place.etalon(&["explain", "sod", "--dim", "2", "--backend", "simd"]);
    let text = stdout(&output);
    for part in [
        "velocity_gradients (pass over neighbours)",
        "of others",
        "per pair",
        "M L^-nu",
        "density ρ",
        "simd f64",
        "total",
    ] {
        assert!(text.contains(part), "{part} is missing:\n{text}");
    }
    assert!(!text.contains("wgpu") && !text.contains('\\'), "{text}");
    // Symbols with indices, of fields that only some schemes have.
    let output = place.etalon(&["explain", "sod", "--scheme", "AVSW", "--conduction", "--backend", "simd"]);
    let text = stdout(&output);
    for part in ["local_alpha α_loc", "I_∇·v"] {
        assert!(text.contains(part), "{part} is missing:\n{text}");
    }
    assert!(!text.contains('\\'), "{text}");
}

#[test]
fn scenes_lists_every_name() {
    let place = Place::new("scenes");
    let text = place.etalon(&["scenes"]);
    let names = json(stdout(&place.etalon(&["scenes", "--json"])));
    let mut page = Page::read("scenes-schema.md");
    page.check(&names);
    page.all_seen();
    for list in ["schemes", "kernels", "grad_h", "starts", "backends", "precisions"] {
        let names = names[list].as_array().unwrap();
        assert!(!names.is_empty());
        for name in names {
            assert!(stdout(&text).contains(name.as_str().unwrap()), "{name} is missing:\n{}", stdout(&text));
        }
    }
}

/// A scene printed as a file, changed, is run as changed; the report names the command that runs it again.
#[test]
fn a_scene_of_a_file_runs() {
    let place = Place::new("scenefile");
    let printed = place.etalon(&["scenes", "sod", "--dim", "1"]);
    assert_eq!(code(&printed), Some(0), "{}", stderr(&printed));
    let text = stdout(&printed)
        .replace("particles = 450", "particles = 100")
        .replace("gamma = 1.6666666666666667", "gamma = 1.4");
    let text = text.replace("alpha = 1.0", "alpha = 0.5");
    fs::write(place.path("mine.toml"), text).unwrap();
    let run = ["run", "mine.toml", "--backend", "simd", "--precision", "f64", "--alone", "--json"];
    let output = place.etalon(&run);
    assert_eq!(code(&output), Some(0), "{}", stderr(&output));
    let report = json(stdout(&output));
    assert_eq!(report["scene"]["gamma"], 1.4);
    let command = report["command"].as_str().unwrap();
    for part in ["etalon run mine.toml --dim 1", "--n 100", "--set gamma=1.4", "--set method.alpha=0.5"] {
        assert!(command.contains(part), "{part} is missing: {command}");
    }
    assert!(place.path("etalon-out/mine-1d/report.html").exists());
    // The command line goes over the file.
    let output = place.etalon(&[
        "explain",
        "mine.toml",
        "--dim",
        "2",
        "--n",
        "6000",
        "--neighbours",
        "26",
        "--scheme",
        "AV",
        "--json",
    ]);
    let explained = json(stdout(&output));
    assert_eq!((explained["dimension"].clone(), explained["scheme"].clone()), (2.into(), "AV".into()));
}

#[test]
fn what_is_wrong_in_a_scene_file_is_named_with_its_line() {
    let place = Place::new("wrongfile");
    for (text, words) in [
        ("scene = \"sod\"\nspeed = 1\n", &["mine.toml, line 2", "speed", "end_time"][..]),
        ("scene = \"soda\"\n", &["mine.toml, line 1", "there is no scene `soda`"]),
        ("scene = \"sod\"\n[method]\nneighbours = \"many\"\n", &["mine.toml, line 3", "many"]),
        ("scene = \"sod\"\ndimension = 4\n", &["mine.toml", "dimension = 4"]),
        ("scene = \"sod\"\nend_time = -1.0\n", &["--end-time -1", "above 0"]),
        ("scene = \"sod\"\n[problem]\ngamma = 0.9\n", &["gamma = 0.9"]),
        ("scene = \"so", &["mine.toml, line 1"]),
        ("", &["mine.toml", "scene"]),
    ] {
        fs::write(place.path("mine.toml"), text).unwrap();
        let output = place.etalon(&["run", "mine.toml"]);
        let log = stderr(&output);
        assert_eq!(code(&output), Some(2), "{text}: {log}");
        assert!(log.trim().lines().count() == 1, "{log}");
        for word in words {
            assert!(log.contains(word), "{text}: `{word}` is missing: {log}");
        }
    }
    assert!(!place.path("etalon-out").exists());
}

/// Four runs, one front; a second call has nothing left to do; what cannot be done is refused before anything runs.
#[test]
fn a_sweep_is_drawn_and_goes_on_where_it_stopped() {
    let place = Place::new("pareto");
    let sweep = ["pareto", "sod", "--dim", "1", "--n", "60,120", "--scheme", "AV,AVSLRB2", "--precision", "f64"];
    let output = place.etalon(&sweep);
    assert_eq!(code(&output), Some(0), "{}", stderr(&output));
    assert_eq!(stdout(&output).matches(" simd f64 ").count(), 4, "{}", stdout(&output));
    let folder = place.path("etalon-out/pareto-sod-1d");
    assert!(fs::read_to_string(folder.join("pareto.svg")).unwrap().contains("AVSLRB2"));
    let done = fs::read_to_string(folder.join("results.jsonl")).unwrap();
    assert_eq!(done.lines().count(), 4);
    let again = place.etalon(&[&sweep[..], &["--json", "--cost", "operations"]].concat());
    assert!(stderr(&again).contains("4 of 4 runs are done already"), "{}", stderr(&again));
    assert_eq!(fs::read_to_string(folder.join("results.jsonl")).unwrap(), done);
    let study = json(stdout(&again));
    let mut page = Page::read("pareto-schema.md");
    page.check(&study);
    page.all_seen();
    let points = study["points"].as_array().unwrap();
    // More particles cost more and are nearer to the solution; the reconstruction costs operations.
    let of = |scheme: &str, key: &str| -> Vec<f64> {
        let own = points.iter().filter(|p| p["scheme"] == scheme);
        own.map(|p| p[key].as_f64().unwrap()).collect()
    };
    for scheme in ["AV", "AVSLRB2"] {
        let (cost, error) = (of(scheme, "cost"), of(scheme, "error"));
        assert!(cost[0] < cost[1] && error[0] > error[1], "{scheme}: {cost:?} {error:?}");
    }
    assert!(of("AV", "cost")[0] < of("AVSLRB2", "cost")[0]);
    assert!(points.iter().any(|p| p["on_front"] == true));
    refused("pareto-n", &["pareto", "sod", "--dim", "1", "--n", "5"], &["--n 5", "--n 40 is enough"]);
    refused("pareto-error", &[&sweep[..], &["--error", "spin"]].concat(), &["--error spin", "velocity_x"]);
}

/// The tube with all seven schemes and that with dust, small: our numbers stand beside the published ones with ranks, and an interrupted comparison goes on.
#[test]
fn the_papers_numbers_stand_beside_ours() {
    let place = Place::new("reproduce");
    let few = ["reproduce", "sod", "dustyshock", "--size", "0.2", "--minutes", "0"];
    // No time for more than the first run, which is begun whatever the limit.
    let output = place.etalon(&few);
    assert_eq!(code(&output), Some(0), "{}", stderr(&output));
    assert!(stdout(&output).contains("runs are left; the same command goes on"), "{}", stdout(&output));
    let all = ["reproduce", "sod", "dustyshock", "--size", "0.2", "--json"];
    let output = place.etalon(&all);
    assert_eq!(code(&output), Some(0), "{}", stderr(&output));
    assert!(stderr(&output).contains("1 of 12 runs are done already"), "{}", stderr(&output));
    let comparison = json(stdout(&output));
    let mut page = Page::read("reproduce-schema.md");
    page.check(&comparison);
    page.all_seen();
    let quantity = &comparison["quantities"][0];
    assert_eq!(quantity["quantity"], "shock_tube_velocity_l1");
    let variants = quantity["variants"].as_array().unwrap();
    assert_eq!(variants.len(), 7);
    // The paper's errors are below 0.01; ours, with a fifth of the usual particles, are some times as large.
    for variant in variants {
        let ours = variant["ours"].as_f64().unwrap();
        assert!((0.005..0.1).contains(&ours) && variant["published"].as_f64().unwrap() < 0.01, "{variant}");
    }
    let mut ranks: Vec<u64> = variants.iter().map(|v| v["rank_ours"].as_u64().unwrap()).collect();
    ranks.sort_unstable();
    assert_eq!(ranks[0], 1);
    // The limiter that the paper recommends at three resolutions, and the two schemes of which it prints nothing at the lowest.
    let dust = &comparison["quantities"][1];
    assert_eq!(dust["quantity"], "dustyshock_l1");
    let dust = dust["variants"].as_array().unwrap();
    let of = |variant: &str| dust.iter().filter(move |v| v["variant"] == variant).collect::<Vec<_>>();
    let limited = of("MC");
    let resolutions: Vec<u64> = limited.iter().map(|v| v["resolution"].as_u64().unwrap()).collect();
    assert_eq!(resolutions, [128, 256, 512]);
    let errors: Vec<f64> = limited.iter().map(|v| v["ours"].as_f64().unwrap()).collect();
    assert!(errors[0] > errors[1] && errors[1] > errors[2], "{errors:?}");
    let raw = of("unreconstructed")[0];
    assert!(raw["ours"].as_f64().unwrap() > errors[0] && raw["resolution"] == 128, "{raw} {errors:?}");
    let folder = place.path("etalon-out/reproduce");
    assert!(fs::read_to_string(folder.join("heat_map.svg")).unwrap().contains("AVSLRB2"));
    assert!(fs::read_to_string(folder.join("heat_map_dust.svg")).unwrap().contains("unreconstructed"));
    refused("reproduce-scene", &["reproduce", "noh"], &["no published number", "leave the names out"]);
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

#[test]
fn a_benchmark_reports_every_figure() {
    let place = Place::new("bench");
    let output = place.etalon(&["bench", "--n", "1000", "--steps", "1", "--json"]);
    assert_eq!(code(&output), Some(0), "{}", stderr(&output));
    let bench = json(stdout(&output));
    let mut page = Page::read("bench-schema.md");
    page.check(&bench);
    // Elsewhere the system does not say how much memory was used.
    if cfg!(target_os = "linux") {
        page.all_seen();
    }
    let positive = |value: &Value| assert!(value.as_f64().is_some_and(|v| v > 0.0), "{value} in {bench}");
    positive(&bench["reference"]["nanoseconds_per_update"]);
    assert_eq!(bench["runs"].as_array().unwrap().len(), 2);
    for run in bench["runs"].as_array().unwrap() {
        let precision = run["precision"].as_str().unwrap();
        let peak = &bench["machine"]["fma_peak_gflops_per_core"][precision];
        positive(peak);
        for key in ["nanoseconds_per_update", "updates_per_second", "speed_up"] {
            positive(&run[key]);
        }
        // One thread: updates per second over GFLOP/s, to the last rounding or two.
        let expected = run["updates_per_second"].as_f64().unwrap() / peak.as_f64().unwrap();
        let found = run["updates_per_gflop"].as_f64().unwrap();
        assert!((found / expected - 1.0).abs() < 4.0 * f64::EPSILON, "{found} for {expected}");
        assert!(run["stages"].as_array().unwrap().iter().any(|s| s["name"] == "reconstructed_momentum"));
    }
}

#[test]
fn kernels_are_printed_and_written_and_nothing_is_replaced_unasked() {
    let place = Place::new("emit");
    let c = place.etalon(&["emit", "sod", "--dim", "1", "--target", "c", "--precision", "f64", "--pass", "density"]);
    assert_eq!(code(&c), Some(0), "{}", stderr(&c));
    assert!(stdout(&c).contains("void density_pair(") && stdout(&c).contains("double"), "{}", stdout(&c));
    assert!(!stdout(&c).contains("momentum_pair"), "another pass than was asked for");

    let to_folder = ["emit", "sod", "--dim", "1", "--out", "kernels"];
    let written = place.etalon(&to_folder);
    assert_eq!(code(&written), Some(0), "{}", stderr(&written));
    let text = fs::read_to_string(place.path("kernels/reconstructed_momentum.wgsl")).unwrap();
    assert!(text.contains("@compute"), "{text}");
    // The command in the header prints the same text again.
    let command = text.split("Generated by `").nth(1).and_then(|rest| rest.split('`').next()).unwrap();
    let again: Vec<&str> = command.split(' ').skip(1).chain(["--pass", "reconstructed_momentum"]).collect();
    assert_eq!(stdout(&place.etalon(&again)), text, "{command}");

    let twice = place.etalon(&to_folder);
    assert_eq!(code(&twice), Some(2));
    assert!(stderr(&twice).contains("--replace"), "{}", stderr(&twice));
    refused("emit64", &["emit", "sod", "--precision", "f64"], &["--precision f64", "--target c"]);
    refused("emitpass", &["emit", "sod", "--pass", "nosuch"], &["--pass nosuch", "density"]);
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

#[test]
fn an_audit_measures_and_its_json_is_documented() {
    let place = Place::new("audit");
    let mut page = Page::read("audit-schema.md");
    // A limiter; a definition without a number; a law that no function encodes.
    for name in ["gs25:13", "courant_step", "c25:25"] {
        let output = place.etalon(&["audit", "--only", name, "--samples", "1", "--json"]);
        // There is no driver here, which is said; figures of WGSL are those on record.
        assert!(!cfg!(target_os = "linux") || stderr(&output).contains("WGSL is not run"), "{}", stderr(&output));
        assert!(output.status.success(), "{name}: {output:?}");
        page.check(&json(&String::from_utf8(output.stdout).unwrap()));
    }
    page.all_seen();
    let output = place.etalon(&["audit", "--only", "gs25:13", "--samples", "1"]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("reconstruction::slope_limiter") && text.contains("Nothing became worse."), "{text}");
    assert!(place.listing().is_empty());
}

/// Held against records of an earlier time, whatever became worse is said and makes the exit code 1.
#[test]
fn an_audit_that_finds_something_worse_than_recorded_fails() {
    let place = Place::new("audit-against");
    let audit = ["audit", "--only", "gs25:13", "--samples", "1", "--no-adapter", "--against", "records"];
    let records = |tampered: &str, change: &dyn Fn(&str) -> String| {
        fs::create_dir_all(place.path("records")).unwrap();
        for name in ["budgets.toml", "equations.toml", "ranges.toml", "gains.toml"] {
            let text = fs::read_to_string(format!("{}/audit/{name}", env!("CARGO_MANIFEST_DIR"))).unwrap();
            let changed = if name == tampered { change(&text) } else { text.clone() };
            assert!(name != tampered || changed != text, "{name} was not changed");
            fs::write(place.path("records").join(name), changed).unwrap();
        }
    };
    let worse = |words: &str| {
        let output = place.etalon(&audit);
        assert_eq!(code(&output), Some(1), "{}{}", stdout(&output), stderr(&output));
        assert!(stdout(&output).contains("WORSE") && stdout(&output).contains(words), "{}", stdout(&output));
        let output = place.etalon(&[&audit[..], &["--json"]].concat());
        let state = json(stdout(&output));
        assert_eq!((code(&output), &state["passed"]), (Some(1), &Value::Bool(false)), "{state}");
        assert!(!state["regressions"].as_array().unwrap().is_empty() && state["equations"][0]["regressed"] == true);
    };

    records("", &|text| text.to_string());
    let output = place.etalon(&audit);
    assert_eq!(code(&output), Some(0), "{}{}", stdout(&output), stderr(&output));

    // The same error was a hundredth once.
    let in_record = |text: &str, key: &str, value: &str| {
        let (before, rest) = text.split_once("probe = \"reconstruction::slope_limiter\"").unwrap();
        let (record, after) = rest.split_once(&format!("\n{key} = ")).unwrap();
        let (_, after) = after.split_once('\n').unwrap();
        format!("{before}probe = \"reconstruction::slope_limiter\"{record}\n{key} = {value}\n{after}")
    };
    records("budgets.toml", &|text| in_record(text, "worst", "0.01"));
    worse("recorded 0.01");
    records("budgets.toml", &|text| in_record(text, "budget", "0.02"));
    worse("the operations allow");
    records("budgets.toml", &|text| text.replace("probe = \"reconstruction::slope_limiter\"", "probe = \"gone\""));
    worse("has no record");
    records("equations.toml", &|text| {
        text.to_string() + "\n[[function]]\npath = \"reconstruction::gone\"\nids = [\"gs25:13\"]\n"
    });
    worse("no longer encoded by reconstruction::gone");

    records("gains.toml", &|_| "nothing = 1".to_string());
    let output = place.etalon(&audit);
    assert_eq!(code(&output), Some(2), "{}", stderr(&output));
    assert!(stderr(&output).contains("--against: gains.toml cannot be read"), "{}", stderr(&output));
}

/// Where a device must be there, the equations' WGSL must run on it and stay within its budget.
#[test]
fn an_audit_runs_wgsl_where_there_is_an_adapter() {
    if std::env::var_os("ETALON_REQUIRE_ADAPTER").is_none() {
        println!("SKIPPED: only where ETALON_REQUIRE_ADAPTER says that there is an adapter");
        return;
    }
    let place = Place::new("audit-adapter");
    let arguments = ["audit", "--only", "gs25:13", "--samples", "1000", "--json"];
    let output = place.etalon_with_drivers(&arguments);
    assert_eq!(code(&output), Some(0), "{}", stderr(&output));
    let state = json(stdout(&output));
    let errors = state["equations"][0]["errors"].as_array().unwrap();
    let wgsl = errors.iter().find(|error| error["target"] == "wgsl f32").unwrap_or_else(|| panic!("{state}"));
    assert!(wgsl["measured"] == true && wgsl["adapter"].is_string() && wgsl["worst"].as_f64() > Some(0.0), "{wgsl}");
    assert!(wgsl["worst"].as_f64() <= wgsl["budget"].as_f64(), "{wgsl}");
}

#[test]
fn an_equation_is_shown_and_its_json_is_documented() {
    let place = Place::new("show");
    let mut page = Page::read("show-schema.md");
    for name in [
        "gs25:13",
        "gs25:5",
        "gs25:6",
        "gs25:20",
        "c25:1",
        "c25:25",
        "courant_step",
        "conduction_weight",
        "kernels::mixed_sinc",
        "sinc_half_pi",
    ] {
        let output = place.etalon(&["show", name, "--json"]);
        assert!(output.status.success(), "{name}: {output:?}");
        page.check(&json(&String::from_utf8(output.stdout).unwrap()));
    }
    page.all_seen();
    let text = String::from_utf8(place.etalon(&["show", "gs25:13"]).stdout).unwrap();
    for part in ["\\phi_{ab} =", "pub fn slope_limiter", "fn slope_limiter(slope_a: f32, slope_b: f32)", "caught"] {
        assert!(text.contains(part), "no {part} in {text}");
    }
}

#[test]
fn pages_are_written_and_stale_ones_fail_the_check() {
    let place = Place::new("pages");
    assert!(place.etalon(&["pages", "--out", "."]).status.success());
    assert!(place.etalon(&["pages", "--out", ".", "--check"]).status.success());
    let page = place.path("equations/gs25/13.md");
    fs::write(&page, fs::read_to_string(&page).unwrap() + "more\n").unwrap();
    let output = place.etalon(&["pages", "--out", ".", "--check"]);
    assert_eq!(output.status.code(), Some(1), "{output:?}");
    assert!(String::from_utf8(output.stdout).unwrap().contains("13.md is stale"));
}

#[test]
fn unknown_equations_and_misplaced_records_are_refused() {
    refused("show-number", &["show", "gs25:31"], &["its equations are 1 to 30", "near it are gs25:"]);
    refused("show-name", &["show", "mixd_sinc"], &["neither an equation", "mixed_sinc"]);
    refused("audit-only", &["audit", "--only", "gs25"], &["--only", "near it are"]);
    refused("audit-record", &["audit", "--record"], &["--record", "root"]);
    refused("audit-against", &["audit", "--against", "nowhere"], &["--against", "budgets.toml"]);
    refused("pages-out", &["pages", "--out", "nowhere"], &["no folder nowhere"]);
}

/// Bad input: exit code 2, these words in one line on stderr, nothing on stdout, nothing written.
fn refused(test: &str, arguments: &[&str], words: &[&str]) {
    let place = Place::new(test);
    let output = place.etalon(arguments);
    let message = stderr(&output);
    assert_eq!(code(&output), Some(2), "{arguments:?}: {message}");
    assert_eq!(message.lines().count(), 1, "{arguments:?}: {message}");
    for word in words {
        assert!(message.contains(word), "{arguments:?}: `{word}` is missing in: {message}");
    }
    assert_eq!(stdout(&output), "", "{arguments:?}");
    assert_eq!(place.listing(), Vec::<String>::new(), "{arguments:?}");
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

#[test]
fn unknown_names_are_refused_with_the_right_ones() {
    refused("scene", &["run", "soda"], &["`soda`", "there is no scene", "sod", "my-scene.toml"]);
    refused("scene2", &["explain", "soda"], &["there is no scene `soda`"]);
    refused("scene3", &["run", "nowhere.toml"], &["nowhere.toml", "cannot be read"]);
    refused("scene4", &["scenes", "soda"], &["there is no scene `soda`"]);
    refused("scheme", &tiny(&["--scheme", "AVX"]), &["--scheme AVX", "AVSLRB2F"]);
    refused("wave", &tiny(&["--scheme", "AVSLRB*2"]), &["--scheme AVSLRB*2", "period", "choose AVSLRB2,"]);
    refused("conduction", &tiny(&["--conduction", "-1"]), &["conduction = -1", "from 0 to 10"]);
    refused("kernel", &tiny(&["--kernel", "gauss"]), &["--kernel gauss", "sinc49, M4"]);
    refused("backend", &tiny(&["--backend", "cuda"]), &["--backend cuda", "reference, simd, wgpu"]);
    refused("precision", &tiny(&["--precision", "f16"]), &["--precision f16", "f32, f64"]);
    refused("grad-h", &tiny(&["--grad-h", "none"]), &["--grad-h none", "exact, corrected"]);
    refused("start", &tiny(&["--start", "random"]), &["--start random", "lattice, glass"]);
    refused("instructions", &tiny(&["--instructions", "mmx"]), &["--instructions mmx", "portable"]);
}

#[test]
fn numbers_that_make_no_sense_are_refused() {
    let run = |more: &[&'static str]| [&["run", "sod"], more].concat();
    refused("dim4", &run(&["--dim", "4"]), &["--dim 4", "1, 2 or 3"]);
    refused("dim-1", &run(&["--dim", "-1"]), &["--dim -1", "1, 2 or 3"]);
    refused("n0", &run(&["--n", "0"]), &["--n 0", "at least 1"]);
    refused("nmany", &run(&["--n", "many"]), &["--n many", "whole number"]);
    refused("n-5", &run(&["--n", "-5"]), &["--n -5", "at least 1"]);
    refused("n5", &run(&["--dim", "1", "--n", "5"]), &["--n 5", "--n 40 is enough"]);
    refused("n1e15", &run(&["--n", "1e15"]), &["--n 1000000000000000", "give at most"]);
    refused("n1e99", &run(&["--n", "1e99"]), &["--n 1e99", "smaller"]);
    refused("narrow", &run(&["--n", "2000"]), &["--n 2000", "is enough"]);
    refused("proc", &run(&["--dim", "1", "--out", "/proc/nowhere"]), &["/proc/nowhere"]);
    refused("t-1", &run(&["--end-time", "-1"]), &["--end-time -1", "above 0"]);
    refused("t0", &run(&["--end-time", "0"]), &["--end-time 0", "above 0"]);
    refused("tnan", &run(&["--end-time", "NaN"]), &["--end-time NaN", "finite"]);
    refused("t1", &run(&["--end-time", "1"]), &["--end-time 1", "t = 0.27", "smaller"]);
    refused("observe", &run(&["--observe-every", "0"]), &["--observe-every 0", "above 0"]);
    refused("set", &run(&["--set", "smoothed"]), &["--set smoothed", "a key and a value"]);
    refused("set2", &run(&["--set", "smooth=true"]), &["unknown field `smooth`", "smoothed", "gamma"]);
    refused("set3", &run(&["--set", "smoothed=maybe"]), &["sod: ", "boolean"]);
    refused("set4", &run(&["--set", "method.alfa=1"]), &["method.", "unknown field `alfa`", "alpha"]);
    refused("set5", &run(&["--set", "method.alpha=-1"]), &["alpha = -1", "from 0 to 10"]);
    refused("few", &run(&["--neighbours", "3"]), &["--neighbours 3", "between 30 and 600"]);
    refused("many", &run(&["--dim", "1", "--neighbours", "1e9"]), &["between 4 and 40"]);
    refused("nan", &run(&["--neighbours", "NaN"]), &["--neighbours NaN", "finite"]);
    refused("gamma", &run(&["--gamma", "1"]), &["gamma", "1"]);
    refused("threads", &run(&["--threads", "0"]), &["--threads 0", "at least 1"]);
    refused("threads9", &run(&["--threads", "1000000"]), &["--threads 1000000", "smaller"]);
    refused("bench0", &["bench", "--n", "0"], &["--n 0"]);
    refused("bench9", &["bench", "--n", "9"], &["--n 9", "at least 512"]);
    refused("steps0", &["bench", "--steps", "0"], &["--steps 0"]);
}

#[test]
fn combinations_that_make_no_sense_are_refused() {
    refused("f64", &tiny(&["--backend", "wgpu", "--precision", "f64"]), &["--precision f32", "64-bit"]);
    refused("alone", &tiny(&["--alone"]), &["--alone", "--backend"]);
    refused("no-simd", &tiny(&["--backend", "reference", "--instructions", "portable"]), &["--instructions", "simd"]);
    refused("no-pool", &tiny(&["--backend", "reference", "--threads", "2"]), &["--threads", "simd"]);
    refused("no-wgpu", &tiny(&["--backend", "simd", "--adapter", "x"]), &["--adapter", "wgpu"]);
}

#[test]
#[cfg(target_os = "linux")]
fn a_graphics_backend_that_was_asked_for_by_name_is_not_skipped() {
    refused("wgpu", &tiny(&["--backend", "wgpu"]), &["--backend simd"]);
    refused("adapter", &tiny(&["--adapter", "no such adapter"]), &["--backend simd"]);
}

#[test]
fn what_the_reader_of_the_command_line_refuses_exits_with_2() {
    let place = Place::new("clap");
    for arguments in [&["run"][..], &["run", "sod", "--no-such-option"], &["walk"], &[]] {
        let output = place.etalon(arguments);
        assert_eq!(code(&output), Some(2), "{arguments:?}");
        assert!(!stderr(&output).is_empty());
    }
    refused("noscene", &["run"], &["<SCENE>", "not provided", "`etalon help`"]);
    refused("nooption", &tiny(&["--neighbour", "9"]), &["--neighbour", "similar", "--neighbours"]);
    refused("nocommand", &["walk"], &["unrecognized subcommand 'walk'", "`etalon help`"]);
    refused("conflict", &tiny(&["--start-file", "x.csv"]), &["--n", "cannot be used with", "--start-file"]);
    for arguments in [&["--help"][..], &["run", "--help"], &["--version"]] {
        let output = place.etalon(arguments);
        assert_eq!(code(&output), Some(0), "{arguments:?}");
        assert!(stderr(&output).is_empty() && stdout(&output).contains("etalon"), "{arguments:?}");
    }
    assert!(stdout(&place.etalon(&["--help"])).contains("etalon run sod"));
}

/// Everything below a folder with its contents.
fn contents(folder: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let mut all: Vec<_> =
        fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).map(|p| (p.clone(), fs::read(&p).unwrap())).collect();
    all.sort();
    all
}

#[test]
fn nothing_foreign_is_overwritten_and_a_failure_keeps_the_old_report() {
    let place = Place::new("out");
    fs::create_dir(place.path("thesis")).unwrap();
    fs::write(place.path("thesis/chapter.tex"), "years of work").unwrap();
    let output = place.etalon(&tiny(&["--backend", "simd", "--alone", "--out", "thesis"]));
    assert_eq!(code(&output), Some(2));
    assert!(stderr(&output).contains("--out"), "{}", stderr(&output));
    // Refused before anything ran.
    assert!(!stderr(&output).contains("steps"), "{}", stderr(&output));
    assert_eq!(contents(&place.path("thesis")).len(), 1);

    let good = tiny(&["--backend", "simd", "--precision", "f64", "--alone", "--out", "mine"]);
    assert_eq!(code(&place.etalon(&good)), Some(0));
    let before = contents(&place.path("mine"));
    assert_eq!(code(&place.etalon(&tiny(&["--scheme", "AVX", "--out", "mine"]))), Some(2));
    assert_eq!(contents(&place.path("mine")), before);
    // A report is replaced by the next one.
    assert_eq!(code(&place.etalon(&good)), Some(0));
    assert_ne!(contents(&place.path("mine")), before);
    assert_eq!(place.listing(), ["mine", "thesis"]);
}
