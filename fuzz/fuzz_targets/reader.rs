//! Any bytes as a specification: see `sml_tests::survive`.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| sml_tests::survive::check(bytes));
