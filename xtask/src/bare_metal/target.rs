//! The targets, and the machine that each runs on.

/// A target of Rust with an emulated machine.
#[derive(Debug)]
pub(crate) struct Target {
    /// As Rust names it.
    pub(crate) triple: &'static str,
    /// The emulator's program.
    pub(crate) emulator: &'static str,
    /// The package of Debian that has it.
    pub(crate) package: &'static str,
    /// The machine, as options of the emulator.
    pub(crate) machine: &'static [&'static str],
    /// What the linker is given.
    pub(crate) scripts: &'static [&'static str],
}

pub(crate) const ALL: [Target; 3] = [
    Target {
        triple: "thumbv7m-none-eabi",
        emulator: "qemu-system-arm",
        package: "qemu-system-arm",
        machine: &["-M", "lm3s6965evb"],
        scripts: &["-Tlink.x"],
    },
    Target {
        triple: "thumbv6m-none-eabi",
        emulator: "qemu-system-arm",
        package: "qemu-system-arm",
        machine: &["-M", "microbit"],
        scripts: &["-Tlink.x"],
    },
    Target {
        triple: "riscv32imac-unknown-none-elf",
        emulator: "qemu-system-riscv32",
        package: "qemu-system-misc",
        machine: &["-M", "virt", "-bios", "none"],
        scripts: &["-Tmemory.x", "-Tlink.x"],
    },
];

/// The target of a name.
pub(crate) fn by_name(name: &str) -> Result<&'static Target, String> {
    let known = || ALL.map(|target| target.triple).join(", ");
    ALL.iter().find(|target| target.triple == name).ok_or_else(|| format!("the targets are {}", known()))
}
