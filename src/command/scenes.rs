//! `etalon scenes`: what can be run, and the names that options take; or one scene as a file.

use super::arguments::ScenesArguments;
use super::choices::{Backend, Precision};
use super::failure::Failure;
use super::scene_file;
use etalon_reference::scenes::{Arrangement, Name, Problem};
use etalon_reference::schemes::{Dissipation, GradH, Gradients, Kernel, Rung, VolumeElement};
use serde_json::json;

/// The list for people or as JSON, or the file.
pub fn scenes(arguments: &ScenesArguments) -> Result<String, Failure> {
    match arguments.scene {
        Some(name) => file(name, arguments.dim),
        None if arguments.json => as_json(),
        None => text(),
    }
}

/// A scene with everything spelled out.
fn file(name: Name, dimension: Option<usize>) -> Result<String, Failure> {
    let dimension = dimension.unwrap_or(name.dimensions()[0]);
    let problem = name.standard(dimension)?;
    scene_file::text(&problem, dimension, problem.end_time())
        .map_err(|error| Failure::Broken(format!("the scene has no TOML form: {error}")))
}

/// The usual choices in each dimension.
fn standards(name: Name) -> Result<Vec<Problem>, Failure> {
    name.dimensions().iter().map(|&dimension| Ok(name.standard(dimension)?)).collect()
}

fn names<T: std::fmt::Display>(all: &[T]) -> Vec<String> {
    all.iter().map(ToString::to_string).collect()
}

fn as_json() -> Result<String, Failure> {
    let mut scenes = Vec::new();
    for &name in Name::ALL {
        let standards = standards(name)?;
        scenes.push(json!({
            "name": name.name(),
            "title": name.title(),
            "source": name.source(),
            "dimensions": name.dimensions(),
            "default_particles": standards.iter().map(|p| p.method().particles).collect::<Vec<_>>(),
            "default_neighbours": standards.iter().map(|p| p.method().neighbours).collect::<Vec<_>>(),
            "default_end_time": standards[0].end_time(),
            "exact_solution": name.solution(),
        }));
    }
    super::to_text(&json!({
        "schema": "etalon-scenes",
        "schema_version": 1,
        "scenes": scenes,
        "schemes": names(Dissipation::ALL),
        "kernels": names(Kernel::ALL),
        "grad_h": names(GradH::ALL),
        "gradients": names(Gradients::ALL),
        "volume_elements": names(VolumeElement::ALL),
        "rungs": names(Rung::ALL),
        "starts": names(Arrangement::ALL),
        "backends": names(Backend::ALL),
        "precisions": names(Precision::ALL),
    }))
}

fn text() -> Result<String, Failure> {
    let widest = Name::ALL.iter().map(|name| name.name().len()).max().unwrap_or(0);
    let mut out = String::new();
    for &name in Name::ALL {
        let standards = standards(name)?;
        let list = |of: &dyn Fn(&Problem) -> String| standards.iter().map(of).collect::<Vec<_>>().join(", ");
        let dimensions: Vec<String> = name.dimensions().iter().map(|d| format!("{d}-D")).collect();
        out += &format!(
            "{name:<widest$}  {} in {} ({}); compared with: {}\n{:widest$}  particles {}; neighbours {}; to t = {}\n",
            name.title(),
            dimensions.join(", "),
            name.source(),
            name.solution(),
            "",
            list(&|p| p.method().particles.to_string()),
            list(&|p| p.method().neighbours.to_string()),
            standards[0].end_time(),
        );
    }
    let options = [
        ("scheme", names(Dissipation::ALL)),
        ("kernel", names(Kernel::ALL)),
        ("grad-h", names(GradH::ALL)),
        ("start", names(Arrangement::ALL)),
        ("backend", names(Backend::ALL)),
        ("precision", names(Precision::ALL)),
    ];
    out += "\n`etalon scenes NAME` prints a scene as a file to copy, change and run.\n\n";
    for (option, names) in options {
        out += &format!("--{option:<11} {}\n", names.join(", "));
    }
    let settings = [
        ("gradients", names(Gradients::ALL)),
        ("volume_elements", names(VolumeElement::ALL)),
        ("rung", names(Rung::ALL)),
    ];
    for (key, names) in settings {
        out += &format!("--set method.{key}={}\n", names.join("|"));
    }
    Ok(out)
}
