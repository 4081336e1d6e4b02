//! DUSTYSHOCK, small, and under a tenth of the paper's drag: steps are ten times as long, and the fronts' own width, `t_s c_s`, is still far below
//! the particles' distance.

use etalon_reference::diagnostics::front_width::front_width;
use etalon_reference::engine::{Engine, PlainEngine};
use etalon_reference::fields;
use etalon_reference::scenes::dustyshock::{DRAG_COEFFICIENT, DustyShock, END_TIME, INTERFACE};
use etalon_reference::schemes::{CommonPoint, Drag, DragReconstruction, SlopeLimiter};
use etalon_reference::simulation::Simulation;

/// The state at the end.
struct End {
    /// `L_1` of the velocities of gas and dust.
    error: f64,
    /// The largest velocity.
    fastest: f64,
    /// The width of the shock in the gas, in smoothing lengths; none if it does not reach its strength.
    width: Option<f64>,
    /// The largest velocity difference between a particle of gas and its copy of dust.
    apart: f64,
}

fn end(particles: usize, point: CommonPoint, limiter: SlopeLimiter) -> End {
    let drag = Drag { reconstruction: DragReconstruction { point, limiter }, ..Drag::of(0.1 * DRAG_COEFFICIENT) };
    let scene = DustyShock { particles, drag, ..DustyShock::standard(1) };
    let set = scene.particles::<1>().unwrap();
    let mut simulation = Simulation::new(PlainEngine::<f64, 1>::new(&set), scene.physics()).unwrap();
    simulation.run(END_TIME, |_| {}).unwrap();
    let engine = simulation.engine();
    let velocity = engine.read_all(fields::VELOCITY).unwrap().swap_remove(0);
    let x: Vec<f64> = engine.coordinates(0).unwrap().iter().map(|&x| set.domain().decode(0, x)).collect();
    let exact = scene.exact().unwrap();
    let off: Vec<f64> = (0..set.len())
        .filter(|&i| set.particles()[i].mobile)
        .map(|i| (velocity[i] - exact.sample((x[i] - INTERFACE) / END_TIME).velocity).abs())
        .collect();
    let h = engine.read_scalar(fields::SMOOTHING_LENGTH).unwrap();
    let (gas, dust) = velocity.split_at(set.len() / 2);
    let end = End {
        error: off.iter().sum::<f64>() / off.len() as f64,
        fastest: velocity.iter().copied().fold(0.0, f64::max),
        width: front_width((0..gas.len()).map(|i| [x[i], gas[i], h[i]]), exact.contact().unwrap()),
        apart: gas.iter().zip(dust).map(|(g, d)| (g - d).abs()).fold(0.0, f64::max),
    };
    println!(
        "{particles}, {point}, {limiter}: L1 {:.4e}, fastest {:.4}, width {:.2?}, apart {:.4}",
        end.error, end.fastest, end.width, end.apart
    );
    end
}

/// PL20 Fig. 5: reconstruction brings the shock nearer to the exact one, without a limiter it overshoots.
#[test]
fn reconstruction_sharpens_the_shock_and_the_limiter_keeps_it_from_overshooting() {
    let without = end(64, CommonPoint::Particles, SlopeLimiter::Unlimited);
    let unlimited = end(64, CommonPoint::Barycentre, SlopeLimiter::Unlimited);
    let limited = end(64, CommonPoint::Barycentre, SlopeLimiter::MonotonizedCentral);
    assert!(limited.error < 0.65 * without.error, "{} and {}", limited.error, without.error);
    assert!(limited.error < unlimited.error && limited.fastest < unlimited.fastest);
    let wider = without.width.is_none_or(|without| limited.width.is_some_and(|limited| without > limited));
    assert!(wider && limited.width.is_some(), "{:?} and {:?}", limited.width, without.width);
    // The order of magnitude of the drift that pressure keeps up, t_s grad P / rho, is 6e-3 * 30: dust and gas are coupled.
    assert!(limited.apart < 0.2, "{}", limited.apart);
}

/// The error falls nearly as the spacing does, as it must at jumps.
#[test]
fn the_error_falls_with_the_spacing() {
    let [coarse, fine] = [48, 96].map(|n| end(n, CommonPoint::Barycentre, SlopeLimiter::MonotonizedCentral).error);
    let order = (coarse / fine).log2();
    assert!((0.6..1.4).contains(&order), "{coarse:e}, {fine:e}: order {order}");
}

/// Gas and dust of either side have the densities asked for, particles of one mass, and copies where the gas is.
fn the_tube_is_as_asked<const D: usize>(scene: DustyShock) {
    let set = scene.particles::<D>().unwrap();
    let (gas, dust) = set.particles().split_at(set.len() / 2);
    let species = set.dust().unwrap();
    assert!(species[..gas.len()].iter().all(|dust| !dust) && species[gas.len()..].iter().all(|dust| *dust));
    for (g, d) in gas.iter().zip(dust) {
        assert_eq!((g.position, g.mobile, g.velocity), (d.position, d.mobile, d.velocity));
        assert!((d.mass / g.mass - scene.dust_to_gas).abs() < 1e-15 && (g.mass / gas[0].mass - 1.0).abs() < 1e-15);
    }
    let area = (scene.rows as f64 * INTERFACE / scene.particles as f64).powi(D as i32 - 1);
    for (side, density) in [1.0, 0.125].into_iter().enumerate() {
        let inside =
            |p: &&etalon_reference::particles::Particle<D>| p.mobile && usize::from(p.position[0] > INTERFACE) == side;
        let mass: f64 = gas.iter().filter(inside).map(|p| p.mass).sum();
        // Up to a column at the end: the lattice of the thin side does not divide its length.
        let column = gas[0].mass * (scene.rows as f64).powi(D as i32 - 1);
        assert!((mass - density * INTERFACE * area).abs() <= column, "{D}-D side {side}: {mass}");
    }
    let left = gas.iter().filter(|p| p.mobile && p.position[0] < INTERFACE).count();
    assert_eq!(left, scene.particles * scene.rows.pow(D as u32 - 1));
}

#[test]
fn the_tube_holds_what_it_should() {
    the_tube_is_as_asked::<1>(DustyShock { dust_to_gas: 0.5, ..DustyShock::standard(1) });
    the_tube_is_as_asked::<2>(DustyShock { particles: 32, ..DustyShock::standard(2) });
    // The paper's own: 128 * 24 * 24 particles left.
    the_tube_is_as_asked::<3>(DustyShock::standard(3));
}
