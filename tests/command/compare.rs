//! `etalon compare` as users run it, and snapshots as other programs write and read them.

use super::documented::Page;
use super::place::{Place, stderr, stdout};
use etalon::snapshot::{Column, Format, Frame, Snapshot};
use serde_json::Value;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name)
}

/// A step in density, in two dimensions; the second version of it has one density off by `error`.
fn tube(error: f64) -> Snapshot {
    let count = 40;
    let x: Vec<f64> = (0..count).map(|i| (f64::from(i) + 0.5) / f64::from(count) - 0.5).collect();
    let mut density: Vec<f64> = x.iter().map(|x| if *x < 0.0 { 1.0 } else { 0.125 }).collect();
    density[7] += error;
    let columns = vec![
        Column::new("velocity_x", "L T^-1", x.iter().map(|x| 0.5 - x).collect()),
        Column::new("velocity_y", "L T^-1", vec![0.0; x.len()]),
        Column::new("density", "M L^-nu", density),
        Column::new("y", "L", x.iter().map(|x| 0.1 * x.abs()).collect()),
        Column::new("x", "L", x),
    ];
    let frame = Frame { lower: vec![-0.5, 0.0], upper: vec![0.5, 0.1], periodic: vec![false, true] };
    Snapshot::new(2, columns).unwrap().at_time(0.2).in_frame(frame).unwrap()
}

#[test]
fn two_snapshots_are_compared_in_any_formats() {
    let place = Place::new("compare-formats");
    tube(0.0).write(&place.path("a.hdf5"), Format::Hdf5).unwrap();
    for (name, format) in [("b.hdf5", Format::Hdf5), ("b.vtu", Format::Vtu), ("b.csv", Format::Csv)] {
        tube(0.25).write(&place.path(name), format).unwrap();
        let output = place.etalon(&["compare", "a.hdf5", name, "--tolerance", "0.01"]);
        let table = stdout(&output);
        assert_eq!(output.status.code(), Some(1), "{name}: {table}{}", stderr(&output));
        assert!(table.contains("40 pairs by position") && table.contains("; all"), "{table}");
        let row = table.lines().find(|line| line.starts_with("density")).unwrap_or_else(|| panic!("{table}"));
        assert!(row.contains(" 7  "), "the particle is not named: {row}");
        assert!(table.contains("FAIL beyond 0.01: density\n"), "{table}");
        // HDF5 moves places to a box that begins at zero, and back.
        let output = place.etalon(&["compare", "a.hdf5", name, "--tolerance", "0.5"]);
        assert_eq!(output.status.code(), Some(0), "{name}: {}", stdout(&output));
        assert!(stdout(&output).contains("within 0.5: every field"), "{}", stdout(&output));
    }
}

