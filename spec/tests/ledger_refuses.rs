//! Every fault a ledger file can have is refused with its own message, which names file, equation, field and remedy.

use etalon_spec::{LedgerError, Paper, PaperLedger, UnitError};

const FILE: &str = "bad.toml";

/// A valid file for PL20, equation by equation, to be broken by the tests.
fn entries() -> Vec<String> {
    (1..=Paper::Pl20.last_number()).map(entry).collect()
}

/// The speed of sound is listed for particle a and so explains that of b as well.
const ENTRY: &str = r"
[[equation]]
number = NUMBER
title = 'Speed'
kind = 'computable'
confidence = 'certain'
paper_section = '2'
latex = '\frac{v_a}{c_a + c_b}'
symbols = [
  { symbol = 'v_a', name = 'velocity', unit = 'L T^-1' },
  { symbol = 'c_{a}', name = 'speed of sound', unit = 'L T^-1' },
]
reading = 'A ratio.'
bad_input = 'propagates'
";

fn entry(number: u16) -> String {
    ENTRY.replace("NUMBER", &number.to_string())
}

fn header() -> String {
    "paper = 'pl20'\ncitation = 'A paper'\nabout = 'A test.'\nparticles = ['a', 'b']\n\
     indices = [{ letter = 'a', meaning = 'a particle' }, { letter = 'b', meaning = 'another' }]\n\n"
        .to_owned()
}

fn parse(text: &str) -> Result<PaperLedger, LedgerError> {
    PaperLedger::parse(Paper::Pl20, FILE, text)
}

fn file(entries: &[String]) -> String {
    header() + &entries.concat()
}

/// The fault that follows when `old` is replaced by `new` in equation 7.
#[track_caller]
fn fault_in_seven(old: &str, new: &str) -> LedgerError {
    let mut all = entries();
    assert!(all[6].contains(old), "the test replaces nothing: `{old}` is not in\n{}", all[6]);
    all[6] = all[6].replace(old, new);
    let error = parse(&file(&all)).expect_err("the file is broken and was accepted");
    let message = error.to_string();
    assert!(message.contains(FILE) && message.contains("equation 7"), "{message}");
    error
}

#[test]
fn the_unbroken_file_is_accepted() {
    let ledger = parse(&file(&entries())).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(ledger.entries().count(), 16);
}

#[test]
fn a_missing_number() {
    let mut all = entries();
    all.remove(4);
    let error = parse(&file(&all)).unwrap_err();
    assert_eq!(error, LedgerError::MissingNumber { file: FILE.into(), number: 5, last: 16 });
    assert_eq!(
        error.to_string(),
        "bad.toml: equation 5 is missing; the file needs an [[equation]] for every number from 1 to 16"
    );
}

#[test]
fn a_duplicate_number() {
    let mut all = entries();
    all[4] = entry(4);
    let error = parse(&file(&all)).unwrap_err();
    assert_eq!(error, LedgerError::DuplicateNumber { file: FILE.into(), number: 4 });
    assert!(error.to_string().contains("keep one entry"), "{error}");
}

#[test]
fn a_number_out_of_range() {
    let mut all = entries();
    all.push(entry(17));
    let error = parse(&file(&all)).unwrap_err();
    assert_eq!(error, LedgerError::NumberOutOfRange { file: FILE.into(), number: 17, last: 16 });
}

#[test]
fn numbers_out_of_order() {
    let mut all = entries();
    all.swap(2, 3);
    let error = parse(&file(&all)).unwrap_err();
    assert_eq!(error, LedgerError::OutOfOrder { file: FILE.into(), number: 3, previous: 4 });
}

#[test]
fn keys_that_are_unknown_missing_or_mistyped() {
    for (old, new, says) in [
        ("paper_section", "papersection", "unknown field `papersection`"),
        ("reading = 'A ratio.'", "", "missing field `reading`"),
        ("title = 'Speed'", "title = 3", "expected a string"),
        ("'computable'", "'computeable'", "unknown variant `computeable`"),
        ("'certain'", "'sure'", "unknown variant `sure`"),
        ("unit = 'L T^-1'", "units = 'L T^-1'", "unknown field `units`"),
    ] {
        let error = fault_in_seven(old, new);
        assert!(matches!(error, LedgerError::BadEntry { .. }), "{error:?}");
        let message = error.to_string();
        assert!(message.contains(says) && message.contains("README"), "{message}");
        assert!(!message.contains('\n'), "one line: {message}");
    }
}

