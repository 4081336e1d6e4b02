//! `etalon emit`: the kernels of a scene as text in another language, to read or to carry to other hardware.
//!
//! The text is printed from the drawings that the passes make of themselves, so it is what the backends run.

use super::arguments::EmitArguments;
use super::choices::{Precision, Target};
use super::failure::Failure;
use super::setup::Setup;
use etalon_kernels_gen::emit::{Header, MulAdd, c};
use etalon_kernels_gen::trace::{Double, Drawing, PassDrawing, Single, UpdateDrawing};
use etalon_kernels_gen::{Pass, Update};
use etalon_reference::pipeline::{PassVisitor, Pipeline, UpdateVisitor};
use std::fs;

/// Where the definitions of all passes are to be read.
const DEFINITION: &str = "reference/src/passes";

/// A pass or an update as text.
struct Text {
    name: &'static str,
    text: String,
}

/// The texts, one after the other, or the names of the files they went to.
pub fn emit(arguments: &EmitArguments) -> Result<String, Failure> {
    let setup = Setup::new(&arguments.scene)?;
    let texts = match setup.dimension {
        1 => texts::<1>(arguments, &setup),
        2 => texts::<2>(arguments, &setup),
        _ => texts::<3>(arguments, &setup),
    }?;
    let names: Vec<&str> = texts.iter().map(|text| text.name).collect();
    if let Some(wanted) = arguments.pass.as_deref().filter(|wanted| !names.contains(wanted)) {
        let names = names.join(", ");
        return Err(Failure::BadInput(format!(
            "--pass {wanted}: a step of this scene has {names}; choose one of them"
        )));
    }
    let chosen = texts.iter().filter(|text| arguments.pass.as_deref().is_none_or(|wanted| wanted == text.name));
    let Some(folder) = &arguments.out else {
        return Ok(chosen.map(|text| text.text.as_str()).collect::<Vec<_>>().join("\n"));
    };
    let mut written = String::new();
    let wrong = |path: &std::path::Path, error: std::io::Error| {
        Failure::BadInput(format!("--out: cannot write {}: {error}; choose another folder", path.display()))
    };
    fs::create_dir_all(folder).map_err(|error| wrong(folder, error))?;
    let files = chosen.map(|text| (folder.join(format!("{}.{}", text.name, arguments.target.name())), text));
    let files: Vec<_> = files.collect();
    if let Some((path, _)) = files.iter().find(|(path, _)| path.exists() && !arguments.replace) {
        return Err(Failure::BadInput(format!(
            "--out: {} is there already; choose another folder, or give --replace",
            path.display()
        )));
    }
    for (path, text) in files {
        fs::write(&path, &text.text).map_err(|error| wrong(&path, error))?;
        written += &format!("{}\n", path.display());
    }
    Ok(written)
}

fn texts<const D: usize>(arguments: &EmitArguments, setup: &Setup) -> Result<Vec<Text>, Failure> {
    let precision = match (arguments.target, arguments.scene.precision) {
        (Target::Wgsl, Some(Precision::Double)) => {
            return Err(Failure::BadInput(
                "--precision f64: WGSL has no 64-bit floats; use --precision f32, or --target c".into(),
            ));
        }
        (_, precision) => precision.unwrap_or(Precision::Single),
    };
    let physics = setup.physics();
    let pipeline = Pipeline::of_scene::<D>(&physics);
    let command = format!("etalon emit {} --target {} --precision {precision}", setup.options(), arguments.target);
    let mut printer = Printer {
        target: arguments.target,
        precision,
        command,
        #[cfg(feature = "wgpu")]
        slots: etalon_wgpu::Slots::new(&pipeline.fields::<D>(), D),
    };
    let mut texts = Vec::new();
    for update in pipeline.opening().iter().chain(pipeline.driving()) {
        texts.push(update.visit::<D, _>(physics, &mut printer)?);
    }
    for pass in pipeline.passes() {
        texts.push(pass.visit::<D, _>(physics, &mut printer)?);
    }
    for update in pipeline.pushing().iter().chain(pipeline.closing()) {
        texts.push(update.visit::<D, _>(physics, &mut printer)?);
    }
    Ok(texts)
}

struct Printer {
    target: Target,
    precision: Precision,
    command: String,
    #[cfg(feature = "wgpu")]
    slots: etalon_wgpu::Slots,
}

fn broken(error: impl std::fmt::Display) -> Failure {
    Failure::Broken(format!("a pass cannot be printed: {error}"))
}

impl Printer {
    fn head(&self) -> Header<'_> {
        Header { command: &self.command, definition: DEFINITION }
    }

    #[cfg(feature = "wgpu")]
    fn pass_as_wgsl(&self, drawing: &PassDrawing) -> Result<String, Failure> {
        etalon_wgpu::pass_text(drawing, &self.slots, &self.head()).map_err(broken)
    }
    #[cfg(feature = "wgpu")]
    fn update_as_wgsl(&self, drawing: &UpdateDrawing) -> Result<String, Failure> {
        etalon_wgpu::update_text(drawing, &self.slots, &self.head()).map_err(broken)
    }

    #[cfg(not(feature = "wgpu"))]
    fn pass_as_wgsl(&self, _: &PassDrawing) -> Result<String, Failure> {
        Err(self.no_wgsl())
    }
    #[cfg(not(feature = "wgpu"))]
    fn update_as_wgsl(&self, _: &UpdateDrawing) -> Result<String, Failure> {
        Err(self.no_wgsl())
    }
    #[cfg(not(feature = "wgpu"))]
    fn no_wgsl(&self) -> Failure {
        Failure::BadInput("--target wgsl: this program was built without it; build it with `--features wgpu`".into())
    }
}

impl<const D: usize> UpdateVisitor<D> for Printer {
    type Output = Result<Text, Failure>;
    fn visit_update<U: Update<D>>(&mut self, update: &U) -> Self::Output {
        let drawing = match self.precision {
            Precision::Single => Drawing::of_update::<D, U, Single>(update),
            Precision::Double => Drawing::of_update::<D, U, Double>(update),
        };
        let drawing = drawing.map_err(broken)?;
        let text = match self.target {
            Target::Wgsl => self.update_as_wgsl(&drawing)?,
            Target::C => {
                let function = c::function(U::NAME, &drawing.apply, &self.head(), MulAdd::TwoRoundings);
                format!("{}\n{}", c::prelude(), function.map_err(broken)?)
            }
        };
        Ok(Text { name: U::NAME, text })
    }
}

impl<const D: usize> PassVisitor<D> for Printer {
    type Output = Result<Text, Failure>;
    fn visit<P: Pass<D>>(&mut self, pass: &P) -> Self::Output {
        let drawing = match self.precision {
            Precision::Single => Drawing::of_pass::<D, P, Single>(pass),
            Precision::Double => Drawing::of_pass::<D, P, Double>(pass),
        };
        let drawing = drawing.map_err(broken)?;
        let text = match self.target {
            Target::Wgsl => self.pass_as_wgsl(&drawing)?,
            Target::C => c::pass(&drawing, &self.head(), MulAdd::TwoRoundings).map_err(broken)?,
        };
        Ok(Text { name: P::NAME, text })
    }
}
