//! Judging WGSL before a driver sees it.

use naga::SourceLocation;
use naga::valid::{Capabilities, ValidationFlags, Validator};

use crate::device::one_line;
use crate::{Error, Result};

/// Parses and validates a text as WebGPU would, on this side of the driver. `kernel` is for the message.
///
/// # Errors
/// [`Error::Shader`] with the place, and the equation that it belongs to where the text is generated.
pub fn validate(kernel: &str, text: &str) -> Result<()> {
    let refused = |location: Option<SourceLocation>, message: &str| Error::Shader {
        kernel: kernel.to_owned(),
        message: format!("{}{}", location.map_or(String::new(), |found| place(text, found)), one_line(message)),
    };
    let module = naga::front::wgsl::parse_str(text).map_err(|error| refused(error.location(text), error.message()))?;
    let mut validator = Validator::new(ValidationFlags::all(), Capabilities::empty());
    validator.validate(&module).map_err(|error| {
        // Of the places it names, from the expression up to the whole function, the most precise one.
        let spans = error.spans().map(|(span, _)| *span).filter(naga::Span::is_defined);
        let narrowest = spans.min_by_key(|span| span.to_range().map_or(usize::MAX, |range| range.len()));
        refused(narrowest.map(|span| span.location(text)), &chain(error.as_inner()))
    })?;
    Ok(())
}

/// `in line 12, in gs25:8 balsara_limiter, at ...: `. A comment by itself inside a function names the equation of what
/// follows it, up to the next one.
fn place(text: &str, location: SourceLocation) -> String {
    let lines: Vec<&str> = text.lines().collect();
    let number = location.line_number as usize;
    let before = lines.iter().take(number).rev().take_while(|line| !line.starts_with("fn "));
    let equation = before.filter_map(|line| line.strip_prefix("    // ")).next().map_or(String::new(), |name| {
        // "back in" says that an equation has ended.
        format!(", in {}", name.strip_prefix("back in ").unwrap_or(name))
    });
    let line = lines.get(number.saturating_sub(1)).map_or("", |line| line.trim());
    format!("in line {number}{equation}, at `{line}`: ")
}

/// An error and what caused it, outermost first.
fn chain(error: &dyn std::error::Error) -> String {
    let mut all = error.to_string();
    let mut cause = error.source();
    while let Some(inner) = cause {
        all = format!("{all}: {inner}");
        cause = inner.source();
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "\
fn balsara(x: f32) -> f32 {
    let y = x * 2.0f;

    // gs25:8 balsara_limiter
    let z = y / true;
    return z;
}
";

    #[test]
    fn a_refusal_names_kernel_line_and_equation() {
        let message = validate("density", TEXT).unwrap_err().to_string();
        for part in ["`density`", "line 5", "gs25:8 balsara_limiter", "y / true"] {
            assert!(message.contains(part), "{part}: {message}");
        }
        assert!(!message.contains('\n'), "{message}");
        let syntax = validate("density", &TEXT.replace("y / true", "y /")).unwrap_err().to_string();
        assert!(syntax.contains("gs25:8 balsara_limiter"), "{syntax}");
        let other = validate("density", &TEXT.replace("x * 2.0f", "unknown")).unwrap_err().to_string();
        assert!(other.contains("line 2, at `let y = unknown;`"), "{other}");
    }

    #[test]
    fn good_text_passes() {
        validate("density", &TEXT.replace("true", "3.0f")).unwrap();
    }
}
