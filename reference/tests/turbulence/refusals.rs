//! What cannot be measured or driven is refused in one sentence, with a remedy; nothing comes out as NaN.

use crate::places::{cube, particles};
use etalon_reference::domain::Domain;
use etalon_reference::schemes::{Kernel, MachReading, Weighting};
use etalon_reference::turbulence::density_pdf::density_pdf;
use etalon_reference::turbulence::forcing::{Driving, Forcing};
use etalon_reference::turbulence::grid::VelocityGrid;
use etalon_reference::turbulence::power_law::fit_power_law;
use etalon_reference::turbulence::spectrum::velocity_spectrum;
use etalon_reference::turbulence::structure_function::{PairChoice, mach_numbers, rms_mach_number, structure_function};
use etalon_reference::turbulence::{Bins, Snapshot, TurbulenceError};

#[track_caller]
fn refused<T: std::fmt::Debug>(result: Result<T, TurbulenceError>, sentence: &str) {
    assert_eq!(result.unwrap_err().to_string(), sentence);
}

fn pair() -> Snapshot<1> {
    particles(1.0, &[[0.25], [0.5]], |i| [i as f64])
}

#[test]
fn particles_that_are_none() {
    let columns = |velocity: Vec<f64>, mass: Vec<f64>| Snapshot::new(cube::<1>(1.0), [vec![0; 2]], [velocity], mass);
    refused(columns(vec![], vec![]), "there are no particles: give at least 1");
    refused(
        columns(vec![0.0], vec![1.0; 2]),
        "the list of velocities has 1 entries where 2 are due: give one for each",
    );
    refused(columns(vec![0.0, f64::NAN], vec![1.0; 2]), "entry 1 of the velocities is NaN; it must be finite");
    refused(columns(vec![0.0; 2], vec![0.0, 1.0]), "entry 0 of the masses is 0; it must be finite and positive");
    refused(
        columns(vec![0.0; 3], vec![1.0; 3]),
        "the list of coordinates has 2 entries where 3 are due: give one for each",
    );
}

#[test]
fn forces_that_make_no_sense() {
    let force = |domain: Domain<2>, driving| Forcing::new(&domain, driving, 0);
    let good = Driving::subsonic();
    let nan = Driving { solenoidal_weight: f64::NAN, ..good };
    refused(force(cube(1.0), nan), "the solenoidal weight is NaN; it must lie between 0 and 1");
    let more = Driving { solenoidal_weight: 1.1, ..good };
    refused(force(cube(1.0), more), "the solenoidal weight is 1.1; it must lie between 0 and 1");
    let still = Driving { velocity: 0.0, ..good };
    refused(force(cube(1.0), still), "the driving velocity is 0; it must be finite and positive");
    let curl = Driving { solenoidal_weight: 1.0, ..good };
    refused(
        Forcing::new(&cube::<1>(1.0), curl, 0),
        "the solenoidal weight is 1; in one dimension nothing is solenoidal: take less",
    );
    refused(
        force(Domain::new([0.0; 2], [1.0, 2.0], [true; 2]).unwrap(), good),
        "the box has the sides [1.0, 2.0], periodic [true, true]; waves need a periodic box with equal sides",
    );
    refused(
        force(Domain::new([0.0; 2], [1.0; 2], [true, false]).unwrap(), good),
        "the box has the sides [1.0, 1.0], periodic [true, false]; waves need a periodic box with equal sides",
    );
    let mut running = Forcing::new(&cube::<1>(1.0), good, 0).unwrap();
    refused(running.advance(-0.1), "the time step of the driving is -0.1; it must be finite and not negative");
    refused(running.advance(f64::INFINITY), "the time step of the driving is inf; it must be finite and not negative");
    refused(
        running.on(&particles(2.0, &[[0.5]], |_| [0.0])),
        "the side of the particles' box is 2; the force was made for another box: make one for this",
    );
}

