//! Every published number of the three papers in one form, so that ours can be set beside it.

use std::sync::LazyLock;

use super::TableError;
use super::membrane::MembraneVariant;
use super::numbers::{Row, Says, Source};
use super::place::Place;
use super::quantity::Goal;
use super::results::{MetricKey, Results};
use super::scene::Scene;
use super::schemes::SchemeName;
use super::setups::Setups;
use super::variant::{DragScheme, GradHForm, Rung, Variant};
use crate::paper::Paper;
use crate::unit::Unit;

/// One number of a paper.
#[derive(Clone, Debug, PartialEq)]
pub struct Published {
    /// The paper.
    pub paper: Paper,
    /// Where in it.
    pub place: Place,
    /// The key of what is measured, such as `kelvin_helmholtz_amplitude`; the same wherever the paper repeats it.
    pub quantity: String,
    /// What is measured, in plain words.
    pub meaning: String,
    /// The unit, in powers of the code's mass, length and time.
    pub unit: Unit,
    /// When it is measured.
    pub time: String,
    /// The problem.
    pub scene: Scene,
    /// What was run on it.
    pub scheme: Variant,
    /// The paper's name of the run, such as `KH3`.
    pub run: Option<String>,
    /// Particles along an axis or in a wavelength, where the number belongs to one resolution of several.
    pub resolution: Option<u32>,
    /// The value in the unit; none where the paper, or the text of it at hand, has none. The note says what it has.
    pub value: Option<f64>,
    /// How the value is stated.
    pub says: Says,
    /// Which value is better.
    pub better: Goal,
    /// What to beware of, and where the paper contradicts itself.
    pub note: Option<String>,
}

/// Everything published, in the order of the papers and of the places in them.
///
/// What a paper prints twice stands here twice; [`Published::place`] tells one from the other.
///
/// # Errors
/// [`TableError`] for the first fault of a file; none occurs in a build whose tests pass.
pub fn published() -> Result<&'static [Published], TableError> {
    static ALL: LazyLock<Result<Vec<Published>, TableError>> = LazyLock::new(read_all);
    ALL.as_deref().map_err(Clone::clone)
}

/// Reads and checks the text of one place as if it were the file built in; for those who check files.
///
/// # Errors
/// [`TableError`] for the first fault found, and where nothing is kept of that place in this form.
pub fn parse_published(paper: Paper, place: Place, text: &str) -> Result<Vec<Published>, TableError> {
    let known = SOURCES.iter().find(|source| (source.paper, source.place) == (paper, place));
    known.ok_or(TableError::UnknownPlace { paper, place }).and_then(|source| numbers(source, text))
}

const fn scheme(name: SchemeName) -> Variant {
    Variant::Scheme(name)
}

/// The seven schemes of Table 1; Tables 3 to 5 have the first six.
const SCHEMES: [Variant; 7] = [
    scheme(SchemeName::Av),
    scheme(SchemeName::Avsw),
    scheme(SchemeName::Avslr),
    scheme(SchemeName::Avswslr),
    scheme(SchemeName::Avslrb),
    scheme(SchemeName::Avslrb2),
    scheme(SchemeName::Avslrb2f),
];
const SIX: &[Variant] = SCHEMES.split_at(6).0;
const MEMBRANE: &[Variant] = &[
    Variant::Membrane(MembraneVariant::Av),
    Variant::Membrane(MembraneVariant::Avsw),
    Variant::Membrane(MembraneVariant::Avslrb2),
    Variant::Membrane(MembraneVariant::Avswslr),
    Variant::Membrane(MembraneVariant::AvslrbStar2),
    Variant::Membrane(MembraneVariant::AvslrbStar2f),
];
const LADDER: &[Variant] = &[
    Variant::Rung(Rung::Standard),
    Variant::Rung(Rung::IntegralGradients),
    Variant::Rung(Rung::VolumeElements),
    Variant::Rung(Rung::VariableViscosity),
    Variant::Rung(Rung::SlopeLimitedReconstruction),
];
const GRAD_H: &[Variant] = &[Variant::GradH(GradHForm::Exact), Variant::GradH(GradHForm::Corrected)];
const BARE: Variant = Variant::Drag(DragScheme::Unreconstructed);
const UNLIMITED: Variant = Variant::Drag(DragScheme::Unlimited);
const MC: Variant = Variant::Drag(DragScheme::MonotonizedCentral);

/// A place with its file.
macro_rules! source {
    ($paper:ident $place:ident $number:literal, $file:literal, $columns:expr) => {
        Source {
            paper: Paper::$paper,
            place: Place::$place($number),
            text: include_str!(concat!("../../tables/", $file, ".toml")),
            columns: $columns,
        }
    };
}

