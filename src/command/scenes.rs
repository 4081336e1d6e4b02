//! `etalon scenes`: what there is to choose from.

use super::choices::{Backend, Precision, SceneName, Start};
use super::failure::Failure;
use etalon_reference::scenes::sod::{self, Sod};
use etalon_reference::schemes::{Dissipation, GradH, Kernel};
use serde_json::json;

/// The scenes and the names that options take, for people or as JSON.
pub fn scenes(as_json: bool) -> Result<String, Failure> {
    let defaults: Vec<Sod> = (1..=3).map(Sod::standard).collect();
    let schemes: Vec<&str> = Dissipation::ALL.iter().filter(|s| !s.knows_waves()).map(|s| s.name()).collect();
    let kernels: Vec<&str> = Kernel::ALL.iter().map(|k| k.name()).collect();
    let grad_h: Vec<&str> = GradH::ALL.iter().map(|g| g.name()).collect();
    let backends: Vec<&str> = Backend::ALL.iter().map(|b| b.name()).collect();
    let precisions: Vec<&str> = Precision::ALL.iter().map(|p| p.name()).collect();
    let starts: Vec<&str> = Start::ALL.iter().map(|s| s.name()).collect();
    if as_json {
        let scenes: Vec<_> = SceneName::ALL
            .iter()
            .map(|scene| match scene {
                SceneName::Sod => json!({
                    "name": scene.name(),
                    "title": "Sod shock tube",
                    "source": "GS25, section 3.1",
                    "dimensions": [1, 2, 3],
                    "default_particles": defaults.iter().map(|s| s.particles).collect::<Vec<_>>(),
                    "default_neighbours": defaults.iter().map(|s| s.neighbours).collect::<Vec<_>>(),
                    "default_end_time": sod::END_TIME,
                    "exact_solution": "Riemann problem",
                }),
            })
            .collect();
        return super::to_text(&json!({
            "schema": "etalon-scenes",
            "schema_version": 1,
            "scenes": scenes,
            "schemes": schemes,
            "kernels": kernels,
            "grad_h": grad_h,
            "starts": starts,
            "backends": backends,
            "precisions": precisions,
        }));
    }
    let list = |of: &dyn Fn(&Sod) -> String| defaults.iter().map(of).collect::<Vec<_>>().join(", ");
    Ok(format!(
        "sod  Sod shock tube in 1, 2 or 3 dimensions (GS25, section 3.1), against the exact Riemann solution\n\
         \x20    particles {}; neighbours {}; to t = {}\n\
         \n\
         --scheme      {}\n\
         --kernel      {}\n\
         --grad-h      {}\n\
         --start       {}\n\
         --backend     {}\n\
         --precision   {}\n",
        list(&|s| s.particles.to_string()),
        list(&|s| s.neighbours.to_string()),
        sod::END_TIME,
        schemes.join(", "),
        kernels.join(", "),
        grad_h.join(", "),
        starts.join(", "),
        backends.join(", "),
        precisions.join(", "),
    ))
}
