//! The three problems of gas and dust: the box, the wave and the tube.

use super::{Dusty, GasAndDust, Kind};
use crate::exact::dustyshock::gas_of;
use crate::particles::ParticleSet;
use crate::scenes::DustySceneError;
use crate::scenes::dustybox::{self, DustyBox};
use crate::scenes::dustyshock::{self, DustyShock};
use crate::scenes::dustywave::{self, DustyWave};

/// DUSTYBOX: gas and dust that flow through each other until drag has made them one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct InABox;

impl InABox {
    fn of(scene: &Dusty<Self>, dimension: usize) -> DustyBox {
        let across = (scene.method.particles as f64 / 2.0).powf(1.0 / dimension as f64).round() as usize;
        DustyBox {
            across,
            dust_density: scene.dust_to_gas,
            gamma: scene.gamma,
            drag: scene.drag(),
            kernel: scene.method.kernel,
            neighbours: scene.method.neighbours,
            dissipation: scene.method.viscosity.dissipation,
            ..DustyBox::standard(dimension)
        }
    }
}

impl Kind for InABox {
    const NAME: &'static str = "dustybox";
    const TITLE: &'static str = "Gas and dust in a box";
    const SOURCE: &'static str = "Laibe & Price 2011; PHANTOM's unit test";
    const SOLUTION: &'static str = "exponential decay of the velocity difference";
    const DRAG: f64 = dustybox::DRAG_COEFFICIENT;
    const END_TIME: f64 = dustybox::END_TIME;
    const PARTICLES: [usize; 3] = [128, 1_152, 3_456];
    const START: &'static str = "even gas at rest, even dust in motion";
    const BOUNDARIES: &'static str = "periodic";

    fn particles<const D: usize>(scene: &Dusty<Self>) -> Result<ParticleSet<D>, DustySceneError> {
        Self::of(scene, D).particles::<D>()
    }
    fn solution(scene: &Dusty<Self>, time: f64) -> Result<GasAndDust, DustySceneError> {
        let inner = Self::of(scene, 1);
        let exact = inner.exact()?;
        let (gas, dust) = exact.velocities(time);
        // All the heat stays in the gas, evenly.
        let warm = inner.sound_speed * inner.sound_speed / (inner.gamma * (inner.gamma - 1.0));
        let energy = warm + exact.heat(time) / inner.gas_density;
        let pressure = (inner.gamma - 1.0) * inner.gas_density * energy;
        let state = [inner.gas_density, gas, pressure, energy];
        Ok(GasAndDust { gas: Box::new(move |_| state), dust_velocity: Box::new(move |_| dust), jumps: Vec::new() })
    }
}

/// DUSTYWAVE: a sound wave in gas with as much dust.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct InAWave;

/// Rows across the wave in two and three dimensions (PL20 section 3.1).
const WAVE_ROWS: usize = 12;

impl InAWave {
    fn of(scene: &Dusty<Self>, dimension: usize) -> DustyWave {
        DustyWave {
            particles: scene.along(dimension, WAVE_ROWS),
            rows: WAVE_ROWS,
            dust_density: scene.dust_to_gas,
            gamma: scene.gamma,
            drag: scene.drag(),
            kernel: scene.method.kernel,
            neighbours: scene.method.neighbours,
            dissipation: scene.method.viscosity.dissipation,
            ..DustyWave::standard(dimension)
        }
    }
}

impl Kind for InAWave {
    const NAME: &'static str = "dustywave";
    const TITLE: &'static str = "Sound wave in gas with dust";
    const SOURCE: &'static str = "PL20, section 3.1";
    const SOLUTION: &'static str = "linear wave of two fluids";
    const DRAG: f64 = dustywave::DRAG_COEFFICIENT;
    const END_TIME: f64 = dustywave::END_TIME;
    const PARTICLES: [usize; 3] = [256, 3_072, 36_864];
    const START: &'static str = "velocities, densities and energy in phase, with an amplitude of 1e-6";
    const BOUNDARIES: &'static str = "periodic";

