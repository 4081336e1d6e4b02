// How far must a particle look to find those that reach it? At most as far as the largest reach among the cells from which
// the largest reach of all could arrive. `window` takes that maximum along one axis; run once per axis it covers the box.
// All reaches are handled as bits, which are ordered as the floats are.

struct WindowAxis {
    axis: u32,
}

@group(0) @binding(0) var<storage, read> source: array<u32>;
@group(0) @binding(1) var<storage, read_write> widened: array<u32>;
@group(0) @binding(2) var<storage, read> reach_extremes: array<u32, 2>;
@group(0) @binding(3) var<uniform> parameters: SearchParameters;
@group(0) @binding(4) var<uniform> along: WindowAxis;

@compute @workgroup_size(WORKGROUP)
fn window(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) workgroups: vec3<u32>,
) {
    let cell = invocation_index(id, workgroups);
    if (cell >= parameters.cell_total) {
        return;
    }
    let cells = parameters.cells[along.axis];
    var stride = 1u;
    for (var axis = 0u; axis < along.axis; axis++) {
        stride *= parameters.cells[axis];
    }
    let own = (cell / stride) % cells;
    let line = cell - own * stride;

    // Two particles closer than `largest` along the axis are at most floor(largest / width) + 1 cells apart; the slack is
    // far above the rounding of the quotient (below 2^-22 of it, see `span` in list.wgsl).
    var half = 0u;
    let largest = reach_extremes[1];
    if (largest < INFINITY_BITS) {
        let quotient = bitcast<f32>(largest) / parameters.cell_width[along.axis];
        half = cells;
        if (quotient < f32(cells)) {
            half = u32(quotient * 1.000001 + 1.001);
        }
    }
    var widest = 0u;
    if (2u * half + 1u >= cells) {
        for (var k = 0u; k < cells; k++) {
            widest = max(widest, source[line + k * stride]);
        }
    } else {
        var k = select(own + cells - half, own - half, own >= half);
        for (var step = 0u; step < 2u * half + 1u; step++) {
            widest = max(widest, source[line + k * stride]);
            k = select(k + 1u, 0u, k + 1u == cells);
        }
    }
    widened[cell] = widest;
}
