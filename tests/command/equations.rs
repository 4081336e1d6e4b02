//! `etalon audit`, `etalon show` and `etalon pages`.

use super::documented::Page;
use super::place::{Place, code, json, stderr, stdout};
use super::refused;
use serde_json::Value;
use std::fs;

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