    fn particles<const D: usize>(scene: &Dusty<Self>) -> Result<ParticleSet<D>, DustySceneError> {
        Self::of(scene, D).particles::<D>()
    }
    fn solution(scene: &Dusty<Self>, time: f64) -> Result<GasAndDust, DustySceneError> {
        let inner = Self::of(scene, 1);
        let (exact, start) = (inner.exact()?, inner.initial());
        let (density, gamma) = (inner.gas_density, inner.gamma);
        let quiet = inner.sound_speed * inner.sound_speed / (gamma * (gamma - 1.0));
        let gas = move |x: f64| {
            let wave = exact.at(x, time, start);
            let rho = density * (1.0 + wave.gas_density);
            // Along the adiabat: the heat of drag is of second order.
            let energy = quiet * (1.0 + (gamma - 1.0) * wave.gas_density);
            [rho, wave.gas_velocity, (gamma - 1.0) * rho * energy, energy]
        };
        let exact = inner.exact()?;
        let dust_velocity = move |x: f64| exact.at(x, time, start).dust_velocity;
        Ok(GasAndDust { gas: Box::new(gas), dust_velocity: Box::new(dust_velocity), jumps: Vec::new() })
    }
}

/// DUSTYSHOCK: Sod's tube with dust.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct InATube;

/// Rows across the tube's dense side in two and three dimensions (PL20 section 3.2).
const TUBE_ROWS: usize = 24;
/// Of the particles of a tube, what share is left of the interface: eight ninths.
const LEFT: f64 = 8.0 / 9.0;

impl InATube {
    fn of(scene: &Dusty<Self>, dimension: usize) -> DustyShock {
        DustyShock {
            particles: (scene.along(dimension, TUBE_ROWS) as f64 * LEFT).round() as usize,
            rows: TUBE_ROWS,
            dust_to_gas: scene.dust_to_gas,
            gamma: scene.gamma,
            drag: scene.drag(),
            kernel: scene.method.kernel,
            neighbours: scene.method.neighbours,
            dissipation: scene.method.viscosity.dissipation,
        }
    }
}

impl Kind for InATube {
    const NAME: &'static str = "dustyshock";
    const TITLE: &'static str = "Shock tube of gas and dust";
    const SOURCE: &'static str = "PL20, section 3.2";
    const SOLUTION: &'static str = "Riemann problem of the mixture, for instant coupling";
    const DRAG: f64 = dustyshock::DRAG_COEFFICIENT;
    const END_TIME: f64 = dustyshock::END_TIME;
    const PARTICLES: [usize; 3] = [288, 6_912, 165_888];
    const START: &'static str = "sharp; the dust rests with the gas";
    const BOUNDARIES: &'static str = "fixed layers of gas and dust at both ends, periodic across";

    fn particles<const D: usize>(scene: &Dusty<Self>) -> Result<ParticleSet<D>, DustySceneError> {
        Self::of(scene, D).particles::<D>()
    }
    fn solution(scene: &Dusty<Self>, time: f64) -> Result<GasAndDust, DustySceneError> {
        let inner = Self::of(scene, 1);
        let (exact, ratio, less) = (inner.exact()?, inner.dust_to_gas, inner.gamma - 1.0);
        // A ratio that no mixture has is refused here, not at each place.
        inner.gas_at(0.0, time)?;
        let waves = [exact.left_wave(), exact.right_wave()].into_iter().flatten().filter_map(|wave| wave.shock());
        let jumps =
            exact.contact().into_iter().chain(waves).map(|speed| dustyshock::INTERFACE + speed * time).collect();
        let sample = move |x: f64| exact.sample((x - dustyshock::INTERFACE) / time);
        let again = inner.exact()?;
        let gas = move |x: f64| {
            let Ok(gas) = gas_of(sample(x), ratio) else { return [f64::NAN; 4] };
            [gas.density, gas.velocity, gas.pressure, gas.pressure / (less * gas.density)]
        };
        let dust_velocity = move |x: f64| again.sample((x - dustyshock::INTERFACE) / time).velocity;
        Ok(GasAndDust { gas: Box::new(gas), dust_velocity: Box::new(dust_velocity), jumps })
    }
    fn pushed(_: &Dusty<Self>, _: f64) -> bool {
        true
    }
    fn behind_shock(scene: &Dusty<Self>) -> Option<f64> {
        Self::of(scene, 1).exact().ok()?.contact()
    }
}
