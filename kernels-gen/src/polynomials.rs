//! Minimax polynomials that stand for the transcendental functions inside kernels, and the
//! normalisations of the sinc kernels.
//!
//! Generated; do not edit. Command: `python3 kernels-gen/coefficients/fit.py`
//!
//! Kernels call no library `sin` or `exp`: these polynomials are the same text on every target.
//! Each function has a set of coefficients for each precision: the `single` ones are exact in `f32`,
//! the `double` ones in `f64`, and of these every coefficient was rounded and the later ones fitted
//! again; the `extended` ones are sums of two `f64`, for the oracle.
//! Errors are those of the polynomial with the coefficients as they stand here, in exact arithmetic,
//! certified by enclosing the difference to the power series with Bernstein coefficients. They are
//! not errors of its evaluation, to which rounding adds a few units in the last place.

use crate::constant::Constant;

/// A polynomial on an interval, in three precisions; lowest power first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polynomial {
    /// Coefficients for `f32` evaluation, each exactly representable in `f32`.
    pub single: &'static [f64],
    /// Coefficients for `f64` evaluation.
    pub double: &'static [f64],
    /// Coefficients for evaluation with more digits than `f64` has.
    pub extended: &'static [Constant],
    /// Certified bound of the relative error of `single` over the whole interval.
    pub single_error: f64,
    /// Certified bound of the relative error of `double` over the whole interval.
    pub double_error: f64,
    /// Certified bound of the relative error of `extended` over the whole interval.
    pub extended_error: f64,
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
    extended: &[
        Constant::pair(1.0, 0.0),
        Constant::pair(-0.6449340668482264, -3.040672350398476e-17),
        Constant::pair(0.1668083584351272, 5.2071168174304756e-18),
        Constant::pair(-0.023943465686957006, -7.816384091669174e-19),
        Constant::pair(0.002204382130697794, -1.5046203736386768e-19),
        Constant::pair(-0.00014169890475802967, 5.2008857550771884e-21),
        Constant::pair(6.729888273041339e-06, -3.476700391599827e-22),
        Constant::pair(-2.459853886150415e-07, -7.92192027379171e-24),
        Constant::pair(7.136351798661235e-09, -5.645428105337028e-27),
        Constant::pair(-1.683600235565395e-10, -2.218803714211945e-27),
        Constant::pair(3.2938239416748024e-12, 7.872662777810349e-29),
        Constant::pair(-5.430959336919534e-14, 1.020629258009803e-30),
        Constant::pair(7.649957522029553e-16, 3.332253666985216e-32),
        Constant::pair(-9.31251999718083e-18, -6.2122210234082305e-34),
        Constant::pair(9.895318694421049e-20, 9.883920108402007e-37),
        Constant::pair(-9.257714344596952e-22, -2.88894721211951e-38),
        Constant::pair(7.671422588763146e-24, -7.09880234679349e-42),
        Constant::pair(-5.364288644107807e-26, -3.697657438893433e-42),
    ],
    single_error: 1.96e-10,
    double_error: 2.51e-19,
    extended_error: 4.71e-33,
};

/// Certified bound of the relative error of d/dt \[(1 - t) p(t)\] with [`SINC`]'s `single`
/// coefficients, against d sinc/dt, over t in \[0, 1\].
pub const SINC_SLOPE_SINGLE_ERROR: f64 = 5.35e-9;

/// Certified bound of the relative error of d/dt \[(1 - t) p(t)\] with [`SINC`]'s `double`
/// coefficients, against d sinc/dt, over t in \[0, 1\].
pub const SINC_SLOPE_DOUBLE_ERROR: f64 = 1.88e-17;

