//! Small passes with everything in them that real ones have: branches, vectors, matrices, equations, sums that vanish.

use etalon_kernels_gen::{
    Field, Mask, Matrix, Nameable, Pass, Rank, Real, Reduction, Scalar, Separation, Symmetric, Update, Vector, record,
};

const fn field(name: &'static str, rank: Rank) -> Field {
    Field { name, symbol: "", unit: "", rank, reduction: Reduction::Sum }
}
pub const MASS: Field = field("mass", Rank::Scalar);
pub const INVERSE_H: Field = field("inverse_h", Rank::Scalar);
pub const DENSITY: Field = field("density", Rank::Scalar);
pub const UNUSED: Field = field("unused", Rank::Scalar);
pub const VELOCITY: Field = field("velocity", Rank::Vector);
pub const POSITION: Field = field("position", Rank::Vector);
pub const INVERSE_MATRIX: Field = field("inverse_matrix", Rank::Symmetric);
pub const VELOCITY_GRADIENT: Field = field("velocity_gradient", Rank::Matrix);
pub const ACCELERATION: Field = field("acceleration", Rank::Vector);
pub const SIGNAL_SPEED: Field = Field { reduction: Reduction::Max, ..field("signal_speed", Rank::Scalar) };
pub const HEATING: Field = field("heating", Rank::Scalar);
/// A name that WGSL and C keep for themselves.
pub const TARGET: Field = field("target", Rank::Scalar);

record! {
    /// Read of the particle.
    pub struct DensityOwn { mass: Scalar = MASS, inverse_h: Scalar = INVERSE_H, unused: Scalar = UNUSED }
}
record! {
    /// Read of the neighbour.
    pub struct DensityOther { mass: Scalar = MASS }
}
record! {
    /// Summed, and written.
    pub struct DensitySums { density: Scalar = DENSITY }
}

/// A density with a two-piece kernel.
#[derive(Clone, Copy)]
pub struct Density;

/// The cubic spline, without its normalisation.
pub fn spline<R: Real>(q: R) -> R {
    R::equation("toy:1", "spline", || {
        let inner = (R::one() - q).max(R::zero()).named("inner");
        let outer = (R::lit(2.0) - q).max(R::zero()).named("outer");
        let outer_cubed = outer.power(3);
        q.lt(R::one()).choose(|| outer_cubed - R::lit(4.0) * inner.power(3), || outer_cubed)
    })
}

impl<const D: usize> Pass<D> for Density {
    type Own<R: Real> = DensityOwn<R, D>;
    type Other<R: Real> = DensityOther<R, D>;
    type Sums<R: Real> = DensitySums<R, D>;
    type Out<R: Real> = DensitySums<R, D>;
    const NAME: &'static str = "density";

    fn pair<R: Real>(
        &self,
        own: &Self::Own<R>,
        other: &Self::Other<R>,
        separation: &Separation<R, D>,
    ) -> Self::Sums<R> {
        let q = (separation.r_squared.sqrt() * own.inverse_h).named("q");
        DensitySums { density: other.mass * spline(q) }
    }
    fn finish<R: Real>(&self, own: &Self::Own<R>, sums: &Self::Sums<R>) -> Self::Out<R> {
        let norm = (R::lit(0.25) * own.inverse_h.power(D as u32)).named("norm");
        DensitySums { density: norm * own.mass.mul_add(R::lit(4.0), sums.density) }
    }
}

record! {
    /// Read of the particle.
    pub struct MomentumOwn {
        density: Scalar = DENSITY, velocity: Vector = VELOCITY, inverse_matrix: Symmetric = INVERSE_MATRIX,
        velocity_gradient: Matrix = VELOCITY_GRADIENT,
    }
}
record! {
    /// Read of the neighbour.
    pub struct MomentumOther {
        mass: Scalar = MASS, density: Scalar = DENSITY, velocity: Vector = VELOCITY,
        velocity_gradient: Matrix = VELOCITY_GRADIENT,
    }
}
record! {
    /// Summed.
    pub struct MomentumSums {
        acceleration: Vector = ACCELERATION, heating: Scalar = HEATING, signal_speed: Scalar = SIGNAL_SPEED,
    }
}
record! {
    /// Written.
    pub struct MomentumOut { acceleration: Vector = ACCELERATION, heating: Scalar = HEATING, target: Scalar = TARGET }
}

/// A force with a limiter of both particles; `heats` is a choice of the scene.
#[derive(Clone, Copy)]
pub struct Momentum {
    pub heats: bool,
}

/// How much of the gradient is compression, between zero and one.
pub fn limiter<R: Real, const D: usize>(gradient: Matrix<R, D>) -> R {
    R::equation("toy:2", "limiter", || {
        let divergence = gradient.trace().abs().named("divergence");
        let distance = (gradient.0[0][D - 1] - gradient.0[D - 1][0]).abs().named("distance");
        let total = divergence + distance;
        let moving = total.gt(R::zero());
        R::pick(moving, divergence / R::pick(moving, total, R::one()), R::zero())
    })
}

impl<const D: usize> Pass<D> for Momentum {
    type Own<R: Real> = MomentumOwn<R, D>;
    type Other<R: Real> = MomentumOther<R, D>;
    type Sums<R: Real> = MomentumSums<R, D>;
    type Out<R: Real> = MomentumOut<R, D>;
    const NAME: &'static str = "momentum";

    fn pair<R: Real>(
        &self,
        own: &Self::Own<R>,
        other: &Self::Other<R>,
        separation: &Separation<R, D>,
    ) -> Self::Sums<R> {
        let v_ab = (own.velocity - other.velocity).named("v_ab");
        let approach = v_ab.dot(separation.x_ab).named("approach");
        let strength = (limiter(own.velocity_gradient) + limiter(other.velocity_gradient)) * R::lit(0.3);
        let speed = approach.lt(R::zero()).choose(|| -approach, R::zero);
        let force = (other.mass * strength * speed / (own.density + other.density)).named("force");
        let direction: Vector<R, D> = own.inverse_matrix.apply(separation.x_ab);
        let heating = if self.heats { force * approach } else { R::zero() };
        MomentumSums { acceleration: direction.scale(-force), heating, signal_speed: speed }
    }
    fn finish<R: Real>(&self, own: &Self::Own<R>, sums: &Self::Sums<R>) -> Self::Out<R> {
        MomentumOut {
            acceleration: sums.acceleration,
            heating: sums.heating * own.density,
            target: sums.signal_speed / R::lit(3.0),
        }
    }
}

record! {
    /// Read.
    pub struct DriftOwn { position: Vector = POSITION, velocity: Vector = VELOCITY }
}
record! {
    /// Written.
    pub struct DriftOut { position: Vector = POSITION }
}

/// Motion with constant velocity.
#[derive(Clone, Copy)]
pub struct Drift;

impl<const D: usize> Update<D> for Drift {
    type Own<R: Real> = DriftOwn<R, D>;
    type Out<R: Real> = DriftOut<R, D>;
    const NAME: &'static str = "drift";

    fn apply<R: Real>(&self, own: &Self::Own<R>, time_step: R) -> Self::Out<R> {
        DriftOut { position: Vector::from_fn(|i| own.velocity[i].mul_add(time_step, own.position[i])) }
    }
}
