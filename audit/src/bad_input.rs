//! What an equation makes of values that no gas has, on every target, and whether the ledger says so.
//!
//! Into legal inputs one bad value is put at a time. On the reference, NaN must come out wherever the argument *matters*, that is, where
//! another legal value would have changed a result; the exceptions are those that the ledger, or [`Unnumbered`] for definitions without a number,
//! names as caught, and every one of these must be seen. On every other target, and in the drawing, each result must be of the same [`Kind`] as
//! on the reference: a number, infinite, or NaN.

mod trial;
mod unnumbered;

use crate::domain::Domain;
use crate::probe::Probe;
use crate::target::Target;
use etalon_kernels_gen::trace::{Double, Drawing, Single, interpret};
use etalon_spec::{BadInput, BadValue, Caught, Ledger};
use std::collections::BTreeSet;
use std::fmt;
pub use trial::{Trial, trials};
pub use unnumbered::{Unnumbered, of_unnumbered};

/// What a result is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// A finite number.
    Number,
    /// Infinite, of either sign.
    Infinite,
    /// Not a number.
    Nan,
}

impl Kind {
    /// Of a value.
    #[must_use]
    pub fn of(value: f64) -> Self {
        match (value.is_nan(), value.is_infinite()) {
            (true, _) => Kind::Nan,
            (false, true) => Kind::Infinite,
            (false, false) => Kind::Number,
        }
    }
    /// Of several results together: the worst.
    #[must_use]
    pub fn of_all(values: &[f64]) -> Self {
        values.iter().map(|value| Kind::of(*value)).max().unwrap_or(Kind::Number)
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Kind::Number => "a number",
            Kind::Infinite => "infinite",
            Kind::Nan => "NaN",
        })
    }
}

/// What came of one class of bad values in one argument, on the reference.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// The argument's name in the code.
    pub argument: &'static str,
    /// Its symbol, as the probe declares it.
    pub symbol: &'static str,
    /// Which values.
    pub value: BadValue,
    /// What came out where the argument matters.
    pub kinds: BTreeSet<Kind>,
    /// The first inputs for which NaN went in and a number came out.
    pub hidden: Option<Vec<f64>>,
}

/// A fault in how an equation treats bad input.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BadInputFault {
    /// NaN went in, a number came out, and nothing says so.
    #[error(
        "{probe}: NaN in {argument} gives a number at {inputs:?}; let it come out, or say under `caught` of {of} why not"
    )]
    Hidden {
        /// The probe.
        probe: String,
        /// The argument.
        argument: &'static str,
        /// The ledger's entry, or the table of definitions without a number.
        of: String,
        /// The inputs.
        inputs: Vec<f64>,
    },
    /// Something is said to be caught that is not.
    #[error(
        "{of}: `{symbol}` {value} is said to be caught, but no call of its functions gives a number for it; remove it"
    )]
    NotCaught {
        /// The ledger's entry, or the function.
        of: String,
        /// The argument's symbol.
        symbol: String,
        /// The values.
        value: BadValue,
    },
    /// An encoded equation whose entry is silent.
    #[error("{of}: the entry does not say what its code does with bad input; add `bad_input`")]
    Silent {
        /// The ledger's entry.
        of: String,
    },
    /// Another target gives another kind of result.
    #[error("{probe} on {target}: {output} is {found} where the reference has {expected}, at {inputs:?}")]
    Differs {
        /// The probe.
        probe: String,
        /// The target.
        target: &'static str,
        /// The result.
        output: String,
        /// What it is.
        found: Kind,
        /// What it should be.
        expected: Kind,
        /// The inputs.
        inputs: Vec<f64>,
    },
}

