//! `etalon show`: all that is known of an equation.

use super::arguments::ShowArguments;
use super::audit::catalogue;
use super::failure::Failure;
use etalon_audit::page::Page;
use serde_json::json;

/// The pages of an equation or of the functions of a name, for people or as JSON.
pub fn show(arguments: &ShowArguments) -> Result<String, Failure> {
    let catalogue = catalogue()?;
    let subject = catalogue.find(&arguments.subject).map_err(|unknown| Failure::BadInput(unknown.to_string()))?;
    let pages = Page::of(&catalogue, &subject).map_err(|error| Failure::Broken(error.to_string()))?;
    if arguments.json {
        let mut value = json!({ "schema": "etalon-show", "schema_version": 2 });
        super::extend(&mut value, &json!({ "pages": pages }))?;
        return super::to_text(&value);
    }
    Ok(pages.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"))
}
