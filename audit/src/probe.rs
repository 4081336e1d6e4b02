//! What is asked of an equation: its arguments with symbols, units and domains, its results, and the call.

use crate::domain::Domain;
use crate::number::{Body, Evaluators, Number};
use crate::shaped::Shaped;
use etalon_kernels_gen::trace::{Drawing, Significand, Symbol, TraceError, draw};
use etalon_kernels_gen::{EquationEntry, registered};
use etalon_spec::{EquationId, Unit};
use std::fmt;

/// The name of an argument or result as the formula writes it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Name {
    /// LaTeX, without dollars.
    pub latex: &'static str,
    /// What it is, where the ledger's entry of the equation does not have the symbol.
    pub meaning: Option<&'static str>,
}

/// A symbol that no ledger entry of the equation has, with what it is: `own(r"h_a^{-1}", "inverse smoothing length")`.
#[must_use]
pub const fn own(latex: &'static str, meaning: &'static str) -> Name {
    Name { latex, meaning: Some(meaning) }
}

impl From<&'static str> for Name {
    fn from(latex: &'static str) -> Self {
        Name { latex, meaning: None }
    }
}

/// An argument or a result.
#[derive(Clone, Debug)]
pub struct Quantity {
    /// Its name in the code.
    pub name: &'static str,
    /// Its name in formulas.
    pub symbol: Name,
    /// Its unit, as the ledger writes units. Not parsed yet: see [`Quantity::unit`].
    pub unit_text: &'static str,
    /// What distinguishes its components' names, one each.
    pub suffixes: Vec<String>,
}

impl Quantity {
    /// A quantity of the shape `T`.
    #[must_use]
    pub fn new<T: Shaped<f64>>(name: &'static str, symbol: impl Into<Name>, unit_text: &'static str) -> Self {
        Quantity { name, symbol: symbol.into(), unit_text, suffixes: T::suffixes() }
    }
    /// Its unit.
    ///
    /// # Errors
    /// If the text is not a unit; none of the probes here has that fault, a test sees to it.
    pub fn unit(&self) -> Result<Unit, etalon_spec::UnitError> {
        self.unit_text.parse()
    }
    /// The components' names: `v_x`, `v_y`, or the quantity's own.
    pub fn component_names(&self) -> impl Iterator<Item = String> {
        self.suffixes.iter().map(|suffix| format!("{}{suffix}", self.name))
    }
    /// The components in LaTeX: `v_{x}`, `(v_a)_{x}`, or the quantity's own.
    pub fn component_symbols(&self) -> impl Iterator<Item = String> {
        self.suffixes.iter().map(|suffix| match suffix.strip_prefix('_') {
            Some(axes) if self.symbol.latex.contains(['_', '^', ' ']) => format!("({})_{{{axes}}}", self.symbol.latex),
            Some(axes) => format!("{}_{{{axes}}}", self.symbol.latex),
            None => self.symbol.latex.to_string(),
        })
    }
}

/// An argument with its domain.
#[derive(Clone, Debug)]
pub struct Argument {
    /// Name, symbol, unit.
    pub quantity: Quantity,
    /// What each of its components may be.
    pub domain: Domain,
}

/// The declaration of a probe, as [`probe!`](crate::probe!) writes it.
pub trait Declaration: Body {
    /// The arguments, in the order in which the body reads them.
    fn arguments() -> Vec<Argument>;
    /// The results, in the order in which the body gives them.
    fn results() -> Vec<Quantity>;
    /// Makes legal arguments of independent samples: for arguments that belong together.
    fn arrange(_arguments: &mut [f64]) {}
    /// What [`arrange`](Declaration::arrange) makes of them, in words; nothing if they are independent.
    const ARRANGED: Option<&'static str> = None;
}

/// A way to call an equation. An equation has several if it exists in several dimensions, or makes choices.
#[derive(Clone, Debug)]
pub struct Probe {
    /// The module, and the function in it, as in `dissipation::balsara_limiter`.
    pub module: &'static str,
    /// The function's name.
    pub function: &'static str,
    /// The choice that is made, such as a scheme.
    pub variant: Option<&'static str>,
    /// The dimension, for an equation that has one.
    pub dimension: Option<usize>,
    /// Its arguments.
    pub arguments: Vec<Argument>,
    /// Its results.
    pub results: Vec<Quantity>,
    evaluators: Evaluators,
    arrange: fn(&mut [f64]),
    /// How its arguments depend on one another, in words; then a box of inputs is not one of legal inputs.
    pub arranged: Option<&'static str>,
}

