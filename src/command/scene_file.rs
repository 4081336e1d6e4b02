//! A scene as a file in TOML: what a user can copy, change and run.
//!
//! ```toml
//! scene = "sod"
//! dimension = 2
//! end_time = 0.1
//! [method]
//! particles = 20000
//! [problem]
//! gamma = 1.4
//! ```
//!
//! All but `scene` may be left out; what is left out is as in the paper.

use etalon_reference::scenes::{Arrangement, Definition, Method, Name, Problem, ReadChoices};
use etalon_reference::schemes::{Dissipation, GradH, Gradients, Kernel, Rung, Viscosity, VolumeElement};
use serde::{Deserialize, Serialize, Serializer};
use std::ops::Range;

/// The top level; `P` is what is read of the problem's own choices.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct File<P> {
    scene: Name,
    #[serde(default)]
    dimension: Option<usize>,
    #[serde(default)]
    end_time: Option<f64>,
    #[serde(default)]
    observe_every: Option<f64>,
    #[serde(default)]
    method: MethodChanges,
    #[serde(default = "none")]
    problem: Option<P>,
}

fn none<P>() -> Option<P> {
    None
}

/// Choices of the method that differ from the scene's usual ones.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct MethodChanges {
    /// About how many particles.
    pub particles: Option<usize>,
    /// How they start.
    pub start: Option<Arrangement>,
    /// The kernel.
    pub kernel: Option<Kernel>,
    /// Neighbours within a support.
    pub neighbours: Option<f64>,
    /// The dissipation scheme.
    pub scheme: Option<Dissipation>,
    /// A rung of C25's ladder: gradients, volume elements and scheme at once; what is said of each besides goes before it.
    pub rung: Option<Rung>,
    /// How derivatives are estimated.
    pub gradients: Option<Gradients>,
    /// Which volume a particle stands for.
    pub volume_elements: Option<VolumeElement>,
    /// The grad-h form.
    pub grad_h: Option<GradH>,
    /// Linear coefficient of the viscosity.
    pub alpha: Option<f64>,
    /// Its least value where it depends on time.
    pub alpha_min: Option<f64>,
    /// Quadratic coefficient.
    pub beta: Option<f64>,
    /// Width of the reconstruction's cut-off.
    pub q_fold: Option<f64>,
    /// Floor of the linear coefficient in AVSLRB2F.
    pub floor: Option<f64>,
    /// The period of a driven wave.
    pub wave_period: Option<f64>,
    /// Coefficient of artificial conduction.
    pub conduction: Option<f64>,
}

impl MethodChanges {
    /// What these and then `later` change together. A later rung takes the place of all that it decides.
    pub fn and(self, later: Self) -> Self {
        let earlier = match later.rung {
            Some(_) => MethodChanges { scheme: None, gradients: None, volume_elements: None, ..self },
            None => self,
        };
        MethodChanges {
            particles: later.particles.or(earlier.particles),
            start: later.start.or(earlier.start),
            kernel: later.kernel.or(earlier.kernel),
            neighbours: later.neighbours.or(earlier.neighbours),
            scheme: later.scheme.or(earlier.scheme),
            rung: later.rung.or(earlier.rung),
            gradients: later.gradients.or(earlier.gradients),
            volume_elements: later.volume_elements.or(earlier.volume_elements),
            grad_h: later.grad_h.or(earlier.grad_h),
            alpha: later.alpha.or(earlier.alpha),
            alpha_min: later.alpha_min.or(earlier.alpha_min),
            beta: later.beta.or(earlier.beta),
            q_fold: later.q_fold.or(earlier.q_fold),
            floor: later.floor.or(earlier.floor),
            wave_period: later.wave_period.or(earlier.wave_period),
            conduction: later.conduction.or(earlier.conduction),
        }
    }

