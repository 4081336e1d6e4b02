//! Without drag each species is alone.

use crate::{on, physics, run, together, two_clouds};
use etalon_kernels_gen::components;
use etalon_reference::engine::Engine;
use etalon_reference::fields;
use etalon_reference::particles::ParticleSet;
use etalon_reference::passes::Physics;
use etalon_reference::pipeline::Pipeline;
use etalon_reference::schemes::{Dissipation, Drag, GradH, Rung, Viscosity};

/// Every number of the gas is, to the last bit, what it is without dust: a masked pair adds zero, and the others keep their order. The
/// step alone may be shorter, as signals pass between the two species.
fn gas_is_as_without_dust<const D: usize>(mut physics: Physics, seed: u64) {
    let mixed = two_clouds::<D>(seed);
    let half = mixed.len() / 2;
    let alone = ParticleSet::new(*mixed.domain(), mixed.particles()[..half].to_vec()).unwrap();
    let mut with_dust = run(&mixed, physics);
    physics.drag = None;
    let mut without = run(&alone, physics);
    let mut compared = 0;
    for component in components(&Pipeline::of_scene::<D>(&physics).fields::<D>(), D) {
        let Ok(due) = without.read(component) else { continue };
        if component.field == fields::TIME_STEP {
            continue;
        }
        let found = with_dust.read(component).unwrap();
        assert_eq!(found[..half], due, "{} in {D}-D, {physics:?}", component.name(D));
        compared += 1;
    }
    assert!(compared > 15 + D, "only {compared} components");
}

#[test]
fn without_drag_gas_does_not_see_dust() {
    for &dissipation in Dissipation::ALL {
        for &grad_h in GradH::ALL {
            let viscosity = Viscosity { conduction: 0.1, ..Viscosity::of(dissipation) };
            let physics = Physics { viscosity, grad_h, ..physics(Drag::of(0.0)) };
            gas_is_as_without_dust::<1>(physics, 3);
            gas_is_as_without_dust::<2>(physics, 4);
        }
    }
    gas_is_as_without_dust::<3>(physics(Drag::of(0.0)), 5);
}

/// The same on every rung of C25's ladder.
#[test]
fn without_drag_gas_does_not_see_dust_on_any_rung() {
    for &rung in Rung::ALL {
        for &grad_h in GradH::ALL {
            let physics = Physics { grad_h, ..on(rung, physics(Drag::of(0.0))) };
            gas_is_as_without_dust::<1>(physics, 3);
            gas_is_as_without_dust::<2>(physics, 4);
        }
    }
}

/// The dust's densities are those it would have as the only gas, and nothing moves or heats it.
#[test]
fn without_drag_dust_is_dust() {
    let physics = physics(Drag::of(0.0));
    let mixed = two_clouds::<2>(7);
    let half = mixed.len() / 2;
    let mut with_gas = run(&mixed, physics);
    let alone = together(*mixed.domain(), &mixed.particles()[half..], &[]);
    let mut only = run(&alone, physics);
    for field in [fields::DENSITY, fields::VOLUME, fields::GRAD_H, fields::LINEAR_STRAIN_RATE] {
        for component in components(&[field], 2) {
            assert_eq!(with_gas.read(component).unwrap()[half..], only.read(component).unwrap(), "{}", field.name);
        }
    }
    for component in components(&[fields::ACCELERATION, fields::ENERGY_RATE, fields::PRESSURE], 2) {
        let of_dust = &with_gas.read(component).unwrap()[half..];
        assert!(of_dust.iter().all(|value| *value == 0.0), "{}", component.name(2));
    }
}

/// Gravity does.
#[test]
fn dust_falls() {
    let physics = Physics { gravity: [0.0, -3.0, 0.0], ..physics(Drag::of(0.0)) };
    let mixed = two_clouds::<2>(7);
    let half = mixed.len() / 2;
    let acceleration = run(&mixed, physics).read_all(fields::ACCELERATION).unwrap();
    assert!(acceleration[0][half..].iter().all(|a| *a == 0.0) && acceleration[1][half..].iter().all(|a| *a == -3.0));
}
