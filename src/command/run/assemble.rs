//! The report, from what was asked and what came out.

use super::approximation::approximations;
use super::graphics::Graphics;
use super::plan::Plan;
use super::seen::{VELOCITY, names};
use crate::command::arguments::RunArguments;
use crate::command::choices::{Backend, Precision};
use crate::command::failure::Failure;
use crate::command::machine;
use crate::command::setup::{Setup, quoted};
use crate::fma_peak::FmaPeak;
use crate::report::model::{self, Curve, Field, Machine, NormRange, Run, Scene, Setting};
use crate::report::{Column, Particles, Report, plain, utc_now};
use etalon_kernels_gen::lanes::level_name;
use etalon_reference::equations::time_step::COURANT;
use etalon_reference::scenes::{Description, Measured, State, View};
use etalon_reference::schemes::Kernel;
use fearless_simd::Level;
use std::path::Path;

/// What a report is made of.
pub struct Circumstances<'a> {
    pub setup: &'a Setup,
    pub plan: &'a Plan,
    pub arguments: &'a RunArguments,
    pub folder: &'a Path,
    pub graphics: &'a Graphics,
    pub level: Level,
    pub peak: FmaPeak,
    pub particles: usize,
    /// The solution as a line.
    pub exact: Curve,
    pub view: View,
    pub measured: Measured,
    pub description: Description,
    pub runs: Vec<Run>,
}

/// The report.
pub fn report(of: &Circumstances) -> Report {
    let mut precisions: Vec<Precision> = Vec::new();
    for (_, precision) in &of.plan.combinations {
        if !precisions.contains(precision) {
            precisions.push(*precision);
        }
    }
    Report {
        program_version: env!("CARGO_PKG_VERSION").into(),
        created: utc_now(),
        command: command(of),
        scene: scene(of),
        machine: machine(of),
        fields: fields(of.view),
        exact: of.exact.clone(),
        kernel_approximation: approximations(of.setup, &precisions),
        runs: of.runs.clone(),
    }
}

/// The command line that gives this report again.
fn command(of: &Circumstances) -> String {
    let mut text = format!("etalon run {}", of.setup.options());
    let given = of.arguments;
    let mut option = |name: &str, value: String| text += &format!(" --{name} {value}");
    if let Some(backend) = given.scene.backend {
        option("backend", backend.to_string());
    }
    if let Some(precision) = given.scene.precision {
        option("precision", precision.to_string());
    }
    if of.plan.combinations.iter().any(|(backend, _)| *backend == Backend::Simd) {
        option("threads", rayon::current_num_threads().to_string());
        option("instructions", level_name(of.level).into());
    }
    if let Some(adapter) = &given.adapter {
        option("adapter", quoted(adapter));
    }
    if given.out.is_some() {
        option("out", quoted(&of.folder.display().to_string()));
    }
    if given.alone {
        text += " --alone";
    }
    text
}

fn scene(of: &Circumstances) -> Scene {
    let (problem, method) = (&of.setup.problem, of.setup.method());
    let setting = |name: &str, value: String| Setting { name: name.into(), value };
    let mut settings: Vec<Setting> =
        of.description.settings.iter().map(|(n, value)| setting(n, value.clone())).collect();
    settings.extend([
        setting("Dissipation", of.setup.coefficients()),
        setting("Grad-h factor", method.grad_h.to_string()),
        setting("Time integration", format!("kick, drift, kick; Courant number {} on h/c", plain(0.5 * COURANT))),
    ]);
    settings.extend(of.setup.formulation().map(|words| setting("Formulation", words)));
    if let Some(bytes) = machine::peak_memory() {
        let mut text = format!("{:.0} MiB", bytes as f64 / f64::from(1 << 20));
        // In a smaller run the program itself and the drivers outweigh the particles.
        if of.particles >= 100_000 {
            text += &format!(", {:.0} bytes a particle", bytes as f64 / of.particles as f64);
        }
        settings.push(setting("Peak memory of the program", text));
    }
    Scene {
        name: problem.name().to_string(),
        title: problem.name().title().into(),
        dimension: of.setup.dimension as u8,
        particles: of.particles as u64,
        neighbours: method.neighbours,
        kernel: kernel(method.kernel).into(),
        scheme: method.viscosity.dissipation.name().into(),
        gamma: of.setup.physics().gamma_minus_one + 1.0,
        end_time: of.setup.end_time,
        arrangement: match &of.setup.start_file {
            Some(_) => "file".into(),
            None => method.arrangement.to_string(),
        },
        discontinuity: match &of.setup.start_file {
            Some(_) => "as in the file".into(),
            None => of.description.start.clone(),
        },
        boundaries: of.description.boundaries.clone(),
        norm: NormRange {
            coordinate: of.view.coordinate().into(),
            unit: "L".into(),
            from: of.measured.range.0,
            to: of.measured.range.1,
            source: of.measured.source.into(),
        },
        settings,
    }
}

/// The kernel for people.
fn kernel(kernel: Kernel) -> &'static str {
    match kernel {
        Kernel::MixedSinc => "mixed sinc, 0.9 S₄ + 0.1 S₉",
        Kernel::CubicSpline => "cubic spline M₄",
        Kernel::QuinticSpline => "quintic spline M₆",
        Kernel::WendlandC2 => "Wendland C2",
        Kernel::WendlandC4 => "Wendland C4",
        Kernel::WendlandC6 => "Wendland C6",
    }
}

fn machine(of: &Circumstances) -> Machine {
    Machine {
        cpu: machine::processor(),
        threads: machine::hardware_threads() as u32,
        instruction_set: match level_name(of.level) {
            "avx512" => "AVX-512".into(),
            "avx2" => "AVX2".into(),
            "neon" => "NEON".into(),
            other => other.into(),
        },
        system: machine::system(),
        adapter: of.graphics.adapter(),
        fma_peak_gflops_per_core: model::FmaPeak { f32: of.peak.single, f64: of.peak.double },
    }
}

fn fields(view: View) -> Vec<Field> {
    let field = |name: &str, label: &str, symbol: &str, unit: &str| Field {
        name: name.into(),
        label: label.into(),
        symbol: symbol.into(),
        unit: unit.into(),
    };
    vec![
        field("density", "density", "ρ", "ρ₀"),
        field(names(view)[VELOCITY], "velocity", view.velocity_symbol(), "√(P₀/ρ₀)"),
        field("pressure", "pressure", "P", "P₀"),
        field("internal_energy", "internal energy", "u", "P₀/ρ₀"),
    ]
}

/// The final particles as a table.
pub fn particle_columns(state: &State) -> Result<Particles<'_>, Failure> {
    const POSITION: [&str; 3] = ["x", "y", "z"];
    const VELOCITY: [&str; 3] = ["velocity_x", "velocity_y", "velocity_z"];
    let column = |name, unit, values| Column { name, unit, values };
    let mut columns = Vec::new();
    for (axis, values) in state.position.iter().enumerate() {
        columns.push(column(POSITION[axis], "L", values.as_slice()));
    }
    for (axis, values) in state.velocity.iter().enumerate() {
        columns.push(column(VELOCITY[axis], "sqrt(P0/rho0)", values.as_slice()));
    }
    columns.push(column("density", "rho0", &state.density));
    columns.push(column("pressure", "P0", &state.pressure));
    columns.push(column("internal_energy", "P0/rho0", &state.internal_energy));
    columns.push(column("smoothing_length", "L", &state.smoothing_length));
    Ok(Particles::new(columns)?)
}
