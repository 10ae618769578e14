//! What a program is made of: sizes as `size` counts them, and the functions whose instructions are counted.

use crate::failure::{At, Result};
use object::{Object, ObjectSection, ObjectSymbol, SectionFlags, SectionKind, SymbolKind, elf};
use rustc_demangle::demangle;
use std::fmt;
use std::fs;
use std::path::Path;

/// Bytes of a program.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub(crate) struct Sizes {
    /// In flash alone: code and everything constant.
    pub(crate) text: u64,
    /// In RAM, with the initial values in flash.
    pub(crate) data: u64,
    /// In RAM, zero or nothing at the start.
    pub(crate) bss: u64,
}

impl fmt::Display for Sizes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Sizes { text, data, bss } = self;
        writeln!(f, "text {text:6}\ndata {data:6}\nbss  {bss:6}")
    }
}

/// A function of a program.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Function {
    /// Its path without the hash: `measured::cell::cycle`.
    pub(crate) name: String,
    pub(crate) address: u64,
    /// Bytes of code.
    pub(crate) size: u64,
}

/// Sizes and functions of the program at `path`.
pub(crate) fn read(path: &Path) -> Result<(Sizes, Vec<Function>)> {
    let bytes = fs::read(path).doing(format_args!("read `{}`", path.display()))?;
    let file = object::File::parse(bytes.as_slice()).doing(format_args!("read `{}`", path.display()))?;
    let mut sizes = Sizes::default();
    for section in file.sections() {
        let SectionFlags::Elf { sh_flags, .. } = section.flags() else { continue };
        if sh_flags.0 & elf::SHF_ALLOC.0 == 0 {
            continue;
        }
        // The rest of RAM, whatever is left.
        if section.name().is_ok_and(|name| [".stack", ".heap"].contains(&name)) {
            continue;
        }
        let part = match section.kind() {
            SectionKind::UninitializedData => &mut sizes.bss,
            _ if sh_flags.0 & elf::SHF_WRITE.0 == 0 => &mut sizes.text,
            // Nothing is loaded for what has no initial value, such as `.uninit` and the place of the stack.
            _ if section.file_range().is_none() => &mut sizes.bss,
            _ => &mut sizes.data,
        };
        *part += section.size();
    }
    let functions =
        file.symbols().filter(|symbol| symbol.kind() == SymbolKind::Text).map(|symbol| Function {
            name: format!("{:#}", demangle(symbol.name().unwrap_or_default())),
            // The lowest bit tells Thumb code.
            address: symbol.address() & !1,
            size: symbol.size(),
        });
    Ok((sizes, functions.collect()))
}
