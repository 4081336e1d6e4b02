//! Whether an engine computes what the equations say of gas with dust.

use super::sets::{self, Difficulty};
use super::{Summary, check_set};
use crate::engine::{Engine, EngineError};
use crate::particles::{Particle, ParticleError, ParticleSet};
use crate::passes::Physics;
use crate::scenes::sod::Sod;
use crate::schemes::{CommonPoint, Dissipation, Drag, DragReconstruction, DragSigns, SlopeLimiter, Viscosity};
use etalon_kernels_gen::Field;
use etalon_kernels_gen::bounded::Roundoff;

/// A drag that is felt beside pressure in sets whose densities and sizes are of order one.
const COEFFICIENT: f64 = 2.0;

/// Every third particle of a set as dust.
pub(super) fn with_dust<const D: usize>(set: &ParticleSet<D>) -> Result<ParticleSet<D>, ParticleError> {
    let dust: Vec<bool> = (0..set.len()).map(|i| i % 3 == 0).collect();
    let cold = |(p, dust): (&Particle<D>, &bool)| match dust {
        true => Particle { internal_energy: 0.0, ..*p },
        false => *p,
    };
    let particles = set.particles().iter().zip(&dust).map(cold).collect();
    ParticleSet::new(*set.domain(), particles)?.with_dust(dust)
}

/// All passes of gas with dust on all difficult sets in `D` dimensions: PL20's recommended drag meets every difficulty, all other forms of it and all
/// dissipation schemes the first ones. `make` builds an engine of precision `P`.
///
/// # Errors
/// [`EngineError`] if the particles or the engine fail. What does not compare is a failure of the [`Summary`].
pub fn check_mixtures<const D: usize, P: Roundoff, E: Engine<D>>(
    mut make: impl FnMut(&ParticleSet<D>, &[Field]) -> Result<E, EngineError>,
) -> Result<Summary, EngineError> {
    let mut summary = Summary::default();
    for (round, physics) in all_physics(D).into_iter().enumerate() {
        let tried = if round == 0 { Difficulty::ALL } else { &Difficulty::ALL[..2] };
        for &difficulty in tried {
            let across = [36, 12, 10][D - 1];
            let set = sets::set::<D>(difficulty, across, &physics, 101 + round as u64);
            let set = set.and_then(|set| with_dust(&set)).map_err(EngineError::from_display)?;
            let place = format!("{D}-D, {difficulty:?}, {}, {:?}", physics.viscosity.dissipation, physics.drag);
            check_set::<D, P, E>(&mut summary, &mut make, &set, physics, difficulty, &place)?;
        }
    }
    Ok(summary)
}

fn all_physics(dimension: usize) -> Vec<Physics> {
    let usual = Physics { drag: Some(Drag::of(COEFFICIENT)), ..Sod::standard(dimension).physics() };
    let with = |drag: Drag| Physics { drag: Some(drag), ..usual };
    let mut all = vec![usual];
    all.push(with(Drag { reconstruction: DragReconstruction::NONE, ..Drag::of(COEFFICIENT) }));
    for (&limiter, &point) in SlopeLimiter::ALL.iter().zip(CommonPoint::ALL[1..].iter().cycle()) {
        let reconstruction = DragReconstruction { point, limiter };
        all.push(with(Drag { reconstruction, ..Drag::of(COEFFICIENT) }));
    }
    all.push(with(Drag { signs: DragSigns::AsPrinted, entropy_fix: true, ..Drag::of(COEFFICIENT) }));
    for dissipation in [Dissipation::Av, Dissipation::AvSwSlr] {
        let viscosity = Viscosity { conduction: Viscosity::CONDUCTION, ..Viscosity::of(dissipation) };
        all.push(Physics { viscosity, ..usual });
    }
    all
}
