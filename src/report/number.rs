//! How numbers are printed: three significant digits, decimal where that is short, scientific elsewhere.

/// A number in ASCII for terminals: `1230`, `0.0123`, `3.10e-12`, `0`.
pub fn plain(value: f64) -> String {
    match Shape::of(value) {
        Shape::Word(word) => word.into(),
        Shape::Decimal(digits) => digits,
        Shape::Scientific { digits, exponent } => format!("{digits}e{exponent}"),
    }
}

/// A number typeset for pages and plots: `1 230`, `0.0123`, `3.10×10⁻¹²`, with a true minus sign.
pub fn typeset(value: f64) -> String {
    match Shape::of(value) {
        Shape::Word(word) => word.replace('-', "−"),
        Shape::Decimal(digits) => grouped(&digits.replace('-', "−")),
        Shape::Scientific { digits, exponent } => {
            format!("{}×{}", digits.replace('-', "−"), power_of_ten(exponent))
        }
    }
}

/// A setting as one would write it, typeset: at most four significant digits, none of them idle: `0.2`, `1.667`.
pub(super) fn short(value: f64) -> String {
    let rounded: f64 = format!("{value:.3e}").parse().unwrap_or(value);
    if rounded != 0.0 && !(1e-4..1e6).contains(&rounded.abs()) {
        return typeset(value);
    }
    grouped(&rounded.to_string().replace('-', "−"))
}

/// A whole number with its thousands set apart: `110 592`.
pub(super) fn count(value: u64) -> String {
    grouped(&value.to_string())
}

/// A ratio such as a speed-up, typeset: `14.2×`.
pub(super) fn times(value: f64) -> String {
    format!("{}×", typeset(value))
}

/// `10⁻³`.
pub(super) fn power_of_ten(exponent: i32) -> String {
    let superscript = |c| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '0'..='9' => char::from_u32(0x2070 + (c as u32 - '0' as u32)).unwrap_or(c),
        other => other,
    };
    format!("10{}", exponent.to_string().chars().map(superscript).collect::<String>())
}

/// The form in which a number is printed.
enum Shape {
    /// Zero and what is not finite.
    Word(&'static str),
    /// Plain digits.
    Decimal(String),
    /// One digit before the point, and a power of ten.
    Scientific { digits: String, exponent: i32 },
}

impl Shape {
    fn of(value: f64) -> Self {
        if value.is_nan() {
            return Self::Word("nan");
        }
        if value.is_infinite() {
            return Self::Word(if value > 0.0 { "inf" } else { "-inf" });
        }
        if value == 0.0 {
            return Self::Word("0");
        }
        // Rounding to three digits first settles the exponent: 9.996 is 1.00e1.
        let rounded = format!("{value:.2e}");
        let Some((digits, exponent)) = rounded.split_once('e') else { return Self::Decimal(rounded) };
        let exponent: i32 = exponent.parse().unwrap_or(0);
        match exponent {
            // From 1000 on whole numbers are shown in full: 12 346, not 12 300.
            3..=5 => Self::Decimal(format!("{value:.0}")),
            -2..=2 => Self::Decimal(format!("{value:.*}", (2 - exponent) as usize)),
            _ => Self::Scientific { digits: digits.into(), exponent },
        }
    }
}

/// Sets thousands of the whole part apart with narrow no-break spaces, from five digits on.
fn grouped(number: &str) -> String {
    let whole = number.find('.').unwrap_or(number.len());
    let digits = number[..whole].chars().filter(char::is_ascii_digit).count();
    if digits < 5 {
        return number.into();
    }
    let mut left = digits;
    let mut out = String::with_capacity(number.len() + 6);
    for c in number[..whole].chars() {
        out.push(c);
        if c.is_ascii_digit() {
            left -= 1;
            if left > 0 && left % 3 == 0 {
                out.push('\u{202f}');
            }
        }
    }
    out + &number[whole..]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_digits_where_they_fit() {
        for (value, expected) in [
            (0.0, "0"),
            (-0.0, "0"),
            (1.0, "1.00"),
            (9.996, "10.0"),
            (0.01234, "0.0123"),
            (0.009996, "0.0100"),
            (0.001234, "1.23e-3"),
            (123.4, "123"),
            (12345.6, "12346"),
            (999_999.0, "1.00e6"),
            (3.1e-12, "3.10e-12"),
            (-4.56e-7, "-4.56e-7"),
            (f64::MIN_POSITIVE, "2.23e-308"),
            (f64::NAN, "nan"),
            (f64::NEG_INFINITY, "-inf"),
        ] {
            assert_eq!(plain(value), expected, "{value:e}");
        }
    }

    #[test]
    fn settings_have_no_idle_digits() {
        assert_eq!(
            [0.2, 5.0 / 3.0, 100.0, 0.0, -0.05, 1e-9].map(short),
            ["0.2", "1.667", "100", "0", "−0.05", "1.00×10⁻⁹"]
        );
    }

    #[test]
    fn typeset_uses_true_signs() {
        assert_eq!(typeset(-3.1e-12), "−3.10×10⁻¹²");
        assert_eq!(typeset(6.789e20), "6.79×10²⁰");
        assert_eq!(typeset(-12345.6), "−12\u{202f}346");
        assert_eq!(typeset(1234.0), "1234");
        assert_eq!(count(1_234_567), "1\u{202f}234\u{202f}567");
        assert_eq!(power_of_ten(-1045), "10⁻¹⁰⁴⁵");
    }
}
