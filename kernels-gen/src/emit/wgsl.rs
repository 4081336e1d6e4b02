//! WGSL.
//!
//! A pass `density` becomes the structs `DensityOwn`, `DensityOther`, `DensitySums` and `DensityOut`, whose members are the
//! components in order, and the functions
//!
//! ```wgsl
//! fn density_pair(own: DensityOwn, other: DensityOther, x_ab: vec3<f32>, r_squared: f32) -> DensitySums
//! fn density_finish(own: DensityOwn, sums: DensitySums) -> DensityOut
//! ```
//!
//! An update `drift` becomes `fn drift_apply(own: DriftOwn, time_step: f32) -> DriftOut`. In one dimension `x_ab` is an
//! `f32`. WGSL has no empty structs: where a record is empty its struct and parameter are left out, and so is a function
//! that would return nothing. Components whose name is a reserved word have `_` behind it, see [`member`].
//!
//! Only `+ - * /`, `sqrt`, `abs`, `min`, `max`, comparisons and `select` are used, and `fma` if asked for.

mod reserved;

use super::body::body;
use super::error::EmitError;
use super::expression::{Dialect, Text, decimal};
use super::header::{Header, Part, header, lint, list};
use super::names::{camel_case, legal};
use super::{MulAdd, expression::Tight};
use crate::real::Precision;
use crate::record::Reduction;
use crate::trace::{Drawing, PassDrawing, UpdateDrawing};
use reserved::{is_reserved, is_word};
use std::collections::BTreeMap;

/// A longer list of parameters is broken up.
const WIDTH: usize = 120;

/// The structs and functions of a pass.
///
/// # Errors
/// If the pass was drawn in double precision, or contains a constant that is not finite.
pub fn pass(drawing: &PassDrawing, head: &Header, mul_add: MulAdd) -> Result<String, EmitError> {
    let drawing = drawing.simplified();
    let structs = camel_case(drawing.name);
    let sums: Vec<String> = drawing.sums.iter().map(|sum| sum.name.clone()).collect();
    let records = [("Own", &drawing.own), ("Other", &drawing.other), ("Sums", &sums), ("Out", &drawing.out)];

    let separation = match drawing.dimension {
        1 => "f32".to_string(),
        dimension => format!("vec{dimension}<f32>"),
    };
    let mut pair = Function::new(format!("{}_pair", drawing.name), "sums", format!("{structs}Sums"), mul_add);
    pair.record("own", &format!("{structs}Own"), "a_", &drawing.own);
    pair.record("other", &format!("{structs}Other"), "b_", &drawing.other);
    pair.parameters.push(("x_ab".to_string(), separation));
    for axis in ["x", "y", "z"].into_iter().take(drawing.dimension) {
        let text = if drawing.dimension == 1 { "x_ab".to_string() } else { format!("x_ab.{axis}") };
        pair.inputs.insert(format!("x_ab_{axis}"), text);
    }
    pair.number("r_squared");

    let mut finish = Function::new(format!("{}_finish", drawing.name), "out", format!("{structs}Out"), mul_add);
    finish.record("own", &format!("{structs}Own"), "a_", &drawing.own);
    finish.record("sums", &format!("{structs}Sums"), "sum_", &sums);

    let zero: Vec<String> = drawing.zero_sums().iter().map(|sum| format!("`{sum}`")).collect();
    let finish_unused = drawing.finish.unused_inputs();
    let both_unused = |input: &&str| !input.starts_with("a_") || finish_unused.contains(input);
    let unused =
        drawing.pair.unused_inputs().into_iter().filter(both_unused).filter_map(|input| pair.inputs.get(input));
    let unused: Vec<String> = unused.map(|text| format!("`{text}`")).collect();
    let maxima = drawing.sums.iter().filter(|sum| sum.reduction == Reduction::Max);
    let maxima: Vec<String> = maxima.map(|sum| format!("`{}`", sum.name)).collect();
    let remarks = [
        list("Combined as the maximum, not the sum", &maxima),
        list("Sums that are always zero", &zero),
        list("Never read", &unused),
    ];

    let parts = [
        Part { how_often: "per pair", drawing: &drawing.pair },
        Part { how_often: "per particle", drawing: &drawing.finish },
    ];
    let subject = format!("Pass `{}` in {}", drawing.name, dimensions(drawing.dimension));
    let remarks: Vec<String> = remarks.into_iter().flatten().chain(lint(&parts)).collect();
    let mut lines = header(head, &subject, mul_add, &parts, &remarks);
    for (kind, members) in records {
        lines.extend(structure(&format!("{structs}{kind}"), members));
    }
    lines.extend(pair.lines("What one neighbour contributes.", &drawing.pair)?);
    lines.extend(finish.lines("What the particle makes of the sums.", &drawing.finish)?);
    Ok(lines.join("\n") + "\n")
}

