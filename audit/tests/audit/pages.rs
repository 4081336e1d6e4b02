//! The pages of equations, and the book made of them.

use etalon_audit::Catalogue;
use etalon_audit::page::{Book, Call, Page, Stale};
use std::fs;

fn page(name: &str) -> Page {
    let catalogue = Catalogue::load().unwrap();
    Page::of(&catalogue, &catalogue.find(name).unwrap()).unwrap().remove(0)
}

#[test]
fn a_page_has_all_that_an_auditor_comes_for() {
    let text = page("gs25:13").to_string();
    let parts = [
        r"\phi_{ab} = \max\left[0, \min\left(1,",
        "ratio of the two particles' velocity slopes",
        "Reading",
        "Deviation",
        "pub fn slope_limiter<R: Real>(slope_a: R, slope_b: R) -> R {",
        r"\begin{aligned}",
        "fn slope_limiter(slope_a: f32, slope_b: f32) -> SlopeLimiterOut {",
        "5 compare, 3 select",
        "scalar f32",
        "reconstruction::limiter_is_that_of_van_leer",
        "caught",
    ];
    for part in parts {
        assert!(text.contains(part), "no {part} in\n{text}");
    }
}

#[test]
fn a_function_brings_the_entries_of_its_numbers() {
    let limiter = page("slope_limiter");
    assert_eq!(limiter.entries.iter().map(|entry| entry.id.as_str()).collect::<Vec<_>>(), limiter.functions[0].ids);
    assert!(page("mixed_sinc").entries.is_empty());
}

#[test]
fn what_no_function_encodes_says_why() {
    let catalogue = Catalogue::load().unwrap();
    let id = etalon_spec::EquationId::all().find(|id| catalogue.functions(*id).next().is_none()).unwrap();
    let page = Page::of_number(&catalogue, id).unwrap();
    let reason = page.entries[0].not_encoded.clone().unwrap();
    assert!(page.to_string().contains("Not encoded") && page.markdown("../").unwrap().contains(&reason));
}

#[test]
fn functions_in_several_dimensions_are_printed_in_one() {
    let page = page("gradients::gradient");
    let printed: Vec<_> = page.functions[0].calls.iter().filter(|call| call.wgsl.is_some()).collect();
    assert_eq!(printed.iter().map(|call| call.probe.as_str()).collect::<Vec<_>>(), ["gradients::gradient 2-D"]);
    let here = |call: &Call| call.figures.iter().filter(|record| record.adapter.is_none()).count();
    assert!(page.functions[0].calls.iter().all(|call| call.operations.f32 > 0 && here(call) == 4));
}

#[test]
fn stale_missing_and_left_over_pages_are_noticed() {
    let folder = std::env::temp_dir().join(format!("etalon-pages-{}", std::process::id()));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    let catalogue = Catalogue::load().unwrap();
    let book = Book::of(&catalogue, |_| ()).unwrap();
    assert_eq!(book.len(), 79 + catalogue.unnumbered().count() + 3);

    let missing = book.stale(&folder).unwrap();
    assert!(missing.len() == book.len() && missing.iter().all(|stale| matches!(stale, Stale::Missing(_))));
    fs::write(folder.join("SUMMARY.md"), "# Summary\n\n# Equations\n\n# Look up\n").unwrap();
    book.write(&folder).unwrap();
    assert_eq!(book.stale(&folder).unwrap(), []);
    let summary = fs::read_to_string(folder.join("SUMMARY.md")).unwrap();
    assert!(summary.contains("(equations/gs25/13.md)") && summary.ends_with("\n\n# Look up\n"), "{summary}");

    let place = |name: &str| folder.join("equations").join(name);
    let stale = place("gs25/13.md");
    fs::write(&stale, fs::read_to_string(&stale).unwrap().replace("idle", "busy")).unwrap();
    fs::remove_file(place("gs25/14.md")).unwrap();
    fs::copy(place("gs25/15.md"), place("gs25/99.md")).unwrap();
    fs::write(place("notes.md"), "# By hand\n").unwrap();
    let expected = [Stale::Differs(stale), Stale::Missing(place("gs25/14.md")), Stale::LeftOver(place("gs25/99.md"))];
    assert_eq!(book.stale(&folder).unwrap(), expected);
    book.write(&folder).unwrap();
    assert_eq!(book.stale(&folder).unwrap(), []);
    assert!(place("notes.md").exists() && !place("gs25/99.md").exists());

    fs::write(folder.join("SUMMARY.md"), "# Summary\n").unwrap();
    assert!(book.stale(&folder).unwrap_err().to_string().contains("# Equations"));
    fs::remove_dir_all(&folder).unwrap();
}
