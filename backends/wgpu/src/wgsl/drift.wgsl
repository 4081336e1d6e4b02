// Moves the particles: coordinate += round(displacement * 2^32 / length), rounded half to even, wrapping round the torus.
// A displacement that is not finite or not shorter than half the torus has no unambiguous coordinate: it is not applied, and
// the smallest index of such a particle is left in `first_fault` for the host.

struct DriftParameters {
    count: u32,
    first_displacement: u32,
    units_per_length: vec4<f32>,
    half_length: vec4<f32>,
}

@group(0) @binding(0) var<storage, read> fields: array<f32>;
@group(0) @binding(1) var<storage, read_write> coordinates: array<u32>;
@group(0) @binding(2) var<storage, read_write> first_fault: atomic<u32>;
@group(0) @binding(3) var<uniform> parameters: DriftParameters;

@compute @workgroup_size(WORKGROUP)
fn drift(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) workgroups: vec3<u32>,
) {
    let particle = invocation_index(id, workgroups);
    if (particle >= parameters.count) {
        return;
    }
    for (var axis = 0u; axis < DIMENSION; axis++) {
        let displacement = fields[parameters.first_displacement + axis * parameters.count + particle];
        // Magnitudes compared as integers, which a NaN cannot slip through.
        if ((bitcast<u32>(displacement) & 0x7fffffffu) < bitcast<u32>(parameters.half_length[axis])) {
            let units = i32(round(displacement * parameters.units_per_length[axis]));
            coordinates[axis * parameters.count + particle] += bitcast<u32>(units);
        } else {
            atomicMin(&first_fault, particle);
        }
    }
}
