//! How a scene is computed: what is a choice of the method and not of the problem.

use super::{Arrangement, SceneError};
use crate::equations::reconstruction::smoothing_length_holding;
use crate::passes::Physics;
use crate::schemes::{Dissipation, GradH, Gradients, Kernel, Rung, Viscosity, VolumeElement};

/// The choices that every scene has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Method {
    /// About how many particles; those of fixed layers and walls are not counted.
    pub particles: usize,
    /// How they start.
    pub arrangement: Arrangement,
    /// The kernel.
    pub kernel: Kernel,
    /// The number of neighbours, the particle included.
    pub neighbours: f64,
    /// The dissipation scheme and its coefficients, conduction included.
    pub viscosity: Viscosity,
    /// How derivatives are estimated.
    pub gradients: Gradients,
    /// Which volume a particle stands for.
    pub volume_element: VolumeElement,
    /// The grad-h form.
    pub grad_h: GradH,
}

impl Method {
    /// So many particles on a lattice, all else as in GS25: the mixed kernel, AVSLRB2, about 100 neighbours in three dimensions.
    pub fn standard(dimension: usize, particles: usize) -> Self {
        Method {
            particles,
            arrangement: Arrangement::Lattice,
            kernel: Kernel::MixedSinc,
            neighbours: Self::usual_neighbours(dimension, Kernel::MixedSinc),
            viscosity: Viscosity::of(Dissipation::AvSlrB2),
            gradients: Physics::STANDARD.gradients,
            volume_element: Physics::STANDARD.volume_element,
            grad_h: GradH::Corrected,
        }
    }

    /// The same on a rung of C25's ladder: gradients, volume elements and dissipation scheme are the rung's; the scheme's coefficients are GS25's,
    /// conduction and all else stay.
    pub fn on(self, rung: Rung) -> Self {
        Method {
            gradients: rung.gradients(),
            volume_element: rung.volume_element(),
            viscosity: Viscosity { conduction: self.viscosity.conduction, ..Viscosity::of(rung.dissipation()) },
            ..self
        }
    }

    /// About 100 neighbours in 3-D (GS25), and the same support in spacings in the other dimensions; more for a kernel that reaches farther, so that the
    /// smoothing length is the same.
    pub fn usual_neighbours(dimension: usize, kernel: Kernel) -> f64 {
        let wider = (kernel.support() / Kernel::MixedSinc.support()).powi(dimension as i32);
        [5.8, 26.0, 100.0][dimension - 1] * wider
    }

    /// The physics of all passes for an ideal gas of this adiabatic index.
    pub fn physics(&self, gamma: f64) -> Physics {
        Physics {
            kernel: self.kernel,
            gradients: self.gradients,
            volume_element: self.volume_element,
            grad_h: self.grad_h,
            viscosity: self.viscosity,
            gamma_minus_one: gamma - 1.0,
            neighbours: self.neighbours,
            ..Physics::STANDARD
        }
    }

    /// The smoothing length of particles that each fill so much volume.
    pub fn smoothing_length(&self, dimension: usize, volume: f64) -> f64 {
        smoothing_length_holding(self.neighbours, volume, dimension, self.kernel.support())
    }

    /// The radius of their supports.
    pub fn reach(&self, dimension: usize, volume: f64) -> f64 {
        self.kernel.support() * self.smoothing_length(dimension, volume)
    }

    /// How deep a fixed layer of such particles must be: more than a support and what a particle at its edge moves.
    pub fn wall(&self, smoothing_length: f64) -> f64 {
        WALL.max(2.0 * self.kernel.support()) * smoothing_length
    }

    /// Refuses a particle number that does not fit a scene, naming one that does.
    pub(super) fn check_number(
        &self,
        dimension: usize,
        least: usize,
        fits: impl Fn(usize) -> bool,
    ) -> Result<(), SceneError> {
        let (given, neighbours) = (self.particles, self.neighbours);
        if given >= least && fits(given) {
            return Ok(());
        }
        // Rows are whole: somewhat more particles are not always closer, so each number is tried.
        let mut enough = given.max(least);
        while !fits(enough) {
            enough += 1 + enough / 100;
        }
        Err(SceneError::TooFew { given, dimension, enough, neighbours })
    }

