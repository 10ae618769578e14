//! The sections between domain and collaborations: effects, who is controllable, what is spontaneous, ranges,
//! channels.

use super::super::{
    Channel, Effect, EffectAssignment, Endpoint, EventRef, Expr, ParameterRange, Type, Value,
};
use super::expr::Names;
use super::{Meaning, Resolver};
use crate::diagnostic::Code;
use crate::model::ClassId;
use crate::syntax::Span;
use crate::syntax::ast;

/// More values in one span of a parameter range are refused: each stands for an event.
const MOST_VALUES: u64 = 1 << 20;

impl Resolver {
    pub(super) fn effects(&mut self, sections: &[&ast::Section]) -> Vec<Effect> {
        let mut effects = Vec::new();
        for section in sections {
            let ast::Section::Effects(list) = section else { continue };
            for effect in list {
                effects.extend(self.effect(effect));
            }
        }
        effects
    }

    fn effect(&mut self, effect: &ast::Effect) -> Option<Effect> {
        let sender = self.endpoint(&effect.sender);
        let (receiver, receiver_class) = self.endpoint(&effect.receiver)?;
        let operation = self.operation(receiver_class, &effect.operation)?;
        let (sender, sender_class) = sender?;
        self.domain.operations[operation].mentioned = true;
        let declared = self.domain.operations[operation].parameters.clone();
        if declared.len() != effect.parameters.len() {
            self.wrong_count(&effect.operation, declared.len(), effect.parameters.len());
            return None;
        }
        self.check_unique("parameter", effect.parameters.iter());
        let parameters: Vec<(String, Type)> =
            effect.parameters.iter().zip(declared).map(|(name, (_, ty))| (name.text.clone(), ty)).collect();
        let names = Names { event: Some((sender_class, receiver_class, parameters)), ..Names::default() };
        let assignments = effect
            .assignments
            .iter()
            .filter_map(|(path, value)| self.assignment(path, value, &names))
            .collect();
        Some(Effect { sender, receiver, operation, assignments })
    }

    pub(super) fn wrong_count(&mut self, operation: &ast::Name, declared: usize, given: usize) {
        let message = format!(
            "`{}` takes {declared} argument{}, but {given} {} given",
            operation.text,
            if declared == 1 { "" } else { "s" },
            if given == 1 { "is" } else { "are" }
        );
        let help = match declared {
            0 => format!("write `{}()`", operation.text),
            _ => "give one argument for each parameter of the declaration".to_owned(),
        };
        self.error(Code::ArgumentCount, operation.span, message).help = Some(help);
    }

    fn endpoint(&mut self, name: &ast::Name) -> Option<(Endpoint, ClassId)> {
        match self.names.get(&name.text) {
            Some(&(Meaning::Object(object), _)) => {
                Some((Endpoint::Object(object), self.domain.objects[object].class))
            }
            Some(&(Meaning::Class(class), _)) => Some((Endpoint::Class(class), class)),
            _ => {
                let known: Vec<String> = self.names.keys().cloned().collect();
                self.unknown("object or class", name, known.iter().map(String::as_str));
                None
            }
        }
    }

    fn assignment(&mut self, path: &ast::Path, value: &ast::Expr, names: &Names) -> Option<EffectAssignment> {
        let (attribute, owner) = path.names.split_last()?;
        if owner.is_empty() {
            self.error(Code::TypeMismatch, path.span, "an effect assigns an attribute of an object").help =
                Some(format!("write `sender.{0}` or `receiver.{0}`", attribute.text));
            return None;
        }
        let owner_span = path.names[0].span.to(owner[owner.len() - 1].span);
        let owner = ast::Path { names: owner.to_vec(), span: owner_span };
        let owner = ast::Expr { kind: ast::ExprKind::Path(owner), span: owner_span };
        let (owner, owner_class) = self.object_valued(&owner, names)?;
        let position = self.attribute(owner_class, attribute)?;
        let ty = self.domain.classes[owner_class].attributes[position].ty;
        let value = self.value_of_type(value, ty, names, false)?;
        Some(EffectAssignment { owner, owner_class, attribute: position, ty, value, span: path.span })
    }

