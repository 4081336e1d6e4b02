//! `etalon pages`: the book's pages of the equations.

use super::Done;
use super::arguments::PagesArguments;
use super::audit::catalogue;
use super::failure::Failure;
use etalon_audit::page::{Book, BookError};

/// Writes the pages, or says which are stale.
pub fn pages(arguments: &PagesArguments) -> Result<Done, Failure> {
    let docs = &arguments.out;
    if !docs.is_dir() {
        let docs = docs.display();
        return Err(Failure::BadInput(format!("--out: there is no folder {docs}; make it, or give the book's `docs`")));
    }
    let failure = |error: BookError| match error {
        BookError::File { .. } | BookError::NoPart { .. } => Failure::BadInput(format!("--out: {error}")),
        _ => Failure::Broken(error.to_string()),
    };
    let book = Book::of(&catalogue()?, |_| ()).map_err(failure)?;
    if !arguments.check {
        book.write(docs).map_err(failure)?;
        return Ok(Done::passed(format!("{} pages in {}\n", book.len(), docs.join("equations").display())));
    }
    let stale = book.stale(docs).map_err(failure)?;
    if stale.is_empty() {
        return Ok(Done::passed(format!("{} pages are up to date\n", book.len())));
    }
    let mut text: String = stale.iter().map(|stale| format!("{stale}\n")).collect();
    text += "Write them anew with `etalon pages`.\n";
    Ok(Done { text, passed: false })
}
