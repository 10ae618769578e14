//! What stands behind the colon: types.

use tree_sitter::Node;

use super::{Analysis, Scope};
use crate::kind::Kind;
use crate::tree::{children, field, part};
use crate::types::{DEFAULT_TEXT, Field, Type, TypeId};

/// More cells than this are taken for a mistake.
const MOST_CELLS: i64 = 1 << 24;

impl<'t> Analysis<'t> {
    /// `name : type := default;`
    pub(super) fn type_definition(&mut self, node: Node<'t>) -> Option<TypeId> {
        let name = part(node, "name").map(|n| self.source.text(n).to_owned())?;
        let scope = Scope::default();
        let definition_node = part(node, "definition")?;
        let ty = self.specifier(definition_node, &scope, Some(&name))?;
        let Some(default) = part(node, "default") else { return Some(ty) };
        let mut image = self.types.image(ty).to_vec();
        self.fill(ty, &[default], &scope, &mut image);
        let definition = self.types.get(ty).clone();
        let own = self.types.add(definition, image);
        if definition_node.kind() == "enumerated_type_inline" {
            // The values belong to the type with the default.
            for (of, _) in self.enumerators.values_mut().flatten().filter(|(of, _)| *of == ty) {
                *of = own;
            }
        }
        Some(own)
    }

    /// The type that a node describes; `name` is what it gets to be called.
    pub(super) fn specifier(&mut self, node: Node<'t>, scope: &Scope, name: Option<&str>) -> Option<TypeId> {
        match node.kind() {
            "elementary_type" => self.elementary(node),
            "identifier" => self.named_type(node),
            "string_type" => self.string(node, scope),
            "array_type" => self.array(node, scope, name),
            "subrange_type" => self.subrange(node, scope),
            "enumerated_type_inline" => self.enumeration(node, scope, name),
            "structure_type_inline" => self.structure(node, scope, name),
            "pointer_type" => self.pointer(node, scope),
            other => {
                self.error(node, format!("`{other}` is not supported"));
                None
            }
        }
    }

    fn elementary(&mut self, node: Node<'t>) -> Option<TypeId> {
        let name = self.source.name(node);
        let scl_only = name == "CHAR" && self.source.dialect != crate::Dialect::Siemens;
        match Kind::named(&name).filter(|_| !scl_only) {
            Some(kind) => Some(self.types.elementary(kind)),
            None => {
                self.error(node, format!("`{name}` is not supported"));
                None
            }
        }
    }

    fn string(&mut self, node: Node<'t>, scope: &Scope) -> Option<TypeId> {
        if self.source.name(node).starts_with('W') {
            self.error(node, "`WSTRING` is not supported");
            return None;
        }
        let Some(length) = part(node, "length") else { return Some(self.types.text(DEFAULT_TEXT)) };
        let mut cursor = node.walk();
        let open = node.children(&mut cursor).find(|child| child.kind() == "(");
        let bracket = open.is_some_and(|open| self.source.spelled.brackets.contains(&open.start_byte()));
        if !bracket && !self.source.dialect.is_codesys() {
            self.error(node, "the length of a string stands in `[ ]`");
        }
        let capacity = self.constant_integer(length, scope)?;
        if !(1..=32_767).contains(&capacity) {
            self.error(length, "the length of a string is between 1 and 32767");
            return None;
        }
        Some(self.types.text(capacity as u32))
    }

    /// Lower and upper limit.
    fn limits(&mut self, node: Node<'t>, scope: &Scope) -> Option<(i64, i64)> {
        let low = self.constant_integer(part(node, "lower")?, scope)?;
        let high = self.constant_integer(part(node, "upper")?, scope)?;
        if low > high {
            self.error(node, "the lower limit is above the upper one");
            return None;
        }
        Some((low, high))
    }

