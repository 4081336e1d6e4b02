//! The text that stands round the functions of a generated pass or update: an entry point that reads a particle's fields,
//! loops over its neighbours, and writes the results. Nothing here knows what a pass computes.

use std::fmt::Write;

use etalon_kernels_gen::emit::{EmitError, Header, MulAdd, wgsl as printer};
use etalon_kernels_gen::trace::{PassDrawing, UpdateDrawing};
use etalon_kernels_gen::{Component, Field, Reduction, components};

use crate::wgsl;

/// The entry point of every generated text.
pub(crate) const ENTRY_POINT: &str = "sweep";

/// Where among the parameters the time step is.
pub(crate) const TIME_STEP: usize = 0;
/// Where among the parameters the kernel's support in smoothing lengths is.
pub(crate) const SUPPORT: usize = 1;
/// How many parameters there are.
pub(crate) const PARAMETERS: usize = 2;

/// Why a text could not be made.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum TextError {
    /// The pass or update has something that WGSL cannot express.
    #[error("{0}")]
    Emit(#[from] EmitError),
    /// A component that the store has no room for.
    #[error(
        "`{kernel}` needs the field `{component}`, which this engine was made without: make it with all fields of the pipeline"
    )]
    Missing {
        /// The pass or update.
        kernel: String,
        /// The component.
        component: String,
    },
}

/// Where in the field store each component lies: the order of the fields, and after them one more number per particle, the
/// support radius that the neighbour search reads.
#[derive(Debug, Clone)]
pub struct Slots {
    components: Vec<Component>,
    names: Vec<String>,
}

impl Slots {
    /// Slots for all components of these fields.
    pub fn new(fields: &[Field], dimension: usize) -> Self {
        let components = components(fields, dimension);
        let names = components.iter().map(|component| component.name(dimension)).collect();
        Self { components, names }
    }

    /// Numbers per particle, the support radius included.
    pub fn count(&self) -> usize {
        self.components.len() + 1
    }

    /// Where the support radius is.
    pub fn reach(&self) -> usize {
        self.components.len()
    }

    /// Where a component is, if there is room for it.
    pub fn of(&self, component: Component) -> Option<usize> {
        self.components.iter().position(|known| *known == component)
    }

    fn named(&self, kernel: &str, name: &str) -> Result<usize, TextError> {
        let missing = || TextError::Missing { kernel: kernel.to_owned(), component: name.to_owned() };
        self.names.iter().position(|known| known == name).ok_or_else(missing)
    }
}

