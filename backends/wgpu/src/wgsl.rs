//! Assembling WGSL text.
//!
//! The only templating is a header of constants: `DIMENSION` (1, 2 or 3), `WORKGROUP` (64) and what the caller adds. The
//! `.wgsl` files use those constants and loop over axes; they are otherwise complete and never rewritten.

/// Threads in a workgroup.
pub const WORKGROUP: u32 = 64;

/// Workgroups along one axis of a dispatch, the most that WebGPU guarantees.
const WORKGROUPS_PER_AXIS: u32 = 65535;

pub(crate) const SCAN: &str = include_str!("wgsl/scan.wgsl");
pub(crate) const SORT_SEGMENTS: &str = include_str!("wgsl/sort_segments.wgsl");
pub(crate) const EXTREMES: &str = include_str!("wgsl/extremes.wgsl");
pub(crate) const DRIFT: &str = include_str!("wgsl/drift.wgsl");
pub(crate) const SEARCH_PARAMETERS: &str = include_str!("wgsl/search_parameters.wgsl");
pub(crate) const CELLS: &str = include_str!("wgsl/cells.wgsl");
pub(crate) const WINDOW: &str = include_str!("wgsl/window.wgsl");
pub(crate) const LIST: &str = include_str!("wgsl/list.wgsl");
pub(crate) const PERMUTATION: &str = include_str!("wgsl/permutation.wgsl");
const INVOCATION: &str = include_str!("wgsl/invocation.wgsl");
const PASS: &str = include_str!("wgsl/pass.wgsl");
const CALL: &str = include_str!("wgsl/call.wgsl");

/// The text of a kernel: the constants, the shared helpers, then the given parts.
pub(crate) fn assemble(dimension: usize, parts: &[&str]) -> String {
    let mut text = format!("const DIMENSION = {dimension}u;\nconst WORKGROUP = {WORKGROUP}u;\n\n{INVOCATION}");
    for part in parts {
        text.push('\n');
        text.push_str(part);
    }
    text
}

/// What stands before the text of a pass in `dimension` axes: the constants, the bindings of [`crate::PassPipeline`] and
/// functions to reach particles (`src/wgsl/pass.wgsl`). A pass's own text follows it, with an entry point such as
///
/// ```wgsl
/// @compute @workgroup_size(WORKGROUP)
/// fn name(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) workgroups: vec3<u32>) {
///     let slot = invocation_index(id, workgroups);
///     if (slot >= particles.count) { return; }
///     let a = order[slot];
///     for (var k = list_offsets[a]; k < list_offsets[a + 1u]; k++) { let b = list[k]; /* pair */ }
/// }
/// ```
pub fn pass_prelude(dimension: usize) -> String {
    assemble(dimension, &[PASS])
}

/// What stands before a function that is called for each row of a table (`src/wgsl/call.wgsl`).
pub(crate) fn call_prelude() -> String {
    assemble(1, &[CALL])
}

/// The dispatch that gives at least `items` threads: a plane of workgroups, see `invocation.wgsl`.
pub(crate) fn workgroups(items: u32) -> [u32; 3] {
    let groups = items.div_ceil(WORKGROUP).max(1);
    let across = groups.min(WORKGROUPS_PER_AXIS);
    [across, groups.div_ceil(across), 1]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn validate(name: &str, text: &str) -> Vec<String> {
        let module = naga::front::wgsl::parse_str(text)
            .unwrap_or_else(|error| panic!("{name}:\n{}", error.emit_to_string(text)));
        naga::valid::Validator::new(naga::valid::ValidationFlags::all(), naga::valid::Capabilities::empty())
            .validate(&module)
            .unwrap_or_else(|error| panic!("{name}:\n{}", error.emit_to_string(text)));
        let storage = module
            .global_variables
            .iter()
            .filter(|(_, variable)| matches!(variable.space, naga::AddressSpace::Storage { .. }))
            .count();
        assert!(storage <= 8, "{name} uses {storage} storage buffers, WebGPU guarantees 8");
        module
            .entry_points
            .iter()
            .map(|entry| {
                assert_eq!(entry.workgroup_size, [WORKGROUP, 1, 1], "{name}");
                entry.name.clone()
            })
            .collect()
    }

    #[test]
    fn every_kernel_is_valid_without_a_device() {
        for dimension in 1..=3 {
            let expected: [(&str, &[&str], &[&str]); 10] = [
                ("scan", &[SCAN], &["scan_blocks", "add_sums"]),
                ("sort_segments", &[SORT_SEGMENTS], &["sort_segments"]),
                ("extremes", &[EXTREMES], &["per_workgroup", "of_workgroups"]),
                ("drift", &[DRIFT], &["drift"]),
                ("cells", &[SEARCH_PARAMETERS, CELLS], &["bin", "scatter", "pack"]),
                ("window", &[SEARCH_PARAMETERS, WINDOW], &["window"]),
                ("list", &[SEARCH_PARAMETERS, LIST], &["count", "fill"]),
                ("permutation", &[PERMUTATION], &["permute"]),
                ("pass", &[PASS], &[]),
                ("call", &[CALL], &[]),
            ];
            for (name, parts, entries) in expected {
                assert_eq!(validate(name, &assemble(dimension, parts)), entries, "{name}");
            }
        }
    }

    #[test]
    fn dispatches_cover_their_items() {
        for items in [0, 1, 64, 65, 65535 * 64, 65535 * 64 + 1, 1 << 31, u32::MAX] {
            let [x, y, z] = workgroups(items);
            assert!(x <= WORKGROUPS_PER_AXIS && y <= WORKGROUPS_PER_AXIS && z == 1);
            assert!(u64::from(x) * u64::from(y) * u64::from(WORKGROUP) >= u64::from(items), "{items}");
            assert!(x * y >= 1);
        }
    }
}
