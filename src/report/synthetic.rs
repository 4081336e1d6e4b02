//! A report as a Sod run would give it, made up for the tests: exact solution by the known star state, errors by a
//! seeded generator. No simulation behind it.

use super::model::{
    Conserved, Curve, CurveColumn, CurveField, EndCurve, EndQuantity, Ending, ExpectedLine, Field, FieldDifference,
    FieldError, FmaPeak, KernelApproximation, Machine, Measurements, Norm, NormRange, Outcome, Profile, ProfileField,
    Report, Run, Scene, Series, Setting, Speed, Stage, Tolerance, stratified,
};

/// Names of the four fields.
const FIELDS: [&str; 4] = ["density", "velocity_x", "pressure", "internal_energy"];

/// Density, velocity, pressure and internal energy of the sharp Sod tube at t = 0.2 for an adiabatic index of 5/3.
fn exact(x: f64) -> [f64; 4] {
    let (pressure_star, velocity_star) = (0.293945187666018, 0.841194852168808);
    let (density_left, density_right) = (0.479689058720917, 0.229805749311947);
    let gamma: f64 = 5.0 / 3.0;
    let sound = gamma.sqrt();
    let [density, velocity, pressure] = match x {
        x if x < 0.2418011 => [1.0, 0.0, 1.0],
        x if x < 0.4661197 => {
            let velocity = 2.0 / (gamma + 1.0) * (sound + (x - 0.5) / 0.2);
            let ratio = (sound - (gamma - 1.0) / 2.0 * velocity) / sound;
            [ratio.powi(3), velocity, ratio.powi(5)]
        }
        x if x < 0.6682390 => [density_left, velocity_star, pressure_star],
        x if x < 0.8688947 => [density_right, velocity_star, pressure_star],
        _ => [0.125, 0.0, 0.1],
    };
    [density, velocity, pressure, pressure / ((gamma - 1.0) * density)]
}

/// The exact solution blurred over a resolution length, as a particle method would give it.
fn blurred(x: f64) -> [f64; 4] {
    let mut mean = [0.0; 4];
    for k in -8..=8 {
        let sample = exact(x + f64::from(k) * 0.0012);
        for (sum, value) in mean.iter_mut().zip(sample) {
            *sum += value / 17.0;
        }
    }
    mean
}

/// A linear congruential generator: noise in -1..1.
struct Noise(u64);

