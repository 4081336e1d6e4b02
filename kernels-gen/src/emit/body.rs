//! The statements of a function.

use super::description::{describe, input_word};
use super::error::EmitError;
use super::expression::{Dialect, Text, compose};
use super::names::Names;
use crate::trace::{Drawing, Id, Op, Scope, Shape};

/// A line longer than this is broken up by giving names to its parts.
const WIDTH: usize = 92;
/// Operands shorter than this are not worth a line of their own.
const PART: usize = 12;

/// A name longer than this is not made part of another.
const LONG_WORD: usize = 40;

/// A function's body.
pub(super) struct Body {
    /// Statements and comments, not indented; empty lines where there should be some.
    pub lines: Vec<String>,
    /// The outputs' names with their expressions, in order.
    pub outputs: Vec<(String, String)>,
}

/// Prints the statements of a simplified drawing. `function` is the name that comments and errors give it; `parameters`
/// are identifiers that are taken.
pub(super) fn body(
    function: &str,
    drawing: &Drawing,
    dialect: &dyn Dialect,
    parameters: &[&str],
) -> Result<Body, EmitError> {
    let uses = drawing.uses();
    let mut writer = Writer {
        drawing,
        dialect,
        function,
        owners: drawing.owners(),
        uses,
        results: drawing.results(),
        names: Names::new(dialect.forbidden(), parameters),
        texts: vec![None; drawing.graph().len()],
        scope: None,
        lines: Vec::new(),
    };
    for id in drawing.needed() {
        writer.check_finite(id)?;
        writer.write(id);
    }
    let outputs = drawing.outputs().iter().map(|output| (output.name.clone(), writer.text(output.id).text)).collect();
    Ok(Body { lines: writer.lines, outputs })
}

struct Writer<'a> {
    drawing: &'a Drawing,
    dialect: &'a dyn Dialect,
    function: &'a str,
    /// The name of the value that each node is part of.
    owners: Vec<&'a str>,
    uses: Vec<u32>,
    /// Which nodes are what an equation returns.
    results: Vec<bool>,
    names: Names,
    /// How to write each node where it is used; filled in order.
    texts: Vec<Option<Text>>,
    /// The equation of the last line.
    scope: Option<Scope>,
    lines: Vec<String>,
}

impl Writer<'_> {
    fn text(&self, id: Id) -> Text {
        self.texts[id.index()].clone().unwrap_or_else(|| Text::atom("")) // operands come first, so it is there
    }

    fn check_finite(&self, id: Id) -> Result<(), EmitError> {
        let graph = self.drawing.graph();
        let op = graph.op(id);
        // What the simplifier left of operations on constants is what it could not compute.
        let constant = |a| matches!(graph.op(a), Op::Literal(_) | Op::Truth(_));
        let broken = match op {
            Op::Literal(literal) => !literal.value().is_finite(),
            _ => !op.is_leaf() && op.operands().all(constant),
        };
        if !broken {
            return Ok(());
        }
        let equation = graph.node(id).scope.map_or("outside of any equation".to_string(), |scope| scope.to_string());
        Err(EmitError::NotFinite {
            function: self.function.to_string(),
            name: self.owners[id.index()].to_string(),
            equation,
        })
    }

    /// Writes a node's own line, or keeps its text for where it is used.
    fn write(&mut self, id: Id) {
        let node = self.drawing.graph().node(id);
        let mut text = self.compose(id);
        while text.text.len() > WIDTH {
            let parts = node.op.operands().filter(|part| self.is_inlined(*part));
            let Some(longest) = parts.max_by_key(|part| self.text(*part).text.len()) else { break };
            if self.text(longest).text.len() < PART {
                break;
            }
            self.declare(longest);
            text = self.compose(id);
        }
        self.texts[id.index()] = Some(text);
        let own_line = node.name.is_some() || self.uses[id.index()] > 1 || self.results[id.index()];
        if own_line && !node.op.is_leaf() {
            self.declare(id);
        }
    }

    fn compose(&self, id: Id) -> Text {
        let op = self.drawing.graph().op(id);
        let operands: Vec<Text> = op.operands().map(|operand| self.text(operand)).collect();
        compose(op, self.dialect, self.drawing.inputs(), &operands)
    }

    /// Whether the node's text is an expression, not a name.
    fn is_inlined(&self, id: Id) -> bool {
        let is_name = |c: char| c.is_ascii_alphanumeric() || c == '_';
        !self.drawing.graph().op(id).is_leaf() && !self.text(id).text.chars().all(is_name)
    }

    /// Gives the node's text a name on a line of its own.
    fn declare(&mut self, id: Id) {
        let node = self.drawing.graph().node(id);
        let wanted = match &node.name {
            Some(name) => name.clone(),
            None => self.invented_name(id),
        };
        let name = self.names.unique(&wanted);
        self.comment(node.scope);
        let keyword = self.dialect.declare(node.op.shape() == Shape::Mask);
        self.lines.push(format!("{keyword} {name} = {};", self.text(id).text));
        self.texts[id.index()] = Some(Text::atom(name));
    }

    /// Says where the following lines come from, if that has changed.
    fn comment(&mut self, scope: Option<Scope>) {
        if self.scope == scope {
            return;
        }
        if !self.lines.is_empty() {
            self.lines.push(String::new());
        }
        self.lines.push(match scope {
            Some(scope) => format!("// {scope}"),
            None => format!("// back in {}", self.function),
        });
        self.scope = scope;
    }

    /// A name for a value that the author did not name.
    fn invented_name(&self, id: Id) -> String {
        let node = self.drawing.graph().node(id);
        let is_output = self.drawing.outputs().iter().any(|output| output.id == id);
        if self.results[id.index()] || is_output {
            return self.owners[id.index()].to_string();
        }
        let described = describe(self.drawing.graph(), node.op, &|operand| self.word(operand));
        let kind = if node.op.shape() == Shape::Mask { "case" } else { "part" };
        described.unwrap_or_else(|| format!("{}_{kind}", self.owners[id.index()]))
    }

    /// A node's name as part of another name, if it has one that says something.
    fn word(&self, id: Id) -> Option<String> {
        let name = match self.drawing.graph().op(id) {
            Op::Input(index) => input_word(&self.drawing.inputs()[index]),
            Op::Literal(_) | Op::Truth(_) => return None,
            _ if self.is_inlined(id) => return None,
            _ => self.text(id).text,
        };
        (name.len() < LONG_WORD && !name.contains("_part")).then_some(name)
    }
}
