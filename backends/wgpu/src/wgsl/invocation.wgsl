// One invocation per item, in workgroups of 64 threads (the constant WORKGROUP). One axis of a dispatch holds at most
// 65535 workgroups, so the workgroups lie on a plane and are counted row by row.

fn invocation_index(id: vec3<u32>, workgroups: vec3<u32>) -> u32 {
    return id.x + id.y * workgroups.x * WORKGROUP;
}
