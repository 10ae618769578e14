//! Expressions: what each name means, and whether the types fit.

use super::super::domain::NULL;
use super::super::{BinaryOp, ClassId, Expr, Type, Value};
use super::{Meaning, Resolver};
use crate::diagnostic::Code;
use crate::syntax::Span;
use crate::syntax::ast;

/// The type of an expression.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Ty {
    Bool,
    Int,
    Enum(usize),
    Class(ClassId),
    Null,
}

impl From<Type> for Ty {
    fn from(ty: Type) -> Self {
        match ty {
            Type::Bool => Ty::Bool,
            Type::Int(..) => Ty::Int,
            Type::Enum(e) => Ty::Enum(e),
            Type::Class(class) => Ty::Class(class),
        }
    }
}

/// The names that mean something besides classes, enums and objects.
#[derive(Clone, Default)]
pub(super) struct Names {
    /// Visible variables: name, index, type, whether it surely has a value.
    pub(super) variables: Vec<(String, usize, Type, bool)>,
    /// Dynamic roles: name, index, class, whether it is surely bound.
    pub(super) roles: Vec<(String, usize, ClassId, bool)>,
    /// In effects.
    pub(super) event: Option<EventNames>,
    /// In constraints: what is not bound yet matches anything and is no mistake.
    pub(super) lenient: bool,
}

/// Classes of an effect's sender and receiver, and its parameters.
pub(super) type EventNames = (ClassId, ClassId, Vec<(String, Type)>);

impl Resolver {
    /// An expression whose value is stored in, or compared with, something of type `ty`.
    ///
    /// With `superclass_fits` an expression of a superclass is accepted (a message argument then only matches what
    /// fits).
    pub(super) fn value_of_type(
        &mut self,
        expr: &ast::Expr,
        ty: Type,
        names: &Names,
        superclass_fits: bool,
    ) -> Option<Expr> {
        let (value, found) = self.expr(expr, Some(ty.into()), names)?;
        let fits = match (Ty::from(ty), found) {
            (Ty::Class(wanted), Ty::Class(class)) => {
                self.domain.is_a(class, wanted) || superclass_fits && self.domain.is_a(wanted, class)
            }
            (Ty::Class(_), Ty::Null) => true,
            (wanted, found) => wanted == found,
        };
        if !fits {
            self.mismatch(expr.span, &self.show_ty(ty.into()), found);
            return None;
        }
        if let (Type::Int(low, high), Some(constant)) = (ty, value.constant())
            && !(low..=high).contains(&constant)
        {
            let message = format!("`{constant}` is not in the range `{low}..={high}`");
            self.error(Code::OutOfRange, expr.span, message).help =
                Some("write a value of the range, or widen it where it is declared".to_owned());
            return None;
        }
        Some(value)
    }

    /// A Boolean expression.
    pub(super) fn condition(&mut self, expr: &ast::Expr, names: &Names) -> Option<Expr> {
        self.value_of_type(expr, Type::Bool, names, false)
    }

    fn mismatch(&mut self, span: Span, wanted: &str, found: Ty) {
        if matches!(found, Ty::Class(class) if self.is_orphan(class)) {
            self.silenced += 1;
            return;
        }
        let found = self.show_ty(found);
        let help = match wanted {
            "`bool`" => "write a truth value here, or change the declaration".to_owned(),
            _ => format!("write {wanted} here, or change the declaration"),
        };
        self.error(Code::TypeMismatch, span, format!("expected {wanted}, found {found}")).help = Some(help);
    }

    fn show_ty(&self, ty: Ty) -> String {
        match ty {
            Ty::Bool => "`bool`".to_owned(),
            Ty::Int => "an integer".to_owned(),
            Ty::Enum(e) => format!("a literal of `{}`", self.domain.enums[e].name),
            Ty::Class(class) => format!("an object of `{}`", self.domain.classes[class].name),
            Ty::Null => "`null`".to_owned(),
        }
    }

