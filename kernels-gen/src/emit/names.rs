//! Identifiers: an author's names made legal and unique.

use std::collections::HashSet;

/// The identifiers of one function.
pub(super) struct Names {
    taken: HashSet<String>,
    forbidden: fn(&str) -> bool,
}

impl Names {
    /// With the language's own words forbidden and the function's parameters taken.
    pub fn new(forbidden: fn(&str) -> bool, parameters: &[&str]) -> Self {
        Names { taken: parameters.iter().map(|name| name.to_string()).collect(), forbidden }
    }
    /// The wanted name, made legal, with `_1`, `_2` and so on behind it where it is taken already.
    pub fn unique(&mut self, wanted: &str) -> String {
        let base = legal(wanted, self.forbidden);
        let mut name = base.clone();
        let mut number = 0;
        while !self.taken.insert(name.clone()) {
            number += 1;
            name = format!("{}_{number}", base.trim_end_matches('_'));
        }
        name
    }
}

/// The wanted name in letters, digits and underscores, with `_` behind it where the language has the word itself.
pub(super) fn legal(wanted: &str, forbidden: fn(&str) -> bool) -> String {
    let plain: String = wanted.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
    // A leading underscore has a meaning of its own in some languages.
    let mut name = plain.trim_start_matches('_').to_string();
    if name.is_empty() {
        name = "value".to_string();
    }
    if name.starts_with(|c: char| c.is_ascii_digit()) {
        name.insert_str(0, "value_");
    }
    if forbidden(&name) {
        name.push('_');
    }
    name
}

/// `smoothing_length` as `SmoothingLength`.
pub(super) fn camel_case(name: &str) -> String {
    let capital = |word: &str| {
        let mut letters = word.chars();
        letters.next().map_or(String::new(), |first| first.to_ascii_uppercase().to_string() + letters.as_str())
    };
    legal(name, |_| false).split('_').map(capital).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_become_legal_and_unique() {
        let mut names = Names::new(|name| name == "target", &["own"]);
        let made: Vec<String> = ["target", "target", "own", "own", "_x", "2h", "\u{3c1}", "h", "h", "h"]
            .iter()
            .map(|w| names.unique(w))
            .collect();
        assert_eq!(made, ["target_", "target_1", "own_1", "own_2", "x", "value_2h", "value", "h", "h_1", "h_2"]);
        assert_eq!(camel_case("momentum_energy"), "MomentumEnergy");
    }
}