    /// The method so changed. A wider kernel without a neighbour number of its own gets more, so that the smoothing length stays.
    pub fn of(&self, usual: Method, dimension: usize) -> Method {
        let usual = self.rung.map_or(usual, |rung| usual.on(rung));
        let kernel = self.kernel.unwrap_or(usual.kernel);
        let wider = Method::usual_neighbours(dimension, kernel) / Method::usual_neighbours(dimension, usual.kernel);
        let coefficients = match self.scheme {
            Some(scheme) => Viscosity { conduction: usual.viscosity.conduction, ..Viscosity::of(scheme) },
            None => usual.viscosity,
        };
        Method {
            particles: self.particles.unwrap_or(usual.particles),
            arrangement: self.start.unwrap_or(usual.arrangement),
            kernel,
            neighbours: self.neighbours.unwrap_or(usual.neighbours * wider),
            viscosity: Viscosity {
                alpha: self.alpha.unwrap_or(coefficients.alpha),
                alpha_min: self.alpha_min.unwrap_or(coefficients.alpha_min),
                beta: self.beta.unwrap_or(coefficients.beta),
                q_fold: self.q_fold.unwrap_or(coefficients.q_fold),
                floor: self.floor.unwrap_or(coefficients.floor),
                wave_period: self.wave_period.unwrap_or(coefficients.wave_period),
                conduction: self.conduction.unwrap_or(coefficients.conduction),
                ..coefficients
            },
            gradients: self.gradients.unwrap_or(usual.gradients),
            volume_element: self.volume_elements.unwrap_or(usual.volume_element),
            grad_h: self.grad_h.unwrap_or(usual.grad_h),
        }
    }
}

/// A scene as it was written down.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneFile {
    /// Which problem.
    pub name: Name,
    /// In how many dimensions; the usual ones if it does not say.
    pub dimension: Option<usize>,
    /// When to stop; when the paper looks if it does not say.
    pub end_time: Option<f64>,
    /// The time between two measurements.
    pub observe_every: Option<f64>,
    /// What is different about the method.
    pub method: MethodChanges,
    /// The problem's own choices, by key.
    pub choices: toml::Table,
}

/// What is wrong with a scene file: line, if it is known, and sentence.
#[derive(Clone, Debug, PartialEq)]
pub struct Wrong {
    /// The line, from 1.
    pub line: Option<usize>,
    /// What is wrong, and what is allowed.
    pub problem: String,
}

impl std::fmt::Display for Wrong {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.line {
            Some(line) => write!(f, "line {line}: {}", self.problem),
            None => f.write_str(&self.problem),
        }
    }
}

impl Wrong {
    fn of(error: &toml::de::Error, text: &str) -> Self {
        let line = |Range { start, .. }: Range<usize>| {
            1 + text.as_bytes()[..start.min(text.len())].iter().filter(|b| **b == b'\n').count()
        };
        let problem = error.message().split_whitespace().collect::<Vec<_>>().join(" ");
        Wrong { line: error.span().map(line), problem }
    }
}

impl SceneFile {
    /// A scene that says nothing but its name.
    pub fn of(name: Name) -> Self {
        SceneFile {
            name,
            dimension: None,
            end_time: None,
            observe_every: None,
            method: MethodChanges::default(),
            choices: toml::Table::new(),
        }
    }

    /// Reads a text.
    ///
    /// # Errors
    /// A key that there is not (with those there are), a value of the wrong type, a name that there is not, with its line.
    pub fn parse(text: &str) -> Result<Self, Wrong> {
        let wrong = |error: toml::de::Error| Wrong::of(&error, text);
        let file: File<toml::Table> = toml::from_str(text).map_err(wrong)?;
        // The choices once more as what they must be: only the text tells the line of a wrong one.
        Problem::read(file.scene, FromText(text)).map_err(wrong)?;
        Ok(SceneFile {
            name: file.scene,
            dimension: file.dimension,
            end_time: file.end_time,
            observe_every: file.observe_every,
            method: file.method,
            choices: file.problem.unwrap_or_default(),
        })
    }

    /// The problem with its own choices, its method the usual one in so many dimensions changed as the file says.
    ///
    /// # Errors
    /// A choice that there is not or of the wrong type; it can come from the command line here.
    pub fn problem(&self, dimension: usize) -> Result<Problem, Wrong> {
        let refused = |problem: String| Wrong { line: None, problem };
        let usual = self.name.standard(dimension).map_err(|error| refused(error.to_string()))?;
        let wrong = |error: toml::de::Error| refused(error.message().split_whitespace().collect::<Vec<_>>().join(" "));
        let mut problem = Problem::read(self.name, FromTable(&self.choices)).map_err(wrong)?;
        *problem.method_mut() = self.method.of(*usual.method(), dimension);
        Ok(problem)
    }
}

/// Reads the choices where they stand in a file.
struct FromText<'a>(&'a str);

