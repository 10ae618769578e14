//! Scenarios and effects as lists of numbers in which names, places and the order of constraints play no part: what
//! becomes of them where objects change places can be compared with what there is.

use crate::model::{
    Argument, BinaryOp, ClassId, Effect, Endpoint, Expr, Message, Node, NodeKind, ObjectId, RoleRef,
    Scenario, Spec, Type, Value,
};
use std::collections::BTreeMap;

/// What a scenario or an effect says, and which objects it names how often.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(super) struct Form {
    pub(super) text: Vec<i64>,
    pub(super) names: BTreeMap<ObjectId, u32>,
    /// It says something of which this cannot tell whether it is an object.
    pub(super) is_unclear: bool,
}

impl Form {
    /// A scenario, each object that it names replaced by its image.
    pub(super) fn of_scenario(
        spec: &Spec,
        scenario: &Scenario,
        image: &dyn Fn(ObjectId) -> ObjectId,
    ) -> Form {
        let mut writer = Writer { spec, image, place: Place::Scenario(scenario), form: Form::default() };
        writer.scenario(scenario);
        writer.form
    }

    /// What an effect does. Which events it belongs to is not part of it.
    pub(super) fn of_effect(spec: &Spec, effect: &Effect, image: &dyn Fn(ObjectId) -> ObjectId) -> Form {
        let mut writer = Writer { spec, image, place: Place::Effect(effect), form: Form::default() };
        for assignment in &effect.assignments {
            writer.expr(&assignment.owner, true);
            writer.push(assignment.attribute as i64);
            writer.ty(assignment.ty);
            writer.expr(&assignment.value, matches!(assignment.ty, Type::Class(_)));
        }
        writer.form
    }
}

/// Where an expression stands.
#[derive(Clone, Copy)]
enum Place<'a> {
    Scenario(&'a Scenario),
    Effect(&'a Effect),
}

struct Writer<'a> {
    spec: &'a Spec,
    image: &'a dyn Fn(ObjectId) -> ObjectId,
    place: Place<'a>,
    form: Form,
}

