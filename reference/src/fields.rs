//! Every quantity a particle can carry, once: its name, symbol and unit.

use etalon_kernels_gen::{Field, Rank, Reduction};

macro_rules! fields {
    ($($(#[$meta:meta])* $name:ident = $text:literal, $symbol:literal, $unit:literal, $rank:ident $(, $reduction:ident)?;)*) => {
        $($(#[$meta])* pub const $name: Field = Field {
            name: $text, symbol: $symbol, unit: $unit, rank: Rank::$rank, reduction: fields!(@ $($reduction)?),
        };)*
        /// All of them, in the order of this file.
        pub const ALL: &[Field] = &[$($name),*];
    };
    (@) => { Reduction::Sum };
    (@ $reduction:ident) => { Reduction::$reduction };
}

/// What is looked at between steps, beside the coordinates.
pub const SHOWN: &[Field] = &[VELOCITY, DENSITY, PRESSURE, INTERNAL_ENERGY, SMOOTHING_LENGTH, MASS, MOBILITY, SPECIES];

fields! {
    /// Mass `m`.
    MASS = "mass", "m", "M", Scalar;
    /// Smoothing length `h`: the kernel's support is a multiple of it.
    SMOOTHING_LENGTH = "smoothing_length", "h", "L", Scalar;
    /// The smoothing length that would have held the wanted neighbours, `h_*`.
    SETTLED_SMOOTHING_LENGTH = "settled_smoothing_length", "h_*", "L", Scalar;
    /// `1 / h`.
    INVERSE_SMOOTHING_LENGTH = "inverse_smoothing_length", "1/h", "L^-1", Scalar;
    /// Velocity `v`.
    VELOCITY = "velocity", "v", "L T^-1", Vector;
    /// Specific internal energy `u`.
    INTERNAL_ENERGY = "internal_energy", "u", "L^2 T^-2", Scalar;
    /// One where the particle moves freely, zero where it is part of a fixed wall.
    MOBILITY = "mobility", "\\mu", "", Scalar;
    /// Zero for gas, one for dust; only what has both carries it.
    SPECIES = "species", "s", "", Scalar;

    /// The plain density estimate, `rho^0 = sum m_b W_ab`.
    STANDARD_DENSITY = "standard_density", "\\rho^0", "M L^-nu", Scalar;
    /// The estimator of the generalised volume element, `X` (C25 20).
    VOLUME_ESTIMATOR = "volume_estimator", "X", "L^nu", Scalar;
    /// `k = sum X_b W_ab` (C25 19).
    KERNEL_NORMALISATION = "kernel_normalisation", "k", "", Scalar;
    /// Volume element `V = X / k` (C25 19).
    VOLUME = "volume", "V", "L^nu", Scalar;
    /// Density `rho` (C25 21).
    DENSITY = "density", "\\rho", "M L^-nu", Scalar;
    /// Pressure `P`.
    PRESSURE = "pressure", "P", "M L^(2-nu) T^-2", Scalar;
    /// Adiabatic sound speed `c`.
    SOUND_SPEED = "sound_speed", "c", "L T^-1", Scalar;
    /// The mean particle spacing in units of `h`, `q_crit` (GS25 16).
    CRITICAL_SEPARATION = "critical_separation", "q_{crit}", "", Scalar;

    /// `sum X_b dW/dh` over the neighbours.
    VOLUME_ESTIMATOR_DERIVATIVE = "volume_estimator_derivative", "\\sum X_b D_{ab}", "L^-1", Scalar;
    /// `sum m_b dW/dh` over the neighbours.
    STANDARD_DENSITY_DERIVATIVE = "standard_density_derivative", "\\sum m_b D_{ab}", "M L^(-nu-1)", Scalar;
    /// `S = sum V_b dW/dh` over the neighbours (C25 30).
    PARTITION_DERIVATIVE = "partition_derivative", "S", "L^-1", Scalar;
    /// The grad-h factor `Omega` (C25 24, 31).
    GRAD_H = "grad_h", "\\Omega", "", Scalar;
    /// What each particle brings to the pressure force, `P / (Omega k rho0^2)` (C25 22).
    PRESSURE_COEFFICIENT = "pressure_coefficient", "P/(\\Omega k (\\rho^0)^2)", "M^-1 L^(2+nu) T^-2", Scalar;

    /// Second moments of the neighbour distribution, `tau` (C25 2).
    MOMENT_MATRIX = "moment_matrix", "\\tau", "L^2", Symmetric;
    /// Its inverse `c` (C25 1).
    GRADIENT_MATRIX = "gradient_matrix", "c", "L^-2", Symmetric;
    /// First moments of the velocity differences (C25 3); with kernel gradients, the velocity gradient itself (4).
    VELOCITY_MOMENT = "velocity_moment", "I", "L^2 T^-1", Matrix;
    /// The symmetric part of the velocity gradient, `(J + J^T) / 2`.
    STRAIN_RATE = "strain_rate", "\\frac12(J+J^T)", "T^-1", Symmetric;
    /// Balsara's limiter (GS25 8).
    BALSARA = "balsara", "\\mathcal{B}", "", Scalar;

    /// First moments of the differences of the velocity's divergence (C25 3 for `div v`); with kernel gradients, its gradient (4).
    DIVERGENCE_MOMENT = "divergence_moment", "I_{\\nabla\\cdot v}", "L T^-1", Vector;
    /// The linear viscosity coefficient that the local flow asks for (GS25 9).
    LOCAL_ALPHA = "local_alpha", "\\alpha_{loc}", "", Scalar;
    /// The linear viscosity coefficient of a scheme in which it depends on time (GS25 10).
    ALPHA = "alpha", "\\alpha", "", Scalar;
    /// What decay has left of it since the step before; a particle starts with the smallest.
    REMAINING_ALPHA = "remaining_alpha", "\\alpha_-", "", Scalar;
    /// The rate at which it decays, `1 / tau` (GS25 10).
    ALPHA_DECAY_RATE = "alpha_decay_rate", "1/\\tau", "T^-1", Scalar;

    /// `sum m_b v_ba (grad W_ab)^T` over neighbours of the same species (PL20 11), without the power of `h_a` common to all terms.
    LINEAR_GRADIENT_SUM = "linear_gradient_sum", "-\\sum m_b v_{ab} \\nabla W_{ab}", "M L^2 T^-1", Matrix;
    /// `R = sum m_b r_ba (grad W_ab)^T` (PL20 12), likewise.
    CORRECTION_MATRIX = "correction_matrix", "R", "M L^2", Symmetric;
    /// The symmetric part of the velocity gradient that is exact for linear flows (PL20 11).
    LINEAR_STRAIN_RATE = "linear_strain_rate", "\\frac12(J+J^T)_{lin}", "T^-1", Symmetric;
    /// Drag of the other species (PL20 4, 5).
    DRAG_ACCELERATION = "drag_acceleration", "\\dot v_{drag}", "L T^-2", Vector;
    /// Drag heating of the gas (PL20 6).
    DRAG_HEATING = "drag_heating", "\\dot u_{drag}", "L^2 T^-3", Scalar;
    /// The inverse of the shortest stopping time among the neighbours of the other species (PL20 7).
    STOPPING_RATE = "stopping_rate", "1/t_s", "T^-1", Scalar, Max;

    /// Acceleration (C25 22).
    ACCELERATION = "acceleration", "\\dot v", "L T^-2", Vector;
    /// Rate of change of the internal energy (C25 23).
    ENERGY_RATE = "energy_rate", "\\dot u", "L^2 T^-3", Scalar;
    /// The part of it that artificial conduction makes (Price et al. 2018).
    CONDUCTION_RATE = "conduction_rate", "\\dot u_{cond}", "L^2 T^-3", Scalar;
    /// The acceleration at the step's start.
    PREVIOUS_ACCELERATION = "previous_acceleration", "\\dot v_n", "L T^-2", Vector;
    /// The energy rate at the step's start.
    PREVIOUS_ENERGY_RATE = "previous_energy_rate", "\\dot u_n", "L^2 T^-3", Scalar;
    /// The largest signal velocity among the neighbours (GS25 3).
    SIGNAL_VELOCITY = "signal_velocity", "v^{sig}", "L T^-1", Scalar, Max;
    /// The longest step the particle allows.
    TIME_STEP = "time_step", "\\Delta t", "T", Scalar;
    /// The way the particle goes in this step.
    DISPLACEMENT = "displacement", "\\Delta x", "L", Vector;

    /// The largest velocity of a driven wall, that at the crest of its oscillation.
    DRIVE_VELOCITY = "drive_velocity", "v_w", "L T^-1", Vector;
    /// The acceleration of a force that the host makes.
    FORCING = "forcing", "f", "L T^-2", Vector;

    /// How many pairs a particle is in (GS25 29).
    PAIRS = "pairs", "N_{pairs}", "", Scalar;
    /// How many of them approach.
    APPROACHING_PAIRS = "approaching_pairs", "N_{\\omega<0}", "", Scalar;
    /// In how many the reconstruction turns the sign of the velocity of approach.
    REVERSED_PAIRS = "reversed_pairs", "N_{\\omega\\omega'<0}", "", Scalar;
    /// In how many of those that approach it does.
    REVERSED_APPROACHING_PAIRS = "reversed_approaching_pairs", "N_{\\omega<0<\\omega'}", "", Scalar;
}
