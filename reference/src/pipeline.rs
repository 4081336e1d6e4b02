//! Which passes a scene needs, found by following its wanted outputs back to the fields particles start with.

use crate::engine::{Engine, EngineError};
use crate::fields;
use crate::passes::*;
use crate::schemes::Dissipation;
use etalon_kernels_gen::{Component, Field, Footprint, Pass, Update};

/// Something that is done with a pass whose type is known only here.
pub trait PassVisitor<const D: usize> {
    /// What comes of it.
    type Output;
    /// Does it.
    fn visit<P: Pass<D>>(&mut self, pass: &P) -> Self::Output;
}

macro_rules! catalogue {
    (gas { $($(#[$gas_meta:meta])* $gas:ident,)* }
     mixture { $($(#[$meta:meta])* $name:ident = $first:ident $(of $inner:ident)?,)* }) => {
        /// One of the passes there are.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum PassKind { $($(#[$gas_meta])* $gas,)* $($(#[$meta])* $name,)* }

        impl PassKind {
            /// All of them; of two that write the same field, the one that does less comes first.
            pub const ALL: &'static [PassKind] = &[$(PassKind::$gas,)* $(PassKind::$name,)*];

            /// Whether it is for particles of two species, gas and dust. No pipeline has passes of both kinds.
            pub fn is_of_mixture(self) -> bool {
                match self { $(PassKind::$gas => false,)* $(PassKind::$name => true,)* }
            }
            /// What it reads and writes under a scene's physics.
            pub fn footprint<const D: usize>(self, physics: &Physics) -> Footprint {
                match self {
                    $(PassKind::$gas => Footprint::of_pass::<D, _>(&$gas(*physics)),)*
                    $(PassKind::$name => {
                        let physics = *physics;
                        Footprint::of_pass::<D, _>(&catalogue!(@make physics $first $($inner)?))
                    })*
                }
            }
            /// Makes the pass for a scene's physics and hands it to the visitor.
            pub fn visit<const D: usize, V: PassVisitor<D>>(self, physics: Physics, visitor: &mut V) -> V::Output {
                match self {
                    $(PassKind::$gas => visitor.visit(&$gas(physics)),)*
                    $(PassKind::$name => visitor.visit(&catalogue!(@make physics $first $($inner)?)),)*
                }
            }
        }
    };
    (@make $physics:ident $pass:ident) => { $pass($physics) };
    (@make $physics:ident $mask:ident $pass:ident) => { $mask($pass($physics)) };
}

catalogue! {
    gas {
        /// [`VolumeElements`].
        VolumeElements,
        /// [`Density`].
        Density,
        /// [`Gradients`].
        Gradients,
        /// [`VelocityGradients`].
        VelocityGradients,
        /// [`Switch`].
        Switch,
        /// [`Momentum`].
        Momentum,
        /// [`ReconstructedMomentum`].
        ReconstructedMomentum,
        /// [`SwitchedMomentum`].
        SwitchedMomentum,
        /// [`Conduction`].
        Conduction,
    }
    mixture {
        /// [`VolumeElements`] among each species.
        SpeciesVolumeElements = SameSpecies of VolumeElements,
        /// [`Density`] among each species.
        SpeciesDensity = SameSpecies of Density,
        /// [`Gradients`] among each species.
        SpeciesGradients = SameSpecies of Gradients,
        /// [`VelocityGradients`] among each species.
        SpeciesVelocityGradients = SameSpecies of VelocityGradients,
        /// [`LinearGradients`] among each species.
        SpeciesLinearGradients = SameSpecies of LinearGradients,
        /// [`Switch`] among the gas.
        GasSwitch = GasOnly of Switch,
        /// [`Momentum`] among the gas.
        GasMomentum = GasOnly of Momentum,
        /// [`ReconstructedMomentum`] among the gas.
        GasReconstructedMomentum = GasOnly of ReconstructedMomentum,
        /// [`SwitchedMomentum`] among the gas.
        GasSwitchedMomentum = GasOnly of SwitchedMomentum,
        /// [`Conduction`] among the gas.
        GasConduction = GasOnly of Conduction,
        /// [`DragForces`].
        DragForces = DragForces,
        /// [`ReconstructedDragForces`].
        ReconstructedDragForces = ReconstructedDragForces,
    }
}

/// Something that is done with an update whose type is known only here.
pub trait UpdateVisitor<const D: usize> {
    /// What comes of it.
    type Output;
    /// Does it.
    fn visit_update<U: Update<D>>(&mut self, update: &U) -> Self::Output;
}

/// One of the updates of particles by themselves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum UpdateKind {
    /// [`KickDrift`].
    KickDrift,
    /// [`Decay`].
    Decay,
    /// [`DriveWall`].
    DriveWall,
    /// [`MoveWall`].
    MoveWall,
    /// [`Push`].
    Push,
    /// [`Correct`].
    Correct,
}

impl UpdateKind {
    /// What it reads and writes.
    pub fn footprint<const D: usize>(self) -> Footprint {
        match self {
            UpdateKind::KickDrift => Footprint::of_update::<D, KickDrift>(),
            UpdateKind::Decay => Footprint::of_update::<D, Decay>(),
            UpdateKind::DriveWall => Footprint::of_update::<D, DriveWall>(),
            UpdateKind::MoveWall => Footprint::of_update::<D, MoveWall>(),
            UpdateKind::Push => Footprint::of_update::<D, Push>(),
            UpdateKind::Correct => Footprint::of_update::<D, Correct>(),
        }
    }
    /// Makes the update for a scene's physics and hands it to the visitor.
    pub fn visit<const D: usize, V: UpdateVisitor<D>>(self, physics: Physics, visitor: &mut V) -> V::Output {
        match self {
            UpdateKind::KickDrift => visitor.visit_update(&KickDrift(physics)),
            UpdateKind::Decay => visitor.visit_update(&Decay(physics)),
            UpdateKind::DriveWall => visitor.visit_update(&DriveWall),
            UpdateKind::MoveWall => visitor.visit_update(&MoveWall),
            UpdateKind::Push => visitor.visit_update(&Push),
            UpdateKind::Correct => visitor.visit_update(&Correct),
        }
    }
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

/// What particles start with or updates keep beside the [`STATE`], for schemes that need it; carried only where a pass reads it.
pub const SCHEME_STATE: &[Field] = &[fields::REMAINING_ALPHA, fields::SPECIES];

/// The passes of a step, in order, and the updates around them.
#[derive(Clone, Debug, PartialEq)]
pub struct Pipeline {
    passes: Vec<PassKind>,
    physics: Physics,
    /// What moves walls.
    driving: &'static [UpdateKind],
    /// What adds to the passes' accelerations.
    pushing: &'static [UpdateKind],
}

impl Pipeline {
    /// The passes that give accelerations, energy rates and time steps under a scene's physics, and no others.
    pub fn of_scene<const D: usize>(physics: &Physics) -> Self {
        // Which of the last sweeps it is, is the scheme's choice; all else follows from what they read.
        let viscosity = &physics.viscosity;
        let mixture = physics.drag.is_some();
        let forces = match (viscosity.dissipation, mixture) {
            (scheme, false) if scheme.switches() => PassKind::SwitchedMomentum,
            (scheme, true) if scheme.switches() => PassKind::GasSwitchedMomentum,
            (Dissipation::Av, false) => PassKind::Momentum,
            (Dissipation::Av, true) => PassKind::GasMomentum,
            (_, false) => PassKind::ReconstructedMomentum,
            (_, true) => PassKind::GasReconstructedMomentum,
        };
        let mut last = vec![forces];
        if viscosity.conduction > 0.0 {
            last.push(if mixture { PassKind::GasConduction } else { PassKind::Conduction });
        }
        if let Some(drag) = physics.drag {
            last.push(if drag.reconstructs() { PassKind::ReconstructedDragForces } else { PassKind::DragForces });
        }
        let driving: &[UpdateKind] = match physics.driver {
            None => &[],
            Some(Driver { moves: false, .. }) => &[UpdateKind::DriveWall],
            Some(Driver { moves: true, .. }) => &[UpdateKind::DriveWall, UpdateKind::MoveWall],
        };
        let pushing: &[UpdateKind] = if physics.forced { &[UpdateKind::Push] } else { &[] };
        Pipeline { driving, pushing, ..Self::leading_to_all::<D>(last, physics) }
    }

    /// The passes that give densities and what the smoothing length's update asks for besides.
    pub fn of_smoothing_lengths<const D: usize>(physics: &Physics) -> Self {
        let last = match physics.drag {
            Some(_) => PassKind::SpeciesGradients,
            None => PassKind::Gradients,
        };
        Self::leading_to::<D>(last, physics)
    }

    /// A pass, preceded by those that write what it reads, and so on back to the [`STATE`].
    pub fn leading_to<const D: usize>(last: PassKind, physics: &Physics) -> Self {
        Self::leading_to_all::<D>(vec![last], physics)
    }

    fn leading_to_all<const D: usize>(mut chosen: Vec<PassKind>, physics: &Physics) -> Self {
        let mixture = chosen.iter().any(|pass| pass.is_of_mixture());
        loop {
            // What a pass changes of its own it must have from another.
            let written = |by_other_than: &PassKind, field: &Field| {
                chosen.iter().any(|p| p != by_other_than && p.footprint::<D>(physics).out.contains(field))
            };
            let missing = |reader: &PassKind| {
                let given = |field: &Field| STATE.contains(field) || SCHEME_STATE.contains(field);
                let mut wanted = reads::<D>(*reader, physics);
                wanted.retain(|field| !given(field) && !written(reader, field));
                wanted
            };
            let writers = |field: Field| {
                let fits = |p: &&PassKind| p.is_of_mixture() == mixture && !chosen.contains(p);
                let writes = |p: &&PassKind| p.footprint::<D>(physics).out.contains(&field);
                PassKind::ALL.iter().filter(fits).filter(writes).copied().collect::<Vec<_>>()
            };
            // A field with a single writer decides first: that pass may bring the other wanted fields along.
            let wanted = chosen.iter().flat_map(missing);
            let next = wanted.map(writers).min_by_key(Vec::len).and_then(|w| w.first().copied());
            match next {
                Some(pass) => chosen.push(pass),
                None => break,
            }
        }
        chosen.sort_by_key(|p| PassKind::ALL.iter().position(|q| q == p));
        Pipeline { passes: chosen, physics: *physics, driving: &[], pushing: &[] }
    }

    /// What the passes read and write, in the order they run.
    pub fn footprints<const D: usize>(&self) -> Vec<Footprint> {
        self.passes.iter().map(|pass| pass.footprint::<D>(&self.physics)).collect()
    }

    /// The passes, in the order they run.
    pub fn passes(&self) -> &[PassKind] {
        &self.passes
    }

    /// Whether particles carry a viscosity coefficient that decays between steps.
    pub fn switches(&self) -> bool {
        self.passes.iter().any(|pass| matches!(pass, PassKind::Switch | PassKind::GasSwitch))
    }

    /// The updates that open a step, before particles move and the passes run, in order.
    pub fn opening(&self) -> &'static [UpdateKind] {
        if self.switches() { &[UpdateKind::KickDrift, UpdateKind::Decay] } else { &[UpdateKind::KickDrift] }
    }

    /// The updates that drive walls, after the opening ones; [`DriveWall`] before the first passes too.
    pub fn driving(&self) -> &'static [UpdateKind] {
        self.driving
    }

    /// The updates that belong to the passes and run right after them.
    pub fn pushing(&self) -> &'static [UpdateKind] {
        self.pushing
    }

    /// The updates that close it, after the passes.
    pub fn closing(&self) -> &'static [UpdateKind] {
        &[UpdateKind::Correct]
    }

    /// All updates of a step, in order.
    pub fn updates(&self) -> impl Iterator<Item = UpdateKind> {
        [self.opening(), self.driving, self.pushing, self.closing()].into_iter().flatten().copied()
    }

    /// Gives particles what schemes and walls keep beside the [`STATE`]: to be called once, before the first run. A driven wall starts with
    /// the largest velocity it will have.
    pub fn start<const D: usize, E: Engine<D>>(&self, engine: &mut E, physics: Physics) -> Result<(), EngineError> {
        if self.switches() {
            let smallest = vec![physics.viscosity.alpha_min; engine.particle_count()];
            engine.write(Component { field: fields::REMAINING_ALPHA, index: 0 }, &smallest)?;
        }
        for index in 0..D {
            if physics.driver.is_some() {
                let velocity = engine.read(Component { field: fields::VELOCITY, index })?;
                engine.write(Component { field: fields::DRIVE_VELOCITY, index }, &velocity)?;
            }
            if physics.forced {
                let zeros = vec![0.0; engine.particle_count()];
                engine.write(Component { field: fields::FORCING, index }, &zeros)?;
            }
        }
        Ok(())
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

    /// The fields that a step reads before it writes them: what has to outlast a step, beside the coordinates. A run can go on from these.
    pub fn carried<const D: usize>(&self) -> Vec<Field> {
        let (mut carried, mut written) = (Vec::new(), Vec::new());
        let opening = self.opening().iter().chain(self.driving).map(|u| u.footprint::<D>());
        let closing = self.pushing.iter().chain(self.closing()).map(|u| u.footprint::<D>());
        for footprint in opening.chain(self.footprints::<D>()).chain(closing) {
            for field in footprint.own.into_iter().chain(footprint.other) {
                if !written.contains(&field) && !carried.contains(&field) {
                    carried.push(field);
                }
            }
            written.extend(footprint.out);
        }
        carried
    }

    /// Every field a particle carries through this pipeline and its time integration, each once.
    pub fn fields<const D: usize>(&self) -> Vec<Field> {
        let mut all = STATE.to_vec();
        let updates = self.updates().map(|u| u.footprint::<D>());
        for footprint in self.footprints::<D>().into_iter().chain(updates) {
            for field in footprint.own.into_iter().chain(footprint.other).chain(footprint.out) {
                if !all.contains(&field) {
                    all.push(field);
                }
            }
        }
        all
    }
}

fn reads<const D: usize>(pass: PassKind, physics: &Physics) -> Vec<Field> {
    let footprint = pass.footprint::<D>(physics);
    footprint.own.into_iter().chain(footprint.other).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::schemes::{GradH, Viscosity, VolumeElement};
    use etalon_kernels_gen::components;

    #[test]
    fn a_scheme_gets_the_passes_it_needs_and_no_others() {
        use PassKind::*;
        let plain = Pipeline::leading_to::<3>(PassKind::Momentum, &Physics::STANDARD);
        assert_eq!(plain.passes(), [VolumeElements, Density, Gradients, Momentum]);
        let reconstructed = Pipeline::leading_to::<3>(PassKind::ReconstructedMomentum, &Physics::STANDARD);
        assert_eq!(reconstructed.passes(), [VolumeElements, Density, VelocityGradients, ReconstructedMomentum]);
        assert!(!plain.fields::<3>().contains(&fields::STRAIN_RATE));
        assert!(reconstructed.fields::<3>().contains(&fields::STRAIN_RATE));
    }

    /// Every way to take gradients with every volume element and grad-h form.
    fn formulations() -> Vec<Physics> {
        let mut all = Vec::new();
        for &gradients in crate::schemes::Gradients::ALL {
            for &volume_element in VolumeElement::ALL {
                for &grad_h in GradH::ALL {
                    all.push(Physics { gradients, volume_element, grad_h, ..Physics::STANDARD });
                }
            }
        }
        all
    }

    #[test]
    fn what_a_formulation_does_without_nothing_carries() {
        use PassKind::*;
        let usual = Physics { viscosity: Viscosity::of(Dissipation::Av), ..Physics::STANDARD };
        let standard = Physics { volume_element: VolumeElement::Standard, ..usual };
        let classic = Physics { gradients: crate::schemes::Gradients::Kernel, ..standard };
        let fields = |physics: &Physics| Pipeline::of_scene::<3>(physics).fields::<3>();
        assert_eq!(Pipeline::of_scene::<3>(&usual).passes(), [VolumeElements, Density, Gradients, Momentum]);
        // The plain density is the density: no sweep before it.
        for physics in [standard, classic] {
            assert_eq!(Pipeline::of_scene::<3>(&physics).passes(), [Density, Gradients, Momentum]);
        }
        let gone = |from: &Physics, to: &Physics| {
            let kept = fields(to);
            assert!(kept.iter().all(|field| fields(from).contains(field)));
            fields(from).into_iter().filter(|field| !kept.contains(field)).collect::<Vec<_>>()
        };
        let of_volumes = [
            fields::STANDARD_DENSITY,
            fields::VOLUME_ESTIMATOR,
            fields::KERNEL_NORMALISATION,
            fields::VOLUME_ESTIMATOR_DERIVATIVE,
        ];
        let gone_with_volumes = gone(&usual, &standard);
        assert_eq!(gone_with_volumes.len(), 4);
        assert!(of_volumes.iter().all(|field| gone_with_volumes.contains(field)));
        assert_eq!(gone(&standard, &classic), [fields::GRADIENT_MATRIX]);
        // Sums are counted by pass: the matrix's moments are not summed, nor X's derivative.
        let sums = |pass: PassKind, physics: &Physics| components(&pass.footprint::<3>(physics).sums, 3).len();
        assert_eq!((sums(Gradients, &usual), sums(Gradients, &standard), sums(Gradients, &classic)), (7, 7, 1));
        assert_eq!((sums(Density, &usual), sums(Density, &standard)), (3, 2));
        assert_eq!((sums(VelocityGradients, &usual), sums(VelocityGradients, &classic)), (16, 10));
        // Numbers of a neighbour in the last sweep: the plain density and six of the matrix fewer.
        let others = |physics: &Physics| components(&Momentum.footprint::<3>(physics).other, 3).len();
        assert_eq!((others(&usual), others(&standard), others(&classic)), (15, 14, 8));
    }

    #[test]
    fn a_switch_brings_its_own_fields_and_no_other_scheme_has_them() {
        use PassKind::*;
        let physics = |dissipation| Physics {
            kernel: crate::schemes::Kernel::MixedSinc,
            grad_h: crate::schemes::GradH::Corrected,
            viscosity: crate::schemes::Viscosity::of(dissipation),
            gamma_minus_one: 0.4,
            neighbours: 50.0,
            ..Physics::STANDARD
        };
        let own = [fields::ALPHA, fields::LOCAL_ALPHA, fields::REMAINING_ALPHA, fields::ALPHA_DECAY_RATE];
        let numbers = |dissipation| components(&Pipeline::of_scene::<3>(&physics(dissipation)).fields::<3>(), 3).len();
        for &dissipation in Dissipation::ALL {
            let pipeline = Pipeline::of_scene::<3>(&physics(dissipation));
            let carried = own.iter().filter(|f| pipeline.fields::<3>().contains(f)).count();
            assert_eq!(carried, if dissipation.switches() { 4 } else { 0 }, "{dissipation}");
            assert_eq!(pipeline.switches(), dissipation.switches(), "{dissipation}");
        }
        // Beside these four the switch reads what reconstruction has anyway.
        assert_eq!(numbers(Dissipation::AvSwSlr), numbers(Dissipation::AvSlr) + 4);
        assert_eq!(numbers(Dissipation::AvSw), numbers(Dissipation::AvSlr) + 4);
        assert_eq!(numbers(Dissipation::AvB), numbers(Dissipation::AvSlr));
        assert_eq!(numbers(Dissipation::AvSlrBStar2F), numbers(Dissipation::AvSlrB2));
        let switched = Pipeline::of_scene::<3>(&physics(Dissipation::AvSw));
        assert_eq!(switched.passes(), [VolumeElements, Density, VelocityGradients, Switch, SwitchedMomentum]);
    }

    #[test]
    fn conduction_runs_last_and_only_where_it_is_asked_for() {
        use PassKind::*;
        let mut physics = crate::scenes::sod::Sod::standard(3).physics();
        let without = Pipeline::of_scene::<3>(&physics);
        assert!(!without.passes().contains(&Conduction));
        physics.viscosity.conduction = crate::schemes::Viscosity::CONDUCTION;
        let with = Pipeline::of_scene::<3>(&physics);
        assert_eq!(with.passes()[..4], *without.passes());
        assert_eq!(with.passes()[4..], [Conduction]);
        assert_eq!(with.fields::<3>(), without.fields::<3>(), "it carries nothing of its own");
        assert_eq!(
            Pipeline::leading_to::<1>(Conduction, &physics).passes(),
            [VolumeElements, Density, Gradients, Momentum, Conduction]
        );
    }

    #[test]
    fn a_mixture_gets_passes_of_its_own_and_a_gas_none_of_them() {
        use PassKind::*;
        let gas = crate::scenes::sod::Sod::standard(3).physics();
        let with = |reconstruction| {
            let drag = crate::schemes::Drag { reconstruction, ..crate::schemes::Drag::of(1.0) };
            Physics { drag: Some(drag), ..gas }
        };
        let reconstructed = with(crate::schemes::DragReconstruction::RECOMMENDED);
        let plain = with(crate::schemes::DragReconstruction::NONE);
        let forces = [SpeciesVolumeElements, SpeciesDensity, SpeciesVelocityGradients];
        assert_eq!(
            Pipeline::of_scene::<3>(&reconstructed).passes(),
            [&forces[..], &[SpeciesLinearGradients, GasReconstructedMomentum, ReconstructedDragForces]].concat()
        );
        assert_eq!(
            Pipeline::of_scene::<3>(&plain).passes(),
            [&forces[..], &[GasReconstructedMomentum, DragForces]].concat()
        );
        // One number more a particle; six more where velocities are reconstructed for drag.
        let numbers = |physics: &Physics| components(&Pipeline::of_scene::<3>(physics).fields::<3>(), 3).len();
        assert_eq!(numbers(&plain), numbers(&gas) + 1);
        assert_eq!(numbers(&reconstructed), numbers(&gas) + 7);
        for &dissipation in Dissipation::ALL {
            for drag in [None, plain.drag, reconstructed.drag] {
                let mut physics = Physics { drag, ..gas };
                physics.viscosity.dissipation = dissipation;
                physics.viscosity.conduction = 0.1;
                let pipeline = Pipeline::of_scene::<3>(&physics);
                assert!(pipeline.passes().iter().all(|pass| pass.is_of_mixture() == drag.is_some()), "{pipeline:?}");
                assert_eq!(pipeline.fields::<3>().contains(&fields::SPECIES), drag.is_some());
                assert_eq!(pipeline.switches(), dissipation.switches());
            }
        }
    }

    #[test]
    fn no_pass_writes_what_it_reads_of_its_neighbours() {
        for physics in formulations() {
            for pass in PassKind::ALL {
                let footprint = pass.footprint::<3>(&physics);
                for field in &footprint.out {
                    let name = footprint.name;
                    assert!(!footprint.other.contains(field), "{name} writes {} while it reads it", field.name);
                }
            }
        }
    }

    #[test]
    fn every_pass_runs_after_those_that_write_what_it_reads() {
        for physics in formulations() {
            for &last in PassKind::ALL {
                let mut known: Vec<Field> = [STATE, SCHEME_STATE].concat();
                for pass in Pipeline::leading_to::<2>(last, &physics).passes() {
                    assert!(reads::<2>(*pass, &physics).iter().all(|f| known.contains(f)), "{pass:?} reads too early");
                    known.extend(pass.footprint::<2>(&physics).out);
                }
            }
        }
    }
}
