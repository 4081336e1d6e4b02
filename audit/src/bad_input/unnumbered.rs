//! What definitions without a number, which the ledger does not have, catch. All else propagates.

use etalon_spec::{BadValue, Caught};

/// Values that such a definition catches.
#[derive(Clone, Copy, Debug)]
pub struct Unnumbered {
    /// Module and name of the function.
    pub path: &'static str,
    /// The argument's symbol, as its probe has it.
    pub of: &'static str,
    /// Which values.
    pub values: &'static [BadValue],
    /// What comes out, and why.
    pub gives: &'static str,
}

const fn caught(path: &'static str, of: &'static str, values: &'static [BadValue], gives: &'static str) -> Unnumbered {
    Unnumbered { path, of, values, gives }
}

impl Unnumbered {
    /// All of them.
    pub const ALL: &'static [Unnumbered] = &[
        caught(
            "limiters::limited_slope",
            "S_{ai}",
            &[BadValue::Nan],
            "no slope, zero, where a limiter is chosen: it has no sign in common with the other",
        ),
        caught("limiters::limited_slope", "S_{ia}", &[BadValue::Nan], "the same"),
        caught(
            "dust_reconstruction::entropy_fixed",
            r"\omega_{ai}",
            &[BadValue::Nan],
            "the reconstructed velocity difference: no sign is known to be wrong. It is made of this one, and is NaN all the same",
        ),
        caught(
            "dust_reconstruction::entropy_fixed",
            "d",
            &[BadValue::Nan],
            "the reconstructed velocity difference; the step that multiplies it with this is NaN all the same",
        ),
        caught(
            "conduction::conduction_weight",
            r"\rho_a",
            &[BadValue::Zero, BadValue::Negative],
            "no conduction from this particle, as where its grad-h factor is not positive",
        ),
        caught(
            "wind_cloud::wind_cloud",
            r"\mathbf{x}",
            &[BadValue::Nan],
            "the cloud: a comparison. A scene refuses such a place before it asks",
        ),
    ];
}

/// What the function at this path catches.
#[must_use]
pub fn of_unnumbered(path: &str) -> Vec<Caught> {
    let of = Unnumbered::ALL.iter().filter(|of| of.path == path);
    of.map(|of| Caught { of: of.of.to_string(), values: of.values.to_vec(), gives: of.gives.to_string() }).collect()
}
