//! Reading a TOML file in two steps, so that an error can say in which entry it lies.

use serde::de::DeserializeOwned;

/// Why a piece of a file could not be read; the caller adds the file's name and the entry.
pub(crate) struct ReadError {
    /// The line, where the file is not TOML at all.
    pub line: Option<usize>,
    /// The parser's message on one line.
    pub message: String,
}

/// Parses the text of a whole file.
pub(crate) fn parse_table(text: &str) -> Result<toml::Table, ReadError> {
    text.parse::<toml::Table>().map_err(|error| ReadError {
        line: error.span().map(|span| 1 + text[..span.start.min(text.len())].matches('\n').count()),
        message: one_line(error.message()),
    })
}

/// Gives a parsed value its type.
pub(crate) fn typed<T: DeserializeOwned>(value: toml::Value) -> Result<T, ReadError> {
    T::deserialize(value).map_err(|error| ReadError { line: None, message: one_line(error.message()) })
}

/// Joins the lines of a text and removes the indentation it has in its file.
pub(crate) fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
