//! Which of our measurements stands beside which published number.

use super::series::{order, second_order_from, within_from};
use crate::command::sweep::Record;
use etalon_reference::scenes::wind_cloud::GROWTH_TIME;
use etalon_reference::scenes::{Name, dustywave};
use etalon_spec::tables::{Rung, Variant};

/// Where a number is found in what is remembered of a run, or of several with more and more particles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Read {
    /// The mean error of this field against the solution.
    Error(&'static str),
    /// The last value of this quantity.
    Last(&'static str),
    /// Its largest value.
    Largest(&'static str),
    /// Its mean over time.
    Mean {
        /// The quantity.
        of: &'static str,
        /// From this time on.
        since: f64,
    },
    /// How fast it changes around a time.
    Rate {
        /// The quantity.
        of: &'static str,
        /// The time.
        at: f64,
        /// How far around it.
        within: f64,
    },
    /// The order with which its last value falls from run to run.
    Order(&'static str),
    /// From how many particles on it falls in second order.
    SecondOrderFrom(&'static str),
    /// From how many particles on it is no larger than this.
    WithinFrom(&'static str, f64),
}

/// What becomes of the numbers of all variants of a quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Among {
    /// Each stands for itself.
    Themselves,
    /// Each becomes its place, 1 for the highest, among those to which the paper gives one.
    Places,
    /// Each becomes the decades by which it exceeds that of this variant.
    DecadesBeyond(Variant),
}

/// The runs of a variant that a number takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Runs {
    /// One at the scene's usual size, or the paper's.
    One,
    /// One at the resolution that the paper gives with the number; at its lowest where it gives none.
    Published,
    /// One at each of these resolutions.
    Series {
        /// At the usual sizes.
        usual: &'static [usize],
        /// At the paper's.
        paper: &'static [usize],
    },
}

/// How a published quantity is measured here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// Its key in `spec/tables/`.
    pub quantity: &'static str,
    /// What is run.
    pub scene: Name,
    /// Which runs.
    pub runs: Runs,
    /// Where it is found.
    pub read: Read,
    /// What becomes of it beside the other variants.
    pub among: Among,
    /// What ours is multiplied with in two dimensions: for a sum over the particles the depth of the paper's box, else one.
    pub depth: f64,
    /// What a reader of both numbers must know beside the paper's own caveat.
    pub note: &'static str,
}

/// A quantity that one run of a scene has.
const fn one(quantity: &'static str, scene: Name, read: Read, note: &'static str) -> Reading {
    Reading { quantity, scene, runs: Runs::One, read, among: Among::Themselves, depth: 1.0, note }
}

/// Of the dusty wave: its error at these resolutions.
const fn wave(
    quantity: &'static str,
    [usual, paper]: [&'static [usize]; 2],
    read: Read,
    note: &'static str,
) -> Reading {
    let runs = Runs::Series { usual, paper };
    Reading { runs, ..one(quantity, Name::DustyWave, read, note) }
}

/// Either side of PL20's 1000 particles.
const RESOLVED: [&[usize]; 2] = [&[512, 1024], &[1024, 2048]];
const UNRESOLVED: [&[usize]; 2] = [&[32, 64, 128, 256]; 2];
const ALL: [&[usize]; 2] = [&[32, 64, 128, 256, 512, 1024], &[32, 64, 128, 256, 512, 1024, 2048]];
/// The mean error of the gas's velocity.
const WAVE_ERROR: &str = "l1_gas_velocity";
/// What PL20's "few per cent" are taken for, in amplitudes.
const FEW_PER_CENT: f64 = 0.05 * dustywave::AMPLITUDE;

/// All that can be set beside each other.
pub const READINGS: &[Reading] = &[
    one(
        "shock_tube_velocity_l1",
        Name::Sod,
        Read::Error("velocity_x"),
        "from a sharp start; the printed start cannot reach the printed figures (docs/sod.md)",
    ),
    one("sedov_largest_density", Name::Sedov, Read::Largest("maximum_density"), "the largest over the run"),
    one(
        "sedov_radial_velocity_l1",
        Name::Sedov,
        Read::Last("l1_radial_velocity"),
        "to the radius of the largest velocity of each run, as the paper measures",
    ),
    one("vortex_azimuthal_velocity_l1", Name::GreshoChan, Read::Last("l1_azimuthal_velocity"), ""),
    one(
        "kelvin_helmholtz_amplitude",
        Name::KelvinHelmholtz,
        Read::Last("amplitude"),
        "sharp layers, as the paper describes; the converged amplitude of that start is 0.1408, not the 0.1479 of smoothed layers",
    ),
    Reading {
        depth: 0.1,
        ..one(
            "rayleigh_taylor_kinetic_energy",
            Name::RayleighTaylor,
            Read::Last("kinetic_energy_y"),
            "of a box 0.1 deep as the paper's; in two dimensions the energy per depth is multiplied by it",
        )
    },
    one(
        "wind_cloud_destruction_rate",
        Name::WindCloud,
        Read::Rate { of: "cloud_fraction", at: 1.8 * GROWTH_TIME, within: 0.5 },
        "the slope of M/M0 by least squares over t = 4.7 to 5.7, per unit of time, M0 being the mass measured at the start; none where the cloud is gone by then",
    ),
    one(
        "wind_cloud_later_destruction_rate",
        Name::WindCloud,
        Read::Rate { of: "cloud_fraction", at: 2.0 * GROWTH_TIME, within: 0.5 },
        "the same over t = 5.3 to 6.3, for which the run goes on beyond the paper's last look at t = 5.8",
    ),
    one(
        "kelvin_helmholtz_sign_reversals",
        Name::KelvinHelmholtz,
        Read::Last("sign_reversals"),
        "of all pairs of neighbours, at the end",
    ),
    one(
        "turbulence_bottleneck_wavenumber",
        Name::Turbulence,
        Read::Last("k_max"),
        "the top of k^(5/3) E(k) between k = 4 and what a grid of one point a particle holds; none if it is at an end of that range (docs/turbulence.md)",
    ),
    one("turbulence_inertial_slope", Name::Turbulence, Read::Last("spectrum_slope"), "from k = 4 to 10"),
    Reading {
        among: Among::DecadesBeyond(Variant::Rung(Rung::Standard)),
        ..one(
            "turbulence_inertial_range_gain",
            Name::Turbulence,
            Read::Last("k_max"),
            "the decades by which the bottleneck, which ends the range, lies beyond that of STD; none where either has no bottleneck that is resolved",
        )
    },
    one(
        "turbulence_mach_slope",
        Name::Turbulence,
        Read::Last("mach_slope"),
        "at the end, from a tenth to a quarter of the side",
    ),
    one("grad_h_mean", Name::Turbulence, Read::Last("grad_h_mean"), "at the end, with all ingredients of the ladder"),
    one(
        "grad_h_scatter",
        Name::Turbulence,
        Read::Last("grad_h_scatter"),
        "at the end, with all ingredients of the ladder",
    ),
    one(
        "membrane_radial_velocity_l1",
        Name::Membrane,
        Read::Error("velocity_r"),
        "distance from the linear wave, as in the paper; the full equations themselves are 0.0201 away from it (docs/membrane.md)",
    ),
    wave(
        "dustywave_particles_for_a_few_percent",
        ALL,
        Read::WithinFrom(WAVE_ERROR, FEW_PER_CENT),
        "the least of 32, 64 and so on to 1024 (2048 at the paper's resolution) from which L1 of the gas's velocity is at most 0.05 amplitudes at t = 10; \
         none if it is more at the last",
    ),
    Reading {
        runs: Runs::Published,
        among: Among::Places,
        ..one(
            "dustywave_kinetic_energy_place",
            Name::DustyWave,
            Read::Mean { of: "kinetic_energy", since: 0.0 },
            "by the mean over the run of the kinetic energy of gas and dust, among those the paper draws",
        )
    },
    wave(
        "dustywave_order",
        RESOLVED,
        Read::Order(WAVE_ERROR),
        "from 512 to 1024 particles; 1024 to 2048 at the paper's resolution",
    ),
    wave(
        "dustywave_unresolved_order",
        UNRESOLVED,
        Read::Order(WAVE_ERROR),
        "the slope by least squares over 32, 64, 128 and 256 particles",
    ),
    wave(
        "dustywave_particles_for_second_order",
        ALL,
        Read::SecondOrderFrom(WAVE_ERROR),
        "the least of 32, 64 and so on from which every doubling gains at least an order of 1.5, nearer to second than to first",
    ),
    Reading {
        runs: Runs::Published,
        ..one(
            "dustyshock_l1",
            Name::DustyShock,
            Read::Error("velocity_x"),
            "of the gas, against instant coupling. In one dimension with four times the number, which makes as many along the thin side, where the shock is, \
             as the paper's have there (docs/dust.md)",
        )
    },
    Reading {
        runs: Runs::Series { usual: &[128], paper: &[128] },
        ..one(
            "dustyshock_width",
            Name::DustyShock,
            Read::Last("shock_width"),
            "from a tenth to nine tenths of the velocity behind the shock, of the gas, with as many particles on the thin side as the paper has with 128",
        )
    },
];

impl Reading {
    /// Ours, from the records of its runs with their resolutions, ascending, in so many dimensions; none if they did not measure it.
    pub fn of(&self, records: &[(usize, &Record)], dimension: usize) -> Option<f64> {
        let (_, record) = *records.last()?;
        let series = |name: &str| {
            records.iter().map(|(n, record)| Some((*n as f64, record.last(name)?))).collect::<Option<Vec<_>>>()
        };
        let found = match self.read {
            Read::Error(field) => record.l1.get(field).copied(),
            Read::Last(name) => record.last(name),
            Read::Largest(name) => record.largest(name),
            Read::Mean { of, since } => record.mean(of, since),
            // What is gone has no rate any more.
            Read::Rate { of, at, within } => record.rate(of, at, within).filter(|rate| *rate != 0.0),
            Read::Order(name) => order(&series(name)?),
            Read::SecondOrderFrom(name) => second_order_from(&series(name)?),
            Read::WithinFrom(name, most) => within_from(&series(name)?, most),
        };
        found.map(|value| if dimension == 2 { value * self.depth } else { value })
    }
}

impl Among {
    /// What becomes of the numbers of all variants, of which the paper has the `published` ones.
    pub fn apply(self, variants: &[Variant], published: &[Option<f64>], ours: Vec<Option<f64>>) -> Vec<Option<f64>> {
        match self {
            Among::Themselves => ours,
            Among::Places => {
                let drawn: Vec<Option<f64>> = ours.iter().zip(published).map(|(o, p)| p.and(*o)).collect();
                let place = |own: f64| 1.0 + drawn.iter().flatten().filter(|other| **other > own).count() as f64;
                // With one missing, a place among the others is none.
                let whole = drawn.iter().zip(published).all(|(ours, theirs)| ours.is_some() == theirs.is_some());
                drawn.iter().map(|own| own.filter(|_| whole).map(place)).collect()
            }
            Among::DecadesBeyond(first) => {
                let at = variants.iter().position(|variant| *variant == first);
                let base = at.and_then(|at| ours[at]);
                ours.iter().map(|own| own.zip(base).map(|(own, base)| (own / base).log10())).collect()
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::command::reproduce::conditions::Conditions;
    use etalon_reference::scenes::{Quantity, Scene, View};
    use etalon_spec::tables::published;

    /// The view, what is measured on the way, what at the end alone.
    fn names<const D: usize>(scene: &dyn Scene<D>) -> (View, Vec<&'static str>, Vec<&'static str>) {
        let names = |quantities: Vec<Quantity>| quantities.into_iter().map(|quantity| quantity.name).collect();
        (scene.view(), names(scene.quantities()), names(scene.quantities_at_end()))
    }

    /// A name that nothing measures, or that no paper has, would make an empty column.
    #[test]
    fn every_reading_names_what_there_is() {
        let all = published().unwrap();
        for reading in READINGS {
            let theirs: Vec<_> = all.iter().filter(|p| p.quantity == reading.quantity).collect();
            assert!(!theirs.is_empty(), "no paper has {}", reading.quantity);
            assert!(theirs.iter().all(|p| p.scene.as_str() == reading.scene.name()), "{}", reading.quantity);
            let conditions = Conditions::of(reading.scene).unwrap();
            for &dimension in reading.scene.dimensions() {
                let problem = reading.scene.standard(dimension).unwrap();
                let (view, on_the_way, at_end) = match dimension {
                    1 => names(problem.scene::<1>()),
                    2 => names(problem.scene::<2>()),
                    _ => names(problem.scene::<3>()),
                };
                let measured = |name: &str| on_the_way.contains(&name);
                let end = conditions.end_time.unwrap_or(problem.end_time());
                let known = match reading.read {
                    Read::Error(field) => view.velocity() == field,
                    Read::Last(name) => measured(name) || at_end.contains(&name),
                    Read::Largest(name) => measured(name),
                    Read::Order(name) | Read::SecondOrderFrom(name) | Read::WithinFrom(name, _) => measured(name),
                    Read::Mean { of, since } => measured(of) && since < end,
                    Read::Rate { of, at, within } => measured(of) && at + within <= end,
                };
                assert!(known, "{} in {dimension}-D has no {:?}", reading.scene, reading.read);
            }
        }
    }

    #[test]
    fn places_are_among_those_that_the_paper_has() {
        let variants = [Variant::Rung(Rung::Standard); 4];
        let published = [Some(1.0), Some(2.0), None, Some(3.0)];
        let ours = vec![Some(0.5), Some(0.7), Some(9.0), Some(0.1)];
        let places = Among::Places.apply(&variants, &published, ours);
        assert_eq!(places, [Some(2.0), Some(1.0), None, Some(3.0)]);
        let missing = Among::Places.apply(&variants, &published, vec![None, Some(0.7), Some(9.0), Some(0.1)]);
        assert_eq!(missing, [None; 4]);
    }

    #[test]
    fn decades_are_beyond_the_first_rung() {
        let variants = [Variant::Rung(Rung::VolumeElements), Variant::Rung(Rung::Standard)];
        let beyond = Among::DecadesBeyond(variants[1]);
        assert_eq!(beyond.apply(&variants, &[None; 2], vec![Some(40.0), Some(4.0)]), [Some(1.0), Some(0.0)]);
        assert_eq!(beyond.apply(&variants, &[None; 2], vec![Some(40.0), None]), [None; 2]);
    }
}
