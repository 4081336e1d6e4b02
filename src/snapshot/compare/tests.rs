use super::*;
use crate::snapshot::testing::small;
use crate::snapshot::{Column, Frame};

fn message(a: &Snapshot, b: &Snapshot, options: &Options) -> String {
    compare(a, b, options).unwrap_err().to_string()
}

fn snapshot(columns: &[(&str, Vec<f64>)], ids: &[u64]) -> Snapshot {
    let dimension = columns.iter().filter(|(name, _)| ["x", "y", "z"].contains(name)).count();
    let columns = columns.iter().map(|(name, values)| Column::new(*name, "", values.clone())).collect();
    let made = Snapshot::new(dimension, columns).unwrap();
    if ids.is_empty() { made } else { made.with_ids(ids.to_vec()).unwrap() }
}

#[test]
fn a_snapshot_does_not_differ_from_itself() {
    for by in By::ALL {
        let found = compare(&small(3), &small(3), &Options { by: Some(*by), ..Options::default() }).unwrap();
        assert!(found.beyond(0.0).is_empty(), "{by}");
        assert!(found.only_in_a.is_empty() && found.only_in_b.is_empty());
        // Positions have no profile.
        assert_eq!((found.fields.len(), found.profiles.len()), (if *by == By::Profile { 0 } else { 11 }, 8), "{by}");
    }
}

/// Four particles in another order, one density off by 0.5, velocities off by 0.3 along one axis.
#[test]
fn norms_scales_and_places_are_those_of_the_difference() {
    let x = vec![0.0, 1.0, 2.0, 3.0];
    let a = snapshot(
        &[("x", x), ("density", vec![1.0, 1.0, 1.0, 7.0]), ("velocity_x", vec![3.0; 4]), ("velocity_y", vec![4.0; 4])],
        &[10, 11, 12, 13],
    );
    let b = snapshot(
        &[
            ("x", vec![3.0, 2.0, 1.0, 0.0]),
            ("density", vec![7.0, 1.5, 1.0, 1.0]),
            ("velocity_x", vec![3.3; 4]),
            ("mass", vec![1.0; 4]),
        ],
        &[13, 12, 11, 10],
    );
    let found = compare(&a, &b, &Options::default()).unwrap();
    assert_eq!(
        (found.by, found.only_in_a.as_slice(), found.only_in_b.as_slice()),
        ("id", &["velocity_y".to_string()][..], &["mass".to_string()][..])
    );
    let field = |name: &str| found.fields.iter().find(|field| field.name == name).unwrap();
    let density = field("density");
    // sqrt((3 + 49) / 4), and 0.5 in one of four.
    let scale = 13f64.sqrt();
    let close = |found: f64, expected: f64| {
        assert!((found - expected).abs() <= 4.0 * f64::EPSILON * expected, "{found} {expected}")
    };
    close(density.scale, scale);
    close(density.l1, 0.125);
    close(density.rms, 0.25);
    close(density.relative_max, 0.5 / scale);
    assert_eq!(density.at, Place { id: 12, position: vec![2.0], a: 1.0, b: 1.5 });
    // A vector's scale is that of all its components.
    close(field("velocity_x").scale, 5.0);
    assert_eq!(field("x").max, 0.0);
    assert_eq!(found.beyond(0.1), ["density"]);
    assert_eq!(found.beyond(0.05), ["density", "velocity_x"]);
}

#[test]
fn particles_are_matched_by_position_round_the_corner_and_both_ways() {
    let frame = Frame { lower: vec![0.0, 0.0], upper: vec![1.0, 1.0], periodic: vec![true, false] };
    let at = |x: Vec<f64>, y: Vec<f64>| snapshot(&[("x", x), ("y", y)], &[]).in_frame(frame.clone()).unwrap();
    let a = at(vec![0.01, 0.5, 0.52], vec![0.5, 0.01, 0.01]);
    // The first round the corner in x; one near two of the others; one round the corner in y, where there is none.
    let b = at(vec![0.53, 0.99, 0.5], vec![0.01, 0.5, 0.99]);
    let found = Matching::by_position(&a, &b, Some(0.05)).unwrap();
    assert_eq!(found.pairs, [(0, 1), (2, 0)]);
    let found = compare(&a, &b, &Options { within: Some(0.05), ..Options::default() }).unwrap();
    assert_eq!(found.matched, Some(Matched { pairs: 2, unmatched_a: 1, unmatched_b: 1, within: Some(0.05) }));
    let x = found.fields.iter().find(|field| field.name == "x").unwrap();
    assert!((x.max - 0.02).abs() < 1e-15, "{x:?}");
}

