//! Whatever is thrown at it, the library answers: it never panics, and what it accepts is Rust.

use etalon_equation_syntax::{Place, Surroundings, expand, translate};
use proptest::prelude::*;

/// Words of the language and its neighbourhood.
const WORDS: &[&str] = &[
    "x",
    "y",
    "v",
    "n",
    "D",
    "R",
    "r#type",
    "value",
    "rare",
    "lit",
    "sin",
    "powi",
    "f64",
    "Mask",
    "Real",
    "usize",
    "0.5",
    "-",
    "1",
    "1e-4",
    "2.0f32",
    "'a",
    "\"text\"",
    "true",
    "+",
    "*",
    "/",
    "%",
    "<",
    "<=",
    ">",
    ">=",
    "==",
    "!=",
    "&&",
    "||",
    "!",
    "&",
    "mut",
    "=",
    "+=",
    "<<=",
    ".",
    "..",
    "..=",
    ",",
    ";",
    ":",
    "::",
    "->",
    "=>",
    "|",
    "?",
    "#",
    "@",
    "_",
    "if",
    "else",
    "match",
    "let",
    "for",
    "in",
    "while",
    "loop",
    "return",
    "break",
    "continue",
    "as",
    "unsafe",
    "async",
    "await",
    "move",
    "const",
    "fn",
    "struct",
    "use",
    "impl",
    "dyn",
    "where",
    "self",
    "super",
    "matches!",
    "assert!",
    "unreachable!",
    "vec!",
    "static",
    "yield",
    "try",
    "raw",
];

/// Tokens in any order, with brackets that close.
fn soup() -> impl Strategy<Value = String> {
    let word = prop::sample::select(WORDS).prop_map(String::from);
    word.prop_recursive(5, 60, 8, |inner| {
        let bracket = prop::sample::select(&[("(", ")"), ("[", "]"), ("{", "}")][..]);
        (bracket, prop::collection::vec(inner, 0..8))
            .prop_map(|((open, close), words)| format!("{open} {} {close}", words.join(" ")))
    })
}

/// A real-valued expression of the language.
fn real() -> impl Strategy<Value = String> {
    let leaf = prop::sample::select(&["x", "y", "0.5", "-2.0", "v[0]", "R::lit(1.0 / 3.0)", "R::one()"][..])
        .prop_map(String::from);
    leaf.prop_recursive(5, 40, 4, |inner| {
        let two = (inner.clone(), inner.clone());
        let four = (inner.clone(), inner.clone(), inner.clone(), inner.clone());
        prop_oneof![
            (two.clone(), prop::sample::select(&["+", "-", "*", "/"][..]))
                .prop_map(|((a, b), op)| format!("({a} {op} {b})")),
            inner.clone().prop_map(|a| format!("({a}).sqrt()")),
            two.clone().prop_map(|(a, b)| format!("({a}).min({b})")),
            inner.clone().prop_map(|a| format!("-({a})")),
            two.clone().prop_map(|(a, b)| format!("{{ let a = {a}; {b} }}")),
            two.prop_map(|(a, b)| format!("(if D < 3 {{ {a} }} else {{ {b} }})")),
            (four.clone(), prop::sample::select(&["<", "<=", ">", ">="][..]), any::<bool>()).prop_map(
                |((a, b, c, d), op, rare)| {
                    let (open, close) = if rare { ("rare(", ")") } else { ("", "") };
                    format!("(if {open}{a} {op} {b}{close} {{ {c} }} else {{ {d} }})")
                }
            ),
            four.prop_map(|(a, b, c, d)| format!(
                "(if {a} < {b} && !({b} <= {c}) {{ {c} }} else if x > {a} {{ {d} }} else {{ x }})"
            )),
        ]
    })
}

fn function(body: &str) -> String {
    format!("/// D.\nfn f<R: Real, const D: usize>(x: R, y: R, v: Vector<R, D>, n: usize) -> R {{ {body} }}")
}

/// Runs both entries on it, and with mutants. The assertion is that they return, that anything accepted parses, and that mutants
/// change nothing about what is accepted.
fn answers(attribute: &str, item: &str) -> bool {
    let (Ok(attribute), Ok(item)) =
        (attribute.parse::<proc_macro2::TokenStream>(), item.parse::<proc_macro2::TokenStream>())
    else {
        return false;
    };
    let expanded = expand(attribute.clone(), item.clone(), &Surroundings::NONE);
    syn::parse2::<syn::File>(expanded).expect("what the compiler gets is Rust, or compile_error!");
    let place_of = |_| Place::default();
    let around = Surroundings { mutants: Some(&place_of), ..Surroundings::NONE };
    let with_mutants = translate(attribute.clone(), item.clone(), &around);
    let is_accepted = translate(attribute, item, &Surroundings::NONE).is_ok();
    assert_eq!(with_mutants.is_ok(), is_accepted);
    if let Ok(tokens) = with_mutants {
        syn::parse2::<syn::File>(tokens).expect("an equation with its mutants is Rust");
    }
    is_accepted
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_tokens_as_body(words in prop::collection::vec(soup(), 0..8)) {
        answers("\"gs25:8\"", &function(&words.join(" ")));
    }

    #[test]
    fn any_tokens_as_attribute_and_item(attribute in prop::collection::vec(soup(), 0..4), item in prop::collection::vec(soup(), 0..8)) {
        answers(&attribute.join(" "), &item.join(" "));
        answers(&attribute.join(" "), &function("x"));
    }

    #[test]
    fn any_text(attribute in "\\PC{0,20}", item in "\\PC{0,60}") {
        answers(&attribute, &item);
    }

    /// Sound equations are accepted, and a token taken out of one, or put twice, makes no panic.
    #[test]
    fn sound_equations_and_damaged_ones(body in real(), place in any::<prop::sample::Index>(), twice in any::<bool>()) {
        let sound = function(&body);
        prop_assert!(answers("\"gs25:8\"", &sound), "refused: {sound}");
        let mut words: Vec<String> = sound.split(' ').map(String::from).collect();
        let place = place.index(words.len());
        if twice {
            words.insert(place, words[place].clone());
        } else {
            words.remove(place);
        }
        answers("\"gs25:8\"", &words.join(" "));
    }
}
