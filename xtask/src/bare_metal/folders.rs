//! Where everything is.

use std::env;
use std::path::{Path, PathBuf};

/// The repository, and the folder of all that is fetched and built for bare metal.
pub(crate) struct Folders {
    /// The repository's root.
    pub(crate) repository: PathBuf,
    /// `bare-metal` in Cargo's target folder.
    home: PathBuf,
}

impl Folders {
    pub(crate) fn new() -> Self {
        let package = Path::new(env!("CARGO_MANIFEST_DIR"));
        let repository = package.parent().unwrap_or(package).to_owned();
        let built = env::var_os("CARGO_TARGET_DIR").map_or_else(|| "target".into(), PathBuf::from);
        // Cargo takes a relative one from the current folder, too.
        let built = if env::var_os("CARGO_TARGET_DIR").is_some() {
            env::current_dir().unwrap_or_default().join(built)
        } else {
            repository.join(built)
        };
        Folders { home: built.join("bare-metal"), repository }
    }

    /// The workspace of the programs.
    pub(crate) fn firmware(&self) -> PathBuf {
        self.repository.join("firmware")
    }

    /// Golden files.
    pub(crate) fn expected(&self) -> PathBuf {
        self.firmware().join("expected")
    }

    /// Packages on their way.
    pub(crate) fn packages(&self) -> PathBuf {
        self.home.join("packages")
    }

    /// What was unpacked: a `/usr` and a `/lib` of their own.
    pub(crate) fn root(&self) -> PathBuf {
        self.home.join("root")
    }

    /// The empty crate with which `core` is compiled.
    pub(crate) fn core(&self) -> PathBuf {
        self.home.join("core")
    }

    /// What belongs to an older compiler.
    pub(crate) fn older(&self, version: &str) -> PathBuf {
        self.home.join(format!("rust-{version}"))
    }

    /// What `cargo xtask compare` generates.
    pub(crate) fn compared(&self) -> PathBuf {
        self.home.join("compared")
    }

    /// The page with the comparison, its figures and its plots.
    pub(crate) fn docs(&self) -> PathBuf {
        self.repository.join("docs")
    }

    /// What `cargo xtask performance` measures.
    pub(crate) fn performance(&self) -> PathBuf {
        self.home.with_file_name("performance")
    }

    /// Release builds of this workspace.
    pub(crate) fn release(&self) -> PathBuf {
        self.home.with_file_name("release")
    }

    /// Cargo's target folder of the programs.
    pub(crate) fn build(&self) -> PathBuf {
        self.home.join("build")
    }
}