/// Against looking at all pairs.
#[test]
fn the_nearest_are_the_nearest() {
    use rand::{RngExt, SeedableRng};
    let mut random = rand_pcg::Pcg64Mcg::seed_from_u64(5);
    let mut cloud = |count: usize| {
        let mut column = || (0..count).map(|_| random.random::<f64>()).collect::<Vec<_>>();
        snapshot(&[("x", column()), ("y", column()), ("z", column())], &[])
    };
    let (a, b) = (cloud(150), cloud(200));
    let within = 0.1;
    let apart = |i: usize, j: usize| -> f64 {
        a.position().iter().zip(b.position()).map(|(x, y)| (x[i] - y[j]).powi(2)).sum::<f64>().sqrt()
    };
    let best_b = |i: usize| (0..b.len()).min_by(|j, k| apart(i, *j).total_cmp(&apart(i, *k))).unwrap();
    let best_a = |j: usize| (0..a.len()).min_by(|i, k| apart(*i, j).total_cmp(&apart(*k, j))).unwrap();
    let expected: Vec<_> =
        (0..a.len()).map(|i| (i, best_b(i))).filter(|&(i, j)| best_a(j) == i && apart(i, j) <= within).collect();
    assert!(expected.len() > 30, "{}", expected.len());
    assert_eq!(Matching::by_position(&a, &b, Some(within)).unwrap().pairs, expected);
}

#[test]
fn profiles_have_mean_and_scatter() {
    let a = snapshot(&[("x", vec![0.0, 0.4, 2.0]), ("y", vec![0.0; 3]), ("density", vec![1.0, 3.0, 5.0])], &[]);
    let b = snapshot(&[("x", vec![0.2, 1.9]), ("y", vec![0.0; 2]), ("density", vec![2.5, 4.0])], &[]);
    let options = Options { by: Some(By::Profile), bins: 4, ..Options::default() };
    let found = compare(&a, &b, &options).unwrap();
    let profile = &found.profiles[0];
    assert_eq!(profile.bins[0].a, Some(BinValue { particles: 2, mean: 2.0, scatter: 1.0 }));
    assert_eq!(profile.bins[0].b, Some(BinValue { particles: 1, mean: 2.5, scatter: 0.0 }));
    assert_eq!((profile.bins[1].a, profile.bins[1].difference()), (None, None));
    assert_eq!((profile.bins[3].difference(), profile.max, profile.at), (Some(-1.0), 1.0, 1.75));
    assert_eq!((profile.l1, found.matched), (0.75, None));
    let radius = Options { along: Along::Radius, centre: Some(vec![2.0, 0.0]), ..options.clone() };
    let found = compare(&a, &b, &radius).unwrap();
    assert_eq!(found.profiles[0].bins[0].a.unwrap().mean, 5.0);
    assert_eq!(found.centre, Some(vec![2.0, 0.0]));
}

#[test]
fn what_cannot_be_compared_is_refused() {
    let usual = Options::default();
    assert!(message(&small(2), &small(3), &usual).starts_with("the first snapshot has 2 dimensions and the second 3;"));
    let bare = snapshot(&[("x", vec![0.0, 1.0])], &[]);
    let named = |ids: &[u64]| snapshot(&[("x", vec![0.0, 1.0])], ids);
    let by_id = Options { by: Some(By::Id), ..usual.clone() };
    assert!(message(&named(&[1, 2]), &bare, &by_id).contains("of the second snapshot have no ids"));
    assert!(message(&named(&[1, 2]), &named(&[3, 4]), &usual).contains("no id is in both"));
    let far = snapshot(&[("x", vec![10.0])], &[]);
    assert!(message(&bare, &far, &usual).contains("use --within or --by profile"));
    let with = |options: Options| message(&bare, &bare, &options);
    assert!(with(Options { within: Some(-1.0), ..usual.clone() }).contains("particles within -1 were asked for"));
    assert!(with(Options { bins: 0, ..usual.clone() }).contains("there may be 1 to 100000"));
    assert!(with(Options { along: Along::Axis(1), ..usual.clone() }).contains("there is no axis y in 1 dimensions"));
    let centre = Options { along: Along::Radius, centre: Some(vec![0.0, 0.0]), ..usual };
    assert!(with(centre).contains("no point of 1 finite coordinates"));
}
