//! Tests of the plots that are drawn from plain data: heat map, Pareto front, series, picture.

use std::f64::consts::PI;

use etalon_spec::tables::{MetricKey, Results, SchemeName};

use super::super::ReportError;
use super::*;

/// Every element of the file is closed, by its own name.
fn assert_balanced(svg: &str) {
    let mut open: Vec<&str> = Vec::new();
    for tag in svg.split('<').skip(1) {
        let tag = tag.split('>').next().unwrap();
        let name = tag.split([' ', '\n']).next().unwrap();
        match name.strip_prefix('/') {
            Some(name) => assert_eq!(open.pop(), Some(name), "{tag}"),
            None if tag.ends_with('/') || name == "?xml" => {}
            None => open.push(name),
        }
    }
    assert!(open.is_empty(), "{open:?}");
}

/// The file is balanced and holds every one of the texts.
fn assert_shows(plot: &Plot, texts: &[&str]) {
    let svg = plot.svg();
    assert_balanced(&svg);
    for text in texts {
        assert!(
            svg.contains(&format!("\n{text}\n")) || svg.contains(&format!(">{text}<")),
            "{}: no `{text}`",
            plot.file
        );
    }
    for text in svg.split("<text ").skip(1) {
        let number = |name: &str| -> f64 {
            let value = text.split(&format!("{name}=\"")).nth(1).and_then(|rest| rest.split('"').next());
            value.unwrap().parse().unwrap()
        };
        assert!((0.0..=f64::from(canvas::WIDTH)).contains(&number("x")), "{}: {text}", plot.file);
    }
    keep(plot);
}

/// Leaves the plot in the folder that `ETALON_PLOTS` names, if it does, for those who want to see it.
fn keep(plot: &Plot) {
    if let Some(folder) = std::env::var_os("ETALON_PLOTS") {
        std::fs::write(std::path::Path::new(&folder).join(&plot.file), plot.svg()).unwrap();
    }
}

fn refusal(result: Result<Plot, ReportError>) -> String {
    result.expect_err("drawn in spite of bad input").to_string()
}

/// GS25, Table 7, and a made-up one of ours without turbulence.
fn table_7(file: &str, cells: CellText) -> HeatMap {
    let results = Results::load().unwrap();
    let names = ["ST", "ρ max", "S", "V", "KHI", "RTI", "WC", "T"];
    let column = |(key, name): (MetricKey, &str)| HeatColumn { name: name.into(), goal: results.metric(key).goal() };
    let published: Vec<Vec<Option<f64>>> = SchemeName::ALL
        .iter()
        .map(|&scheme| MetricKey::ALL.iter().map(|&key| Some(results.value(scheme, key))).collect())
        .collect();
    let mut ours = published.clone();
    for (row, values) in ours.iter_mut().enumerate() {
        values[7] = None;
        values[row] = values[row].map(|value| value * 1.1);
    }
    HeatMap {
        file: file.into(),
        title: "Schemes by tests".into(),
        caption: "Lighter is better.".into(),
        rows: SchemeName::ALL.iter().map(ToString::to_string).collect(),
        columns: MetricKey::ALL.into_iter().zip(names).map(column).collect(),
        matrices: vec![
            HeatMatrix { title: "published".into(), values: published },
            HeatMatrix { title: "ours".into(), values: ours },
        ],
        cells,
    }
}

#[test]
fn heat_maps_of_table_7() {
    let plot = heat_map(&table_7("heat.svg", CellText::Differences)).unwrap();
    // AVSWSLR's shock tube is at 6.24e-3, the best one at 2.97e-3: 110 % more. The vortex of AV: 5.80 against 1.22.
    assert_shows(&plot, &["published", "ours", "AVSLRB2F", "ρ max", "110", "375", "no value"]);
    // Nothing stands twice for each matrix but the names of rows, which stand once where matrices are side by side.
    assert_eq!(plot.svg().matches("\nAVSLRB2F\n").count(), 1);
    let plot = heat_map(&table_7("heat_values.svg", CellText::Values)).unwrap();
    assert_shows(&plot, &["published", "ours", "0.00624", "59.04", "−0.105"]);
    assert_eq!(plot.svg().matches("\nAVSLRB2F\n").count(), 2);
}

#[test]
fn long_names_of_columns_stand_upright() {
    let mut map = table_7("heat_names.svg", CellText::Differences);
    map.columns[4].name = "Kelvin-Helmholtz".into();
    let plot = heat_map(&map).unwrap();
    assert_shows(&plot, &["Kelvin-Helmholtz"]);
    assert!(plot.svg().contains("rotate(270"));
}

