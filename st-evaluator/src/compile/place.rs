//! Variables, parts of variables, and what pointers point to.

use tree_sitter::Node;

use super::{Body, Located, Operand};
use crate::Dialect;
use crate::code::{Element, Expr, Place, Target};
use crate::declare::{PouKind, Section, Variable};
use crate::kind::Kind;
use crate::tree::{field, part, position};
use crate::types::{Type, TypeId};

/// Why a `CONSTANT` is not written.
const CONSTANT: &str = "a constant is not written";

/// The place so many cells further on.
fn further(place: Place, cells: u32) -> Place {
    match place {
        Place::Constant(at) => Place::Constant(at + cells),
        Place::Global(at) => Place::Global(at + cells),
        Place::This(at) => Place::This(at + cells),
        Place::Frame(at) => Place::Frame(at + cells),
        place if cells == 0 => place,
        place => Place::Field(Box::new(place), cells),
    }
}

impl<'t> Body<'_, 't> {
    /// Something that has a place, or an error.
    pub(super) fn place(&mut self, node: Node<'t>) -> Option<Located> {
        match self.operand(node, None)? {
            Operand::Place(located) => Some(located),
            _ => {
                self.error(node, "a variable is wanted");
                None
            }
        }
    }

    /// A place to be written.
    pub(super) fn target(&mut self, node: Node<'t>) -> Option<Located> {
        let located = self.place(node)?;
        if let Some(reason) = located.refused {
            self.error(node, reason);
            return None;
        }
        let root = self.unit.source.name(root_of(node));
        if self.is_strict() && self.controls.contains(&root) {
            self.error(node, "the control variable of a loop is not written in the loop");
        }
        if self.kind == Some(PouKind::Function)
            && root == self.unit.pous[self.index].name.to_ascii_uppercase()
        {
            self.has_result = true;
        }
        Some(located)
    }

    /// A name: of a variable, or of an enumeration's value.
    pub(super) fn identifier(&mut self, node: Node<'t>, hint: Option<TypeId>) -> Option<Operand> {
        let name = self.unit.source.name(node);
        let in_reach = !self.unit.is_strict();
        let global = self.unit.globals.get(&name);
        let own = self.scope.get(&name);
        let variable = match own {
            Some(variable) if variable.section == Section::External => match global {
                Some(global) => {
                    let constant = variable.constant || global.constant;
                    Some(Variable { constant, value: None, ..global.clone() })
                }
                // Reported already.
                None => return None,
            },
            Some(variable) => Some(variable.clone()),
            None => global.filter(|_| in_reach).cloned(),
        };
        if let Some(variable) = variable {
            if self.kind.is_none() && variable.value.is_none() {
                self.error(node, format!("`{name}` is no constant"));
                return None;
            }
            return Some(Operand::Place(self.variable(&variable)));
        }
        self.enumerator(node, &name, hint)
    }

    fn enumerator(&mut self, node: Node<'t>, name: &str, hint: Option<TypeId>) -> Option<Operand> {
        let found = self.unit.enumerators.get(name).map_or(&[][..], Vec::as_slice);
        let chosen = match found {
            [only] => Some(*only),
            several => several.iter().find(|(ty, _)| Some(*ty) == hint).copied(),
        };
        let Some((ty, value)) = chosen else {
            let message = match found.len() {
                0 => format!("`{}` is not declared", self.unit.source.text(node)),
                _ => format!("`{}` is a value of several enumerations", self.unit.source.text(node)),
            };
            self.error(node, message);
            return None;
        };
        Some(Operand::Scalar { ty, expr: Expr::Value(value), value: Some(value) })
    }

    fn variable(&self, variable: &Variable) -> Located {
        let refused = match variable.section {
            _ if variable.constant => Some(CONSTANT),
            Section::Input if self.is_strict() => Some("an input is not written"),
            _ => None,
        };
        Located { ty: variable.ty, place: variable.place.clone(), refused, value: variable.value }
    }

    /// `object.member`.
    pub(super) fn member(&mut self, node: Node<'t>) -> Option<Operand> {
        let (object, member) = (part(node, "object")?, part(node, "member")?);
        if object.kind() == "identifier" && self.names_a_type(object) {
            return self.qualified(node, object, member);
        }
        let located = self.place(object)?;
        let name = self.unit.source.name(member);
        match self.unit.types.get(located.ty).clone() {
            Type::Structure { fields, .. } => {
                if let Some(field) = fields.iter().find(|field| field.name == name) {
                    let place = further(located.place, field.offset);
                    return Some(Operand::Place(Located { ty: field.ty, place, value: None, ..located }));
                }
            }
            Type::Block { pou, .. } => {
                if let Some(variable) = self.unit.pous[pou].scope.get(&name).cloned() {
                    return self.variable_of_instance(member, located, &variable);
                }
            }
            _ => {}
        }
        let ty = self.unit.types.name(located.ty);
        self.error(member, format!("`{ty}` has no `{name}`"));
        None
    }

    fn names_a_type(&self, node: Node<'t>) -> bool {
        let name = self.unit.source.name(node);
        self.scope.get(&name).is_none() && self.unit.is_declared(&name)
    }

    /// `Type.value` of the dialects, `Type#value` of the standard.
    fn qualified(&mut self, node: Node<'t>, ty_node: Node<'t>, member: Node<'t>) -> Option<Operand> {
        let hash = self.unit.source.spelled.hashes.contains(&ty_node.end_byte());
        if self.is_strict() && !hash {
            self.error(node, "a value of an enumeration is written `Type#value`");
        }
        let ty = self.unit.named_type(ty_node)?;
        let name = self.unit.source.name(member);
        let value = match self.unit.types.get(ty) {
            Type::Enumeration { values, .. } => {
                values.iter().find(|(other, _)| *other == name).map(|(_, v)| *v)
            }
            _ => None,
        };
        let Some(value) = value else {
            self.error(member, format!("`{}` has no value `{name}`", self.unit.types.name(ty)));
            return None;
        };
        Some(Operand::Scalar { ty, expr: Expr::Value(value), value: Some(value) })
    }

    fn variable_of_instance(
        &mut self,
        node: Node<'t>,
        instance: Located,
        variable: &Variable,
    ) -> Option<Operand> {
        let refused = match variable.section {
            Section::Output => Some("an output is written by its function block only"),
            Section::Input if !self.is_strict() => None,
            Section::Input => {
                self.error(node, "an input cannot be used from outside");
                return None;
            }
            _ => {
                self.error(node, format!("`{}` is not visible from outside", variable.name));
                return None;
            }
        };
        let place = further(instance.place, variable.offset());
        Some(Operand::Place(Located { ty: variable.ty, place, refused, value: None }))
    }

    /// `object[index, …]`.
    pub(super) fn indexed(&mut self, node: Node<'t>) -> Option<Operand> {
        let object = part(node, "object")?;
        let indices = field(node, "index");
        let located = self.place(object)?;
        match self.unit.types.get(located.ty).clone() {
            Type::Array { limits, element, .. } => {
                if indices.len() > limits.len() || self.is_strict() && indices.len() != limits.len() {
                    self.error(node, format!("the array has {} indices", limits.len()));
                    return None;
                }
                if indices.len() < limits.len() {
                    self.error(node, "rows of an array are not supported");
                    return None;
                }
                self.element(located, &indices, &limits, element).map(Operand::Place)
            }
            Type::Text { capacity } => self.character(node, located, &indices, capacity),
            Type::Pointer(target) => self.behind(node, located, &indices, target),
            _ => {
                let name = self.unit.types.name(located.ty);
                self.error(object, format!("`{name}` is no array"));
                None
            }
        }
    }

    fn element(
        &mut self,
        located: Located,
        indices: &[Node<'t>],
        limits: &[(i64, i64)],
        element: TypeId,
    ) -> Option<Located> {
        let mut place = located.place;
        for (position_of, (&index, &(low, high))) in indices.iter().zip(limits).enumerate() {
            let rest: i64 = limits[position_of + 1..].iter().map(|(low, high)| high - low + 1).product();
            let stride = rest as u32 * self.unit.types.size(element);
            let (expr, value) = self.any_integer(index)?;
            if let Some(value) = value.filter(|value| *value < low || *value > high) {
                self.error(index, format!("index {value} is outside of [{low}..{high}]"));
                return None;
            }
            place = match value {
                // What lies behind a pointer may be shorter than the type says.
                Some(value) if !matches!(place, Place::Target(_)) => {
                    further(place, (value - low) as u32 * stride)
                }
                _ => {
                    let at = position(index);
                    Place::Element(Box::new(Element { base: place, index: expr, low, high, stride, at }))
                }
            };
        }
        Some(Located { ty: element, place, refused: located.refused, value: None })
    }

    /// A character of a string: `BYTE` from 0 in CODESYS, `CHAR` from 1 in SCL.
    fn character(
        &mut self,
        node: Node<'t>,
        located: Located,
        indices: &[Node<'t>],
        capacity: u32,
    ) -> Option<Operand> {
        let dialect = self.unit.source.dialect;
        if dialect == Dialect::Edition2 {
            self.error(node, "the second edition has no characters of strings");
            return None;
        }
        let capacity = i64::from(capacity);
        let (kind, low, high) = match dialect {
            Dialect::Siemens => (Kind::Char, 1, capacity),
            _ => (Kind::Byte, 0, capacity),
        };
        let ty = self.elementary(kind);
        let text = Located { place: further(located.place, 1), ..located };
        let [index] = indices else {
            self.error(node, "a string has one index");
            return None;
        };
        self.element(text, &[*index], &[(low, high)], ty).map(Operand::Place)
    }

    /// `pointer[index]`.
    fn behind(
        &mut self,
        node: Node<'t>,
        located: Located,
        indices: &[Node<'t>],
        target: TypeId,
    ) -> Option<Operand> {
        let [index] = indices else {
            self.error(node, "a pointer has one index");
            return None;
        };
        let (index, _) = self.any_integer(*index)?;
        let size = self.unit.types.size(target);
        let pointer = Expr::Load(located.place);
        let place = Place::Target(Box::new(Target { pointer, index: Some(index), size, at: position(node) }));
        Some(Operand::Place(Located { ty: target, place, refused: None, value: None }))
    }

    /// `pointer^`.
    pub(super) fn dereferenced(&mut self, node: Node<'t>) -> Option<Operand> {
        if !self.unit.source.dialect.has_pointers() {
            self.error(node, "this dialect has no pointers");
            return None;
        }
        let pointer_node = part(node, "pointer")?;
        let located = self.place(pointer_node)?;
        let Type::Pointer(target) = *self.unit.types.get(located.ty) else {
            let name = self.unit.types.name(located.ty);
            self.error(pointer_node, format!("`{name}` is no pointer"));
            return None;
        };
        // Of an array, those elements must be there that are used.
        let is_array = matches!(self.unit.types.get(target), Type::Array { .. });
        let size = if is_array { 0 } else { self.unit.types.size(target) };
        let pointer = Expr::Load(located.place);
        let place = Place::Target(Box::new(Target { pointer, index: None, size, at: position(node) }));
        Some(Operand::Place(Located { ty: target, place, refused: None, value: None }))
    }

    /// `ADR(variable)`.
    pub(super) fn address(&mut self, node: Node<'t>) -> Option<Operand> {
        if !self.unit.source.dialect.has_pointers() {
            self.error(node, "this dialect has no `ADR`");
            return None;
        }
        let operand = part(node, "operand")?;
        let located = self.place(operand)?;
        let Some(kind) = self.unit.types.uniform(located.ty) else {
            self.error(operand, "only addresses of elementary types and arrays of them are supported");
            return None;
        };
        let size = self.unit.types.size(located.ty);
        Some(Operand::Address { expr: Expr::Address(Box::new(located.place), size), kind })
    }
}

/// The variable that an expression is a part of.
fn root_of(mut node: Node<'_>) -> Node<'_> {
    while let Some(inner) = ["object", "pointer"].into_iter().find_map(|name| node.child_by_field_name(name))
    {
        node = inner;
    }
    node
}