#[test]
fn the_json_is_documented_and_the_plots_are_there() {
    let place = Place::new("compare-json");
    let (mut fewer, ids) = (tube(0.25).columns().to_vec(), (0..39).collect());
    fewer.iter_mut().for_each(|column| column.values.truncate(39));
    fewer.push(Column::new("mass", "M", vec![1.0; 39]));
    fewer.retain(|column| column.name != "velocity_y");
    let fewer = Snapshot::new(2, fewer).unwrap().with_ids(ids).unwrap().at_time(0.2);
    tube(0.0).with_ids((0..40).collect()).unwrap().write(&place.path("a.hdf5"), Format::Hdf5).unwrap();
    fewer.write(&place.path("b.csv"), Format::Csv).unwrap();
    let mut page = Page::read("compare-schema.md");
    let arguments =
        ["a.hdf5", "b.csv", "--json", "--along", "r", "--bins", "12", "--out", "out", "--tolerance", "1e-3"];
    let output = place.etalon(&[&["compare"], &arguments[..]].concat());
    let found: Value = serde_json::from_str(stdout(&output)).unwrap_or_else(|e| panic!("{e}: {}", stderr(&output)));
    page.check(&found);
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(found["matched"], serde_json::json!({ "pairs": 39, "unmatched_a": 1, "unmatched_b": 0 }));
    assert_eq!((&found["only_in_a"][0], &found["only_in_b"][0]), (&"velocity_y".into(), &"mass".into()));
    assert_eq!(found["tolerance"]["beyond"], serde_json::json!(["density"]));
    assert_eq!(found["fields"][0]["at"]["id"], 7);
    // 0.25 of the first one's root mean square: half of it 1, half 1/8.
    let scale = ((1.0 + 0.125 * 0.125) / 2.0_f64).sqrt();
    assert!(
        (found["fields"][0]["relative_max"].as_f64().unwrap() - 0.25 / scale).abs() < 1e-14,
        "{}",
        found["fields"][0]
    );
    assert_eq!(std::fs::read_to_string(place.path("out/compare.json")).unwrap(), stdout(&output));
    for file in ["profile_density.svg", "difference_density.svg", "profile_velocity_x.svg"] {
        let svg = std::fs::read_to_string(place.path("out").join(file)).unwrap();
        assert!(svg.contains("a.hdf5") && svg.contains("b.csv"), "{file}");
    }
    // Again, into the same folder; not into one of something else.
    let again =
        place.etalon(&["compare", "a.hdf5", "b.csv", "--json", "--by", "position", "--within", "0.01", "--out", "out"]);
    assert_eq!(again.status.code(), Some(0), "{}", stderr(&again));
    page.check(&serde_json::from_str(stdout(&again)).unwrap());
    page.all_seen();
    let only_profiles = place.etalon(&["compare", "a.hdf5", "b.csv", "--json", "--by", "profile"]);
    page.check(&serde_json::from_str(stdout(&only_profiles)).unwrap());
    let refused = place.etalon(&["compare", "a.hdf5", "b.csv", "--out", "."]);
    assert_eq!(refused.status.code(), Some(2));
    assert_eq!(stderr(&refused), "etalon: --out .: it is not empty and holds no comparison; name another folder\n");
}

#[test]
fn bad_input_gives_one_sentence_that_names_the_file() {
    let place = Place::new("compare-bad");
    tube(0.0).write(&place.path("a.hdf5"), Format::Hdf5).unwrap();
    let whole = std::fs::read(place.path("a.hdf5")).unwrap();
    std::fs::write(place.path("cut.hdf5"), &whole[..whole.len() / 2]).unwrap();
    std::fs::write(place.path("bad.csv"), "x,y,density\n0,0,1\n1,0,NaN\n").unwrap();
    std::fs::write(place.path("a.dat"), "1 2 3\n").unwrap();
    let line = Snapshot::new(1, vec![Column::new("x", "", vec![0.0])]).unwrap();
    line.write(&place.path("line.csv"), Format::Csv).unwrap();
    for (arguments, expected) in [
        (&["a.hdf5", "cut.hdf5"][..], "etalon: cut.hdf5: "),
        (&["a.hdf5", "bad.csv"], "etalon: bad.csv: line 3: density is `NaN`; it must be a finite number\n"),
        (
            &["a.hdf5", "a.dat"],
            "etalon: a.dat: its ending says no format of a snapshot; the endings are .hdf5, .h5, .vtu, .csv\n",
        ),
        (&["a.hdf5", "none.csv"], "etalon: cannot read none.csv: "),
        (&["a.hdf5", "line.csv"], "etalon: the first snapshot has 2 dimensions and the second 1;"),
        (&["a.hdf5", "a.hdf5", "--by", "id"], "etalon: the particles of the first snapshot have no ids;"),
        (&["a.hdf5", "a.hdf5", "--along", "z"], "etalon: there is no axis z in 2 dimensions\n"),
        (&["a.hdf5", "a.hdf5", "--along", "w"], "etalon: --along w: there are x, y, z, r; choose one of them\n"),
        (
            &["a.hdf5", "a.hdf5", "--by", "name"],
            "etalon: --by name: there are id, position, profile; choose one of them\n",
        ),
        (&["a.hdf5", "a.hdf5", "--tolerance", "-1"], "etalon: --tolerance: it must not be negative\n"),
    ] {
        let output = place.etalon(&[&["compare"], arguments].concat());
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {}", stdout(&output));
        assert!(stderr(&output).starts_with(expected), "{arguments:?}: {}", stderr(&output));
        assert_eq!((stderr(&output).lines().count(), stdout(&output)), (1, ""), "{arguments:?}");
    }
}

