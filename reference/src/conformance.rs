//! Whether an engine computes what the equations say: pass by pass, on sets of particles made to be difficult.
//!
//! Engine and reference get the same inputs, rounded to the engine's precision. The reference computes in `f64` with a running
//! error bound ([`Bounded`]): the tolerance of every single number follows from the operations that led to it. It is proven to
//! first order in the unit roundoff, for arithmetic as good as WGSL promises.

pub mod external;
mod mixtures;
pub mod poison;
pub mod resume;
pub mod runs;
pub mod sets;
mod updates;

pub use mixtures::check_mixtures;
pub use updates::check_updates;

use crate::engine::{Engine, EngineError, PlainEngine};
use crate::particles::ParticleSet;
use crate::passes::Physics;
use crate::pipeline::{PassVisitor, Pipeline};
use crate::scenes::sod::Sod;
use crate::schemes::{Dissipation, GradH, Gradients, Kernel, Viscosity, VolumeElement};
use etalon_kernels_gen::bounded::{Bounded, Roundoff};
use etalon_kernels_gen::{Field, Footprint, Pass, Precision, components};
use sets::Difficulty;
use std::fmt;

/// How one number per particle compares, over all particles.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// The pass.
    pub pass: &'static str,
    /// What it wrote, spelled out.
    pub component: String,
    /// The particle that comes nearest to its bound, or exceeds it most.
    pub particle: usize,
    /// What the engine found there.
    pub found: f64,
    /// What the reference found there.
    pub expected: f64,
    /// The bound there.
    pub bound: f64,
    /// For how many particles there is no finite bound: an ill-posed neighbourhood, whose result need only be finite.
    pub unbounded: usize,
    /// The median over the particles of bound over magnitude: what the bound is worth.
    pub looseness: f64,
    /// How many particles there are.
    pub particles: usize,
}

impl Verdict {
    /// Error over bound where that is largest; infinite for a result that is not finite.
    pub fn ratio(&self) -> f64 {
        let error = (self.found - self.expected).abs();
        if error.is_nan() || !self.found.is_finite() {
            f64::INFINITY
        } else if error == 0.0 {
            0.0
        } else {
            error / self.bound
        }
    }
    /// Whether every particle is within its bound.
    pub fn holds(&self) -> bool {
        self.ratio() <= 1.0
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let error = (self.found - self.expected).abs();
        write!(
            f,
            "{}: {} of particle {} is {:e}, expected {:e}: error {error:.2e}, bound {:.2e}, {:.1} % of it; no bound for {} of {}",
            self.pass,
            self.component,
            self.particle,
            self.found,
            self.expected,
            self.bound,
            100.0 * self.ratio(),
            self.unbounded,
            self.particles,
        )
    }
}

/// Runs each pass of a scene's pipeline by itself on `engine`, which must hold the particles of `set`, and compares.
///
/// `P` is the engine's precision.
pub fn check_passes<const D: usize, P: Roundoff, E: Engine<D>>(
    set: &ParticleSet<D>,
    physics: Physics,
    engine: &mut E,
) -> Result<Vec<Verdict>, EngineError> {
    let support = physics.kernel.support();
    let pipeline = Pipeline::of_scene::<D>(&physics);
    let mut reference = PlainEngine::<f64, D>::new(set);
    reference.find_neighbours(support)?;
    pipeline.start(&mut reference, physics)?;
    pipeline.run(&mut reference, physics)?;
    let mut bounded = PlainEngine::<Bounded<P>, D>::new(set);
    bounded.find_neighbours(support)?;
    engine.find_neighbours(support)?;
    let mut check = Check { reference, bounded, engine, verdicts: Vec::new() };
    for pass in pipeline.passes() {
        pass.visit(physics, &mut check)?;
    }
    Ok(check.verdicts)
}

struct Check<'e, P, E, const D: usize> {
    /// Where each pass's inputs come from, whatever the passes before it made of theirs.
    reference: PlainEngine<f64, D>,
    bounded: PlainEngine<Bounded<P>, D>,
    engine: &'e mut E,
    verdicts: Vec<Verdict>,
}

