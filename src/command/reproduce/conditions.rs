//! How each scene is run for the comparisons: dimensions, particles, precision, and what the paper has that the scene by itself does not.

use crate::command::choices::Precision;
use crate::command::failure::Failure;
use etalon_reference::scenes::Name;
use etalon_reference::scenes::dustyshock::{DustyShock, GAS};
use etalon_reference::scenes::dustywave::DustyWave;
use etalon_spec::tables::{Scene, Setups, Test};

/// How many particles a run has.
#[derive(Clone, Copy, Debug)]
pub enum Particles {
    /// So many.
    Number {
        /// In the usual dimensions; the scene's own number if none.
        usual: Option<usize>,
        /// The paper's, where GS25 Table 2 does not have it.
        paper: Option<usize>,
    },
    /// Of both species, from the number that the paper gives along the problem, and the dimensions.
    Along(fn(f64, usize) -> f64),
}

/// How a scene is run.
#[derive(Clone, Copy, Debug)]
pub struct Conditions {
    /// The scene.
    pub scene: Name,
    /// In how many dimensions: as few as the flow has.
    pub dimension: usize,
    /// In how many at the paper's resolution.
    pub paper_dimension: usize,
    /// How many particles.
    pub particles: Particles,
    /// In which precision, if none is asked for.
    pub precision: Precision,
    /// When it ends; as the scene by itself if none.
    pub end_time: Option<f64>,
    /// Choices that the paper makes and the scene by itself does not.
    pub set: &'static [(&'static str, &'static str)],
    /// About how many microseconds a unit of a job's weight takes on two cores, measured once: what one scene takes beside another. What a call
    /// learns on its way corrects all together.
    pub cost: f64,
}

/// A flow that has two dimensions and is a thin slice in the paper; the scene's own number of particles.
const PLANE: Conditions = Conditions {
    scene: Name::GreshoChan,
    dimension: 2,
    paper_dimension: 3,
    particles: Particles::Number { usual: None, paper: None },
    precision: Precision::Single,
    end_time: None,
    set: &[],
    cost: 0.1,
};

/// All scenes with published numbers.
pub const CONDITIONS: &[Conditions] = &[
    Conditions { scene: Name::Sod, dimension: 1, cost: 0.5, ..PLANE },
    Conditions { scene: Name::Sedov, cost: 0.6, ..PLANE },
    // 100 across, as the paper's.
    Conditions { particles: Particles::Number { usual: Some(10_000), paper: None }, cost: 0.17, ..PLANE },
    Conditions { scene: Name::KelvinHelmholtz, cost: 0.1, ..PLANE },
    Conditions { scene: Name::RayleighTaylor, cost: 0.07, ..PLANE },
    Conditions {
        scene: Name::WindCloud,
        dimension: 3,
        // The later rate of Table 5 is a slope around t = 5.8.
        end_time: Some(6.3),
        cost: 0.017,
        ..PLANE
    },
    Conditions {
        scene: Name::Turbulence,
        dimension: 3,
        // 22 a side: slopes are taken up to k = 10, which takes 21.
        particles: Particles::Number { usual: Some(10_648), paper: None },
        cost: 0.08,
        ..PLANE
    },
    Conditions {
        scene: Name::Membrane,
        // 200 a side as the blast, of whose box the slice is a tenth (GS25 section 5.2).
        particles: Particles::Number { usual: None, paper: Some(800_000) },
        set: &[("compared_with", "linear")],
        cost: 0.12,
        ..PLANE
    },
    Conditions {
        scene: Name::DustyWave,
        dimension: 1,
        paper_dimension: 1,
        particles: Particles::Along(of_dusty_wave),
        // An amplitude of 1e-6 is a few roundings of a density of one in single precision.
        precision: Precision::Double,
        cost: 0.2,
        ..PLANE
    },
    Conditions {
        scene: Name::DustyShock,
        dimension: 1,
        particles: Particles::Along(of_dusty_tube),
        cost: 1.2,
        ..PLANE
    },
];

/// Of two species, in rows across the wave.
fn of_dusty_wave(along: f64, dimension: usize) -> f64 {
    2.0 * along * across(DustyWave::standard(dimension).rows, dimension)
}

