//! Packages of Debian, unpacked into a folder of their own: nothing is installed, nothing removed, nobody needs to be
//! root unless the lists of packages are missing or old.

use crate::failure::{At, Failure, Result};
use crate::process;
use crate::progress::Progress;
use std::collections::BTreeSet;
use std::fs;
use std::io::{IsTerminal, stdout};
use std::path::Path;
use std::process::Command;

/// A file of a package, as apt names it: `name_version_architecture.deb`, the version's colon as `%3a`.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
struct Package {
    file: String,
    bytes: u64,
}

impl Package {
    fn name(&self) -> &str {
        self.file.split('_').next().unwrap_or_default()
    }

    /// What apt takes for exactly this one.
    fn exact(&self) -> String {
        let version = self.file.split('_').nth(1).unwrap_or_default().replace("%3a", ":");
        format!("{}={version}", self.name())
    }
}

/// Whether apt knows such a package; `name`s are those of [`unpack`].
pub(crate) fn knows(name: &str) -> Result<bool> {
    Ok(process::find("apt-cache").is_some() && version(name)?.is_some())
}

/// Unpacks `names`, and what they depend on that this system does not have, from `packages` into `root`. A name may
/// have the beginning of a version, `rustc-web=1.85.`; else the newest is taken. Says whether anything was unpacked; what is there in the right version is left alone.
pub(crate) fn unpack(names: &[&str], packages: &Path, root: &Path) -> Result<bool> {
    if ["apt-get", "apt-cache", "dpkg-deb"].into_iter().any(|tool| process::find(tool).is_none()) {
        let missing = names.join(", ");
        return Err(Failure::new(format!(
            "missing are {missing}, and this system has no packages of Debian"
        ))
        .help("add the target with `rustup target add`, and install QEMU and LLVM"));
    }
    let wanted = resolve(names)?;
    let list = root.join("unpacked");
    let old: BTreeSet<String> =
        fs::read_to_string(&list).unwrap_or_default().lines().map(str::to_owned).collect();
    let outdated = old.iter().any(|file| {
        let name = file.split('_').next();
        wanted.iter().any(|package| Some(package.name()) == name && package.file != *file)
    });
    if outdated {
        println!("newer packages: {} is made anew", root.display());
        fs::remove_dir_all(root).doing(format_args!("remove `{}`", root.display()))?;
    }
    let missing: Vec<Package> =
        wanted.into_iter().filter(|package| outdated || !old.contains(&package.file)).collect();
    if missing.is_empty() {
        return Ok(false);
    }
    fs::create_dir_all(packages).doing(format_args!("create `{}`", packages.display()))?;
    fs::create_dir_all(root).doing(format_args!("create `{}`", root.display()))?;
    let bytes: u64 = missing.iter().map(|package| package.bytes).sum();
    println!("fetching {} packages, {} MB", missing.len(), bytes.div_ceil(1_000_000));
    fetch(&missing, packages)?;
    let mut unpacked = if outdated { BTreeSet::new() } else { old };
    let progress = Progress::new();
    for (index, package) in missing.iter().enumerate() {
        progress.tell(&format!("unpacking {} ({} of {})", package.name(), index + 1, missing.len()));
        let file = packages.join(&package.file);
        process::text(Command::new("dpkg-deb").arg("--extract").arg(&file).arg(root))?;
        fs::remove_file(&file).doing(format_args!("remove `{}`", file.display()))?;
        unpacked.insert(package.file.clone());
    }
    let text: String = unpacked.iter().map(|file| format!("{file}\n")).collect();
    fs::write(&list, text).doing(format_args!("write `{}`", list.display()))?;
    Ok(true)
}

/// The packages of `names` in the newest version that apt knows, and what must be there for them.
fn resolve(names: &[&str]) -> Result<Vec<Package>> {
    let versions = || names.iter().map(|name| version(name)).collect::<Result<Vec<_>>>();
    let mut known = versions()?;
    if known.iter().any(Option::is_none) {
        update()?;
        known = versions()?;
    }
    let mut exact = Vec::new();
    for (name, version) in names.iter().zip(&known) {
        let version = version.as_deref().ok_or_else(|| {
            Failure::new(format!("apt knows no package `{name}`"))
                .help("add a source of packages that has it, as Debian's main and security archives do")
        })?;
        exact.push(format!("{}={version}", name.split('=').next().unwrap_or_default()));
    }
    // Only asks: recommended packages are not needed, installed ones are fetched all the same.
    let mut ask = apt("apt-get");
    ask.args(["--yes", "--print-uris", "--no-install-recommends", "--reinstall", "install"]).args(exact);
    Ok(files(&process::text(&mut ask)?))
}

