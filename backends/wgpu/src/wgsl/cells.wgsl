// Sorts the particles into cells: `bin` counts them and finds each cell's largest reach; the host scans the counts into
// `cell_start`; `scatter` lists the particles of each cell in `order` (the host then sorts each cell's particles by index, as
// atomics come in any order); `pack` copies position and reach into that order, so that the search reads them in one run.

@group(0) @binding(0) var<storage, read> coordinates: array<u32>;
@group(0) @binding(1) var<storage, read> fields: array<f32>;
@group(0) @binding(2) var<storage, read_write> cell_counts: array<atomic<u32>>;
@group(0) @binding(3) var<storage, read_write> cell_reach: array<atomic<u32>>;
@group(0) @binding(4) var<storage, read> cell_start: array<u32>;
@group(0) @binding(5) var<storage, read_write> order: array<u32>;
@group(0) @binding(6) var<storage, read_write> packed: array<vec4<u32>>;
@group(0) @binding(7) var<uniform> parameters: SearchParameters;

fn position_of(particle: u32) -> vec3<u32> {
    var position = vec3<u32>(0u, 0u, 0u);
    for (var axis = 0u; axis < DIMENSION; axis++) {
        position[axis] = coordinates[axis * parameters.count + particle];
    }
    return position;
}

@compute @workgroup_size(WORKGROUP)
fn bin(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) workgroups: vec3<u32>,
) {
    let particle = invocation_index(id, workgroups);
    if (particle >= parameters.count) {
        return;
    }
    let cell = cell_index(cell_of(position_of(particle), parameters.cells), parameters.cells);
    atomicAdd(&cell_counts[cell], 1u);
    // The bits of positive floats are ordered as the floats are.
    atomicMax(&cell_reach[cell], bitcast<u32>(fields[parameters.first_reach + particle]));
}

@compute @workgroup_size(WORKGROUP)
fn scatter(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) workgroups: vec3<u32>,
) {
    let particle = invocation_index(id, workgroups);
    if (particle >= parameters.count) {
        return;
    }
    let cell = cell_index(cell_of(position_of(particle), parameters.cells), parameters.cells);
    // The count runs down to zero again: each particle takes the last free place of its cell.
    let place = atomicSub(&cell_counts[cell], 1u) - 1u;
    order[cell_start[cell] + place] = particle;
}

@compute @workgroup_size(WORKGROUP)
fn pack(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) workgroups: vec3<u32>,
) {
    let slot = invocation_index(id, workgroups);
    if (slot >= parameters.count) {
        return;
    }
    let particle = order[slot];
    let reach = bitcast<u32>(fields[parameters.first_reach + particle]);
    packed[slot] = vec4<u32>(position_of(particle), reach);
}