#[test]
fn bad_heat_maps_are_refused() {
    let good = table_7("heat.svg", CellText::Values);
    let mut map = good.clone();
    map.matrices[1].values[3][2] = Some(f64::NAN);
    let message = refusal(heat_map(&map));
    assert!(message.starts_with("heat.svg: matrix ours[AVSWSLR][S] is not a finite number"), "{message}");
    let mut map = good.clone();
    map.matrices[0].values.pop();
    assert!(refusal(heat_map(&map)).contains("one value or none"));
    let mut map = good;
    map.matrices.clear();
    assert!(refusal(heat_map(&map)).contains("at least one"));
}

/// Made-up sweeps: the error falls with resolution until arithmetic or the scheme stops it.
fn sweep() -> Pareto {
    let mut points = Vec::new();
    for (family, scheme, cost) in [("AV", 3.0, 1.0), ("AVSLRB2", 1.0, 1.6), ("AVSW", 1.9, 1.3)] {
        for (kind, floor, speed) in [("f32", 3e-4, 1.0), ("f64", 0.0, 1.9)] {
            for resolution in [50_u32, 100, 200, 400] {
                let size = f64::from(resolution);
                points.push(ParetoPoint {
                    cost: 2e-7 * cost * speed * size.powi(3),
                    error: scheme * 0.4 / size.powf(1.1) + floor,
                    label: format!("n = {resolution}"),
                    family: family.into(),
                    kind: kind.into(),
                });
            }
        }
    }
    Pareto {
        file: "pareto.svg".into(),
        title: "What buys a given error cheapest".into(),
        caption: "Down is closer, left is cheaper.".into(),
        cost: "time [s]".into(),
        error: "L₁(vₓ) [√(P₀/ρ₀)]".into(),
        points,
    }
}

#[test]
fn a_pareto_front_is_drawn_and_told() {
    let plot = pareto(&sweep()).unwrap();
    assert_shows(&plot, &["What buys a given error cheapest", "AVSLRB2", "f64", "n = 400", "time [s]"]);
    assert!(plot.caption.contains("cheaper and closer than the line: n = 50 AV f32 ("), "{}", plot.caption);
    // One point, without family or kind, and an error of zero.
    let point =
        |error| ParetoPoint { cost: 2.0, error, label: "one".into(), family: String::new(), kind: String::new() };
    let mut alone = sweep();
    (alone.file, alone.points) = ("pareto_alone.svg".into(), vec![point(1e-3), point(0.0)]);
    assert_shows(&pareto(&alone).unwrap(), &["one"]);
}

#[test]
fn bad_points_are_refused() {
    for (cost, error, expected) in [
        (f64::NAN, 1.0, "pareto.svg: cost of `n = 50` is not a finite number"),
        (1.0, f64::INFINITY, "pareto.svg: error of `n = 50` is not a finite number"),
        (0.0, 1.0, "must be above zero"),
        (1.0, -1.0, "not below zero"),
    ] {
        let mut plot = sweep();
        (plot.points[0].cost, plot.points[0].error) = (cost, error);
        let message = refusal(pareto(&plot));
        assert!(message.contains(expected), "{message}");
    }
    let empty = Pareto { points: vec![], ..sweep() };
    assert!(refusal(pareto(&empty)).contains("no points"));
}

/// Made-up growth of a mode for seven schemes.
fn growth(file: &str, logarithmic: bool, target: Option<SeriesTarget>) -> Series {
    let lines = SchemeName::ALL
        .iter()
        .map(|scheme| {
            let rate = 1.6 + 0.05 * f64::from(scheme.number());
            let points =
                (0..=3000).map(|step| f64::from(step) / 2000.0).map(|t| (t, 0.01 * (rate * t).exp())).collect();
            SeriesLine { label: scheme.to_string(), points }
        })
        .collect();
    Series {
        file: file.into(),
        title: "Amplitude of the seeded mode [Δv]".into(),
        caption: "Seven schemes.".into(),
        time: "t [L/Δv]".into(),
        logarithmic,
        lines,
        target,
    }
}

#[test]
fn series_with_every_target() {
    let value = SeriesTarget::Value { label: "McNally et al.".into(), value: 0.1479 };
    let plot = series(&growth("series.svg", true, Some(value))).unwrap();
    assert_shows(&plot, &["AV: 0.119", "AVSLRB2F: 0.186", "McNally et al.: 0.148", "t [L/Δv]"]);
    let band = SeriesTarget::Band { label: "other codes".into(), low: 0.12, high: 0.15 };
    let plot = series(&growth("series_band.svg", false, Some(band))).unwrap();
    assert_shows(&plot, &["other codes: 0.120 to 0.150"]);
    let points = (0..=15).map(|step| f64::from(step) / 10.0).map(|t| (t, 0.01 * (1.8 * t).exp())).collect();
    let curve = SeriesTarget::Curve { label: "exact".into(), points };
    let plot = series(&growth("series_curve.svg", true, Some(curve))).unwrap();
    assert_shows(&plot, &["exact"]);
    // No file grows with the number of steps: a thousand points a line, of 8 to 10 signs each.
    assert!(plot.svg().len() < 7 * 12_000 + 30_000, "{}", plot.svg().len());
    // A single point is a line too.
    let mut short = growth("series_short.svg", false, None);
    short.lines.truncate(1);
    short.lines[0].points.truncate(1);
    assert_shows(&series(&short).unwrap(), &["AV: 0.0100"]);
}

