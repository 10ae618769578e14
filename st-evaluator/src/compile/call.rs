//! Calls of functions and function blocks, and their arguments.

use std::collections::BTreeSet;

use tree_sitter::Node;

use super::{Body, Located, Operand};
use crate::code::{Action, Argument, Call, CallBlock, Expr, Output};
use crate::declare::{PouKind, Section, Variable};
use crate::tree::{children, has_token, part};
use crate::types::{Type, TypeId};

/// `name := value`, `name => variable`, or a value alone.
pub(super) struct Given<'t> {
    pub(super) name: Option<Node<'t>>,
    pub(super) value: Node<'t>,
    pub(super) output: bool,
}

/// Inputs with their offsets in the called one, and outputs.
type Arguments = (Vec<(u32, Argument)>, Vec<Output>);

/// The arguments of a call in order.
pub(super) fn given(node: Node<'_>) -> Vec<Given<'_>> {
    let Some(list) = part(node, "arguments") else { return Vec::new() };
    children(list)
        .into_iter()
        .filter_map(|argument| {
            if argument.kind() != "named_argument" {
                return Some(Given { name: None, value: argument, output: false });
            }
            let output = has_token(argument, "=>");
            Some(Given { name: part(argument, "name"), value: part(argument, "value")?, output })
        })
        .collect()
}

impl<'t> Body<'_, 't> {
    /// A call within an expression.
    pub(super) fn call_operand(&mut self, node: Node<'t>, hint: Option<TypeId>) -> Option<Operand> {
        let function = part(node, "function")?;
        if function.kind() != "identifier" {
            self.error(function, "only functions are called in an expression");
            return None;
        }
        if self.trusted && self.unit.source.name(function) == "__CLOCK" {
            let ty = self.elementary(crate::kind::Kind::Time);
            return Some(Operand::Scalar { ty, expr: Expr::Clock, value: None });
        }
        match self.unit.pou(function) {
            Some(index) if self.unit.pous[index].kind == PouKind::Function => {
                let call = self.function(node, function, index)?;
                let Some((ty, _)) = self.unit.pous[index].result else {
                    self.error(function, "the function has no result");
                    return None;
                };
                Some(Operand::Scalar { ty, expr: Expr::Call(Box::new(call)), value: None })
            }
            Some(_) => {
                self.error(function, "an instance is called, not the function block");
                None
            }
            None => self.standard_function(node, function, hint),
        }
    }

    fn function(&mut self, node: Node<'t>, function: Node<'t>, index: usize) -> Option<Call> {
        self.calls.insert(index);
        if index == self.index {
            self.error(function, "the function calls itself");
            return None;
        }
        if self.kind.is_none() {
            self.error(function, "is no constant");
            return None;
        }
        let (inputs, outputs) = self.arguments(node, index)?;
        Some(Call { pou: index, inputs, outputs })
    }

    /// A call that stands alone.
    pub(super) fn call_statement(&mut self, node: Node<'t>) -> Option<Action> {
        let callee = part(node, "function")?;
        let is_local = self.scope.get(&self.unit.source.name(callee)).is_some();
        let is_global = callee.kind() == "identifier" && !is_local;
        if let Some(index) = is_global.then(|| self.unit.pou(callee)).flatten() {
            if self.unit.pous[index].kind != PouKind::Function {
                self.error(callee, "an instance is called, not the function block");
                return None;
            }
            if self.is_strict() {
                self.error(callee, "a function is called in an expression");
                return None;
            }
            let call = self.function(node, callee, index)?;
            return Some(Action::Discard(Expr::Call(Box::new(call))));
        }
        let instance = self.place(callee)?;
        let Type::Block { pou, .. } = *self.unit.types.get(instance.ty) else {
            let name = self.unit.types.name(instance.ty);
            self.error(callee, format!("`{name}` cannot be called"));
            return None;
        };
        let (inputs, outputs) = self.arguments(node, pou)?;
        Some(Action::CallBlock(Box::new(CallBlock { instance: instance.place, pou, inputs, outputs })))
    }

    fn arguments(&mut self, node: Node<'t>, callee: usize) -> Option<Arguments> {
        let parameters: Vec<Variable> = self.unit.pous[callee].scope.variables.clone();
        let given = given(node);
        let mut inputs = Vec::new();
        let mut outputs = Vec::new();
        let mut seen: BTreeSet<String> = BTreeSet::new();
        let is_input = |v: &&Variable| matches!(v.section, Section::Input | Section::InOut);
        let positional: Vec<&Variable> = parameters.iter().filter(is_input).collect();
        let formal = given.iter().any(|argument| argument.name.is_some());
        if formal && given.iter().any(|argument| argument.name.is_none()) {
            self.error(node, "arguments with and without names");
            return None;
        }
        if !formal && !given.is_empty() && given.len() != positional.len() {
            self.error(node, format!("{} arguments, {} are wanted", given.len(), positional.len()));
            return None;
        }
        let mut complete = true;
        for (index, argument) in given.iter().enumerate() {
            let parameter = match argument.name {
                Some(name) => self.parameter(name, argument.output, &parameters),
                None => Some(positional[index]),
            };
            let Some(parameter) = parameter else {
                complete = false;
                continue;
            };
            if !seen.insert(parameter.name.to_ascii_uppercase()) {
                self.error(argument.value, format!("`{}` is given twice", parameter.name));
            }
            let offset = parameter.offset();
            if argument.output {
                match self.output(argument.value, parameter) {
                    Some(output) => outputs.push(output),
                    None => complete = false,
                }
            } else {
                match self.input(argument.value, parameter) {
                    Some(input) => inputs.push((offset, input)),
                    None => complete = false,
                }
            }
        }
        for parameter in positional.iter().filter(|p| p.section == Section::InOut) {
            if !seen.contains(&parameter.name.to_ascii_uppercase()) {
                self.error(node, format!("`{}` must be given", parameter.name));
                complete = false;
            }
        }
        complete.then_some((inputs, outputs))
    }

    fn parameter<'p>(&mut self, name: Node<'t>, output: bool, all: &'p [Variable]) -> Option<&'p Variable> {
        let capitals = self.unit.source.name(name);
        let found = all.iter().find(|v| {
            let section = match v.section {
                Section::Output => output,
                Section::Input | Section::InOut => !output,
                _ => false,
            };
            section && v.name.eq_ignore_ascii_case(&capitals)
        });
        if found.is_none() {
            let sort = if output { "output" } else { "input" };
            self.error(name, format!("there is no {sort} `{capitals}`"));
        }
        found
    }

    fn input(&mut self, node: Node<'t>, parameter: &Variable) -> Option<Argument> {
        let ty = parameter.ty;
        if parameter.section == Section::InOut {
            return self.reference(node, parameter);
        }
        match *self.unit.types.get(ty) {
            Type::Text { capacity } => Some(Argument::Text(self.text(node)?, capacity)),
            _ if self.unit.types.is_scalar(ty) => Some(Argument::Scalar(self.scalar(node, ty)?.0)),
            _ => {
                let located = self.place(node)?;
                self.require_same(node, located.ty, ty)?;
                Some(Argument::Copy(located.place, self.unit.types.size(ty)))
            }
        }
    }

    fn reference(&mut self, node: Node<'t>, parameter: &Variable) -> Option<Argument> {
        let located = if parameter.constant { self.place(node)? } else { self.target(node)? };
        let (from, to) = (located.ty, parameter.ty);
        let scalar =
            self.unit.types.is_scalar(from) || matches!(self.unit.types.get(from), Type::Text { .. });
        if !(scalar && from == to) {
            self.require_same(node, from, to)?;
        }
        Some(Argument::Reference(located.place))
    }

    fn output(&mut self, node: Node<'t>, parameter: &Variable) -> Option<Output> {
        let Located { ty, place, .. } = self.target(node)?;
        if ty != parameter.ty {
            self.require_same(node, parameter.ty, ty)?;
        }
        Some(Output { from: parameter.offset(), to: place, size: self.unit.types.size(ty) })
    }

    /// For what is copied as a whole.
    pub(super) fn require_same(&mut self, node: Node<'t>, from: TypeId, to: TypeId) -> Option<()> {
        if self.is_same(from, to) {
            return Some(());
        }
        let (a, b) = (self.unit.types.name(from), self.unit.types.name(to));
        let message = if self.unit.types.same_shape(from, to) {
            format!("`{a}` and `{b}` are not the same type by name")
        } else {
            format!("`{a}` where `{b}` is wanted")
        };
        self.error(node, message);
        None
    }
}
