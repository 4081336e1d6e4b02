//! What the program runs on, as far as the system tells.

use std::fs;

/// The processor's name.
pub fn processor() -> String {
    let information = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = information.lines().find_map(|line| line.strip_prefix("model name")?.split_once(':'));
    name.map_or_else(|| format!("{} processor", std::env::consts::ARCH), |(_, name)| name.trim().to_string())
}

/// Operating system and architecture.
pub fn system() -> String {
    format!("{} {}", std::env::consts::OS, std::env::consts::ARCH)
}

/// Hardware threads this process may use.
pub fn hardware_threads() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

/// Bytes this process can still have, where the system says so: of the machine, and of the control group it lives in.
pub fn available_memory() -> Option<u64> {
    let machine = proc_bytes("/proc/meminfo", "MemAvailable")?;
    let group = |file: &str| fs::read_to_string(format!("/sys/fs/cgroup/{file}")).ok()?.trim().parse::<u64>().ok();
    let limit = group("memory.max").zip(group("memory.current")).map(|(most, used)| most.saturating_sub(used));
    Some(limit.map_or(machine, |limit| limit.min(machine)))
}

/// The most memory this process ever held at once, bytes, where the system says so.
pub fn peak_memory() -> Option<u64> {
    proc_bytes("/proc/self/status", "VmHWM")
}

/// A line such as `MemAvailable:  1234 kB`.
fn proc_bytes(file: &str, key: &str) -> Option<u64> {
    let text = fs::read_to_string(file).ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix(key)?.strip_prefix(':'))?;
    Some(line.trim().trim_end_matches("kB").trim().parse::<u64>().ok()? * 1024)
}
