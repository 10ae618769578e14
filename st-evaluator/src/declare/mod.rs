//! Declarations: what names mean, how much room they take, what they hold first.

mod configuration;
mod initial;
mod specifier;
mod variables;

use std::collections::BTreeMap;

use tree_sitter::Node;

use crate::code::{Place, Step};
use crate::compile;
use crate::error::{Error, Position};
use crate::reserved::Reserved;
use crate::task::Task;
use crate::tree::{Source, children, has_token, part, position};
use crate::types::{Type, TypeId, Types};

/// What a program organization unit is.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(crate) enum PouKind {
    Function,
    #[default]
    FunctionBlock,
    Program,
}

/// A function, function block or program.
#[derive(Clone, Debug, Default)]
pub(crate) struct Pou {
    /// As written.
    pub(crate) name: String,
    pub(crate) kind: PouKind,
    pub(crate) scope: Scope,
    /// What an instance holds first; nothing for a function.
    pub(crate) image: Vec<i64>,
    /// What a call's frame holds first.
    pub(crate) frame: Vec<i64>,
    /// Where a function leaves its result.
    pub(crate) result: Option<(TypeId, u32)>,
    /// The type of its instances; none for a function.
    pub(crate) ty: Option<TypeId>,
    pub(crate) code: Vec<Step>,
    /// Whether its statements count.
    pub(crate) counted: bool,
}

/// The names of a program organization unit.
#[derive(Clone, Debug, Default)]
pub(crate) struct Scope {
    pub(crate) variables: Vec<Variable>,
    /// By name, in capitals.
    pub(crate) by_name: BTreeMap<String, usize>,
}

impl Scope {
    pub(crate) fn get(&self, capitals: &str) -> Option<&Variable> {
        self.by_name.get(capitals).map(|&index| &self.variables[index])
    }
}

/// The kind of `VAR` that a variable stands in.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Section {
    Input,
    Output,
    InOut,
    Local,
    Temp,
    Global,
    External,
    Result,
}

#[derive(Clone, Debug)]
pub(crate) struct Variable {
    /// As written.
    pub(crate) name: String,
    pub(crate) section: Section,
    pub(crate) ty: TypeId,
    pub(crate) place: Place,
    pub(crate) constant: bool,
    pub(crate) retain: bool,
    /// Of a constant.
    pub(crate) value: Option<i64>,
    pub(crate) at: Position,
}

impl Variable {
    /// Its offset in an instance or a frame.
    pub(crate) fn offset(&self) -> u32 {
        match self.place {
            Place::This(at) | Place::Frame(at) | Place::ThroughThis(at) | Place::ThroughFrame(at) => at,
            _ => 0,
        }
    }
}

/// How far the declaration of a name is.
#[derive(Clone, Copy, Debug)]
enum State {
    Waiting,
    Active,
    Type(TypeId),
    Pou(usize),
    Broken,
}

#[derive(Debug)]
struct Declaration<'t> {
    node: Node<'t>,
    state: State,
}

/// A program of the configuration: its name and what it is an instance of.
#[derive(Clone, Debug)]
pub(crate) struct Program {
    pub(crate) name: String,
    pub(crate) pou: usize,
}

/// Everything that is known of a text.
#[derive(Debug)]
pub(crate) struct Analysis<'t> {
    pub(crate) source: &'t Source,
    pub(crate) errors: Vec<Error>,
    pub(crate) reserved: Reserved,
    pub(crate) types: Types,
    pub(crate) pous: Vec<Pou>,
    pub(crate) globals: BTreeMap<String, Variable>,
    /// Values of enumerations, by name, and what declares them.
    pub(crate) enumerators: BTreeMap<String, Vec<(TypeId, i64)>>,
    /// Cells that nothing writes.
    pub(crate) constants: Vec<i64>,
    pub(crate) global_cells: Vec<i64>,
    pub(crate) programs: Vec<Program>,
    pub(crate) tasks: Vec<Task>,
    declared: BTreeMap<String, Declaration<'t>>,
    /// Names in the order of the text.
    order: Vec<String>,
    bodies: Vec<(usize, Node<'t>)>,
}

