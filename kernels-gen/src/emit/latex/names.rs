//! Names of values as symbols.

use std::collections::HashSet;

/// The symbols of one formula, each for one value.
pub(super) struct Symbols {
    taken: HashSet<String>,
}

impl Symbols {
    pub fn new() -> Self {
        Symbols { taken: HashSet::new() }
    }
    /// Keeps a symbol for what it stands for already.
    pub fn take(&mut self, symbol: &str) {
        self.taken.insert(symbol.to_string());
    }
    /// The wanted symbol, with a number below where it is taken already; `t` always has one.
    pub fn unique(&mut self, wanted: &str) -> String {
        let mut symbol = if wanted == "t" { "t_{1}".to_string() } else { wanted.to_string() };
        let mut number = 1;
        while !self.taken.insert(symbol.clone()) {
            number += 1;
            symbol = match wanted.strip_suffix('}').filter(|_| wanted.contains("_{")) {
                Some(start) => format!("{start},{number}}}"),
                None => format!("{wanted}_{{{number}}}"),
            };
        }
        symbol
    }
}

const GREEK: [&str; 23] = [
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa", "lambda", "mu", "nu", "xi",
    "pi", "rho", "sigma", "tau", "phi", "chi", "psi", "omega", "Omega",
];

/// `omega_ab` as `\omega_{ab}`, `s_4` as `s_{4}`, `inverse_determinant` as a word.
pub(super) fn symbol(name: &str) -> String {
    let parts: Vec<&str> = name.split('_').filter(|part| !part.is_empty()).collect();
    let is_index = |part: &&&str| {
        part.len() == 1 || part.len() == 2 && part.chars().all(|c| "abijxyz".contains(c) || c.is_ascii_digit())
    };
    let indices = parts.iter().skip(1).rev().take_while(is_index).count();
    let (words, below) = parts.split_at(parts.len() - indices);
    let head = match words {
        [letter] if letter.len() == 1 => (*letter).to_string(),
        [word] if GREEK.contains(word) => format!("\\{word}"),
        _ => format!(r"\mathit{{{}}}", words.join(r"\ ")),
    };
    if below.is_empty() { head } else { format!("{head}_{{{}}}", below.concat()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_become_symbols() {
        assert_eq!(symbol("omega_ab"), r"\omega_{ab}");
        assert_eq!(symbol("s_4"), "s_{4}");
        assert_eq!(symbol("e"), "e");
        assert_eq!(symbol("sinc_half_pi"), r"\mathit{sinc\ half\ pi}");
        assert_eq!(symbol("size_a"), r"\mathit{size}_{a}");
        assert_eq!(symbol("inverse_determinant"), r"\mathit{inverse\ determinant}");
        assert_eq!(symbol("shift_x"), r"\mathit{shift}_{x}");
        let mut symbols = Symbols::new();
        symbols.take("q");
        let made: Vec<String> = ["q", "q", "t", "t", "s_{a}", "s_{a}"].iter().map(|w| symbols.unique(w)).collect();
        assert_eq!(made, ["q_{2}", "q_{3}", "t_{1}", "t_{2}", "s_{a}", "s_{a,2}"]);
    }
}