/// The shock is on the thin side: the dense side has so many particles along x that the thin one has as many as in three dimensions. Both sides are equally
/// long; of two species, in rows across the dense side.
fn of_dusty_tube(along: f64, dimension: usize) -> f64 {
    let [dense, thin] = GAS.map(|gas| gas.density);
    let more = (dense / thin).powf(1.0 / dimension as f64 - 1.0 / 3.0);
    2.0 * (1.0 + thin / dense) * along * more * across(DustyShock::standard(dimension).rows, dimension)
}

/// Particles of a plane across x with so many rows.
fn across(rows: usize, dimension: usize) -> f64 {
    (rows as f64).powi(dimension as i32 - 1)
}

impl Conditions {
    /// Those of a scene.
    pub fn of(scene: Name) -> Result<&'static Self, Failure> {
        let found = CONDITIONS.iter().find(|conditions| conditions.scene == scene);
        found.ok_or_else(|| Failure::Broken(format!("{scene}: nothing says how it is run for the comparisons")))
    }

    /// How many particles: `along` the problem if its readings say so, at the paper's resolution or at `size` times the usual one.
    pub fn particles(&self, dimension: usize, along: Option<usize>, paper: bool, size: f64) -> Result<usize, Failure> {
        let usual = match (self.particles, along) {
            (Particles::Along(of), Some(along)) => of(along as f64, dimension).round() as usize,
            (Particles::Along(_), None) => {
                return Err(Failure::Broken(format!("{}: a reading must say how many particles", self.scene)));
            }
            (Particles::Number { paper: own, .. }, _) if paper => match own.or(of_table_2(self.scene)?) {
                Some(number) => number,
                None => self.scene.standard(dimension)?.method().particles,
            },
            (Particles::Number { usual: Some(usual), .. }, _) if dimension == self.dimension => usual,
            _ => self.scene.standard(dimension)?.method().particles,
        };
        Ok(((usual as f64 * size) as usize).max(1))
    }
}

/// GS25's particle number; none where its Table 2 does not have the scene.
fn of_table_2(scene: Name) -> Result<Option<usize>, Failure> {
    let setups = Setups::load().map_err(|error| Failure::Broken(format!("GS25 Table 2: {error}")))?;
    let test = Test::ALL.into_iter().find(|test| Scene::from(*test).as_str() == scene.name());
    Ok(test.map(|test| (setups.get(test).particles_in_millions * 1e6) as usize))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_dusty_tube_at_the_papers_resolution_is_the_papers() {
        for along in [128, 256] {
            let number = Conditions::of(Name::DustyShock).unwrap().particles(3, Some(along), true, 1.0).unwrap();
            // 24 rows by 24, two species, an eighth more right of the interface (PL20 section 3.2).
            assert_eq!(number, 2 * along * 24 * 24 * 9 / 8);
            let tube = DustyShock { particles: along, ..DustyShock::standard(3) }.particles::<3>().unwrap();
            let moving = tube.particles().iter().filter(|p| p.mobile).count();
            // The thin side's lattice is whole columns.
            assert!((moving as f64 / number as f64 - 1.0).abs() < 0.02, "{moving} of {number}");
        }
    }

    #[test]
    fn in_one_dimension_its_thin_side_is_as_fine() {
        let number = Conditions::of(Name::DustyShock).unwrap().particles(1, Some(128), false, 1.0).unwrap();
        let tube = DustyShock { particles: number * 4 / 9, ..DustyShock::standard(1) }.particles::<1>().unwrap();
        let thin = tube.particles().iter().filter(|p| p.mobile && p.position[0] > 0.5).count() / 2;
        // Half as many as on the dense side (PL20 section 3.2), up to one at the end.
        assert!(thin.abs_diff(64) <= 1, "{thin}");
    }

    #[test]
    fn the_membrane_is_as_fine_as_the_blast() {
        let across = |scene| of_table_2(scene).unwrap().map(|number| (number as f64).cbrt().round());
        assert_eq!(across(Name::Sedov), Some(200.0));
        let number = Conditions::of(Name::Membrane).unwrap().particles(3, None, true, 1.0).unwrap();
        assert_eq!(number, 200 * 200 * 20);
    }
}
