//! What `etalon pages` and `etalon show` do, without building what runs scenes: `cargo run -p etalon-audit --example pages` writes the
//! book's pages of the equations, and with a name behind `--` shows that equation.

use etalon_audit::Catalogue;
use etalon_audit::page::{Book, Page};
use std::path::Path;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let catalogue = Catalogue::load()?;
    let Some(name) = std::env::args().nth(1) else {
        let docs = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../docs"));
        return Ok(Book::of(&catalogue, |_| ())?.write(docs)?);
    };
    for page in Page::of(&catalogue, &catalogue.find(&name)?)? {
        println!("{page}");
    }
    Ok(())
}
