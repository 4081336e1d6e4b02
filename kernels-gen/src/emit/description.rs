//! Names for values that their author did not name, from what they are: `velocity_x_ab`, `r`, `inverse_r`.

use crate::trace::{Graph, Id, Op};

/// A name for what an operation computes, where it is simple enough to have one. `word` is the name of an operand.
pub(super) fn describe(graph: &Graph, op: Op, word: &dyn Fn(Id) -> Option<String>) -> Option<String> {
    let is = |id: Id, value: f64| graph.literal(id) == Some(value);
    let is_square = |square: Id, of: Id| graph.op(square) == Op::Mul(of, of);
    let with = |prefix: &str, id: Id, suffix: &str| word(id).map(|name| format!("{prefix}{name}{suffix}"));
    match op {
        Op::Mul(a, b) if a == b => with("", a, "_squared"),
        Op::Mul(a, b) if is_square(b, a) => with("", a, "_cubed"),
        Op::Mul(a, b) if is_square(a, b) => with("", b, "_cubed"),
        Op::Sqrt(a) => {
            let name = word(a)?;
            Some(name.strip_suffix("_squared").map_or(format!("sqrt_{name}"), str::to_string))
        }
        Op::Abs(a) => with("abs_", a, ""),
        Op::Neg(a) => with("minus_", a, ""),
        Op::Div(a, b) if is(a, 1.0) => with("one_over_", b, ""),
        Op::Sub(a, b) => of_pair(word(a)?, word(b)?, "_ab"),
        Op::Add(a, b) => of_pair(word(a)?, word(b)?, "_a_plus_b"),
        Op::Less(a, b) if is(a, 0.0) => with("", b, "_is_positive"),
        Op::Less(a, b) if is(b, 0.0) => with("", a, "_is_negative"),
        Op::LessEqual(a, b) if is(b, 0.0) => with("", a, "_is_not_positive"),
        _ => None,
    }
}

/// `density_a` and `density_b` make `density` with the suffix.
fn of_pair(a: String, b: String, suffix: &str) -> Option<String> {
    let common = a.strip_suffix("_a")?;
    (b.strip_suffix("_b")? == common).then(|| format!("{common}{suffix}"))
}

/// An input's name as a word: `a_density` is `density_a`, as the papers write it.
pub(super) fn input_word(input: &str) -> String {
    let prefixes = [("a_", "_a"), ("b_", "_b"), ("sum_", "_sum")];
    let turned = prefixes.iter().find_map(|(prefix, suffix)| {
        let component = input.strip_prefix(prefix)?;
        Some(format!("{component}{suffix}"))
    });
    turned.unwrap_or_else(|| input.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::real::Real;
    use crate::trace::{Single, Symbol, draw};

    fn named(body: impl FnOnce(Symbol<Single>, Symbol<Single>, Symbol<Single>) -> Symbol<Single>) -> Option<String> {
        let drawing = draw::<Single>(|pen| {
            let (own, other, mass) = (pen.input("a_density"), pen.input("b_density"), pen.input("b_mass"));
            pen.output("result", body(own, other, mass));
        });
        let drawing = drawing.expect("only its own symbols");
        let graph = drawing.graph();
        describe(graph, graph.op(drawing.outputs()[0].id), &|id| match graph.op(id) {
            Op::Input(index) => Some(input_word(&drawing.inputs()[index])),
            _ => None,
        })
    }

    #[test]
    fn values_are_named_for_what_they_are() {
        assert_eq!(named(|a, b, _| a - b).as_deref(), Some("density_ab"));
        assert_eq!(named(|a, b, _| a + b).as_deref(), Some("density_a_plus_b"));
        assert_eq!(named(|a, _, m| a - m), None);
        assert_eq!(named(|a, b, _| b - a), None);
        assert_eq!(named(|_, _, m| m.power(3)).as_deref(), Some("mass_b_cubed"));
        assert_eq!(named(|_, _, m| Symbol::one() / m).as_deref(), Some("one_over_mass_b"));
        assert_eq!(named(|a, b, m| a * b + m), None);
        assert_eq!(input_word("sum_density"), "density_sum");
        assert_eq!(input_word("r_squared"), "r_squared");
    }
}
