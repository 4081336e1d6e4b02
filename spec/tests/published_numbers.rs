//! The numbers of all three papers in one form: complete, in agreement with each other, and broken files refused.

use std::collections::BTreeSet;

use etalon_spec::tables::{
    Factor, Goal, MembraneSettings, MembraneVariant, MetricKey, Place, Published, Says, Scene, SchemeName, Schemes,
    Variant, parse_published, published,
};
use etalon_spec::{Paper, Unit};

fn all() -> &'static [Published] {
    published().unwrap_or_else(|error| panic!("{error}"))
}

fn at(paper: Paper, place: Place) -> impl Iterator<Item = &'static Published> {
    all().iter().filter(move |number| (number.paper, number.place) == (paper, place))
}

#[test]
fn every_place_has_its_rows() {
    let mut counts: Vec<(String, usize)> = Vec::new();
    for number in all() {
        let place = format!("{} {}", number.paper, number.place);
        match counts.last_mut() {
            Some((last, count)) if *last == place => *count += 1,
            _ => counts.push((place, 1)),
        }
    }
    let counts: Vec<(&str, usize)> = counts.iter().map(|(place, count)| (place.as_str(), *count)).collect();
    assert_eq!(
        counts,
        [
            ("gs25 Table 3", 6),
            ("gs25 Table 4", 6),
            ("gs25 Table 5", 12),
            ("gs25 Table 6", 7),
            ("gs25 Table 7", 56),
            ("gs25 Fig. 11", 6),
            ("gs25 Eq. 29", 1),
            ("pl20 Fig. 1", 3),
            ("pl20 Fig. 3", 7),
            ("pl20 Fig. 4", 6),
            ("pl20 Fig. 5", 6),
            ("c25 Fig. 1", 10),
            ("c25 Fig. 7", 4),
            ("c25 Fig. 8", 1),
        ]
    );
}

/// Tables 3 to 6 are typed in from their own place in the paper, so a slip in either table shows here.
#[test]
fn tables_3_to_6_agree_with_table_7() {
    let mut compared = 0;
    for table in 3..=6 {
        for number in at(Paper::Gs25, Place::Table(table)) {
            if number.quantity == "wind_cloud_later_destruction_rate" {
                continue;
            }
            let same = |other: &&Published| (&other.quantity, other.scheme) == (&number.quantity, number.scheme);
            let other = at(Paper::Gs25, Place::Table(7)).find(same).expect("Table 7 has every scheme");
            assert_eq!(number.value, other.value, "{} {} in Table {table}", number.quantity, number.scheme);
            assert_eq!((number.scene, &number.run), (other.scene, &other.run));
            assert_eq!((number.better, number.unit), (other.better, other.unit));
            assert_eq!((&number.meaning, &number.time), (&other.meaning, &other.time));
            compared += 1;
        }
    }
    assert_eq!(compared, 6 + 6 + 6 + 7);
}

/// The ranking that the paper's text draws from Table 5: by the earlier time, in the order of the table.
#[test]
fn the_wind_cloud_rates_rank_as_the_text_says() {
    let rates = |quantity: &str| -> Vec<f64> {
        let rows = at(Paper::Gs25, Place::Table(5)).filter(|number| number.quantity == quantity);
        rows.map(|number| number.better.badness(number.value.unwrap())).collect()
    };
    assert!(rates("wind_cloud_destruction_rate").is_sorted_by(|worse, better| better < worse));
    let later = rates("wind_cloud_later_destruction_rate");
    assert_eq!(later, [-0.121, -0.119, -0.127, -0.152, -0.174, -0.214]);
}

#[test]
fn every_scheme_is_known() {
    let schemes = Schemes::load().unwrap();
    let known: BTreeSet<&str> = schemes.iter().map(|scheme| scheme.name.as_str()).collect();
    let membrane = MembraneSettings::load().unwrap();
    for number in all() {
        match (number.paper, number.scheme) {
            (Paper::Gs25, Variant::Scheme(name)) => assert!(known.contains(name.as_str()), "{name}"),
            (Paper::Gs25, Variant::Membrane(name)) => assert_eq!(membrane.get(name).name, name),
            (Paper::Pl20, Variant::Drag(_)) | (Paper::C25, Variant::Rung(_) | Variant::GradH(_)) => {}
            (paper, variant) => panic!("{paper} does not compare {variant}"),
        }
    }
}

#[test]
fn values_stand_in_their_unit() {
    let velocity: Unit = "L T^-1".parse().unwrap();
    let first = at(Paper::Gs25, Place::Table(3)).next().unwrap();
    // Printed value, quotient and literal are each rounded once, by half a unit of 2^-52 at most: 3/2 units in all.
    let close = |found: f64, expected: f64| (found - expected).abs() <= 1.5 * f64::EPSILON * expected.abs();
    assert!(close(first.value.unwrap(), 0.0287));
    let Goal::Target(target) = first.better else { panic!("{:?}", first.better) };
    assert!(close(target, 0.1479));
    assert_eq!((first.unit, first.scene, first.run.as_deref()), (velocity, Scene::KelvinHelmholtz, Some("KH1")));
    let shock: Vec<(Option<u32>, f64)> = at(Paper::Pl20, Place::Figure(5))
        .filter(|number| number.quantity == "dustyshock_l1")
        .filter_map(|number| Some((number.resolution, number.value?)))
        .collect();
    for ((found, value), (resolution, expected)) in shock.iter().zip([(128, 1.4e-2), (256, 6.6e-3), (512, 4.0e-3)]) {
        assert_eq!(*found, Some(resolution));
        assert!(close(*value, expected), "{value} is not {expected}");
    }
    assert_eq!(shock.len(), 3);
}

