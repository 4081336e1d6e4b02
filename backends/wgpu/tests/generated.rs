//! The generated text of every pass and update: valid without a device, and the same as it was.

use etalon_kernels_gen::emit::Header;
use etalon_kernels_gen::trace::{Drawing, Single};
use etalon_kernels_gen::{Pass, Update};
use etalon_reference::passes::{KickDrift, Physics};
use etalon_reference::pipeline::{PassKind, PassVisitor, Pipeline, UpdateVisitor};
use etalon_reference::scenes::sod::Sod;
use etalon_reference::schemes::{
    CommonPoint, Dissipation, Drag, DragReconstruction, GradH, Gradients, Kernel, SlopeLimiter, Viscosity,
    VolumeElement,
};
use etalon_wgpu::{Slots, pass_text, update_text, validate, wgsl};
use std::collections::BTreeSet;

const HEAD: Header<'static> = Header { command: "etalon emit --target wgsl", definition: "reference/src/passes" };

struct Texts {
    slots: Slots,
    made: Vec<(&'static str, String)>,
}

impl<const D: usize> PassVisitor<D> for Texts {
    type Output = ();
    fn visit<P: Pass<D>>(&mut self, pass: &P) {
        let drawing = Drawing::of_pass::<D, P, Single>(pass).unwrap();
        self.made.push((P::NAME, pass_text(&drawing, &self.slots, &HEAD).unwrap()));
    }
}

impl<const D: usize> UpdateVisitor<D> for Texts {
    type Output = ();
    fn visit_update<U: Update<D>>(&mut self, update: &U) {
        let drawing = Drawing::of_update::<D, U, Single>(update).unwrap();
        self.made.push((U::NAME, update_text(&drawing, &self.slots, &HEAD).unwrap()));
    }
}

/// The texts of everything that a step runs, by name.
fn texts<const D: usize>(physics: Physics) -> Vec<(&'static str, String)> {
    let pipeline = Pipeline::of_scene::<D>(&physics);
    let mut texts = Texts { slots: Slots::new(&pipeline.fields::<D>(), D), made: Vec::new() };
    for pass in pipeline.passes() {
        PassKind::visit::<D, _>(*pass, physics, &mut texts);
    }
    for update in pipeline.updates() {
        update.visit::<D, _>(physics, &mut texts);
    }
    texts.made
}

fn physics<const D: usize>(dissipation: Dissipation) -> Physics {
    Physics { viscosity: Viscosity::of(dissipation), ..Sod::standard(D).physics() }
}

fn all_valid<const D: usize>() {
    let usual = physics::<D>(Dissipation::AvSlrB2);
    let schemes = Dissipation::ALL.iter().map(|&dissipation| physics::<D>(dissipation));
    let kernels = Kernel::ALL.iter().map(|&kernel| Physics { kernel, ..usual });
    let conducting = Viscosity { conduction: Viscosity::CONDUCTION, ..usual.viscosity };
    let others = [Physics { grad_h: GradH::Exact, ..usual }, Physics { viscosity: conducting, ..usual }];
    let standard = VolumeElement::Standard;
    let formulations = [
        Physics { gradients: Gradients::Kernel, ..usual },
        Physics { volume_element: standard, grad_h: GradH::Exact, ..usual },
        Physics {
            gradients: Gradients::Kernel,
            volume_element: standard,
            viscosity: Viscosity { conduction: Viscosity::CONDUCTION, ..Viscosity::of(Dissipation::AvSwSlr) },
            ..usual
        },
    ];
    let mut seen = 0;
    for physics in schemes.chain(kernels).chain(others).chain(formulations) {
        for (name, text) in texts::<D>(physics) {
            validate(name, &text).unwrap_or_else(|error| panic!("{D}-D {physics:?}: {error}\n{text}"));
            // WebGPU guarantees eight.
            let bindings = text.matches("var<storage").count();
            assert!(bindings <= 8, "{name} uses {bindings} storage buffers");
            seen += 1;
        }
    }
    // Four passes and two updates; a sweep and an update more with a switch, a sweep more with conduction.
    let switched = Dissipation::ALL.iter().filter(|d| d.switches()).count();
    let usual = 6 * (Dissipation::ALL.len() + Kernel::ALL.len() + 2) + 2 * switched + 1;
    // With standard volumes a sweep less.
    assert_eq!(seen, usual + 6 + (6 - 1) + (6 - 1 + 2 + 1));
}

#[test]
fn every_text_is_valid_in_every_dimension() {
    all_valid::<1>();
    all_valid::<2>();
    all_valid::<3>();
}

/// Every form of drag, and every pass there is for gas with dust. Valid, with no more buffers than there are.
fn all_of_mixtures_valid<const D: usize>() {
    let mut seen = BTreeSet::new();
    let drags = CommonPoint::ALL.iter().flat_map(|&point| {
        SlopeLimiter::ALL.iter().map(move |&limiter| Drag {
            reconstruction: DragReconstruction { point, limiter },
            entropy_fix: limiter == SlopeLimiter::Minmod,
            ..Drag::of(1000.0)
        })
    });
    let usual = physics::<D>(Dissipation::AvSlrB2);
    let with_drags = drags.map(|drag| Physics { drag: Some(drag), ..usual });
    let schemes = Dissipation::ALL.iter().map(|&dissipation| {
        let viscosity = Viscosity { conduction: Viscosity::CONDUCTION, ..Viscosity::of(dissipation) };
        Physics { viscosity, drag: Some(Drag::of(1000.0)), ..usual }
    });
    for physics in with_drags.chain(schemes) {
        seen.extend(Pipeline::of_scene::<D>(&physics).passes().to_vec().into_iter().map(|pass| format!("{pass:?}")));
        for (name, text) in texts::<D>(physics) {
            validate(name, &text).unwrap_or_else(|error| panic!("{D}-D {physics:?}: {error}\n{text}"));
            let bindings = text.matches("var<storage").count();
            assert!(bindings <= 8, "{name} uses {bindings} storage buffers");
        }
    }
    let all = PassKind::ALL.iter().filter(|pass| pass.is_of_mixture()).count();
    assert_eq!(seen.len(), all, "{seen:?}");
}

#[test]
fn every_text_of_a_mixture_is_valid_in_every_dimension() {
    all_of_mixtures_valid::<1>();
    all_of_mixtures_valid::<2>();
    all_of_mixtures_valid::<3>();
}

/// The whole of drag in one dimension, and what a mask around a sweep of the gas looks like.
#[test]
fn gas_with_dust_reads_like_code() {
    let gas = physics::<1>(Dissipation::Av);
    for (name, text) in texts::<1>(Physics { drag: Some(Drag::of(1000.0)), ..gas }) {
        if ["volume_elements", "linear_gradients", "reconstructed_drag_forces"].contains(&name) {
            insta::assert_snapshot!(format!("1d_dust_{name}"), generated(1, &text));
        }
    }
}

#[test]
fn what_a_formulation_does_without_is_not_printed() {
    let usual = physics::<3>(Dissipation::AvSlrB2);
    let printed = |physics, word: &str| texts::<3>(physics).iter().any(|(_, text)| text.contains(word));
    let kernel = Physics { gradients: Gradients::Kernel, ..usual };
    let standard = Physics { volume_element: VolumeElement::Standard, ..usual };
    for (physics, words) in [
        (kernel, &["gradient_matrix", "moment_matrix"][..]),
        (standard, &["volume_estimator", "standard_density:", "crossed"]),
    ] {
        for word in words {
            assert!(printed(usual, word), "{word} is in the usual texts");
            assert!(
                !printed(physics, word),
                "{word} is printed with gradients {} and {}",
                physics.gradients,
                physics.volume_element
            );
        }
    }
}

#[test]
fn the_text_is_the_same_every_time() {
    let physics = physics::<3>(Dissipation::AvSlrB2F);
    assert_eq!(texts::<3>(physics), texts::<3>(physics));
}

/// What follows the part that is written by hand and tested with the other kernels.
fn generated(dimension: usize, text: &str) -> &str {
    text.strip_prefix(&wgsl::pass_prelude(dimension)).unwrap().trim_start()
}

#[test]
fn three_dimensions_with_reconstruction_read_like_code() {
    for (name, text) in texts::<3>(physics::<3>(Dissipation::AvSlrB2)) {
        insta::assert_snapshot!(format!("3d_avslrb2_{name}"), generated(3, &text));
    }
}

#[test]
fn one_dimension_reads_like_code() {
    for (name, text) in texts::<1>(physics::<1>(Dissipation::Av)) {
        insta::assert_snapshot!(format!("1d_av_{name}"), generated(1, &text));
    }
}

#[test]
fn a_sum_that_is_always_zero_has_no_accumulator() {
    // With the exact grad-h form the partition's derivative is not needed.
    let with = texts::<2>(Physics { grad_h: GradH::Corrected, ..physics::<2>(Dissipation::Av) });
    let without = texts::<2>(Physics { grad_h: GradH::Exact, ..physics::<2>(Dissipation::Av) });
    let accumulates = |texts: &[(&str, String)]| {
        let (_, text) = texts.iter().find(|(name, _)| *name == "gradients").unwrap();
        text.contains("sums.partition_derivative = sums.partition_derivative + term.partition_derivative;")
    };
    assert!(accumulates(&with) && !accumulates(&without));
}

#[test]
fn a_missing_field_is_named() {
    let physics = physics::<1>(Dissipation::Av);
    let drawing = Drawing::of_update::<1, _, Single>(&KickDrift(physics)).unwrap();
    let slots = Slots::new(&[etalon_reference::fields::SMOOTHING_LENGTH], 1);
    let message = update_text(&drawing, &slots, &HEAD).unwrap_err().to_string();
    assert!(message.contains("`kick_drift` needs the field `"), "{message}");
    assert!(message.contains("without"), "{message}");
}
