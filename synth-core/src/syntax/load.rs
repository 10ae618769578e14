//! A specification with everything that it imports.

use super::{FileId, Sources, Span, ast, decode, parse_text, print, shown};
use crate::diagnostic::{Code, Diagnostic};
use crate::fnv::Fnv;

/// All files of a specification.
#[derive(Debug, Default)]
pub struct Loaded {
    /// In order of import: an imported file before the one that imports it, the one that was asked for last.
    pub files: Vec<ast::File>,
    /// Paths and texts, for rendering.
    pub sources: Sources,
    /// Mistakes in any of them.
    pub diagnostics: Vec<Diagnostic>,
    /// Of every file but the main one, by [`FileId`]: the string that first imports it.
    imported_at: Vec<Span>,
}

/// Reads a file that was asked for by this path.
pub type Reader<'r> = &'r mut dyn FnMut(&str) -> Result<Vec<u8>, String>;

/// Loads a specification from the bytes of its main file. Imported files, relative to the importing one, are asked
/// of `read`, which gives the bytes or says why not.
#[must_use]
pub fn load(path: &str, bytes: &[u8], read: Reader<'_>) -> Loaded {
    let mut loader = Loader { loaded: Loaded::default(), read, circle: Vec::new(), done: Vec::new() };
    loader.file(path, bytes);
    loader.loaded
}

/// Loads what the tokens of a macro import; `path` stands for the file that invokes it.
#[must_use]
pub fn load_imports(path: &str, main: ast::File, read: Reader<'_>) -> Loaded {
    let mut loader = Loader { loaded: Loaded::default(), read, circle: Vec::new(), done: Vec::new() };
    loader.loaded.sources.add(path, "");
    loader.circle.push(normalize(path));
    loader.imports(path, &main);
    loader.loaded.files.push(main);
    loader.loaded
}

struct Loader<'r> {
    loaded: Loaded,
    read: Reader<'r>,
    /// The files that are being loaded, each imported by the one before.
    circle: Vec<String>,
    done: Vec<String>,
}

impl Loader<'_> {
    fn file(&mut self, path: &str, bytes: &[u8]) {
        let id = self.loaded.sources.add(path, shown(bytes));
        let text = match decode(bytes, id) {
            Ok(text) => text,
            Err(diagnostic) => return self.loaded.diagnostics.push(*diagnostic),
        };
        let (file, diagnostics) = parse_text(text, id);
        self.loaded.diagnostics.extend(diagnostics);
        let Some(file) = file else { return };
        self.circle.push(normalize(path));
        self.imports(path, &file);
        self.done.extend(self.circle.pop());
        self.loaded.files.push(file);
    }

    fn imports(&mut self, importer: &str, file: &ast::File) {
        for import in &file.imports {
            let path = join(importer, &import.path);
            let normal = normalize(&path);
            if self.done.contains(&normal) {
                continue;
            }
            if self.circle.contains(&normal) {
                let message = format!("`{}` imports itself, directly or through others", import.path);
                let help = "remove this import; every file is merged once anyway";
                self.error(Code::CyclicImport, import.span, message, help);
                continue;
            }
            match (self.read)(&path) {
                Ok(bytes) => {
                    self.loaded.imported_at.push(import.span);
                    self.file(&path, &bytes);
                }
                Err(why) => {
                    let message = format!("`{path}` cannot be read: {why}");
                    let help = "paths are relative to the file that imports";
                    self.error(Code::MissingImport, import.span, message, help);
                    // One message for each missing file is enough.
                    self.done.push(normal);
                }
            }
        }
    }

    fn error(&mut self, code: Code, span: Span, message: String, help: &str) {
        self.loaded.diagnostics.push(Diagnostic::error(code, span, message).help(help));
    }
}

fn join(importer: &str, import: &str) -> String {
    if import.starts_with('/') {
        return import.to_owned();
    }
    match importer.rsplit_once('/') {
        Some((folder, _)) => format!("{folder}/{import}"),
        None => import.to_owned(),
    }
}

