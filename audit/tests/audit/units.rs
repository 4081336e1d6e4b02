//! Units of every node of every equation, and that a wrong one would be noticed.

use etalon_audit::{
    Catalogue, Probe, State, Subject, Survey, any, check_units, not_negative, own, positive, probe, probes,
};
use etalon_kernels_gen::registered;

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

mod slips {
    //! Equations of the papers, each with one slip in it.
    use etalon_kernels_gen::functions::ratio_or_zero;
    use etalon_kernels_gen::{Real, equation};

    /// GS25 (8) as it is. Source: GS25 (8).
    #[equation(unnumbered = "test: no slip")]
    pub fn balsara<R: Real>(divergence: R, curl: R, sound_speed: R, inverse_h: R) -> R {
        ratio_or_zero(divergence.abs(), divergence.abs() + curl + 1e-4 * sound_speed * inverse_h)
    }

    /// GS25 (8) without the smoothing length. Source: none.
    #[equation(unnumbered = "test: missing factor h")]
    pub fn missing_factor<R: Real>(divergence: R, curl: R, sound_speed: R) -> R {
        ratio_or_zero(divergence.abs(), divergence.abs() + curl + 1e-4 * sound_speed)
    }

    /// GS25 (3) with a density in it. Source: none.
    #[equation(unnumbered = "test: wrong dimension added")]
    pub fn wrong_term<R: Real>(sound_speed: R, density: R, omega: R) -> R {
        let signal = sound_speed + density;
        signal - 3.0 * omega
    }

    /// The sound speed with the density squared. Source: none.
    #[equation(unnumbered = "test: wrong exponent")]
    pub fn wrong_exponent<R: Real>(pressure: R, density: R) -> R {
        (1.4 * pressure / (density * density)).sqrt()
    }
}

/// Each slip with the words that name it; the first has none.
fn slips() -> Vec<(Vec<Probe>, Option<&'static str>)> {
    let balsara = probe! {
        slips::balsara(divergence, curl, sound_speed, inverse_h);
        divergence: R = own("d", "divergence"), "T^-1", any(0.1, 10.0);
        curl: R = own("o", "curl"), "T^-1", not_negative(0.1, 10.0);
        sound_speed: R = own("c", "sound speed"), "L T^-1", not_negative(0.1, 10.0);
        inverse_h: R = own("h^{-1}", "inverse smoothing length"), "L^-1", positive(0.1, 10.0);
        => balsara: R = own("b", "limiter"), "1";
    };
    let missing_factor = probe! {
        slips::missing_factor(divergence, curl, sound_speed);
        divergence: R = own("d", "divergence"), "T^-1", any(0.1, 10.0);
        curl: R = own("o", "curl"), "T^-1", not_negative(0.1, 10.0);
        sound_speed: R = own("c", "sound speed"), "L T^-1", not_negative(0.1, 10.0);
        => balsara: R = own("b", "limiter"), "1";
    };
    let wrong_term = probe! {
        slips::wrong_term(sound_speed, density, omega);
        sound_speed: R = own("c", "sound speed"), "L T^-1", not_negative(0.1, 10.0);
        density: R = own("r", "density"), "M L^-nu", positive(0.1, 10.0);
        omega: R = own("w", "velocity of approach"), "L T^-1", any(0.1, 10.0);
        => signal: R = own("v", "signal velocity"), "L T^-1";
    };
    let wrong_exponent = probe! {
        slips::wrong_exponent(pressure, density);
        pressure: R = own("P", "pressure"), "M L^(2-nu) T^-2", positive(0.1, 10.0);
        density: R = own("r", "density"), "M L^-nu", positive(0.1, 10.0);
        => speed: R = own("c", "sound speed"), "L T^-1";
    };
    vec![
        (balsara, None),
        (missing_factor, Some("missing_factor (test: missing factor h): a sum of T^-1 and L T^-1")),
        (wrong_term, Some("`signal` of wrong_term (test: wrong dimension added): a sum of L T^-1 and M L^-1")),
        (wrong_exponent, Some("the result speed has the unit M^(-1/2) L^(3/2) T^-1, declared is L T^-1")),
    ]
}

/// By the way of `etalon audit`: a survey, the state that it amounts to, what that prints. `src/command/audit.rs` goes on to the exit code.
#[test]
fn an_inconsistent_equation_fails_the_audit() {
    for (probes, expected) in slips() {
        let mut catalogue = Catalogue::load().unwrap();
        let entry = registered().into_iter().find(|entry| probes[0].is_of(entry)).unwrap();
        let all: Vec<&Probe> = probes.iter().collect();
        let survey =
            Survey::of_probes(&catalogue, Some(Subject::Functions(vec![entry])), &all, 1, None, |_, _, _| ()).unwrap();
        // Its errors are on record, so that its units alone can be amiss.
        catalogue.budgets = survey.budgets();
        let state = State::of(&catalogue, &survey);
        let text = state.to_string();
        let [row] = &state.unnumbered[..] else { panic!("{text}") };
        match expected {
            None => assert!(state.passed && row.units == "fit" && !row.regressed, "{text}"),
            Some(expected) => {
                assert!(!state.passed && row.units == "fault" && row.regressed, "{text}");
                assert!(text.contains(expected) && text.contains("WORSE"), "{text}");
                // In one, two and three dimensions the units differ where a density is amiss.
                assert!((1..=3).contains(&state.regressions.len()), "{text}");
            }
        }
    }
}
