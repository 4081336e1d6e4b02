// The neighbour lists. For each particle i all j != i with |r_i - r_j|^2 < max(reach_i, reach_j)^2. One invocation per slot
// of the cell order, so that neighbouring threads walk the same cells. `count` writes the number of neighbours of particle
// i to offsets[i]; the host scans the offsets; `fill` writes the indices in ascending order of slots, which is the
// final order where particles are numbered in cell order; the host has every list sorted in any case.
//
// Cells are only a means of looking at fewer candidates: they are left out when they cannot hold a neighbour, with a slack
// far above every rounding error, and so the lists do not depend on the cells.

@group(0) @binding(0) var<storage, read> packed: array<vec4<u32>>;
@group(0) @binding(1) var<storage, read> order: array<u32>;
@group(0) @binding(2) var<storage, read> cell_start: array<u32>;
@group(0) @binding(3) var<storage, read> search_reach: array<u32>;
@group(0) @binding(4) var<storage, read_write> offsets: array<u32>;
@group(0) @binding(5) var<storage, read_write> list: array<u32>;
@group(0) @binding(6) var<uniform> parameters: SearchParameters;

// The cells along one axis that may hold neighbours: `number` cells from `start` on, of which the last `wrapped` lie at the
// beginning of the axis, where the torus closes; `lowest` is the offset of the first one from the particle's own cell.
// `whole` says that they are all the cells of the axis, where offsets mean nothing.
struct Span {
    start: u32,
    number: u32,
    wrapped: u32,
    lowest: i32,
    whole: bool,
}

// Slack in cells. Fractions and offsets are below 2^24, so the quotient radius / width (division 2.5 ulp, square root a
// little more) is off by less than 1e-6 of itself; a fraction of a cell by 1e-7.
fn slack(radius: f32) -> f32 {
    return 1e-3 + 1e-6 * radius;
}

// `radius` in cells; `fraction` is how far into its cell the particle lies, 0 to 1.
fn span(own: u32, fraction: f32, radius: f32, cells: u32) -> Span {
    let widened = radius + slack(radius);
    if (2.0 * widened + 3.0 >= f32(cells)) {
        return Span(0u, cells, 0u, 0, true);
    }
    let lowest = i32(floor(fraction - widened));
    let highest = i32(floor(fraction + widened));
    let number = u32(highest - lowest + 1);
    let unwrapped = i32(own) + lowest;
    let start = u32(select(unwrapped, unwrapped + i32(cells), unwrapped < 0));
    return Span(start, number, max(start + number, cells) - cells, lowest, false);
}

// One cell of a span, and its place in the span counted from `start`.
struct Step {
    cell: u32,
    place: u32,
}

// The k-th cell of a span in ascending order of cells, so that the slots are visited in ascending order.
fn step_of(cells: Span, k: u32) -> Step {
    if (k < cells.wrapped) {
        return Step(k, cells.number - cells.wrapped + k);
    }
    return Step(cells.start + k - cells.wrapped, k - cells.wrapped);
}

// A lower bound, in cells, of the distance along the axis to anything in a cell of a span.
fn gap(cells: Span, place: u32, fraction: f32) -> f32 {
    if (cells.whole) {
        return 0.0;
    }
    let offset = f32(cells.lowest + i32(place));
    return max(max(offset - fraction, fraction - offset - 1.0) - slack(abs(offset)), 0.0);
}

// Tests the candidates in the slots from `begin` up to `end`; `place` is where the next neighbour goes, if below `last`.
fn visit(slot: u32, record: vec4<u32>, begin: u32, end: u32, first_place: u32, last: u32) -> u32 {
    let reach = bitcast<f32>(record.w);
    var place = first_place;
    for (var other = begin; other < end; other++) {
        let candidate = packed[other];
        let difference = bitcast<vec3<i32>>(record.xyz - candidate.xyz);
        let separation = vec3<f32>(difference) * parameters.length_per_unit.xyz;
        // fma leaves the driver no choice to contract one way here and another way there; the sign of the separation does
        // not enter, so i finds j exactly when j finds i.
        let distance_squared = fma(
            separation.z,
            separation.z,
            fma(separation.y, separation.y, separation.x * separation.x),
        );
        let support = max(reach, bitcast<f32>(candidate.w));
        if (distance_squared < support * support && other != slot) {
            if (place < last) {
                list[place] = order[other];
            }
            place += 1u;
        }
    }
    return place;
}

// Returns the number of neighbours of the particle in `slot`, and writes them to the list from `first` up to `last`.
fn search(slot: u32, first: u32, last: u32) -> u32 {
    let record = packed[slot];
    let cells = parameters.cells;
    let width = parameters.cell_width;
    let cell = cell_of(record.xyz, cells);
    let radius_bits = max(record.w, search_reach[cell_index(cell, cells)]);
    if (radius_bits >= INFINITY_BITS) {
        return 0u;
    }
    let radius = bitcast<f32>(radius_bits);
    // The low word of coordinate * cells is the place within the cell: 2^-32 turns it into a fraction.
    let fraction = vec3<f32>(record.xyz * cells.xyz) * 2.3283064365386963e-10;

    var place = first;
    let layers = span(cell.z, fraction.z, radius / width.z, cells.z);
    for (var layer = 0u; layer < layers.number; layer++) {
        let z = step_of(layers, layer);
        let gap_z = gap(layers, z.place, fraction.z) * width.z;
        let rows = span(cell.y, fraction.y, radius / width.y, cells.y);
        for (var row = 0u; row < rows.number; row++) {
            let y = step_of(rows, row);
            let gap_y = gap(rows, y.place, fraction.y) * width.y;
            let rest = radius * radius - gap_y * gap_y - gap_z * gap_z;
            if (rest < 0.0) {
                continue;
            }
            // Along x the cells are one run of slots, or two where the torus closes.
            let run = span(cell.x, fraction.x, sqrt(rest) / width.x, cells.x);
            let line = cells.x * (y.cell + cells.y * z.cell);
            if (run.wrapped > 0u) {
                place = visit(slot, record, cell_start[line], cell_start[line + run.wrapped], place, last);
            }
            let begin = line + run.start;
            let end = begin + run.number - run.wrapped;
            place = visit(slot, record, cell_start[begin], cell_start[end], place, last);
        }
    }
    return place - first;
}

@compute @workgroup_size(WORKGROUP)
fn count(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) workgroups: vec3<u32>,
) {
    let slot = invocation_index(id, workgroups);
    if (slot >= parameters.count) {
        return;
    }
    // The last offset, the total, comes of the scan, whatever stands there before.
    offsets[order[slot]] = search(slot, 0u, 0u);
}

@compute @workgroup_size(WORKGROUP)
fn fill(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) workgroups: vec3<u32>,
) {
    let slot = invocation_index(id, workgroups);
    if (slot >= parameters.count) {
        return;
    }
    let particle = order[slot];
    let first = offsets[particle];
    let last = offsets[particle + 1u];
    if (last <= parameters.capacity) {
        search(slot, first, last);
    }
}