/// What an entry point takes, up to the index of its item.
const ARGUMENTS: &str = "(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) workgroups: vec3<u32>,
) {
    let item = invocation_index(id, workgroups);
    if (item >= particles.count) {
        return;
    }
";

/// The whole text of a pass: its functions, printed by the generator, in the frame.
///
/// # Errors
/// [`TextError`].
pub fn pass_text(drawing: &PassDrawing, slots: &Slots, head: &Header<'_>) -> Result<String, TextError> {
    let name = drawing.name;
    let types = camel_case(name);
    let simple = drawing.simplified();
    let mut text = wgsl::pass_prelude(drawing.dimension);
    let _ = write!(text, "\n{}", printer::pass(drawing, head, MulAdd::TwoRoundings)?);

    let dimension = drawing.dimension;
    let _ = write!(
        text,
        "\n// One invocation per particle: the sum over its neighbours, then the epilogue.\n\
         @compute @workgroup_size(WORKGROUP)\nfn {ENTRY_POINT}{ARGUMENTS}    let a = order[item];\n"
    );
    let mut own_arguments = Vec::new();
    read(&mut text, "    ", "own", &format!("{types}Own"), &drawing.own, |component| {
        Ok(format!("field({}u, a)", slots.named(name, component)?))
    })?;
    if !drawing.own.is_empty() {
        own_arguments.push("own");
    }
    if !drawing.sums.is_empty() {
        let _ = writeln!(text, "    var sums: {types}Sums;");
        for axis in 0..dimension {
            let _ = writeln!(text, "    let place_{axis} = coordinate({axis}u, a);");
        }
        text.push_str("    let last = list_offsets[a + 1u];\n    for (var k = list_offsets[a]; k < last; k++) {\n");
        text.push_str("        let b = list[k];\n");
        read(&mut text, "        ", "other", &format!("{types}Other"), &drawing.other, |component| {
            Ok(format!("field({}u, b)", slots.named(name, component)?))
        })?;
        separation(&mut text, dimension);
        let mut arguments = own_arguments.clone();
        if !drawing.other.is_empty() {
            arguments.push("other");
        }
        arguments.extend(["x_ab", "r_squared"]);
        let _ = writeln!(text, "        let term = {name}_pair({});", arguments.join(", "));
        let zero = simple.zero_sums();
        for sum in drawing.sums.iter().filter(|sum| !zero.contains(&sum.name.as_str())) {
            let member = printer::member(&sum.name);
            let _ = match sum.reduction {
                Reduction::Sum => writeln!(text, "        sums.{member} = sums.{member} + term.{member};"),
                Reduction::Max => writeln!(text, "        sums.{member} = max(sums.{member}, term.{member});"),
            };
        }
        text.push_str("    }\n");
        own_arguments.push("sums");
    }
    if !drawing.out.is_empty() {
        let _ = writeln!(text, "    let out = {name}_finish({});", own_arguments.join(", "));
    }
    write_out(&mut text, name, slots, &drawing.out)?;
    text.push_str("}\n");
    Ok(text)
}

/// The whole text of an update.
///
/// # Errors
/// [`TextError`].
pub fn update_text(drawing: &UpdateDrawing, slots: &Slots, head: &Header<'_>) -> Result<String, TextError> {
    let name = drawing.name;
    let mut text = wgsl::pass_prelude(drawing.dimension);
    let _ = write!(text, "\n{}", printer::update(drawing, head, MulAdd::TwoRoundings)?);
    let _ = write!(
        text,
        "\n// One invocation per particle.\n\
         @compute @workgroup_size(WORKGROUP)\nfn {ENTRY_POINT}{ARGUMENTS}    let a = item;\n"
    );
    let types = camel_case(name);
    read(&mut text, "    ", "own", &format!("{types}Own"), &drawing.own, |component| {
        Ok(format!("field({}u, a)", slots.named(name, component)?))
    })?;
    if !drawing.out.is_empty() {
        let own = if drawing.own.is_empty() { "" } else { "own, " };
        let _ = writeln!(text, "    let out = {name}_apply({own}parameters[{TIME_STEP}u]);");
    }
    write_out(&mut text, name, slots, &drawing.out)?;
    text.push_str("}\n");
    Ok(text)
}

/// The text of the kernel that sets the support radius of every particle from the smoothing length in `length_slot`.
pub(crate) fn reach_text(dimension: usize, slots: &Slots, length_slot: usize) -> String {
    let prelude = wgsl::pass_prelude(dimension);
    let reach = slots.reach();
    format!(
        "{prelude}\n// The support radius that the neighbour search reads: a multiple of the smoothing length.\n\
         @compute @workgroup_size(WORKGROUP)\nfn {ENTRY_POINT}{ARGUMENTS}    \
         set_field({reach}u, item, parameters[{SUPPORT}u] * field({length_slot}u, item));\n}}\n"
    )
}

/// A variable for a record, and a line for each of its members.
fn read(
    text: &mut String,
    indent: &str,
    variable: &str,
    structure: &str,
    members: &[String],
    mut value: impl FnMut(&str) -> Result<String, TextError>,
) -> Result<(), TextError> {
    if members.is_empty() {
        return Ok(());
    }
    let _ = writeln!(text, "{indent}var {variable}: {structure};");
    for (index, component) in members.iter().enumerate() {
        // A record made of records may read a field twice; it is one member.
        if !members[..index].contains(component) {
            let _ = writeln!(text, "{indent}{variable}.{} = {};", printer::member(component), value(component)?);
        }
    }
    Ok(())
}

/// The separation and its square, rounded as the reference rounds: every product and every sum on its own, first axis first.
fn separation(text: &mut String, dimension: usize) {
    let along: Vec<String> =
        (0..dimension).map(|axis| format!("apart({axis}u, place_{axis}, coordinate({axis}u, b))")).collect();
    if dimension == 1 {
        let _ = writeln!(text, "        let x_ab = {};", along[0]);
        text.push_str("        let r_squared = x_ab * x_ab;\n");
        return;
    }
    let _ = writeln!(text, "        let x_ab = vec{dimension}<f32>(");
    for line in along {
        let _ = writeln!(text, "            {line},");
    }
    text.push_str("        );\n");
    let mut square = "x_ab.x * x_ab.x".to_owned();
    for axis in ["y", "z"].into_iter().take(dimension - 1) {
        square = format!("(x_ab.{axis} * x_ab.{axis}) + ({square})");
    }
    let _ = writeln!(text, "        let r_squared = {square};");
}

fn write_out(text: &mut String, kernel: &str, slots: &Slots, out: &[String]) -> Result<(), TextError> {
    for component in out {
        let slot = slots.named(kernel, component)?;
        let _ = writeln!(text, "    set_field({slot}u, a, out.{});", printer::member(component));
    }
    Ok(())
}

/// `volume_elements` as `VolumeElements`, which is how the generator names the structs of a pass.
fn camel_case(name: &str) -> String {
    let capital = |word: &str| {
        let mut letters = word.chars();
        letters.next().map_or(String::new(), |first| first.to_ascii_uppercase().to_string() + letters.as_str())
    };
    name.split('_').map(capital).collect()
}
