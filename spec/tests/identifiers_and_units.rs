//! Reading and writing of identifiers and units.

use etalon_spec::{Base, EquationId, Exponent, IdError, Paper, Unit, UnitError, exists};
use proptest::prelude::*;

#[test]
fn identifiers_that_exist() {
    for (text, paper, number) in [("gs25:1", Paper::Gs25, 1), ("gs25:30", Paper::Gs25, 30), ("c25:33", Paper::C25, 33)]
    {
        let id = exists(text).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!((id.paper(), id.number()), (paper, number));
    }
    assert_eq!(EquationId::all().count(), 30 + 16 + 33);
}

#[test]
fn identifiers_that_do_not_exist_say_what_would() {
    for (text, message) in [
        (
            "gs25-8",
            "`gs25-8` is not an equation identifier: write the paper's key, a colon and the number, for example `gs25:13`",
        ),
        ("gs24:8", "`gs24:8`: the ledger has no paper `gs24`; its papers are gs25, pl20, c25"),
        ("GS25:8", "`GS25:8`: the ledger has no paper `GS25`; its papers are gs25, pl20, c25"),
        ("gs25:31", "gs25 has no equation 31; its equations are 1 to 30"),
        ("pl20:0", "pl20 has no equation 0; its equations are 1 to 16"),
        ("c25:65537", "c25 has no equation 65537; its equations are 1 to 33"),
        (
            "pl20:08",
            "`pl20:08`: `08` is not an equation number; write digits without sign, spaces or leading zeros, pl20 has 1 to 16",
        ),
    ] {
        assert_eq!(exists(text).unwrap_err().to_string(), message);
    }
    for text in ["gs25:", "gs25:+8", "gs25: 8", "gs25:8 ", "gs25:8:1", "gs25:99999999999999999999", "gs25:٣"] {
        assert!(matches!(exists(text), Err(IdError::NotANumber { .. })), "{text}");
    }
}

fn any_exponent() -> impl Strategy<Value = Exponent> {
    (any::<i8>(), any::<i8>()).prop_map(|(constant, per_dimension)| Exponent { constant, per_dimension })
}

proptest! {
    /// What is written can be read, and nothing else is.
    #[test]
    fn identifiers_round_trip(position in 0_usize..79) {
        let id = EquationId::all().nth(position).unwrap();
        prop_assert_eq!(id.to_string().parse::<EquationId>(), Ok(id));
    }

    /// A text that is accepted is the identifier's one spelling, so that texts can be compared.
    #[test]
    fn an_accepted_text_is_the_canonical_one(text in "(gs25|pl20|c25|x)?:?[0-9+ ]{0,4}") {
        match text.parse::<EquationId>() {
            Ok(id) => prop_assert_eq!(id.to_string(), text),
            Err(error) => prop_assert!(!error.to_string().contains('\n')),
        }
    }

    /// Exactly the numbers of the range exist.
    #[test]
    fn the_range_decides(number in any::<u16>()) {
        for paper in Paper::ALL {
            let parsed = format!("{paper}:{number}").parse::<EquationId>();
            prop_assert_eq!(parsed.is_ok(), (1..=paper.last_number()).contains(&number));
            prop_assert_eq!(parsed, EquationId::new(paper, number));
        }
    }

    /// No text makes the reader panic.
    #[test]
    fn any_text_is_read_or_refused(text in any::<String>()) {
        let _ = text.parse::<EquationId>();
        let _ = text.parse::<Unit>();
    }

    /// Every unit survives writing and reading.
    #[test]
    fn units_round_trip(exponents in [any_exponent(), any_exponent(), any_exponent(), any_exponent()]) {
        let unit = Unit::new(exponents);
        prop_assert_eq!(unit.to_string().parse::<Unit>(), Ok(unit), "written as `{}`", unit);
    }
}

#[test]
fn units_are_read_as_they_are_meant() {
    let exponents = |text: &str| {
        let unit: Unit = text.parse().unwrap_or_else(|error| panic!("{text}: {error}"));
        Base::ALL.map(|base| unit.exponent(base).in_dimensions(3))
    };
    assert_eq!(exponents("1"), [0, 0, 0, 0]);
    assert_eq!(exponents("M L^-nu"), [1, -3, 0, 0]);
    assert_eq!(exponents("L T^-1"), [0, 1, -1, 0]);
    assert_eq!(exponents("M L^(2-nu) T^-2"), [1, -1, -2, 0]);
    assert_eq!(exponents("F L^(-1-2nu)"), [0, -7, 0, 1]);
    assert_eq!(exponents("M^-1 L^(2+nu)"), [-1, 5, 0, 0]);
}

#[test]
fn units_that_cannot_be_read() {
    let fault = |text: &str| text.parse::<Unit>().unwrap_err();
    assert_eq!(fault("  "), UnitError::Empty);
    assert_eq!(fault("kg"), UnitError::UnknownBase { factor: "kg".into() });
    assert_eq!(fault("M 1"), UnitError::UnknownBase { factor: "1".into() });
    assert_eq!(fault("L T L"), UnitError::Repeated { letter: 'L' });
    for text in ["L^", "L^0", "L2", "L^+2", "L^02", "L^2.5", "L^(2)", "L^(nu)", "L^(2-nu", "L^(0+nu)", "L^200", "L^nu2"]
    {
        assert_eq!(fault(text), UnitError::Exponent { factor: text.into() });
    }
}
