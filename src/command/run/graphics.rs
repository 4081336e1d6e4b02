//! The graphics adapter: found before anything runs, so that a missing one is said first.

use super::progress::Progress;
use super::simulate::{Finished, Task};
use crate::command::failure::Failure;
use etalon_reference::particles::ParticleSet;

#[cfg(feature = "wgpu")]
use super::timed::Timed;
#[cfg(feature = "wgpu")]
use etalon_reference::pipeline::Pipeline;
#[cfg(feature = "wgpu")]
use etalon_wgpu::{AdapterPreference, Device, WgpuEngine};

/// An adapter, or why there is none.
#[cfg(feature = "wgpu")]
pub struct Graphics {
    preference: AdapterPreference,
    found: Result<String, String>,
}

#[cfg(feature = "wgpu")]
impl Graphics {
    /// Looks for an adapter whose name contains `name`; without a name, for the one the environment names, or the best.
    pub fn find(name: Option<&str>) -> Self {
        let preference = match name {
            Some(name) => AdapterPreference::Named(name.to_string()),
            None => AdapterPreference::from_environment(),
        };
        let found = Device::open(preference.clone()).map(|device| device.adapter().name.clone());
        Graphics { preference, found: found.map_err(|error| error.to_string()) }
    }
    /// Why nothing can be run, if so.
    pub fn absent(&self) -> Option<&str> {
        self.found.as_ref().err().map(String::as_str)
    }
    /// The adapter's name.
    pub fn adapter(&self) -> Option<String> {
        self.found.as_ref().ok().cloned()
    }
    /// Runs a task.
    pub fn run<const D: usize>(
        &self,
        task: &Task,
        set: &ParticleSet<D>,
        progress: Progress,
    ) -> Result<Finished, Failure> {
        let device = Device::open(self.preference.clone()).map_err(|error| Failure::BadInput(error.to_string()))?;
        let fields = Pipeline::of_scene::<D>(&task.physics).fields::<D>();
        let engine = WgpuEngine::<D>::new(set, &fields, device).map_err(|e| Failure::Broken(e.to_string()))?;
        task.simulate(Timed::new(engine), set, progress)
    }
}

/// What stands in for an adapter where graphics were left out.
#[cfg(not(feature = "wgpu"))]
pub struct Graphics;

#[cfg(not(feature = "wgpu"))]
impl Graphics {
    /// There is none.
    pub fn find(_name: Option<&str>) -> Self {
        Graphics
    }
    /// Why nothing can be run.
    pub fn absent(&self) -> Option<&str> {
        Some("this program was built without the feature `wgpu`; build it with its default features, or use `--backend simd`")
    }
    /// The adapter's name.
    pub fn adapter(&self) -> Option<String> {
        None
    }
    /// Refuses.
    pub fn run<const D: usize>(&self, _: &Task, _: &ParticleSet<D>, _: Progress) -> Result<Finished, Failure> {
        Err(Failure::BadInput(self.absent().unwrap_or_default().to_string()))
    }
}
