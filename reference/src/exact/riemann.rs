//! The exact solution of the Riemann problem for an ideal gas.
//!
//! Two uniform states meet at x = 0, t = 0; the solution depends on $\xi = x/t$ alone. Each side answers with a shock
//! (pressure rises) or a rarefaction fan (pressure falls), and the pressure $p_*$ between them follows from
//! $f_L(p) + f_R(p) + u_R - u_L = 0$ (Toro 2009, *Riemann Solvers and Numerical Methods for Fluid Dynamics*, chapter 4).
//! The states may draw apart so fast that vacuum opens between them, and one of them may be vacuum from the start.

mod error;
mod side;
mod star;
#[cfg(test)]
mod tests;

pub use error::{Field, RiemannError, SideName};

use num_traits::Float;
use side::Side;

/// A uniform gas: density, velocity along x, pressure, in any consistent units.
///
/// Density and pressure both exactly 0 mean vacuum, whose velocity says nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State<F> {
    /// Mass per volume.
    pub density: F,
    /// Velocity along x.
    pub velocity: F,
    /// Pressure.
    pub pressure: F,
}

impl<F: Float> State<F> {
    /// No gas at all.
    pub fn vacuum() -> Self {
        State { density: F::zero(), velocity: F::zero(), pressure: F::zero() }
    }

    /// Whether there is no gas at all.
    pub fn is_vacuum(&self) -> bool {
        self.density.is_zero() && self.pressure.is_zero()
    }

    fn mirrored(self) -> Self {
        State { velocity: -self.velocity, ..self }
    }
}

/// How one side changes: speeds $dx/dt$ of what moves into it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Wave<F> {
    /// A jump to higher pressure.
    Shock {
        /// Where it is, x/t.
        speed: F,
    },
    /// A smooth fall to lower pressure.
    Rarefaction {
        /// Where the undisturbed gas ends, x/t.
        head: F,
        /// Where the star state, or vacuum, begins, x/t.
        tail: F,
    },
}

impl<F: Float> Wave<F> {
    /// The edge on the undisturbed side, x/t; for a shock its place.
    pub fn head(&self) -> F {
        match *self {
            Wave::Shock { speed } => speed,
            Wave::Rarefaction { head, .. } => head,
        }
    }

    /// The edge on the inner side, x/t; for a shock its place.
    pub fn tail(&self) -> F {
        match *self {
            Wave::Shock { speed } => speed,
            Wave::Rarefaction { tail, .. } => tail,
        }
    }

    /// The place of a shock, x/t; `None` for a rarefaction.
    pub fn shock(&self) -> Option<F> {
        match *self {
            Wave::Shock { speed } => Some(speed),
            Wave::Rarefaction { .. } => None,
        }
    }
}

/// What lies between the two waves: one pressure and velocity, and a density on either side of the contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Star<F> {
    /// $p_*$.
    pub pressure: F,
    /// $u_*$, also the speed of the contact.
    pub velocity: F,
    /// $\rho_{*L}$.
    pub density_left: F,
    /// $\rho_{*R}$.
    pub density_right: F,
}

/// A Riemann problem, solved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RiemannProblem<F> {
    left: Side<F>,
    /// Seen in a mirror, so that both sides are left sides.
    right: Side<F>,
    star: Option<Star<F>>,
}

impl<F: Float> RiemannProblem<F> {
    /// Solve for two states and the adiabatic index `gamma` of an ideal gas.
    ///
    /// # Errors
    /// A field that is not finite, a negative density or pressure, a density of 0 with pressure, `gamma` not above 1,
    /// or states so extreme that the solution overflows the number type.
    pub fn new(left: State<F>, right: State<F>, gamma: F) -> Result<Self, RiemannError> {
        error::check(SideName::Left, &left)?;
        error::check(SideName::Right, &right)?;
        error::check_gamma(gamma)?;
        let mut left = Side::new(left, gamma);
        let mut right = Side::new(right.mirrored(), gamma);
        let star = star::solve(&left, &right)?;
        if let Some(star) = star {
            left.meet(star.pressure, star.velocity);
            right.meet(star.pressure, -star.velocity);
        }
        Ok(RiemannProblem { left, right, star })
    }

    /// The state at $\xi = (x - x_c)/t$; at a jump the one on its left. `xi` must not be NaN.
    ///
    /// In vacuum density and pressure are 0 and the velocity is $\xi$, held between those of the gas fronts.
    pub fn sample(&self, xi: F) -> State<F> {
        match (self.star, self.left.front(), self.right.front().map(|front| -front)) {
            (Some(star), ..) if xi <= star.velocity => self.left.sample(xi),
            (Some(_), ..) => self.right.sample(-xi).mirrored(),
            (None, Some(front), _) if xi <= front => self.left.sample(xi),
            (None, _, Some(front)) if xi >= front => self.right.sample(-xi).mirrored(),
            (None, from, to) => {
                let velocity = xi.max(from.or(to).unwrap_or(xi)).min(to.or(from).unwrap_or(xi));
                State { velocity, ..State::vacuum() }
            }
        }
    }

    /// What lies between the waves; `None` where that is vacuum.
    pub fn star(&self) -> Option<Star<F>> {
        self.star
    }

    /// Speed of the contact between the two gases; `None` where vacuum parts them.
    pub fn contact(&self) -> Option<F> {
        self.star.map(|star| star.velocity)
    }

    /// The wave into the left state; `None` if that is vacuum.
    pub fn left_wave(&self) -> Option<Wave<F>> {
        self.left.wave()
    }

    /// The wave into the right state; `None` if that is vacuum.
    pub fn right_wave(&self) -> Option<Wave<F>> {
        self.right.wave().map(|wave| match wave {
            Wave::Shock { speed } => Wave::Shock { speed: -speed },
            Wave::Rarefaction { head, tail } => Wave::Rarefaction { head: -head, tail: -tail },
        })
    }
}