impl<const D: usize, P: Roundoff, E: Engine<D>> PassVisitor<D> for Check<'_, P, E, D> {
    type Output = Result<(), EngineError>;

    fn visit<Q: Pass<D>>(&mut self, pass: &Q) -> Self::Output {
        let footprint = Footprint::of_pass::<D, Q>(pass);
        for component in components(&[footprint.own, footprint.other].concat(), D) {
            let exact = self.reference.read(component)?;
            let rounded: Vec<f64> = exact.into_iter().map(to_precision::<P>).collect();
            self.bounded.write(component, &rounded)?;
            self.engine.write(component, &rounded)?;
        }
        self.bounded.run_pass(pass)?;
        self.engine.run_pass(pass)?;
        for component in components(&footprint.out, D) {
            let found = self.engine.read(component)?;
            let expected = self.bounded.column(component).unwrap_or(&[]);
            self.verdicts.push(verdict::<P>(Q::NAME, component.name(D), &found, expected));
        }
        Ok(())
    }
}

fn to_precision<P: Roundoff>(value: f64) -> f64 {
    match P::PRECISION {
        Precision::Single => f64::from(value as f32),
        Precision::Double | Precision::Extended => value,
    }
}

/// The reference itself rounds in `f64`; where that is the engine's precision too, errors of both count.
fn sides_that_round<P: Roundoff>() -> f64 {
    match P::PRECISION {
        Precision::Single => 1.0,
        Precision::Double | Precision::Extended => 2.0,
    }
}

fn verdict<P: Roundoff>(pass: &'static str, component: String, found: &[f64], expected: &[Bounded<P>]) -> Verdict {
    let own_share = sides_that_round::<P>();
    let one = |particle: usize| Verdict {
        pass,
        component: component.clone(),
        particle,
        found: found[particle],
        expected: expected[particle].value(),
        bound: own_share * expected[particle].error(),
        unbounded: expected.iter().filter(|e| e.error().is_infinite()).count(),
        looseness: own_share * median(expected.iter().map(|e| e.error() / e.value().abs())),
        particles: expected.len(),
    };
    let worst = (0..expected.len())
        .max_by(|&a, &b| one_ratio(found[a], expected[a]).total_cmp(&one_ratio(found[b], expected[b])));
    one(worst.unwrap_or(0))
}

/// The middle one; NaN, which zero over zero makes, counts as nothing.
fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.map(|v| if v.is_nan() { 0.0 } else { v }).collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}

fn one_ratio<P: Roundoff>(found: f64, expected: Bounded<P>) -> f64 {
    let error = (found - expected.value()).abs();
    if !found.is_finite() {
        f64::INFINITY
    } else if error == 0.0 {
        0.0
    } else {
        error / expected.error()
    }
}

/// What a round of [`check_passes`] over all difficulties came to.
#[derive(Clone, Debug, Default)]
pub struct Summary {
    /// Numbers compared.
    pub compared: usize,
    /// The largest ratio of error to bound.
    pub worst: Option<(String, Verdict)>,
    /// The widest bound beside the value it bounds, on sets without difficulty.
    pub loosest: Option<(String, Verdict)>,
    /// What does not hold, each with where it was found.
    pub failures: Vec<String>,
}

/// A bound is worth something only if it is far smaller than what it bounds. On ordinary particles the median over them is at most 5e4 roundings of
/// the value, those of each side that rounds; this leaves another kernel or scheme room.
const LOOSEST: f64 = 1e5;

impl Summary {
    fn add<P: Roundoff>(&mut self, place: &str, dimension: usize, difficulty: Difficulty, verdicts: Vec<Verdict>) {
        for verdict in verdicts {
            self.compared += verdict.particles;
            if !verdict.holds() {
                self.failures.push(format!("{place}: {verdict}"));
            }
            let most = (difficulty.most_unbounded(dimension) * verdict.particles as f64).ceil() as usize;
            if verdict.unbounded > most {
                self.failures.push(format!("{place}: no bound where there should be one: {verdict}"));
            }
            if difficulty == Difficulty::None {
                if verdict.looseness > LOOSEST * sides_that_round::<P>() * P::UNIT {
                    let loose = verdict.looseness;
                    self.failures.push(format!("{place}: a bound of {loose:e} of the value says nothing: {verdict}"));
                }
                if self.loosest.as_ref().is_none_or(|(_, l)| verdict.looseness > l.looseness) {
                    self.loosest = Some((place.to_string(), verdict.clone()));
                }
            }
            if self.worst.as_ref().is_none_or(|(_, w)| verdict.ratio() > w.ratio()) {
                self.worst = Some((place.to_string(), verdict));
            }
        }
    }
}

