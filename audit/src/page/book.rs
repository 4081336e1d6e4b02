//! All pages, with the indices by paper and by symbol, as files below `docs/`.

use super::indices::{by_paper, by_symbol, gains};
use super::markdown::GENERATED;
use super::mathml::NoFormula;
use super::{Page, PageError};
use crate::catalogue::Catalogue;
use crate::encoded::path_of;
use etalon_spec::EquationId;
use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Where the pages are, below `docs/`.
const FOLDER: &str = "equations";
/// The table of contents of the book.
const SUMMARY: &str = "SUMMARY.md";
/// The part of it that is generated: from this line to the next heading.
const PART: &str = "# Equations";

/// The generated files, by their paths below `docs/`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Book {
    files: BTreeMap<PathBuf, String>,
    contents: String,
}

/// A file that is not what it should be.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Stale {
    /// It is not there.
    #[error("{} is missing", .0.display())]
    Missing(PathBuf),
    /// It says something else.
    #[error("{} is stale", .0.display())]
    Differs(PathBuf),
    /// Nothing makes it.
    #[error("{} belongs to no equation", .0.display())]
    LeftOver(PathBuf),
}

/// Why the pages cannot be made, read or written.
#[derive(Debug, thiserror::Error)]
pub enum BookError {
    /// A page cannot be made.
    #[error(transparent)]
    Page(#[from] PageError),
    /// A formula cannot be rendered.
    #[error("{subject}: {source}")]
    Formula {
        /// Whose.
        subject: String,
        /// Why.
        source: NoFormula,
    },
    /// A file cannot be read or written.
    #[error("{}: {source}; choose another folder", path.display())]
    File {
        /// Which.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// The table of contents has no place for the pages.
    #[error("{}: there is no line `{PART}`; add one where the pages of the equations are to be listed", path.display())]
    NoPart {
        /// The table of contents.
        path: PathBuf,
    },
}

fn file_error(path: &Path) -> impl FnOnce(io::Error) -> BookError {
    let path = path.to_path_buf();
    move |source| BookError::File { path, source }
}

pub(super) fn formula_error(subject: &str) -> impl FnOnce(NoFormula) -> BookError {
    let subject = subject.to_string();
    move |source| BookError::Formula { subject, source }
}

/// Where a number's page is, below the folder of the equations.
pub(super) fn place(id: EquationId) -> String {
    format!("{}/{}.md", id.paper().key(), id.number())
}

/// Where a function's page is.
pub(super) fn place_of_function(path: &str) -> String {
    format!("unnumbered/{}.md", path.replace("::", "/"))
}

impl Book {
    /// All pages; `progress` hears of each one before it is made.
    ///
    /// # Errors
    /// If a page cannot be made; none is known.
    pub fn of(catalogue: &Catalogue, mut progress: impl FnMut(&str)) -> Result<Self, BookError> {
        let mut files = BTreeMap::new();
        let mut contents = format!("{PART}\n\n- [By paper]({FOLDER}/README.md)\n");
        let mut chapter = |page: &Page, place: &str, up: &str, indent: &str| -> Result<(), BookError> {
            let text = page.markdown(up).map_err(formula_error(&page.subject))?;
            let title: String = page.title.chars().filter(|c| !"$\\{}[]".contains(*c)).collect();
            contents += &format!("{indent}- [{}: {title}]({FOLDER}/{place})\n", page.subject);
            files.insert(Path::new(FOLDER).join(place), text);
            Ok(())
        };
        for id in EquationId::all() {
            progress(&id.to_string());
            chapter(&Page::of_number(catalogue, id)?, &place(id), "../", "  ")?;
        }
        for entry in catalogue.unnumbered() {
            let path = path_of(entry);
            progress(&path);
            chapter(&Page::of_function(catalogue, entry)?, &place_of_function(&path), "../../", "  ")?;
        }
        contents += &format!("- [By symbol]({FOLDER}/symbols.md)\n- [Gains and ranges]({FOLDER}/gains.md)\n");
        files.insert(Path::new(FOLDER).join("README.md"), by_paper(catalogue)?);
        files.insert(Path::new(FOLDER).join("symbols.md"), by_symbol(catalogue)?);
        files.insert(Path::new(FOLDER).join("gains.md"), gains(catalogue)?);
        Ok(Book { files, contents })
    }

    /// How many files there are, the table of contents not counted.
    #[must_use]
    pub fn len(&self) -> usize {
        self.files.len()
    }
    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.files.is_empty()
    }

    /// What in the folder of the book is not as it should be; nothing if all is.
    ///
    /// # Errors
    /// If something cannot be read.
    pub fn stale(&self, docs: &Path) -> Result<Vec<Stale>, BookError> {
        let mut stale = Vec::new();
        for (place, text) in self.all(docs)? {
            let path = docs.join(place);
            match fs::read_to_string(&path) {
                Ok(found) if found == text => {}
                Ok(_) => stale.push(Stale::Differs(path)),
                Err(error) if error.kind() == io::ErrorKind::NotFound => stale.push(Stale::Missing(path)),
                Err(error) => return Err(file_error(&path)(error)),
            }
        }
        stale.extend(self.left_over(docs)?.into_iter().map(Stale::LeftOver));
        Ok(stale)
    }

    /// Writes all pages, and removes those of equations that are gone. The table of contents is brought up to date if the folder
    /// has one.
    ///
    /// # Errors
    /// If something cannot be written.
    pub fn write(&self, docs: &Path) -> Result<(), BookError> {
        let all = self.all(docs)?;
        for (place, text) in all {
            let path = docs.join(place);
            if fs::read_to_string(&path).is_ok_and(|found| found == text) {
                continue;
            }
            let folder = path.parent().unwrap_or(docs);
            fs::create_dir_all(folder).map_err(file_error(folder))?;
            fs::write(&path, text).map_err(file_error(&path))?;
        }
        for path in self.left_over(docs)? {
            fs::remove_file(&path).map_err(file_error(&path))?;
        }
        Ok(())
    }

    /// All files with the table of contents, if the folder has one.
    fn all(&self, docs: &Path) -> Result<Vec<(PathBuf, String)>, BookError> {
        let mut all: Vec<_> = self.files.iter().map(|(place, text)| (place.clone(), text.clone())).collect();
        let path = docs.join(SUMMARY);
        match fs::read_to_string(&path) {
            Ok(text) => {
                let summary = with_part(&text, &self.contents).ok_or(BookError::NoPart { path })?;
                all.push((PathBuf::from(SUMMARY), summary));
            }
            Err(error) if error.kind() == io::ErrorKind::NotFound => {}
            Err(error) => return Err(file_error(&path)(error)),
        }
        Ok(all)
    }

    /// Generated pages in the folder that no equation has any more. Files without the mark of this program are not touched.
    fn left_over(&self, docs: &Path) -> Result<Vec<PathBuf>, BookError> {
        let mut found = Vec::new();
        let mut folders = vec![docs.join(FOLDER)];
        while let Some(folder) = folders.pop() {
            let entries = match fs::read_dir(&folder) {
                Ok(entries) => entries,
                Err(error) if error.kind() == io::ErrorKind::NotFound => continue,
                Err(error) => return Err(file_error(&folder)(error)),
            };
            for entry in entries {
                let path = entry.map_err(file_error(&folder))?.path();
                let known = path.strip_prefix(docs).is_ok_and(|place| self.files.contains_key(place));
                if path.is_dir() {
                    folders.push(path);
                } else if !known && fs::read_to_string(&path).is_ok_and(|text| text.starts_with(GENERATED)) {
                    found.push(path);
                }
            }
        }
        found.sort();
        Ok(found)
    }
}

/// A table of contents with its generated part replaced; nothing if it has none.
fn with_part(summary: &str, contents: &str) -> Option<String> {
    let lines: Vec<&str> = summary.lines().collect();
    let start = lines.iter().position(|line| *line == PART)?;
    let rest = lines[start + 1..].iter().position(|line| line.starts_with("# ")).map(|after| start + 1 + after);
    let before = lines[..start].iter().map(|line| format!("{line}\n")).collect::<String>();
    let after = rest.map_or(String::new(), |rest| {
        let lines: String = lines[rest..].iter().map(|line| format!("{line}\n")).collect();
        format!("\n{lines}")
    });
    Some(format!("{before}{contents}{after}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_part_is_replaced_and_the_rest_left_alone() {
        let summary = "# Summary\n\n- [A](a.md)\n\n# Equations\n\n- [old](old.md)\n\n# Look up\n\n- [B](b.md)\n";
        let new = with_part(summary, "# Equations\n\n- [new](new.md)\n").unwrap();
        assert_eq!(new, summary.replace("old", "new"));
        assert_eq!(
            with_part("# Summary\n\n# Equations\n", "# Equations\n\n- x\n").unwrap(),
            "# Summary\n\n# Equations\n\n- x\n"
        );
        assert_eq!(with_part("# Summary\n", "x"), None);
    }
}