    pub(super) fn expr(
        &mut self,
        expr: &ast::Expr,
        expected: Option<Ty>,
        names: &Names,
    ) -> Option<(Expr, Ty)> {
        match &expr.kind {
            ast::ExprKind::Bool(value) => Some((Expr::Const(Value::from(*value)), Ty::Bool)),
            ast::ExprKind::Int(value) => Some((Expr::Const(*value), Ty::Int)),
            ast::ExprKind::Null => Some((Expr::Const(NULL), Ty::Null)),
            ast::ExprKind::Literal(name, literal) => self.qualified(name, literal),
            ast::ExprKind::Path(path) => self.path(path, expected, names),
            ast::ExprKind::Unary(op, operand) => self.unary(*op, operand, expr.span, names),
            ast::ExprKind::Binary(op, left, right) => self.binary(*op, left, right, expr.span, names),
        }
    }

    fn qualified(&mut self, name: &ast::Name, literal: &ast::Name) -> Option<(Expr, Ty)> {
        let Some(&(Meaning::Enum(e), _)) = self.names.get(&name.text) else {
            let enums: Vec<String> = self.domain.enums.iter().map(|e| e.name.clone()).collect();
            self.unknown("enum", name, enums.iter().map(String::as_str));
            return None;
        };
        let literals = self.domain.enums[e].literals.clone();
        let position = literals.iter().position(|l| *l == literal.text);
        if position.is_none() {
            let what = format!("literal of enum `{}`:", name.text);
            self.unknown(&what, literal, literals.iter().map(String::as_str));
        }
        Some((Expr::Const(position? as Value), Ty::Enum(e)))
    }

    fn unary(
        &mut self,
        op: ast::UnaryOp,
        operand: &ast::Expr,
        span: Span,
        names: &Names,
    ) -> Option<(Expr, Ty)> {
        let wanted = match op {
            ast::UnaryOp::Not => Ty::Bool,
            ast::UnaryOp::Neg => Ty::Int,
        };
        let value = Box::new(self.operand(operand, wanted, names)?);
        Some(match op {
            ast::UnaryOp::Not => (Expr::Not(value), Ty::Bool),
            ast::UnaryOp::Neg => (Expr::Neg(value, span), Ty::Int),
        })
    }

    fn operand(&mut self, expr: &ast::Expr, wanted: Ty, names: &Names) -> Option<Expr> {
        let (value, found) = self.expr(expr, Some(wanted), names)?;
        if found != wanted {
            let wanted = self.show_ty(wanted);
            self.mismatch(expr.span, &wanted, found);
            return None;
        }
        Some(value)
    }

    fn binary(
        &mut self,
        op: ast::BinaryOp,
        left: &ast::Expr,
        right: &ast::Expr,
        span: Span,
        names: &Names,
    ) -> Option<(Expr, Ty)> {
        use ast::BinaryOp as Op;
        let operands = match op {
            Op::Implies | Op::Or | Op::And => Ty::Bool,
            Op::Lt | Op::Le | Op::Gt | Op::Ge | Op::Add | Op::Sub | Op::Mul => Ty::Int,
            Op::Eq | Op::Ne => return self.equality(op, left, right, span, names),
        };
        let (a, b) = (self.operand(left, operands, names), self.operand(right, operands, names));
        let (a, b) = (Box::new(a?), Box::new(b?));
        let number = |op| (op, Ty::Int);
        let (op, ty) = match op {
            Op::Implies => return Some((Expr::Or(Box::new(Expr::Not(a)), b), Ty::Bool)),
            Op::Or => return Some((Expr::Or(a, b), Ty::Bool)),
            Op::And => return Some((Expr::And(a, b), Ty::Bool)),
            Op::Eq => (BinaryOp::Eq, Ty::Bool),
            Op::Ne => (BinaryOp::Ne, Ty::Bool),
            Op::Lt => (BinaryOp::Lt, Ty::Bool),
            Op::Le => (BinaryOp::Le, Ty::Bool),
            Op::Gt => (BinaryOp::Gt, Ty::Bool),
            Op::Ge => (BinaryOp::Ge, Ty::Bool),
            Op::Add => number(BinaryOp::Add),
            Op::Sub => number(BinaryOp::Sub),
            Op::Mul => number(BinaryOp::Mul),
        };
        Some((Expr::Binary(op, a, b, span), ty))
    }