/// All places but Table 7, in order.
static SOURCES: [Source; 13] = [
    source!(Gs25 Table 3, "gs25_table3", &[("kelvin_helmholtz_amplitude", SIX)]),
    source!(Gs25 Table 4, "gs25_table4", &[("rayleigh_taylor_kinetic_energy", SIX)]),
    source!(Gs25 Table 5, "gs25_table5", &[
        ("wind_cloud_destruction_rate", SIX),
        ("wind_cloud_later_destruction_rate", SIX),
    ]),
    source!(Gs25 Table 6, "gs25_table6", &[("turbulence_bottleneck_wavenumber", &SCHEMES)]),
    source!(Gs25 Figure 11, "gs25_figure11", &[("membrane_radial_velocity_l1", MEMBRANE)]),
    source!(Gs25 Equation 29, "gs25_equation29", &[("kelvin_helmholtz_sign_reversals", &[SCHEMES[5]])]),
    source!(Pl20 Figure 1, "pl20_figure1", &[("dustywave_particles_for_a_few_percent", &[BARE, UNLIMITED, MC])]),
    source!(Pl20 Figure 3, "pl20_figure3", &[("dustywave_kinetic_energy_place", &[
        UNLIMITED,
        MC,
        Variant::Drag(DragScheme::VanLeer),
        Variant::Drag(DragScheme::Minmod),
        Variant::Drag(DragScheme::EntropyFix),
        BARE,
        Variant::Drag(DragScheme::Superbee),
    ])]),
    source!(Pl20 Figure 4, "pl20_figure4", &[
        ("dustywave_order", &[BARE, MC]),
        ("dustywave_unresolved_order", &[BARE, MC]),
        ("dustywave_particles_for_second_order", &[BARE, MC]),
    ]),
    source!(Pl20 Figure 5, "pl20_figure5", &[
        ("dustyshock_l1", &[BARE, UNLIMITED, MC, MC, MC]),
        ("dustyshock_width", &[UNLIMITED]),
    ]),
    source!(C25 Figure 1, "c25_figure1", &[
        ("turbulence_inertial_range_gain", LADDER),
        ("turbulence_inertial_slope", LADDER),
    ]),
    source!(C25 Figure 7, "c25_figure7", &[("grad_h_mean", GRAD_H), ("grad_h_scatter", GRAD_H)]),
    source!(C25 Figure 8, "c25_figure8", &[("turbulence_mach_slope", &[LADDER[4]])]),
];

fn read_all() -> Result<Vec<Published>, TableError> {
    let mut all = table_7(&Results::load()?, &Setups::load()?);
    for source in &SOURCES {
        all.extend(numbers(source, source.text)?);
    }
    // Stable: within a place the order stays that of its file.
    all.sort_by_key(|number| (number.paper, number.place));
    Ok(all)
}

/// The rows of a file, each with what its column says.
fn numbers(source: &Source, text: &str) -> Result<Vec<Published>, TableError> {
    let (columns, rows) = source.parse(text)?;
    let column = |key: &str| columns.iter().find(|column| column.key == key);
    let number = |(scheme, row): (Variant, Row)| {
        let column = column(&row.quantity)?;
        let notes = [row.note, column.caveat.clone()];
        let note = notes.into_iter().flatten().collect::<Vec<_>>().join(" ");
        Some(Published {
            paper: source.paper,
            place: source.place,
            meaning: column.meaning.clone(),
            unit: column.unit,
            time: column.time.clone(),
            scene: column.test,
            scheme,
            run: row.run,
            resolution: row.resolution,
            value: row.value.map(|printed| column.scaled(printed)),
            says: row.says,
            better: column.goal(),
            note: (!note.is_empty()).then_some(note),
            quantity: row.quantity,
        })
    };
    // Parsing has checked that every row names a column of the file, so none is left out.
    Ok(rows.into_iter().filter_map(number).collect())
}

/// Table 7 in the common form.
fn table_7(results: &Results, setups: &Setups) -> Vec<Published> {
    let number = |key: MetricKey, name: SchemeName| {
        let metric = results.metric(key);
        Published {
            paper: Paper::Gs25,
            place: Place::Table(7),
            quantity: key.as_str().into(),
            meaning: metric.meaning.clone(),
            unit: metric.unit,
            time: metric.time.clone(),
            scene: metric.test.into(),
            scheme: Variant::Scheme(name),
            run: Some(format!("{}{}", setups.get(metric.test).prefix, name.number())),
            resolution: None,
            value: Some(results.value(name, key)),
            says: Says::Exactly,
            better: metric.goal(),
            note: metric.caveat.clone(),
        }
    };
    MetricKey::ALL.into_iter().flat_map(|key| SchemeName::ALL.map(|name| number(key, name))).collect()
}