#[test]
fn what_is_lost_says_so() {
    let lost: Vec<&Published> = all().iter().filter(|number| number.value.is_none()).collect();
    assert!(lost.iter().all(|number| number.note.is_some() && number.says == Says::Exactly));
    // The panels of GS25's Fig. 11, two curves of PL20's Fig. 5 and the one left out of its Fig. 3, and of C25 all but
    // the reach of the last rung and the bound on the mean factor.
    assert_eq!(lost.len(), 6 + 2 + 1 + (15 - 2));
    let bound = at(Paper::Gs25, Place::Equation(29)).next().unwrap();
    assert_eq!((bound.says, bound.value, bound.run.as_deref()), (Says::AtMost, Some(0.06), Some("KH6")));
}

#[test]
fn goals_rank() {
    assert!(Goal::Lower.badness(1.0) < Goal::Lower.badness(2.0));
    assert!(Goal::Higher.badness(2.0) < Goal::Higher.badness(1.0));
    assert!(Goal::Target(4.0).badness(4.1) < Goal::Target(4.0).badness(3.8));
    assert_eq!(Goal::Target(0.5).to_string(), "closer to 0.5 is better");
}

#[test]
fn the_membrane_has_its_coefficients() {
    let settings = MembraneSettings::load().unwrap();
    assert_eq!(settings.iter().map(|setting| setting.name).collect::<Vec<_>>(), MembraneVariant::ALL);
    let found: Vec<_> = settings
        .iter()
        .map(|setting| {
            (setting.linear_coefficient, setting.modulation.map(|modulation| (modulation.factor, modulation.power)))
        })
        .collect();
    assert_eq!(
        found,
        [
            ([0.2, 0.2], None),
            ([0.05, 1.0], None),
            ([1.0, 1.0], Some((Factor::Balsara, 2))),
            ([0.05, 1.0], None),
            ([1.0, 1.0], Some((Factor::Waves, 2))),
            ([0.5, 1.0], Some((Factor::Waves, 2))),
        ]
    );
}

#[test]
fn keys_are_those_of_the_files() {
    let text = include_str!("../tables/gs25_table7.toml");
    for key in MetricKey::ALL {
        assert!(text.contains(&format!("key = \"{}\"", key.as_str())), "{key:?}");
    }
    for name in SchemeName::ALL {
        assert!(text.contains(&format!("scheme = \"{name}\"")), "{name}");
    }
}

#[test]
fn broken_numbers_are_refused() {
    let three = include_str!("../tables/gs25_table3.toml");
    let figure = include_str!("../tables/pl20_figure5.toml");
    let eight = include_str!("../tables/gs25_table8.toml");
    let replaced = |text: &str, old: &str, new: &str| {
        assert!(text.contains(old), "the test replaces nothing: `{old}` is not in the file");
        text.replacen(old, new, 1)
    };
    let table_3 = |old: &str, new: &str| {
        let broken = replaced(three, old, new);
        parse_published(Paper::Gs25, Place::Table(3), &broken).expect_err("broken and accepted").to_string()
    };
    let figure_5 = |old: &str, new: &str| {
        let broken = replaced(figure, old, new);
        parse_published(Paper::Pl20, Place::Figure(5), &broken).expect_err("broken and accepted").to_string()
    };
    let table_8 = |old: &str, new: &str| {
        MembraneSettings::parse("bad.toml", &replaced(eight, old, new)).expect_err("broken and accepted").to_string()
    };
    for (message, expected) in [
        (table_3("about =", "colour = 3\nabout ="), "unknown field `colour`"),
        (table_3("value = 2.87", "valu = 2.87"), "unknown field `valu`"),
        (table_3("table = 3", "table = 4"), "they say gs25, 4; they must say gs25, 3"),
        (table_3("table = 3", "figure = 3"), "fields `paper` and `table`: they say gs25, nothing"),
        (table_3("scheme = \"AVSLRB2\"", "scheme = \"AVSLRB3\""), "AVSLRB3"),
        (table_3("scheme = \"AVSW\"", "scheme = \"AV\""), "row 2, field `quantity, scheme`"),
        (table_3("key = \"kelvin", "key = \"calvin"), "row 1, field `key`"),
        (table_3("unit = \"L T^-1\"", "unit = \"furlong\""), "does not start with M (mass)"),
        (table_3("test = \"kelvin-helmholtz\"", "test = \"teapot\""), "unknown variant `teapot`"),
        (table_3("target = 14.79\n", ""), "field `target`"),
        (table_3("value = 2.87", "value = nan"), "a finite number"),
        (table_3("value = 2.87", ""), "a note must say why"),
        (table_3("power_of_ten = -2", "power_of_ten = 2"), "field `power_of_ten`"),
        (figure_5("resolution = 256", "resolution = 128"), "finer than that of the row before"),
        (figure_5("resolution = 128\n", ""), "finer than that of the row before"),
        (figure_5("value = 3\nsays = \"about\"", "value = 3\nsays = \"roughly\""), "unknown variant `roughly`"),
        (table_8("name = \"AVSLRB*2\"", "name = \"AVSLRB2\""), "row 5, field `name`"),
        (table_8("[0.2, 0.2]", "[0.3, 0.2]"), "between 0 and the largest"),
        (table_8("power = 2", "power = 0"), "a power of at least 1"),
        (table_8("factor = \"waves\"", "factor = \"wavy\""), "unknown variant `wavy`"),
    ] {
        assert!(message.contains(expected), "`{message}` does not say `{expected}`");
    }
    let nowhere = parse_published(Paper::C25, Place::Table(9), "").expect_err("there is no such table");
    assert_eq!(
        nowhere.to_string(),
        "no numbers are kept of c25, Table 9, in the common form; `published()` lists the places that have some"
    );
}
