//! The device the tests share, and numbers to feed it.

use etalon_wgpu::{Coordinates, Device, FieldStore, Torus};

pub use crate::adapter::device;
pub use crate::random::Random;

/// Particles on a torus: `coordinates[axis][particle]`, and each one's support radius.
#[derive(Debug, Clone)]
pub struct Particles {
    pub torus: Torus,
    pub coordinates: Vec<Vec<u32>>,
    pub reach: Vec<f32>,
}

impl Particles {
    pub fn count(&self) -> usize {
        self.reach.len()
    }

    /// Stores on the device: the coordinates, and fields of which the first is the reach.
    pub fn upload(&self, device: &Device, components: usize) -> (Coordinates, FieldStore) {
        let coordinates = Coordinates::new(device, self.torus, self.count()).unwrap();
        for (axis, values) in self.coordinates.iter().enumerate() {
            coordinates.upload(device, axis, values).unwrap();
        }
        let fields = FieldStore::new(device, components, self.count()).unwrap();
        fields.upload(device, 0, &self.reach).unwrap();
        (coordinates, fields)
    }

    /// The neighbour lists by testing every pair, in the arithmetic of the kernel. WGSL leaves open whether fma(a, b, c)
    /// rounds once or twice, so there are two answers, `fused` or not; a device must give one of them.
    pub fn brute_force(&self, fused: bool) -> (Vec<u32>, Vec<u32>) {
        let fma = |a: f32, b: f32, c: f32| if fused { a.mul_add(b, c) } else { a * b + c };
        let dimension = self.torus.dimension();
        let scale = self.torus.length_per_unit();
        let mut offsets = vec![0];
        let mut list = Vec::new();
        for i in 0..self.count() {
            for j in (0..self.count()).filter(|j| *j != i) {
                let mut separation = [0.0f32; 3];
                for axis in 0..dimension {
                    let units = self.coordinates[axis][i].wrapping_sub(self.coordinates[axis][j]);
                    separation[axis] = units.cast_signed() as f32 * scale[axis];
                }
                let [x, y, z] = separation;
                let support = self.reach[i].max(self.reach[j]);
                if fma(z, z, fma(y, y, x * x)) < support * support {
                    list.push(j as u32);
                }
            }
            offsets.push(list.len() as u32);
        }
        (offsets, list)
    }
}
