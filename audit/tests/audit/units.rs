//! Units of every node of every equation, and that a wrong one would be noticed.

use etalon_audit::{Probe, any, check_units, own, positive, probe, probes};

#[test]
fn units_fit_at_every_node() {
    let faults: Vec<String> =
        probes().iter().filter_map(|probe| check_units(probe).err()).flatten().map(|fault| fault.to_string()).collect();
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
}

mod wrong {
    //! Equations whose units do not fit.
    use etalon_kernels_gen::{Real, equation};

    /// A length and a time are added. Source: none.
    #[equation(unnumbered = "test: inconsistent sum")]
    pub fn length_and_time<R: Real>(length: R, time: R) -> R {
        let twice = length + length;
        let mixed = twice + time;
        mixed * 2.0
    }

    /// A length is compared with one. Source: none.
    #[equation(unnumbered = "test: inconsistent comparison")]
    pub fn bare_threshold<R: Real>(length: R) -> R {
        if length < 1e-3 { 0.0 } else { length }
    }

    /// A speed squared where a speed is declared. Source: none.
    #[equation(unnumbered = "test: wrong result")]
    pub fn missing_root<R: Real>(pressure: R, density: R) -> R {
        pressure / density
    }

    /// A bare epsilon keeps a divisor from zero. Source: none.
    #[equation(unnumbered = "test: bare epsilon")]
    pub fn bare_epsilon<R: Real>(length: R) -> R {
        length / (length * length + 1e-30).sqrt()
    }
}

fn inconsistent() -> Vec<(Probe, &'static str)> {
    let mut list: Vec<Probe> = probe! {
        wrong::length_and_time(length, time);
        length: R = length_symbol(), "L", any(0.1, 1.0);
        time: R = own("t", "a time"), "T", any(0.1, 1.0);
        => sum: R = own("s", "their sum"), "L";
    };
    list.extend(probe! {
        wrong::bare_threshold(length);
        length: R = length_symbol(), "L", any(0.1, 1.0);
        => cut: R = length_symbol(), "L";
    });
    list.extend(probe! {
        wrong::missing_root(pressure, density);
        pressure: R = own("P", "a pressure"), "M L^(2-nu) T^-2", positive(0.1, 1.0);
        density: R = own("r", "a density"), "M L^-nu", positive(0.1, 1.0);
        => speed: R = own("c", "a speed"), "L T^-1";
    });
    list.extend(probe! {
        wrong::bare_epsilon(length);
        length: R = length_symbol(), "L", any(0.1, 1.0);
        => sign: R = own("s", "its sign"), "1";
    });
    let expected = [
        "`mixed` of length_and_time (test: inconsistent sum): a sum of L and T",
        "bare_threshold (test: inconsistent comparison): a comparison of L and 1",
        "the result speed has the unit L^2 T^-2, declared is L T^-1",
        "bare_epsilon (test: bare epsilon): a sum of L^2 and 1",
    ];
    list.into_iter().zip(expected).collect()
}

fn length_symbol() -> etalon_audit::Name {
    own("l", "a length")
}

#[test]
fn an_inconsistent_equation_is_found_at_its_node() {
    for (probe, expected) in inconsistent() {
        let faults = check_units(&probe).unwrap_err();
        let text = faults.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n");
        println!("{text}");
        assert!(text.contains(expected), "{text}");
        assert_eq!(faults.len(), 1, "one fault is reported once:\n{text}");
    }
}

#[test]
fn a_wrong_declaration_is_found() {
    let balsara = probes().iter().find(|probe| probe.function == "balsara_limiter").unwrap();
    let mut wrong = balsara.clone();
    wrong.arguments[3].quantity.unit_text = "L"; // h instead of 1/h
    let faults = check_units(&wrong).unwrap_err();
    assert!(faults[0].to_string().contains("balsara_limiter: a sum of T^-1 and L^2 T^-1"), "{}", faults[0]);
    wrong.arguments[3].quantity.unit_text = "X";
    assert!(check_units(&wrong).unwrap_err()[0].to_string().contains("does not start with M"));
}