/// The structs and the function of an update.
///
/// # Errors
/// As for [`pass`].
pub fn update(drawing: &UpdateDrawing, head: &Header, mul_add: MulAdd) -> Result<String, EmitError> {
    let drawing = drawing.simplified();
    let structs = camel_case(drawing.name);
    let mut apply = Function::new(format!("{}_apply", drawing.name), "out", format!("{structs}Out"), mul_add);
    apply.record("own", &format!("{structs}Own"), "a_", &drawing.own);
    apply.number("time_step");
    let unused = drawing.apply.unused_inputs().into_iter().filter_map(|input| apply.inputs.get(input));
    let unused: Vec<String> = unused.map(|text| format!("`{text}`")).collect();
    let subject = format!("Update `{}` in {}", drawing.name, dimensions(drawing.dimension));
    let parts = [Part { how_often: "per particle", drawing: &drawing.apply }];
    let remarks: Vec<String> = list("Never read", &unused).into_iter().chain(lint(&parts)).collect();
    let mut lines = header(head, &subject, mul_add, &parts, &remarks);
    lines.extend(structure(&format!("{structs}Own"), &drawing.own));
    lines.extend(structure(&format!("{structs}Out"), &drawing.out));
    lines.extend(apply.lines("What becomes of the particle in one step.", &drawing.apply)?);
    Ok(lines.join("\n") + "\n")
}

/// Any drawing as a function of numbers, `fn name(x: f32, y: f32) -> NameOut`, with the struct it returns.
///
/// # Errors
/// As for [`pass`].
pub fn function(name: &str, drawing: &Drawing, head: &Header, mul_add: MulAdd) -> Result<String, EmitError> {
    let drawing = drawing.simplified();
    let name = function_name(name);
    let structs = camel_case(&name);
    let mut function = Function::new(name, "out", format!("{structs}Out"), mul_add);
    drawing.inputs().iter().for_each(|input| function.number(input));
    let parts = [Part { how_often: "per call", drawing: &drawing }];
    let mut lines = header(head, &format!("Function `{}`", function.name), mul_add, &parts, &lint(&parts));
    let members: Vec<String> = drawing.outputs().iter().map(|output| output.name.clone()).collect();
    lines.extend(structure(&format!("{structs}Out"), &members));
    lines.extend(function.lines("", &drawing)?);
    Ok(lines.join("\n") + "\n")
}

/// The name that [`function`] gives a function: the same, but for reserved words.
pub fn function_name(name: &str) -> String {
    legal(name, is_word)
}

/// A component's name as a member of a struct: the same, but for reserved words.
pub fn member(component: &str) -> String {
    legal(component, is_reserved)
}

fn dimensions(dimension: usize) -> &'static str {
    ["one dimension", "two dimensions", "three dimensions"][dimension.clamp(1, 3) - 1]
}

/// A struct's declaration with an empty line before it; nothing for no members.
fn structure(name: &str, members: &[String]) -> Vec<String> {
    if members.is_empty() {
        return Vec::new();
    }
    let mut lines = vec![String::new(), format!("struct {name} {{")];
    for component in members {
        // A record made of records may read a field twice; it is one member.
        let line = format!("    {}: f32,", member(component));
        if !lines.contains(&line) {
            lines.push(line);
        }
    }
    lines.push("}".to_string());
    lines
}

