//! Which of our measurements stands beside which published number.

use crate::command::sweep::Record;
use etalon_reference::scenes::Name;

/// Where a number is found in what is remembered of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Read {
    /// The mean error of this field against the solution.
    Error(&'static str),
    /// The last value of this quantity.
    Last(&'static str),
    /// Its largest value.
    Largest(&'static str),
    /// How fast it changes around a time.
    Rate {
        /// The quantity.
        of: &'static str,
        /// The time.
        at: f64,
        /// How far around it.
        within: f64,
    },
}

/// How a published quantity is measured here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// Its key in `spec/tables/`.
    pub quantity: &'static str,
    /// What is run.
    pub scene: Name,
    /// Where it is found.
    pub read: Read,
    /// In how many dimensions it is run where the paper's three are not asked for: as few as the flow has.
    pub dimension: usize,
    /// What ours is multiplied with in two dimensions: for a sum over the particles the depth of the paper's box, else one.
    pub depth: f64,
    /// Choices of the scene that the paper makes and the scene by itself does not.
    pub set: &'static [(&'static str, &'static str)],
    /// What a reader of both numbers must know beside the paper's own caveat.
    pub note: &'static str,
}

/// All that can be set beside each other.
pub const READINGS: &[Reading] = &[
    Reading {
        quantity: "shock_tube_velocity_l1",
        scene: Name::Sod,
        read: Read::Error("velocity_x"),
        dimension: 1,
        depth: 1.0,
        set: &[],
        note: "from a sharp start; the printed start cannot reach the printed figures (docs/sod.md)",
    },
    Reading {
        quantity: "sedov_largest_density",
        scene: Name::Sedov,
        read: Read::Largest("maximum_density"),
        dimension: 2,
        depth: 1.0,
        set: &[],
        note: "the largest over the run",
    },
    Reading {
        quantity: "sedov_radial_velocity_l1",
        scene: Name::Sedov,
        read: Read::Last("l1_radial_velocity"),
        dimension: 2,
        depth: 1.0,
        set: &[],
        note: "to the radius of the largest velocity of each run, as the paper measures",
    },
    Reading {
        quantity: "vortex_azimuthal_velocity_l1",
        scene: Name::GreshoChan,
        read: Read::Last("l1_azimuthal_velocity"),
        dimension: 2,
        depth: 1.0,
        set: &[],
        note: "",
    },
    Reading {
        quantity: "kelvin_helmholtz_amplitude",
        scene: Name::KelvinHelmholtz,
        read: Read::Last("amplitude"),
        dimension: 2,
        depth: 1.0,
        set: &[],
        note: "sharp layers, as the paper describes; the converged amplitude of that start is 0.1408, not the 0.1479 of smoothed layers",
    },
    Reading {
        quantity: "rayleigh_taylor_kinetic_energy",
        scene: Name::RayleighTaylor,
        read: Read::Last("kinetic_energy_y"),
        dimension: 2,
        depth: 0.1,
        set: &[],
        note: "of a box 0.1 deep as the paper's; in two dimensions the energy per depth is multiplied by it",
    },
    Reading {
        quantity: "wind_cloud_destruction_rate",
        scene: Name::WindCloud,
        read: Read::Rate { of: "cloud_fraction", at: 5.2, within: 0.5 },
        dimension: 3,
        depth: 1.0,
        set: &[],
        note: "the slope of M/M0 by least squares over t = 4.7 to 5.7, per unit of time, M0 being the mass measured at the start",
    },
    Reading {
        quantity: "membrane_radial_velocity_l1",
        scene: Name::Membrane,
        read: Read::Error("velocity_r"),
        dimension: 2,
        depth: 1.0,
        set: &[("compared_with", "linear")],
        note: "distance from the linear wave, as in the paper; the full equations themselves are 0.0201 away from it (docs/membrane.md)",
    },
];

impl Reading {
    /// Ours, from a run in so many dimensions; none if it did not measure it.
    pub fn of(&self, record: &Record, dimension: usize) -> Option<f64> {
        let found = match self.read {
            Read::Error(field) => record.l1.get(field).copied(),
            Read::Last(name) => record.last(name),
            Read::Largest(name) => record.largest(name),
            Read::Rate { of, at, within } => record.rate(of, at, within),
        };
        found.map(|value| if dimension == 2 { value * self.depth } else { value })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_spec::tables::published;

    /// A name that nothing measures, or that no paper has, would make an empty column.
    #[test]
    fn every_reading_names_what_there_is() {
        let all = published().unwrap();
        for reading in READINGS {
            let theirs: Vec<_> = all.iter().filter(|p| p.quantity == reading.quantity).collect();
            assert!(!theirs.is_empty(), "no paper has {}", reading.quantity);
            assert!(theirs.iter().all(|p| p.scene.as_str() == reading.scene.name()), "{}", reading.quantity);
            for &dimension in reading.scene.dimensions() {
                let problem = reading.scene.standard(dimension).unwrap();
                let (view, quantities) = match dimension {
                    1 => (problem.scene::<1>().view(), problem.scene::<1>().quantities()),
                    2 => (problem.scene::<2>().view(), problem.scene::<2>().quantities()),
                    _ => (problem.scene::<3>().view(), problem.scene::<3>().quantities()),
                };
                let measured = |name: &str| quantities.iter().any(|quantity| quantity.name == name);
                let known = match reading.read {
                    Read::Error(field) => view.velocity() == field,
                    Read::Last(name) | Read::Largest(name) => measured(name),
                    Read::Rate { of, at, within } => measured(of) && at + within <= problem.end_time(),
                };
                assert!(known, "{} in {dimension}-D has no {:?}", reading.scene, reading.read);
            }
        }
    }
}
