//! Lists the mutants of the equations, for the command that runs them: see `docs/mutants.md`.

use etalon_kernels_gen::mutants::registered;
use serde_json::json;

/// One line of JSON an equation. Not a test; ignored so that it runs only when asked for.
#[test]
#[ignore = "lists the mutants, for the command that runs them"]
fn list() {
    println!();
    for equation in registered() {
        let mutants: Vec<_> = equation
            .mutants
            .iter()
            .map(|m| json!({ "operator": m.operator, "original": m.original, "mutated": m.mutated, "line": m.line, "column": m.column }))
            .collect();
        let path = format!("{}::{}", equation.module_path, equation.name);
        println!("{}", json!({ "equation": path, "file": equation.file, "mutants": mutants }));
    }
}
