//! What each construct becomes: snapshots of the translated text, which must be read before a new one is accepted.

use etalon_equation_syntax::{Surroundings, translate};

/// The translated function as formatted Rust, or the errors, one a line.
fn translated(attribute: &str, function: &str) -> Result<String, String> {
    let tokens = |text: &str| text.parse().expect("the text has balanced brackets");
    match translate(tokens(attribute), tokens(function), &Surroundings::NONE) {
        Ok(output) => Ok(prettyplease::unparse(&syn::parse2(output).expect("the output is Rust"))),
        Err(errors) => Err(errors.into_iter().map(|error| format!("{error}\n")).collect()),
    }
}

/// The translated statements of an equation of `x`, `y`, `v`, `n`, `flag` and `known`, with the crate's paths left out.
fn body(statements: &str) -> String {
    let function = format!(
        "/// Documented.
        fn f<R: Real, const D: usize>(x: R, y: R, v: Vector<R, D>, n: usize, flag: bool, known: R::Mask) {{ {statements} }}"
    );
    let text = translated("\"gs25:8\"", &function).unwrap_or_else(|errors| panic!("refused:\n{errors}"));
    let (_, text) = text.split_once("Real>::equation(").expect("the body is wrapped");
    let text = text.replace("<R as ::etalon_kernels_gen::Real>::", "R::").replace("::etalon_kernels_gen::", "");
    let lines = text.lines().skip(5).collect::<Vec<_>>();
    let lines = lines.iter().take(lines.len() - 3).map(|line| line.strip_prefix("            ").unwrap_or(line));
    lines.collect::<Vec<_>>().join("\n")
}

macro_rules! snapshots {
    ($($name:ident: $statements:expr;)*) => {
        $(#[test]
        fn $name() {
            insta::assert_snapshot!(stringify!($name), body($statements), $statements);
        })*
    };
}

snapshots! {
    literals: "x * 0.5 + -1e-4 - f(2.0, [3.0; 2], -x) + 4.0.squared() + -y + R::lit(1.0 / 3.0f64 + n as f64) + R::lit(HALF)";
    integers_stay: "for i in 1..n { g(v[i - 1], 2) } const C: f64 = 0.5; x.power(3)";
    comparisons: "let m = (x + 0.5) < y; let k = !(m && x >= 0.0) || known; let i = n < 3; let j = D >= 2; g(x > y, m)";
    if_on_data: "let z = if x < 0.0 { -x } else if x <= 1.0 || known { let s = x * y; s } else { y }; z";
    if_is_decided_early: "let z = if D < 3 { x } else if flag && n == 2 { y } else if let Some(q) = g(0.5) { q } else { 1.0 }; z";
    if_on_a_method: "let z = if x.lt(y).and(known) { x } else { y }; if n.lt(&3) { z } else { -z }";
    rare_branch: "if rare(x < y) { g(x) } else { 0.0 }";
    names: "let a = g(x); let b: R = x; let mut c = x; let _d = x; let (e, f) = (x, y); let g = 1; let h = &x; let r#type = x; a";
    accumulation: "let mut s = 0.0; let mut k = 0; s += x; s -= x + y; s *= if x < y { x } else { y }; k += 1; s[n] /= 2.0; h().0 += x; s";
    closures: "Vector::from_fn(|i| if v[i] < x { 0.5 } else { v[i] })";
    decisions: "match n { 0 if flag => 0.5, _ if matches!(n, 1 | 2) => x, _ => unreachable!(\"{}\", n) }";
}

/// The whole of the output, once.
#[test]
fn whole_function() {
    let function = "
        /// The claim.
        #[must_use]
        pub(crate) fn balsara_limiter<R>(div_v: R, curl_v: R) -> R where R: Real {
            #![allow(clippy::inside)]
            let sum = div_v.abs() + curl_v.abs();
            div_v.abs() / (sum + 1e-4)
        }";
    let attribute = "\"gs25:8\", \"gs25:9\"";
    insta::assert_snapshot!(translated(attribute, function).expect("accepted"));
}

/// An unnumbered definition, an object's equation, and a result that cannot be written on a closure.
#[test]
fn unnumbered_method() {
    let function = "
        /// The claim.
        fn weights<R: Real>(&self, x: R) -> impl Iterator<Item = R> {
            g(x)
        }";
    let attribute = "unnumbered = \"mixed sinc kernel, GS25 section 3\"";
    insta::assert_snapshot!(translated(attribute, function).expect("accepted"));
}

/// What is computed on the host alone stays as it is: no constant, comparison or early return is translated.
#[test]
fn host_function() {
    let function = "
        /// The claim.
        pub fn mean<F: Float>(values: &[F]) -> Option<f64> {
            #![allow(clippy::inside)]
            if values.is_empty() { return None; }
            let sum: f64 = values.iter().map(|x| x.to_f64()).sum();
            Some(0.5 * sum)
        }";
    insta::assert_snapshot!(translated("\"gs25:20\", host", function).expect("accepted"));
}

#[test]
fn what_could_be_translated_is_no_host_function() {
    let refused = |attribute, function| translated(attribute, function).expect_err("refused");
    let generic = refused("\"gs25:20\", host", "/// The claim.\nfn f<R: Real>(x: R) -> R { x }");
    assert_eq!(generic, "what is generic over `Real` runs on every target: leave `host` out\n");
    let bare = refused("\"gs25:20\", host, host", "fn f(x: f64) -> f64 { x }");
    assert!(bare.starts_with("`host` is given twice; keep one\nan equation is its documentation too"), "{bare}");
    assert!(refused("host", "/// The claim.\nfn f() {}").starts_with("the equation names no source"));
}

/// One function, all its errors.
#[test]
fn errors_come_all_at_once() {
    let function = "fn f<R: Real>(x: R, y: f64) -> R { let z = x.sin(); while x < 1.0 { return z.exp(); } z }";
    insta::assert_snapshot!(translated("8", function).expect_err("refused"));
}