/// The same file by the same name, as far as that can be told without looking at the disk.
fn normalize(path: &str) -> String {
    let mut parts: Vec<&str> = Vec::new();
    for part in path.split('/') {
        match part {
            "." => {}
            ".." if parts.last().is_some_and(|last| !last.is_empty() && *last != "..") => {
                parts.pop();
            }
            part => parts.push(part),
        }
    }
    parts.join("/")
}

impl Loaded {
    /// The main file's id.
    pub const MAIN: FileId = FileId(0);

    /// Whether everything that declares a name was read, in all files.
    #[must_use]
    pub fn declares_all(&self) -> bool {
        let imported = |d: &Diagnostic| !matches!(d.code, Code::MissingImport | Code::CyclicImport);
        !self.files.is_empty()
            && self.files.len() == self.sources.len()
            && self.files.iter().all(|file| file.declares_all)
            && self.diagnostics.iter().all(imported)
    }

    /// The string in the main file that leads to `file`, directly or through others; `None` for the main file.
    #[must_use]
    pub fn import_of(&self, file: FileId) -> Option<Span> {
        let at = |file: FileId| self.imported_at.get((file.0 as usize).checked_sub(1)?).copied();
        let mut import = at(file)?;
        while let Some(outer) = at(import.file) {
            import = outer;
        }
        Some(import)
    }

    /// FNV-1a of all texts in the order of their files, as 16 hex digits. Macro tokens have no text; their canonical
    /// form stands for it.
    #[must_use]
    pub fn hash(&self) -> String {
        let mut hash = Fnv::new();
        for file in 0..self.sources.len() as u32 {
            hash.text(self.sources.text(FileId(file)));
        }
        if self.sources.text(Self::MAIN).is_empty() {
            self.files.last().into_iter().for_each(|main| hash.text(&print(main)));
        }
        hash.hex()
    }
}

#[cfg(test)]
mod tests {
    use super::{load, normalize};
    use crate::diagnostic::Code;
    use crate::syntax::FileId;

    /// `files`: path and text; the first one is asked for.
    #[track_caller]
    fn check(files: &[(&str, &str)], names: &[&str], codes: &[(Code, u32, u32)]) {
        let loaded = load(files[0].0, files[0].1.as_bytes(), &mut |path| {
            let found = files.iter().find(|(p, _)| normalize(p) == normalize(path));
            found.map(|(_, text)| text.as_bytes().to_vec()).ok_or_else(|| "not found".to_owned())
        });
        let order: Vec<&str> = loaded.files.iter().map(|file| file.name.text.as_str()).collect();
        assert_eq!(order, names);
        let found: Vec<(Code, u32, u32)> =
            loaded.diagnostics.iter().map(|d| (d.code, d.span.file.0, d.span.start.column)).collect();
        assert_eq!(found, codes);
    }

    #[test]
    fn imported_first_and_once() {
        let main = ("d/a.sml", "import \"b.sml\" import \"./c.sml\" specification A { }");
        let b = ("d/b.sml", "import \"../d/c.sml\" specification B { }");
        check(&[main, b, ("d/c.sml", "specification C { }")], &["C", "B", "A"], &[]);
    }

    #[test]
    fn circle_at_the_string_that_closes_it() {
        let a = ("a.sml", "import \"b.sml\" specification A { }");
        let b = ("b.sml", "import \"a.sml\" specification B { }");
        check(&[a, b], &["B", "A"], &[(Code::CyclicImport, 1, 8)]);
    }

    #[test]
    fn the_import_that_leads_to_a_file() {
        let loaded = load("a.sml", b"import \"b.sml\" import \"d.sml\" specification A { }", &mut |path| {
            let imports = if path == "b.sml" { "import \"c.sml\" " } else { "" };
            Ok(format!("{imports}specification B {{ }}").into_bytes())
        });
        let columns = (0..5).map(|file| loaded.import_of(FileId(file)).map(|span| span.start.column));
        assert_eq!(columns.collect::<Vec<_>>(), [None, Some(8), Some(8), Some(23), None]);
    }

    #[test]
    fn missing_at_the_string() {
        check(&[("a.sml", "import \"b.sml\" specification A { }")], &["A"], &[(Code::MissingImport, 0, 8)]);
    }
}