impl<'t> Analysis<'t> {
    /// Reads everything below the root; what is wrong is in `errors`.
    pub(crate) fn of(source: &'t Source, root: Node<'t>) -> Analysis<'t> {
        let mut analysis = Analysis {
            source,
            errors: Vec::new(),
            reserved: Reserved::of(source.dialect),
            types: Types::default(),
            pous: Vec::new(),
            globals: BTreeMap::new(),
            enumerators: BTreeMap::new(),
            constants: Vec::new(),
            global_cells: Vec::new(),
            programs: Vec::new(),
            tasks: Vec::new(),
            declared: BTreeMap::new(),
            order: Vec::new(),
            bodies: Vec::new(),
        };
        let items = children(root);
        if has_token(root, ";") && analysis.is_strict() {
            analysis.error(root, "a semicolon between declarations");
        }
        analysis.collect(&items);
        for name in analysis.order.clone() {
            if analysis.declared[&name].node.kind() == "type_definition" {
                analysis.resolve(&name);
            }
        }
        analysis.global_variables(&items);
        for name in analysis.order.clone() {
            analysis.resolve(&name);
        }
        compile::bodies(&mut analysis);
        analysis.configurations(&items);
        analysis
    }

    pub(crate) fn error(&mut self, node: Node<'_>, message: impl Into<String>) {
        self.error_at(position(node), message);
    }

    pub(crate) fn error_at(&mut self, at: Position, message: impl Into<String>) {
        self.errors.push(Error { line: at.line, column: at.column, message: message.into() });
    }

    pub(crate) fn is_strict(&self) -> bool {
        self.source.dialect.is_strict()
    }

    pub(crate) fn take_bodies(&mut self) -> Vec<(usize, Node<'t>)> {
        std::mem::take(&mut self.bodies)
    }

    fn collect(&mut self, items: &[Node<'t>]) {
        for &item in items {
            match item.kind() {
                "type_declaration" => {
                    for definition in children(item) {
                        self.declare(definition);
                    }
                }
                "function_declaration" | "function_block_declaration" | "program_declaration" => {
                    self.declare(item);
                }
                "configuration_declaration" => {}
                "global_var_declaration_block" => {
                    if self.is_strict() {
                        self.error(item, "`VAR_GLOBAL` stands in a configuration or resource");
                    }
                }
                other => self.error(item, format!("`{other}` is not supported")),
            }
        }
    }

    fn declare(&mut self, node: Node<'t>) {
        let Some(name_node) = part(node, "name") else { return };
        self.check_name(name_node);
        let name = self.source.name(name_node);
        if self.declared.contains_key(&name) {
            if self.source.is_prelude(node) {
                // The text has a block of its own of this name, if the dialect lets it.
                return;
            }
            return self.error(name_node, format!("`{name}` is declared twice"));
        }
        self.order.push(name.clone());
        self.declared.insert(name, Declaration { node, state: State::Waiting });
    }

    /// Refuses what is no identifier of the dialect.
    pub(crate) fn check_name(&mut self, node: Node<'_>) {
        if self.source.is_prelude(node) {
            return;
        }
        let name = self.source.name(node);
        let dialect = self.source.dialect;
        let quoted = self.source.spelled.quoted.contains(&node.start_byte());
        if self.reserved.has(&name) && !quoted {
            self.error(node, format!("`{name}` is a reserved word"));
        }
        if name.contains("__") && dialect != crate::Dialect::Siemens {
            self.error(node, format!("`{name}` has two underscores in a row"));
        }
        if name.ends_with('_') && dialect.is_strict() {
            self.error(node, format!("`{name}` ends in an underscore"));
        }
        let limit = dialect.identifier_limit();
        if name.len() > limit {
            self.error(node, format!("`{name}` has more than {limit} characters"));
        }
    }

    /// What a global name is, used at `from`.
    fn lookup(&mut self, from: Node<'_>) -> Option<State> {
        let name = self.source.name(from);
        let declaration = self.declared.get(&name)?;
        let (node, state) = (declaration.node, declaration.state);
        // Inside its own declaration it is a circle, which `resolve` reports.
        let later = node.start_byte() > from.start_byte() && !self.source.is_prelude(node);
        if later && self.is_strict() {
            self.error(from, format!("`{name}` is declared only further down"));
        }
        if let State::Active = state {
            self.error(from, format!("`{name}` contains itself"));
            return Some(State::Broken);
        }
        self.resolve(&name);
        Some(self.declared[&name].state)
    }

    /// The function, function block or program of a name.
    pub(crate) fn pou(&mut self, from: Node<'_>) -> Option<usize> {
        match self.lookup(from)? {
            State::Pou(index) => Some(index),
            _ => None,
        }
    }

    /// Whether a name is one of a type, function, function block or program.
    pub(crate) fn is_declared(&self, capitals: &str) -> bool {
        self.declared.get(capitals).is_some_and(|d| !self.source.is_prelude(d.node))
    }

    /// The declared type of a name.
    pub(crate) fn named_type(&mut self, from: Node<'_>) -> Option<TypeId> {
        let name = self.source.text(from).to_owned();
        let ty = match self.lookup(from) {
            None => {
                self.error(from, format!("there is no type `{name}`"));
                return None;
            }
            Some(State::Type(ty)) => Some(ty),
            Some(State::Pou(index)) => self.pous[index].ty,
            Some(_) => return None,
        };
        if ty.is_none() {
            self.error(from, format!("`{name}` is a function and no type"));
        }
        ty
    }

    fn resolve(&mut self, name: &str) {
        let Declaration { node, state: State::Waiting } = self.declared[name] else { return };
        self.set_state(name, State::Active);
        let state = match node.kind() {
            "type_definition" => self.type_definition(node).map_or(State::Broken, State::Type),
            kind => {
                let kind = match kind {
                    "function_declaration" => PouKind::Function,
                    "program_declaration" => PouKind::Program,
                    _ => PouKind::FunctionBlock,
                };
                State::Pou(self.interface(node, kind))
            }
        };
        self.set_state(name, state);
    }

    fn set_state(&mut self, name: &str, state: State) {
        if let Some(declaration) = self.declared.get_mut(name) {
            declaration.state = state;
        }
    }

    /// Variables and result.
    fn interface(&mut self, node: Node<'t>, kind: PouKind) -> usize {
        let name = part(node, "name").map(|n| self.source.text(n).to_owned()).unwrap_or_default();
        let mut pou =
            Pou { name: name.clone(), kind, counted: !self.source.is_prelude(node), ..Pou::default() };
        for unsupported in ["ABSTRACT", "FINAL", "EXTENDS", "IMPLEMENTS"] {
            if has_token(node, unsupported) {
                self.error(node, format!("`{unsupported}` is not supported"));
            }
        }
        if kind == PouKind::Function {
            self.result(node, &mut pou);
        }
        for block in children(node) {
            self.variable_block(block, &mut pou);
        }
        let index = self.pous.len();
        if kind != PouKind::Function {
            let ty = Type::Block { name, pou: index };
            pou.ty = Some(self.types.add(ty, pou.image.clone()));
        }
        self.pous.push(pou);
        self.bodies.push((index, node));
        index
    }

    /// A variable of the function's name.
    fn result(&mut self, node: Node<'t>, pou: &mut Pou) {
        let (Some(name), Some(ty_node)) = (part(node, "name"), part(node, "return_type")) else { return };
        if self.source.dialect == crate::Dialect::Siemens && self.source.name(ty_node) == "VOID" {
            return;
        }
        let Some(ty) = self.specifier(ty_node, &pou.scope, None) else { return };
        if !self.types.is_scalar(ty) {
            return self.error(ty_node, "a function whose result is no single value is not supported");
        }
        let place = Place::Frame(pou.frame.len() as u32);
        pou.result = Some((ty, pou.frame.len() as u32));
        pou.frame.extend_from_slice(self.types.image(ty));
        let variable = Variable {
            name: pou.name.clone(),
            section: Section::Result,
            ty,
            place,
            constant: false,
            retain: false,
            value: None,
            at: position(name),
        };
        pou.scope.by_name.insert(pou.name.to_ascii_uppercase(), 0);
        pou.scope.variables.push(variable);
    }
}
