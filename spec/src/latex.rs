//! As much of LaTeX as is needed to check the ledger's formulas: tokens, pairs, and which symbols occur.

use std::ops::Range;

/// A token: a command with its backslash, or a single character. White space between tokens is dropped.
pub(crate) type Token = String;

/// Splits a formula into tokens and writes groups of one token without braces, so that `x_{a}` equals `x_a`.
pub(crate) fn tokens(formula: &str) -> Vec<Token> {
    let mut split: Vec<Token> = Vec::new();
    let mut letters = formula.chars().peekable();
    while let Some(letter) = letters.next() {
        if letter.is_whitespace() {
            continue;
        }
        let mut token = String::from(letter);
        if letter == '\\' {
            let word = letters.peek().is_some_and(char::is_ascii_alphabetic);
            while let Some(next) = letters.next_if(|next| word && next.is_ascii_alphabetic()) {
                token.push(next);
            }
            if !word {
                token.extend(letters.next());
            }
        }
        split.push(token);
        let end = split.len();
        if end >= 3 && split[end - 1] == "}" && split[end - 3] == "{" && !matches!(split[end - 2].as_str(), "{" | "}") {
            split.remove(end - 1);
            split.remove(end - 3);
        }
    }
    split
}

/// What does not pair up in a formula or, with `dollars`, in a sentence that holds formulas.
pub(crate) fn fault(text: &str) -> Option<String> {
    let mut depth = 0_usize;
    let mut environments: Vec<&str> = Vec::new();
    let mut dollars = 0_usize;
    let mut rest = text;
    let mut consumed = 0;
    while let Some(letter) = rest.chars().next() {
        let mut step = letter.len_utf8();
        match letter {
            '\\' => {
                // The character after a backslash is part of the command: `\{` opens no group.
                step += rest[step..].chars().next().map_or(0, char::len_utf8);
                if let Some(name) = environment(rest, "\\begin{") {
                    environments.push(name);
                } else if let Some(name) = environment(rest, "\\end{")
                    && environments.pop() != Some(name)
                {
                    return Some(format!("`\\end{{{name}}}` closes no environment of that name"));
                }
            }
            '{' => depth += 1,
            '}' if depth == 0 => {
                return Some(format!("a closing brace at character {} has no opening one", consumed + 1));
            }
            '}' => depth -= 1,
            '$' => dollars += 1,
            _ => {}
        }
        consumed += rest[..step].chars().count();
        rest = &rest[step..];
    }
    if depth > 0 {
        return Some(format!("{depth} opening brace(s) are never closed"));
    }
    if let Some(name) = environments.last() {
        return Some(format!("`\\begin{{{name}}}` is never ended"));
    }
    (dollars % 2 == 1).then(|| "a dollar sign has no partner".to_owned())
}

fn environment<'text>(text: &'text str, opening: &str) -> Option<&'text str> {
    text.strip_prefix(opening)?.split_once('}').map(|(name, _)| name)
}

/// Where `symbol` occurs in `formula`, as ranges of tokens.
pub(crate) fn occurrences(formula: &[Token], symbol: &[Token]) -> Vec<Range<usize>> {
    if symbol.is_empty() {
        return Vec::new();
    }
    formula
        .windows(symbol.len())
        .enumerate()
        .filter(|(_, window)| *window == symbol)
        .map(|(start, _)| start..start + symbol.len())
        .collect()
}

/// The symbol of the partner particle: every `one` becomes `other` and the reverse.
pub(crate) fn swapped(symbol: &[Token], one: &str, other: &str) -> Vec<Token> {
    let swap = |token: &Token| {
        if token == one {
            other.to_owned()
        } else if token == other {
            one.to_owned()
        } else {
            token.clone()
        }
    };
    symbol.iter().map(swap).collect()
}

/// The first letter of `formula` that is neither `covered` nor one of the `indices`.
pub(crate) fn unexplained<'formula>(
    formula: &'formula [Token],
    covered: &[bool],
    indices: &[&str],
) -> Option<&'formula Token> {
    let mut position = 0;
    while position < formula.len() {
        let token = &formula[position];
        if covered[position] {
            position += 1;
        } else if WORDS.contains(&token.as_str()) {
            position = after_argument(formula, position + 1);
        } else if is_letter(token) && !indices.contains(&token.as_str()) {
            return Some(token);
        } else {
            position += 1;
        }
    }
    None
}

/// The position after a command's argument: a group in braces or a single token.
fn after_argument(formula: &[Token], start: usize) -> usize {
    let mut depth = 0_usize;
    for (offset, token) in formula[start..].iter().enumerate() {
        match token.as_str() {
            "{" => depth += 1,
            "}" => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth == 0 {
            return start + offset + 1;
        }
    }
    formula.len()
}

/// Commands whose argument is a word, not symbols.
const WORDS: [&str; 6] = ["\\text", "\\mathrm", "\\operatorname", "\\begin", "\\end", "\\tag"];

fn is_letter(token: &str) -> bool {
    match token.strip_prefix('\\') {
        Some(command) => GREEK.contains(&command),
        None => token.chars().all(char::is_alphabetic),
    }
}

/// Greek letters and other commands that stand for quantities; `\pi` is the number and needs no explanation.
const GREEK: [&str; 36] = [
    "alpha",
    "beta",
    "gamma",
    "delta",
    "epsilon",
    "varepsilon",
    "zeta",
    "eta",
    "theta",
    "vartheta",
    "iota",
    "kappa",
    "lambda",
    "mu",
    "nu",
    "xi",
    "rho",
    "sigma",
    "tau",
    "upsilon",
    "phi",
    "varphi",
    "chi",
    "psi",
    "omega",
    "ell",
    "Gamma",
    "Delta",
    "Theta",
    "Lambda",
    "Xi",
    "Pi",
    "Sigma",
    "Phi",
    "Psi",
    "Omega",
];