    fn array(&mut self, node: Node<'t>, scope: &Scope, name: Option<&str>) -> Option<TypeId> {
        let ranges = field(node, "range");
        let limits: Vec<(i64, i64)> =
            ranges.into_iter().map(|range| self.limits(range, scope)).collect::<Option<_>>()?;
        let element = self.specifier(part(node, "element_type")?, scope, None)?;
        let mut count: i64 = 1;
        for (low, high) in &limits {
            count = count.saturating_mul(high.saturating_sub(*low).saturating_add(1));
        }
        if count.saturating_mul(i64::from(self.types.size(element))) > MOST_CELLS {
            self.error(node, "the array is too large");
            return None;
        }
        let image = self.types.image(element).repeat(count as usize);
        let named = name.map(str::to_owned);
        Some(self.types.add(Type::Array { limits, element, named }, image))
    }

    fn subrange(&mut self, node: Node<'t>, scope: &Scope) -> Option<TypeId> {
        let base_node = children(node).into_iter().next()?;
        let base = self.elementary(base_node)?;
        let kind = self.types.kind(base).filter(|kind| kind.is_integer());
        let Some(kind) = kind else {
            self.error(base_node, "only integers have subranges");
            return None;
        };
        let (low, high) = self.limits(node, scope)?;
        let (least, most) = kind.range();
        if i128::from(low) < least || i128::from(high) > most {
            self.error(node, format!("{low}..{high} is not within `{}`", kind.name()));
            return None;
        }
        Some(self.types.add(Type::Subrange { base: kind, low, high }, vec![low]))
    }

    fn enumeration(&mut self, node: Node<'t>, scope: &Scope, name: Option<&str>) -> Option<TypeId> {
        let mut values: Vec<(String, i64)> = Vec::new();
        for enumerator in field_or_children(node) {
            let name_node = part(enumerator, "name")?;
            self.check_name(name_node);
            let value = match part(enumerator, "value") {
                Some(value) => {
                    if self.is_strict() {
                        self.error(value, "enumerations with values are not in the second edition");
                    }
                    self.constant_integer(value, scope)?
                }
                None => values.last().map_or(0, |(_, last)| last + 1),
            };
            let capitals = self.source.name(name_node);
            if values.iter().any(|(other, _)| *other == capitals) {
                self.error(name_node, format!("`{capitals}` is declared twice"));
            }
            values.push((capitals, value));
        }
        let first = values.first()?.1;
        let ty = Type::Enumeration { name: name.unwrap_or("(…)").to_owned(), values: values.clone() };
        let id = self.types.add(ty, vec![first]);
        for (name, value) in values {
            self.enumerators.entry(name).or_default().push((id, value));
        }
        Some(id)
    }

    fn structure(&mut self, node: Node<'t>, scope: &Scope, name: Option<&str>) -> Option<TypeId> {
        let mut fields: Vec<Field> = Vec::new();
        let mut image = Vec::new();
        for node in children(node) {
            let name_node = part(node, "name")?;
            self.check_name(name_node);
            let capitals = self.source.name(name_node);
            if fields.iter().any(|field| field.name == capitals) {
                self.error(name_node, format!("`{capitals}` is declared twice"));
            }
            let ty = self.specifier(part(node, "type")?, scope, None)?;
            let offset = image.len();
            image.extend_from_slice(self.types.image(ty));
            if let Some(default) = part(node, "default") {
                self.fill(ty, &[default], scope, &mut image[offset..]);
            }
            fields.push(Field { name: capitals, ty, offset: offset as u32 });
        }
        let name = name.unwrap_or("STRUCT").to_owned();
        Some(self.types.add(Type::Structure { name, fields }, image))
    }

    fn pointer(&mut self, node: Node<'t>, scope: &Scope) -> Option<TypeId> {
        if !self.source.dialect.has_pointers() {
            self.error(node, "this dialect has no pointers");
            return None;
        }
        let target_node = part(node, "target")?;
        let target = self.specifier(target_node, scope, None)?;
        if self.types.uniform(target).is_none() {
            self.error(target_node, "only pointers to elementary types and arrays of them are supported");
            return None;
        }
        Some(self.types.pointer(target))
    }
}

fn field_or_children(node: Node<'_>) -> Vec<Node<'_>> {
    children(node).into_iter().filter(|child| child.kind() == "enumerator").collect()
}
