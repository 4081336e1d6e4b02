//! Memory of a backend, counted from what it keeps.

use super::choices::{Backend, Precision};
use super::failure::Failure;
use super::machine;
use etalon_kernels_gen::components;
use etalon_reference::particles::Particle;
use etalon_reference::pipeline::Pipeline;

/// Bytes a particle, by what they are for.
#[derive(Clone, Debug, PartialEq)]
pub struct Memory {
    /// The fields.
    pub fields: f64,
    /// A second copy of them while particles are put in order or a pass writes.
    pub copy: f64,
    /// Coordinates, particle numbers and sorting keys.
    pub places: f64,
    /// What a pass reads of neighbours, packed.
    pub records: f64,
    /// The neighbour list.
    pub neighbours: f64,
}

impl Memory {
    /// Of a backend that runs this pipeline with so many neighbours within a support.
    pub fn of<const D: usize>(backend: Backend, precision: Precision, pipeline: &Pipeline, neighbours: f64) -> Self {
        let size = precision.bytes() as f64;
        let numbers = components(&pipeline.fields::<D>(), D).len() as f64;
        let widest = |of: &dyn Fn(&etalon_kernels_gen::Footprint) -> usize| {
            pipeline.footprints::<D>().iter().map(of).max().unwrap_or(0) as f64
        };
        let axes = D as f64;
        match backend {
            // Columns; what a pass writes is built beside them. Lists grow by doubling: half as much again on average.
            Backend::Reference => Memory {
                fields: numbers * size,
                copy: widest(&|f| components(&f.out, D).len()) * size,
                places: axes * 8.0 + 16.0,
                records: 0.0,
                neighbours: (neighbours * 4.0) * 1.5 + 8.0,
            },
            // Blocks, sorted one component at a time. Records hold coordinates and fields, padded to whole groups of four words.
            Backend::Simd => Memory {
                fields: numbers * size,
                copy: size,
                places: 2.0 * (axes * size + 4.0) + 24.0,
                records: widest(&|f| (D + components(&f.other, D).len()).next_multiple_of(4)) * size,
                neighbours: neighbours * 4.0 * 1.125 + 4.0,
            },
            // Buffers on the adapter, none copied.
            Backend::Wgpu => Memory {
                fields: numbers * size,
                copy: 0.0,
                places: 2.0 * (axes * size + 4.0) + 24.0,
                records: widest(&|f| (D + components(&f.other, D).len()).next_multiple_of(4)) * size,
                neighbours: neighbours * 4.0 * 1.25 + 4.0,
            },
        }
    }

    /// Bytes a particle in all.
    pub fn total(&self) -> f64 {
        self.fields + self.copy + self.places + self.records + self.neighbours
    }
}

/// What a run keeps of a particle beside its backend: the initial state, and results that are compared, with their places.
pub fn beside<const D: usize>() -> f64 {
    /// Numbers of a result: position, velocity and five scalars; that of the reference, that of the run, and that kept for the file.
    const RESULTS: usize = 3;
    (size_of::<Particle<D>>() + RESULTS * (2 * D + 6) * 8) as f64
}

/// Refuses a size that does not fit into what memory there is, in the words that asked for it; where the system does not say, all sizes are tried.
pub fn check(asked: &str, particles: usize, bytes_each: f64) -> Result<(), Failure> {
    // Particles have 32-bit numbers.
    const MOST: usize = u32::MAX as usize / 2;
    let available = machine::available_memory();
    let needed = particles as f64 * bytes_each;
    let gigabytes = |bytes: f64| bytes / f64::from(1 << 30);
    match available {
        Some(available) if needed > available as f64 => Err(Failure::BadInput(format!(
            "{asked}: that takes about {:.1} GiB of memory ({bytes_each:.0} bytes a particle) and {:.1} GiB are free; \
             give at most {}",
            gigabytes(needed),
            gigabytes(available as f64),
            ((available as f64 / bytes_each) as usize).min(MOST)
        ))),
        _ if particles > MOST => {
            Err(Failure::BadInput(format!("{asked}: particles are numbered with 32 bits; give at most {MOST}")))
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_reference::scenes::sod::Sod;

    #[test]
    fn a_particle_of_the_usual_step_fits_into_a_kilobyte_in_single_precision() {
        let physics = Sod::standard(3).physics();
        let pipeline = Pipeline::of_scene::<3>(&physics);
        let single = Memory::of::<3>(Backend::Simd, Precision::Single, &pipeline, 100.0).total();
        let double = Memory::of::<3>(Backend::Simd, Precision::Double, &pipeline, 100.0).total();
        assert!(single < 1000.0, "{single} bytes in single precision");
        // The list of neighbours has the same four bytes an entry in either precision; all else doubles.
        assert!(single < double && double < 1200.0, "{double} bytes in double precision");
    }

    #[test]
    fn a_size_beyond_memory_is_refused_with_one_that_fits() {
        let error = check("--n 9e18", usize::MAX / 2, 1000.0).unwrap_err().to_string();
        assert!(error.contains("give at most"), "{error}");
        assert!(check("--n 1", 1, 1000.0).is_ok());
    }
}
