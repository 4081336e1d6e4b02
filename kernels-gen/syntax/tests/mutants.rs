//! Which faults each construct can be given: snapshots of the list, and of one translation with them in it.

use etalon_equation_syntax::{Place, Surroundings, expand_part, mutants, translate};
use syn::visit::Visit;

fn with_mutants(function: &str) -> syn::File {
    let tokens = |text: &str| text.parse().expect("the text has balanced brackets");
    let place_of = |_| Place { line: 1, column: 1 };
    let around = Surroundings { mutants: Some(&place_of), ..Surroundings::NONE };
    let output = translate(tokens("\"gs25:8\""), tokens(function), &around).expect("accepted");
    syn::parse2(output).expect("the output is Rust")
}

/// The equation of `x`, `y`, `v`, `n`, `flag` and `known` with these statements.
fn function(statements: &str) -> String {
    format!(
        "/// Documented.
        fn f<R: Real, const D: usize>(x: R, y: R, v: Vector<R, D>, n: usize, flag: bool, known: R::Mask) {{ {statements} }}"
    )
}

/// Collects `operator`, `original` and `mutated` of every entry of the list.
#[derive(Default)]
struct List(Vec<String>);

impl<'ast> Visit<'ast> for List {
    fn visit_macro(&mut self, call: &'ast syn::Macro) {
        if let Ok(entry) = syn::parse2::<syn::ExprStruct>(call.tokens.clone()) {
            self.visit_expr_struct(&entry);
        }
    }
    fn visit_expr_struct(&mut self, entry: &'ast syn::ExprStruct) {
        let text = |name: &str| {
            let field = entry.fields.iter().find(|f| matches!(&f.member, syn::Member::Named(n) if n == name))?;
            match &field.expr {
                syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) => Some(text.value()),
                _ => None,
            }
        };
        if let (Some(operator), Some(original), Some(mutated)) = (text("operator"), text("original"), text("mutated")) {
            self.0.push(format!("{operator}: {original} → {mutated}"));
        }
        syn::visit::visit_expr_struct(self, entry);
    }
}

fn list(statements: &str) -> String {
    let file = with_mutants(&function(statements));
    let mut list = List::default();
    list.visit_file(&file);
    // The signature's own mutant, the same for all.
    assert_eq!(list.0.pop().as_deref(), Some("swapped: fn(.., x, y, ..) → fn(.., y, x, ..)"));
    list.0.join("\n")
}

macro_rules! snapshots {
    ($($name:ident: $statements:expr;)*) => {
        $(#[test]
        fn $name() {
            insta::assert_snapshot!(stringify!($name), list($statements), $statements);
        })*
    };
}

snapshots! {
    arithmetic: "let mut s = x + y; s -= x * y / x; s = s - (-x); g(n + 1, 2 * n)";
    constants: "g(0.5, 0.0, -2.0) * R::lit(FLOOR.0 * TABLE[D - 1] / PI + D as f64 - v.x) + x.power(3) + y.power(D as u32) + R::zero()";
    exact_constants: "R::constant(THIRD) * x + R::constant(TABLE[D - 1]) * y";
    arms: "let z = match way { Way::Up => x, Way::Down | Way::Back => -x, Way::Other(n) if n > 1 => y, _ => y }; match D { 1 => z, 2 => z, _ => y }";
    methods: "x.min(y.abs()).max(0.0).sqrt() + v.scale(x).norm() + x.mul_add(y, 1.0) + x.power(n)";
    arguments: "g(x, y, n, 3) + h(|i| v[i], x) + R::pick(known, x, y) + x.thrice(y, v)";
    comparisons: "let m = x < y && !(x >= 0.0) || known; g(m, x.lt(y))";
    branches: "let z = if x < y { x } else { y }; let w = if D < 3 { z } else if flag { x } else if let Some(q) = g() { q } else { y }; w";
    parts: "let (a, b) = (x + y, 2); Shape { value: a, slope: b, corner: [x, y] }";
    what_stays: "const C: f64 = 0.5; assert!(n == 1); let a = [x; 3]; root::<R, 2>(a[0]); let mut s = [x; 2]; s[1] += y; s";
}

/// The whole of the output, once; the result has a sign to lose.
#[test]
fn whole_function_with_mutants() {
    let file = with_mutants("/// The claim.\nfn half_sum<R: Real>(a: R, b: R) -> R { 0.5 * (a + b) }");
    insta::assert_snapshot!(prettyplease::unparse(&file));
}

/// Without mutants not a token of a part changes.
#[test]
fn a_part_is_left_alone() {
    let part = "#[inline(always)] fn twice<R: Real>(x: R) -> R { R::lit(2.0) * x }";
    let tokens: proc_macro2::TokenStream = part.parse().expect("tokens");
    assert_eq!(expand_part(tokens.clone(), &Surroundings::NONE).to_string(), tokens.to_string());
    let place_of = |_| Place::default();
    let with = expand_part(tokens, &Surroundings { mutants: Some(&place_of), ..Surroundings::NONE }).to_string();
    assert!(with.contains("ETALON_MUTANTS . is (4u32)") && !with.contains(":: equation"), "{with}");
}

/// The list by itself is the one that the translation carries; what is generic over nothing has none.
#[test]
fn the_list_can_be_had_without_the_translation() {
    let text = function("let z = if x < y { x } else { y }; z + 0.5 * x");
    let mut carried = List::default();
    carried.visit_file(&with_mutants(&text));
    let place_of = |_| Place { line: 1, column: 1 };
    let list = mutants(text.parse().expect("tokens"), &place_of).expect("accepted");
    let list: Vec<_> = list.iter().map(|m| format!("{}: {} → {}", m.operator, m.original, m.mutated)).collect();
    assert!(list.len() > 5);
    assert_eq!(list, carried.0);
    let host = "fn mean(values: &[f64]) -> f64 { values.iter().sum::<f64>() / 2.0 }";
    assert_eq!(mutants(host.parse().expect("tokens"), &place_of).expect("accepted"), []);
}
