//! What the compiler says to a user of `pendulum!`: every mistake with its message, and what has to compile.
//!
//! `TRYBUILD=overwrite cargo test --test ui` blesses the messages; read the difference before you commit it.

#[test]
fn every_mistake_has_its_message() {
    trybuild::TestCases::new().compile_fail("tests/ui/fail/*.rs");
}

#[test]
fn every_form_and_surrounding_compiles() {
    trybuild::TestCases::new().pass("tests/ui/pass/*.rs");
}