    fn equality(
        &mut self,
        op: ast::BinaryOp,
        left: &ast::Expr,
        right: &ast::Expr,
        span: Span,
        names: &Names,
    ) -> Option<(Expr, Ty)> {
        // An enum literal takes its enum from the other side, so the side that may be one is resolved last.
        let literal_first = self.may_be_literal(left, names);
        let (first, second) = if literal_first { (right, left) } else { (left, right) };
        let told = self.diagnostics.len();
        let Some((a, first_ty)) = self.expr(first, None, names) else {
            // The other side may have a mistake of its own; a literal just has no enum now, and where that enum is the
            // mistake, no name is known to be a literal.
            let has_no_enum = self.diagnostics.len() == told && single_name(second).is_some();
            if !has_no_enum && !self.may_be_literal(second, names) {
                self.expr(second, None, names);
            }
            return None;
        };
        let (b, second_ty) = self.expr(second, Some(first_ty), names)?;
        let comparable = match (first_ty, second_ty) {
            (Ty::Class(a), Ty::Class(b)) => self.domain.is_a(a, b) || self.domain.is_a(b, a),
            (Ty::Class(_), Ty::Null) | (Ty::Null, Ty::Class(_)) => true,
            (a, b) => a == b,
        };
        if !comparable {
            let wanted = self.show_ty(first_ty);
            self.mismatch(second.span, &wanted, second_ty);
            return None;
        }
        let (a, b) = if literal_first { (b, a) } else { (a, b) };
        let op = if op == ast::BinaryOp::Eq { BinaryOp::Eq } else { BinaryOp::Ne };
        Some((Expr::Binary(op, Box::new(a), Box::new(b), span), Ty::Bool))
    }

    fn may_be_literal(&self, expr: &ast::Expr, names: &Names) -> bool {
        let Some(text) = single_name(expr) else { return false };
        let is_parameter = names.event.as_ref().is_some_and(|(.., parameters)| {
            text == "sender" || text == "receiver" || parameters.iter().any(|(n, _)| n == text)
        });
        let is_literal = self.domain.enums.iter().any(|e| e.literals.contains(text));
        is_literal
            && !(is_parameter
                || names.variables.iter().any(|(n, ..)| n == text)
                || names.roles.iter().any(|(n, ..)| n == text)
                || matches!(self.names.get(text), Some((Meaning::Object(_), _))))
    }

    fn path(&mut self, path: &ast::Path, expected: Option<Ty>, names: &Names) -> Option<(Expr, Ty)> {
        let (first, attributes) = path.names.split_first()?;
        let (mut value, mut ty) = self.first_name(first, attributes.is_empty(), expected, names)?;
        for name in attributes {
            let Ty::Class(class) = ty else {
                let found = self.show_ty(ty);
                self.error(Code::TypeMismatch, name.span, format!("{found} has no attributes"));
                return None;
            };
            let position = self.attribute(class, name)?;
            value = Expr::Attribute(Box::new(value), position, first.span.to(name.span));
            ty = self.domain.classes[class].attributes[position].ty.into();
        }
        Some((value, ty))
    }

    fn first_name(
        &mut self,
        name: &ast::Name,
        alone: bool,
        expected: Option<Ty>,
        names: &Names,
    ) -> Option<(Expr, Ty)> {
        let text = name.text.as_str();
        if let Some(&(_, index, ty, set)) = names.variables.iter().rev().find(|(n, ..)| n == text) {
            self.check_bound("variable", name, set || names.lenient);
            return Some((Expr::Variable(index), ty.into()));
        }
        if let Some((sender, receiver, parameters)) = &names.event {
            if let Some(p) = parameters.iter().position(|(n, _)| n == text) {
                return Some((Expr::Parameter(p), parameters[p].1.into()));
            }
            match text {
                "sender" => return Some((Expr::Sender, Ty::Class(*sender))),
                "receiver" => return Some((Expr::Receiver, Ty::Class(*receiver))),
                _ => {}
            }
        }
        if let Some(&(_, index, class, bound)) = names.roles.iter().find(|(n, ..)| n == text) {
            self.check_bound("dynamic role", name, bound || names.lenient);
            return Some((Expr::Role(index), Ty::Class(class)));
        }
        if let Some(&(Meaning::Object(object), _)) = self.names.get(text) {
            return Some((Expr::Const(object as Value), Ty::Class(self.domain.objects[object].class)));
        }
        if alone { self.enum_literal(name, expected, names) } else { self.unknown_value(name, names) }
    }

