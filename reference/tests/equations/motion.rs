//! The last sweep against the papers' formulas as they are printed, written out here in plain `f64`.

use crate::check::{UNIT, assert_close, gamma};
use crate::cloud::Recipe;
use etalon_kernels_gen::{Field, Pass, Quantity, Separation, Symmetric, Update, Vector};
use etalon_reference::domain::separation;
use etalon_reference::engine::{Engine, PlainEngine};
use etalon_reference::equations::kernels::kernel_shape;
use etalon_reference::fields;
use etalon_reference::particles::{Particle, ParticleSet};
use etalon_reference::passes::{Correct, KickDrift, Momentum, Physics};
use etalon_reference::pipeline::Pipeline;
use etalon_reference::schemes::{ApproachForm, Dissipation, GradH, Kernel, Viscosity};

fn physics(dissipation: Dissipation, grad_h: GradH) -> Physics {
    let viscosity = Viscosity::of(dissipation);
    Physics {
        kernel: Kernel::MixedSinc,
        grad_h,
        viscosity,
        gamma_minus_one: 2.0 / 3.0,
        neighbours: 50.0,
        ..Physics::STANDARD
    }
}

/// All that the formulas take of a particle, read from the engine.
struct Gas<const D: usize> {
    columns: Vec<(Field, Vec<Vec<f64>>)>,
    coordinates: [Vec<u64>; D],
}

impl<const D: usize> Gas<D> {
    fn get(&self, field: Field, a: usize) -> f64 {
        self.columns.iter().find(|(f, _)| *f == field).unwrap().1[0][a]
    }
    fn vector(&self, field: Field, a: usize) -> [f64; D] {
        let columns = &self.columns.iter().find(|(f, _)| *f == field).unwrap().1;
        std::array::from_fn(|i| columns[i][a])
    }
    fn apply(&self, field: Field, a: usize, x: [f64; D]) -> [f64; D] {
        let columns = &self.columns.iter().find(|(f, _)| *f == field).unwrap().1;
        std::array::from_fn(|i| (0..D).map(|j| columns[Symmetric::<f64, D>::position(i, j)][a] * x[j]).sum())
    }
    /// `x_a - x_b`
    fn between(&self, a: usize, b: usize) -> [f64; D] {
        std::array::from_fn(|axis| separation(self.coordinates[axis][a], self.coordinates[axis][b], 1.0))
    }
}

