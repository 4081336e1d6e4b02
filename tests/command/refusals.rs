//! What is refused, and what is never overwritten.

use super::place::{Place, code, stderr, stdout};
use super::{refused, tiny};
use std::fs;
use std::path::{Path, PathBuf};

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
