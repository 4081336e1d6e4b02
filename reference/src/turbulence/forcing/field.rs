//! The force at many places: [`force_at`](super::force_at), with the sines and cosines of each axis taken once for all waves.

use super::ForceWave;
use crate::equations::turbulence::driving_term;
use etalon_kernels_gen::Vector;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Places that are looked at together, so that the inner loops run over many.
const TOGETHER: usize = 64;

/// The cosine and sine of one axis' share of the phase, for so many waves along it, by place.
type Axis = Vec<[[f64; 2]; TOGETHER]>;

/// The force of the waves at each place, by axis. The sum is that of `force_at`, wave by wave; its phases are sums over the axes, so that cosine
/// and sine of each are products.
pub(super) fn accelerations<const D: usize>(waves: &[ForceWave<D>], places: &[Vec<u64>; D]) -> [Vec<f64>; D] {
    let count = places.first().map_or(0, Vec::len);
    let starts: Vec<usize> = (0..count).step_by(TOGETHER).collect();
    let blocks: Vec<[Vector<f64, D>; TOGETHER]> = starts
        .into_par_iter()
        .map(|start| block(waves, places.each_ref().map(|axis| &axis[start..count.min(start + TOGETHER)])))
        .collect();
    std::array::from_fn(|axis| blocks.iter().flatten().take(count).map(|force| force[axis]).collect())
}

fn block<const D: usize>(waves: &[ForceWave<D>], places: [&[u64]; D]) -> [Vector<f64, D>; TOGETHER] {
    let most = waves.iter().flat_map(|wave| wave.wave_vector).map(i32::unsigned_abs).max().unwrap_or(0);
    let tables: [Axis; D] = places.map(|axis| (0..=most).map(|n| harmonic(n, axis)).collect());
    let mut sum = [Vector::zero(); TOGETHER];
    for wave in waves {
        let mut phase = [[1.0, 0.0]; TOGETHER];
        for (axis, &n) in wave.wave_vector.iter().enumerate().filter(|(_, n)| **n != 0) {
            let sign = f64::from(n.signum());
            for ([cosine, sine], [c, s]) in phase.iter_mut().zip(&tables[axis][n.unsigned_abs() as usize]) {
                let s = sign * s;
                (*cosine, *sine) = (*cosine * c - *sine * s, *sine * c + *cosine * s);
            }
        }
        for (sum, [cosine, sine]) in sum.iter_mut().zip(phase) {
            *sum = *sum + driving_term(1.0, wave.real, wave.imaginary, cosine, sine);
        }
    }
    sum
}

/// Cosine and sine of `n` waves along an axis. The phase is formed in whole numbers, as exactly for `n` waves as for one.
fn harmonic(n: u32, axis: &[u64]) -> [[f64; 2]; TOGETHER] {
    let mut table = [[1.0, 0.0]; TOGETHER];
    for (entry, x) in table.iter_mut().zip(axis) {
        let turn = x.wrapping_mul(u64::from(n)) as i64 as f64;
        let (sine, cosine) = (turn * (TAU / 18_446_744_073_709_551_616.0)).sin_cos();
        *entry = [cosine, sine];
    }
    table
}