impl ReadChoices for FromText<'_> {
    type Error = toml::de::Error;
    fn read<P: Definition>(&self) -> Result<P, Self::Error> {
        let file: File<P> = toml::from_str(self.0)?;
        Ok(file.problem.unwrap_or_else(|| P::standard(P::DIMENSIONS[0])))
    }
}

/// Reads them from a table.
struct FromTable<'a>(&'a toml::Table);

impl ReadChoices for FromTable<'_> {
    type Error = toml::de::Error;
    fn read<P: Definition>(&self) -> Result<P, Self::Error> {
        self.0.clone().try_into()
    }
}

/// A problem's own choices.
struct Choices<'a>(&'a Problem);

impl Serialize for Choices<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.0.choices(serializer)
    }
}

/// The problem's own choices as a table.
pub fn choices(problem: &Problem) -> Result<toml::Table, toml::ser::Error> {
    toml::Table::try_from(Choices(problem))
}

/// A scene as a text that [`SceneFile::parse`] reads again, everything spelled out.
pub fn text(problem: &Problem, dimension: usize, end_time: f64) -> Result<String, toml::ser::Error> {
    let name = problem.name();
    let Method { particles, arrangement, kernel, neighbours, viscosity, gradients, volume_element, grad_h } =
        *problem.method();
    let Viscosity { dissipation, alpha, alpha_min, beta, q_fold, floor, wave_period, conduction, .. } = viscosity;
    let dimensions: Vec<String> = name.dimensions().iter().map(ToString::to_string).collect();
    let float = |value: f64| toml::Value::Float(value).to_string();
    let mut lines = vec![
        format!("# {} ({}). Compared with: {}.", name.title(), name.source(), name.solution()),
        format!("# Copy, change, and run with `etalon run FILE`. What is left out is as here."),
        format!("scene = \"{name}\""),
        format!("dimension = {dimension}  # it runs in {}", dimensions.join(", ")),
        format!("end_time = {}", float(end_time)),
        String::from("# observe_every = 0.01  # time between two measurements of what is measured while it runs"),
        String::new(),
        String::from("[method]"),
        format!("particles = {particles}  # about; walls not counted"),
        format!("start = \"{arrangement}\"  # {}", names(Arrangement::ALL)),
        format!("kernel = \"{kernel}\"  # {}", names(Kernel::ALL)),
        format!("neighbours = {}  # within a support, the particle included", float(neighbours)),
        format!("scheme = \"{dissipation}\"  # {}", names(Dissipation::ALL)),
        format!("gradients = \"{gradients}\"  # {}", names(Gradients::ALL)),
        format!("volume_elements = \"{volume_element}\"  # {}", names(VolumeElement::ALL)),
        format!("grad_h = \"{grad_h}\"  # {}", names(GradH::ALL)),
        format!(
            "alpha = {}  # linear coefficient of the viscosity, the largest where it depends on time",
            float(alpha)
        ),
    ];
    if dissipation.switches() {
        lines.push(format!("alpha_min = {}  # its least value", float(alpha_min)));
    }
    lines.push(format!("beta = {}  # quadratic coefficient", float(beta)));
    if dissipation.reconstructs() {
        lines
            .push(format!("q_fold = {}  # width of the reconstruction's cut-off, in smoothing lengths", float(q_fold)));
    }
    if matches!(dissipation, Dissipation::AvSlrB2F | Dissipation::AvSlrBStar2F) {
        lines.push(format!("floor = {}  # of the linear coefficient", float(floor)));
    }
    if dissipation.knows_waves() {
        lines.push(format!("wave_period = {}  # of the driver", float(wave_period)));
    }
    lines.push(format!("conduction = {}  # coefficient of artificial conduction", float(conduction)));
    lines.push(String::new());
    // Under its key, so that a choice with parts of its own is a table below it.
    let choices = toml::Table::from_iter([("problem".to_string(), toml::Value::Table(choices(problem)?))]);
    Ok(lines.join("\n") + "\n" + &toml::to_string(&choices)?)
}

