//! Formulas printed back from the code.

use etalon_audit::{formula, probes};

/// The formulas of some probes, by function, and by dimension or choice where there are several.
fn formulas(wanted: &[&str]) -> String {
    let print = |key: &&str| {
        let probe = probes().iter().find(|probe| probe.key() == **key).unwrap_or_else(|| panic!("no probe {key}"));
        format!("% {key}\n{}", formula(probe).unwrap())
    };
    wanted.iter().map(print).collect::<Vec<_>>().join("\n")
}

#[test]
fn formulas_read_as_the_papers_do() {
    insta::assert_snapshot!(formulas(&[
        "dissipation::pair_viscosity",
        "dissipation::balsara_limiter",
        "reconstruction::slope_limiter",
        "reconstruction::short_range_factor",
        "reconstruction::critical_separation 3-D",
        "grad_h::density_derivative_corrected",
        "hydrodynamics::crossed_weight",
        "limiters::slope_van_leer",
        "equation_of_state::sound_speed",
    ]));
}

#[test]
fn polynomials_powers_and_matrices_are_gathered() {
    insta::assert_snapshot!(formulas(&[
        "kernels::mixed_sinc 3-D",
        "kernels::quintic_spline 2-D",
        "kernels::wendland_c4 3-D",
        "gradients::inverse_moments 2-D",
        "gradients::moment_term 2-D",
    ]));
}

#[test]
fn every_formula_is_sound() {
    for probe in probes() {
        let text = formula(probe).unwrap();
        let count = |what: &str| text.matches(what).count();
        let braces = |open: char| text.chars().filter(|c| *c == open).count();
        assert_eq!(braces('{'), braces('}'), "{probe}\n{text}");
        assert_eq!(count(r"\left"), count(r"\right"), "{probe}\n{text}");
        assert_eq!(count(r"\begin{"), count(r"\end{"), "{probe}\n{text}");
        for output in probe.output_symbols() {
            assert!(text.contains(&format!("{output} &= ")), "{probe} has no line for {output}\n{text}");
        }
        assert!(!text.contains("= \n") && !text.contains("&= \\\\"), "{probe}\n{text}");
        // No line breaks within brackets: LaTeX would refuse them. (Those of cases are within an environment.)
        if !text.contains("cases") {
            for line in text.split(r"\\") {
                assert_eq!(line.matches(r"\left(").count(), line.matches(r"\right)").count(), "{probe}\n{text}");
            }
        }
    }
}
