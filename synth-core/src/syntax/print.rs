//! The canonical text of a syntax tree.
//!
//! [`print`] normalises older spellings, the order of attributes and operations, and the layout; what it prints
//! parses to the same tree, places apart. Comments other than requirement texts are not part of the tree.

use super::ast::{
    Argument, ArgumentKind, Attribute, BinaryOp, Body, Collaboration, ConstraintKind, DomainItem, Effect,
    EventRef, Expr, ExprKind, File, Fragment, FragmentKind, Message, Modality, Modifier, Name, Object,
    Operation, ParameterRanges, Path, Scenario, ScenarioKind, Section, Type, TypeKind, UnaryOp,
};

/// The canonical text of `file`, two spaces to a level, ending in a newline.
#[must_use]
pub fn print(file: &File) -> String {
    let mut out = Printer::default();
    for import in &file.imports {
        out.line(&format!("import {}", quoted(&import.path)));
    }
    out.open(&format!("specification {} {{", file.name.text));
    for section in &file.sections {
        out.section(section);
    }
    out.close("}");
    out.text
}

#[derive(Default)]
struct Printer {
    text: String,
    level: usize,
}

impl Printer {
    fn line(&mut self, text: &str) {
        for _ in 0..self.level {
            self.text.push_str("  ");
        }
        self.text.push_str(text);
        self.text.push('\n');
    }

    fn open(&mut self, text: &str) {
        self.line(text);
        self.level += 1;
    }

    fn close(&mut self, text: &str) {
        self.level -= 1;
        self.line(text);
    }

    fn block(&mut self, head: &str, lines: impl IntoIterator<Item = String>) {
        self.open(&format!("{head} {{"));
        for line in lines {
            self.line(&line);
        }
        self.close("}");
    }

    fn section(&mut self, section: &Section) {
        match section {
            Section::Domain(items) => {
                self.open("domain {");
                for item in items {
                    self.domain_item(item);
                }
                self.close("}");
            }
            Section::Object(object) => self.line(&object_text(object)),
            Section::Effects(effects) => {
                self.open("effects {");
                for effect in effects {
                    self.effect(effect);
                }
                self.close("}");
            }
            Section::Controllable(controllable) => {
                self.block("controllable", controllable.classes.iter().map(|class| class.text.clone()));
            }
            Section::NonSpontaneous(events) => self.block("non-spontaneous events", events.iter().map(event)),
            Section::ParameterRanges(ranges) => {
                self.block("parameter ranges", ranges.iter().map(ranges_text));
            }
            Section::Channels(channels) => self.block(
                "channels",
                channels
                    .iter()
                    .map(|c| format!("{} over {}.{}", event(&c.event), c.class.text, c.reference.text)),
            ),
            Section::Collaboration(collaboration) => self.collaboration(collaboration),
        }
    }

    fn domain_item(&mut self, item: &DomainItem) {
        match item {
            DomainItem::Enum(item) => {
                self.line(&format!("enum {} {{ {} }}", item.name.text, comma_list(&item.literals, name)));
            }
            DomainItem::Class(class) => {
                let modifier = if class.is_abstract { "abstract " } else { "" };
                let base = class.base.as_ref().map_or(String::new(), |base| format!(": {}", base.text));
                let attributes = class.attributes.iter().map(attribute);
                let head = format!("{modifier}class {}{base}", class.name.text);
                self.block(&head, attributes.chain(class.operations.iter().map(operation)));
            }
        }
    }

    fn effect(&mut self, effect: &Effect) {
        let Effect { sender, receiver, operation, parameters, assignments } = effect;
        let parameters = comma_list(parameters, name);
        let head = format!("{} -> {}.{}({parameters})", sender.text, receiver.text, operation.text);
        self.block(
            &head,
            assignments.iter().map(|(target, value)| format!("{} = {};", path(target), expr(value))),
        );
    }

    fn collaboration(&mut self, collaboration: &Collaboration) {
        self.open(&format!("collaboration {} {{", collaboration.name.text));
        for role in &collaboration.roles {
            let kind = if role.dynamic { "dynamic" } else { "static" };
            self.line(&format!("{kind} role {} {}", role.class.text, role.name.text));
        }
        for scenario in &collaboration.scenarios {
            self.scenario(scenario);
        }
        self.close("}");
    }

