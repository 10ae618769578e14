//! `VAR … END_VAR`.

use tree_sitter::Node;

use super::{Analysis, Pou, PouKind, Section, Variable};
use crate::Dialect;
use crate::code::Place;
use crate::tree::{children, field, part, position};
use crate::types::{Type, TypeId};

/// What stands behind `VAR`.
#[derive(Clone, Copy)]
struct Header {
    section: Section,
    constant: bool,
    retain: Option<bool>,
}

impl<'t> Analysis<'t> {
    /// Adds the variables of a block; other nodes are passed over.
    pub(super) fn variable_block(&mut self, node: Node<'t>, pou: &mut Pou) {
        let Some(header) = self.header(node) else { return };
        if header.section == Section::Global {
            return self.error(node, "`VAR_GLOBAL` does not stand in a function, function block or program");
        }
        self.check_header(node, header, pou.kind);
        for declaration in self.declarations(node) {
            self.declaration(declaration, header, pou);
        }
    }

    /// The variables of `VAR_GLOBAL` blocks, at the top or in configurations.
    pub(super) fn global_variables(&mut self, items: &[Node<'t>]) {
        let mut pending: Vec<Node<'t>> = items.iter().rev().copied().collect();
        while let Some(node) = pending.pop() {
            match node.kind() {
                "global_var_declaration_block" | "configuration_declaration" | "resource_declaration" => {
                    pending.extend(children(node).into_iter().rev());
                }
                "var_global" => self.global_block(node),
                _ => {}
            }
        }
    }

    fn global_block(&mut self, node: Node<'t>) {
        let Some(header) = self.header(node) else { return };
        for declaration in self.declarations(node) {
            let mut pou = Pou::default();
            self.declaration(declaration, header, &mut pou);
            for variable in pou.scope.variables {
                let name = variable.name.to_ascii_uppercase();
                if self.globals.contains_key(&name) || self.is_declared(&name) {
                    self.error_at(variable.at, format!("`{}` is declared twice", variable.name));
                }
                self.globals.insert(name, variable);
            }
        }
    }

    fn header(&mut self, node: Node<'t>) -> Option<Header> {
        let section = match node.kind() {
            "var_block" => Section::Local,
            "var_input" => Section::Input,
            "var_output" => Section::Output,
            "var_in_out" => Section::InOut,
            "var_temp" => Section::Temp,
            "var_global" => Section::Global,
            "var_external" => Section::External,
            "var_access" | "var_config" | "method_declaration" | "property_declaration" => {
                self.error(node, format!("`{}` is not supported", node.kind()));
                return None;
            }
            _ => return None,
        };
        let qualifiers: Vec<String> = children(node)
            .into_iter()
            .filter(|child| child.kind() == "var_qualifier_list")
            .flat_map(children)
            .map(|qualifier| self.source.name(qualifier))
            .collect();
        let has = |word: &str| qualifiers.iter().any(|q| q == word);
        let retain = has("RETAIN").then_some(true).or(has("NON_RETAIN").then_some(false));
        Some(Header { section, constant: has("CONSTANT"), retain })
    }

    /// What the sections of the standard exclude.
    fn check_header(&mut self, node: Node<'t>, header: Header, kind: PouKind) {
        let Header { section, constant, retain } = header;
        let retain = retain.is_some();
        let strict = self.is_strict();
        let refused = match (kind, section) {
            (PouKind::Function, Section::External) => Some("a function has no `VAR_EXTERNAL`"),
            (PouKind::Function, Section::Temp) if strict => Some("a function has no `VAR_TEMP`"),
            (PouKind::Function, _) if retain => Some("a function retains nothing"),
            (_, Section::Temp | Section::InOut | Section::External) if retain => {
                Some("these variables cannot be retained")
            }
            (_, Section::Input | Section::Output | Section::InOut | Section::Temp) if constant && strict => {
                Some("these variables cannot be constant")
            }
            _ if constant && retain && strict => Some("a constant is not retained"),
            _ => None,
        };
        if let Some(message) = refused.filter(|_| !self.source.is_prelude(node)) {
            self.error(node, message);
        }
    }

    fn declarations(&mut self, node: Node<'t>) -> Vec<Node<'t>> {
        let found: Vec<Node<'t>> =
            children(node).into_iter().filter(|child| child.kind() == "variable_declaration").collect();
        if found.is_empty() && self.is_strict() {
            self.error(node, "a block of variables without any");
        }
        found
    }

    fn declaration(&mut self, node: Node<'t>, header: Header, pou: &mut Pou) {
        let Some(ty_node) = part(node, "type") else { return };
        let Some(ty) = self.specifier(ty_node, &pou.scope, None) else { return };
        self.check_type(ty_node, ty, header, pou.kind);
        let mut image = self.types.image(ty).to_vec();
        let initial = field(node, "initial_value");
        if let Some(&first) = initial.first() {
            match header.section {
                Section::InOut | Section::External => {
                    self.error(first, "these variables have no initial value");
                }
                _ => self.fill(ty, &initial, &pou.scope, &mut image),
            }
        }
        for name in field(node, "names") {
            self.variable(name, ty, &image, header, pou);
        }
    }

    fn check_type(&mut self, node: Node<'t>, ty: TypeId, header: Header, kind: PouKind) {
        let is_block = matches!(self.types.get(ty), Type::Block { .. });
        let is_program = match self.types.get(ty) {
            Type::Block { pou, .. } => self.pous[*pou].kind == PouKind::Program,
            _ => false,
        };
        if is_program {
            self.error(node, "only a resource has instances of a program");
        } else if is_block && kind == PouKind::Function && header.section != Section::InOut {
            self.error(node, "a function has no instances of function blocks");
        } else if is_block && header.constant {
            self.error(node, "an instance of a function block is no constant");
        }
        let composite = !self.types.is_scalar(ty) && !matches!(self.types.get(ty), Type::Text { .. });
        if self.source.dialect == Dialect::Siemens && header.constant && composite {
            self.error(node, "constants of SCL have elementary types");
        }
    }

    fn variable(&mut self, node: Node<'t>, ty: TypeId, image: &[i64], header: Header, pou: &mut Pou) {
        self.check_name(node);
        let name = self.source.text(node).to_owned();
        let capitals = self.source.name(node);
        self.check_clash(node, &capitals, header, pou);
        let place = self.allocate(image, header, pou);
        let value = (header.constant && self.types.is_scalar(ty)).then(|| image[0]);
        let value = value.filter(|_| header.section != Section::External && header.section != Section::InOut);
        let constant = header.constant;
        let retain = header.retain == Some(true);
        let (section, at) = (header.section, position(node));
        let variable = Variable { name, section, ty, place, constant, retain, value, at };
        pou.scope.by_name.insert(capitals, pou.scope.variables.len());
        pou.scope.variables.push(variable);
    }

    fn check_clash(&mut self, node: Node<'t>, capitals: &str, header: Header, pou: &Pou) {
        if self.source.is_prelude(node) {
            return;
        }
        if pou.scope.by_name.contains_key(capitals) || capitals == pou.name.to_ascii_uppercase() {
            self.error(node, format!("`{capitals}` is declared twice"));
        } else if self.is_strict() && header.section != Section::Global {
            // Compilers that tell names apart while reading stumble over it.
            if self.is_declared(capitals) || self.enumerators.contains_key(capitals) {
                self.error(node, format!("`{capitals}` is declared at the top, too"));
            }
        }
    }

    /// Finds room for a variable.
    fn allocate(&mut self, image: &[i64], header: Header, pou: &mut Pou) -> Place {
        let is_function = pou.kind == PouKind::Function;
        let add = |cells: &mut Vec<i64>, image: &[i64]| {
            cells.extend_from_slice(image);
            (cells.len() - image.len()) as u32
        };
        match header.section {
            Section::Local | Section::Global if header.constant => {
                Place::Constant(add(&mut self.constants, image))
            }
            Section::Global => Place::Global(add(&mut self.global_cells, image)),
            // Its place is that of the global variable, which may not be known yet.
            Section::External => Place::Global(0),
            Section::InOut if is_function => Place::ThroughFrame(add(&mut pou.frame, &[0])),
            Section::InOut => Place::ThroughThis(add(&mut pou.image, &[0])),
            _ if is_function || header.section == Section::Temp => Place::Frame(add(&mut pou.frame, image)),
            _ => Place::This(add(&mut pou.image, image)),
        }
    }
}
