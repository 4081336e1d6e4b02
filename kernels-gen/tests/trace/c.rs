//! C99: the second target of the same graphs, compiled and compared bit for bit with the interpreter.

use crate::programs::{INPUTS, drawn, inputs, program};
use crate::toys::Momentum;
use etalon_kernels_gen::emit::{EmitError, Header, MulAdd, c};
use etalon_kernels_gen::trace::{Double, Drawing, Significand, Single, interpret};
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::TestRunner;
use std::fmt::Write;
use std::path::PathBuf;
use std::process::Command;

const HEAD: Header =
    Header { command: "etalon emit toy --target c", definition: "kernels-gen/tests/trace/programs.rs" };

/// Compiles C99 without contraction and runs it. `None`, said aloud, where there is no compiler.
fn run(name: &str, text: &str) -> Option<String> {
    let compiler = std::env::var("CC").unwrap_or_else(|_| "cc".to_string());
    if Command::new(&compiler).arg("--version").output().is_err() {
        eprintln!("SKIPPED: no C compiler `{compiler}`; the C printer was not tried on {name}");
        return None;
    }
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR"));
    let (source, program) = (folder.join(format!("{name}.c")), folder.join(name));
    std::fs::write(&source, text).unwrap();
    let flags =
        ["-std=c99", "-O2", "-ffp-contract=off", "-Wall", "-Wextra", "-Wno-unknown-pragmas", "-Wno-unused-function"];
    let compiled =
        Command::new(&compiler).args(flags).arg("-Werror").arg(&source).arg("-o").arg(&program).arg("-lm").output();
    let compiled = compiled.unwrap();
    assert!(compiled.status.success(), "{}\n{}", String::from_utf8_lossy(&compiled.stderr), source.display());
    let output = Command::new(&program).output().unwrap();
    assert!(output.status.success(), "{name} ended with {}", output.status);
    Some(String::from_utf8(output.stdout).unwrap())
}

/// A number type of both languages.
trait Number: etalon_kernels_gen::Real<Mask = bool> + Into<f64> {
    type Marker: Significand;
    const C_NAME: &'static str;
    fn from_f64(value: f64) -> Self;
    fn hex(self) -> String;
    fn is_nan(self) -> bool {
        let value: f64 = self.into();
        value.is_nan()
    }
}
impl Number for f32 {
    type Marker = Single;
    const C_NAME: &'static str = "float";
    fn from_f64(value: f64) -> Self {
        value as f32
    }
    fn hex(self) -> String {
        format!("{:08x}", self.to_bits())
    }
}
impl Number for f64 {
    type Marker = Double;
    const C_NAME: &'static str = "double";
    fn from_f64(value: f64) -> Self {
        value
    }
    fn hex(self) -> String {
        format!("{:016x}", self.to_bits())
    }
}

/// Many random programs in one file, each on a few inputs; every bit of every result must agree, the sign of zero included.
fn programs_agree<N: Number>() {
    const PROGRAMS: usize = 150;
    const CALLS: usize = 12;
    let mut runner = TestRunner::deterministic();
    let mut functions = c::prelude().to_string();
    let (mut calls, mut table, mut data) = (String::new(), Vec::new(), Vec::new());
    let mut expected: Vec<Vec<N>> = Vec::new();
    while expected.len() < PROGRAMS * CALLS {
        let drawing = drawn::<N::Marker>(&program().new_tree(&mut runner).unwrap().current()).simplified();
        let number = expected.len() / CALLS;
        match c::function(&format!("program_{number}"), &drawing, &HEAD, MulAdd::TwoRoundings) {
            Ok(text) => functions += &text,
            Err(EmitError::NotFinite { .. }) => continue,
            Err(error) => panic!("{error}"),
        }
        let values: Vec<String> = (0..INPUTS).map(|i| format!("v[{i}]")).collect();
        write!(calls, "static void call_{number}(const number *v) {{ struct program_{number}_in in = ").unwrap();
        writeln!(calls, "{{ {} }}; struct program_{number}_out out;", values.join(", ")).unwrap();
        writeln!(calls, "    program_{number}(&in, &out);").unwrap();
        writeln!(calls, "    const number list[] = {{ out.result_0, out.result_1, out.result_2 }};").unwrap();
        writeln!(calls, "    show(list); }}").unwrap();
        table.push(format!("call_{number}"));
        for _ in 0..CALLS {
            let values = inputs().new_tree(&mut runner).unwrap().current().map(N::from_f64);
            data.push(format!("{{ {} }}", values.map(|v| format!("{:?}", v.into())).join(", ")));
            expected.push(interpret(&drawing, &values).unwrap());
        }
    }
    let main = format!(
        "static const number inputs[][{INPUTS}] = {{\n{}\n}};\n\
         static void (*const programs[])(const number *) = {{ {} }};\n\
         int main(void) {{\n\
           for (int i = 0; i < {}; i++) programs[i / {CALLS}](inputs[i]);\n\
           return 0;\n\
         }}\n",
        data.join(",\n"),
        table.join(", "),
        data.len()
    );
    let show = format!(
        "#include <stdio.h>\n#include <string.h>\ntypedef {} number;\n\
         static void show(const number *values) {{\n\
           for (int i = 0; i < 3; i++) {{\n\
             unsigned long long bits = 0;\n\
             memcpy(&bits, &values[i], sizeof values[i]);\n\
             printf(\"%s%0*llx\", i ? \" \" : \"\", (int)(2 * sizeof values[i]), bits);\n\
           }}\n\
           printf(\"\\n\");\n\
         }}\n",
        N::C_NAME
    );
    let text = [functions, show, calls, main].concat();
    let Some(found) = run(&format!("programs_{}", N::C_NAME), &text) else { return };
    let found: Vec<&str> = found.lines().collect();
    assert_eq!(found.len(), expected.len());
    let mut finite = 0;
    for (line, (found, expected)) in found.iter().zip(&expected).enumerate() {
        for (found, expected) in found.split(' ').zip(expected) {
            // A NaN has many bit patterns; C's is checked to be one by its exponent and a fraction that is not zero.
            let bits = u64::from_str_radix(found, 16).unwrap();
            let found_nan = match N::C_NAME {
                "float" => f32::from_bits(bits as u32).is_nan(),
                _ => f64::from_bits(bits).is_nan(),
            };
            let agrees = if expected.is_nan() { found_nan } else { found == expected.hex() };
            assert!(
                agrees,
                "program {}, call {}: C gives {found}, the interpreter {}",
                line / CALLS,
                line % CALLS,
                expected.hex()
            );
            finite += usize::from(!expected.is_nan());
        }
    }
    assert!(finite > expected.len(), "only {finite} of {} results compared were numbers", 3 * expected.len());
}

#[test]
fn programs_agree_in_float() {
    programs_agree::<f32>();
}

#[test]
fn programs_agree_in_double() {
    programs_agree::<f64>();
}

/// A pass as a whole compiles; its values are covered by the programs above.
#[test]
fn a_pass_compiles() {
    let pass = Drawing::of_pass::<3, _, Double>(&Momentum { heats: true }).unwrap();
    let text = c::pass(&pass, &HEAD, MulAdd::Fused).unwrap();
    assert!(text.contains("struct momentum_pair_in {") && text.contains("void momentum_finish("), "{text}");
    run("momentum", &(text + "int main(void) { return 0; }\n"));
}
