// sorted[i] = columns[order[i]] for every column. Words are moved as integers, so that no float changes its bits.

struct PermutationParameters {
    count: u32,
    words: u32,
}

@group(0) @binding(0) var<storage, read> columns: array<u32>;
@group(0) @binding(1) var<storage, read> order: array<u32>;
@group(0) @binding(2) var<storage, read_write> sorted: array<u32>;
@group(0) @binding(3) var<uniform> parameters: PermutationParameters;

@compute @workgroup_size(WORKGROUP)
fn permute(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(num_workgroups) workgroups: vec3<u32>,
) {
    let word = invocation_index(id, workgroups);
    if (word >= parameters.words) {
        return;
    }
    let place = word % parameters.count;
    sorted[word] = columns[word - place + order[place]];
}