    fn scenario(&mut self, scenario: &Scenario) {
        for line in &scenario.requirement {
            self.line(format!("/// {line}").trim_end());
        }
        let kind = match scenario.kind {
            ScenarioKind::Assumption => "assumption",
            ScenarioKind::Guarantee => "guarantee",
            ScenarioKind::Existential => "existential",
        };
        let bindings = match scenario.bindings.as_slice() {
            [] => String::new(),
            bindings => {
                let binding = |(role, value): &(Name, Expr)| format!("{} = {}", role.text, expr(value));
                format!(" bindings [{}]", comma_list(bindings, binding))
            }
        };
        self.body(&format!("{kind} scenario {}{bindings} ", scenario.name.text), &scenario.body);
    }

    fn body(&mut self, head: &str, body: &Body) {
        self.open(&format!("{head}{{"));
        for fragment in &body.fragments {
            self.fragment(fragment);
        }
        if body.constraints.is_empty() {
            return self.close("}");
        }
        self.close("} constraints [");
        self.level += 1;
        for constraint in &body.constraints {
            let kind = match constraint.kind {
                ConstraintKind::Forbidden => "forbidden",
                ConstraintKind::Ignore => "ignore",
                ConstraintKind::Interrupt => "interrupt",
                ConstraintKind::Consider => "consider",
            };
            self.line(&format!("{kind} {}", message(&constraint.message)));
        }
        self.close("]");
    }

    fn fragment(&mut self, fragment: &Fragment) {
        let text = match &fragment.kind {
            FragmentKind::Body(body) => return self.body("", body),
            FragmentKind::Alternative(cases) => {
                for (at, case) in cases.iter().enumerate() {
                    let word = if at == 0 { "alternative" } else { "or" };
                    self.body(&format!("{word} {}", optional_condition(case.condition.as_ref())), &case.body);
                }
                return;
            }
            FragmentKind::Parallel(branches) => {
                for (at, branch) in branches.iter().enumerate() {
                    self.body(if at == 0 { "parallel " } else { "and " }, branch);
                }
                return;
            }
            FragmentKind::While(condition, body) => {
                return self.body(&format!("while {}", optional_condition(condition.as_ref())), body);
            }
            FragmentKind::Message(modifier, m) => format!("{}{}", modifier_text(*modifier), message(m)),
            FragmentKind::Wait { strict, eventually, condition } => {
                let strict = if *strict { "strict " } else { "" };
                let eventually = if *eventually { "eventually " } else { "" };
                format!("wait {strict}{eventually}[{}]", expr(condition))
            }
            FragmentKind::Interrupt(condition) => format!("interrupt [{}]", expr(condition)),
            FragmentKind::Violation(condition) => format!("violation [{}]", expr(condition)),
            FragmentKind::Variable(ty, name, value) => {
                let value = value.as_ref().map_or(String::new(), |value| format!(" = {}", expr(value)));
                format!("var {} {}{value}", type_text(ty), name.text)
            }
            FragmentKind::Assignment(name, value) => format!("{} = {}", name.text, expr(value)),
        };
        self.line(&text);
    }
}

fn comma_list<T>(items: &[T], text: impl Fn(&T) -> String) -> String {
    items.iter().map(text).collect::<Vec<_>>().join(", ")
}

fn name(name: &Name) -> String {
    name.text.clone()
}

fn quoted(text: &str) -> String {
    let mut out = String::from("\"");
    for c in text.chars() {
        match c {
            '"' => out.push_str("\\\""),
            '\\' => out.push_str("\\\\"),
            '\n' => out.push_str("\\n"),
            '\r' => out.push_str("\\r"),
            c => out.push(c),
        }
    }
    out.push('"');
    out
}

fn attribute(attribute: &Attribute) -> String {
    let initial = attribute.initial.as_ref().map_or(String::new(), |value| format!(" = {}", expr(value)));
    format!("{}: {}{initial}", attribute.name.text, type_text(&attribute.ty))
}