fn names<T: std::fmt::Display>(all: &[T]) -> String {
    let names: Vec<String> = all.iter().map(ToString::to_string).collect();
    names.join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_scene_written_down_is_read_as_the_same() {
        for &name in Name::ALL {
            for &dimension in name.dimensions() {
                let problem = name.standard(dimension).unwrap();
                let written = text(&problem, dimension, problem.end_time()).unwrap();
                let read = SceneFile::parse(&written).unwrap_or_else(|wrong| panic!("{wrong}:\n{written}"));
                assert_eq!(read.problem(dimension).unwrap(), problem, "{written}");
                assert_eq!((read.dimension, read.end_time), (Some(dimension), Some(problem.end_time())));
            }
        }
    }

    #[test]
    fn what_is_left_out_is_usual() {
        let read = SceneFile::parse("scene = \"sod\"\n").unwrap();
        assert_eq!(read.problem(2).unwrap(), Name::Sod.standard(2).unwrap());
    }

    #[test]
    fn what_is_wrong_is_named_with_its_line_and_what_is_allowed() {
        for (text, line, words) in [
            ("", None, &["scene"][..]),
            ("scene = \"sod\"\nspeed = 1\n", Some(2), &["speed", "end_time"]),
            ("scene = \"sodd\"\n", Some(1), &["there is no scene `sodd`", "sod"]),
            ("scene = \"sod\"\n[method]\nkernel = \"gauss\"\n", Some(3), &["gauss", "sinc49"]),
            ("scene = \"sod\"\n[method]\nparticles = -4\n", Some(3), &["-4"]),
            ("scene = \"sod\"\n[method]\nneighbours = \"many\"\n", Some(3), &["many"]),
            ("scene = \"sod\"\n[problem]\nsmoothed = 1\n", Some(3), &["boolean"]),
            ("scene = \"sod\"\n[problem]\n\nwidth = 1\n", Some(4), &["width", "gamma"]),
            ("scene = \"sod\"\n[problem\n", Some(2), &[]),
            ("scene = \"sod\"\nscene = \"sod\"\n", Some(2), &["duplicate"]),
        ] {
            let wrong = SceneFile::parse(text).unwrap_err();
            if line.is_some() {
                assert_eq!(wrong.line, line, "{text}: {wrong}");
            }
            for word in words {
                assert!(wrong.problem.contains(word), "{text}: {wrong}");
            }
        }
    }

    #[test]
    fn a_rung_is_three_choices_and_each_can_be_changed_again() {
        let method = |text: &str| {
            let text = format!("scene = \"sod\"\n[method]\n{text}\n");
            *SceneFile::parse(&text).unwrap().problem(2).unwrap().method()
        };
        let usual = method("");
        assert_eq!(method("rung = \"STD\""), usual.on(Rung::Standard));
        assert_eq!(
            method("gradients = \"kernel\"\nvolume_elements = \"standard\"\nscheme = \"AV\""),
            usual.on(Rung::Standard)
        );
        let changed = method("rung = \"IA\"\ngradients = \"kernel\"\nalpha = 0.5");
        assert_eq!((changed.gradients, changed.viscosity.alpha), (Gradients::Kernel, 0.5));
        assert_eq!(changed.volume_element, VolumeElement::Standard);
        // What a file spells out gives way to a rung chosen later.
        let spelled = MethodChanges { scheme: Some(Dissipation::AvSlr), alpha: Some(0.5), ..MethodChanges::default() };
        let later = MethodChanges { rung: Some(Rung::Standard), ..MethodChanges::default() };
        let both = spelled.and(later).of(usual, 2);
        assert_eq!((both.viscosity.dissipation, both.viscosity.alpha), (Dissipation::Av, 0.5));
        // Written down, every rung is read as the same.
        for &rung in Rung::ALL {
            let mut problem = Name::Sod.standard(2).unwrap();
            *problem.method_mut() = problem.method().on(rung);
            let written = text(&problem, 2, 0.2).unwrap();
            assert_eq!(SceneFile::parse(&written).unwrap().problem(2).unwrap(), problem, "{written}");
        }
    }

    #[test]
    fn a_wider_kernel_keeps_the_smoothing_length_of_a_scene() {
        let changes = MethodChanges { kernel: Some(Kernel::QuinticSpline), ..MethodChanges::default() };
        let usual = Method { neighbours: 120.0, ..Method::standard(3, 100) };
        // (3/2)^3 times as many.
        assert!((changes.of(usual, 3).neighbours / 405.0 - 1.0).abs() < 1e-12);
        let exact = MethodChanges { neighbours: Some(50.0), ..changes };
        assert_eq!(exact.of(usual, 3).neighbours, 50.0);
    }
}
