//! The folder of a report: looked at before anything is computed, written beside, put in place as a whole.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use super::html::page;
use super::json::{envelope, to_json};
use super::plot::{Plot, plots};
use super::{Particles, Report, ReportError, write_csv, write_vtu};

/// The file by which a folder is recognised.
const JSON: &str = "report.json";

/// What is laid beside a report.
#[derive(Default)]
pub struct Beside<'a> {
    /// Plots that a report cannot draw by itself.
    pub pictures: Vec<Plot>,
    /// The final particles, for `particles.csv` and `particles.vtu`.
    pub particles: Option<&'a Particles<'a>>,
    /// Further files.
    pub attachments: Vec<Attachment<'a>>,
}

/// Writes a file to a path.
pub type Save<'a> = Box<dyn Fn(&Path) -> Result<(), String> + 'a>;

/// A file that is laid beside a report.
pub struct Attachment<'a> {
    /// Its name.
    pub file: String,
    /// Writes it; the problem in words if it cannot.
    pub save: Save<'a>,
}

/// Writes `report.json`, `report.html`, the plots and what is to lie beside them into `folder`.
///
/// Everything is written into a new folder beside it, which then takes its place; a report that was there before is
/// replaced, and after a failure it is still there.
///
/// # Errors
/// What [`check_destination`] and [`super::check()`] return; [`ReportError::Io`] if the disk is full or the like.
pub fn write(report: &Report, beside: Beside, folder: &Path) -> Result<(), ReportError> {
    let Beside { pictures, particles, attachments } = beside;
    check_destination(folder)?;
    super::check(report)?;
    let mut plots = plots(report)?;
    plots.extend(pictures);
    let mut files = vec![JSON, "report.html"];
    files.extend(plots.iter().map(|plot| plot.file.as_str()));
    if particles.is_some() {
        files.extend(["particles.csv", "particles.vtu"]);
    }
    files.extend(attachments.iter().map(|attachment| attachment.file.as_str()));
    let (json, html) = (to_json(report, &files)?, page(report, &plots, &files));

    let fresh = Temporary::beside(folder, "partial")?;
    fs::create_dir_all(&fresh.0).map_err(ReportError::io("create", &fresh.0))?;
    let save = |name: &str, fill: &dyn Fn(&mut BufWriter<File>) -> io::Result<()>| {
        let path = fresh.0.join(name);
        let saved = File::create(&path).map(BufWriter::new).and_then(|mut out| {
            fill(&mut out)?;
            out.flush()
        });
        saved.map_err(ReportError::io("write", &path))
    };
    save("report.html", &|out| out.write_all(html.as_bytes()))?;
    for plot in &plots {
        save(&plot.file, &|out| out.write_all(plot.svg().as_bytes()))?;
    }
    if let Some(particles) = particles {
        save("particles.csv", &|out| write_csv(particles, out))?;
        save("particles.vtu", &|out| write_vtu(particles, out))?;
    }
    for attachment in &attachments {
        let path = fresh.0.join(&attachment.file);
        (attachment.save)(&path).map_err(|problem| ReportError::io("write", &path)(io::Error::other(problem)))?;
    }
    save(JSON, &|out| out.write_all(json.as_bytes()))?;
    put_in_place(&fresh.0, folder)
}

/// Whether a report may be written to `folder`: it does not exist, or is empty, or holds a report and nothing else. To
/// be asked before a long run, and asked again by [`write()`].
///
/// # Errors
/// [`ReportError::Occupied`] naming what is in the way; [`ReportError::Io`] if the folder cannot be looked at.
pub fn check_destination(folder: &Path) -> Result<(), ReportError> {
    let occupied = |problem: String| Err(ReportError::Occupied { folder: folder.to_owned(), problem });
    if folder.file_name().is_none() {
        return occupied("is no folder that can be replaced".into());
    }
    // Of the link itself, not of what it points to: replacing a link would leave its target behind.
    match fs::symlink_metadata(folder) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return check_writable(folder),
        Err(error) => return Err(ReportError::io("look at", folder)(error)),
        Ok(metadata) if metadata.is_dir() => {}
        Ok(_) => return occupied("exists and is not a folder".into()),
    }
    let mut names = Vec::new();
    for entry in fs::read_dir(folder).map_err(ReportError::io("list", folder))? {
        names.push(entry.map_err(ReportError::io("list", folder))?.file_name());
    }
    if names.is_empty() {
        return check_writable(folder);
    }
    let known = fs::read_to_string(folder.join(JSON)).ok().and_then(|text| envelope(&text).ok());
    let Some(known) = known else {
        return occupied(format!("is not empty and holds no {JSON} of this program"));
    };
    match names.iter().find(|name| !known.files.iter().any(|file| name.to_str() == Some(file))) {
        Some(stranger) => occupied(format!("holds {}, which is not part of the report there", stranger.display())),
        None => check_writable(folder),
    }
}

/// Whether a folder can be made beside `folder`, or where its nearest parent is: a folder is made there and removed.
fn check_writable(folder: &Path) -> Result<(), ReportError> {
    let parent =
        |path: &Path| path.parent().map(|p| if p.as_os_str().is_empty() { Path::new(".") } else { p }.to_owned());
    let mut place = parent(folder);
    while let Some(path) = place.as_deref().filter(|path| fs::symlink_metadata(path).is_err()) {
        place = parent(path);
    }
    let probe = Temporary::beside(&place.unwrap_or_else(|| PathBuf::from("/")).join("etalon"), "probe")?;
    fs::create_dir(&probe.0).map_err(ReportError::io("create a folder beside", folder))
}

