//! Scenes as they are listed, explained, written down and read.

use super::documented::Page;
use super::place::{Place, code, json, stderr, stdout};
use std::fs;

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