/// The version of a package that is taken.
fn version(name: &str) -> Result<Option<String>> {
    Ok(match name.split_once('=') {
        None => candidate(&process::text(apt("apt-cache").arg("policy").arg(name))?),
        Some((name, beginning)) => {
            beginning_with(&process::text(apt("apt-cache").arg("madison").arg(name))?, beginning)
        }
    })
}

fn update() -> Result<()> {
    println!("fetching the lists of packages");
    match process::text(apt("apt-get").args(["-qq", "update"])) {
        Ok(_) => Ok(()),
        Err(failure) => Err(failure.help("run `apt-get update` as root, then this again")),
    }
}

/// Downloads what is not there in full; apt compares the checksums.
fn fetch(packages: &[Package], folder: &Path) -> Result<()> {
    let missing: Vec<&Package> = packages
        .iter()
        .filter(|package| {
            fs::metadata(folder.join(&package.file)).map_or(0, |file| file.len()) != package.bytes
        })
        .collect();
    if missing.is_empty() {
        return Ok(());
    }
    let download = || {
        let mut download = apt("apt-get");
        // As it is in a folder of ours, another user could not write there.
        download.current_dir(folder).args(["-o", "APT::Sandbox::User=root", "download"]);
        download.args(missing.iter().map(|package| package.exact()));
        if stdout().is_terminal() {
            let status = download.status().doing("run `apt-get`")?;
            return if status.success() { Ok(()) } else { Err(Failure::new("`apt-get download` failed")) };
        }
        process::text(download.arg("-qq")).map(drop)
    };
    // Old lists name files that archives have no more.
    download().or_else(|_| {
        update()?;
        download()
    })
}

/// A program of apt that speaks English.
fn apt(program: &str) -> Command {
    let mut command = Command::new(program);
    command.env("LC_ALL", "C.UTF-8").env("DEBIAN_FRONTEND", "noninteractive");
    command
}

/// The candidate in what `apt-cache policy` says.
fn candidate(policy: &str) -> Option<String> {
    let version = policy.lines().find_map(|line| line.trim().strip_prefix("Candidate: "))?;
    (version != "(none)").then(|| version.to_owned())
}

/// The first version with a beginning in what `apt-cache madison` says: lines of `NAME | VERSION | SOURCE`.
fn beginning_with(madison: &str, beginning: &str) -> Option<String> {
    let mut versions = madison.lines().filter_map(|line| line.split('|').nth(1)).map(str::trim);
    versions.find(|version| version.starts_with(beginning)).map(str::to_owned)
}

/// The packages in what `apt-get --print-uris` says: lines of `'URI' FILE BYTES HASH`.
fn files(uris: &str) -> Vec<Package> {
    let package = |line: &str| {
        let mut words = line.strip_prefix('\'')?.split(' ').skip(1);
        Some(Package { file: words.next()?.to_owned(), bytes: words.next()?.parse().ok()? })
    };
    uris.lines().filter_map(package).collect()
}

#[cfg(test)]
mod tests {
    use super::{Package, beginning_with, candidate, files};

    #[test]
    fn a_version_may_be_asked_for() {
        let madison = " rustc | 1.96.0+d1-2 | http://archive a\n rustc | 1.85.0+d3-1 | http://archive b\n";
        assert_eq!(beginning_with(madison, "1.85.").as_deref(), Some("1.85.0+d3-1"));
        assert_eq!(beginning_with(madison, "1.8."), None);
        assert_eq!(beginning_with("", "1.85."), None);
    }

    #[test]
    fn the_candidate_is_the_version() {
        let policy =
            "qemu:\n  Installed: (none)\n  Candidate: 1:7.2+dfsg-7\n  Version table:\n     1:7.2 500\n";
        assert_eq!(candidate(policy).as_deref(), Some("1:7.2+dfsg-7"));
        assert_eq!(candidate("x:\n  Installed: 1\n  Candidate: (none)\n"), None);
        assert_eq!(candidate(""), None);
    }

    #[test]
    fn packages_are_the_lines_of_addresses() {
        let text = "Reading package lists...\nNeed to get 2 B\n\
            'http://archive/a_1%253a2_all.deb' a_1%3a2_all.deb 41 SHA256:00\n";
        let package = Package { file: "a_1%3a2_all.deb".to_owned(), bytes: 41 };
        assert_eq!(files(text), std::slice::from_ref(&package));
        assert_eq!((package.name(), package.exact().as_str()), ("a", "a=1:2"));
    }
}
