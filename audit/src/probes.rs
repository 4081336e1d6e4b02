//! The probes, a file per subject as in `reference/src/equations/`. Entering a file here is all there is to it.

mod conduction;
mod dissipation;
mod double_hump;
mod drag;
mod dust_reconstruction;
mod entropy;
mod equation_of_state;
mod grad_h;
mod gradients;
mod hydrodynamics;
mod initial_state;
mod kernels;
mod limiters;
mod polar;
mod reconstruction;
mod smoothing_length;
mod stiff_drag;
mod switch;
mod test_problems;
mod time_step;
mod turbulence;
mod volume_elements;

use crate::probe::Probe;
use etalon_kernels_gen::EquationEntry;
use std::sync::LazyLock;

static PROBES: LazyLock<Vec<Probe>> = LazyLock::new(|| {
    [
        conduction::probes(),
        dissipation::probes(),
        double_hump::probes(),
        drag::probes(),
        dust_reconstruction::probes(),
        entropy::probes(),
        equation_of_state::probes(),
        grad_h::probes(),
        gradients::probes(),
        hydrodynamics::probes(),
        initial_state::probes(),
        kernels::probes(),
        limiters::probes(),
        polar::probes(),
        reconstruction::probes(),
        smoothing_length::probes(),
        stiff_drag::probes(),
        switch::probes(),
        test_problems::probes(),
        time_step::probes(),
        turbulence::probes(),
        volume_elements::probes(),
    ]
    .concat()
});

/// All probes, by subject.
#[must_use]
pub fn probes() -> &'static [Probe] {
    &PROBES
}

/// The probes of an equation: one for each dimension and choice it has.
pub fn of_equation(entry: &EquationEntry) -> impl Iterator<Item = &'static Probe> {
    PROBES.iter().filter(move |probe| probe.is_of(entry))
}
