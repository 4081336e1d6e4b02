// The bindings of every pass, and how to reach particles through them. A particle is named by its index; component k of a
// particle lies at fields[k * count + index]. `order` lists the particles cell by cell: threads that take their particle
// from it read neighbours that lie close together.

struct Particles {
    count: u32,
    length_per_unit: vec4<f32>,
}

@group(0) @binding(0) var<storage, read_write> fields: array<f32>;
@group(0) @binding(1) var<storage, read> coordinates: array<u32>;
@group(0) @binding(2) var<storage, read> list_offsets: array<u32>;
@group(0) @binding(3) var<storage, read> list: array<u32>;
@group(0) @binding(4) var<storage, read> order: array<u32>;
@group(0) @binding(5) var<storage, read> parameters: array<f32>;
@group(0) @binding(6) var<uniform> particles: Particles;

fn coordinate(axis: u32, particle: u32) -> u32 {
    return coordinates[axis * particles.count + particle];
}

// The separation a - b of two coordinates along an axis, the shorter way round the torus.
fn apart(axis: u32, a: u32, b: u32) -> f32 {
    return f32(bitcast<i32>(a - b)) * particles.length_per_unit[axis];
}

// The separation a - b of two particles along an axis.
fn separation(axis: u32, a: u32, b: u32) -> f32 {
    return apart(axis, coordinate(axis, a), coordinate(axis, b));
}

fn field(component: u32, particle: u32) -> f32 {
    return fields[component * particles.count + particle];
}

fn set_field(component: u32, particle: u32, value: f32) {
    fields[component * particles.count + particle] = value;
}
