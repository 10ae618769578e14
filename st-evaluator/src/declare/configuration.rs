//! `CONFIGURATION`: which programs run.

use std::collections::BTreeSet;

use tree_sitter::Node;

use super::{Analysis, PouKind, Task};
use crate::tree::{children, field, part};

impl<'t> Analysis<'t> {
    /// Checks the names of all configurations and lists their programs.
    pub(super) fn configurations(&mut self, items: &[Node<'t>]) {
        for configuration in items.iter().filter(|item| item.kind() == "configuration_declaration") {
            if let Some(name) = part(*configuration, "name") {
                self.check_name(name);
            }
            for resource in children(*configuration) {
                if resource.kind() == "resource_declaration" {
                    self.resource(resource);
                }
            }
        }
    }

    fn resource(&mut self, node: Node<'t>) {
        let mut tasks = BTreeSet::new();
        for name in field(node, "name") {
            self.check_name(name);
        }
        for item in children(node) {
            match item.kind() {
                "task_declaration" => {
                    let Some(name) = part(item, "name") else { continue };
                    self.check_name(name);
                    if !tasks.insert(self.source.name(name)) {
                        self.error(name, "there are two tasks of this name");
                    }
                    self.task(item);
                }
                "program_assignment" => self.program(item, &tasks),
                _ => {}
            }
        }
    }

    fn task(&mut self, node: Node<'t>) {
        let mut has_priority = false;
        for parameter in children(node) {
            let (Some(name), Some(value)) = (part(parameter, "name"), part(parameter, "value")) else {
                continue;
            };
            let wanted = match self.source.name(name).as_str() {
                "INTERVAL" => "time_literal",
                "PRIORITY" => {
                    has_priority = true;
                    "integer_literal"
                }
                "SINGLE" => continue,
                other => {
                    let message = format!("a task has no `{other}`");
                    self.error(name, message);
                    continue;
                }
            };
            if value.kind() != wanted {
                self.error(value, format!("a `{wanted}` is wanted here"));
            }
        }
        if !has_priority {
            self.error(node, "a task has a `PRIORITY`");
        }
    }

    fn program(&mut self, node: Node<'t>, tasks: &BTreeSet<String>) {
        let (Some(name), Some(ty)) = (part(node, "name"), part(node, "program_type")) else { return };
        self.check_name(name);
        if let Some(task) = part(node, "task").filter(|task| !tasks.contains(&self.source.name(*task))) {
            self.error(task, format!("there is no task `{}`", self.source.text(task)));
        }
        if let Some(arguments) = children(node).into_iter().find(|child| child.kind() == "argument_list") {
            self.error(arguments, "connections of a program are not supported");
        }
        let capitals = self.source.name(name);
        if self.programs.iter().any(|known| known.program.eq_ignore_ascii_case(&capitals)) {
            self.error(name, "there are two programs of this name");
        }
        if self.is_strict() && self.is_declared(&capitals) {
            self.error(name, format!("`{capitals}` is declared at the top, too"));
        }
        match self.pou(ty).filter(|&index| self.pous[index].kind == PouKind::Program) {
            Some(pou) => {
                self.programs.push(Task { program: self.source.text(name).to_owned(), pou });
            }
            None => self.error(ty, format!("there is no program `{}`", self.source.text(ty))),
        }
    }
}
