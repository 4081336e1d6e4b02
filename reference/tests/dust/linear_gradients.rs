//! PL20 (11), (12) as a sweep: each species' own gradient.

use crate::check::{UNIT, assert_close, gamma};
use crate::cloud::Recipe;
use crate::{physics, run, together};
use etalon_reference::engine::Engine;
use etalon_reference::fields;
use etalon_reference::particles::Particle;
use etalon_reference::schemes::Drag;

/// Two linear flows through each other, each given back exactly, however the particles lie.
///
/// Of `sum` and `R` each is off by gamma_n of its terms' sizes for n neighbours, and the inverse magnifies that by the condition of `R`, for
/// which 100 is ample: the clouds are jittered by less than a spacing. Places and velocities are rounded once, in units of a box whose side holds
/// seven spacings or more and thirty in one dimension: differences between neighbours have lost so many times more.
fn linear_flows_are_exact<const D: usize>(seed: u64) {
    let matrices: [[[f64; D]; D]; 2] = std::array::from_fn(|s| {
        std::array::from_fn(|i| std::array::from_fn(|j| ((3 * i + 5 * j + 7 * s) % 11) as f64 - 4.0))
    });
    let cloud = |s: usize| {
        let recipe = Recipe { jitter: 0.4, h_spread: 1.2, ..Recipe::unequal::<D>(seed + s as u64) };
        let set = recipe.particles::<D>(false);
        let domain = *set.domain();
        let flow = |p: &Particle<D>| {
            // Where the grid of places puts it.
            let x: [f64; D] = std::array::from_fn(|j| domain.decode(j, domain.encode(j, p.position[j])));
            let velocity = std::array::from_fn(|i| (0..D).map(|j| matrices[s][i][j] * x[j]).sum());
            Particle { velocity, ..*p }
        };
        (*set.domain(), set.particles().iter().map(flow).collect::<Vec<_>>())
    };
    let ((domain, gas), (_, dust)) = (cloud(0), cloud(1));
    let set = together(domain, &gas, &dust);
    let mut engine = run(&set, physics(Drag::of(1.0)));
    let found = engine.read_all(fields::LINEAR_STRAIN_RATE).unwrap();
    let most = (0..set.len()).map(|a| engine.neighbours().of(a).len()).max().unwrap();
    // Velocities are up to 11 D, gradients up to 7.
    let tolerance = 100.0 * 30.0 * gamma(most + 30, UNIT) * 11.0 * D as f64;
    let mut worst = 0.0_f64;
    for a in 0..set.len() {
        let matrix = matrices[usize::from(a >= gas.len())];
        let pairs = (0..D).flat_map(|i| (i..D).map(move |j| (i, j)));
        for (k, (i, j)) in pairs.enumerate() {
            let due = 0.5 * (matrix[i][j] + matrix[j][i]);
            assert_close(&format!("{D}-D: component {k} of {a}"), found[k][a], due, tolerance);
            worst = worst.max((found[k][a] - due).abs());
        }
    }
    println!("{D}-D: off by {worst:e}, tolerance {tolerance:e}");
}

#[test]
fn each_species_has_its_own_gradient() {
    linear_flows_are_exact::<1>(11);
    linear_flows_are_exact::<2>(13);
    linear_flows_are_exact::<3>(17);
}