/// Files that the C library made in the ways of two codes (`tests/data/make.py`); both hold the same gas.
#[test]
fn files_of_other_codes_are_read() {
    let (gadget, swift) = (Snapshot::read(&data("gadget.hdf5")).unwrap(), Snapshot::read(&data("swift.hdf5")).unwrap());
    assert_eq!((gadget.dimension(), swift.dimension()), (3, 2));
    for snapshot in [&gadget, &swift] {
        assert_eq!((snapshot.time(), snapshot.ids()), (Some(0.25), Some(&[3, 1, 2][..])));
        for (name, values) in [
            ("x", [0.125, 0.5, 0.75]),
            ("y", [0.25, 0.75, 0.5]),
            ("velocity_y", [0.0, 2.0, 0.0]),
            ("mass", [0.5; 3]),
            ("internal_energy", [1.5, 2.5, 3.5]),
            ("density", [1.0, 2.0, 4.0]),
            ("smoothing_length", [0.25, 0.5, 0.125]),
        ] {
            assert_eq!(snapshot.column(name), Some(&values[..]), "{name}");
        }
    }
    assert_eq!(gadget.column("z"), Some(&[0.5, 0.25, 0.125][..]));
}

#[test]
fn a_header_that_claims_a_million_million_million_numbers_allocates_nothing() {
    for name in ["absurd.hdf5", "absurd_chunks.hdf5"] {
        let message = Snapshot::read(&data(name)).unwrap_err().to_string();
        assert!(
            message.contains("PartType0/Coordinates claims 333333333333333333 rows of 3 numbers, more than the file"),
            "{message}"
        );
    }
}

/// What the C library, by way of h5py, finds in our files. `ETALON_PYTHON` names another Python than `python3`.
#[test]
fn the_c_library_reads_what_we_write() {
    let python = std::env::var("ETALON_PYTHON").unwrap_or_else(|_| "python3".into());
    let has_h5py =
        Command::new(&python).args(["-c", "import h5py"]).output().is_ok_and(|output| output.status.success());
    if !has_h5py {
        // Straight to the terminal: what the test harness captures of a test that passes is never seen.
        let _ = writeln!(std::io::stderr(), "SKIPPED: {python} has no h5py");
        return;
    }
    let place = Place::new("compare-h5py");
    let path = place.path("a.hdf5");
    tube(0.0).with_ids((100..140).collect()).unwrap().write(&path, Format::Hdf5).unwrap();
    let output = Command::new(&python).arg(data("make.py")).arg("read").arg(&path).output().unwrap();
    let found: Value = serde_json::from_slice(&output.stdout).unwrap_or_else(|e| panic!("{e}: {}", stderr(&output)));
    let (header, gas) = (&found["header"], &found["gas"]);
    assert_eq!(header["NumPart_ThisFile"], serde_json::json!([40, 0, 0, 0, 0, 0]));
    assert_eq!((&header["Time"], &header["BoxSize"], &header["Dimension"]), (&0.2.into(), &1.0.into(), &2.into()));
    let snapshot = tube(0.0);
    let column = |name: &str| snapshot.column(name).unwrap().to_vec();
    assert_eq!(gas["Density"], serde_json::json!(column("density")));
    assert_eq!(gas["ParticleIDs"], serde_json::json!((100..140).collect::<Vec<u64>>()));
    let rows = |[x, y]: [Vec<f64>; 2]| x.into_iter().zip(y).map(|(x, y)| [x, y, 0.0]).collect::<Vec<_>>();
    assert_eq!(gas["Velocities"], serde_json::json!(rows([column("velocity_x"), column("velocity_y")])));
    let shifted = column("x").into_iter().map(|x| x + 0.5).collect();
    assert_eq!(gas["Coordinates"], serde_json::json!(rows([shifted, column("y")])));
    assert_eq!((&found["units"]["Density"], &found["units"]["Coordinates"]), (&"M L^-nu".into(), &"L".into()));
}
