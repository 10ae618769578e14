//! The syntax tree: the grammar's nodes with their texts.

use tree_sitter::{Node, Parser, Tree};

use crate::dialect::Dialect;
use crate::error::{Error, Position};
use crate::prelude;
use crate::spelling::{self, Spelled};

/// The text, as the grammar reads it, with the standard function blocks behind it.
#[derive(Debug)]
pub(crate) struct Source {
    pub(crate) dialect: Dialect,
    pub(crate) spelled: Spelled,
    /// Where the standard function blocks begin.
    prelude: usize,
}

impl Source {
    /// # Errors
    ///
    /// What the spelling or the grammar refuses.
    pub(crate) fn parse(text: &str, dialect: Dialect) -> Result<(Source, Tree), Vec<Error>> {
        // TIA Portal takes a byte order mark for what it is; to the standard it is a character like any other.
        let text = match dialect {
            Dialect::Siemens => text.strip_prefix('\u{feff}').unwrap_or(text),
            _ => text,
        };
        let mut spelled = spelling::spell(text, dialect);
        let prelude = spelled.text.len() + 1;
        spelled.text.push('\n');
        spelled.text.push_str(&prelude::text(dialect));
        let mut source = Source { dialect, spelled, prelude };
        let mut errors = std::mem::take(&mut source.spelled.errors);
        let failed = |message: String| vec![Error { line: 1, column: 1, message }];
        let mut parser = Parser::new();
        parser
            .set_language(&tree_sitter_iec61131_3_st::LANGUAGE.into())
            .map_err(|error| failed(error.to_string()))?;
        let tree = parser
            .parse(&source.spelled.text, None)
            .ok_or_else(|| failed("the grammar gave up".to_owned()))?;
        source.syntax_errors(tree.root_node(), &mut errors);
        if errors.is_empty() {
            return Ok((source, tree));
        }
        errors.sort();
        errors.dedup();
        Err(errors)
    }

    fn syntax_errors(&self, root: Node<'_>, errors: &mut Vec<Error>) {
        let mut pending = vec![root];
        while let Some(node) = pending.pop() {
            if !node.has_error() {
                continue;
            }
            let message = if node.is_missing() {
                format!("`{}` is missing", node.kind())
            } else if node.is_error() {
                let text = self.text(node);
                let shown: String = text.lines().next().unwrap_or_default().chars().take(40).collect();
                format!("cannot be read: `{shown}`")
            } else {
                let mut cursor = node.walk();
                pending.extend(node.children(&mut cursor));
                continue;
            };
            // A text that breaks off is noticed in what stands behind it.
            let offset = node.start_byte().min(self.prelude.saturating_sub(1));
            let Position { line, column } = spelling::position(&self.spelled.text, offset);
            errors.push(Error { line, column, message });
        }
    }

    pub(crate) fn text(&self, node: Node<'_>) -> &str {
        &self.spelled.text[node.byte_range()]
    }

    /// The text in capitals, as names are compared.
    pub(crate) fn name(&self, node: Node<'_>) -> String {
        self.text(node).to_ascii_uppercase()
    }

    /// Whether the node belongs to the standard function blocks.
    pub(crate) fn is_prelude(&self, node: Node<'_>) -> bool {
        node.start_byte() >= self.prelude
    }
}

pub(crate) fn position(node: Node<'_>) -> Position {
    let start = node.start_position();
    Position { line: start.row as u32 + 1, column: start.column as u32 + 1 }
}

fn is_aside(node: Node<'_>) -> bool {
    matches!(node.kind(), "comment" | "pragma")
}

/// The named children, without comments and pragmas.
pub(crate) fn children(node: Node<'_>) -> Vec<Node<'_>> {
    let mut cursor = node.walk();
    node.named_children(&mut cursor).filter(|child| !is_aside(*child)).collect()
}

/// The named children of a field, without comments and pragmas.
pub(crate) fn field<'t>(node: Node<'t>, name: &str) -> Vec<Node<'t>> {
    let mut cursor = node.walk();
    node.children_by_field_name(name, &mut cursor).filter(|c| c.is_named() && !is_aside(*c)).collect()
}

/// The one child of a field.
pub(crate) fn part<'t>(node: Node<'t>, name: &str) -> Option<Node<'t>> {
    field(node, name).into_iter().next()
}

/// Whether a child is this very token.
pub(crate) fn has_token(node: Node<'_>, token: &str) -> bool {
    let mut cursor = node.walk();
    node.children(&mut cursor).any(|child| child.kind() == token)
}
