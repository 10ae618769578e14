//! Collaborations: from scenario bodies to node trees.
//!
//! One walk in textual order resolves names and at the same time knows which variables and dynamic roles surely
//! have a value at each place.

use super::super::scenario::{
    Argument, Case, Constraint, Kind, Message, Node, NodeId, NodeKind, Role, RoleRef, Scenario, Variable,
};
use super::super::{ClassId, Expr, Type};
use super::expr::Names;
use super::{Meaning, Resolver, flow};
use crate::diagnostic::Code;
use crate::syntax::Span;
use crate::syntax::ast;
use std::collections::BTreeMap;

impl Resolver {
    pub(super) fn collaborations(
        &mut self,
        sections: &[&ast::Section],
        controllable: &[bool],
    ) -> Vec<Scenario> {
        let mut scenarios = Vec::new();
        let mut seen: BTreeMap<String, Span> = BTreeMap::new();
        for section in sections {
            let ast::Section::Collaboration(collaboration) = section else { continue };
            let roles = self.roles(collaboration);
            for scenario in &collaboration.scenarios {
                let name = format!("{}.{}", collaboration.name.text, scenario.name.text);
                if let Some(&first) = seen.get(&name) {
                    self.duplicate("scenario", &scenario.name, first);
                    continue;
                }
                seen.insert(name.clone(), scenario.name.span);
                scenarios.extend(self.scenario(name, scenario, &roles, controllable));
            }
        }
        scenarios
    }

    /// The dynamic roles of a collaboration.
    fn roles(&mut self, collaboration: &ast::Collaboration) -> Vec<Role> {
        self.check_unique("role", collaboration.roles.iter().map(|role| &role.name));
        let mut roles: Vec<Role> = Vec::new();
        for role in &collaboration.roles {
            let Some(class) = self.class(&role.class) else {
                self.lost.insert(role.name.text.clone());
                continue;
            };
            let object = match self.names.get(&role.name.text) {
                Some(&(Meaning::Object(object), place)) => Some((object, place)),
                _ => None,
            };
            match (role.dynamic, object) {
                (true, Some((_, place))) => self.duplicate("role", &role.name, place),
                (true, None) if roles.iter().all(|r| r.name != role.name.text) => {
                    roles.push(Role { name: role.name.text.clone(), class });
                }
                (true, None) => {}
                (false, Some((object, place))) => {
                    if self.is_orphan(self.domain.objects[object].class) {
                        self.silenced += 1;
                    } else if !self.domain.is_a(self.domain.objects[object].class, class) {
                        let message = format!("object `{}` is no `{}`", role.name.text, role.class.text);
                        let diagnostic = self.error(Code::TypeMismatch, role.class.span, message);
                        diagnostic.labels.push((place, "the object is declared here".to_owned()));
                    }
                }
                (false, None) => {
                    let objects: Vec<String> = self.domain.objects.iter().map(|o| o.name.clone()).collect();
                    self.unknown("object", &role.name, objects.iter().map(String::as_str));
                }
            }
        }
        roles
    }

    fn scenario(
        &mut self,
        name: String,
        scenario: &ast::Scenario,
        roles: &[Role],
        controllable: &[bool],
    ) -> Option<Scenario> {
        if scenario.body.fragments.is_empty() {
            let message = format!("scenario `{}` is empty", scenario.name.text);
            self.error(Code::EmptyScenario, scenario.name.span, message).help =
                Some("write the messages that it is about, or remove it".to_owned());
            return None;
        }
        let mistakes = self.mistakes();
        self.unbound.clear();
        let initial = flow::initial_messages(&scenario.body);
        let mut builder = Builder {
            resolver: self,
            kind: scenario.kind,
            controllable,
            nodes: Vec::new(),
            variables: Vec::new(),
            names: Names::default(),
            initial,
            initial_nodes: Vec::new(),
            bound_by_bindings: Vec::new(),
        };
        for (index, role) in roles.iter().enumerate() {
            builder.names.roles.push((role.name.clone(), index, role.class, false));
        }
        let bindings = builder.bindings(scenario);
        if builder.initial.is_empty() {
            builder.bind_roles_of_bindings();
        }
        builder.body(&scenario.body, 0);
        let Builder { nodes, variables, initial_nodes, .. } = builder;
        if self.mistakes() > mistakes {
            return None;
        }
        let mut scenario = Scenario {
            name,
            kind: scenario.kind,
            span: scenario.name.span,
            requirement: scenario.requirement.clone(),
            roles: roles.to_vec(),
            variables,
            bindings,
            nodes,
            initial: initial_nodes,
        };
        if let Some(span) = flow::silent_loop(&scenario) {
            let message = "this loop can come round without a message or `wait`";
            self.error(Code::SilentLoop, span, message).help =
                Some("put a message or a `wait` on every way through its body".to_owned());
            return None;
        }
        drop_unused_roles(&mut scenario);
        Some(scenario)
    }
}