#[test]
fn a_number_that_cannot_be_read_is_placed() {
    let text = file(&entries());
    for (new, label) in [("number = 'seven'", "\"seven\""), ("number = -7", "equation -7"), ("", "at place 7")] {
        let error = parse(&text.replace("number = 7\n", &format!("{new}\n"))).unwrap_err();
        assert!(matches!(error, LedgerError::BadEntry { .. }), "{error:?}");
        assert!(error.to_string().contains(label), "{error}");
    }
}

#[test]
fn a_bad_unit() {
    let LedgerError::BadUnit { number, symbol, source, .. } = fault_in_seven("unit = 'L T^-1'", "unit = 'L S^-1'")
    else {
        panic!("another fault was found")
    };
    assert_eq!((number, symbol.as_str()), (7, "v_a"));
    assert_eq!(source, UnitError::UnknownBase { factor: "S^-1".into() });
    let message = fault_in_seven("unit = 'L T^-1'", "unit = 'L^x T^-1'").to_string();
    assert!(message.contains("`v_a`") && message.contains("whole number"), "{message}");
}

#[test]
fn braces_that_do_not_pair() {
    for (old, new, field, says) in [
        ("\\frac{v_a}", "\\frac{v_a", "latex", "never closed"),
        ("{c_a + c_b}", "{c_a + c_b}}", "latex", "no opening"),
        ("{c_a + c_b}'", "{c_a + c_b} \\begin{cases}'", "latex", "never ended"),
        ("{c_a + c_b}'", "{c_a + c_b} \\end{cases}'", "latex", "closes no environment"),
        ("'A ratio.'", "'A ratio of $v_a.'", "reading", "dollar"),
        ("'A ratio.'", "'A ratio.'\ndeviation = 'None {'", "deviation", "never closed"),
        ("symbol = 'c_{a}'", "symbol = 'c_{a'", "symbols.symbol", "never closed"),
    ] {
        let error = fault_in_seven(old, new);
        let LedgerError::Unbalanced { field: found, .. } = &error else { panic!("{error:?}") };
        assert_eq!(*found, field);
        assert!(error.to_string().contains(says), "{error}");
    }
}

/// An escaped brace is a printed character and opens no group.
#[test]
fn escaped_braces_need_no_partner() {
    let text = file(&entries()).replace("\\frac{v_a}", "\\left\\{ \\frac{v_a}");
    assert!(parse(&text).is_ok());
}

#[test]
fn fields_that_are_empty() {
    for (old, new, field) in [
        ("'Speed'", "' '", "title"),
        ("paper_section = '2'", "paper_section = ''", "paper_section"),
        ("latex = '\\frac{v_a}{c_a + c_b}'", "latex = ''", "latex"),
        ("'A ratio.'", "''", "reading"),
        ("'A ratio.'", "'A ratio.'\ndeviation = ''", "deviation"),
        ("name = 'velocity'", "name = ''", "symbols.name"),
    ] {
        let error = fault_in_seven(old, new);
        assert_eq!(error, LedgerError::EmptyField { file: FILE.into(), number: 7, field });
    }
    let both = ENTRY.split_once("symbols = ").unwrap().1.split_once("reading").unwrap().0;
    let error = fault_in_seven(both, "[]\n");
    assert_eq!(error, LedgerError::EmptyField { file: FILE.into(), number: 7, field: "symbols" });
}

#[test]
fn an_open_reading_without_its_question() {
    let error = fault_in_seven("'certain'", "'open'");
    assert_eq!(error, LedgerError::OpenWithoutQuestion { file: FILE.into(), number: 7 });
    let text = file(&entries()).replace("'certain'", "'open'\nopen_question = 'Which?'");
    assert!(parse(&text).is_ok());
}

