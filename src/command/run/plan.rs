//! Which backends run in which precision.

use crate::command::arguments::RunArguments;
use crate::command::choices::{Backend, Precision};
use crate::command::failure::Failure;

/// A backend in a precision.
pub type Combination = (Backend, Precision);

/// What the others are compared with.
pub const REFERENCE: Combination = (Backend::Reference, Precision::Double);

/// Without a choice: what the report is about.
const USUAL: [Combination; 4] = [
    REFERENCE,
    (Backend::Simd, Precision::Double),
    (Backend::Simd, Precision::Single),
    (Backend::Wgpu, Precision::Single),
];

/// The combinations of a chosen backend, or precision, or both; the usual ones without a choice.
pub fn chosen(backend: Option<Backend>, precision: Option<Precision>) -> Result<Vec<Combination>, Failure> {
    match (backend, precision) {
        (Some(Backend::Wgpu), Some(Precision::Double)) => Err(Failure::BadInput(
            "--backend wgpu --precision f64: WGSL has no 64-bit floats; use --precision f32, or --backend simd".into(),
        )),
        (Some(backend), Some(precision)) => Ok(vec![(backend, precision)]),
        _ => {
            let fits = |(b, p): &Combination| {
                backend.is_none_or(|backend| backend == *b) && precision.is_none_or(|precision| precision == *p)
            };
            Ok(USUAL.into_iter().filter(fits).collect())
        }
    }
}

/// What a command line asks to run, the reference first.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// In the order in which they run.
    pub combinations: Vec<Combination>,
    /// Whether the graphics backend was asked for by name, so that it must not be skipped.
    pub wgpu_required: bool,
}

impl Plan {
    /// The plan, or why there is none.
    pub fn new(arguments: &RunArguments) -> Result<Self, Failure> {
        let scene = &arguments.scene;
        let mut combinations = chosen(scene.backend, scene.precision)?;
        let has = |backend| combinations.iter().any(|(b, _)| *b == backend);
        let pointless = |option: &str, backend: Backend| {
            Failure::BadInput(format!(
                "{option} concerns the {backend} backend, which is not to run; leave {option} out"
            ))
        };
        if arguments.instructions.is_some() && !has(Backend::Simd) {
            return Err(pointless("--instructions", Backend::Simd));
        }
        if arguments.threads.is_some() && !has(Backend::Simd) {
            return Err(pointless("--threads", Backend::Simd));
        }
        if arguments.adapter.is_some() && !has(Backend::Wgpu) {
            return Err(pointless("--adapter", Backend::Wgpu));
        }
        if !arguments.alone && !combinations.contains(&REFERENCE) {
            combinations.insert(0, REFERENCE);
        }
        if arguments.alone && scene.backend.is_none() && scene.precision.is_none() {
            return Err(Failure::BadInput(
                "--alone leaves the reference out beside what was chosen; choose with --backend or --precision".into(),
            ));
        }
        let wgpu_required = scene.backend == Some(Backend::Wgpu) || arguments.adapter.is_some();
        Ok(Plan { combinations, wgpu_required })
    }

    /// The precisions of what is compared with the reference, each once; none without the reference.
    pub fn compared_precisions(&self) -> Vec<Precision> {
        let judged =
            |precision: &Precision| self.combinations.iter().any(|other| *other != REFERENCE && other.1 == *precision);
        match self.combinations.contains(&REFERENCE) {
            true => Precision::ALL.iter().copied().filter(judged).collect(),
            false => Vec::new(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_choice_narrows_the_usual_runs() {
        use Backend::*;
        use Precision::*;
        assert_eq!(chosen(None, None).unwrap(), USUAL);
        assert_eq!(chosen(Some(Simd), None).unwrap(), [(Simd, Double), (Simd, Single)]);
        assert_eq!(chosen(None, Some(Single)).unwrap(), [(Simd, Single), (Wgpu, Single)]);
        assert_eq!(chosen(Some(Reference), Some(Single)).unwrap(), [(Reference, Single)]);
        assert!(chosen(Some(Wgpu), Some(Double)).unwrap_err().to_string().contains("--precision f32"));
    }
}