fn operation(operation: &Operation) -> String {
    let parameter = |(name, ty): &(Name, Type)| format!("{}: {}", name.text, type_text(ty));
    format!("{}({})", operation.name.text, comma_list(&operation.parameters, parameter))
}

fn type_text(ty: &Type) -> String {
    match &ty.kind {
        TypeKind::Bool => "bool".to_owned(),
        TypeKind::Int(low, high) => format!("{low}..={high}"),
        TypeKind::Named(name) => name.clone(),
    }
}

fn object_text(object: &Object) -> String {
    let value = |(attribute, value): &(Name, Expr)| format!("{}: {}", attribute.text, expr(value));
    let values = match object.values.as_slice() {
        [] => String::new(),
        values => format!(" {{ {} }}", comma_list(values, value)),
    };
    format!("object {}: {}{values}", object.name.text, object.class.text)
}

fn event(event: &EventRef) -> String {
    format!("{}.{}", event.class.text, event.operation.text)
}

fn ranges_text(ranges: &ParameterRanges) -> String {
    let parameters = comma_list(&ranges.parameters, |(name, spans)| {
        let spans = comma_list(spans, |span| match &span.high {
            None => expr(&span.low),
            Some(high) => format!("{}..={}", expr(&span.low), expr(high)),
        });
        format!("{} = [{spans}]", name.text)
    });
    format!("{}({parameters})", event(&ranges.event))
}

fn modifier_text(modifier: Modifier) -> String {
    let strict = if modifier.strict { "strict " } else { "" };
    let monitored = if modifier.monitored { "monitored " } else { "" };
    let modality = match modifier.modality {
        None => "",
        Some(Modality::Eventually) => "eventually ",
        Some(Modality::Urgent) => "urgent ",
        Some(Modality::Requested) => "requested ",
        Some(Modality::Committed) => "committed ",
    };
    format!("{strict}{monitored}{modality}")
}

fn message(message: &Message) -> String {
    let Message { sender, receiver, operation, arguments, .. } = message;
    format!("{} -> {}.{}({})", sender.text, receiver.text, operation.text, comma_list(arguments, argument))
}

fn argument(argument: &Argument) -> String {
    match &argument.kind {
        ArgumentKind::Any => "*".to_owned(),
        ArgumentKind::Bind(variable) => format!("bind {}", variable.text),
        ArgumentKind::Value(value) => expr(value),
    }
}

fn optional_condition(condition: Option<&Expr>) -> String {
    condition.map_or(String::new(), |condition| format!("[{}] ", expr(condition)))
}

fn path(path: &Path) -> String {
    path.names.iter().map(|name| name.text.as_str()).collect::<Vec<_>>().join(".")
}

/// The text of an expression, with the parentheses that its tree needs and no others.
fn expr(e: &Expr) -> String {
    match &e.kind {
        ExprKind::Bool(value) => value.to_string(),
        ExprKind::Int(value) => value.to_string(),
        ExprKind::Null => "null".to_owned(),
        ExprKind::Literal(of, literal) => format!("{}:{}", of.text, literal.text),
        ExprKind::Path(p) => path(p),
        ExprKind::Unary(op, operand) => {
            // A sign before digits would become part of the integer.
            let bare = match operand.kind {
                ExprKind::Binary(..) => false,
                ExprKind::Int(_) => *op != UnaryOp::Neg,
                _ => true,
            };
            let sign = if *op == UnaryOp::Not { '!' } else { '-' };
            if bare { format!("{sign}{}", expr(operand)) } else { format!("{sign}({})", expr(operand)) }
        }
        ExprKind::Binary(op, left, right) => {
            let associates_right = *op == BinaryOp::Implies;
            let chains = op.precedence() != BinaryOp::Eq.precedence();
            let left = operand(left, op.precedence() + u8::from(associates_right || !chains));
            let right = operand(right, op.precedence() + u8::from(!associates_right));
            format!("{left} {} {right}", op.text())
        }
    }
}

/// `e` in parentheses if it binds less tightly than `least`.
fn operand(e: &Expr, least: u8) -> String {
    match &e.kind {
        ExprKind::Binary(op, ..) if op.precedence() < least => format!("({})", expr(e)),
        _ => expr(e),
    }
}