#[test]
fn symbols_that_do_not_match_the_formula() {
    let error = fault_in_seven("symbol = 'v_a'", "symbol = 'v_a^2'");
    assert_eq!(error, LedgerError::SymbolNotInFormula { file: FILE.into(), number: 7, symbol: "v_a^2".into() });

    // `c` occurs inside the command `\frac`, which does not make it a symbol of the formula.
    let error = fault_in_seven("{c_a + c_b}", "{v_b}");
    assert_eq!(error, LedgerError::SymbolNotInFormula { file: FILE.into(), number: 7, symbol: "c_{a}".into() });

    let error = fault_in_seven("symbol = 'c_{a}'", "symbol = 'v_{a}'");
    assert_eq!(error, LedgerError::DuplicateSymbol { file: FILE.into(), number: 7, symbol: "v_{a}".into() });

    for (new, letter) in [("{c_a + c_b + k}", "k"), ("{c_a + c_b + \\kappa}", "\\kappa"), ("{c_a + c_b + c_2}", "c")] {
        let error = fault_in_seven("{c_a + c_b}", new);
        assert_eq!(error, LedgerError::UnexplainedLetter { file: FILE.into(), number: 7, letter: letter.into() });
    }
    // Words, operators and numbers need no explanation.
    let text = file(&entries()).replace("{c_a + c_b}", "{c_a + c_b + 2\\pi \\max\\text{ if far}}");
    assert!(parse(&text).is_ok());
}

#[test]
fn a_header_that_is_wrong() {
    let text = file(&entries());
    let other = parse(&text.replace("paper = 'pl20'", "paper = 'gs25'")).unwrap_err();
    let expected = LedgerError::WrongPaper { file: FILE.into(), expected: "pl20".into(), found: "gs25".into() };
    assert_eq!(other, expected);
    for (old, new, says) in [
        ("citation = 'A paper'\n", "", "missing field `citation`"),
        ("citation = 'A paper'", "citation = ''", "`citation` is empty"),
        ("about =", "colour = 'red'\nabout =", "unknown field `colour`"),
    ] {
        let error = parse(&text.replace(old, new)).unwrap_err();
        assert!(matches!(error, LedgerError::BadHeader { .. }), "{error:?}");
        assert!(error.to_string().contains(says), "{error}");
    }
}

#[test]
fn text_that_is_not_toml() {
    let error = parse("paper = 'pl20'\ncitation == 'A paper'\n").unwrap_err();
    let LedgerError::NotToml { line, .. } = &error else { panic!("{error:?}") };
    assert_eq!(*line, 2, "{error}");
}

/// What an equation does with bad input is said, and said once.
#[test]
fn bad_input_that_is_not_accounted_for() {
    let says = "bad_input = 'propagates'\n";
    let guards = |caught: &str| format!("bad_input = 'guards'\ncaught = [{caught}]\n");
    let error = fault_in_seven(says, "");
    assert_eq!(error, LedgerError::MissingBadInput { file: FILE.into(), number: 7 });
    assert!(error.to_string().contains("guarded, refused, or propagate"), "{error}");
    let one = "{ of = 'v_a', values = ['nan'], gives = 'zero' }";
    let error = fault_in_seven(says, &format!("{says}caught = [{one}]\n"));
    assert_eq!(error, LedgerError::CaughtYetPropagates { file: FILE.into(), number: 7 });
    for (caught, field) in [
        ("", "caught"),
        ("{ of = '', values = ['nan'], gives = 'zero' }", "caught.of"),
        ("{ of = 'v_a', values = [], gives = 'zero' }", "caught.values"),
        ("{ of = 'v_a', values = ['nan'], gives = ' ' }", "caught.gives"),
    ] {
        let error = fault_in_seven(says, &guards(caught));
        assert_eq!(error, LedgerError::EmptyField { file: FILE.into(), number: 7, field });
    }
    let error = fault_in_seven(says, &guards("{ of = 'v_{a', values = ['nan'], gives = 'zero' }"));
    assert!(matches!(error, LedgerError::Unbalanced { field: "caught.of", .. }), "{error:?}");
    let error = fault_in_seven(says, &guards("{ of = 'v_a', values = ['nan', 'nan'], gives = 'zero' }"));
    assert_eq!(error, LedgerError::DuplicateBadValue { file: FILE.into(), number: 7, of: "v_a".into() });
    for (new, word) in
        [("bad_input = 'ignores'\n", "unknown variant `ignores`"), (&guards(&one.replace("nan", "odd")), "`odd`")]
    {
        assert!(fault_in_seven(says, new).to_string().contains(word));
    }
    let text = file(&entries()).replace(says, &guards(one));
    assert!(parse(&text).is_ok());
    // An explanation has no code, so nothing can go wrong in it.
    let text = file(&entries()).replace(says, "").replace("'computable'", "'explanatory'");
    assert!(parse(&text).is_ok());
}
