//! What the tests of files share.

use super::{Column, Frame, Snapshot};
use std::path::PathBuf;
use std::sync::atomic::{AtomicU32, Ordering};

/// A folder of its own, removed at the end.
pub struct Place(PathBuf);

impl Place {
    pub fn new(test: &str) -> Self {
        // Tests run side by side, and some take several places.
        static TAKEN: AtomicU32 = AtomicU32::new(0);
        let number = TAKEN.fetch_add(1, Ordering::Relaxed);
        let path = std::env::temp_dir().join(format!("etalon-snapshot-{test}-{}-{number}", std::process::id()));
        let _ = std::fs::remove_dir_all(&path);
        std::fs::create_dir_all(&path).unwrap();
        Place(path)
    }
    pub fn path(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }
    pub fn listing(&self) -> Vec<String> {
        let entries = std::fs::read_dir(&self.0).unwrap();
        let mut names: Vec<String> = entries.map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }
}

impl Drop for Place {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// A small snapshot in so many dimensions, with numbers that are easily spoilt: tiny, huge, a third, a negative zero.
pub fn small(dimension: usize) -> Snapshot {
    let mut columns = Vec::new();
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate().take(dimension) {
        columns.push(Column::new(name, "L", vec![0.125 + axis as f64, 0.5, 0.75]));
        columns.push(Column::new(format!("velocity_{name}"), "L T^-1", vec![-1.0 / 3.0, -0.0, axis as f64]));
    }
    columns.push(Column::new("mass", "M", vec![1.0, 5e-300, 2.0]));
    columns.push(Column::new("density", "M L^-nu", vec![1.0 / 3.0, 1e300, 5e-324]));
    columns.push(Column::new("internal_energy", "L^2 T^-2", vec![2.5, 0.0, 1.0]));
    columns.push(Column::new("smoothing_length", "L", vec![0.1, 0.2, 0.3]));
    columns.push(Column::new("kernel_normalisation", "", vec![1.0, 1.001, 0.999]));
    let frame = Frame {
        lower: vec![0.0; dimension],
        upper: (0..dimension).map(|axis| 2.0 + axis as f64).collect(),
        periodic: (0..dimension).map(|axis| axis == 0).collect(),
    };
    Snapshot::new(dimension, columns)
        .unwrap()
        .with_ids(vec![7, 3, 1 << 40])
        .unwrap()
        .at_time(0.1)
        .in_frame(frame)
        .unwrap()
}