#[test]
fn grids_and_spectra_that_make_no_sense() {
    refused(
        VelocityGrid::<2>::from_components(0, [vec![], vec![]]),
        "the number of grid points a side is 0; take at least one, and no more than 2^32 points in all",
    );
    refused(
        VelocityGrid::nearest(&particles(1.0, &[[0.5; 3]], |_| [0.0; 3]), 100_000),
        "the number of grid points a side is 100000; take at least one, and no more than 2^32 points in all",
    );
    refused(
        VelocityGrid::<1>::from_components(2, [vec![1.0]]),
        "the component of the grid's velocities has 1 entries where 2 are due: give one for each",
    );
    refused(
        VelocityGrid::<1>::from_components(2, [vec![1.0, f64::INFINITY]]),
        "entry 1 of the grid's velocities is inf; it must be finite",
    );
    let coarse = VelocityGrid::<1>::from_components(3, [vec![1.0; 3]]).unwrap();
    refused(velocity_spectrum(&coarse), "the grid has 3 points a side, and a spectrum needs at least 4: refine it");
    let smoothed = |h: f64, v: f64| VelocityGrid::smoothed(&pair(), Kernel::MixedSinc, &[0.2, h], &[1.0, v], 4);
    refused(smoothed(f64::NAN, 1.0), "entry 1 of the smoothing lengths is NaN; it must be finite and positive");
    refused(smoothed(0.2, 0.0), "entry 1 of the volumes is 0; it must be finite and positive");
    refused(
        smoothed(0.3, 1.0),
        "entry 1 of the smoothing lengths is 0.3; a support must fit into the box: use more particles or fewer neighbours",
    );
    let still = velocity_spectrum(&VelocityGrid::<1>::from_components(8, [vec![0.0; 8]]).unwrap()).unwrap();
    refused(still.bottleneck((1, 3)), "entry 0 of the compensated spectrum is 0; it must be finite and positive");
    refused(still.bottleneck((4, 9)), "none of the 3 shells falls into the bins from 4 to 9: widen them");
}

#[test]
fn structure_functions_that_make_no_sense() {
    let of = |cloud: &Snapshot<1>, from: f64, to: f64| {
        structure_function(cloud, &Bins::linear(from, to, 1).unwrap(), PairChoice::All)
    };
    refused(of(&particles(1.0, &[[0.5]], |_| [0.0]), 0.0, 0.5), "there are no pairs of particles: give at least 1");
    refused(
        of(&pair(), 0.0, 0.6),
        "the largest distance is 0.6; nearest images reach half a side of the box: end the bins there",
    );
    refused(of(&pair(), -0.1, 0.4), "the smallest distance is -0.1; give none below zero");
    refused(of(&pair(), 0.3, 0.4), "none of the 1 pairs falls into the bins from 0.3 to 0.4: widen them");
    refused(
        structure_function(&pair(), &Bins::linear(0.0, 0.5, 1).unwrap(), PairChoice::Random { count: 0, seed: 0 }),
        "none of the 0 pairs falls into the bins from 0 to 0.5: widen them",
    );
    let scales = of(&pair(), 0.0, 0.5).unwrap();
    for wrong in [0.0, -1.0, f64::NAN] {
        refused(
            mach_numbers(&scales, wrong, MachReading::Halved),
            &format!("the sound speed is {wrong}; it must be finite and positive"),
        );
    }
    refused(
        rms_mach_number(&pair(), &[1.0]),
        "the list of sound speeds has 1 entries where 2 are due: give one for each",
    );
    refused(rms_mach_number(&pair(), &[1.0, 0.0]), "entry 1 of the sound speeds is 0; it must be finite and positive");
}

#[test]
fn distributions_and_slopes_that_make_no_sense() {
    let bins = Bins::linear(-1.0, 1.0, 2).unwrap();
    let pdf = |mass: &[f64], density: &[f64]| density_pdf(mass, density, Weighting::Mass, &bins);
    refused(pdf(&[], &[]), "there are no particles: give at least 1");
    refused(pdf(&[1.0], &[1.0, 1.0]), "the list of densities has 2 entries where 1 are due: give one for each");
    refused(pdf(&[1.0], &[0.0]), "entry 0 of the densities is 0; it must be finite and positive");
    refused(pdf(&[-1.0], &[1.0]), "entry 0 of the masses is -1; it must be finite and positive");
    let far = density_pdf(&[1.0], &[1.0], Weighting::Volume, &Bins::linear(1.0, 2.0, 1).unwrap());
    refused(far, "none of the 1 densities falls into the bins from 1 to 2: widen them");

    let fit = |x: &[f64], y: &[f64]| fit_power_law(x, y, (0.0, 10.0));
    refused(fit(&[], &[]), "none of the 0 points falls into the bins from 0 to 10: widen them");
    refused(fit(&[1.0, 2.0], &[1.0]), "the list of values has 1 entries where 2 are due: give one for each");
    refused(fit(&[0.0, 2.0], &[1.0; 2]), "entry 0 of the abscissae in the range is 0; it must be finite and positive");
    refused(fit(&[1.0, 2.0], &[1.0, -1.0]), "entry 1 of the values in the range is -1; it must be finite and positive");
    refused(fit(&[f64::NAN, 2.0], &[1.0; 2]), "entry 0 of the abscissae is NaN; it must be finite");
    refused(fit(&[2.0; 3], &[1.0; 3]), "all points of the slope are at 2: give at least two different places");
    refused(fit(&[2.0], &[1.0]), "all points of the slope are at 2: give at least two different places");
}
