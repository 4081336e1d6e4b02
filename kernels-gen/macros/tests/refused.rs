//! What the macro refuses, and with which words.
//!
//! These tests live here and not beside the others in `kernels-gen/tests`, because each run builds the tested crate's
//! development dependencies anew, and this crate has few.
#![forbid(unsafe_code)]

/// Each file in `refused` must fail to compile with exactly the messages beside it. After a change of wording,
/// `TRYBUILD=overwrite` writes them anew, to be read before they are kept.
#[test]
fn refusals_point_at_the_token_and_say_what_to_write() {
    let cases = trybuild::TestCases::new();
    cases.compile_fail("tests/refused/*.rs");
}
