//! A generated function of plain numbers, called once for each entry of a list: how an audit learns what a device makes of an
//! equation.

use std::fmt::Write;

use bytemuck::NoUninit;
use etalon_kernels_gen::emit::{Header, MulAdd, wgsl as printer};
use etalon_kernels_gen::trace::Drawing;

use crate::program::{Program, Slot};
use crate::transfer::Region;
use crate::{Device, Error, Result, TextError, wgsl};

/// The entry point of the text.
const ENTRY_POINT: &str = "call_all";
/// The bindings: what goes in, what comes out, how many calls there are.
const SLOTS: [Slot; 3] = [Slot::Read, Slot::ReadWrite, Slot::Uniform];

#[derive(Clone, Copy, NoUninit)]
#[repr(C)]
struct Calls {
    count: u32,
    padding: [u32; 3],
}

/// The whole text: the function as the generator prints it, and an entry point that calls it once for each row of a table.
///
/// # Errors
/// What the printer refuses.
pub fn function_text(name: &str, drawing: &Drawing, head: &Header<'_>) -> std::result::Result<String, TextError> {
    let mut text = wgsl::call_prelude();
    let _ = write!(text, "\n{}", printer::function(name, drawing, head, MulAdd::TwoRoundings)?);
    let (inputs, outputs) = (drawing.inputs().len(), drawing.outputs());
    let argument = |k: usize| format!("rows_in[{inputs}u * call + {k}u]");
    let arguments: Vec<String> = (0..inputs).map(argument).collect();
    let _ = write!(
        text,
        "\n// One invocation per call.\n@compute @workgroup_size(WORKGROUP)\nfn {ENTRY_POINT}(\n    \
         @builtin(global_invocation_id) id: vec3<u32>,\n    @builtin(num_workgroups) workgroups: vec3<u32>,\n) {{\n    \
         let call = invocation_index(id, workgroups);\n    if (call >= calls.count) {{\n        return;\n    }}\n    \
         let result = {}({});\n",
        printer::function_name(name),
        arguments.join(", ")
    );
    for (k, output) in outputs.iter().enumerate() {
        let member = printer::member(&output.name);
        let _ = writeln!(text, "    rows_out[{}u * call + {k}u] = result.{member};", outputs.len());
    }
    text.push_str("}\n");
    Ok(text)
}

/// Calls a function once for each row of `rows`, which holds the drawing's inputs one call after the other, and returns its outputs
/// in the same manner. Waits for the device; lists that are longer than it can bind go there in parts.
///
/// # Errors
/// [`Error::Shader`] if the function cannot be printed or is refused, [`Error::WrongLength`] if the last row is not whole,
/// [`Error::OutOfMemory`] or [`Error::DeviceLost`].
pub fn call_function(device: &Device, name: &str, drawing: &Drawing, calls: usize, rows: &[f32]) -> Result<Vec<f32>> {
    let (inputs, outputs) = (drawing.inputs().len(), drawing.outputs().len());
    if rows.len() != calls * inputs {
        let what = format!("the table of inputs of `{name}`");
        return Err(Error::WrongLength { what, expected: calls * inputs, found: rows.len() });
    }
    let head = Header { command: "etalon audit", definition: name };
    let text = function_text(name, drawing, &head)
        .map_err(|error| Error::Shader { kernel: name.to_owned(), message: error.to_string() })?;
    let program = Program::new(device, name, &text, &SLOTS, [ENTRY_POINT])?;
    // As many calls at a time as fit into a binding, and into an index.
    let bytes_per_call = 4 * inputs.max(outputs).max(1) as u64;
    let most = (device.largest_binding() / bytes_per_call).clamp(1, u64::from(u32::MAX) / bytes_per_call) as usize;
    let mut results = Vec::with_capacity(calls * outputs);
    for first in (0..calls).step_by(most) {
        let count = most.min(calls - first);
        let part = &rows[first * inputs..(first + count) * inputs];
        results.extend(call_part(device, &program, part, count, outputs)?);
    }
    Ok(results)
}

fn call_part(device: &Device, program: &Program<1>, rows: &[f32], count: usize, outputs: usize) -> Result<Vec<f32>> {
    let bytes = 4 * (count * outputs) as u64;
    let given = device.storage("the inputs of a function", 4 * rows.len() as u64)?;
    let found = device.storage("the outputs of a function", bytes)?;
    device.write(&given, 0, rows)?;
    let calls = device.uniform("the number of calls", &Calls { count: count as u32, padding: [0; 3] })?;
    let bound = program.bind(device, &[&given, &found, &calls])?;
    device.submit("calling a function", |encoder| {
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        program.dispatch(&mut pass, 0, &bound, count as u32);
    })?;
    device.read(&[Region { buffer: &found, offset: 0, bytes }])
}
