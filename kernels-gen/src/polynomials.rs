//! Minimax polynomials that stand for the transcendental functions inside kernels, and the
//! normalisations of the sinc kernels.
//!
//! Generated; do not edit. Command: `python3 kernels-gen/coefficients/fit.py`
//!
//! Kernels call no library `sin` or `exp`: these polynomials are the same text on every target.
//! Each function has two sets of coefficients, fitted for its precision: the `single` ones are exact
//! in `f32`, the `double` ones in `f64`; every coefficient was rounded and the later ones fitted again.
//! Errors are those of the polynomial with the coefficients as they stand here, in exact arithmetic,
//! certified by enclosing the difference to the power series with Bernstein coefficients. They are
//! not errors of its evaluation, to which rounding adds a few units in the last place.

/// A polynomial on an interval, in two precisions; lowest power first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polynomial {
    /// Coefficients for `f32` evaluation, each exactly representable in `f32`.
    pub single: &'static [f64],
    /// Coefficients for `f64` evaluation.
    pub double: &'static [f64],
    /// Certified bound of the relative error of `single` over the whole interval.
    pub single_error: f64,
    /// Certified bound of the relative error of `double` over the whole interval.
    pub double_error: f64,
}

/// p(t) with sinc(pi q/2) = (1 - t) p(t), t = q^2/4 in \[0, 1\], q in \[0, 2\].
///
/// The factor 1 - t carries the zero at the edge of the support, so the relative error of the sinc
/// there is that of p; p(0) = 1 exactly. The bounds are relative to p, hence also to the sinc.
pub const SINC: Polynomial = Polynomial {
    single: &[
        1.0, // 0x1.0000000000000p+0
        -0.6449340581893921, // -0x1.4a34cc0000000p-1
        0.16680823266506195, // 0x1.559f8e0000000p-3
        -0.023942844942212105, // -0x1.8847920000000p-6
        0.002202951116487384, // 0x1.20bec60000000p-9
        -0.00014000631927046925, // -0x1.259d520000000p-13
        5.725675691792276e-06, // 0x1.803e5c0000000p-18
    ],
    double: &[
        1.0, // 0x1.0000000000000p+0
        -0.6449340668482264, // -0x1.4a34cc4a60fa6p-1
        0.166808358435126, // 0x1.559f9ee16d2edp-3
        -0.023943465686940522, // -0x1.884a2c8502fe6p-6
        0.002204382130585005, // 0x1.20eeca514799ep-9
        -0.00014169890431342658, // -0x1.292a051df182dp-13
        6.729887188327556e-06, // 0x1.c3a294de663ccp-18
        -2.4598369886560404e-07, // -0x1.081f7bfa338f2p-22
        7.1346706082292435e-09, // 0x1.ea4a73e4838f7p-28
        -1.6732757072473963e-10, // -0x1.6ff50c5345056p-33
        2.936841995682839e-12, // 0x1.9d52e256f2c51p-39
    ],
    single_error: 1.96e-10,
    double_error: 2.51e-19,
};

/// Certified bound of the relative error of d/dt \[(1 - t) p(t)\] with [`SINC`]'s `single`
/// coefficients, against d sinc/dt, over t in \[0, 1\].
pub const SINC_SLOPE_SINGLE_ERROR: f64 = 5.35e-9;

/// Certified bound of the relative error of d/dt \[(1 - t) p(t)\] with [`SINC`]'s `double`
/// coefficients, against d sinc/dt, over t in \[0, 1\].
pub const SINC_SLOPE_DOUBLE_ERROR: f64 = 1.88e-17;

