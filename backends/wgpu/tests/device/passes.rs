//! The frame for generated passes, with passes written by hand in the shape that generated ones have.

use etalon_wgpu::{NeighbourSearch, Parameters, PassBuffers, PassPipeline, Timer, Torus, wgsl};

use crate::common::{Particles, Random, device};

/// sum_b m_b (1 - r^2 / h_a^2), without a product that a driver could rewrite, and the sum of the separations x_a - x_b
/// along the last axis, which knows signs.
const SUM: &str = r"
@compute @workgroup_size(WORKGROUP)
fn sum(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) workgroups: vec3<u32>) {
    let slot = invocation_index(id, workgroups);
    if (slot >= particles.count) {
        return;
    }
    let a = order[slot];
    let reach_squared = field(0u, a) * field(0u, a);
    var total = parameters[0];
    var shift = 0.0;
    for (var k = list_offsets[a]; k < list_offsets[a + 1u]; k++) {
        let b = list[k];
        var distance_squared = 0.0;
        for (var axis = 0u; axis < DIMENSION; axis++) {
            let x = separation(axis, a, b);
            distance_squared = fma(x, x, distance_squared);
        }
        shift += separation(DIMENSION - 1u, a, b);
        total = fma(field(1u, b), 1.0 - distance_squared / reach_squared, total);
    }
    set_field(2u, a, total);
    set_field(3u, a, shift);
}
";

#[test]
fn a_pair_sum_equals_the_same_sum_on_the_host() {
    let Some(device) = device() else { return };
    let mut random = Random(40);
    for dimension in 1..=3 {
        let count = 1000;
        let torus = Torus::new(&[1.0, 1.5, 2.0][..dimension]).unwrap();
        let coordinates = (0..dimension).map(|_| (0..count).map(|_| random.word()).collect()).collect();
        // Some 15 to 50 neighbours.
        let size = [0.02, 0.15, 0.22][dimension - 1];
        let reach = (0..count).map(|_| (size * random.between(1.0, 1.2)) as f32).collect();
        let particles = Particles { torus, coordinates, reach };
        let mass: Vec<f32> = (0..count).map(|_| random.between(0.5, 1.5) as f32).collect();

        let (coordinates, fields) = particles.upload(device, 4);
        fields.upload(device, 1, &mass).unwrap();
        let parameters = Parameters::new(device, 1).unwrap();
        parameters.upload(device, 0, &[0.25]).unwrap();
        let mut search = NeighbourSearch::new(device, &coordinates, &fields, 0).unwrap();
        search.build(device, &mut Timer::off()).unwrap();

        let prelude = wgsl::pass_prelude(dimension);
        let sum = PassPipeline::new(device, "sum", &(prelude + SUM), "sum").unwrap();
        let buffers =
            PassBuffers { fields: &fields, coordinates: &coordinates, lists: search.lists(), parameters: &parameters };
        let bindings = sum.bind(device, &buffers).unwrap();
        assert!(bindings.suits(search.lists()));
        bindings.run(device, &mut Timer::off(), &[&sum]).unwrap();
        let found = fields.download(device, 2).unwrap();
        let shifts = fields.download(device, 3).unwrap();

        let (offsets, list) = search.lists().download(device).unwrap();
        let mut largest = (0.0, 0.0);
        let mut identical = 0;
        for a in 0..count {
            let neighbours = &list[offsets[a] as usize..offsets[a + 1] as usize];
            let reach_squared = f64::from(particles.reach[a]).powi(2);
            let (mut total, mut magnitude, mut unfused) = (0.25, 0.25, 0.25f32);
            let (mut shift, mut distances) = (0.0, 0.0);
            for b in neighbours {
                let b = *b as usize;
                let along = |axis: usize| {
                    torus.separation(axis, particles.coordinates[axis][a], particles.coordinates[axis][b])
                };
                shift += f64::from(along(dimension - 1));
                distances += f64::from(along(dimension - 1).abs());
                let ratio = (0..dimension).map(|axis| f64::from(along(axis)).powi(2)).sum::<f64>() / reach_squared;
                total += f64::from(mass[b]) * (1.0 - ratio);
                magnitude += f64::from(mass[b]) * (1.0 + ratio);
                let distance_squared = (0..dimension).fold(0.0, |sum, axis| along(axis) * along(axis) + sum);
                unfused += mass[b] * (1.0 - distance_squared / (particles.reach[a] * particles.reach[a]));
            }
            identical += usize::from(found[a].to_bits() == unfused.to_bits());
            // Believed from WGSL's accuracy table, u = 2^-23 (an operation is within one unit in the last place): a term
            // carries 3 for the squares and their sum, 1 for reach^2, 2.5 for the quotient, 1 for the difference, 1 for the
            // product, relative to m (1 + ratio); the sum of n terms adds n.
            let error = (f64::from(found[a]) - total).abs();
            let tolerance = (9.0 + neighbours.len() as f64) * 2f64.powi(-23) * magnitude;
            assert!(error <= tolerance, "{dimension}-D particle {a}: error {error:e}, tolerance {tolerance:e}");
            // Each addition is within one unit in the last place of a sum that stays below the sum of the magnitudes.
            let shift_error = (f64::from(shifts[a]) - shift).abs();
            let shift_tolerance = neighbours.len() as f64 * 2f64.powi(-23) * distances;
            assert!(
                shift_error <= shift_tolerance,
                "{dimension}-D particle {a}: shift error {shift_error:e}, tolerance {shift_tolerance:e}"
            );
            if error / tolerance > largest.0 {
                largest = (error / tolerance, tolerance);
            }
        }
        eprintln!(
            "{dimension}-D pair sum: largest error {:.3} of its tolerance {:e}; {identical} of {count} have the bits of \
             unfused f32",
            largest.0, largest.1
        );

        bindings.run(device, &mut Timer::off(), &[&sum]).unwrap();
        let again = fields.download(device, 2).unwrap();
        assert!(again.iter().zip(&found).all(|(a, b)| a.to_bits() == b.to_bits()), "the sum differs when repeated");
    }
}