impl Probe {
    /// From a declaration.
    #[must_use]
    pub fn new<B: Declaration>(
        module: &'static str,
        function: &'static str,
        variant: Option<&'static str>,
        dimension: Option<usize>,
    ) -> Self {
        Probe {
            module,
            function,
            variant,
            dimension,
            arguments: B::arguments(),
            results: B::results(),
            evaluators: Evaluators::new::<B>(),
            arrange: B::arrange,
            arranged: B::ARRANGED,
        }
    }

    /// Its name, unlike any other's: `dissipation::linear_coefficient AVSLRB2F`, `kernels::mixed_sinc 3-D`.
    #[must_use]
    pub fn key(&self) -> String {
        let variant = self.variant.map_or(String::new(), |variant| format!(" {variant}"));
        let dimension = self.dimension.map_or(String::new(), |dimension| format!(" {dimension}-D"));
        format!("{}::{}{variant}{dimension}", self.module, self.function)
    }

    /// Module and function, as in `dissipation::linear_coefficient`: what all probes of an equation have in common.
    #[must_use]
    pub fn path(&self) -> String {
        format!("{}::{}", self.module, self.function)
    }

    /// What the equation left in the registry.
    #[must_use]
    pub fn entry(&self) -> Option<&'static EquationEntry> {
        registered().into_iter().find(|entry| self.is_of(entry))
    }
    /// Whether it is a probe of this equation.
    #[must_use]
    pub fn is_of(&self, entry: &EquationEntry) -> bool {
        entry.name == self.function && entry.module_path.rsplit("::").next() == Some(self.module)
    }
    /// The equation's numbers in the ledger; none for a definition without a number.
    #[must_use]
    pub fn ids(&self) -> Vec<EquationId> {
        let ids = self.entry().map_or(&[][..], |entry| entry.ids);
        ids.iter().filter_map(|id| id.parse().ok()).collect()
    }

    /// How many numbers go in.
    #[must_use]
    pub fn inputs(&self) -> usize {
        self.arguments.iter().map(|argument| argument.quantity.suffixes.len()).sum()
    }
    /// The names of the numbers that go in.
    #[must_use]
    pub fn input_names(&self) -> Vec<String> {
        self.arguments.iter().flat_map(|argument| argument.quantity.component_names()).collect()
    }
    /// The same in LaTeX.
    #[must_use]
    pub fn input_symbols(&self) -> Vec<String> {
        self.arguments.iter().flat_map(|argument| argument.quantity.component_symbols()).collect()
    }
    /// The domain of each number that goes in.
    #[must_use]
    pub fn input_domains(&self) -> Vec<&Domain> {
        let of = |argument: &'_ Argument| argument.quantity.suffixes.len();
        self.arguments.iter().flat_map(|argument| std::iter::repeat_n(&argument.domain, of(argument))).collect()
    }
    /// The names of the numbers that come out.
    #[must_use]
    pub fn output_names(&self) -> Vec<String> {
        self.results.iter().flat_map(Quantity::component_names).collect()
    }
    /// The same in LaTeX.
    #[must_use]
    pub fn output_symbols(&self) -> Vec<String> {
        self.results.iter().flat_map(Quantity::component_symbols).collect()
    }

    /// Makes legal inputs of independent samples. Run once on every sample, before it is rounded to a target.
    pub fn arrange(&self, inputs: &mut [f64]) {
        (self.arrange)(inputs);
    }

    /// Runs the equation.
    ///
    /// # Errors
    /// [`WrongCount`] unless there are as many numbers as [`inputs`](Probe::inputs).
    pub fn evaluate<N: Number>(&self, inputs: &[N]) -> Result<Vec<N>, WrongCount> {
        if inputs.len() != self.inputs() {
            return Err(WrongCount { probe: self.key(), expected: self.inputs(), found: inputs.len() });
        }
        Ok(N::of(&self.evaluators)(inputs))
    }

    /// Draws the equation: its expression graph, with inputs and outputs named as here.
    ///
    /// # Errors
    /// [`TraceError`] from inside another drawing, or if two results have one name.
    pub fn draw<P: Significand>(&self) -> Result<Drawing, TraceError>
    where
        Symbol<P>: Number,
    {
        draw::<P>(|pen| {
            let inputs: Vec<_> = self.input_names().iter().map(|name| pen.input(name)).collect();
            let outputs = <Symbol<P> as Number>::of(&self.evaluators)(&inputs);
            for (name, value) in self.output_names().iter().zip(outputs) {
                pen.output(name, value);
            }
        })
    }
}

impl fmt::Display for Probe {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&self.key())
    }
}

/// Not as many numbers as a probe has inputs.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{probe} takes {expected} numbers, not {found}; `Probe::input_names` lists them")]
pub struct WrongCount {
    /// The probe.
    pub probe: String,
    /// How many it takes.
    pub expected: usize,
    /// How many there were.
    pub found: usize,
}
