// Smallest and largest of a range of floats. The comparison is done on integers: the map `ordered` takes the bits of a float
// to an unsigned integer of the same order (-0 below +0, a negative NaN below all, a positive NaN above all). So the result
// does not depend on the order of the comparisons, on flushed denormals or on what a driver makes of a NaN, and a NaN in the
// range always shows in the result.

struct ExtremesParameters {
    first: u32,
    length: u32,
    workgroups: u32,
}

@group(0) @binding(0) var<storage, read> values: array<u32>;
@group(0) @binding(1) var<storage, read_write> partials: array<vec2<u32>>;
@group(0) @binding(2) var<storage, read_write> extremes: array<u32, 2>;
@group(0) @binding(3) var<uniform> parameters: ExtremesParameters;

var<workgroup> shared_extremes: array<vec2<u32>, WORKGROUP>;

fn ordered(bits: u32) -> u32 {
    return bits ^ select(0x80000000u, 0xffffffffu, (bits & 0x80000000u) != 0u);
}

fn from_ordered(key: u32) -> u32 {
    return key ^ select(0xffffffffu, 0x80000000u, (key & 0x80000000u) != 0u);
}

fn join(a: vec2<u32>, b: vec2<u32>) -> vec2<u32> {
    return vec2<u32>(min(a.x, b.x), max(a.y, b.y));
}

fn join_workgroup(thread: u32, own: vec2<u32>) {
    shared_extremes[thread] = own;
    workgroupBarrier();
    for (var half = WORKGROUP / 2u; half > 0u; half /= 2u) {
        if (thread < half) {
            shared_extremes[thread] = join(shared_extremes[thread], shared_extremes[thread + half]);
        }
        workgroupBarrier();
    }
}

@compute @workgroup_size(WORKGROUP)
fn per_workgroup(
    @builtin(local_invocation_index) thread: u32,
    @builtin(workgroup_id) group: vec3<u32>,
) {
    var own = vec2<u32>(0xffffffffu, 0u);
    for (var k = group.x * WORKGROUP + thread; k < parameters.length; k += parameters.workgroups * WORKGROUP) {
        let key = ordered(values[parameters.first + k]);
        own = join(own, vec2<u32>(key, key));
    }
    join_workgroup(thread, own);
    if (thread == 0u) {
        partials[group.x] = shared_extremes[0];
    }
}

@compute @workgroup_size(WORKGROUP)
fn of_workgroups(@builtin(local_invocation_index) thread: u32) {
    var own = vec2<u32>(0xffffffffu, 0u);
    for (var k = thread; k < parameters.workgroups; k += WORKGROUP) {
        own = join(own, partials[k]);
    }
    join_workgroup(thread, own);
    if (thread == 0u) {
        extremes[0] = from_ordered(shared_extremes[0].x);
        extremes[1] = from_ordered(shared_extremes[0].y);
    }
}
