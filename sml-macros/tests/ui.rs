//! The macro as a user meets it: what compiles, and what the compiler says where if it does not.
//!
//! `TRYBUILD=overwrite cargo test -p sml-macros` accepts what it says now.

use std::fs;
use std::path::Path;

/// Paths are relative to the package, which is one that `trybuild` makes: the specifications belong there.
fn bring_specifications() -> std::io::Result<()> {
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).parent().unwrap_or(Path::new("target"));
    let folder = target.join("tests/trybuild").join(env!("CARGO_PKG_NAME")).join("specs");
    fs::create_dir_all(&folder)?;
    for entry in fs::read_dir("tests/ui/specs")? {
        let entry = entry?;
        fs::copy(entry.path(), folder.join(entry.file_name()))?;
    }
    let wide: Vec<u8> = "specification Door { }\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
    fs::write(folder.join("utf16.sml"), [&[0xFF, 0xFE][..], &wide].concat())?;
    // No editor would leave it as it is.
    fs::write(folder.join("latin1.sml"), b"// T\xfcr\nspecification Door { }\n")
}

#[test]
fn ui() -> std::io::Result<()> {
    bring_specifications()?;
    let tests = trybuild::TestCases::new();
    tests.pass("tests/ui/pass_*.rs");
    tests.compile_fail("tests/ui/fail_*.rs");
    Ok(())
}
