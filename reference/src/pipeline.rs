//! Which passes a scene needs, found by following its wanted outputs back to the fields particles start with.

use crate::engine::{Engine, EngineError};
use crate::fields;
use crate::passes::*;
use etalon_kernels_gen::{Field, Footprint, Pass};

/// Something that is done with a pass whose type is known only here.
pub trait PassVisitor<const D: usize> {
    /// What comes of it.
    type Output;
    /// Does it.
    fn visit<P: Pass<D>>(&mut self, pass: &P) -> Self::Output;
}

macro_rules! catalogue {
    ($($(#[$meta:meta])* $name:ident),* $(,)?) => {
        /// One of the passes there are.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum PassKind { $($(#[$meta])* $name),* }

        impl PassKind {
            /// All of them; of two that write the same field, the one that does less comes first.
            pub const ALL: &'static [PassKind] = &[$(PassKind::$name),*];

            /// What it reads and writes.
            pub fn footprint<const D: usize>(self) -> Footprint {
                match self { $(PassKind::$name => Footprint::of_pass::<D, $name>()),* }
            }
            /// Makes the pass for a scene's physics and hands it to the visitor.
            pub fn visit<const D: usize, V: PassVisitor<D>>(self, physics: Physics, visitor: &mut V) -> V::Output {
                match self { $(PassKind::$name => visitor.visit(&$name(physics))),* }
            }
        }
    };
}

catalogue! {
    /// [`VolumeElements`].
    VolumeElements,
    /// [`Density`].
    Density,
    /// [`Gradients`].
    Gradients,
    /// [`VelocityGradients`].
    VelocityGradients,
    /// [`Momentum`].
    Momentum,
    /// [`ReconstructedMomentum`].
    ReconstructedMomentum,
}

/// What particles start with and updates keep.
pub const STATE: &[Field] = &[
    fields::MASS,
    fields::SMOOTHING_LENGTH,
    fields::SETTLED_SMOOTHING_LENGTH,
    fields::VELOCITY,
    fields::INTERNAL_ENERGY,
    fields::MOBILITY,
];

/// The passes of a step, in order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pipeline {
    passes: Vec<PassKind>,
}

impl Pipeline {
    /// The passes that give accelerations, energy rates and time steps under a scene's physics, and no others.
    pub fn of_scene<const D: usize>(physics: &Physics) -> Self {
        // Which of the two last sweeps it is, is the scheme's choice; all else follows from what that one reads.
        let last = match physics.viscosity.dissipation.reconstructs() {
            true => PassKind::ReconstructedMomentum,
            false => PassKind::Momentum,
        };
        Self::leading_to::<D>(last)
    }

    /// A pass, preceded by those that write what it reads, and so on back to the [`STATE`].
    pub fn leading_to<const D: usize>(last: PassKind) -> Self {
        let mut chosen = vec![last];
        loop {
            let written: Vec<Field> = chosen.iter().flat_map(|p| p.footprint::<D>().out).collect();
            let missing = |field: &Field| !STATE.contains(field) && !written.contains(field);
            let wanted: Vec<Field> = chosen.iter().flat_map(|p| reads::<D>(*p)).filter(missing).collect();
            let writers = |field: &Field| {
                let writes = |p: &&PassKind| p.footprint::<D>().out.contains(field);
                PassKind::ALL.iter().filter(writes).copied().collect::<Vec<_>>()
            };
            // A field with a single writer decides first: that pass may bring the other wanted fields along.
            let next = wanted.iter().map(&writers).min_by_key(Vec::len).and_then(|w| w.first().copied());
            match next {
                Some(pass) => chosen.push(pass),
                None => break,
            }
        }
        chosen.sort_by_key(|p| PassKind::ALL.iter().position(|q| q == p));
        Pipeline { passes: chosen }
    }

    /// The passes, in the order they run.
    pub fn passes(&self) -> &[PassKind] {
        &self.passes
    }

    /// Runs them all.
    pub fn run<const D: usize, E: Engine<D>>(&self, engine: &mut E, physics: Physics) -> Result<(), EngineError> {
        struct Run<'e, E>(&'e mut E);
        impl<const D: usize, E: Engine<D>> PassVisitor<D> for Run<'_, E> {
            type Output = Result<(), EngineError>;
            fn visit<P: Pass<D>>(&mut self, pass: &P) -> Self::Output {
                self.0.run_pass(pass)
            }
        }
        self.passes.iter().try_for_each(|pass| pass.visit(physics, &mut Run(engine)))
    }

    /// Every field a particle carries through this pipeline and its time integration, each once.
    pub fn fields<const D: usize>(&self) -> Vec<Field> {
        let mut all = STATE.to_vec();
        let updates = [Footprint::of_update::<D, KickDrift>(), Footprint::of_update::<D, Correct>()];
        for footprint in self.passes.iter().map(|p| p.footprint::<D>()).chain(updates) {
            for field in footprint.own.into_iter().chain(footprint.other).chain(footprint.out) {
                if !all.contains(&field) {
                    all.push(field);
                }
            }
        }
        all
    }
}

fn reads<const D: usize>(pass: PassKind) -> Vec<Field> {
    let footprint = pass.footprint::<D>();
    footprint.own.into_iter().chain(footprint.other).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scheme_gets_the_passes_it_needs_and_no_others() {
        use PassKind::*;
        let plain = Pipeline::leading_to::<3>(PassKind::Momentum);
        assert_eq!(plain.passes(), [VolumeElements, Density, Gradients, Momentum]);
        let reconstructed = Pipeline::leading_to::<3>(PassKind::ReconstructedMomentum);
        assert_eq!(reconstructed.passes(), [VolumeElements, Density, VelocityGradients, ReconstructedMomentum]);
        assert!(!plain.fields::<3>().contains(&fields::STRAIN_RATE));
        assert!(reconstructed.fields::<3>().contains(&fields::STRAIN_RATE));
    }

    #[test]
    fn no_pass_writes_what_it_reads_of_its_neighbours() {
        for pass in PassKind::ALL {
            let footprint = pass.footprint::<3>();
            for field in &footprint.out {
                assert!(!footprint.other.contains(field), "{} writes {} while it reads it", footprint.name, field.name);
            }
        }
    }

    #[test]
    fn every_pass_runs_after_those_that_write_what_it_reads() {
        for &last in PassKind::ALL {
            let mut known: Vec<Field> = STATE.to_vec();
            for pass in Pipeline::leading_to::<2>(last).passes() {
                assert!(reads::<2>(*pass).iter().all(|f| known.contains(f)), "{pass:?} reads too early");
                known.extend(pass.footprint::<2>().out);
            }
        }
    }
}