/// All passes on all difficult sets in `D` dimensions: every dissipation scheme with the paper's kernel, every kernel and every grad-h
/// form with the paper's scheme, conduction, and gradients and volume elements other than the usual ones, each with a scheme that has sweeps
/// of its own. `make` builds an engine of precision `P`.
pub fn check_dimension<const D: usize, P: Roundoff, E: Engine<D>>(
    mut make: impl FnMut(&ParticleSet<D>, &[Field]) -> Result<E, EngineError>,
) -> Result<Summary, EngineError> {
    let mut summary = Summary::default();
    let usual = Sod::standard(D).physics();
    let viscosity = usual.viscosity;
    let with = |viscosity| Physics { viscosity, ..usual };
    let schemes = Dissipation::ALL.iter().map(|&dissipation| with(Viscosity::of(dissipation)));
    // The usual ones are among the schemes.
    let kernels = Kernel::ALL.iter().map(|&kernel| Physics { kernel, ..usual }).filter(|physics| *physics != usual);
    let forms = GradH::ALL.iter().map(|&grad_h| Physics { grad_h, ..usual }).filter(|physics| *physics != usual);
    let conduction = with(Viscosity { conduction: Viscosity::CONDUCTION, ..viscosity });
    let formulation = |gradients, volume_element, dissipation, conduction| Physics {
        gradients,
        volume_element,
        viscosity: Viscosity { conduction, ..Viscosity::of(dissipation) },
        ..usual
    };
    // With the switch and conduction the classic one has every sweep that takes gradients.
    let classic = formulation(Gradients::Kernel, VolumeElement::Standard, Dissipation::AvSwSlr, Viscosity::CONDUCTION);
    let formulations = [
        classic,
        Physics {
            grad_h: GradH::Exact,
            ..formulation(Gradients::Integral, VolumeElement::Standard, Dissipation::Av, 0.0)
        },
        formulation(Gradients::Kernel, VolumeElement::Generalised, Dissipation::AvSlrB2, 0.0),
    ];
    let all = schemes.chain(kernels).chain(forms).chain([conduction]).chain(formulations);
    for (round, physics) in all.enumerate() {
        // The plainest scheme, the usual one, the classic one and conduction, which is a pass of its own, meet every difficulty, the
        // variations only the first ones: what is difficult is the same for all.
        let every = round == 0 || physics == usual || physics == conduction || physics == classic;
        let tried = if every { Difficulty::ALL } else { &Difficulty::ALL[..2] };
        for &difficulty in tried {
            let across = [24, 10, 9][D - 1];
            let set =
                sets::set::<D>(difficulty, across, &physics, 1 + round as u64).map_err(EngineError::from_display)?;
            let place = format!(
                "{D}-D, {difficulty:?}, {}, {}, {}, gradients {}, volume elements {}",
                physics.viscosity.dissipation,
                physics.kernel,
                physics.grad_h,
                physics.gradients,
                physics.volume_element
            );
            check_set::<D, P, E>(&mut summary, &mut make, &set, physics, difficulty, &place)?;
        }
    }
    Ok(summary)
}

/// All passes on one set.
fn check_set<const D: usize, P: Roundoff, E: Engine<D>>(
    summary: &mut Summary,
    make: &mut impl FnMut(&ParticleSet<D>, &[Field]) -> Result<E, EngineError>,
    set: &ParticleSet<D>,
    physics: Physics,
    difficulty: Difficulty,
    place: &str,
) -> Result<(), EngineError> {
    let fields = Pipeline::of_scene::<D>(&physics).fields::<D>();
    let mut engine = make(set, &fields)?;
    let verdicts =
        check_passes::<D, P, E>(set, physics, &mut engine).map_err(|e| EngineError(format!("{place}: {e}")))?;
    summary.add::<P>(place, D, difficulty, verdicts);
    Ok(())
}