    pub(super) fn controllable(&mut self, sections: &[&ast::Section], specification: Span) -> Vec<bool> {
        let mut classes = Vec::new();
        let mut place = None;
        for section in sections {
            let ast::Section::Controllable(controllable) = section else { continue };
            place.get_or_insert(controllable.keyword);
            for name in &controllable.classes {
                classes.push(self.class(name));
            }
        }
        if classes.is_empty() {
            let message = "no class is controllable, so there is no controller to build";
            self.error(Code::NoControllableClass, place.unwrap_or(specification), message).help =
                Some("name the controller's class: `controllable { Controller }`".to_owned());
        }
        let domain = &self.domain;
        let is_controllable = |class| classes.iter().flatten().any(|&base| domain.is_a(class, base));
        domain.objects.iter().map(|object| is_controllable(object.class)).collect()
    }

    pub(super) fn non_spontaneous(&mut self, sections: &[&ast::Section]) -> Vec<EventRef> {
        let mut events = Vec::new();
        for section in sections {
            let ast::Section::NonSpontaneous(list) = section else { continue };
            events.extend(list.iter().filter_map(|event| self.event_ref(event)));
        }
        events
    }

    pub(super) fn channels(&mut self, sections: &[&ast::Section]) -> Vec<Channel> {
        let mut channels = Vec::new();
        for section in sections {
            let ast::Section::Channels(list) = section else { continue };
            channels.extend(list.iter().filter_map(|channel| self.channel(channel)));
        }
        channels
    }

    fn channel(&mut self, channel: &ast::Channel) -> Option<Channel> {
        let event = self.event_ref(&channel.event);
        let class = self.class(&channel.class)?;
        let reference = self.attribute(class, &channel.reference)?;
        if !matches!(self.domain.classes[class].attributes[reference].ty, Type::Class(_)) {
            let message = format!("`{}` is no reference to an object", channel.reference.text);
            self.error(Code::TypeMismatch, channel.reference.span, message);
            return None;
        }
        Some(Channel { event: event?, class, reference })
    }

    pub(super) fn ranges(&mut self, sections: &[&ast::Section]) -> Vec<ParameterRange> {
        let mut ranges = Vec::new();
        for section in sections {
            let ast::Section::ParameterRanges(list) = section else { continue };
            for range in list {
                ranges.extend(self.range(range));
            }
        }
        ranges
    }

    fn range(&mut self, range: &ast::ParameterRanges) -> Vec<ParameterRange> {
        let Some(event) = self.event_ref(&range.event) else { return Vec::new() };
        self.check_unique("range of", range.parameters.iter().map(|(name, _)| name));
        let parameters = self.domain.operations[event.operation].parameters.clone();
        let mut ranges = Vec::new();
        for (name, spans) in &range.parameters {
            let Some(parameter) = parameters.iter().position(|(n, _)| *n == name.text) else {
                let what = format!("parameter of `{}`:", range.event.operation.text);
                self.unknown(&what, name, parameters.iter().map(|(n, _)| n.as_str()));
                continue;
            };
            let ty = parameters[parameter].1;
            let mut values: Vec<Value> = spans.iter().flat_map(|span| self.span_values(span, ty)).collect();
            values.sort_unstable();
            values.dedup();
            ranges.push(ParameterRange { event, parameter, values });
        }
        ranges
    }

    fn span_values(&mut self, span: &ast::RangeSpan, ty: Type) -> Vec<Value> {
        let low = self.literal(&span.low, ty);
        let high = match &span.high {
            Some(high) => self.literal(high, ty),
            None => low,
        };
        match (low, high) {
            (Some(low), Some(high)) if low > high => {
                let place = span.low.span;
                self.error(Code::OutOfRange, place, format!("the span from `{low}` to `{high}` is empty"));
                Vec::new()
            }
            (Some(low), Some(high)) if high.abs_diff(low) >= MOST_VALUES => {
                let message = format!("the span from `{low}` to `{high}` has more than 2^20 values");
                self.error(Code::OutOfRange, span.low.span, message).help =
                    Some("narrow the span".to_owned());
                Vec::new()
            }
            (Some(low), Some(high)) => (low..=high).collect(),
            _ => Vec::new(),
        }
    }

    /// An expression that gives an object, with its static class.
    pub(super) fn object_valued(&mut self, expr: &ast::Expr, names: &Names) -> Option<(Expr, ClassId)> {
        match self.expr(expr, None, names)? {
            (value, super::expr::Ty::Class(class)) => Some((value, class)),
            _ => {
                self.error(Code::TypeMismatch, expr.span, "expected an object");
                None
            }
        }
    }
}