/// What comes of bad values on the reference: for each argument and class that is not legal there.
#[must_use]
pub fn outcomes(probe: &Probe) -> Vec<Outcome> {
    let mut outcomes: Vec<Outcome> = Vec::new();
    for trial in trials(probe).iter().filter(|trial| trial.matters) {
        let kind = Kind::of_all(&Target::ScalarDouble.run(probe, &trial.inputs));
        let argument = &probe.arguments[trial.argument].quantity;
        let is_of = |outcome: &&mut Outcome| outcome.argument == argument.name && outcome.value == trial.value;
        let hidden = (trial.value == BadValue::Nan && kind != Kind::Nan).then(|| trial.inputs.clone());
        match outcomes.iter_mut().find(is_of) {
            Some(outcome) => {
                outcome.kinds.insert(kind);
                outcome.hidden = outcome.hidden.take().or(hidden);
            }
            None => outcomes.push(Outcome {
                argument: argument.name,
                symbol: argument.symbol.latex,
                value: trial.value,
                kinds: BTreeSet::from([kind]),
                hidden,
            }),
        }
    }
    outcomes
}

/// Where a target, or the drawing, gives another kind of result than the reference: the first place for each.
///
/// With NaN in it, all must agree. With other bad values a target is held against the scalar reference *of its own precision*: where one range ends,
/// and whether infinity meets a difference that has cancelled to nothing, depends on the digits. Lanes, which round a multiply-add once, may for that
/// reason have infinity for NaN, but a number only where the reference has one.
#[must_use]
pub fn differences(probe: &Probe) -> Vec<BadInputFault> {
    let (Ok(single), Ok(double)) = (probe.draw::<Single>(), probe.draw::<Double>()) else {
        return Vec::new(); // the check of units reports it
    };
    let drawn = [
        (Target::ScalarSingle, "the drawing for f32", single.clone()),
        (Target::ScalarSingle, "the simplified drawing for f32", single.simplified()),
        (Target::ScalarDouble, "the drawing for f64", double.clone()),
        (Target::ScalarDouble, "the simplified drawing for f64", double.simplified()),
    ];
    let outputs = probe.output_names();
    let mut faults: Vec<BadInputFault> = Vec::new();
    for trial in trials(probe) {
        let inputs: Vec<f64> = trial.inputs.iter().map(|x| Target::ScalarSingle.round(*x)).collect();
        let results = Target::HERE.map(|target| target.run(probe, &inputs));
        let [single, double, fused_single, fused_double] = &results;
        let (drawn_single, drawn_double): (Vec<_>, Vec<_>) = drawn
            .iter()
            .map(|(of, name, drawing)| (*of, *name, evaluated(drawing, &inputs, *of)))
            .partition(|(of, ..)| *of == Target::ScalarSingle);
        let is_nan = trial.value == BadValue::Nan;
        let mut hold = |name: &'static str, found: &[f64], expected: &[f64], exactly: bool| {
            let differ = |(found, expected): (&f64, &f64)| {
                let (found, expected) = (Kind::of(*found), Kind::of(*expected));
                if exactly { found != expected } else { (found == Kind::Number) != (expected == Kind::Number) }
            };
            let is_known =
                |fault: &BadInputFault| matches!(fault, BadInputFault::Differs { target, .. } if *target == name);
            let Some(place) = found.iter().zip(expected).position(differ) else { return };
            if !faults.iter().any(is_known) {
                faults.push(BadInputFault::Differs {
                    probe: probe.key(),
                    target: name,
                    output: outputs[place].clone(),
                    found: Kind::of(found[place]),
                    expected: Kind::of(expected[place]),
                    inputs: inputs.clone(),
                });
            }
        };
        if is_nan {
            hold(Target::ScalarSingle.name(), single, double, true);
        }
        hold(Target::LanesSingle.name(), fused_single, single, is_nan);
        hold(Target::LanesDouble.name(), fused_double, double, is_nan);
        // What cannot matter is simplified away: nothing times zero.
        let is_held = |name: &str| trial.matters || !name.contains("simplified");
        for (_, name, found) in drawn_single.iter().filter(|(_, name, _)| is_held(name)) {
            hold(name, found, single, true);
        }
        for (_, name, found) in drawn_double.iter().filter(|(_, name, _)| is_held(name)) {
            hold(name, found, double, true);
        }
    }
    faults
}