/// Every node has an id.
const MOST_NODES: usize = NodeId::MAX as usize + 1;

/// Builds the nodes of one scenario.
struct Builder<'a> {
    resolver: &'a mut Resolver,
    kind: Kind,
    controllable: &'a [bool],
    nodes: Vec<Node>,
    variables: Vec<Variable>,
    names: Names,
    /// Places of the initial messages.
    initial: Vec<Span>,
    initial_nodes: Vec<NodeId>,
    bound_by_bindings: Vec<usize>,
}

/// Per visible variable and per role: whether it surely has a value.
type Bound = (Vec<bool>, Vec<bool>);

impl Builder<'_> {
    fn bound(&self) -> Bound {
        let variables = self.names.variables.iter().map(|v| v.3).collect();
        (variables, self.names.roles.iter().map(|r| r.3).collect())
    }

    fn set_bound(&mut self, bound: &Bound) {
        for (variable, &set) in self.names.variables.iter_mut().zip(&bound.0) {
            variable.3 = set;
        }
        for (role, &set) in self.names.roles.iter_mut().zip(&bound.1) {
            role.3 = set;
        }
    }

    fn bind_roles_of_bindings(&mut self) {
        for &role in &self.bound_by_bindings {
            self.names.roles[role].3 = true;
        }
    }

    fn bindings(&mut self, scenario: &ast::Scenario) -> Vec<(usize, Expr, Span)> {
        let unbound = self.bound();
        for role in flow::surely_bound(&scenario.body, &self.initial) {
            if let Some(role) = self.names.roles.iter_mut().find(|r| r.0 == role) {
                role.3 = true;
            }
        }
        let mut bindings = Vec::new();
        self.resolver.check_unique("binding of", scenario.bindings.iter().map(|(name, _)| name));
        for (name, value) in &scenario.bindings {
            let Some(&(_, role, class, _)) = self.names.roles.iter().find(|r| r.0 == name.text) else {
                let known: Vec<String> = self.names.roles.iter().map(|r| r.0.clone()).collect();
                self.resolver.unknown("dynamic role", name, known.iter().map(String::as_str));
                continue;
            };
            let value = self.resolver.value_of_type(value, Type::Class(class), &self.names, false);
            self.names.roles[role].3 = true;
            self.bound_by_bindings.push(role);
            bindings.extend(value.map(|value| (role, value, name.span)));
        }
        self.set_bound(&unbound);
        bindings
    }

    /// Adds a node. One too many is an error, and then the scenario is given up; its id means nothing.
    fn push(&mut self, parent: NodeId, kind: NodeKind, span: Span) -> NodeId {
        if self.nodes.len() == MOST_NODES {
            self.resolver.error(Code::TooLarge, span, "the scenario has too many fragments");
        }
        self.nodes.push(Node { parent, kind, span });
        (self.nodes.len() - 1) as NodeId
    }

    fn body(&mut self, body: &ast::Body, parent: NodeId) -> NodeId {
        let empty = NodeKind::Body { children: Vec::new(), variables: Vec::new(), constraints: Vec::new() };
        let id = self.push(parent, empty, body.span);
        let visible = self.names.variables.len();
        let fragments = body.fragments.iter().filter_map(|f| self.fragment(f, id)).collect();
        // Constraints hold in the whole body, so they see all of its variables.
        self.names.lenient = true;
        let in_force = body.constraints.iter().filter_map(|c| self.constraint(c)).collect();
        self.names.lenient = false;
        let owned = self.names.variables.split_off(visible).into_iter().map(|v| v.1).collect();
        if let NodeKind::Body { children, variables, constraints } = &mut self.nodes[usize::from(id)].kind {
            *children = fragments;
            *variables = owned;
            *constraints = in_force;
        }
        id
    }

    fn constraint(&mut self, constraint: &ast::Constraint) -> Option<Constraint> {
        let message = self.message(&constraint.message)?;
        Some(Constraint { kind: constraint.kind, message })
    }

    fn fragment(&mut self, fragment: &ast::Fragment, parent: NodeId) -> Option<NodeId> {
        if self.nodes.len() > MOST_NODES {
            return None;
        }
        let span = fragment.span;
        match &fragment.kind {
            ast::FragmentKind::Body(body) => Some(self.body(body, parent)),
            ast::FragmentKind::Message(modifier, message) => {
                self.message_node(*modifier, message, parent, span)
            }
            ast::FragmentKind::Alternative(cases) => Some(self.alternative(cases, parent, span)),
            ast::FragmentKind::Parallel(branches) => Some(self.parallel(branches, parent, span)),
            ast::FragmentKind::While(condition, body) => {
                let condition = condition.as_ref().map(|c| self.resolver.condition(c, &self.names));
                let condition = match condition {
                    Some(condition) => Some(condition?),
                    None => None,
                };
                let id = self.push(parent, NodeKind::While(condition.clone(), 0), span);
                let before = self.bound();
                let body = self.body(body, id);
                self.set_bound(&before);
                self.nodes[usize::from(id)].kind = NodeKind::While(condition, body);
                Some(id)
            }
            ast::FragmentKind::Wait { strict, eventually, condition } => {
                let condition = self.resolver.condition(condition, &self.names)?;
                let kind = NodeKind::Wait { strict: *strict, eventually: *eventually, condition };
                Some(self.push(parent, kind, span))
            }
            ast::FragmentKind::Interrupt(condition) => {
                let condition = self.resolver.condition(condition, &self.names)?;
                Some(self.push(parent, NodeKind::Interrupt(condition), span))
            }
            ast::FragmentKind::Violation(condition) => {
                let condition = self.resolver.condition(condition, &self.names)?;
                Some(self.push(parent, NodeKind::Violation(condition), span))
            }
            ast::FragmentKind::Variable(ty, name, value) => {
                self.variable(ty, name, value.as_ref(), parent, span)
            }
            ast::FragmentKind::Assignment(name, value) => self.assignment(name, value, parent, span),
        }
    }

    fn alternative(&mut self, cases: &[ast::Case], parent: NodeId, span: Span) -> NodeId {
        let id = self.push(parent, NodeKind::Alternative(Vec::new()), span);
        let before = self.bound();
        let mut after: Option<Bound> = None;
        let mut resolved = Vec::new();
        for case in cases {
            self.set_bound(&before);
            let condition = case.condition.as_ref().map(|c| self.resolver.condition(c, &self.names));
            let body = self.body(&case.body, id);
            resolved.push(Case { condition: condition.flatten(), body });
            let now = self.bound();
            after = Some(after.map_or(now.clone(), |sofar| both(&sofar, &now)));
        }
        // With conditions on all cases none may be offered, and the alternative is passed.
        let passes = cases.iter().all(|case| case.condition.is_some());
        let is_initial = resolved.iter().any(|case| self.begins_initially(case.body));
        let after = after.unwrap_or_else(|| before.clone());
        self.set_bound(&if passes && !is_initial { both(&after, &before) } else { after });
        self.nodes[usize::from(id)].kind = NodeKind::Alternative(resolved);
        id
    }

    fn begins_initially(&self, body: NodeId) -> bool {
        self.initial_nodes.iter().any(|&node| {
            std::iter::successors(Some(node), |&n| Some(self.nodes[usize::from(n)].parent))
                .take_while(|&n| n != 0)
                .any(|n| n == body)
        })
    }

    fn parallel(&mut self, branches: &[ast::Body], parent: NodeId, span: Span) -> NodeId {
        let id = self.push(parent, NodeKind::Parallel(Vec::new()), span);
        let before = self.bound();
        let mut after = before.clone();
        let mut bodies = Vec::new();
        for branch in branches {
            self.set_bound(&before);
            bodies.push(self.body(branch, id));
            after = either(&after, &self.bound());
        }
        self.set_bound(&after);
        self.nodes[usize::from(id)].kind = NodeKind::Parallel(bodies);
        id
    }

    fn variable(
        &mut self,
        ty: &ast::Type,
        name: &ast::Name,
        value: Option<&ast::Expr>,
        parent: NodeId,
        span: Span,
    ) -> Option<NodeId> {
        let Some(ty) = self.resolver.ty(ty) else {
            self.resolver.lost.insert(name.text.clone());
            return None;
        };
        let has_value = value.is_some();
        let value = value.and_then(|value| self.resolver.value_of_type(value, ty, &self.names, false));
        if self.names.variables.iter().any(|v| v.0 == name.text) {
            let message = format!("variable `{}` is declared a second time", name.text);
            self.resolver.error(Code::DuplicateName, name.span, message).help =
                Some("rename it, or assign to the first without `var`".to_owned());
            return None;
        }
        let index = self.variables.len();
        self.variables.push(Variable { name: name.text.clone(), ty });
        self.names.variables.push((name.text.clone(), index, ty, has_value));
        Some(self.push(parent, NodeKind::Assign(index, value), span))
    }

    fn assignment(
        &mut self,
        name: &ast::Name,
        value: &ast::Expr,
        parent: NodeId,
        span: Span,
    ) -> Option<NodeId> {
        let (index, ty) = self.named_variable(name)?;
        let value = self.resolver.value_of_type(value, ty, &self.names, false);
        self.mark_set(index);
        let value = value?;
        Some(self.push(parent, NodeKind::Assign(index, Some(value)), span))
    }

    fn named_variable(&mut self, name: &ast::Name) -> Option<(usize, Type)> {
        let found = self.names.variables.iter().find(|v| v.0 == name.text).map(|v| (v.1, v.2));
        if found.is_none() {
            let known: Vec<String> = self.names.variables.iter().map(|v| v.0.clone()).collect();
            self.resolver.unknown("variable", name, known.iter().map(String::as_str));
        }
        found
    }

    fn mark_set(&mut self, variable: usize) {
        if let Some(known) = self.names.variables.iter_mut().find(|v| v.1 == variable) {
            known.3 = true;
        }
    }

    fn message_node(
        &mut self,
        modifier: ast::Modifier,
        message: &ast::Message,
        parent: NodeId,
        span: Span,
    ) -> Option<NodeId> {
        let is_initial = self.initial.contains(&message.span);
        let Some(resolved) = self.message(message) else {
            self.bind_all_of(message);
            if is_initial {
                self.bind_roles_of_bindings();
            }
            return None;
        };
        let sent_by_system = self.may_be_controllable(resolved.sender);
        if self.kind == Kind::Assumption && modifier.modality.is_some() && sent_by_system {
            let text = "an assumption cannot oblige the system: the sender of this message is controllable";
            self.resolver.error(Code::ControllableInAssumption, message.span, text).help =
                Some("remove the modality, or make the scenario a guarantee".to_owned());
        }
        let must_send = self.kind == Kind::Guarantee
            && modifier.modality.is_some()
            && !modifier.monitored
            && sent_by_system
            && !is_initial;
        for (role, name) in [(resolved.sender, &message.sender), (resolved.receiver, &message.receiver)] {
            let RoleRef::Dynamic(role) = role else { continue };
            if must_send && !self.names.roles[role].3 {
                let text = format!("the system must send this, but role `{}` is not bound yet", name.text);
                self.resolver.error(Code::UnboundRole, name.span, text).help =
                    Some("bind the role in an earlier message or with `bindings [ … ]`".to_owned());
            }
            self.names.roles[role].3 = true;
        }
        for argument in &resolved.arguments {
            if let Argument::Bind(variable) = argument {
                self.mark_set(*variable);
            }
        }
        let kind = NodeKind::Message {
            strict: modifier.strict,
            monitored: modifier.monitored,
            modality: modifier.modality,
            message: resolved,
        };
        let id = self.push(parent, kind, span);
        if is_initial {
            self.initial_nodes.push(id);
            self.bind_roles_of_bindings();
        }
        Some(id)
    }

    /// What a wrong message would bind if it were right.
    fn bind_all_of(&mut self, message: &ast::Message) {
        for name in [&message.sender, &message.receiver] {
            if let Some(role) = self.names.roles.iter_mut().find(|role| role.0 == name.text) {
                role.3 = true;
            }
        }
        for argument in &message.arguments {
            if let ast::ArgumentKind::Bind(name) = &argument.kind
                && let Some(variable) = self.names.variables.iter_mut().find(|v| v.0 == name.text)
            {
                variable.3 = true;
            }
        }
    }

    fn may_be_controllable(&self, sender: RoleRef) -> bool {
        match sender {
            RoleRef::Object(object) => self.controllable.get(object).copied().unwrap_or(false),
            RoleRef::Dynamic(role) => {
                let class = self.names.roles[role].2;
                let domain = &self.resolver.domain;
                let mut players =
                    (0..domain.objects.len()).filter(|&o| domain.is_a(domain.objects[o].class, class));
                players.any(|object| self.controllable.get(object).copied().unwrap_or(false))
            }
        }
    }

    fn message(&mut self, message: &ast::Message) -> Option<Message> {
        let sender = self.role(&message.sender);
        let (receiver, class) = self.role(&message.receiver)?;
        let operation = self.resolver.operation(class, &message.operation)?;
        let (sender, _) = sender?;
        self.resolver.domain.operations[operation].mentioned = true;
        let parameters = self.resolver.domain.operations[operation].parameters.clone();
        if parameters.len() != message.arguments.len() {
            self.resolver.wrong_count(&message.operation, parameters.len(), message.arguments.len());
            return None;
        }
        let arguments: Vec<Option<Argument>> =
            message.arguments.iter().zip(parameters).map(|(a, (_, ty))| self.argument(a, ty)).collect();
        let arguments = arguments.into_iter().collect::<Option<Vec<Argument>>>()?;
        Some(Message { sender, receiver, operation, arguments, span: message.span })
    }

    fn role(&mut self, name: &ast::Name) -> Option<(RoleRef, ClassId)> {
        if let Some(&(_, index, class, _)) = self.names.roles.iter().find(|r| r.0 == name.text) {
            return Some((RoleRef::Dynamic(index), class));
        }
        if let Some(&(Meaning::Object(object), _)) = self.resolver.names.get(&name.text) {
            return Some((RoleRef::Object(object), self.resolver.domain.objects[object].class));
        }
        let domain = &self.resolver.domain;
        let objects = domain.objects.iter().map(|object| object.name.clone());
        let known: Vec<String> = objects.chain(self.names.roles.iter().map(|r| r.0.clone())).collect();
        self.resolver.unknown("role or object", name, known.iter().map(String::as_str));
        None
    }

    fn argument(&mut self, argument: &ast::Argument, ty: Type) -> Option<Argument> {
        match &argument.kind {
            ast::ArgumentKind::Any => Some(Argument::Any),
            ast::ArgumentKind::Value(value) => {
                Some(Argument::Value(self.resolver.value_of_type(value, ty, &self.names, true)?))
            }
            ast::ArgumentKind::Bind(name) => {
                let (index, declared) = self.named_variable(name)?;
                if !self.takes(declared, ty) {
                    let wanted = self.resolver.domain.show_type(declared);
                    let given = self.resolver.domain.show_type(ty);
                    let message = format!("variable `{}` is of type `{wanted}`, not `{given}`", name.text);
                    self.resolver.error(Code::TypeMismatch, name.span, message);
                    return None;
                }
                Some(Argument::Bind(index))
            }
        }
    }

    /// Whether a variable can be bound to a parameter: then it takes those values that it can hold.
    fn takes(&self, variable: Type, parameter: Type) -> bool {
        let domain = &self.resolver.domain;
        match (variable, parameter) {
            (Type::Int(..), Type::Int(..)) => true,
            (Type::Class(v), Type::Class(p)) => domain.is_a(p, v) || domain.is_a(v, p),
            (v, p) => v == p,
        }
    }
}