fn dot<const D: usize>(a: [f64; D], b: [f64; D]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// What a particle's neighbours do to it.
#[derive(Default)]
struct Motion {
    acceleration: [f64; 3],
    heating: f64,
    largest_signal: f64,
    /// Sums of the magnitudes of all terms.
    force_size: f64,
    heating_size: f64,
    /// How many pairs were of each kind: limited, in the ramp, crossed, within the other's support only.
    kinds: [usize; 4],
}

/// C25 (22), (23) and GS25 (4)-(7), (13)-(19), (27) as printed.
fn as_printed<const D: usize>(gas: &Gas<D>, a: usize, count: usize, viscosity: &Viscosity) -> Motion {
    let mut motion = Motion::default();
    let h_a = 1.0 / gas.get(fields::INVERSE_SMOOTHING_LENGTH, a);
    for b in (0..count).filter(|b| *b != a) {
        let x_ab = gas.between(a, b);
        let r = dot(x_ab, x_ab).sqrt();
        let h_b = 1.0 / gas.get(fields::INVERSE_SMOOTHING_LENGTH, b);
        if r >= 2.0 * h_a.max(h_b) {
            continue;
        }
        let x_ba = x_ab.map(|x| -x);
        let kernel = |h: f64| kernel_shape::<f64, D>(Kernel::MixedSinc, (r / h).powi(2)).value / h.powi(D as i32);
        let gradient_a = gas.apply(fields::GRADIENT_MATRIX, a, x_ba).map(|x| x * kernel(h_a));
        let gradient_b = gas.apply(fields::GRADIENT_MATRIX, b, x_ba).map(|x| x * kernel(h_b));
        let (m_a, m_b) = (gas.get(fields::MASS, a), gas.get(fields::MASS, b));
        let (x_a, x_b) = (gas.get(fields::VOLUME_ESTIMATOR, a), gas.get(fields::VOLUME_ESTIMATOR, b));
        let (rho_a, rho_b) = (gas.get(fields::DENSITY, a), gas.get(fields::DENSITY, b));
        let v_ab: [f64; D] =
            std::array::from_fn(|i| gas.vector(fields::VELOCITY, a)[i] - gas.vector(fields::VELOCITY, b)[i]);

        let atwood = (rho_a - rho_b).abs() / (rho_a + rho_b);
        let sigma = ((atwood - 0.1) / (0.2 - 0.1)).clamp(0.0, 1.0);
        let coefficient = |this: usize, x: f64, x_other: f64, m: f64, m_other: f64| {
            let omega = gas.get(fields::GRAD_H, this);
            if omega <= 0.0 {
                return 0.0;
            }
            let volumes = x.powf(2.0 - sigma) * x_other.powf(sigma);
            let masses = m.powf(2.0 - sigma) * m_other.powf(sigma);
            volumes * gas.get(fields::PRESSURE, this) / (masses * gas.get(fields::KERNEL_NORMALISATION, this) * omega)
        };
        let (y_a, y_b) = (coefficient(a, x_a, x_b, m_a, m_b), coefficient(b, x_b, x_a, m_b, m_a));

        let omega = if r > 0.0 { dot(v_ab, x_ab) / r } else { 0.0 };
        let (c_a, c_b) = (gas.get(fields::SOUND_SPEED, a), gas.get(fields::SOUND_SPEED, b));
        let (mut omega_prime, mut omega_size, mut alpha, mut limited) = (omega, omega.abs(), viscosity.alpha, false);
        let balsara_ab = || 0.5 * (gas.get(fields::BALSARA, a) + gas.get(fields::BALSARA, b));
        if viscosity.dissipation.switches() {
            alpha = 0.5 * (gas.get(fields::ALPHA, a) + gas.get(fields::ALPHA, b));
        }
        if viscosity.dissipation.reconstructs() {
            let slope_a = dot(x_ab, gas.apply(fields::STRAIN_RATE, a, x_ab));
            let slope_b = dot(x_ab, gas.apply(fields::STRAIN_RATE, b, x_ab));
            let f = slope_a / slope_b;
            let limiter = (4.0 * f / ((1.0 + f) * (1.0 + f))).clamp(0.0, 1.0);
            let share = match viscosity.dissipation {
                Dissipation::AvSlr | Dissipation::AvSwSlr => 1.0,
                Dissipation::AvSlrB => 1.0 - balsara_ab(),
                _ => 1.0 - balsara_ab().powi(2),
            };
            let q = (r / h_a).min(r / h_b);
            let kappa = |this: usize| {
                let q_crit = gas.get(fields::CRITICAL_SEPARATION, this);
                if q < q_crit { (-((q - q_crit) / 0.2).powi(2)).exp() } else { 1.0 }
            };
            let (phi_ab, phi_ba) = (limiter * kappa(a) * share, limiter * kappa(b) * share);
            omega_prime = omega - (phi_ab * slope_a + phi_ba * slope_b) / (2.0 * r);
            omega_size += (phi_ab * slope_a.abs() + phi_ba * slope_b.abs()) / (2.0 * r);
            limited = phi_ab > 0.0 && phi_ab < 1.0;
            if [Dissipation::AvSlrB2F, Dissipation::AvSlrBStar2F].contains(&viscosity.dissipation) {
                alpha *= balsara_ab().max(0.5);
            }
        }
        if viscosity.form == ApproachForm::Regularised {
            // mu of the velocity that the scheme uses: v . r = omega r.
            let h = 0.5 * (h_a + h_b);
            let weight = h * r / (r * r + 0.01 * h * h);
            (omega_prime, omega_size) = (omega_prime * weight, omega_size * weight);
        }
        let (c_mean, rho_mean) = (0.5 * (c_a + c_b), 0.5 * (rho_a + rho_b));
        let viscous = match omega_prime < 0.0 {
            true => (-alpha * c_mean * omega_prime + viscosity.beta * omega_prime.powi(2)) / rho_mean,
            false => 0.0,
        };
        let limiter = if viscosity.dissipation == Dissipation::AvB { balsara_ab() } else { 1.0 };
        let viscous = limiter * viscous;
        let viscous_size = (alpha * c_mean * omega_size + 2.0 * viscosity.beta * omega_size.powi(2)) / rho_mean;

        let (mut work, mut work_size) = (0.0, 0.0);
        for i in 0..D {
            let mean = 0.5 * (gradient_a[i] + gradient_b[i]);
            motion.acceleration[i] -= m_b * (y_a * gradient_a[i] + y_b * gradient_b[i] + viscous * mean);
            work += m_b * (y_a * v_ab[i] * gradient_a[i] + 0.5 * viscous * v_ab[i] * mean);
            let mean_size = 0.5 * (gradient_a[i].abs() + gradient_b[i].abs());
            let own = y_a * gradient_a[i].abs();
            motion.force_size += m_b * (own + y_b * gradient_b[i].abs() + viscous_size * mean_size);
            work_size += m_b * v_ab[i].abs() * (own + 0.5 * viscous_size * mean_size);
        }
        motion.heating += work;
        motion.heating_size += work_size;
        motion.largest_signal = motion.largest_signal.max(c_a + c_b - 3.0 * omega.min(0.0));
        let kinds = [limited, sigma > 0.0 && sigma < 1.0, sigma == 1.0, r >= 2.0 * h_a];
        for (count, is) in motion.kinds.iter_mut().zip(kinds) {
            *count += usize::from(is);
        }
    }
    motion
}

fn sweep_is_as_printed<const D: usize>(viscosity: Viscosity, grad_h: GradH) {
    let set = Recipe::unequal::<D>(71).particles::<D>(true);
    let dissipation = viscosity.dissipation;
    let physics = Physics { viscosity, ..physics(dissipation, grad_h) };
    let mut engine = PlainEngine::<f64, D>::new(&set);
    engine.find_neighbours(2.0).unwrap();
    let pipeline = Pipeline::of_scene::<D>(&physics);
    pipeline.start(&mut engine, physics).unwrap();
    pipeline.run(&mut engine, physics).unwrap();
    let columns =
        pipeline.fields::<D>().into_iter().filter_map(|field| Some((field, engine.read_all(field).ok()?))).collect();
    let gas = Gas::<D> { columns, coordinates: std::array::from_fn(|axis| set.coordinates(axis)) };
    let mut kinds = [0; 4];
    for a in 0..set.len() {
        let due = as_printed(&gas, a, set.len(), &physics.viscosity);
        let neighbours = engine.neighbours().of(a).len();
        // In units of the sums of magnitudes: kernels 250 (see there), q and kappa 100 (the exponent, up to 12, with
        // 4u, and 16u absolute), powers and products 60, on both sides; and a sum.
        let relative = 2.0 * gamma(neighbours + 410, UNIT);
        let what = |name: &str| format!("{name} of particle {a}, {dissipation}, {grad_h}, {D}-D");
        let acceleration: [f64; D] = gas.vector(fields::ACCELERATION, a);
        for (i, &got) in acceleration.iter().enumerate() {
            assert_close(&what("acceleration"), got, due.acceleration[i], relative * due.force_size);
        }
        let rate = gas.get(fields::ENERGY_RATE, a);
        assert_close(&what("heating"), rate, due.heating, relative * due.heating_size);

        // The step, from the rates just checked.
        let p = &set.particles()[a];
        let signal = due.largest_signal.max(2.0 * gas.get(fields::SOUND_SPEED, a));
        let courant = 0.4 * p.smoothing_length / signal;
        let force = 0.25 * (p.smoothing_length / dot(acceleration, acceleration).sqrt()).sqrt();
        let cooling = if rate < 0.0 { 0.5 * p.internal_energy / -rate } else { f64::INFINITY };
        let step = courant.min(force).min(cooling);
        assert_close(&what("time step"), gas.get(fields::TIME_STEP, a), step, 40.0 * UNIT * step);
        for (total, more) in kinds.iter_mut().zip(due.kinds) {
            *total += more;
        }
    }
    let [limited, ramp, crossed, other_only] = kinds;
    assert!(!dissipation.reconstructs() || limited > 10, "{limited} limited pairs");
    assert!(ramp > 10 && crossed > 10 && other_only > 10, "pairs of each kind: {kinds:?}");
}

#[test]
fn momentum_and_energy_are_as_printed() {
    for &dissipation in Dissipation::ALL {
        let viscosity = Viscosity::of(dissipation);
        for grad_h in [GradH::Exact, GradH::Corrected] {
            sweep_is_as_printed::<1>(viscosity, grad_h);
            sweep_is_as_printed::<2>(viscosity, grad_h);
        }
        sweep_is_as_printed::<3>(viscosity, GradH::Corrected);
    }
}

/// The classical velocity of approach under any scheme; with AVSLRB2F it is (27) to the letter.
#[test]
fn classical_forms_are_as_printed() {
    for dissipation in [Dissipation::Av, Dissipation::AvSlrB2F, Dissipation::AvSwSlr] {
        let viscosity = Viscosity { form: ApproachForm::Regularised, ..Viscosity::of(dissipation) };
        sweep_is_as_printed::<1>(viscosity, GradH::Corrected);
        sweep_is_as_printed::<3>(viscosity, GradH::Corrected);
    }
}

#[test]
fn walls_do_not_move() {
    let cloud = Recipe::unequal::<2>(73).particles::<2>(true);
    let some = |(i, p): (usize, &Particle<2>)| Particle { mobile: i % 3 != 0, ..*p };
    let set = ParticleSet::new(*cloud.domain(), cloud.particles().iter().enumerate().map(some).collect()).unwrap();
    let physics = physics(Dissipation::AvSlrB2, GradH::Corrected);
    let run = |set: &ParticleSet<2>| {
        let mut engine = PlainEngine::<f64, 2>::new(set);
        engine.find_neighbours(2.0).unwrap();
        Pipeline::of_scene::<2>(&physics).run(&mut engine, physics).unwrap();
        (engine.read_all(fields::ACCELERATION).unwrap(), engine.read_scalar(fields::ENERGY_RATE).unwrap())
    };
    let (free, walled) = (run(&cloud), run(&set));
    for (a, p) in set.particles().iter().enumerate() {
        for axis in 0..2 {
            let due = if p.mobile { free.0[axis][a] } else { 0.0 };
            assert_eq!(walled.0[axis][a], due, "acceleration of particle {a}");
        }
        assert_eq!(walled.1[a], if p.mobile { free.1[a] } else { 0.0 }, "heating of particle {a}");
    }
}

/// A record from its numbers in order.
fn record<Q: Quantity<f64>>(values: &[f64]) -> Q {
    let mut next = values.iter();
    let record = Q::from_each(|| *next.next().unwrap());
    assert!(next.next().is_none(), "a number too many");
    record
}
fn numbers<Q: Quantity<f64>>(record: Q) -> Vec<f64> {
    let mut values = Vec::new();
    record.for_each(|value| values.push(value));
    values
}

/// The shortest of the three steps is taken, whichever it is.
#[test]
fn time_step_is_the_shortest_of_three() {
    let sweep = Momentum(physics(Dissipation::Av, GradH::Corrected));
    // h = 2, c = 3, u = 10; of the rest nothing matters here: m, 1/h, v, rho, rho0, c, Y, c_xx, u, mobility.
    let own: <Momentum as Pass<1>>::Own<f64> = record(&[1.0, 0.5, 0.0, 1.0, 1.0, 3.0, 0.0, 0.0, 10.0, 1.0]);
    let step = |acceleration: f64, heating: f64, signal: f64| {
        let sums = record(&[acceleration, heating, signal]);
        numbers(<Momentum as Pass<1>>::finish(&sweep, &own, &sums))[2]
    };
    // 0.4 h / v_sig; without neighbours twice the particle's own sound speed.
    assert_eq!(step(0.0, 0.0, 8.0), 0.1);
    assert_close("alone", step(0.0, 0.0, 0.0), 0.8 / 6.0, UNIT);
    // 0.25 sqrt(2 / 800) and 0.5 * 10 / 1000; heating is no reason to hurry.
    assert_eq!(step(-800.0, 0.0, 8.0), 0.0125);
    assert_eq!(step(0.0, -1000.0, 8.0), 0.005);
    assert_eq!(step(0.0, 1000.0, 8.0), 0.1);

    // Particles that fly apart send signals at the sum of their sound speeds, no slower: c_b = 5, v_ab along x_ab.
    let other = |velocity: f64| record(&[1.0, 0.5, velocity, 1.0, 1.0, 5.0, 0.0, 0.0]);
    let at = Separation { x_ab: Vector([1.0]), r_squared: 1.0 };
    let signal = |velocity: f64| numbers(<Momentum as Pass<1>>::pair(&sweep, &own, &other(velocity), &at))[2];
    assert_eq!(signal(-2.0), 8.0);
    assert_eq!(signal(2.0), 14.0);
}

/// `v_half = v + a dt/2`, `dx = v_half dt`, `v = v_half + a dt/2`; and back to the mean of the old and new rates.
#[test]
fn kick_drift_kick_of_whole_numbers() {
    // h, settled h, 1/h, V, Omega, mobility, v, u, a, du/dt; M4 in 1-D holds 4 h / V = 8 neighbours where 4 are wanted: h = 1
    // would be right, with Omega = 2 that is 1.5, half as much again as before, and a quarter is as far as the change is carried on.
    let four = Physics { neighbours: 4.0, ..physics(Dissipation::Av, GradH::Corrected) };
    let kick = |mobility: f64| {
        let own = record(&[2.0, 1.0, 0.5, 1.0, 2.0, mobility, 10.0, 100.0, 4.0, 8.0]);
        numbers(<KickDrift as Update<1>>::apply(&KickDrift(four), &own, 0.5))
    };
    // h, settled h, v, u, old a, old du/dt, dx
    assert_eq!(kick(1.0), [1.875, 1.5, 12.0, 104.0, 4.0, 8.0, 5.5]);
    assert_eq!(kick(0.0)[6], 0.0, "a wall stays where it is");
    assert_eq!(kick(0.0)[0], 2.0, "a wall keeps its smoothing length");
    // v, u, a, du/dt, old a, old du/dt
    let own = record(&[12.0, 104.0, 6.0, 2.0, 4.0, 8.0]);
    assert_eq!(numbers(<Correct as Update<1>>::apply(&Correct, &own, 0.5)), [12.5, 102.5]);
}
