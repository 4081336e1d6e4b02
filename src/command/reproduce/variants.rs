//! How what a paper compares is chosen here.

use crate::command::arguments::SceneArguments;
use crate::command::failure::Failure;
use etalon_reference::schemes::{CommonPoint, Dissipation, GradH, Rung, SlopeLimiter, Viscosity};
use etalon_spec::tables::{DragScheme, Rung as SpecRung, Variant};
use std::fmt::Display;
use std::str::FromStr;

/// The choices that make a scene the variant of a paper.
///
/// # Errors
/// A name that the reference does not have: then a published number would be left out.
pub fn choices(variant: Variant) -> Result<SceneArguments, Failure> {
    let usual = SceneArguments::default;
    let word = |key: &str, value: &dyn Display| (key.to_string(), toml::Value::String(value.to_string()));
    let rung = |name: &str| Ok::<_, Failure>(word("method.rung", &named::<Rung>(name)?));
    Ok(match variant {
        Variant::Scheme(name) => SceneArguments { scheme: Some(named(name.as_str())?), ..usual() },
        Variant::Membrane(name) => {
            let scheme = named::<Dissipation>(name.as_str())?;
            // The coefficients of Table 8 are not all those of Table 1.
            let own = Viscosity::MEMBRANE.into_iter().find(|viscosity| viscosity.dissipation == scheme);
            let own = own.ok_or_else(|| unknown(name.as_str(), "the schemes of Table 8"))?;
            let alpha = ("method.alpha".to_string(), toml::Value::Float(own.alpha));
            SceneArguments { scheme: Some(scheme), set: vec![alpha], ..usual() }
        }
        Variant::Rung(_) => SceneArguments { set: vec![rung(variant.as_str())?], ..usual() },
        // The paper saw what grad-h does with all its ingredients (C25 appendix B).
        Variant::GradH(_) => SceneArguments {
            set: vec![rung(Variant::Rung(SpecRung::SlopeLimitedReconstruction).as_str())?],
            grad_h: Some(named::<GradH>(variant.as_str())?),
            ..usual()
        },
        Variant::Drag(drag) => {
            let (point, limiter, entropy_fix) = match drag {
                DragScheme::Unreconstructed => (CommonPoint::Particles, SlopeLimiter::Unlimited, false),
                // The raw difference is taken where the reconstructed one has the other sign.
                DragScheme::EntropyFix => (CommonPoint::Barycentre, SlopeLimiter::Unlimited, true),
                _ => (CommonPoint::Barycentre, named(variant.as_str())?, false),
            };
            let entropy_fix = ("entropy_fix".to_string(), toml::Value::Boolean(entropy_fix));
            let set = vec![word("common_point", &point), word("limiter", &limiter), entropy_fix];
            SceneArguments { set, ..usual() }
        }
    })
}

fn named<T: FromStr<Err: Display>>(name: &str) -> Result<T, Failure> {
    name.parse().map_err(|error| unknown(name, error))
}

fn unknown(name: &str, reason: impl Display) -> Failure {
    Failure::Broken(format!("{name}, of the published tables, cannot be chosen: {reason}"))
}

#[cfg(test)]
mod tests {
    use super::super::readings::READINGS;
    use super::*;
    use crate::command::setup::Setup;
    use etalon_spec::tables::published;
    use std::collections::BTreeMap;

    /// What a table names can be run, and no two names of a scene are the same run.
    #[test]
    fn every_published_variant_can_be_chosen() {
        let mut seen: BTreeMap<(String, Variant), String> = BTreeMap::new();
        for published in published().unwrap() {
            let scene = published.scene.as_str().to_string();
            let chosen = choices(published.scheme).unwrap_or_else(|error| panic!("{scene}: {error}"));
            let setup = Setup::new(&SceneArguments { scene: scene.clone(), ..chosen });
            let options = setup.unwrap_or_else(|error| panic!("{scene}, {}: {error}", published.scheme)).options();
            seen.insert((scene, published.scheme), options);
        }
        for ((scene, variant), options) in &seen {
            let family = std::mem::discriminant(variant);
            let same =
                seen.iter().filter(|((s, v), o)| s == scene && std::mem::discriminant(v) == family && *o == options);
            assert_eq!(same.count(), 1, "{scene}: {variant} is chosen as another is: {options}");
        }
        assert!(seen.len() > READINGS.len());
    }

    /// What stands in no reading has a reason that the docs give.
    #[test]
    fn every_published_number_has_a_reading() {
        let without: Vec<&str> = published()
            .unwrap()
            .iter()
            .map(|p| p.quantity.as_str())
            .filter(|quantity| READINGS.iter().all(|reading| reading.quantity != *quantity))
            .collect();
        assert!(without.is_empty(), "{without:?}");
    }
}
