// Sorts each segment values[starts[s] .. starts[s + 1]] ascending, one invocation per segment, by Shell's method with Knuth's
// gaps 1, 4, 13, 40, ...: in place, no stack. Segments that are sorted already, as the neighbour lists are where particles
// are numbered in cell order, cost one look. Segments that end beyond `capacity` were never written and are left alone.

struct SortParameters {
    segments: u32,
    capacity: u32,
}

@group(0) @binding(0) var<storage, read> starts: array<u32>;
@group(0) @binding(1) var<storage, read_write> values: array<u32>;
@group(0) @binding(2) var<uniform> parameters: SortParameters;

@compute @workgroup_size(WORKGROUP)
fn sort_segments(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) workgroups: vec3<u32>,
) {
    let segment = invocation_index(id, workgroups);
    if (segment >= parameters.segments) {
        return;
    }
    let first = starts[segment];
    let last = starts[segment + 1u];
    if (last > parameters.capacity || last < first + 2u) {
        return;
    }
    var sorted = first + 1u;
    while (sorted < last && values[sorted - 1u] <= values[sorted]) {
        sorted += 1u;
    }
    if (sorted == last) {
        return;
    }
    var gap = 1u;
    while (gap < (last - first) / 3u) {
        gap = 3u * gap + 1u;
    }
    while (gap > 0u) {
        for (var k = first + gap; k < last; k++) {
            let value = values[k];
            var hole = k;
            while (hole >= first + gap) {
                let before = values[hole - gap];
                if (before <= value) {
                    break;
                }
                values[hole] = before;
                hole -= gap;
            }
            values[hole] = value;
        }
        gap = gap / 3u;
    }
}