impl Writer<'_> {
    fn push(&mut self, number: i64) {
        self.form.text.push(number);
    }

    fn object(&mut self, object: ObjectId) {
        *self.form.names.entry(object).or_default() += 1;
        self.push((self.image)(object) as i64);
    }

    fn ty(&mut self, ty: Type) {
        let numbers = match ty {
            Type::Bool => [0, 0, 0],
            Type::Int(low, high) => [1, low, high],
            Type::Enum(index) => [2, index as i64, 0],
            Type::Class(class) => [3, class as i64, 0],
        };
        self.form.text.extend(numbers);
    }

    fn scenario(&mut self, scenario: &Scenario) {
        self.push(scenario.kind as i64);
        self.push(scenario.roles.len() as i64);
        for role in &scenario.roles {
            self.push(role.class as i64);
        }
        self.push(scenario.variables.len() as i64);
        for variable in &scenario.variables {
            self.ty(variable.ty);
        }
        self.push(scenario.bindings.len() as i64);
        for (role, value, _) in &scenario.bindings {
            self.push(*role as i64);
            self.expr(value, true);
        }
        self.list(scenario.initial.iter().map(|&node| i64::from(node)));
        self.push(scenario.nodes.len() as i64);
        for node in &scenario.nodes {
            self.node(scenario, node);
        }
    }

    fn list(&mut self, numbers: impl ExactSizeIterator<Item = i64>) {
        self.push(numbers.len() as i64);
        self.form.text.extend(numbers);
    }

    fn node(&mut self, scenario: &Scenario, node: &Node) {
        self.push(i64::from(node.parent));
        match &node.kind {
            NodeKind::Body { children, variables, constraints } => {
                self.push(0);
                self.list(children.iter().map(|&child| i64::from(child)));
                self.list(variables.iter().map(|&variable| variable as i64));
                // It does not matter which of them comes first, or whether one is there twice.
                let before = std::mem::take(&mut self.form.text);
                let mut forms: Vec<Vec<i64>> = Vec::new();
                for constraint in constraints {
                    self.push(constraint.kind as i64);
                    self.message(&constraint.message);
                    forms.push(std::mem::take(&mut self.form.text));
                }
                forms.sort_unstable();
                forms.dedup();
                self.form.text = before;
                self.push(forms.len() as i64);
                self.form.text.extend(forms.into_iter().flatten());
            }
            NodeKind::Message { strict, monitored, modality, message } => {
                self.push(1);
                self.push(i64::from(*strict));
                self.push(i64::from(*monitored));
                self.push(modality.map_or(-1, |modality| modality as i64));
                self.message(message);
            }
            NodeKind::Alternative(cases) => {
                self.push(2);
                self.push(cases.len() as i64);
                for case in cases {
                    self.push(i64::from(case.body));
                    self.condition(case.condition.as_ref());
                }
            }
            NodeKind::Parallel(branches) => {
                self.push(3);
                self.list(branches.iter().map(|&branch| i64::from(branch)));
            }
            NodeKind::While(condition, body) => {
                self.push(4);
                self.push(i64::from(*body));
                self.condition(condition.as_ref());
            }
            NodeKind::Wait { strict, eventually, condition } => {
                self.push(5);
                self.push(i64::from(*strict));
                self.push(i64::from(*eventually));
                self.expr(condition, false);
            }
            NodeKind::Interrupt(condition) => {
                self.push(6);
                self.expr(condition, false);
            }
            NodeKind::Violation(condition) => {
                self.push(7);
                self.expr(condition, false);
            }
            NodeKind::Assign(variable, value) => {
                self.push(8);
                self.push(*variable as i64);
                let is_object = matches!(scenario.variables[*variable].ty, Type::Class(_));
                match value {
                    None => self.push(0),
                    Some(value) => {
                        self.push(1);
                        self.expr(value, is_object);
                    }
                }
            }
        }
    }

    fn condition(&mut self, condition: Option<&Expr>) {
        match condition {
            None => self.push(0),
            Some(condition) => {
                self.push(1);
                self.expr(condition, false);
            }
        }
    }

    fn message(&mut self, message: &Message) {
        for role in [message.sender, message.receiver] {
            match role {
                RoleRef::Object(object) => {
                    self.push(0);
                    self.object(object);
                }
                RoleRef::Dynamic(role) => {
                    self.push(1);
                    self.push(role as i64);
                }
            }
        }
        self.push(message.operation as i64);
        let parameters = &self.spec.domain.operations[message.operation].parameters;
        for (argument, (_, ty)) in message.arguments.iter().zip(parameters) {
            match argument {
                Argument::Any => self.push(0),
                Argument::Bind(variable) => {
                    self.push(1);
                    self.push(*variable as i64);
                }
                Argument::Value(value) => {
                    self.push(2);
                    self.expr(value, matches!(ty, Type::Class(_)));
                }
            }
        }
    }

    /// `is_object`: its value is an object or `null`.
    fn expr(&mut self, expr: &Expr, is_object: bool) {
        match expr {
            Expr::Const(value) => self.constant(*value, is_object),
            Expr::Variable(variable) => self.form.text.extend([1, *variable as i64]),
            Expr::Role(role) => self.form.text.extend([2, *role as i64]),
            Expr::Sender => self.push(3),
            Expr::Receiver => self.push(4),
            Expr::Parameter(parameter) => self.form.text.extend([5, *parameter as i64]),
            Expr::Attribute(owner, attribute, _) => {
                self.form.text.extend([6, *attribute as i64]);
                self.expr(owner, true);
            }
            Expr::Not(a) => {
                self.push(7);
                self.expr(a, false);
            }
            Expr::Neg(a, _) => {
                self.push(8);
                self.expr(a, false);
            }
            Expr::And(a, b) => self.both(9, a, b, false),
            Expr::Or(a, b) => self.both(10, a, b, false),
            Expr::Binary(op, a, b, _) => {
                let are_objects = matches!(op, BinaryOp::Eq | BinaryOp::Ne) && self.compares_objects(a, b);
                self.both(11 + *op as i64, a, b, are_objects);
            }
        }
    }

    fn both(&mut self, kind: i64, a: &Expr, b: &Expr, are_objects: bool) {
        self.push(kind);
        self.expr(a, are_objects);
        self.expr(b, are_objects);
    }

    fn constant(&mut self, value: Value, is_object: bool) {
        self.push(0);
        match usize::try_from(value) {
            Ok(object) if is_object => self.object(object),
            _ => self.push(value),
        }
    }

    /// Whether two sides of `==` are objects. Two constants are equal or not whatever changes places.
    fn compares_objects(&mut self, a: &Expr, b: &Expr) -> bool {
        let sides =
            [a, b].map(|side| if matches!(side, Expr::Const(_)) { None } else { Some(self.type_of(side)) });
        match sides {
            [None, None] => false,
            [Some(Some(ty)), _] | [_, Some(Some(ty))] => matches!(ty, Type::Class(_)),
            _ => {
                self.form.is_unclear = true;
                false
            }
        }
    }

    /// The type of an expression that is no constant; where it is an integer, some type of integers.
    fn type_of(&self, expr: &Expr) -> Option<Type> {
        let Writer { spec, place, .. } = self;
        Some(match (expr, place) {
            (Expr::Variable(variable), Place::Scenario(scenario)) => scenario.variables[*variable].ty,
            (Expr::Role(role), Place::Scenario(scenario)) => Type::Class(scenario.roles[*role].class),
            (Expr::Sender, Place::Effect(effect)) => self.end(effect.sender),
            (Expr::Receiver, Place::Effect(effect)) => self.end(effect.receiver),
            (Expr::Parameter(parameter), Place::Effect(effect)) => {
                spec.domain.operations[effect.operation].parameters[*parameter].1
            }
            (Expr::Attribute(owner, attribute, _), _) => {
                spec.domain.classes[self.class_of(owner)?].attributes[*attribute].ty
            }
            (Expr::Neg(..) | Expr::Binary(BinaryOp::Add | BinaryOp::Sub | BinaryOp::Mul, ..), _) => {
                Type::Int(0, 0)
            }
            (Expr::Not(_) | Expr::And(..) | Expr::Or(..) | Expr::Binary(..), _) => Type::Bool,
            _ => return None,
        })
    }

    fn end(&self, end: Endpoint) -> Type {
        Type::Class(match end {
            Endpoint::Object(object) => self.spec.domain.objects[object].class,
            Endpoint::Class(class) => class,
        })
    }

    /// The class of an expression whose value is an object.
    fn class_of(&self, expr: &Expr) -> Option<ClassId> {
        match expr {
            Expr::Const(object) => Some(self.spec.domain.objects.get(usize::try_from(*object).ok()?)?.class),
            _ => match self.type_of(expr)? {
                Type::Class(class) => Some(class),
                _ => None,
            },
        }
    }
}