#[test]
fn passes_are_timed_by_name() {
    let Some(device) = device() else { return };
    let particles = Particles {
        torus: Torus::new(&[1.0]).unwrap(),
        coordinates: vec![(0..5000).map(|k| k * 858_993).collect()],
        reach: vec![0.01; 5000],
    };
    let (coordinates, fields) = particles.upload(device, 4);
    let parameters = Parameters::new(device, 1).unwrap();
    let mut search = NeighbourSearch::new(device, &coordinates, &fields, 0).unwrap();
    let mut timer = Timer::new(device).unwrap();
    search.build(device, &mut timer).unwrap();
    let sum = PassPipeline::new(device, "sum", &(wgsl::pass_prelude(1) + SUM), "sum").unwrap();
    let buffers =
        PassBuffers { fields: &fields, coordinates: &coordinates, lists: search.lists(), parameters: &parameters };
    let bindings = sum.bind(device, &buffers).unwrap();
    bindings.run(device, &mut timer, &[&sum, &sum]).unwrap();
    let times = timer.read(device).unwrap();
    if !device.has_timestamps() {
        eprintln!("SKIPPED: the adapter has no timestamps");
        assert!(times.is_empty());
        return;
    }
    let time = times.iter().find(|time| time.name == "sum").unwrap();
    assert_eq!(time.runs, 2);
    assert!(time.seconds > 0.0 && time.seconds < 60.0, "{times:?}");
    assert!(times.iter().any(|time| time.name == "list: fill"), "{times:?}");
    // Read once, then forgotten.
    assert!(timer.read(device).unwrap().is_empty());
    // More groups than the timer holds still run.
    let text = wgsl::pass_prelude(1) + "@compute @workgroup_size(WORKGROUP) fn nothing() { }";
    let nothing = PassPipeline::new(device, "nothing", &text, "nothing").unwrap();
    for _ in 0..12 {
        bindings.run(device, &mut timer, &[&nothing; 100]).unwrap();
    }
    assert_eq!(timer.read(device).unwrap()[0].runs, 1024);
}
