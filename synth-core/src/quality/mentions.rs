//! The names that a syntax tree mentions, other than to declare them.

use crate::syntax::ast::{
    Argument, ArgumentKind, Body, Class, Collaboration, DomainItem, Effect, Expr, ExprKind, File, Fragment,
    FragmentKind, Message, Scenario, Section, Type, TypeKind,
};
use std::collections::BTreeSet;

/// Names of classes, enums, objects, roles and variables. They are not told apart: a name that is mentioned as any of
/// these counts for all, which spares a declaration but never accuses one.
#[derive(Default)]
pub(super) struct Mentions<'a>(BTreeSet<&'a str>);

impl<'a> Mentions<'a> {
    /// Everything that the files mention. The role lines of collaborations mention classes only.
    pub(super) fn of_files(files: &'a [File]) -> Self {
        let mut mentions = Mentions::default();
        for section in files.iter().flat_map(|file| &file.sections) {
            mentions.section(section);
        }
        mentions
    }

    /// What the scenarios of a collaboration mention.
    pub(super) fn of_scenarios(collaboration: &'a Collaboration) -> Self {
        let mut mentions = Mentions::default();
        for scenario in &collaboration.scenarios {
            mentions.scenario(scenario);
        }
        mentions
    }

    pub(super) fn contains(&self, name: &str) -> bool {
        self.0.contains(name)
    }

    fn section(&mut self, section: &'a Section) {
        match section {
            Section::Domain(items) => items.iter().for_each(|item| self.item(item)),
            Section::Object(object) => {
                self.0.insert(&object.class.text);
                object.values.iter().for_each(|(_, value)| self.expr(value));
            }
            Section::Effects(effects) => effects.iter().for_each(|effect| self.effect(effect)),
            Section::Controllable(section) => {
                self.0.extend(section.classes.iter().map(|class| class.text.as_str()));
            }
            Section::NonSpontaneous(events) => {
                self.0.extend(events.iter().map(|event| event.class.text.as_str()));
            }
            Section::ParameterRanges(ranges) => {
                for range in ranges {
                    self.0.insert(&range.event.class.text);
                    for span in range.parameters.iter().flat_map(|(_, spans)| spans) {
                        self.expr(&span.low);
                        span.high.iter().for_each(|high| self.expr(high));
                    }
                }
            }
            Section::Channels(channels) => {
                for channel in channels {
                    self.0.extend([channel.event.class.text.as_str(), channel.class.text.as_str()]);
                }
            }
            Section::Collaboration(collaboration) => {
                self.0.extend(collaboration.roles.iter().map(|role| role.class.text.as_str()));
                collaboration.scenarios.iter().for_each(|scenario| self.scenario(scenario));
            }
        }
    }

    fn item(&mut self, item: &'a DomainItem) {
        let DomainItem::Class(Class { base, attributes, operations, .. }) = item else { return };
        self.0.extend(base.iter().map(|base| base.text.as_str()));
        for attribute in attributes {
            self.ty(&attribute.ty);
            attribute.initial.iter().for_each(|value| self.expr(value));
        }
        operations.iter().flat_map(|operation| &operation.parameters).for_each(|(_, ty)| self.ty(ty));
    }

    fn effect(&mut self, effect: &'a Effect) {
        self.0.extend([effect.sender.text.as_str(), effect.receiver.text.as_str()]);
        for (path, value) in &effect.assignments {
            self.0.extend(path.names.first().map(|name| name.text.as_str()));
            self.expr(value);
        }
    }

    fn scenario(&mut self, scenario: &'a Scenario) {
        for (role, value) in &scenario.bindings {
            self.0.insert(&role.text);
            self.expr(value);
        }
        self.body(&scenario.body);
    }

    fn body(&mut self, body: &'a Body) {
        body.fragments.iter().for_each(|fragment| self.fragment(fragment));
        body.constraints.iter().for_each(|constraint| self.message(&constraint.message));
    }

    fn fragment(&mut self, fragment: &'a Fragment) {
        match &fragment.kind {
            FragmentKind::Body(body) => self.body(body),
            FragmentKind::Message(_, message) => self.message(message),
            FragmentKind::Alternative(cases) => {
                for case in cases {
                    case.condition.iter().for_each(|condition| self.expr(condition));
                    self.body(&case.body);
                }
            }
            FragmentKind::Parallel(branches) => branches.iter().for_each(|branch| self.body(branch)),
            FragmentKind::While(condition, body) => {
                condition.iter().for_each(|condition| self.expr(condition));
                self.body(body);
            }
            FragmentKind::Wait { condition, .. }
            | FragmentKind::Interrupt(condition)
            | FragmentKind::Violation(condition) => self.expr(condition),
            FragmentKind::Variable(ty, _, value) => {
                self.ty(ty);
                value.iter().for_each(|value| self.expr(value));
            }
            FragmentKind::Assignment(_, value) => self.expr(value),
        }
    }

    fn message(&mut self, message: &'a Message) {
        self.0.extend([message.sender.text.as_str(), message.receiver.text.as_str()]);
        for Argument { kind, .. } in &message.arguments {
            if let ArgumentKind::Value(value) = kind {
                self.expr(value);
            }
        }
    }

    fn ty(&mut self, ty: &'a Type) {
        if let TypeKind::Named(name) = &ty.kind {
            self.0.insert(name);
        }
    }

    fn expr(&mut self, expr: &'a Expr) {
        match &expr.kind {
            ExprKind::Bool(_) | ExprKind::Int(_) | ExprKind::Null => {}
            ExprKind::Literal(name, _) => {
                self.0.insert(&name.text);
            }
            ExprKind::Path(path) => self.0.extend(path.names.first().map(|name| name.text.as_str())),
            ExprKind::Unary(_, operand) => self.expr(operand),
            ExprKind::Binary(_, left, right) => {
                self.expr(left);
                self.expr(right);
            }
        }
    }
}
