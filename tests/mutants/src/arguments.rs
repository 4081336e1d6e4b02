//! The command line.

use clap::Parser;

/// Puts small faults into the equations, one at a time, and looks whether a test notices.
#[derive(Debug, Parser)]
#[command(name = "etalon-mutants", version)]
pub struct Arguments {
    /// Tests to run at a time; as many as there are processors if not given.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub jobs: Option<u16>,
    /// Only equations whose path contains this, such as `dissipation` or `slope_limiter`; may be given again.
    #[arg(long, value_name = "NAME")]
    pub only: Vec<String>,
    /// Only this part of the work, such as `1/4`; results of earlier parts are kept.
    #[arg(long, value_name = "I/N", value_parser = Part::parse)]
    pub part: Option<Part>,
    /// Run all mutants, also those whose result is known.
    #[arg(long)]
    pub fresh: bool,
    /// List the mutants and run none.
    #[arg(long, conflicts_with_all = ["check", "json"])]
    pub list: bool,
    /// Run none: fail if the record is incomplete, or the page is not what it says.
    #[arg(long)]
    pub check: bool,
    /// The result as JSON on standard output.
    #[arg(long)]
    pub json: bool,
}

impl Arguments {
    /// Whether an equation is among those asked for.
    pub fn wants(&self, path: &str) -> bool {
        self.only.is_empty() || self.only.iter().any(|name| path.contains(name.as_str()))
    }
}

/// One of several parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Part {
    index: usize,
    count: usize,
}

impl Part {
    fn parse(text: &str) -> Result<Self, String> {
        let numbers = text.split_once('/').and_then(|(i, n)| Some((i.parse().ok()?, n.parse().ok()?)));
        match numbers {
            Some((index, count)) if index >= 1 && index <= count => Ok(Part { index, count }),
            _ => Err("write which part of how many, such as 1/4".to_string()),
        }
    }

    /// Whether the `n`th piece of work belongs to it.
    pub fn has(&self, n: usize) -> bool {
        n % self.count == self.index - 1
    }
}

#[cfg(test)]
mod tests {
    use super::Part;

    #[test]
    fn parts_share_the_work() {
        let parts = ["1/3", "2/3", "3/3"].map(|text| Part::parse(text).unwrap());
        for n in 0..10 {
            assert_eq!(parts.iter().filter(|part| part.has(n)).count(), 1, "piece {n}");
        }
        for text in ["0/3", "4/3", "1", "a/b", "1/0", ""] {
            assert!(Part::parse(text).is_err(), "{text}");
        }
    }
}
