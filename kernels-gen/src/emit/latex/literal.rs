//! Constants as people write them.

use super::text::{Text, Tight};
use std::f64::consts::PI;

/// Denominators up to this are looked for.
const LARGEST_DENOMINATOR: u32 = 1024;
/// Decimals of so many digits are written out; of longer ones the beginning.
const DIGITS: usize = 8;

/// `0.25`, `10^{-4}`, `\frac{35}{12}`, `\frac{7}{4\pi}`, or the shortest decimal that reads back as the value.
pub(super) fn literal(value: f64) -> Text {
    let size = value.abs();
    let text = match short(size) {
        Some(text) => text,
        None => match fraction(size) {
            Some(text) => Text::new(text, Tight::Group),
            None => scientific(size),
        },
    };
    if value < 0.0 { text.negated() } else { text }
}

/// A coefficient of a fitted polynomial: its first digits.
pub(super) fn coefficient(value: f64) -> Text {
    let size = value.abs();
    let text = short(size).unwrap_or_else(|| {
        // Cut off, not rounded: the dots say that it goes on.
        let printed = format!("{size:.16e}");
        let (digits, exponent) = printed.split_once('e').unwrap_or((&printed, "0"));
        let digits = &digits[..7];
        match exponent {
            "0" => Text::atom(format!(r"{digits}\ldots")),
            _ => Text::new(format!(r"{digits}\ldots \cdot 10^{{{exponent}}}"), Tight::Product),
        }
    });
    if value < 0.0 { text.negated() } else { text }
}

/// Numbers of few digits.
fn short(size: f64) -> Option<Text> {
    // What came from a drawing for `f32` is written as such.
    let single = size as f32;
    let (plain, power) = match f64::from(single) == size {
        true => (format!("{single}"), format!("{single:e}")),
        false => (format!("{size}"), format!("{size:e}")),
    };
    let (digits, exponent) = power.split_once('e')?;
    if digits.len() > DIGITS {
        return None;
    }
    if plain.len() <= DIGITS && (digits != "1" || size >= 1e-2) {
        return Some(Text::atom(plain));
    }
    Some(match digits {
        "1" => Text::new(format!("10^{{{exponent}}}"), Tight::Group),
        _ => Text::new(format!(r"{digits} \cdot 10^{{{exponent}}}"), Tight::Product),
    })
}

/// A fraction of whole numbers, also with pi below or above, that is this very `f64`.
fn fraction(size: f64) -> Option<String> {
    let with = |unit: f64, above: &str, below: &str| {
        (1..=LARGEST_DENOMINATOR).find_map(|denominator| {
            let numerator = (size / unit * f64::from(denominator)).round();
            let is_it = numerator > 0.0 && numerator < 1e6 && nearly(numerator / f64::from(denominator) * unit, size);
            is_it.then(|| {
                let above = if numerator == 1.0 && !above.is_empty() {
                    above.to_string()
                } else {
                    format!("{numerator}{above}")
                };
                let below = if denominator == 1 && !below.is_empty() {
                    below.to_string()
                } else {
                    format!("{denominator}{below}")
                };
                if below == "1" { above } else { format!(r"\frac{{{above}}}{{{below}}}") }
            })
        })
    };
    with(1.0, "", "").or_else(|| with(1.0 / PI, "", r"\pi")).or_else(|| with(PI, r"\pi", ""))
}

/// The same to the last place but one: the value may have been rounded at another step, or to `f32`.
fn nearly(candidate: f64, size: f64) -> bool {
    let is_single = f64::from(size as f32) == size;
    (candidate - size).abs() <= 4.0 * f64::EPSILON * size || is_single && candidate as f32 == size as f32
}

fn scientific(size: f64) -> Text {
    let (plain, power) = (format!("{size}"), format!("{size:e}"));
    match power.split_once('e') {
        Some((digits, exponent)) if plain.len() > 22 => {
            Text::new(format!(r"{digits} \cdot 10^{{{exponent}}}"), Tight::Product)
        }
        _ => Text::atom(plain),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn constants_are_written_as_people_do() {
        let written = |value: f64| literal(value).text;
        assert_eq!(written(0.5), "0.5");
        assert_eq!(written(-3.0), "-3");
        assert_eq!(written(1e-4), "10^{-4}");
        assert_eq!(written(1e30), "10^{30}");
        assert_eq!(written(2.5e-12), r"2.5 \cdot 10^{-12}");
        assert_eq!(written(35.0 / 12.0), r"\frac{35}{12}");
        assert_eq!(written(-14.0 / 3.0), r"-\frac{14}{3}");
        assert_eq!(written(7.0 / (4.0 * PI)), r"\frac{7}{4\pi}");
        assert_eq!(written(1.0 / PI), r"\frac{1}{\pi}");
        assert_eq!(written(2.0 * PI), r"2\pi");
        assert_eq!(written(f64::from(0.1_f32)), "0.1");
        assert_eq!(written(0.7522150129811814), "0.7522150129811814");
        assert_eq!(coefficient(-0.6449340668482264).text, r"-6.44934\ldots \cdot 10^{-1}");
    }
}