    /// Refuses a neighbour number that no kernel can use, and coefficients that are none.
    pub fn check(&self, dimension: usize) -> Result<(), SceneError> {
        let (least, most) = NEIGHBOURS[dimension - 1];
        if !(least..=most).contains(&self.neighbours) {
            return Err(SceneError::Neighbours { given: self.neighbours, dimension, least, most });
        }
        let Viscosity { alpha, alpha_min, beta, q_fold, floor, wave_period, conduction, .. } = self.viscosity;
        for (name, value, least) in [
            ("alpha", alpha, 0.0),
            ("alpha_min", alpha_min, 0.0),
            ("beta", beta, 0.0),
            ("floor", floor, 0.0),
            ("conduction", conduction, 0.0),
            ("q_fold", q_fold, LEAST_SCALE),
            ("wave_period", wave_period, LEAST_SCALE),
        ] {
            if !(least..=MOST_COEFFICIENT).contains(&value) {
                return Err(SceneError::Choice {
                    name,
                    given: value.to_string(),
                    rule: format!("give a number from {least} to {MOST_COEFFICIENT}"),
                });
            }
        }
        Ok(())
    }
}

/// The least depth of a fixed layer, in smoothing lengths.
const WALL: f64 = 4.0;
/// Neighbour numbers that kernels can use, by dimension: with fewer gradients fail, more do not pay.
pub(super) const NEIGHBOURS: [(f64, f64); 3] = [(4.0, 40.0), (10.0, 150.0), (30.0, 600.0)];
/// Coefficients of order one are meant; ten times as much is no flow to compare anything in.
const MOST_COEFFICIENT: f64 = 10.0;
/// What is divided by must not be zero; a thousandth of what scenes take is none any more.
const LEAST_SCALE: f64 = 1e-5;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wider_kernel_has_the_same_smoothing_length() {
        for dimension in 1..=3 {
            let h = |kernel| {
                let neighbours = Method::usual_neighbours(dimension, kernel);
                Method { kernel, neighbours, ..Method::standard(dimension, 100) }.smoothing_length(dimension, 1e-3)
            };
            let (usual, wide) = (h(Kernel::MixedSinc), h(Kernel::QuinticSpline));
            // A power and a root, a few roundings each.
            assert!((wide / usual - 1.0).abs() < 1e-14, "{dimension}-D: {usual} and {wide}");
        }
    }

    #[test]
    fn each_rung_has_one_ingredient_more() {
        let usual = Method::standard(3, 100);
        let rungs: Vec<_> = Rung::ALL.iter().map(|&rung| usual.on(rung)).collect();
        let ingredients = |m: &Method| {
            let viscosity = m.viscosity.dissipation;
            let has = [
                m.gradients == Gradients::Integral,
                m.volume_element == VolumeElement::Generalised,
                viscosity.switches(),
                viscosity.reconstructs(),
            ];
            has.map(usize::from)
        };
        for (place, rung) in rungs.iter().enumerate() {
            assert_eq!(ingredients(rung), std::array::from_fn(|i| usize::from(i < place)), "{rung:?}");
            assert_eq!(
                Method { grad_h: GradH::Exact, ..*rung },
                Method { grad_h: GradH::Exact, ..usual }.on(Rung::ALL[place])
            );
        }
        let names: Vec<_> = Rung::ALL.iter().map(|rung| rung.name()).collect();
        assert_eq!(names, ["STD", "IA", "GVE", "VAV", "SLR"]);
    }

    #[test]
    fn what_is_no_coefficient_is_refused_by_name() {
        let bad = |change: fn(&mut Method)| {
            let mut method = Method::standard(2, 100);
            change(&mut method);
            method.check(2).unwrap_err().to_string()
        };
        assert!(Method::standard(2, 100).check(2).is_ok());
        assert!(bad(|m| m.neighbours = 3.0).contains("--neighbours 3"));
        assert!(bad(|m| m.neighbours = f64::NAN).contains("--neighbours NaN"));
        assert!(bad(|m| m.viscosity.conduction = -1.0).contains("conduction"));
        assert!(bad(|m| m.viscosity.alpha = f64::INFINITY).contains("alpha"));
        assert!(bad(|m| m.viscosity.q_fold = 0.0).contains("q_fold"));
    }
}