fn both(a: &Bound, b: &Bound) -> Bound {
    let and = |a: &[bool], b: &[bool]| a.iter().zip(b).map(|(a, b)| *a && *b).collect();
    (and(&a.0, &b.0), and(&a.1, &b.1))
}

fn either(a: &Bound, b: &Bound) -> Bound {
    let or = |a: &[bool], b: &[bool]| a.iter().zip(b).map(|(a, b)| *a || *b).collect();
    (or(&a.0, &b.0), or(&a.1, &b.1))
}

/// Keeps only the roles that the scenario mentions: the others are no part of a copy's binding.
fn drop_unused_roles(scenario: &mut Scenario) {
    let mut used = vec![false; scenario.roles.len()];
    for_each_role(scenario, &mut |role| used[*role] = true);
    let mut renumbered = Vec::new();
    let mut next = 0;
    for &used in &used {
        renumbered.push(next);
        next += usize::from(used);
    }
    for_each_role(scenario, &mut |role| *role = renumbered[*role]);
    let mut keep = used.into_iter();
    scenario.roles.retain(|_| keep.next().unwrap_or(false));
}

fn for_each_role(scenario: &mut Scenario, visit: &mut dyn FnMut(&mut usize)) {
    for (role, value, _) in &mut scenario.bindings {
        visit(role);
        roles_of_expr(value, visit);
    }
    for node in &mut scenario.nodes {
        match &mut node.kind {
            NodeKind::Body { constraints, .. } => {
                for constraint in constraints {
                    roles_of_message(&mut constraint.message, visit);
                }
            }
            NodeKind::Message { message, .. } => roles_of_message(message, visit),
            NodeKind::Alternative(cases) => {
                for condition in cases.iter_mut().filter_map(|case| case.condition.as_mut()) {
                    roles_of_expr(condition, visit);
                }
            }
            NodeKind::While(Some(e), _)
            | NodeKind::Wait { condition: e, .. }
            | NodeKind::Interrupt(e)
            | NodeKind::Violation(e)
            | NodeKind::Assign(_, Some(e)) => roles_of_expr(e, visit),
            NodeKind::Parallel(_) | NodeKind::While(None, _) | NodeKind::Assign(_, None) => {}
        }
    }
}

fn roles_of_message(message: &mut Message, visit: &mut dyn FnMut(&mut usize)) {
    for role in [&mut message.sender, &mut message.receiver] {
        if let RoleRef::Dynamic(role) = role {
            visit(role);
        }
    }
    for argument in &mut message.arguments {
        if let Argument::Value(value) = argument {
            roles_of_expr(value, visit);
        }
    }
}

fn roles_of_expr(expr: &mut Expr, visit: &mut dyn FnMut(&mut usize)) {
    match expr {
        Expr::Role(role) => visit(role),
        Expr::Attribute(a, ..) | Expr::Not(a) | Expr::Neg(a, _) => roles_of_expr(a, visit),
        Expr::And(a, b) | Expr::Or(a, b) | Expr::Binary(_, a, b, _) => {
            roles_of_expr(a, visit);
            roles_of_expr(b, visit);
        }
        Expr::Const(_) | Expr::Variable(_) | Expr::Sender | Expr::Receiver | Expr::Parameter(_) => {}
    }
}
