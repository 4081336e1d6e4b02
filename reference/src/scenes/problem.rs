//! All problems there are, by name: where a scene file and the command pick one.

use super::scene::Scene;
use super::{
    Method, SceneError, double_blast, dusty, even_gas, gas_tube, gresho_chan, hydrostatic, kelvin_helmholtz, membrane,
    noh, rayleigh_taylor, sedov, sod, static_square, turbulence, wind_cloud,
};
use serde::Serialize;
use serde::de::DeserializeOwned;

/// What every problem is, whatever the dimension.
pub trait Definition: Clone + Serialize + DeserializeOwned + Send + Sync {
    /// For people.
    const TITLE: &'static str;
    /// Paper and section.
    const SOURCE: &'static str;
    /// The dimensions it runs in, the usual one first.
    const DIMENSIONS: &'static [usize];
    /// What a run is compared with.
    const SOLUTION: &'static str;
    /// Whether a driver of known period makes waves in it.
    const DRIVES_WAVES: bool = false;
    /// The paper's choices in one of these dimensions, at a size that the scalar reference runs in a minute or two.
    fn standard(dimension: usize) -> Self;
    /// When the paper looks.
    fn end_time(&self) -> f64;
    /// How it is computed.
    fn method(&self) -> &Method;
    /// The same, to be changed.
    fn method_mut(&mut self) -> &mut Method;
}