#[test]
fn bad_series_are_refused() {
    let good = growth("series.svg", true, None);
    let with = |change: &dyn Fn(&mut Series)| {
        let mut plot = good.clone();
        change(&mut plot);
        refusal(series(&plot))
    };
    for (message, expected) in [
        (with(&|plot| plot.lines[1].points[5].1 = f64::NAN), "series.svg: AVSW.value[5] is not a finite number"),
        (with(&|plot| plot.lines[0].points[0].0 = f64::NEG_INFINITY), "series.svg: AV.time[0] is not a finite number"),
        (with(&|plot| plot.lines[0].points.swap(3, 9)), "times do not rise"),
        (with(&|plot| plot.lines[0].points.clear()), "no points"),
        (with(&|plot| plot.lines.clear()), "no lines"),
        (
            with(&|plot| plot.target = Some(SeriesTarget::Value { label: "exact".into(), value: f64::NAN })),
            "series.svg: exact is not a finite number",
        ),
        (
            with(&|plot| plot.target = Some(SeriesTarget::Band { label: "codes".into(), low: 2.0, high: 1.0 })),
            "above the upper one",
        ),
    ] {
        assert!(message.contains(expected), "{message}");
    }
}

/// A rolled-up layer, as a Kelvin-Helmholtz run leaves one.
fn rolled([x, y]: [f64; 2]) -> f64 {
    let (dx, dy) = (x - 0.5, y - 0.5);
    let turn = 3.0 * (-8.0 * (dx * dx + dy * dy)).exp();
    let turned = dy * turn.cos() - dx * turn.sin();
    1.5 + 0.5 * (turned * 24.0).tanh() * (PI * x).sin().abs().max(0.4)
}

/// A disordered lattice of that many points a side on the unit square.
fn cloud(side: u32) -> Vec<[f64; 2]> {
    let mut seed = 7_u32;
    let mut noise = || {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(seed >> 8) / f64::from(1 << 24) - 0.5
    };
    let places = (0..side * side).map(|place| [place % side, place / side]);
    places.map(|place| place.map(|index| (f64::from(index) + 0.5 + 0.6 * noise()) / f64::from(side))).collect()
}

fn picture(file: &str, window: Window) -> FieldMap {
    FieldMap {
        file: file.into(),
        title: "Density at t = 1.5".into(),
        caption: "A rolled-up layer.".into(),
        field: "ρ [ρ₀]".into(),
        axes: ["x [L]".into(), "y [L]".into()],
        window,
        range: None,
        pixels: 200,
    }
}

const UNIT: Window = Window { low: [0.0, 0.0], high: [1.0, 1.0], periodic: [true, true] };

#[test]
fn pictures_of_particles() {
    let points = cloud(60);
    let values: Vec<f64> = points.iter().map(|&point| rolled(point)).collect();
    let plot = field_map(&picture("map_nearest.svg", UNIT), nearest(&points, &values, UNIT).unwrap()).unwrap();
    assert_shows(&plot, &["Density at t = 1.5", "ρ [ρ₀]", "x [L]", "↑ y [L]"]);
    assert!(plot.svg().contains("href=\"data:image/png;base64,"));
    let lengths = vec![1.2 / 60.0; points.len()];
    let kernel = |q: f64| (2.0 - q).powi(4) * (1.0 + 2.0 * q);
    let smooth = smoothed(&points, &values, &lengths, UNIT, kernel, 2.0).unwrap();
    assert_shows(&field_map(&picture("map_smoothed.svg", UNIT), smooth).unwrap(), &["0", "1", "Density at t = 1.5"]);
    // Tall, flat, constant, with a hole, and with a scale of its own.
    let tall = Window { low: [0.0, 0.0], high: [1.0, 2.0], periodic: [true, false] };
    assert_shows(&field_map(&picture("map_tall.svg", tall), |[x, y]| Some(rolled([x, y / 2.0]))).unwrap(), &["2"]);
    let flat = Window { low: [0.0, -5.0], high: [40.0, 5.0], periodic: [false, false] };
    let hole = |[x, y]: [f64; 2]| (x.hypot(y) > 2.0).then_some(7.0);
    assert_shows(&field_map(&picture("map_flat.svg", flat), hole).unwrap(), &["3.5", "10.5"]);
    let shared = FieldMap { range: Some((0.0, 4.0)), ..picture("map_shared.svg", UNIT) };
    assert_shows(&field_map(&shared, |point| Some(rolled(point))).unwrap(), &["0", "4", "3"]);
}

