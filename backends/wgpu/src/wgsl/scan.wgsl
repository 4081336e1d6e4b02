// Exclusive prefix sum, in place, in blocks of BLOCK = WORKGROUP * PER_THREAD values. `scan_blocks` sums within each block and
// writes the block's total to `sums`; after `sums` has itself been scanned, `add_sums` adds it back. The addition saturates
// at 2^32 - 1 (which keeps it associative), so that a total that does not fit is seen by the host instead of wrapping.

struct ScanParameters {
    length: u32,
    blocks: u32,
}

const PER_THREAD = 16u;
const BLOCK = WORKGROUP * PER_THREAD;

@group(0) @binding(0) var<storage, read_write> data: array<u32>;
@group(0) @binding(1) var<storage, read_write> sums: array<u32>;
@group(0) @binding(2) var<uniform> parameters: ScanParameters;

var<workgroup> partials: array<u32, WORKGROUP>;

fn saturating_add(a: u32, b: u32) -> u32 {
    let sum = a + b;
    return select(sum, 0xffffffffu, sum < a);
}

@compute @workgroup_size(WORKGROUP)
fn scan_blocks(
    @builtin(local_invocation_index) thread: u32,
    @builtin(workgroup_id) group: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
) {
    let block = group.x + group.y * groups.x;
    let first = block * BLOCK + thread * PER_THREAD;
    let last = min(first + PER_THREAD, parameters.length);

    var own = 0u;
    for (var k = first; k < last; k++) {
        own = saturating_add(own, data[k]);
    }
    partials[thread] = own;
    workgroupBarrier();

    // Inclusive scan of the threads' sums: after the step `reach` each holds the sum of 2 * reach threads.
    for (var reach = 1u; reach < WORKGROUP; reach *= 2u) {
        var sum = partials[thread];
        if (thread >= reach) {
            sum = saturating_add(sum, partials[thread - reach]);
        }
        workgroupBarrier();
        partials[thread] = sum;
        workgroupBarrier();
    }

    var before = 0u;
    if (thread > 0u) {
        before = partials[thread - 1u];
    }
    for (var k = first; k < last; k++) {
        let value = data[k];
        data[k] = before;
        before = saturating_add(before, value);
    }
    if (thread == 0u && block < parameters.blocks) {
        sums[block] = partials[WORKGROUP - 1u];
    }
}

@compute @workgroup_size(WORKGROUP)
fn add_sums(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) workgroups: vec3<u32>,
) {
    let k = invocation_index(id, workgroups);
    if (k < parameters.length) {
        data[k] = saturating_add(data[k], sums[k / BLOCK]);
    }
}
