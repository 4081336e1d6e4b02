// A function called once for each row of a table: the inputs of all calls one after the other, and so the outputs.

struct Calls {
    count: u32,
}

@group(0) @binding(0) var<storage, read> rows_in: array<f32>;
@group(0) @binding(1) var<storage, read_write> rows_out: array<f32>;
@group(0) @binding(2) var<uniform> calls: Calls;
