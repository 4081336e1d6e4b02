// What every kernel of the neighbour search shares: its parameters and the map from a coordinate to a cell.
//
// The torus has cells.x * cells.y * cells.z cells, x running fastest; an axis beyond the dimension has one cell. A coordinate
// is an unsigned 32-bit fraction of the torus; its cell along an axis is floor(coordinate * cells / 2^32), exactly.

struct SearchParameters {
    count: u32,
    cell_total: u32,
    capacity: u32,
    first_reach: u32,
    cells: vec4<u32>,
    length_per_unit: vec4<f32>,
    cell_width: vec4<f32>,
}

// The bits of a positive infinity: a reach whose bits are not below it is negative, infinite or not a number. The host
// refuses it afterwards; the kernels only have to come to an end.
const INFINITY_BITS = 0x7f800000u;

fn multiply_high(a: u32, b: u32) -> u32 {
    let a_low = a & 0xffffu;
    let a_high = a >> 16u;
    let b_low = b & 0xffffu;
    let b_high = b >> 16u;
    let low_high = a_low * b_high;
    let high_low = a_high * b_low;
    let carry = ((a_low * b_low) >> 16u) + (low_high & 0xffffu) + (high_low & 0xffffu);
    return a_high * b_high + (low_high >> 16u) + (high_low >> 16u) + (carry >> 16u);
}

fn cell_of(position: vec3<u32>, cells: vec4<u32>) -> vec3<u32> {
    return vec3<u32>(
        multiply_high(position.x, cells.x),
        multiply_high(position.y, cells.y),
        multiply_high(position.z, cells.z),
    );
}

fn cell_index(cell: vec3<u32>, cells: vec4<u32>) -> u32 {
    return cell.x + cells.x * (cell.y + cells.y * cell.z);
}
