//! Where labels of points go, so that none lies on another or on a mark.

use super::canvas::{LABEL, width_of};

/// Height of a label.
const HEIGHT: i32 = LABEL + 4;
/// Distances of a label from its point, the nearest first; from the second on a line leads to it.
const DISTANCES: [i32; 4] = [20, 44, 76, 112];
/// Directions of a label from its point, the best first: right, left, above, below, and between them. Downwards is positive.
const DIRECTIONS: [(i32, i32); 8] = [(1, -1), (1, 1), (-1, -1), (-1, 1), (1, 0), (-1, 0), (0, -1), (0, 1)];

/// A rectangle on the sheet: left, top, right, bottom.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Rectangle(i32, i32, i32, i32);

impl Rectangle {
    fn meets(self, other: Self) -> bool {
        self.0 < other.2 && other.0 < self.2 && self.1 < other.3 && other.1 < self.3
    }

    fn inside(self, other: Self) -> bool {
        self.0 >= other.0 && self.1 >= other.1 && self.2 <= other.2 && self.3 <= other.3
    }
}

/// A label that found its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Placed {
    /// The middle of its left side.
    pub(super) at: (i32, i32),
    /// The end of the line that leads to it, if it lies apart.
    pub(super) lead: Option<(i32, i32)>,
}

/// What is taken on a sheet.
pub(super) struct Labels {
    frame: Rectangle,
    taken: Vec<Rectangle>,
}

impl Labels {
    /// An empty frame with marks of that radius at the points.
    pub(super) fn around(frame: (i32, i32, i32, i32), points: &[(i32, i32)], radius: i32) -> Self {
        let around = |&(x, y): &(i32, i32)| Rectangle(x - radius, y - radius, x + radius, y + radius);
        Self { frame: Rectangle(frame.0, frame.1, frame.2, frame.3), taken: points.iter().map(around).collect() }
    }

    /// Keeps labels off a line from pixel to pixel, of which each piece runs along one axis.
    pub(super) fn keep_off(&mut self, line: &[(i32, i32)]) {
        for pair in line.windows(2) {
            let [(x, y), (next_x, next_y)] = [pair[0], pair[1]];
            let piece = Rectangle(x.min(next_x) - 2, y.min(next_y) - 2, x.max(next_x) + 2, y.max(next_y) + 2);
            self.taken.push(piece);
        }
    }

    /// Finds a place for a label beside its point or, if it may, apart from it, and takes it. `None` where all are taken.
    pub(super) fn place(&mut self, label: &str, (x, y): (i32, i32), may_lie_apart: bool) -> Option<Placed> {
        let width = width_of(label, LABEL);
        let distances = if may_lie_apart { &DISTANCES[..] } else { &DISTANCES[..1] };
        for (apart, &distance) in distances.iter().enumerate() {
            for (across, down) in DIRECTIONS {
                // Beside the point a label is no further up or down than needed.
                let middle = y + down * if across == 0 { distance + HEIGHT / 2 } else { distance };
                let left = match across {
                    1 => x + distance,
                    -1 => x - distance - width,
                    _ => x - width / 2,
                };
                let place = Rectangle(left, middle - HEIGHT / 2, left + width, middle + HEIGHT / 2);
                if !place.inside(self.frame) || self.taken.iter().any(|taken| taken.meets(place)) {
                    continue;
                }
                self.taken.push(place);
                let near = (x.clamp(left, left + width), y.clamp(place.1, place.3));
                return Some(Placed { at: (left, middle), lead: (apart > 0).then_some(near) });
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_do_not_meet() {
        // Five points close together: every label finds a place of its own, off all marks.
        let points: Vec<(i32, i32)> = (0..5).map(|place| (500 + 8 * place, 400 - 6 * place)).collect();
        let mut labels = Labels::around((100, 100, 1000, 700), &points, 10);
        let placed: Vec<Placed> = points.iter().map(|&point| labels.place("n = 100", point, true).unwrap()).collect();
        assert!(placed.iter().any(|placed| placed.lead.is_some()));
        for (place, one) in labels.taken.iter().enumerate().skip(points.len()) {
            assert!(labels.taken[..place].iter().skip(points.len()).all(|other| !other.meets(*one)));
            assert!(one.inside(labels.frame));
        }
    }

    #[test]
    fn a_full_frame_takes_no_more() {
        let mut labels = Labels::around((0, 0, 300, 60), &[(150, 30)], 10);
        let placed: Vec<Option<Placed>> = (0..9).map(|_| labels.place("f32", (150, 30), true)).collect();
        assert!(placed[0].is_some() && placed[8].is_none(), "{placed:?}");
    }

    #[test]
    fn labels_keep_off_lines() {
        let mut free = Labels::around((0, 0, 1000, 700), &[(500, 300)], 10);
        let mut barred = Labels::around((0, 0, 1000, 700), &[(500, 300)], 10);
        barred.keep_off(&[(500, 300), (900, 300), (900, 0)]);
        barred.keep_off(&[(500, 270), (900, 270)]);
        assert_ne!(free.place("label", (500, 300), false), barred.place("label", (500, 300), false));
    }
}
