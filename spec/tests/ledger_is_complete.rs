//! The ledger built into the crate: complete, valid, and consistent with itself.

use std::collections::{BTreeMap, BTreeSet};

use etalon_spec::{Base, Confidence, Encoding, EquationId, Exponent, Kind, Ledger, Paper, Unit};

fn ledger() -> Ledger {
    Ledger::load().unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn every_numbered_equation_has_its_entry() {
    let ledger = ledger();
    let counts: Vec<_> = ledger.papers().map(|paper| (paper.paper.key(), paper.entries().count())).collect();
    assert_eq!(counts, [("gs25", 30), ("pl20", 16), ("c25", 33)]);
    for id in EquationId::all() {
        assert_eq!(ledger.get(id).id, id);
    }
    assert_eq!(ledger.entries().map(|entry| entry.id).collect::<Vec<_>>(), EquationId::all().collect::<Vec<_>>());
}

#[test]
fn papers_carry_their_citations() {
    let ledger = ledger();
    for (paper, marks) in [
        (Paper::Gs25, ["García-Senz", "arXiv:2510.20534"]),
        (Paper::Pl20, ["Laibe", "doi:10.1093/mnras/staa1366"]),
        (Paper::C25, ["Cabezón", "arXiv:2503.10273"]),
    ] {
        assert_eq!(ledger.paper(paper).paper, paper);
        for mark in marks {
            assert!(ledger.paper(paper).citation.contains(mark), "{paper} lacks {mark}");
        }
    }
}

/// The displayed formulas of C25 are lost: an entry that does not say so would pass for the paper's own text.
#[test]
fn every_c25_entry_says_that_it_is_reconstructed() {
    let ledger = ledger();
    for entry in ledger.paper(Paper::C25).entries() {
        assert!(entry.reading.starts_with("Reconstructed"), "{} does not say so", entry.id);
        assert_eq!(entry.latex_as_printed, None, "{}: nothing printed is known", entry.id);
    }
}

/// The two papers share a derivation: where C25 repeats GS25 the formulas are the same, letter for letter.
#[test]
fn repeated_equations_agree() {
    let ledger = ledger();
    let latex = |id: &str| ledger.get(id.parse().unwrap()).latex.replace("n_s\\,c_a", "0.05\\,c_a");
    for (c25, gs25) in [(8, 11), (9, 12), (10, 13), (11, 14), (12, 15), (13, 16), (14, 17), (15, 9), (16, 10), (18, 8)]
    {
        assert_eq!(latex(&format!("c25:{c25}")), latex(&format!("gs25:{gs25}")), "c25:{c25} and gs25:{gs25}");
    }
}

/// One name means one quantity, in every paper: a unit that differs between two entries is a slip in one of them.
#[test]
fn a_name_has_one_unit_throughout() {
    let ledger = ledger();
    let mut units: BTreeMap<&str, (Unit, EquationId)> = BTreeMap::new();
    let mut compared = 0;
    for entry in ledger.entries() {
        for symbol in &entry.symbols {
            let (unit, first) = *units.entry(&symbol.name).or_insert((symbol.unit, entry.id));
            assert_eq!(symbol.unit, unit, "`{}` in {} and {first}", symbol.name, entry.id);
            compared += usize::from(first != entry.id);
        }
    }
    assert!(compared > 100, "only {compared} repeated names: the comparison has become empty");
}

/// Units that follow from physics by hand, in every dimension: the momentum equation's terms are accelerations.
#[test]
fn units_of_the_momentum_equation_balance() {
    let ledger = ledger();
    let entry = ledger.get("c25:22".parse().unwrap());
    let unit = |latex: &str| entry.symbols.iter().find(|symbol| symbol.latex == latex).unwrap().unit;
    for nu in 1..=3 {
        for base in Base::ALL {
            let exponent = |latex: &str| unit(latex).exponent(base).in_dimensions(nu);
            // m X^2 P A / (m^2 k Omega), with sigma = 0.
            let product =
                -exponent("m_a") + 2 * exponent("X_a") + exponent("P_a") - exponent("k_a") - exponent("\\Omega_a")
                    + exponent("\\boldsymbol{\\mathcal{A}}_{ab}");
            assert_eq!(product, exponent("\\dot{\\mathbf{v}}_a"), "{base:?} in {nu} dimensions");
        }
    }
    let kernel = unit("\\boldsymbol{\\mathcal{A}}_{ab}").exponent(Base::Length);
    assert_eq!(kernel, Exponent { constant: -1, per_dimension: -1 });
}

#[test]
fn confidence_follows_the_audit() {
    let ledger = ledger();
    let of = |paper, confidence| -> Vec<u16> {
        let entries = ledger.paper(paper).entries().filter(|entry| entry.confidence == confidence);
        entries.map(|entry| entry.id.number()).collect()
    };
    assert_eq!(of(Paper::Gs25, Confidence::Open), [21, 25, 27]);
    assert_eq!(of(Paper::Gs25, Confidence::Reconstructed), []);
    assert_eq!(of(Paper::Pl20, Confidence::Reconstructed), [4, 5, 10]);
    assert_eq!(of(Paper::Pl20, Confidence::Open), []);
    assert_eq!(of(Paper::C25, Confidence::Reconstructed), [3, 4, 6, 7, 22, 23, 25, 26, 30, 31, 32]);
    assert_eq!(of(Paper::C25, Confidence::Open), [27, 33]);
}

/// The printed formulas that cannot be taken as they stand keep both forms, and the two differ.
#[test]
fn corrected_formulas_show_the_printed_form() {
    let ledger = ledger();
    for id in ["pl20:4", "pl20:5", "pl20:10", "gs25:18", "gs25:19", "gs25:23", "gs25:27"] {
        let entry = ledger.get(id.parse().unwrap());
        let printed = entry.latex_as_printed.as_ref().unwrap_or_else(|| panic!("{id} lacks the printed form"));
        assert_ne!(*printed, entry.latex, "{id}");
    }
}

#[test]
fn an_entry_not_encoded_yet_says_so_and_why() {
    let ledger = ledger();
    let encoded: BTreeSet<EquationId> = ["gs25:8", "c25:31"].map(|id| id.parse().unwrap()).into();
    let status = ledger.status(&encoded);
    assert_eq!(status.len(), 79);
    let yes: Vec<String> =
        status.iter().filter(|row| row.encoding == Encoding::Encoded).map(|row| row.entry.id.to_string()).collect();
    assert_eq!(yes, ["gs25:8", "c25:31"]);

    let mut reasons = BTreeMap::new();
    for row in &status {
        if let Encoding::NotYetEncoded { reason } = row.encoding {
            assert_eq!(reason, row.entry.kind.reason_not_encoded());
            reasons.insert(row.entry.kind, reason);
        }
    }
    let kinds = [
        Kind::Computable,
        Kind::Definition,
        Kind::Continuum,
        Kind::Explanatory,
        Kind::Diagnostic,
        Kind::InitialCondition,
    ];
    assert_eq!(reasons.keys().copied().collect::<Vec<_>>(), kinds, "every kind occurs in the ledger");
    assert_eq!(reasons.values().collect::<BTreeSet<_>>().len(), kinds.len(), "each kind has its own reason");
}
