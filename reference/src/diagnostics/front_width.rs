//! How wide a shock is that runs into gas at rest (PL20 section 3.2, Fig. 5: "to within ~ 3h").

/// A front ends ahead where the velocity has this share of what it is behind, and behind where it has the other.
pub const SHARES: [f64; 2] = [0.1, 0.9];

/// The width of a front that runs along the positive x axis into gas at rest, in smoothing lengths: the distance from where the velocity, seen from
/// ahead, first reaches a tenth of the `behind` one to where it first reaches nine tenths, between particles by straight lines, over the mean of the
/// smoothing lengths at both places.
///
/// Of each particle its x, its velocity along x and its smoothing length, in any order. None if the velocity does not get so far. The paper does not say how it
/// measures.
pub fn front_width(particles: impl IntoIterator<Item = [f64; 3]>, behind: f64) -> Option<f64> {
    let mut row: Vec<[f64; 3]> = particles.into_iter().collect();
    row.sort_by(|a, b| b[0].total_cmp(&a[0]));
    let reached = |share: f64| {
        let level = share * behind;
        let at = row.iter().position(|[_, velocity, _]| *velocity >= level)?;
        let [ahead, here] = [row[at.checked_sub(1)?], row[at]];
        let part = (level - ahead[1]) / (here[1] - ahead[1]);
        Some([0, 2].map(|k| ahead[k] + part * (here[k] - ahead[k])))
    };
    let [[x_ahead, h_ahead], [x_behind, h_behind]] = [reached(SHARES[0])?, reached(SHARES[1])?];
    Some((x_ahead - x_behind) / (0.5 * (h_ahead + h_behind)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A ramp from 2 down to 0 between x = 4 and x = 5.
    fn ramp(overshoot: f64) -> Vec<[f64; 3]> {
        let velocity = |x: f64| if x < 3.9 { 2.0 + overshoot } else { 2.0 * (5.0 - x).clamp(0.0, 1.0) };
        (0..100).map(|k| 0.1 * f64::from(k)).map(|x| [x, velocity(x), 0.25]).collect()
    }

    #[test]
    fn a_ramp_is_as_wide_as_it_is_in_any_order() {
        let mut row = ramp(0.0);
        // Nine tenths less one of a length of one, in lengths of a quarter; places are multiples of 0.1 to rounding.
        assert!((front_width(row.clone(), 2.0).unwrap() - 3.2).abs() < 1e-12);
        row.reverse();
        row.swap(3, 57);
        assert!((front_width(row, 2.0).unwrap() - 3.2).abs() < 1e-12);
    }

    #[test]
    fn what_lies_behind_the_front_does_not_count() {
        assert_eq!(front_width(ramp(0.5), 2.0), front_width(ramp(0.0), 2.0));
    }

    #[test]
    fn no_front_has_no_width() {
        assert_eq!(front_width(ramp(0.0), 2.5), None);
        assert_eq!(front_width([], 1.0), None);
        // Gas that moves from its end on has no end ahead.
        assert_eq!(front_width([[0.0, 1.0, 0.1], [1.0, 1.0, 0.1]], 1.0), None);
    }
}
