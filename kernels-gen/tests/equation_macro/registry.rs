//! What the macro registers.

use crate::equations::mean;
use etalon_kernels_gen::registered;

#[test]
fn every_equation_is_registered_in_order() {
    let found: Vec<_> = registered().iter().map(|entry| (entry.ids.join(" "), entry.name)).collect();
    let expected = [
        ("c25:1", "decided_early"),
        ("c25:2", "every_let"),
        ("c25:3", "nested"),
        ("gs25:8", "balsara_limiter"),
        ("gs25:11 gs25:12", "pieces"),
        ("gs25:13", "sorted_out"),
        ("gs25:20", "mean"),
        ("pl20:1", "shifted"),
        ("", "rarely_squared"),
    ];
    // Equations of the library itself may come in between.
    let ours: Vec<_> = found.iter().filter(|(_, name)| expected.iter().any(|(_, ours)| ours == name)).collect();
    let ours: Vec<_> = ours.iter().map(|(ids, name)| (ids.as_str(), *name)).collect();
    assert_eq!(ours, expected);
}

#[test]
fn an_entry_is_the_equation_as_written() {
    let all = registered();
    let entry = all.iter().find(|entry| entry.name == "balsara_limiter").expect("registered");
    let written = include_str!("equations.rs");
    let without_attribute = written.replace("#[equation(\"gs25:8\")]\n", "");
    assert!(without_attribute.contains(entry.source), "not as written:\n{}", entry.source);
    assert!(entry.source.starts_with("/// The Balsara factor") && entry.source.ends_with('}'), "{}", entry.source);
    assert!(entry.source.contains("// a comment that the source text keeps"));
    assert!(entry.file.ends_with("equations.rs"), "{}", entry.file);
    assert!(entry.module_path.ends_with("::equations"), "{}", entry.module_path);
    let line = written.lines().position(|line| line.contains("#[equation(\"gs25:8\")]")).map(|i| i as u32 + 1);
    assert_eq!(Some(entry.line), line);
    assert_eq!(entry.unnumbered, None);

    // The one that is indented loses its indentation.
    let method = all.iter().find(|entry| entry.name == "shifted").expect("registered");
    assert!(method.source.starts_with("/// The shifted value"), "{}", method.source);
    assert!(method.source.contains("\n    if N < 2") && method.source.ends_with("\n}"), "{}", method.source);

    // One of the host alone is entered the same way, and is what it was.
    let host = all.iter().find(|entry| entry.name == "mean").expect("registered");
    assert!(without_attribute.replace("#[equation(\"gs25:20\", host)]\n", "").contains(host.source), "{}", host.source);
    assert_eq!((mean(&[]), mean(&[1.0, 2.0, 6.0])), (None, Some(3.0)));

    let unnumbered = all.iter().find(|entry| entry.name == "rarely_squared").expect("registered");
    assert_eq!((unnumbered.ids, unnumbered.unnumbered), (&[][..], Some("a test of rare branches")));
}
