//! C99: the same graphs for a second kind of target. A drawing in single precision becomes `float`, in double `double`.
//!
//! A drawing `kernel` becomes
//!
//! ```c
//! struct kernel_in { float q; };
//! struct kernel_out { float w; };
//! void kernel(const struct kernel_in *in, struct kernel_out *out)
//! ```
//!
//! Compile with `-ffp-contract=off`: then the result is that of the graph, bit for bit. The text of several drawings may
//! stand in one file, after one [`prelude`].

use super::MulAdd;
use super::body::body;
use super::error::EmitError;
use super::expression::{Dialect, Text, Tight, decimal};
use super::header::{Header, Part, header};
use super::names::{Names, legal};
use crate::real::Precision;
use crate::trace::{Drawing, PassDrawing};
use std::collections::BTreeMap;

/// What the functions need before them, once a file.
pub fn prelude() -> &'static str {
    "\
#include <math.h>
#include <stdbool.h>

#pragma STDC FP_CONTRACT OFF

static inline float smaller_float(float a, float b) { return a < b ? a : b; }
static inline float larger_float(float a, float b) { return a > b ? a : b; }
static inline double smaller_double(double a, double b) { return a < b ? a : b; }
static inline double larger_double(double a, double b) { return a > b ? a : b; }
"
}

/// A drawing as a function with the structs it takes and returns, to stand after [`prelude`].
///
/// # Errors
/// If the drawing contains a constant that is not finite.
pub fn function(name: &str, drawing: &Drawing, head: &Header, mul_add: MulAdd) -> Result<String, EmitError> {
    let drawing = drawing.simplified();
    let name = legal(name, is_word);
    let mut member_names = Names::new(is_word, &[]);
    let inputs: Vec<String> = drawing.inputs().iter().map(|input| member_names.unique(input)).collect();
    let inputs_by_name = drawing.inputs().iter().cloned().zip(inputs.iter().cloned()).collect();
    let dialect = C { precision: drawing.precision(), mul_add, inputs: inputs_by_name };
    let body = body(&name, &drawing, &dialect, &["in", "out", &name])?;
    let number = dialect.number();

    let parts = [Part { how_often: "per call", drawing: &drawing }];
    let mut lines = header(head, &format!("Function `{name}`"), mul_add, &parts, &[]);
    let mut output_names = Names::new(is_word, &[]);
    let outputs: Vec<String> = body.outputs.iter().map(|(output, _)| output_names.unique(output)).collect();
    for (kind, members) in [("in", &inputs), ("out", &outputs)] {
        lines.extend([String::new(), format!("struct {name}_{kind} {{")]);
        lines.extend(members.iter().map(|member| format!("    {number} {member};")));
        if members.is_empty() {
            lines.push("    char nothing;".to_string());
        }
        lines.push("};".to_string());
    }
    lines.push(String::new());
    lines.push(format!("void {name}(const struct {name}_in *in, struct {name}_out *out) {{"));
    lines.extend(body.lines.iter().map(|line| if line.is_empty() { String::new() } else { format!("    {line}") }));
    if drawing.needed().iter().all(|id| !matches!(drawing.graph().op(*id), crate::trace::Op::Input(_))) {
        lines.push("    (void)in;".to_string());
    }
    let assigned = outputs.iter().zip(&body.outputs);
    lines.extend(assigned.map(|(member, (_, text))| format!("    out->{member} = {text};")));
    lines.push("}".to_string());
    Ok(lines.join("\n") + "\n")
}

/// The two bodies of a pass as functions `<pass>_pair` and `<pass>_finish`, after the prelude.
///
/// # Errors
/// As for [`function`].
pub fn pass(drawing: &PassDrawing, head: &Header, mul_add: MulAdd) -> Result<String, EmitError> {
    let drawing = drawing.simplified();
    let pair = function(&format!("{}_pair", drawing.name), &drawing.pair, head, mul_add)?;
    let finish = function(&format!("{}_finish", drawing.name), &drawing.finish, head, mul_add)?;
    Ok(format!("{}\n{pair}\n{finish}", prelude()))
}

struct C {
    precision: Precision,
    mul_add: MulAdd,
    inputs: BTreeMap<String, String>,
}

impl C {
    fn number(&self) -> &'static str {
        match self.precision {
            Precision::Single => "float",
            Precision::Double | Precision::Extended => "double",
        }
    }
}

impl Dialect for C {
    fn literal(&self, value: f64) -> String {
        match self.precision {
            Precision::Single => decimal(format!("{:?}", value as f32)) + "f",
            Precision::Double | Precision::Extended => decimal(format!("{value:?}")),
        }
    }
    fn input(&self, name: &str) -> String {
        format!("in->{}", self.inputs.get(name).map_or(name, String::as_str))
    }
    fn functions(&self) -> [&'static str; 4] {
        match self.precision {
            Precision::Single => ["fabsf", "sqrtf", "smaller_float", "larger_float"],
            Precision::Double | Precision::Extended => ["fabs", "sqrt", "smaller_double", "larger_double"],
        }
    }
    fn fused(&self) -> Option<&'static str> {
        let name = match self.precision {
            Precision::Single => "fmaf",
            Precision::Double | Precision::Extended => "fma",
        };
        (self.mul_add == MulAdd::Fused).then_some(name)
    }
    fn select(&self, mask: &Text, yes: &Text, no: &Text) -> Text {
        let side = |text: &Text| text.at_least(Tight::Compare);
        Text::new(format!("{} ? {} : {}", mask.at_least(Tight::Unary), side(yes), side(no)), Tight::Choice)
    }
    fn declare(&self, is_mask: bool) -> &'static str {
        match (is_mask, self.precision) {
            (true, _) => "const bool",
            (false, Precision::Single) => "const float",
            (false, Precision::Double | Precision::Extended) => "const double",
        }
    }
    fn forbidden(&self) -> fn(&str) -> bool {
        is_word
    }
}

/// Keywords of C and C++, and the functions that are called.
fn is_word(name: &str) -> bool {
    const WORDS: &str = "
        alignas alignof and and_eq asm auto bitand bitor bool break case catch char class compl const constexpr continue
        default delete do double else enum explicit export extern false float for friend goto if inline int long mutable
        namespace new not not_eq nullptr operator or or_eq private protected public register restrict return short signed
        sizeof static struct switch template this throw true try typedef typename union unsigned using virtual void
        volatile wchar_t while xor xor_eq
        fabs fabsf sqrt sqrtf fma fmaf smaller_float larger_float smaller_double larger_double main
    ";
    WORDS.split_whitespace().any(|word| word == name)
}
