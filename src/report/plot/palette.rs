//! The scale of colours for pictures and heat maps: viridis, dark to light, even to the eye and safe for any colour vision.
//!
//! The drawing library's eight stops of it; viridis is by N. Smith and S. van der Walt for Matplotlib, in the public domain.

use plotters::prelude::Color;
use plotters::style::colors::colormaps::{ColorMap, ViridisRGB};

use super::theme::Colour;

/// Text on dark and on light colours. Other than the theme's: it keeps to its cell when the ground of the page changes.
const LIGHT_TEXT: Colour = Colour(0xfe, 0xfe, 0xfe);
const DARK_TEXT: Colour = Colour(0x00, 0x00, 0x00);

/// The colour at a part of the scale, from 0 (dark) to 1 (light); beyond them the colour of the end.
pub(super) fn viridis(part: f64) -> Colour {
    ViridisRGB.get_color(part.clamp(0.0, 1.0) as f32)
}

/// Relative luminance of a colour, 0 to 1 (WCAG 2.2, "relative luminance").
pub(super) fn luminance(colour: Colour) -> f64 {
    let linear = |channel: u8| match f64::from(channel) / 255.0 {
        low if low <= 0.040_45 => low / 12.92,
        high => ((high + 0.055) / 1.055).powf(2.4),
    };
    let (red, green, blue) = colour.rgb();
    0.2126 * linear(red) + 0.7152 * linear(green) + 0.0722 * linear(blue)
}

/// The colour in which text reads best on that ground: the one of the higher contrast.
pub(super) fn text_on(ground: Colour) -> Colour {
    let contrast = |text: Colour| {
        let (one, other) = (luminance(ground) + 0.05, luminance(text) + 0.05);
        (one / other).max(other / one)
    };
    if contrast(LIGHT_TEXT) > contrast(DARK_TEXT) { LIGHT_TEXT } else { DARK_TEXT }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scale_grows_lighter_all_along() {
        let lightness: Vec<f64> = (0..=64).map(|step| luminance(viridis(f64::from(step) / 64.0))).collect();
        assert!(lightness.is_sorted_by(|one, next| one < next), "{lightness:?}");
        assert_eq!((viridis(-1.0), viridis(7.0)), (viridis(0.0), viridis(1.0)));
    }

    #[test]
    fn text_reads_on_every_colour() {
        for step in 0..=64 {
            let ground = viridis(f64::from(step) / 64.0);
            let (one, other) = (luminance(ground) + 0.05, luminance(text_on(ground)) + 0.05);
            // 4.5 is what WCAG 2.2 asks of text (success criterion 1.4.3).
            let contrast = (one / other).max(other / one);
            assert!(contrast >= 4.5, "contrast {contrast} at step {step}");
        }
    }
}