/// Certified bound of the relative error of d/dt \[(1 - t) p(t)\] with [`SINC`]'s `extended`
/// coefficients, against d sinc/dt, over t in \[0, 1\].
pub const SINC_SLOPE_EXTENDED_ERROR: f64 = 4.71e-33;

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
    extended: &[
        Constant::pair(1.0, 0.0),
        Constant::pair(-0.5, 2.1442923757392373e-33),
        Constant::pair(0.16666666666666666, 9.25185853854256e-18),
        Constant::pair(-0.041666666666666664, -2.3129646346077242e-18),
        Constant::pair(0.008333333333333333, 1.156482307555913e-19),
        Constant::pair(-0.001388888888888889, 5.300546010886284e-20),
        Constant::pair(0.0001984126984126984, 1.7180781335340839e-22),
        Constant::pair(-2.48015873015873e-05, -1.867150556870037e-23),
        Constant::pair(2.7557319223985893e-06, -2.0644399276225061e-22),
        Constant::pair(-2.755731922398588e-07, -1.6571843425904106e-23),
        Constant::pair(2.505210838544124e-08, -9.620438825300974e-25),
        Constant::pair(-2.0876756987852177e-09, -6.152627554948342e-26),
        Constant::pair(1.605904383640301e-10, 8.875649856884519e-27),
        Constant::pair(-1.1470745588969707e-11, 7.858174954907861e-28),
        Constant::pair(7.647163585647243e-13, 1.0560588288211902e-29),
        Constant::pair(-4.779475391762838e-14, 1.147532271307065e-30),
        Constant::pair(2.8114368910909386e-15, 9.894661299331412e-32),
        Constant::pair(-1.5617538643210797e-16, -3.763877368996421e-33),
        Constant::pair(8.210173032490282e-18, -3.2228051156805055e-34),
        Constant::pair(-4.0616505726982925e-19, 1.7940556936717935e-35),
        Constant::pair(1.7977082854398542e-20, -1.0799837410564626e-36),
        Constant::pair(-5.5206158604277485e-22, 4.537347192074455e-38),
    ],
    single_error: 2.82e-9,
    double_error: 1.63e-17,
    extended_error: 7.86e-34,
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
    extended: &[
        Constant::pair(1.0, 0.0),
        Constant::pair(0.08333333333333333, 4.625929269271804e-18),
        Constant::pair(0.0125, -6.938893904912625e-19),
        Constant::pair(0.002232142857142857, 1.2390883091831944e-19),
        Constant::pair(0.00043402777777777775, 2.4092740025325854e-20),
        Constant::pair(8.87784090909091e-05, -2.4417969827600233e-21),
        Constant::pair(1.8780048076923078e-05, -1.5603332307006654e-21),
        Constant::pair(4.069010416666675e-06, 1.363710308394729e-22),
        Constant::pair(8.975758272057775e-07, 1.385674844551552e-23),
        Constant::pair(2.007735402970372e-07, 5.340060843220834e-24),
        Constant::pair(4.5413062678757085e-08, -1.6206968072417413e-24),
        Constant::pair(1.0366025221024001e-08, 6.672056181317938e-25),
        Constant::pair(2.384185587563784e-09, 3.405661572347908e-26),
        Constant::pair(5.5189565226162e-10, 5.068159643961974e-27),
        Constant::pair(1.2845573617736128e-10, 7.653208885412179e-27),
        Constant::pair(3.0049458816492954e-11, -1.591254350103317e-27),
        Constant::pair(7.04041570872043e-12, -2.48849967490194e-29),
        Constant::pair(1.690858582487503e-12, -8.128100463654525e-29),
        Constant::pair(3.5066159016610606e-13, 3.895266673315295e-30),
        Constant::pair(1.4751330383289306e-13, -1.0662212412725618e-29),
        Constant::pair(-3.465191016915935e-14, -2.8768945268868877e-30),
        Constant::pair(5.388567585084859e-14, 1.2395322822939788e-30),
        Constant::pair(-3.2152360165130466e-14, -3.0053211925744244e-30),
        Constant::pair(1.8381351272535624e-14, -7.619185891212921e-31),
        Constant::pair(-7.371465499251641e-15, 5.988400340484653e-32),
        Constant::pair(2.2257404473995556e-15, 2.421376010218783e-32),
        Constant::pair(-4.2204658176469166e-16, -2.0625860973984257e-32),
        Constant::pair(4.271328849509348e-17, 4.704544132266575e-36),
    ],
    single_error: 1.39e-9,
    double_error: 4.56e-19,
    extended_error: 6.79e-34,
};

/// B in 1, 2 and 3 dimensions: S_4 = B sinc(pi q/2)^4 has unit integral over its support q < 2.
pub const SINC_4_NORMALISATION: [Constant; 3] = [
    Constant::pair(0.7522150129811814, 3.4150533516587676e-17),
    Constant::pair(0.5803121754167139, 1.0808372245398849e-17),
    Constant::pair(0.45891751668763536, -1.550094407773321e-17),
];

/// B in 1, 2 and 3 dimensions: S_9 = B sinc(pi q/2)^9 has unit integral over its support q < 2.
pub const SINC_9_NORMALISATION: [Constant; 3] = [
    Constant::pair(1.1039440110293819, -5.453810904656526e-17),
    Constant::pair(1.2324400612830517, -2.0290954206344423e-17),
    Constant::pair(1.3913221489217884, 5.568029300863981e-17),
];

/// h^2 / int r^2 W dV in 1, 2 and 3 dimensions, for the mixed sinc kernel W = 0.9 S_4 + 0.1 S_9: times q^2 W
/// it makes the double-humped kernel, whose integral is one.
pub const MIXED_SINC_DOUBLE_HUMP: [Constant; 3] = [
    Constant::pair(4.04182550955939, 4.3655943175059756e-16),
    Constant::pair(2.119384573758633, -5.84148634918241e-17),
    Constant::pair(1.4800853074378175, 2.5418451315695363e-17),
];

#[cfg(test)]
mod tests;