/// Moves `fresh` to `folder`; what was there is removed last, and put back if the move fails.
fn put_in_place(fresh: &Path, folder: &Path) -> Result<(), ReportError> {
    if fs::symlink_metadata(folder).is_err() {
        return fs::rename(fresh, folder).map_err(ReportError::io("create", folder));
    }
    let old = Temporary::beside(folder, "old")?;
    fs::rename(folder, &old.0).map_err(ReportError::io("replace", folder))?;
    fs::rename(fresh, folder).map_err(|error| {
        if fs::rename(&old.0, folder).is_err() {
            // The old report stays beside under its temporary name rather than be removed with it.
            std::mem::forget(old);
        }
        ReportError::io("replace", folder)(error)
    })
}

/// A folder that is removed when it goes out of use, whatever happens; nothing to do once it has been renamed.
struct Temporary(PathBuf);

impl Temporary {
    /// A name beside `folder`, hidden, of this process alone.
    fn beside(folder: &Path, purpose: &str) -> Result<Self, ReportError> {
        let Some(name) = folder.file_name() else {
            let problem = "is no folder that can be replaced".into();
            return Err(ReportError::Occupied { folder: folder.to_owned(), problem });
        };
        let mut hidden = std::ffi::OsString::from(".");
        hidden.push(name);
        hidden.push(format!(".{purpose}-{}", std::process::id()));
        let path = folder.with_file_name(hidden);
        // A process that was killed may have had the same number.
        let _ = fs::remove_dir_all(&path);
        Ok(Self(path))
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        // It may have been renamed, or never created: both are fine.
        let _ = fs::remove_dir_all(&self.0);
    }
}

#[cfg(test)]
mod tests {
    use super::super::model::Outcome;
    use super::super::{Column, from_json, synthetic};
    use super::*;

    /// A folder of this test alone, removed at its end.
    fn place(test: &str) -> Temporary {
        let path = std::env::temp_dir().join(format!("etalon-report-{test}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).unwrap();
        Temporary(path)
    }

    fn listing(folder: &Path) -> Vec<String> {
        let mut names: Vec<String> =
            fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    #[test]
    fn writes_everything_and_replaces_only_itself() {
        let home = place("replace");
        let folder = home.0.join("deep/out");
        let report = synthetic::report();
        let x = [0.1, 0.2];
        let particles = Particles::new(vec![Column { name: "x", unit: "L", values: &x }]).unwrap();
        write(&report, Beside { particles: Some(&particles), ..Beside::default() }, &folder).unwrap();
        let names = listing(&folder);
        assert_eq!(names.len(), 12, "{names:?}");
        assert_eq!(from_json(&fs::read_to_string(folder.join(JSON)).unwrap()).unwrap(), report);
        // Again, without particles: the old ones do not stay behind, and no temporary folder does.
        write(&report, Beside::default(), &folder).unwrap();
        assert!(!folder.join("particles.csv").exists());
        assert_eq!(listing(&home.0.join("deep")), ["out"]);
    }

    #[test]
    fn an_empty_folder_is_free() {
        let home = place("empty");
        write(&synthetic::report(), Beside::default(), &home.0).unwrap();
        assert!(home.0.join("report.html").exists());
    }

    #[test]
    fn foreign_folders_are_left_alone() {
        let home = place("foreign");
        let message = |folder: &Path| write(&synthetic::report(), Beside::default(), folder).unwrap_err().to_string();

        let thesis = home.0.join("thesis");
        fs::create_dir(&thesis).unwrap();
        fs::write(thesis.join("chapter.tex"), "years of work").unwrap();
        assert!(message(&thesis).contains("--out"), "{}", message(&thesis));
        assert_eq!(listing(&thesis), ["chapter.tex"]);

        let other_program = home.0.join("other");
        fs::create_dir(&other_program).unwrap();
        fs::write(other_program.join(JSON), r#"{"schema": "benchmark", "schema_version": 1}"#).unwrap();
        assert!(message(&other_program).contains("holds no report.json of this program"));

        let ours = home.0.join("ours");
        write(&synthetic::report(), Beside::default(), &ours).unwrap();
        fs::write(ours.join("notes.txt"), "mine").unwrap();
        assert!(message(&ours).contains("notes.txt"), "{}", message(&ours));
        assert_eq!(fs::read_to_string(ours.join("notes.txt")).unwrap(), "mine");

        let file = home.0.join("file");
        fs::write(&file, "x").unwrap();
        assert!(message(&file).contains("not a folder"));
        assert!(message(Path::new("..")).contains("--out"));
        assert_eq!(listing(&home.0), ["file", "other", "ours", "thesis"]);
    }

    #[test]
    fn after_a_failure_the_old_report_is_still_there() {
        let home = place("failure");
        let folder = home.0.join("out");
        let good = synthetic::report();
        write(&good, Beside::default(), &folder).unwrap();
        let mut bad = synthetic::report();
        let Outcome::Ran(measured) = &mut bad.runs[1].outcome else { panic!("the synthetic SIMD run ran") };
        measured.arithmetic_difference[3].rms = f64::NAN;
        let error = write(&bad, Beside::default(), &folder).unwrap_err().to_string();
        assert!(error.contains("arithmetic_difference[internal_energy].rms"), "{error}");
        assert_eq!(from_json(&fs::read_to_string(folder.join(JSON)).unwrap()).unwrap(), good);
        assert_eq!(listing(&home.0), ["out"]);
    }
}
