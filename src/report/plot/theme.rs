//! Colours: every one has a counterpart on dark ground, and differs from the others also in lightness, so that the
//! plots can be told apart with any colour vision (hues after Okabe and Ito).

use std::fmt::Write;

pub(in super::super) use plotters::style::RGBColor as Colour;

/// A colour on light ground and the one that replaces it on dark ground.
#[derive(Clone, Copy)]
pub(in super::super) struct Pair {
    pub(in super::super) light: Colour,
    pub(in super::super) dark: Colour,
}

const fn pair(light: [u8; 3], dark: [u8; 3]) -> Pair {
    Pair { light: Colour(light[0], light[1], light[2]), dark: Colour(dark[0], dark[1], dark[2]) }
}

/// Text, and the line of the exact solution.
pub(super) const INK: Pair = pair([0x17, 0x1b, 0x21], [0xf0, 0xf3, 0xf7]);
/// Tick labels and remarks.
pub(super) const QUIET: Pair = pair([0x5a, 0x64, 0x70], [0xa3, 0xae, 0xbb]);
/// Axis lines.
pub(super) const AXIS: Pair = pair([0x9a, 0xa3, 0xad], [0x6b, 0x76, 0x83]);
/// Grid lines.
pub(super) const GRID: Pair = pair([0xe4, 0xe8, 0xec], [0x2e, 0x37, 0x42]);
/// The ground of a plot that stands alone.
pub(super) const PAPER: Pair = pair([0xff, 0xff, 0xff], [0x17, 0x1d, 0x26]);

/// One colour a run, in the order of the report: the reference is the first.
pub(in super::super) const RUNS: [Pair; 6] = [
    pair([0xb8, 0x4a, 0x00], [0xff, 0xa0, 0x5c]),
    pair([0x00, 0x5f, 0xa8], [0x62, 0xb4, 0xff]),
    pair([0x00, 0x8a, 0x66], [0x3f, 0xd6, 0xa8]),
    pair([0xa2, 0x3b, 0x8f], [0xf0, 0x8f, 0xde]),
    pair([0x7a, 0x6a, 0x00], [0xe0, 0xcc, 0x50]),
    pair([0x4a, 0x51, 0xc4], [0xa9, 0xad, 0xff]),
];

/// Shades for the stages of a step; neighbours differ in lightness.
pub(in super::super) const STAGES: [Pair; 8] = [
    pair([0x2b, 0x3a, 0x55], [0xc9, 0xd6, 0xee]),
    pair([0x5b, 0x7b, 0xb0], [0x5b, 0x7f, 0xbd]),
    pair([0xa9, 0xc1, 0xe3], [0x2c, 0x48, 0x78]),
    pair([0xe3, 0xc7, 0x8a], [0x8a, 0x6a, 0x22]),
    pair([0xc2, 0x85, 0x2f], [0xd8, 0xa2, 0x4e]),
    pair([0x7d, 0x4e, 0x12], [0xf3, 0xd7, 0xa2]),
    pair([0x6e, 0x9c, 0x83], [0x4d, 0x8a, 0x6a]),
    pair([0xb9, 0xd6, 0xc6], [0x2a, 0x55, 0x42]),
];

/// The colour of a run by its place in the report.
pub(in super::super) fn run(index: usize) -> Pair {
    RUNS[index % RUNS.len()]
}

/// `#RRGGBB`, as the SVG writer spells it.
pub(in super::super) fn hex(colour: Colour) -> String {
    format!("#{:02X}{:02X}{:02X}", colour.0, colour.1, colour.2)
}

/// Style rules that turn every colour into its counterpart where the reader prefers dark ground. On paper they do not
/// apply.
pub(in super::super) fn style_sheet() -> String {
    let mut rules = String::from("@media screen and (prefers-color-scheme:dark){\n");
    for pair in [INK, QUIET, AXIS, GRID, PAPER].iter().chain(&RUNS) {
        let (light, dark) = (hex(pair.light), hex(pair.dark));
        for attribute in ["fill", "stroke"] {
            // Writing to a string cannot fail.
            let _ = writeln!(rules, ".plot [{attribute}=\"{light}\"]{{{attribute}:{dark}}}");
        }
    }
    rules + "}\n"
}
