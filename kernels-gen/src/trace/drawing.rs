//! A finished drawing: a graph with named inputs and outputs.

use super::graph::{Graph, Id, Op, Scope};
use crate::real::Precision;

/// A named result.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Output {
    /// Its name.
    pub name: String,
    /// The node that computes it.
    pub id: Id,
}

/// A computation as a graph, with names for what goes in and comes out.
#[derive(Clone, Debug)]
pub struct Drawing {
    graph: Graph,
    inputs: Vec<String>,
    outputs: Vec<Output>,
    precision: Precision,
}

impl Drawing {
    pub(super) fn new(graph: Graph, inputs: Vec<String>, outputs: Vec<Output>, precision: Precision) -> Self {
        Drawing { graph, inputs, outputs, precision }
    }
    /// The nodes.
    pub fn graph(&self) -> &Graph {
        &self.graph
    }
    /// The inputs' names, in the order they were first asked for; also those that simplification left without a use.
    pub fn inputs(&self) -> &[String] {
        &self.inputs
    }
    /// The outputs, in the order they were given.
    pub fn outputs(&self) -> &[Output] {
        &self.outputs
    }
    /// The precision it was drawn for.
    pub fn precision(&self) -> Precision {
        self.precision
    }
    /// How often each node is used, by a node that is needed or by an output; zero for nodes that nothing needs.
    pub fn uses(&self) -> Vec<u32> {
        let mut uses = vec![0; self.graph.len()];
        for output in &self.outputs {
            uses[output.id.index()] += 1;
        }
        for id in self.graph.ids().collect::<Vec<_>>().into_iter().rev() {
            if uses[id.index()] > 0 {
                self.graph.op(id).operands().for_each(|operand| uses[operand.index()] += 1);
            }
        }
        uses
    }
    /// The nodes that the outputs need, operands before users.
    pub fn needed(&self) -> Vec<Id> {
        let uses = self.uses();
        self.graph.ids().filter(|id| uses[id.index()] > 0).collect()
    }
    /// The names of the inputs that nothing needs.
    pub fn unused_inputs(&self) -> Vec<&str> {
        let mut used = vec![false; self.inputs.len()];
        for id in self.needed() {
            if let Op::Input(index) = self.graph.op(id) {
                used[index] = true;
            }
        }
        self.inputs.iter().zip(used).filter(|(_, used)| !used).map(|(name, _)| name.as_str()).collect()
    }
    /// The names of the outputs that are zero whatever goes in. Ask a [simplified](Drawing::simplified) drawing.
    pub fn zero_outputs(&self) -> Vec<&str> {
        let zero = |output: &&Output| self.graph.literal(output.id) == Some(0.0);
        self.outputs.iter().filter(zero).map(|output| output.name.as_str()).collect()
    }
    /// The equations it is made of, in the order of their first needed node.
    pub fn equations(&self) -> Vec<Scope> {
        let mut equations = Vec::new();
        for scope in self.needed().into_iter().filter_map(|id| self.graph.node(id).scope) {
            if !equations.contains(&scope) {
                equations.push(scope);
            }
        }
        equations
    }
    /// For each node whether it is what an equation returns: made in it and used only outside of it.
    pub(crate) fn results(&self) -> Vec<bool> {
        let mut results: Vec<bool> = self.graph.ids().map(|id| self.graph.node(id).scope.is_some()).collect();
        for id in self.needed() {
            let node = self.graph.node(id);
            for operand in node.op.operands() {
                results[operand.index()] &= self.graph.node(operand).scope != node.scope;
            }
        }
        results
    }
    /// For each node its name, or that of the first named value, result of an equation or output that it is part of.
    pub(crate) fn owners(&self) -> Vec<&str> {
        let results = self.results();
        let mut of_outputs = vec![None; self.graph.len()];
        for output in self.outputs.iter().rev() {
            of_outputs[output.id.index()] = Some(output.name.as_str());
        }
        // From the end, so that users know their names first; the earliest user has the last word.
        let mut owners = vec![""; self.graph.len()];
        for id in self.needed().into_iter().rev() {
            let node = self.graph.node(id);
            let result = node.scope.filter(|_| results[id.index()]).map(|scope| scope.name);
            if let Some(name) = node.name.as_deref().or(result).or(of_outputs[id.index()]) {
                owners[id.index()] = name;
            }
            let owner = owners[id.index()];
            node.op.operands().for_each(|operand| owners[operand.index()] = owner);
        }
        owners
    }
}
