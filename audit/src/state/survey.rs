//! Measuring equations, checking their units, printing them: what takes time, and needs no record.

use super::{Worse, chosen};
use crate::bad_input::{differences, not_caught, unsaid};
use crate::budgets::{Budgets, Regression};
use crate::catalogue::{Catalogue, Subject};
use crate::device::{Device, DeviceError};
use crate::encoded::Vanished;
use crate::measure::{Measurement, measure_on};
use crate::probe::Probe;
use crate::probes::of_equation;
use crate::units::check_units;
use etalon_kernels_gen::emit::{Header, MulAdd, c, wgsl};
use etalon_kernels_gen::trace::Single;
use std::collections::{BTreeMap, BTreeSet};

/// What was found of the equations asked for.
#[derive(Clone, Debug, Default)]
pub struct Survey {
    pub(super) samples: usize,
    /// What was asked for; nothing if all were.
    pub(super) only: Option<Subject>,
    pub(super) measurements: Vec<Measurement>,
    /// By the function's path: whether its units fit.
    pub(super) units: BTreeMap<String, bool>,
    /// By the function's path: what it could be printed for.
    pub(super) printed: BTreeMap<String, BTreeSet<&'static str>>,
    /// Units that do not fit, and bad input that is not treated as the ledger says: no record can excuse them.
    faults: Vec<Worse>,
}

impl Survey {
    /// Measures everything, or only one subject, on all hard inputs and as many random ones; on a device too, if there is one. `progress`
    /// hears of each probe before it is measured, with how many are done and how many there are.
    ///
    /// # Errors
    /// [`DeviceError`] if the device did not run an equation.
    pub fn of(
        catalogue: &Catalogue,
        only: Option<Subject>,
        samples: usize,
        device: Option<&dyn Device>,
        progress: impl FnMut(&str, usize, usize),
    ) -> Result<Self, DeviceError> {
        let (_, entries) = chosen(catalogue, only.as_ref());
        let probes: Vec<&Probe> = entries.iter().flat_map(|entry| of_equation(entry)).collect();
        let mut survey = Survey::of_probes(catalogue, only, &probes, samples, device, progress)?;
        if survey.only.is_none() {
            let faults = not_caught(&catalogue.ledger, crate::probes());
            let worse = |message: String| Worse { subject: "bad input".to_string(), message };
            survey.faults.extend(faults.iter().map(|fault| worse(fault.to_string())));
        }
        Ok(survey)
    }

    /// The same with these probes, for equations that are not among [`probes`](crate::probes()).
    ///
    /// # Errors
    /// As for [`of`](Survey::of).
    pub fn of_probes(
        catalogue: &Catalogue,
        only: Option<Subject>,
        probes: &[&Probe],
        samples: usize,
        device: Option<&dyn Device>,
        mut progress: impl FnMut(&str, usize, usize),
    ) -> Result<Self, DeviceError> {
        let mut survey = Survey { samples, only, ..Survey::default() };
        for (done, probe) in probes.iter().enumerate() {
            progress(&probe.key(), done, probes.len());
            survey.check(catalogue, probe);
            survey.measurements.extend(measure_on(probe, device, samples)?);
        }
        Ok(survey)
    }

    /// The record of what was measured, in the order of [`probes`](crate::probes()).
    #[must_use]
    pub fn budgets(&self) -> Budgets {
        let place = |measurement: &Measurement| {
            crate::probes().iter().position(|probe| probe.key() == measurement.probe).unwrap_or(usize::MAX)
        };
        let mut measurements = self.measurements.clone();
        measurements.sort_by_cached_key(place);
        Budgets::of(&measurements)
    }

    /// Units, bad input, and whether it can be printed.
    fn check(&mut self, catalogue: &Catalogue, probe: &Probe) {
        let path = probe.path();
        let faults = check_units(probe).err().unwrap_or_default();
        *self.units.entry(path.clone()).or_insert(true) &= faults.is_empty();
        let worse = |message: String| Worse { subject: path.clone(), message };
        self.faults.extend(faults.iter().map(|fault| worse(fault.to_string())));
        let faults = [unsaid(&catalogue.ledger, probe), differences(probe)].concat();
        self.faults.extend(faults.iter().map(|fault| worse(fault.to_string())));
        let head = Header { command: "etalon audit", definition: &path };
        let printed = self.printed.entry(path.clone()).or_default();
        if let Ok(drawing) = probe.draw::<Single>() {
            if wgsl::function(probe.function, &drawing, &head, MulAdd::TwoRoundings).is_ok() {
                printed.insert("wgsl");
            }
            if c::function(probe.function, &drawing, &head, MulAdd::TwoRoundings).is_ok() {
                printed.insert("c");
            }
        }
    }

    /// What is worse than recorded.
    pub(super) fn regressions(&self, catalogue: &Catalogue) -> Vec<Worse> {
        let mut worse = self.faults.clone();
        for measurement in &self.measurements {
            let path = measurement.probe.split(' ').next().unwrap_or_default();
            worse.extend(catalogue.budgets.compare(measurement).iter().map(|regression| told(path, regression)));
        }
        let asked = |vanished: &&Vanished| match &self.only {
            None => true,
            Some(Subject::Number(id)) => vanished.subject() == id.to_string(),
            Some(Subject::Functions(_)) => false,
        };
        let vanished = catalogue.encoded.vanished(&catalogue.entries);
        let gone = |gone: &Vanished| Worse { subject: gone.subject().to_string(), message: gone.to_string() };
        worse.extend(vanished.iter().filter(asked).map(gone));
        if self.only.is_none() {
            worse.extend(catalogue.budgets.left_over().iter().map(|left| told("audit/budgets.toml", left)));
        }
        worse
    }
}

fn told(subject: &str, regression: &Regression) -> Worse {
    Worse { subject: subject.to_string(), message: regression.to_string() }
}