    fn check_bound(&mut self, what: &str, name: &ast::Name, bound: bool) {
        if !bound && !self.unbound.insert(name.text.clone()) {
            self.silenced += 1;
        } else if !bound {
            let message = format!("{what} `{}` is read before it is bound", name.text);
            self.error(Code::ReadBeforeBound, name.span, message).help =
                Some(format!("bind `{}` in an earlier message or declaration", name.text));
        }
    }

    fn enum_literal(&mut self, name: &ast::Name, expected: Option<Ty>, names: &Names) -> Option<(Expr, Ty)> {
        let mut found = Vec::new();
        for (e, enumeration) in self.domain.enums.iter().enumerate() {
            if let Some(position) = enumeration.literals.iter().position(|l| *l == name.text) {
                found.push((e, position));
            }
        }
        if let Some(Ty::Enum(wanted)) = expected
            && let Some(&(e, position)) = found.iter().find(|&&(e, _)| e == wanted)
        {
            return Some((Expr::Const(position as Value), Ty::Enum(e)));
        }
        match found.as_slice() {
            [] => self.unknown_value(name, names),
            &[(e, position)] => Some((Expr::Const(position as Value), Ty::Enum(e))),
            several => {
                let enums = several.iter().map(|&(e, _)| self.domain.enums[e].name.clone());
                let choices: Vec<String> = enums.map(|e| format!("`{e}:{}`", name.text)).collect();
                let message = format!("`{}` is a literal of several enums", name.text);
                self.error(Code::TypeMismatch, name.span, message).help =
                    Some(format!("write {}", choices.join(" or ")));
                None
            }
        }
    }

    fn unknown_value(&mut self, name: &ast::Name, names: &Names) -> Option<(Expr, Ty)> {
        let mut known: Vec<String> = self.domain.objects.iter().map(|object| object.name.clone()).collect();
        known.extend(names.variables.iter().map(|(n, ..)| n.clone()));
        known.extend(names.roles.iter().map(|(n, ..)| n.clone()));
        known.extend(self.domain.enums.iter().flat_map(|e| e.literals.clone()));
        if let Some((_, _, parameters)) = &names.event {
            known.extend(parameters.iter().map(|(n, _)| n.clone()));
            known.extend(["sender".to_owned(), "receiver".to_owned()]);
        }
        self.unknown("name", name, known.iter().map(String::as_str));
        None
    }
}

/// The expression, if it is a name and nothing more.
fn single_name(expr: &ast::Expr) -> Option<&String> {
    match &expr.kind {
        ast::ExprKind::Path(ast::Path { names, .. }) if names.len() == 1 => Some(&names[0].text),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::super::resolve;
    use crate::syntax::{FileId, parse_text};

    /// The mistakes in `wait [condition]`, with their columns from the condition on.
    #[track_caller]
    fn check(condition: &str, mistakes: &[(u32, &str)]) {
        let before = "specification S {
          domain d { enum E { on, off } class A { e: E  s() } class C { } }
          object a: A  object c: C  controllable { C }
          collaboration K { guarantee scenario G { a -> a.s() wait [\n";
        let (file, errors) = parse_text(&format!("{before}{condition}\n] }} }} }}"), FileId(0));
        assert_eq!(errors, [], "{condition}");
        let (_, diagnostics) = resolve(&[file.expect("a tree without errors")]);
        let found: Vec<(u32, &str)> =
            diagnostics.iter().map(|each| (each.span.start.column, each.message.as_str())).collect();
        assert_eq!(found, mistakes, "{condition}");
    }

    #[test]
    fn both_sides_of_a_comparison_are_looked_at_from_left_to_right() {
        check("a.e == on && off != a.e", &[]);
        check("no == a.e", &[(1, "unknown name `no`")]);
        check("a.e == no", &[(8, "unknown name `no`")]);
        check("no == none", &[(1, "unknown name `no`"), (7, "unknown name `none`")]);
        check("no.e == on", &[(1, "unknown name `no`")]);
        check("on == no.e", &[(7, "unknown name `no`")]);
    }
}
