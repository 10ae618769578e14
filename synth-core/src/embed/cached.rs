//! What a macro expanded to before.

use crate::cache::{Key, Store};
use crate::diagnostic::Diagnostic;
use proc_macro2::TokenStream;

/// The module of this key, of this expansion or of an earlier one.
pub(super) fn cached(
    store: Option<&dyn Store>,
    key: impl FnOnce() -> Key,
    synthesize: impl FnOnce() -> Result<TokenStream, Vec<Diagnostic>>,
) -> Result<TokenStream, Vec<Diagnostic>> {
    let Some(store) = store else { return synthesize() };
    let key = key();
    if let Some(module) = store.get(&key).and_then(|texts| texts.first()?.parse().ok()) {
        return Ok(module);
    }
    let module = synthesize()?;
    store.put(&key, &[module.to_string()]);
    Ok(module)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cache::Recent;
    use crate::controller::Level;
    use crate::embed::{self, Choices, Expander, plant};
    use crate::emit::rust::Engine;
    use crate::testing::world;
    use proc_macro2::Span;
    use std::cell::Cell;

    /// Counts what is put into it: whatever is synthesised.
    #[derive(Default)]
    struct Counting {
        recent: Recent,
        put: Cell<usize>,
    }

    impl Store for Counting {
        fn get(&self, key: &Key) -> Option<Vec<String>> {
            self.recent.get(key)
        }

        fn put(&self, key: &Key, texts: &[String]) {
            self.put.set(self.put.get() + 1);
            self.recent.put(key, texts);
        }
    }

    fn tokens(text: &str) -> TokenStream {
        text.parse().expect("tokens")
    }

    const EDITOR: Expander = Expander::Editor;
    const AUTO: Choices = Choices { engine: Engine::Auto, level: Level::Exact, monitor: false };
    const RUNS: Choices = Choices { engine: Engine::Runs, ..AUTO };
    const ORDERED: Choices = Choices { level: Level::Ordered, ..AUTO };

    #[test]
    fn scenarios_in_place() {
        let store = Counting::default();
        let expand = |text: &str, choices, expander, import: &str| {
            let module =
                embed::inline(&tokens(text), choices, expander, Some(&store), &mut |_| Ok(import.into()));
            (module.to_string(), store.put.get())
        };
        let import =
            world("guarantee scenario Answers { user -> control.press() urgent control -> lamp.on() }");
        let text = "import \"world.sml\" specification Main { collaboration Main { \
                    /// The lamp stays on.\n guarantee scenario Stays { control -> lamp.on() } } }";
        let (first, synthesised) = expand(text, AUTO, EDITOR, &import);
        assert!(synthesised == 1 && first.contains("pub mod main"), "{first}");
        let again = expand(text, AUTO, EDITOR, &import);
        assert_eq!(again, (first.clone(), 1));
        let moved = expand(&format!("\n\n{}", text.replace("{ ", "{\n  ")), AUTO, EDITOR, &import);
        assert_eq!(moved, (first.clone(), 1), "blanks make no difference");

        for (count, (text, choices, expander, import)) in [
            (text.replace("stays", "remains"), AUTO, EDITOR, import.clone()),
            (text.replace("Stays", "Remains"), AUTO, EDITOR, import.clone()),
            (text.to_owned(), RUNS, EDITOR, import.clone()),
            (text.to_owned(), ORDERED, EDITOR, import.clone()),
            (text.to_owned(), AUTO, Expander::Compiler, import.clone()),
            (text.to_owned(), AUTO, EDITOR, import.replace("lamp.on", "lamp.off")),
        ]
        .into_iter()
        .enumerate()
        {
            assert_eq!(expand(&text, choices, expander, &import).1, count + 2);
        }
        let wrong = expand("specification Main { object a: Gone }", AUTO, EDITOR, &import);
        assert!(wrong.0.contains("compile_error") && wrong.1 == 7, "what is wrong is not kept");
    }

    #[test]
    fn scenarios_of_a_file() {
        let store = Counting::default();
        let expand = |bytes: &[u8]| {
            let read = &mut |_: &str| Err(String::new());
            let span = Span::call_site();
            let module = embed::file("a.sml", bytes, span, AUTO, EDITOR, Some(&store), read);
            (module.to_string(), store.put.get())
        };
        let text =
            world("guarantee scenario Answers { user -> control.press() urgent control -> lamp.on() }");
        let (first, _) = expand(text.as_bytes());
        assert_eq!(expand(text.as_bytes()), (first.clone(), 1));
        // Requirements stand in other lines.
        let moved = expand(format!("\n{text}").as_bytes());
        assert!(moved.0 != first && moved.1 == 2);

        let shown = format!("{text} // \u{FFFD}");
        assert_eq!(expand(shown.as_bytes()).1, 3);
        let unreadable = [format!("{text} // ").as_bytes(), &[0xFF]].concat();
        assert!(expand(&unreadable).0.contains("compile_error"), "what only looks the same is no hit");
    }

    #[test]
    fn plants() {
        let store = Counting::default();
        let text = "plant Clamp { output Air input Open, Shut \
                    /// Shuts the jaw.\n controllable close { set Air } uncontrollable shut \
                    automaton Jaw { initial state Wide [!Air && Open] { close -> Closes } \
                    state Closes [Air && !Shut] { shut -> Tight } state Tight [Air && Shut] } }";
        let inline = |text: &str, choice| {
            let module = plant::inline(&tokens(text), choice, EDITOR, Some(&store));
            (module.to_string(), store.put.get())
        };
        let choice = plant::Choice::default();
        let (first, synthesised) = inline(text, choice);
        assert!(synthesised == 1 && first.contains("pub mod clamp"), "{first}");
        assert_eq!(inline(&format!("\n{text}"), choice), (first, 1));
        assert_eq!(inline(&text.replace("Shuts", "Closes"), choice).1, 2);
        let options = crate::plant::Options { extract: true, ..choice.options };
        assert_eq!(inline(text, plant::Choice { options, ..choice }).1, 3);
        let following = plant::Choice { follows_events: true, ..choice };
        let (first, synthesised) = inline(text, following);
        assert_eq!((inline(&format!("\n{text}"), following), synthesised), ((first, 4), 4));

        let file = |text: &str| {
            let span = Span::call_site();
            let module = plant::file("a.plant", text.as_bytes(), span, choice, EDITOR, Some(&store));
            (module.to_string(), store.put.get())
        };
        let (first, synthesised) = file(text);
        assert_eq!((file(text), synthesised), ((first, 5), 5));
        assert_eq!(file(&format!("{text}\n")).1, 6);
    }
}
