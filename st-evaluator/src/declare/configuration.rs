//! `CONFIGURATION`: which programs run.

use std::time::Duration;

use tree_sitter::Node;

use super::{Analysis, PouKind, Program};
use crate::compile::literal::{integer, nanoseconds};
use crate::task::Task;
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
        let mut tasks: Vec<Task> = Vec::new();
        for name in field(node, "name") {
            self.check_name(name);
        }
        for item in children(node) {
            match item.kind() {
                "task_declaration" => {
                    let Some(name) = part(item, "name") else { continue };
                    self.check_name(name);
                    let task = self.task(name, item);
                    if find(&mut tasks, &task.name).is_some() {
                        self.error(name, "there are two tasks of this name");
                    }
                    tasks.push(task);
                }
                "program_assignment" => self.program(item, &mut tasks),
                _ => {}
            }
        }
        self.tasks.append(&mut tasks);
    }

    fn task(&mut self, name: Node<'t>, node: Node<'t>) -> Task {
        let (mut interval, mut priority) = (None, None);
        for parameter in children(node) {
            let (Some(name), Some(value)) = (part(parameter, "name"), part(parameter, "value")) else {
                continue;
            };
            let text = self.source.text(value);
            let read = match self.source.name(name).as_str() {
                "INTERVAL" => {
                    let time = nanoseconds(text).filter(|_| value.kind() == "time_literal");
                    interval = time.and_then(|time| u64::try_from(time).ok()).map(Duration::from_nanos);
                    interval.is_some()
                }
                "PRIORITY" => {
                    let number = integer(text).filter(|_| value.kind() == "integer_literal");
                    priority = number.and_then(|number| u32::try_from(number).ok());
                    priority.is_some()
                }
                "SINGLE" => true,
                other => {
                    let message = format!("a task has no `{other}`");
                    self.error(name, message);
                    true
                }
            };
            if !read {
                self.error(value, "a duration is wanted for `INTERVAL`, a number for `PRIORITY`");
            }
        }
        if priority.is_none() {
            self.error(node, "a task has a `PRIORITY`");
        }
        let name = self.source.text(name).to_owned();
        Task { name, interval, priority: priority.unwrap_or_default(), programs: Vec::new() }
    }

    fn program(&mut self, node: Node<'t>, tasks: &mut [Task]) {
        let (Some(name), Some(ty)) = (part(node, "name"), part(node, "program_type")) else { return };
        self.check_name(name);
        if let Some(task) = part(node, "task") {
            let text = self.source.text(task);
            match find(tasks, text) {
                Some(task) => task.programs.push(self.source.text(name).to_owned()),
                None => self.error(task, format!("there is no task `{text}`")),
            }
        }
        if let Some(arguments) = children(node).into_iter().find(|child| child.kind() == "argument_list") {
            self.error(arguments, "connections of a program are not supported");
        }
        let capitals = self.source.name(name);
        if self.programs.iter().any(|known| known.name.eq_ignore_ascii_case(&capitals)) {
            self.error(name, "there are two programs of this name");
        }
        if self.is_strict() && self.is_declared(&capitals) {
            self.error(name, format!("`{capitals}` is declared at the top, too"));
        }
        match self.pou(ty).filter(|&index| self.pous[index].kind == PouKind::Program) {
            Some(pou) => {
                self.programs.push(Program { name: self.source.text(name).to_owned(), pou });
            }
            None => self.error(ty, format!("there is no program `{}`", self.source.text(ty))),
        }
    }
}

fn find<'a>(tasks: &'a mut [Task], name: &str) -> Option<&'a mut Task> {
    tasks.iter_mut().find(|task| task.name.eq_ignore_ascii_case(name))
}
