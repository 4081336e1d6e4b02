//! Every equation has a probe and every probe an equation; symbols and units are those of the ledger.

use etalon_audit::{Probe, Quantity, is_host, of_equation, probes};
use etalon_kernels_gen::registered;
use etalon_spec::{Entry, Ledger, Unit};
use std::collections::HashSet;

#[test]
fn every_equation_has_a_probe_and_every_probe_an_equation() {
    // Linked in, so that the registry knows them.
    let of_reference = |path: &str| path.starts_with("etalon_reference::");
    let equations: Vec<_> = registered().into_iter().filter(|entry| of_reference(entry.module_path)).collect();
    assert!(equations.len() >= 85, "only {} equations are registered", equations.len());
    for entry in equations {
        // What runs on the host only takes whole lists of particles, which a probe cannot make up.
        assert_ne!(
            of_equation(entry).next().is_some(),
            is_host(entry),
            "{} in {}: add a probe to audit/src/probes, as docs/how-to/equation.md shows",
            entry.name,
            entry.file
        );
    }
    for probe in probes() {
        assert!(probe.entry().is_some(), "{probe} is a probe of no equation");
    }
}

#[test]
fn keys_and_outputs_have_names_of_their_own() {
    let mut keys = HashSet::new();
    for probe in probes() {
        assert!(keys.insert(probe.key()), "two probes are called {probe}");
        let names: HashSet<String> = probe.output_names().into_iter().collect();
        let ones = vec![0.5; probe.inputs()];
        let count = probe.evaluate::<f64>(&ones).unwrap().len();
        assert_eq!((names.len(), probe.output_symbols().len()), (count, count), "{probe}");
        assert_eq!(probe.input_domains().len(), probe.inputs(), "{probe}");
        assert!(probe.evaluate::<f64>(&ones[1..]).unwrap_err().to_string().contains("input_names"), "{probe}");
    }
}

/// Spaces and braces around a single letter say nothing: `h_{a}` is `h_a`.
fn plain(latex: &str) -> String {
    let letters: Vec<char> = latex.chars().filter(|c| !c.is_whitespace()).collect();
    let single = |i: usize| letters[i] == '{' && letters.get(i + 2) == Some(&'}');
    let kept = (0..letters.len()).filter(|&i| !(single(i) || i >= 2 && single(i - 2)));
    kept.map(|i| letters[i]).collect()
}

/// The partner's symbol: indices a and b exchanged where they stand alone or together.
fn swapped(latex: &str) -> String {
    let swap = |c: char| {
        if c == 'a' {
            'b'
        } else if c == 'b' {
            'a'
        } else {
            c
        }
    };
    let mut result = String::new();
    let mut word = false;
    for c in latex.chars() {
        word = c == '\\' || word && c.is_ascii_alphabetic();
        result.push(if word { c } else { swap(c) });
    }
    result
}

/// The unit that one of the entries has for the symbol, or for the partner's.
fn ledger_unit(entries: &[&Entry], latex: &str) -> Option<Unit> {
    let symbols = || entries.iter().flat_map(|entry| &entry.symbols);
    let find = |latex: String| symbols().find(|symbol| plain(&symbol.latex) == latex).map(|symbol| symbol.unit);
    find(plain(latex)).or_else(|| find(swapped(&plain(latex))))
}

#[test]
fn symbols_and_units_are_the_ledgers() {
    let ledger = Ledger::load().unwrap();
    let mut of_ledger = 0;
    let mut faults = Vec::new();
    for probe in probes() {
        let entries: Vec<&Entry> = probe.ids().into_iter().map(|id| ledger.get(id)).collect();
        for quantity in quantities(probe) {
            let mut fault = |what: String| faults.push(format!("{probe}, {}: {what}", quantity.name));
            let latex = quantity.symbol.latex;
            match (quantity.unit(), quantity.symbol.meaning, ledger_unit(&entries, latex)) {
                (Err(error), ..) => fault(error.to_string()),
                (Ok(unit), None, Some(expected)) if unit == expected => of_ledger += 1,
                (Ok(_), None, Some(expected)) => fault(format!("the ledger has the unit {expected}")),
                (Ok(_), None, None) => fault(format!("the ledger has no symbol {latex}; see `own`")),
                (Ok(_), Some(_), Some(_)) => fault(format!("{latex} is the ledger's, not our own")),
                (Ok(_), Some(""), None) => fault("it has no meaning".to_string()),
                (Ok(_), Some(_), None) => {}
            }
        }
    }
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
    assert!(of_ledger > 100, "only {of_ledger} symbols are the ledger's");
}

fn quantities(probe: &Probe) -> impl Iterator<Item = &Quantity> {
    probe.arguments.iter().map(|argument| &argument.quantity).chain(&probe.results)
}

#[test]
fn domains_are_made_of_numbers() {
    for probe in probes() {
        for argument in &probe.arguments {
            let (least, most) = argument.domain.hull();
            assert!(least < most && least.is_finite() && most.is_finite(), "{probe}, {}", argument.quantity.name);
            assert!(argument.domain.spread() == etalon_audit::Spread::Linear || argument.domain.low() > 0.0, "{probe}");
        }
    }
}