/// A function in the making.
struct Function {
    name: String,
    /// The variable that collects the outputs, and its type.
    result: (&'static str, String),
    parameters: Vec<(String, String)>,
    /// How each of the drawing's inputs is written.
    inputs: BTreeMap<String, String>,
    mul_add: MulAdd,
}

impl Function {
    fn new(name: String, variable: &'static str, returns: String, mul_add: MulAdd) -> Self {
        Function { name, result: (variable, returns), parameters: Vec::new(), inputs: BTreeMap::new(), mul_add }
    }
    /// A struct as parameter, whose members are inputs.
    fn record(&mut self, parameter: &str, structure: &str, prefix: &str, members: &[String]) {
        if !members.is_empty() {
            self.parameters.push((parameter.to_string(), structure.to_string()));
        }
        for component in members {
            self.inputs.insert(format!("{prefix}{component}"), format!("{parameter}.{}", member(component)));
        }
    }
    /// A number as parameter.
    fn number(&mut self, input: &str) {
        let wanted = legal(input, is_word);
        let taken = |name: &str| self.parameters.iter().any(|(known, _)| known == name) || name == self.result.0;
        let mut name = wanted.clone();
        let mut number = 0;
        while taken(&name) {
            number += 1;
            name = format!("{wanted}_{number}");
        }
        self.parameters.push((name.clone(), "f32".to_string()));
        self.inputs.insert(input.to_string(), name);
    }
    /// The function's text with an empty line before it; nothing where nothing is returned.
    fn lines(&self, summary: &str, drawing: &Drawing) -> Result<Vec<String>, EmitError> {
        if drawing.precision() != Precision::Single {
            return Err(EmitError::NotSingle { function: self.name.clone() });
        }
        let (variable, returns) = &self.result;
        let mut taken: Vec<&str> = self.parameters.iter().map(|(name, _)| name.as_str()).collect();
        taken.extend([*variable, self.name.as_str()]);
        let body = body(&self.name, drawing, self, &taken)?;
        if body.outputs.is_empty() {
            return Ok(Vec::new());
        }
        let parameters: Vec<String> = self.parameters.iter().map(|(name, kind)| format!("{name}: {kind}")).collect();
        let mut lines = vec![String::new()];
        if !summary.is_empty() {
            lines.push(format!("// {summary}"));
        }
        let line = format!("fn {}({}) -> {returns} {{", self.name, parameters.join(", "));
        if line.len() <= WIDTH {
            lines.push(line);
        } else {
            lines.push(format!("fn {}(", self.name));
            lines.extend(parameters.iter().map(|parameter| format!("    {parameter},")));
            lines.push(format!(") -> {returns} {{"));
        }
        let indented = |line: &String| if line.is_empty() { String::new() } else { format!("    {line}") };
        lines.extend(body.lines.iter().map(indented));
        if !body.lines.is_empty() {
            lines.push(String::new());
        }
        lines.push(format!("    var {variable}: {returns};"));
        let assign = |(name, text): &(String, String)| format!("    {variable}.{} = {text};", member(name));
        lines.extend(body.outputs.iter().map(assign));
        lines.push(format!("    return {variable};"));
        lines.push("}".to_string());
        Ok(lines)
    }
}

impl Dialect for Function {
    fn literal(&self, value: f64) -> String {
        decimal(format!("{:?}", value as f32)) + "f"
    }
    fn input(&self, name: &str) -> String {
        self.inputs.get(name).cloned().unwrap_or_else(|| legal(name, is_word))
    }
    fn functions(&self) -> [&'static str; 4] {
        ["abs", "sqrt", "min", "max"]
    }
    fn fused(&self) -> Option<&'static str> {
        (self.mul_add == MulAdd::Fused).then_some("fma")
    }
    fn select(&self, mask: &Text, yes: &Text, no: &Text) -> Text {
        Text::new(format!("select({}, {}, {})", no.text, yes.text, mask.text), Tight::Atom)
    }
    fn declare(&self, _is_mask: bool) -> &'static str {
        "let"
    }
    fn forbidden(&self) -> fn(&str) -> bool {
        is_word
    }
}
