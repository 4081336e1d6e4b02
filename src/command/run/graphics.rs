//! The graphics adapter: found before anything runs, so that a missing one is said first.

use super::progress::Progress;
use super::simulate::{Finished, Task};
use crate::command::failure::Failure;
use crate::command::restarts::Restart;
use etalon_reference::particles::ParticleSet;

/// An adapter, or why there is none.
pub struct Graphics {
    #[cfg(feature = "wgpu")]
    device: Result<etalon_wgpu::Device, String>,
}

#[cfg(feature = "wgpu")]
impl Graphics {
    /// Opens the adapter whose name contains `name`, or else the best there is, if one is `wanted` at all.
    pub fn find(name: Option<&str>, wanted: bool) -> Self {
        let device = match wanted {
            true => etalon_wgpu::open(name).map_err(|error| error.to_string()),
            false => Err("it was not asked for".into()),
        };
        Graphics { device }
    }

    /// Why nothing can be run, if so.
    pub fn absent(&self) -> Option<&str> {
        self.device.as_ref().err().map(String::as_str)
    }

    /// The adapter's name.
    pub fn adapter(&self) -> Option<String> {
        self.device.as_ref().ok().map(|device| device.adapter().to_string())
    }

    /// Runs a task on the adapter.
    pub fn run<const D: usize>(
        &self,
        task: &Task<'_, D>,
        set: &ParticleSet<D>,
        progress: Progress,
        restart: Option<Restart>,
    ) -> Result<Finished, Failure> {
        let device = self.device.clone().map_err(Failure::BadInput)?;
        let fields = etalon_reference::pipeline::Pipeline::of_scene::<D>(&task.physics).fields::<D>();
        task.simulate(etalon_wgpu::WgpuEngine::<D>::new(set, &fields, device)?, set.domain(), progress, restart)
    }
}

#[cfg(not(feature = "wgpu"))]
impl Graphics {
    const ABSENT: &'static str =
        "this program was built without graphics; build it with `--features wgpu`, or use `--backend simd`";

    /// Nothing to look for.
    pub fn find(_: Option<&str>, _: bool) -> Self {
        Graphics {}
    }

    /// Why nothing can be run.
    pub fn absent(&self) -> Option<&str> {
        Some(Self::ABSENT)
    }

    /// There is none.
    pub fn adapter(&self) -> Option<String> {
        None
    }

    /// Refuses.
    pub fn run<const D: usize>(
        &self,
        _: &Task<'_, D>,
        _: &ParticleSet<D>,
        _: Progress,
        _: Option<Restart>,
    ) -> Result<Finished, Failure> {
        Err(Failure::BadInput(Self::ABSENT.into()))
    }
}
