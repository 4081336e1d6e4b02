//! The prefix sum: from counts to the places where each one's entries begin.

use bytemuck::NoUninit;

use crate::program::{Program, Slot};
use crate::{Device, Result, wgsl};

/// Values that one workgroup sums; `BLOCK` in `scan.wgsl`.
const BLOCK: u32 = 16 * wgsl::WORKGROUP;

const SCAN_BLOCKS: usize = 0;
const ADD_SUMS: usize = 1;

#[derive(Clone, Copy, NoUninit)]
#[repr(C)]
struct ScanParameters {
    length: u32,
    blocks: u32,
    padding: [u32; 2],
}

/// The kernels, compiled once.
#[derive(Debug, Clone)]
pub(crate) struct Scanner {
    program: Program<2>,
}

/// The exclusive prefix sum of a buffer, in place, saturating at 2^32 - 1. Integers: the same at every run.
#[derive(Debug)]
pub(crate) struct Scan {
    program: Program<2>,
    /// From the buffer itself to the level whose sums fit one block.
    levels: Vec<Level>,
}

#[derive(Debug)]
struct Level {
    bound: wgpu::BindGroup,
    length: u32,
    blocks: u32,
}

impl Scanner {
    pub fn new(device: &Device) -> Result<Self> {
        let slots = [Slot::ReadWrite, Slot::ReadWrite, Slot::Uniform];
        let text = wgsl::assemble(1, &[wgsl::SCAN]);
        Ok(Self { program: Program::new(device, "scan", &text, &slots, ["scan_blocks", "add_sums"])? })
    }

    /// Prepares the scan of the first `length` values of a buffer.
    pub fn scan(&self, device: &Device, data: &wgpu::Buffer, length: u32) -> Result<Scan> {
        let mut levels = Vec::new();
        let mut data = data.clone();
        let mut length = length;
        loop {
            let blocks = length.div_ceil(BLOCK);
            let sums = device.storage("the sums of a scan", 4 * u64::from(blocks))?;
            let parameters =
                device.uniform("the length of a scan", &ScanParameters { length, blocks, padding: [0; 2] })?;
            let bound = self.program.bind(device, &[&data, &sums, &parameters])?;
            levels.push(Level { bound, length, blocks });
            if blocks == 1 {
                return Ok(Scan { program: self.program.clone(), levels });
            }
            (data, length) = (sums, blocks);
        }
    }
}

impl Scan {
    pub fn record(&self, pass: &mut wgpu::ComputePass<'_>) {
        for level in &self.levels {
            self.program.dispatch(pass, SCAN_BLOCKS, &level.bound, level.blocks * wgsl::WORKGROUP);
        }
        for level in self.levels.iter().rev().skip(1) {
            self.program.dispatch(pass, ADD_SUMS, &level.bound, level.length);
        }
    }
}

#[cfg(test)]
mod tests {
    use std::io::Write;

    use super::*;
    use crate::transfer::Region;
    use crate::{AdapterPreference, Timer};

    fn scanned(device: &Device, values: &[u32]) -> Vec<u32> {
        let bytes = 4 * values.len() as u64;
        let buffer = device.storage("values", bytes).unwrap();
        device.write(&buffer, 0, values).unwrap();
        let scan = Scanner::new(device).unwrap().scan(device, &buffer, values.len() as u32).unwrap();
        device.submit("scanning", |encoder| scan.record(&mut Timer::off().begin(encoder, "scan"))).unwrap();
        device.read(&[Region { buffer: &buffer, offset: 0, bytes }]).unwrap()
    }

    /// Lengths on both sides of every boundary: thread, block, and one, two and three levels of blocks.
    #[test]
    fn prefix_sums_are_exact_at_every_length() {
        let device = match Device::open(AdapterPreference::from_environment()) {
            Ok(device) => device,
            Err(error) => {
                let required = std::env::var("ETALON_REQUIRE_ADAPTER").is_ok_and(|value| value != "0");
                assert!(!required, "ETALON_REQUIRE_ADAPTER is set, but {error}");
                // Not by eprintln, which the test harness keeps to itself.
                let _ = writeln!(std::io::stderr(), "SKIPPED: no adapter");
                return;
            }
        };
        for length in [1, 2, 15, 16, 17, 1023, 1024, 1025, 5000, 1 << 20, (1 << 20) + 1, 1_300_001] {
            let values: Vec<u32> = (0..length).map(|k: u32| k.wrapping_mul(2_654_435_761) >> 22).collect();
            let mut sum = 0;
            let expected: Vec<u32> = values
                .iter()
                .map(|value| {
                    sum += value;
                    sum - value
                })
                .collect();
            assert!(scanned(&device, &values) == expected, "length {length}");
        }
        // A sum beyond 32 bits stays at the largest value instead of wrapping round.
        let mut large = vec![0; 3000];
        large[10] = u32::MAX - 1;
        large[2000] = 2;
        let result = scanned(&device, &large);
        assert_eq!((result[10], result[11], result[2000]), (0, u32::MAX - 1, u32::MAX - 1));
        assert_eq!((result[2001], result[2999]), (u32::MAX, u32::MAX));
    }
}
