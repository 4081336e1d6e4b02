//! `etalon explain`: what a step of a scene does, read off the passes themselves.

mod passes;
mod text;

use super::arguments::ExplainArguments;
use super::choices::{Backend, Precision};
use super::failure::Failure;
use super::memory::Memory;
use super::run::plan;
use super::setup::Setup;
use etalon_kernels_gen::{Field, components};
use etalon_reference::passes::Physics;
use etalon_reference::pipeline::Pipeline;
use etalon_reference::scenes::Method;
use passes::{Stage, stages};
use serde_json::{Value, json};

/// Operations of one particle in one step with so many neighbours, counted from the graph.
pub fn work_per_update<const D: usize>(
    pipeline: &Pipeline,
    physics: Physics,
    precision: Precision,
    neighbours: f64,
) -> Result<f64, Failure> {
    let k = match precision {
        Precision::Single => 0,
        Precision::Double => 1,
    };
    let each = stages::<D>(pipeline, physics)?.into_iter().map(|stage| {
        let pairs = stage.pair.map_or(0.0, |pair| f64::from(pair[k].flops()) * neighbours);
        pairs + f64::from(stage.particle[k].flops())
    });
    Ok(each.sum())
}

/// Everything that is shown of a scene.
struct Explanation {
    setup: Setup,
    stages: Vec<Stage>,
    fields: Vec<Field>,
    memory: Vec<(Backend, Precision, Memory)>,
}

/// The explanation, for people or as JSON.
pub fn explain(arguments: &ExplainArguments) -> Result<String, Failure> {
    let scene = &arguments.scene;
    let setup = Setup::new(scene)?;
    let explanation = match setup.dimension {
        1 => Explanation::of::<1>(setup, scene.backend, scene.precision),
        2 => Explanation::of::<2>(setup, scene.backend, scene.precision),
        _ => Explanation::of::<3>(setup, scene.backend, scene.precision),
    }?;
    if arguments.json { super::to_text(&explanation.json()) } else { Ok(text::text(&explanation)) }
}

impl Explanation {
    fn of<const D: usize>(
        setup: Setup,
        backend: Option<Backend>,
        precision: Option<Precision>,
    ) -> Result<Self, Failure> {
        let physics = setup.physics();
        let pipeline = Pipeline::of_scene::<D>(&physics);
        let memory = plan::chosen(backend, precision)?.into_iter().map(|(backend, precision)| {
            (backend, precision, Memory::of::<D>(backend, precision, &pipeline, setup.method().neighbours))
        });
        let memory = memory.collect();
        Ok(Explanation { setup, stages: stages::<D>(&pipeline, physics)?, fields: pipeline.fields::<D>(), memory })
    }

    fn numbers(&self) -> usize {
        components(&self.fields, self.setup.dimension).len()
    }

    /// Operations of one pair in all passes, by precision.
    fn work_per_pair(&self) -> [u32; 2] {
        [0, 1].map(|k| self.stages.iter().filter_map(|stage| Some(stage.pair?[k].flops())).sum())
    }

    fn json(&self) -> Value {
        let Method { particles, kernel, neighbours, viscosity, grad_h, gradients, volume_element, .. } =
            *self.setup.method();
        let field = |field: &Field| {
            json!({
                "name": field.name,
                "symbol": field.symbol,
                "unit": field.unit,
                "numbers": field.rank.components(self.setup.dimension),
            })
        };
        let names = |fields: &[Field]| fields.iter().map(|f| f.name).collect::<Vec<_>>();
        let stages: Vec<Value> = self
            .stages
            .iter()
            .map(|stage| {
                let mut entry = json!({
                    "name": stage.footprint.name,
                    "kind": if stage.pair.is_some() { "pass" } else { "update" },
                    "reads_own": names(&stage.footprint.own),
                    "reads_neighbours": names(&stage.footprint.other),
                    "sums": names(&stage.footprint.sums),
                    "writes": names(&stage.footprint.out),
                    "operations_per_particle": { "f32": stage.particle[0].flops(), "f64": stage.particle[1].flops() },
                });
                if let Some([single, double]) = stage.pair {
                    entry["operations_per_pair"] = json!({ "f32": single.flops(), "f64": double.flops() });
                }
                entry
            })
            .collect();
        let memory: Vec<Value> = self
            .memory
            .iter()
            .map(|(backend, precision, memory)| {
                json!({
                    "backend": backend.name(),
                    "precision": precision.name(),
                    "fields": memory.fields,
                    "copy": memory.copy,
                    "places": memory.places,
                    "records": memory.records,
                    "neighbours": memory.neighbours,
                    "total": memory.total(),
                })
            })
            .collect();
        let [single, double] = self.work_per_pair();
        json!({
            "schema": "etalon-explain",
            "schema_version": 1,
            "scene": self.setup.problem.name().name(),
            "dimension": self.setup.dimension,
            "particles": particles,
            "neighbours": neighbours,
            "kernel": kernel.name(),
            "scheme": viscosity.dissipation.name(),
            "grad_h": grad_h.name(),
            "gradients": gradients.name(),
            "volume_elements": volume_element.name(),
            "gamma": self.setup.physics().gamma_minus_one + 1.0,
            "stages": stages,
            "fields": self.fields.iter().map(field).collect::<Vec<_>>(),
            "numbers_per_particle": self.numbers(),
            "operations_per_pair": { "f32": single, "f64": double },
            "bytes_per_particle": memory,
        })
    }
}