macro_rules! problems {
    ($($(#[$meta:meta])* $variant:ident($type:path) = $name:literal,)*) => {
        $crate::choice! {
            /// A problem that can be run.
            Name, "scene" { $($(#[$meta])* $variant = $name,)* }
        }

        /// A problem with all its choices.
        #[derive(Clone, Debug, PartialEq)]
        pub enum Problem { $($(#[$meta])* $variant($type)),* }

        impl Name {
            /// For people.
            pub fn title(self) -> &'static str {
                match self { $(Name::$variant => <$type as Definition>::TITLE),* }
            }
            /// Paper and section.
            pub fn source(self) -> &'static str {
                match self { $(Name::$variant => <$type as Definition>::SOURCE),* }
            }
            /// The dimensions it runs in, the usual one first.
            pub fn dimensions(self) -> &'static [usize] {
                match self { $(Name::$variant => <$type as Definition>::DIMENSIONS),* }
            }
            /// What a run is compared with.
            pub fn solution(self) -> &'static str {
                match self { $(Name::$variant => <$type as Definition>::SOLUTION),* }
            }
            /// Whether a driver of known period makes waves in it.
            pub fn drives_waves(self) -> bool {
                match self { $(Name::$variant => <$type as Definition>::DRIVES_WAVES),* }
            }
            /// The paper's choices in so many dimensions.
            ///
            /// # Errors
            /// [`SceneError::Dimension`] where it does not run in so many.
            pub fn standard(self, dimension: usize) -> Result<Problem, SceneError> {
                let allowed = self.dimensions();
                if !allowed.contains(&dimension) {
                    return Err(SceneError::Dimension { scene: self.name(), given: dimension, allowed });
                }
                Ok(match self { $(Name::$variant => Problem::$variant(<$type as Definition>::standard(dimension))),* })
            }
        }

        impl Problem {
            /// Which it is.
            pub fn name(&self) -> Name {
                match self { $(Problem::$variant(_) => Name::$variant),* }
            }
            /// As a scene in `D` dimensions, which must be one of [`Name::dimensions`].
            pub fn scene<const D: usize>(&self) -> &dyn Scene<D> {
                match self { $(Problem::$variant(problem) => problem),* }
            }
            /// How it is computed.
            pub fn method(&self) -> &Method {
                match self { $(Problem::$variant(problem) => Definition::method(problem)),* }
            }
            /// The same, to be changed.
            pub fn method_mut(&mut self) -> &mut Method {
                match self { $(Problem::$variant(problem) => Definition::method_mut(problem)),* }
            }
            /// When the paper looks.
            pub fn end_time(&self) -> f64 {
                match self { $(Problem::$variant(problem) => Definition::end_time(problem)),* }
            }
            /// The problem of that name, its own choices read by `read`.
            pub fn read<E>(name: Name, read: impl ReadChoices<Error = E>) -> Result<Self, E> {
                Ok(match name { $(Name::$variant => Problem::$variant(read.read::<$type>()?)),* })
            }
            /// Its own choices, by [`Serialize`].
            pub fn choices<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                match self { $(Problem::$variant(problem) => problem.serialize(serializer)),* }
            }
        }
    };
}

/// Reads a problem's choices from somewhere.
pub trait ReadChoices {
    /// Why it cannot.
    type Error;
    /// The choices of a type of problem.
    fn read<P: Definition>(&self) -> Result<P, Self::Error>;
}

problems! {
    /// Sod's shock tube.
    Sod(sod::Sod) = "sod",
    /// The vortex of Gresho and Chan.
    GreshoChan(gresho_chan::GreshoChan) = "gresho-chan",
    /// Noh's implosion.
    Noh(noh::Noh) = "noh",
    /// Sedov's blast.
    Sedov(sedov::Sedov) = "sedov",
    /// The Kelvin-Helmholtz instability.
    KelvinHelmholtz(kelvin_helmholtz::KelvinHelmholtz) = "kelvin-helmholtz",
    /// The Rayleigh-Taylor instability.
    RayleighTaylor(rayleigh_taylor::RayleighTaylor) = "rayleigh-taylor",
    /// A cloud in a wind.
    WindCloud(wind_cloud::WindCloud) = "wind-cloud",
    /// An oscillating cylinder.
    Membrane(membrane::Membrane) = "membrane",
    /// Stirred gas.
    Turbulence(turbulence::Turbulence) = "turbulence",
    /// Two blast waves that collide.
    DoubleBlast(double_blast::DoubleBlast) = "double-blast",
    /// Gas and dust in a box.
    DustyBox(dusty::Dusty<dusty::InABox>) = "dustybox",
    /// A sound wave in gas with dust.
    DustyWave(dusty::Dusty<dusty::InAWave>) = "dustywave",
    /// A shock tube of gas and dust.
    DustyShock(dusty::Dusty<dusty::InATube>) = "dustyshock",
    /// A shock tube of two gases.
    Tube(gas_tube::GasTube<gas_tube::Sonic>) = "tube",
    /// A jump of 10^5 in pressure.
    StrongShock(gas_tube::GasTube<gas_tube::StrongShock>) = "strong-shock",
    /// Gases that fly apart.
    NearVacuum(gas_tube::GasTube<gas_tube::NearVacuum>) = "vacuum",
    /// Even flow at Mach 100.
    ColdFlow(even_gas::EvenGas<even_gas::ColdFlow>) = "cold-flow",
    /// A dense square at rest.
    StaticSquare(static_square::StaticSquare) = "static-square",
    /// Gas at rest in gravity.
    Hydrostatic(hydrostatic::Hydrostatic) = "hydrostatic",
    /// A stretched and jittered lattice.
    NoisyLattice(even_gas::EvenGas<even_gas::NoisyLattice>) = "noisy-lattice",
    /// Many neighbours.
    Pairing(even_gas::EvenGas<even_gas::Pairing>) = "pairing",
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_problem_stands_by_its_word_in_all_its_dimensions() {
        for &name in Name::ALL {
            assert!(!name.dimensions().is_empty());
            for &dimension in name.dimensions() {
                let problem = name.standard(dimension).unwrap();
                assert_eq!(problem.name(), name);
                assert!(problem.end_time() > 0.0 && problem.method().particles > 0, "{name}");
                let checked = match dimension {
                    1 => problem.scene::<1>().check(),
                    2 => problem.scene::<2>().check(),
                    _ => problem.scene::<3>().check(),
                };
                assert!(checked.is_ok(), "{name} in {dimension}-D: {checked:?}");
            }
            for dimension in (1..=3).filter(|d| !name.dimensions().contains(d)) {
                let error = name.standard(dimension).unwrap_err().to_string();
                assert!(error.contains("runs in"), "{error}");
            }
        }
    }
}