/// A drawing's outputs, in the arithmetic of the target.
fn evaluated(drawing: &Drawing, inputs: &[f64], target: Target) -> Vec<f64> {
    if target == Target::ScalarSingle {
        let inputs: Vec<f32> = inputs.iter().map(|x| *x as f32).collect();
        return interpret(drawing, &inputs).unwrap_or_default().into_iter().map(f64::from).collect();
    }
    interpret(drawing, inputs).unwrap_or_default()
}

/// What is said to be caught, and where it is said.
struct Said {
    of: String,
    caught: Vec<Caught>,
    silent: bool,
}

/// What the ledger says of a probe's equation, entry by entry; of one without a number, what [`Unnumbered`] says.
fn said(ledger: &Ledger, probe: &Probe) -> Vec<Said> {
    let ids = probe.ids();
    if ids.is_empty() {
        let caught = of_unnumbered(&probe.path());
        return vec![Said { of: probe.path(), caught, silent: false }];
    }
    let entry = |id| {
        let entry = ledger.get(id);
        Said { of: id.to_string(), caught: entry.caught.clone(), silent: entry.bad_input.is_none() }
    };
    ids.into_iter().map(entry).collect()
}

/// What does not fit between what is said and what a probe does with NaN.
#[must_use]
pub fn unsaid(ledger: &Ledger, probe: &Probe) -> Vec<BadInputFault> {
    let outcomes = outcomes(probe);
    let mut faults = Vec::new();
    for said in said(ledger, probe) {
        if said.silent {
            faults.push(BadInputFault::Silent { of: said.of.clone() });
        }
        for outcome in &outcomes {
            let names = |caught: &Caught| caught.of == outcome.symbol && caught.values.contains(&BadValue::Nan);
            if let Some(inputs) = outcome.hidden.clone().filter(|_| !said.caught.iter().any(names)) {
                let (probe, argument) = (probe.key(), outcome.argument);
                faults.push(BadInputFault::Hidden { probe, argument, of: said.of.clone(), inputs });
            }
        }
    }
    faults
}

/// What is said to be guarded although none of these probes, all that there are, gives a number for it. What is *refused* is refused by a function over
/// lists, which no probe calls.
#[must_use]
pub fn not_caught(ledger: &Ledger, probes: &[Probe]) -> Vec<BadInputFault> {
    let mut seen: BTreeSet<(String, &str, BadValue)> = BTreeSet::new();
    for probe in probes {
        let of: Vec<String> = said(ledger, probe).into_iter().map(|said| said.of).collect();
        for outcome in outcomes(probe).into_iter().filter(|outcome| outcome.kinds.contains(&Kind::Number)) {
            seen.extend(of.iter().map(|of| (of.clone(), outcome.symbol, outcome.value)));
        }
    }
    let guarded = ledger.entries().filter(|entry| entry.bad_input == Some(BadInput::Guards));
    let of_ledger = guarded.map(|entry| (entry.id.to_string(), entry.caught.clone()));
    let of_others = Unnumbered::ALL.iter().map(|of| (of.path.to_string(), of_unnumbered(of.path)));
    let mut faults = Vec::new();
    for (of, caught) in of_ledger.chain(of_others) {
        for Caught { of: symbol, values, .. } in caught {
            for value in values {
                let is_seen = seen.contains(&(of.clone(), symbol.as_str(), value));
                let fault = BadInputFault::NotCaught { of: of.clone(), symbol: symbol.clone(), value };
                if !is_seen && !faults.contains(&fault) {
                    faults.push(fault);
                }
            }
        }
    }
    faults
}

/// Whether a class of values is bad for a domain.
fn is_bad(value: BadValue, domain: &Domain, arranged: bool) -> bool {
    let (least, _) = domain.hull();
    match value {
        BadValue::Nan | BadValue::Infinite => true,
        // What belongs together is not made of independent values: a matrix of zeros is no legal one though each may be.
        BadValue::Zero => least > 0.0 || arranged,
        BadValue::Negative => least >= 0.0 || arranged,
        BadValue::Empty => false,
    }
}