impl Noise {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// Places of particles, eight times as thick on the left.
fn places(noise: &mut Noise) -> Vec<f64> {
    (0..40_000)
        .map(|i| {
            let u = f64::from(i) / 40_000.0;
            let x = if u < 0.889 { 0.5 * u / 0.889 } else { 0.5 + 0.5 * (u - 0.889) / 0.111 };
            (x + 0.001 * noise.next()).clamp(0.0, 1.0)
        })
        .collect()
}

/// A run whose arithmetic differs from the reference by about `level`.
fn measurements(level: f64, wall_seconds: f64, threads: u32, peak: Option<f64>) -> Measurements {
    let mut noise = Noise(1);
    let all = places(&mut noise);
    let picked = stratified(&all, 800);
    let x: Vec<f64> = picked.iter().map(|&i| all[i]).collect();
    let mut columns: Vec<ProfileField> = FIELDS
        .iter()
        .map(|&field| ProfileField { field: field.into(), value: vec![], exact: vec![], reference: vec![] })
        .collect();
    for &x in &x {
        let (truth, smooth) = (exact(x), blurred(x));
        for (k, column) in columns.iter_mut().enumerate() {
            let reference = smooth[k] + 4e-3 * noise.next();
            // Differences grow where the flow has structure; squaring spreads them over decades.
            let structure = 0.05 + (smooth[k] - truth[k]).abs() * 4.0;
            column.exact.push(truth[k]);
            column.value.push(reference + level * structure * noise.next() * noise.next().abs());
            if level > 0.0 {
                column.reference.push(reference);
            }
        }
    }
    let (particles, steps) = (110_592, 214);
    let difference = |k: usize| {
        let tolerance = if level > 1e-9 {
            Tolerance::new(4e-5, "2⁻²⁴ · √(214 steps · 100 neighbours) · condition 4.6 of the pressure gradient")
        } else {
            Tolerance::new(8e-14, "2⁻⁵³ · √(214 steps · 100 neighbours) · condition 4.6 of the pressure gradient")
        };
        let scale = [1.0, 0.841, 1.0, 1.92][k];
        let rms = level * scale * [0.03, 0.11, 0.05, 0.08][k];
        FieldDifference::new(FIELDS[k], rms, rms * 6.3, scale, Norm::Rms, tolerance)
    };
    let errors = [(3.1e-3, 9.9e-3, 0.121), (7.213e-3, 0.0212, 0.312), (3.6e-3, 0.0131, 0.104), (0.0121, 0.0442, 0.81)];
    let share = [("order", 0.06), ("neighbour list", 0.14), ("density and grad-h", 0.11)];
    let share2 = [("integral-approach matrix", 0.14), ("momentum and energy", 0.49), ("update", 0.06)];
    let drift = if level > 1e-9 { 2.7e-7 } else { 4.4e-16 };
    let rounding = |value| Tolerance::new(value, "one rounding a step, adding like a random walk");
    Measurements {
        steps,
        time: 0.2,
        threads,
        wall_seconds,
        operations_per_update: 24_000.0,
        bytes_per_particle: if level > 1e-9 { 212.0 } else { 384.0 },
        speed: Speed::new(particles, steps, wall_seconds, peak.map(|peak| (threads, peak)), Some(6210.0)),
        stages: share
            .iter()
            .chain(&share2)
            .map(|&(name, share)| Stage { name: name.into(), seconds: share * wall_seconds, count: steps })
            .collect(),
        conservation: vec![
            Conserved { quantity: "mass".into(), scaled_drift: 0.0, tolerance: Some(rounding(1e-15)), note: None },
            Conserved {
                quantity: "momentum".into(),
                scaled_drift: -3.0 * drift,
                tolerance: Some(rounding(if level > 1e-9 { 2e-6 } else { 4e-15 })),
                note: Some("across the tube; along it the fixed layers push".into()),
            },
            Conserved {
                quantity: "energy".into(),
                scaled_drift: 3.2e-5,
                tolerance: None,
                note: Some("second-order integrator".into()),
            },
        ],
        discretisation_error: FIELDS
            .iter()
            .zip(errors)
            .map(|(&field, (l1, l2, max))| FieldError { field: field.into(), l1, l2, max, particles: 93_120 })
            .collect(),
        arithmetic_difference: if level > 0.0 { (0..4).map(difference).collect() } else { vec![] },
        profile: Profile { selection: "800 of 110592 particles, evenly in x".into(), x, fields: columns },
        series: Series::default(),
        ending: Ending::default(),
    }
}

/// Fields, with units of the Sod tube.
fn fields() -> Vec<Field> {
    let text = [
        ("density", "density", "ρ", "ρ₀"),
        ("velocity_x", "velocity", "vₓ", "√(P₀/ρ₀)"),
        ("pressure", "pressure", "P", "P₀"),
        ("internal_energy", "internal energy", "u", "P₀/ρ₀"),
    ];
    let own = |s: &str| s.to_owned();
    text.iter()
        .map(|(name, label, symbol, unit)| Field {
            name: own(name),
            label: own(label),
            symbol: own(symbol),
            unit: own(unit),
        })
        .collect()
}

/// The exact solution as a line, doubled at the jumps.
fn curve() -> Curve {
    let mut x: Vec<f64> = (0..=400).map(|i| f64::from(i) / 400.0).collect();
    for jump in [0.6682390, 0.8688947] {
        x.extend([jump - 1e-9, jump]);
    }
    x.sort_by(f64::total_cmp);
    let fields = (0..4)
        .map(|k| CurveField { field: FIELDS[k].into(), value: x.iter().map(|&x| exact(x)[k]).collect() })
        .collect();
    Curve { x, fields }
}

/// Three runs and a skipped one.
pub(super) fn report() -> Report {
    let approximation = |precision: &str, degree, max, value| KernelApproximation {
        function: "mixed sinc kernel w(q)".into(),
        approximation: format!("polynomial in q², degree {degree}"),
        precision: precision.into(),
        max,
        tolerance: Tolerance::new(value, "fit error and rounding of the Horner scheme"),
    };
    Report {
        program_version: "0.1.0".into(),
        created: "2026-11-22T04:28:00Z".into(),
        command: "etalon run sod --dim 3 --n 110592 --scheme AVSLRB2 --kernel sinc --neighbours 100 --end-time 0.2 --threads 2"
            .into(),
        scene: Scene {
            name: "sod".into(),
            title: "Sod shock tube".into(),
            dimension: 3,
            particles: 110_592,
            neighbours: 100.0,
            kernel: "mixed sinc, 0.9 S₄ + 0.1 S₉".into(),
            scheme: "AVSLRB2".into(),
            gamma: 5.0 / 3.0,
            end_time: 0.2,
            arrangement: "lattice".into(),
            discontinuity: "sharp".into(),
            boundaries: "fixed layers in x, periodic in y and z".into(),
            norm: NormRange { coordinate: "x".into(), unit: "L".into(), from: 0.05, to: 0.868, source: "GS25, Eq. 20".into() },
            settings: vec![Setting { name: "Courant number".into(), value: "0.3".into() }],
        },
        machine: Machine {
            cpu: "Example CPU @ 2.75 GHz".into(),
            threads: 2,
            instruction_set: "AVX-512".into(),
            system: "linux x86_64".into(),
            adapter: None,
            fma_peak_gflops_per_core: FmaPeak { f32: 176.0, f64: 88.0 },
        },
        fields: fields(),
        exact: curve(),
        kernel_approximation: vec![approximation("f64", 10, 3.1e-16, 8e-16), approximation("f32", 5, 1.1e-7, 3e-7)],
        runs: vec![
            Run::ran("reference", "f64", measurements(0.0, 147.0, 1, Some(88.0))),
            Run::ran("simd", "f64", measurements(2e-13, 28.2, 2, Some(88.0))),
            Run::ran("simd", "f32", measurements(6e-5, 15.1, 2, Some(176.0))),
            Run::skipped("wgpu", "f32", "no graphics adapter found (install a Vulkan driver, or mesa-vulkan-drivers)"),
        ],
    }
}

/// The same with all four runs.
pub(super) fn complete() -> Report {
    let mut report = report();
    report.machine.adapter = Some("llvmpipe (LLVM 15.0.6, 256 bits), Vulkan".into());
    report.runs[3].outcome = Outcome::Ran(Box::new(measurements(9e-5, 63.0, 2, None)));
    report
}

/// The same with an end of which one number is known and one is not, and with a curve: made up, a power law.
pub(super) fn with_ending() -> Report {
    let mut report = complete();
    let quantity = |name: &str, value: Option<f64>, missing: Option<&str>| EndQuantity {
        name: name.into(),
        label: format!("the {name}"),
        symbol: "k".into(),
        unit: "L".into(),
        expected: Some(-1.667),
        expected_source: Some("Kolmogorov".into()),
        value,
        missing: missing.map(String::from),
    };
    let column = |name: &str, logarithmic, value| CurveColumn {
        name: name.into(),
        label: format!("label of {name}"),
        unit: "L^-1".into(),
        logarithmic,
        value,
    };
    let x: Vec<f64> = (1..60).map(f64::from).collect();
    for run in &mut report.runs {
        if let Outcome::Ran(measured) = &mut run.outcome {
            measured.ending = Ending {
                quantities: vec![
                    quantity("slope", Some(-1.5), None),
                    quantity("peak", None, Some("too few particles")),
                ],
                curves: vec![EndCurve {
                    name: "spectrum".into(),
                    label: "spectrum of the velocity".into(),
                    x: column("wave_number", true, x.clone()),
                    y: column("energy", true, x.iter().map(|k| 0.01 * k.powf(-1.5)).collect()),
                    expected: Some(ExpectedLine {
                        source: "flat line".into(),
                        x: vec![4.0, 10.0],
                        y: vec![1e-3, 1e-3],
                    }),
                }],
            };
        }
    }
    report
}