#[test]
fn bad_pictures_are_refused() {
    let with = |change: &dyn Fn(&mut FieldMap), value: Option<f64>| {
        let mut map = picture("map.svg", UNIT);
        change(&mut map);
        refusal(field_map(&map, move |_| value))
    };
    for (message, expected) in [
        (with(&|_| {}, Some(f64::NAN)), "is not a finite number"),
        (with(&|_| {}, None), "no value anywhere"),
        (with(&|map| map.window.high[1] = 0.0, Some(1.0)), "window, axis 1: the upper end"),
        (with(&|map| map.window.low[0] = f64::NAN, Some(1.0)), "window.low[0] is not a finite number"),
        (with(&|map| map.range = Some((1.0, 1.0)), Some(1.0)), "map.svg: range: the upper end"),
        (with(&|map| map.pixels = 5000, Some(1.0)), "2 to 1000"),
    ] {
        assert!(message.contains(expected), "{message}");
    }
    let points = [[0.5, 0.5], [0.1, f64::INFINITY]];
    let refused = |result: Result<(), ReportError>| result.unwrap_err().to_string();
    assert!(refused(nearest(&points, &[1.0, 2.0], UNIT).map(drop)).starts_with("particles[1].y is not"));
    assert!(refused(nearest(&points, &[1.0], UNIT).map(drop)).contains("one value a particle"));
    assert!(refused(nearest(&[], &[], UNIT).map(drop)).contains("there are none"));
    let one = |lengths: &[f64], support: f64| {
        refused(smoothed(&points[..1], &[1.0], lengths, UNIT, |_| 1.0, support).map(drop))
    };
    assert!(one(&[0.0], 2.0).contains("particles[0].length: it must be above zero"));
    assert!(one(&[1.0], f64::NAN).starts_with("support is not a finite number"));
}

/// The cells find what trying all particles finds, in windows of every shape, periodic or not.
#[test]
fn cells_miss_no_particle() {
    for (stretch, side) in [([1.0, 1.0], 12), ([5.0, 0.2], 9), ([1e-3, 1.0], 5), ([2.0, 2.0], 1)] {
        for periodic in [[false, false], [true, true], [true, false]] {
            let window = Window { low: [-0.5, 3.0], high: [-0.5 + stretch[0], 3.0 + stretch[1]], periodic };
            let place = |point: [f64; 2]| [0, 1].map(|axis| window.low[axis] + point[axis] * stretch[axis]);
            let points: Vec<[f64; 2]> = cloud(side).into_iter().map(place).collect();
            let values: Vec<f64> = (0..points.len()).map(|index| index as f64).collect();
            let distance = |one: [f64; 2], other: [f64; 2]| {
                let along = |axis: usize| {
                    let difference = (one[axis] - other[axis]).abs();
                    if periodic[axis] { difference.min(stretch[axis] - difference) } else { difference }
                };
                along(0).hypot(along(1))
            };
            let near = nearest(&points, &values, window).unwrap();
            let length = 0.3 * stretch[0].min(stretch[1]);
            let lengths = vec![length; points.len()];
            let smooth = smoothed(&points, &values, &lengths, window, |q| 2.0 - q, 2.0).unwrap();
            for at in cloud(17).into_iter().map(place) {
                let all = points.iter().map(|&point| distance(point, at));
                let found = distance(points[near(at).unwrap() as usize], at);
                // Both round a difference, a square and a root: some units of the last digit of the window's corner.
                let best = all.clone().fold(f64::INFINITY, f64::min);
                assert!((found - best).abs() <= 16.0 * f64::EPSILON * 5.0, "{found} is not {best}");
                let weights = all.map(|distance| (2.0 - distance / length).max(0.0));
                let (sum, total) = weights
                    .zip(&values)
                    .fold((0.0, 0.0), |(sum, total), (weight, value)| (sum + weight * value, total + weight));
                match smooth(at) {
                    // A weight of the last digit may be zero here and not there; it then weighs nothing either way.
                    None => assert!(total < 1e-9, "{total}"),
                    Some(mean) if total > 1e-6 => {
                        // Weights are off by some units of the last digit of distances over lengths, the values go to 143.
                        let tolerance = 143.0 * 64.0 * f64::EPSILON * 5.0 / length / total;
                        let error = (mean - sum / total).abs();
                        assert!(error <= tolerance, "error {error:e} > tolerance {tolerance:e}");
                    }
                    Some(_) => {}
                }
            }
        }
    }
}
