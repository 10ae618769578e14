//! The controller as a Mermaid state diagram, for Markdown and doc comments.

use std::fmt::Write as _;

use super::diagram::edges;
use crate::controller::tables::Tables;

/// The controller as a `stateDiagram-v2`: a transition carries the text of its event, or `/` and the commands of
/// its super step.
#[must_use]
pub fn text(tables: &Tables) -> String {
    let mut out = String::from("stateDiagram-v2\n");
    // Writing to a string cannot fail.
    let _ = writeln!(out, "  [*] --> s{}", tables.initial);
    for edge in edges(tables) {
        let _ = writeln!(out, "  s{} --> s{} : {}", edge.source, edge.target, escaped(&edge.label));
    }
    out
}

/// Characters that would end a description or be read as markup become Mermaid's entity codes.
pub(super) fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '#' | ':' | ';' | '<' | '"' | '\\' | '%' | '{' | '}' => {
                let _ = write!(out, "#{};", c as u32);
            }
            '\n' => out.push(' '),
            _ => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::emit::diagram::tests::lamp;

    #[test]
    fn draws_events_and_super_steps() {
        let expected = "\
stateDiagram-v2
  [*] --> s0
  s0 --> s1 : a -> c.a()
  s1 --> s2 : / c -> lamp.on()
  s2 --> s2 : a -> c.a()
  s2 --> s3 : b -> c.b(#34;x#34;)
  s3 --> s0 : / no command
";
        assert_eq!(text(&lamp()), expected);
    }
}