/// P(x) with exp(-x) - 1 = -x P(x), x in \[0, 1\].
///
/// For exp(-y), y >= 0: x = min(y, 32)/32, e = -x P(x), five times e <- e (2 + e), result 1 + e.
/// An error r of P becomes an absolute error of at most 0.38 r in exp(-y) (y exp(-31 y/32) <= 0.38),
/// and 1 - exp(-y) = -e keeps its relative accuracy as y -> 0. P(0) = 1 exactly.
pub const EXPM1_NEGATIVE: Polynomial = Polynomial {
    single: &[
        1.0, // 0x1.0000000000000p+0
        -0.49999985098838806, // -0x1.fffff60000000p-2
        0.1666637659072876, // 0x1.5553d00000000p-3
        -0.041647881269454956, // -0x1.552df00000000p-5
        0.0082769263535738, // 0x1.0f37e40000000p-7
        -0.001301713171415031, // -0x1.553c7e0000000p-10
        0.00012931374658364803, // 0x1.0f30ca0000000p-13
    ],
    double: &[
        1.0, // 0x1.0000000000000p+0
        -0.49999999999999717, // -0x1.fffffffffffcdp-2
        0.16666666666650656, // 0x1.5555555553ecdp-3
        -0.04166666666350474, // -0x1.55555554e6154p-5
        0.008333333302059775, // 0x1.111110ffdfb46p-7
        -0.0013888887084452847, // -0x1.6c16be527d518p-10
        0.00019841204099685608, // 0x1.a019a74556857p-13
        -2.4800010583384998e-05, // -0x1.a0133c0161df6p-16
        2.7532010482469408e-06, // 0x1.718744877b017p-19
        -2.728693162559575e-07, // -0x1.24fdbf1c0b70cp-22
        2.3189793580150426e-08, // 0x1.8e65ca6e7cc03p-26
        -1.3200005162115397e-09, // -0x1.6ad6c754ee005p-30
    ],
    single_error: 2.82e-9,
    double_error: 1.63e-17,
};

/// P(t) with artanh z = z P(t), t = 4 z^2 in \[0, 1\], |z| <= 1/2.
///
/// For the logarithm of a ratio a/b of at most three: 2 artanh((a - b)/(a + b)). P(0) = 1 exactly.
pub const ARTANH: Polynomial = Polynomial {
    single: &[
        1.0, // 0x1.0000000000000p+0
        0.08333325386047363, // 0x1.5555400000000p-4
        0.012501533143222332, // 0x1.99a6760000000p-7
        0.0022224662825465202, // 0x1.234d980000000p-9
        0.0004615786310750991, // 0x1.e400120000000p-12
        5.039339521317743e-05, // 0x1.a6bafe0000000p-15
        4.306183473090641e-05, // 0x1.693a960000000p-15
    ],
    double: &[
        1.0, // 0x1.0000000000000p+0
        0.08333333333333322, // 0x1.555555555554dp-4
        0.012500000000010732, // 0x1.999999999b1c4p-7
        0.002232142856800313, // 0x1.24924923d1735p-9
        0.0004340277832575786, // 0x1.c71c722783460p-12
        8.877835739920819e-05, // 0x1.745d0910568e1p-14
        1.8780362215157807e-05, // 0x1.3b150aa121151p-16
        4.067714417563594e-06, // 0x1.10facd33cc188p-18
        9.013185970574232e-07, // 0x1.e3e448e3b3275p-21
        1.930924780779399e-07, // 0x1.9ea9b6628f109p-23
        5.662902714832805e-08, // 0x1.e6708c3208b73p-25
        -1.1232787318144856e-09, // -0x1.34c3b6b64e431p-30
        1.0345130803361457e-08, // 0x1.6374bb9d9543cp-27
        -2.8956595818178333e-09, // -0x1.8df9f6d3cc1bdp-29
        8.943811470148946e-10, // 0x1.ebb0f4cdaad2dp-31
    ],
    single_error: 1.39e-9,
    double_error: 4.56e-19,
};

/// B in 1, 2 and 3 dimensions: S_4 = B sinc(pi q/2)^4 has unit integral over its support q < 2.
pub const SINC_4_NORMALISATION: [f64; 3] = [
    0.7522150129811814, // 0x1.81225380a0f7bp-1
    0.5803121754167139, // 0x1.291ead6dc5535p-1
    0.45891751668763536, // 0x1.d5ee7936f0910p-2
];

/// B in 1, 2 and 3 dimensions: S_9 = B sinc(pi q/2)^9 has unit integral over its support q < 2.
pub const SINC_9_NORMALISATION: [f64; 3] = [
    1.1039440110293819, // 0x1.1a9c131ffc7b7p+0
    1.2324400612830517, // 0x1.3b81311d7dae7p+0
    1.3913221489217884, // 0x1.642db037d1cc4p+0
];

/// h^2 / int r^2 W dV in 1, 2 and 3 dimensions, for the mixed sinc kernel W = 0.9 S_4 + 0.1 S_9: times q^2 W
/// it makes the double-humped kernel, whose integral is one.
pub const MIXED_SINC_DOUBLE_HUMP: [f64; 3] = [
    4.04182550955939, // 0x1.02ad44e6ec8d2p+2
    2.119384573758633, // 0x1.0f47fe63f8597p+1
    1.4800853074378175, // 0x1.7ae6dee6bc4bdp+0
];

#[cfg(test)]
mod tests;
