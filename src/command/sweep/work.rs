//! Doing what is left, smallest first, with an estimate of the time it will take: the work that is left at the pace of what was done.

use super::{Job, Record, Store};
use crate::command::failure::Failure;
use crate::command::run::graphics::Graphics;
use crate::command::run::progress::note;
use crate::report::plain;
use fearless_simd::Level;

/// What runs are made with.
pub struct Chances<'a> {
    /// Vector instructions.
    pub level: Level,
    /// The adapter, or why there is none.
    pub graphics: &'a Graphics,
    /// Wall-clock time by which a run must be expected to end to be begun, in seconds; none for no limit.
    pub budget_seconds: Option<f64>,
}

/// Makes those of the jobs that are not done yet; how many are left because time ran out.
///
/// A run that breaks down is told and left out; the others go on.
pub fn work(jobs: &[Job], store: &mut Store, with: &Chances) -> Result<usize, Failure> {
    let mut left: Vec<&Job> = jobs.iter().filter(|job| store.find(&job.id()).is_none()).collect();
    left.sort_by(|a, b| a.weight.total_cmp(&b.weight));
    if left.len() < jobs.len() {
        note(&format!("{} of {} runs are done already", jobs.len() - left.len(), jobs.len()));
    }
    let clock = std::time::Instant::now();
    let (mut done, mut rest) = (0.0, left.iter().map(|job| job.weight).sum::<f64>());
    for (number, job) in left.iter().enumerate() {
        let spent = clock.elapsed().as_secs_f64();
        if number > 0 {
            let pace = if done > 0.0 { spent / done } else { 0.0 };
            // The first is begun in any case: a call that does nothing would never come to an end.
            if with.budget_seconds.is_some_and(|budget| spent + pace * job.weight > budget) {
                return Ok(left.len() - number);
            }
            note(&format!("run {} of {}, about {} left", number + 1, left.len(), duration(pace * rest)));
        }
        let label = format!("{} of {}: {}", number + 1, left.len(), job.name());
        let begun = std::time::Instant::now();
        match job.fits().and_then(|()| job.run(with.level, with.graphics, &label, store.folder())) {
            Ok((record, restarts)) => {
                // Of a run that went on from a restart file only the rest was made now.
                let share = begun.elapsed().as_secs_f64() / record.wall_seconds.max(f64::MIN_POSITIVE);
                done += job.weight * share.min(1.0);
                store.add(record)?;
                restarts.remove();
            }
            Err(error) => note(&format!("left out: {}: {error}", job.id())),
        }
        rest -= job.weight;
    }
    Ok(0)
}

/// The records of jobs, in their order; none for those that are not done.
pub fn done_of<'a>(jobs: &[Job], store: &'a Store) -> Vec<Option<&'a Record>> {
    jobs.iter().map(|job| store.find(&job.id())).collect()
}

/// A time for people.
fn duration(seconds: f64) -> String {
    match seconds {
        s if s < 90.0 => format!("{s:.0} s"),
        s if s < 5400.0 => format!("{:.0} min", s / 60.0),
        s => format!("{} h", plain((s / 360.0).round() / 10.0)),
    }
}

#[cfg(test)]
mod tests {
    use super::duration;

    #[test]
    fn durations_are_told_in_the_unit_that_suits_them() {
        assert_eq!([duration(12.4), duration(600.0), duration(9000.0)], ["12 s", "10 min", "2.50 h"]);
    }
}
