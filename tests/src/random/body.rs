//! Scenarios of a random specification.

use super::world::{Operation, Ty, World};
use super::{Options, Random};
use std::collections::BTreeSet;
use std::fmt::Write as _;

/// A variable in scope.
#[derive(Clone, Debug)]
struct Variable {
    name: String,
    ty: Ty,
    is_set: bool,
}

/// What is known where a fragment stands.
#[derive(Clone, Default, Debug)]
struct Known {
    variables: Vec<Variable>,
    bound: BTreeSet<&'static str>,
    /// A message lies behind: the scenario cannot be violated before anything has happened.
    begun: bool,
    depth: usize,
}

/// Who says it, about whom.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Kind {
    Assumption,
    Guarantee,
}

/// Who sends a message.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum By {
    System,
    Environment,
}

/// What a fragment is to be.
#[derive(Clone, Copy, Debug)]
enum Wanted {
    Message,
    Wait,
    Condition,
    Declaration,
    Assignment,
    Alternative,
    Parallel,
    Loop,
    Nested,
}

pub(super) struct Writer<'a> {
    random: &'a mut Random,
    world: &'a World,
    size: usize,
    kind: Kind,
    variables: usize,
    /// Receiver and operation of what the system is made to send: others look for it.
    caused: Vec<(&'static str, Operation)>,
}

impl Writer<'_> {
    /// The collaboration.
    pub(super) fn scenarios(random: &mut Random, world: &World, options: Options) -> String {
        let mut text = String::from("  collaboration All {\n");
        for (role, class) in &world.roles {
            _ = writeln!(text, "    dynamic role {class} {role}");
        }
        let size = options.size.max(1);
        let count = 1 + random.below(size).max(random.below(size));
        let mut caused = Vec::new();
        for index in 0..count {
            // The first one gives the system something to do.
            let kind = if index == 0 || random.chance(50) { Kind::Guarantee } else { Kind::Assumption };
            let followed = index > 0 && options.features.existential && random.chance(6);
            let mut writer =
                Writer { random: &mut *random, world, size: options.size, kind, variables: 0, caused };
            text.push_str(&writer.scenario(index, followed));
            caused = writer.caused;
        }
        text.push_str("  }\n");
        text
    }

    /// One scenario; one that is only `followed` is existential.
    fn scenario(&mut self, index: usize, followed: bool) -> String {
        let keyword = match self.kind {
            _ if followed => "existential",
            Kind::Assumption => "assumption",
            Kind::Guarantee => "guarantee",
        };
        let mut known = Known::default();
        let bindings = self.bindings(&mut known);
        let body = match self.random.below(10) {
            _ if index == 0 && self.random.chance(80) => self.response(&mut known),
            0..=4 => self.response(&mut known),
            5..=7 => self.restriction(&mut known),
            _ => {
                let length = 1 + self.random.below(2 + self.size / 2);
                self.body(&mut known, length)
            }
        };
        format!("    {keyword} scenario S{index}{bindings} {body}\n")
    }

    /// `bindings [ role = … ]`: that role is bound from the start.
    fn bindings(&mut self, known: &mut Known) -> String {
        let features = self.world.features;
        if !features.bindings || self.world.roles.is_empty() || !self.random.chance(15) {
            return String::new();
        }
        let device = *self.random.pick(&self.world.devices);
        let has_link = self.world.attributes.iter().any(|attribute| attribute.ty == Ty::Dev);
        let value = if has_link { format!("{device}.link") } else { device.to_string() };
        // The initial message must not bind it too.
        known.bound.insert("other");
        format!(" bindings [ other = {value} ]")
    }

    /// One side does something, so the other must answer.
    fn response(&mut self, known: &mut Known) -> String {
        let (trigger, answer) = match self.kind {
            Kind::Guarantee => (By::Environment, By::System),
            Kind::Assumption => (By::System, By::Environment),
        };
        let outer = known.clone();
        let mut text = String::from("{ ");
        text.push_str(&self.declaration_before(known));
        text.push_str(&self.initial(known, trigger));
        if self.random.chance(20) {
            text.push_str(&self.fragment(known));
        }
        for _ in 0..1 + self.random.below(2) {
            let modifier = self.modifier(answer, 90);
            text.push_str(&self.message(known, answer, &modifier));
            if self.random.chance(20) {
                text.push_str(&self.fragment(known));
            }
        }
        text.push('}');
        text.push_str(&self.constraints(&outer, 25));
        text
    }

    /// Between two messages, one must not happen.
    fn restriction(&mut self, known: &mut Known) -> String {
        let by = if self.kind == Kind::Guarantee { By::System } else { By::Environment };
        let first = if self.random.chance(70) { by } else { self.anyone() };
        let second = self.anyone();
        let begin = self.initial(known, first);
        let end = self.message(known, second, "");
        let forbidden = self.constraint_message(known, by);
        format!("{{ {begin}{end}}} constraints [ forbidden {forbidden}]")
    }

    fn anyone(&mut self) -> By {
        if self.random.chance(50) { By::System } else { By::Environment }
    }

    /// A variable for the initial message to bind.
    fn declaration_before(&mut self, known: &mut Known) -> String {
        if self.world.features.variables && self.random.chance(30) {
            self.declaration(known)
        } else {
            String::new()
        }
    }

    /// The first message of a scenario, which starts it and is no obligation.
    fn initial(&mut self, known: &mut Known, by: By) -> String {
        self.message(known, by, "")
    }

    /// A body of so many fragments.
    fn body(&mut self, known: &mut Known, length: usize) -> String {
        let outer = known.clone();
        let mut text = String::from("{ ");
        for _ in 0..length {
            text.push_str(&self.fragment(known));
        }
        text.push('}');
        text.push_str(&self.constraints(&outer, 25));
        text
    }

    /// A body of its own: what happens in it is not known outside.
    fn inner(&mut self, known: &Known, begin: impl FnOnce(&mut Self, &mut Known) -> String) -> String {
        let outer = known;
        let mut known = Known { depth: known.depth + 1, ..known.clone() };
        let mut text = String::from("{ ");
        text.push_str(&begin(self, &mut known));
        if self.random.chance(45) {
            text.push_str(&self.fragment(&mut known));
        }
        text.push('}');
        text.push_str(&self.constraints(outer, 15));
        text
    }

    fn own_message(&mut self, known: &mut Known) -> String {
        let by = self.anyone();
        let modifier = self.modifier(by, 60);
        self.message(known, by, &modifier)
    }

    fn fragment(&mut self, known: &mut Known) -> String {
        let features = self.world.features;
        let allowed = |allowed: bool, weight: usize| if allowed { weight } else { 0 };
        let shallow = known.depth < 2;
        let wanted = self.random.weighted(&[
            (40, Wanted::Message),
            (10, Wanted::Wait),
            (allowed(features.conditions && known.begun, 6), Wanted::Condition),
            (allowed(features.variables, 5), Wanted::Declaration),
            (allowed(features.variables && !known.variables.is_empty(), 8), Wanted::Assignment),
            (allowed(features.alternative && shallow, 10), Wanted::Alternative),
            (allowed(features.parallel && shallow, 7), Wanted::Parallel),
            (allowed(features.loops && shallow, 8), Wanted::Loop),
            (allowed(features.nested && shallow, 4), Wanted::Nested),
        ]);
        match wanted {
            Wanted::Message => self.own_message(known),
            Wanted::Wait => {
                let strict = if self.random.chance(15) { "strict " } else { "" };
                let eventually = if self.random.chance(30) { "eventually " } else { "" };
                format!("wait {strict}{eventually}[{}] ", self.condition(known))
            }
            Wanted::Condition => {
                let keyword = self.random.pick(&["interrupt", "violation"]);
                format!("{keyword} [{}] ", self.condition(known))
            }
            Wanted::Declaration => self.declaration(known),
            Wanted::Assignment => {
                let index = self.random.below(known.variables.len());
                let Variable { name, ty, .. } = known.variables[index].clone();
                let value = self.value(known, ty);
                known.variables[index].is_set = true;
                format!("{name} = {value} ")
            }
            Wanted::Alternative => self.alternative(known),
            Wanted::Parallel => {
                let count = 2 + usize::from(self.random.chance(15));
                let branches: Vec<String> = (0..count).map(|_| self.inner(known, Self::fragment)).collect();
                format!("parallel {} ", branches.join(" and "))
            }
            Wanted::Loop => {
                let condition = self.guard(known, 40);
                let body = self.inner(known, |writer, known| {
                    let condition = writer.guard(known, 20);
                    let wait = if condition.is_empty() { condition } else { format!("wait {condition}") };
                    wait + &writer.own_message(known)
                });
                format!("while {condition}{body} ")
            }
            Wanted::Nested => format!("{} ", self.inner(known, Self::fragment)),
        }
    }

    fn alternative(&mut self, known: &mut Known) -> String {
        let count = self.random.weighted(&[(15, 1), (65, 2), (20, 3)]);
        let cases: Vec<String> = (0..count)
            .map(|_| {
                let guard = self.guard(known, 40);
                let body = match self.random.below(20) {
                    0 => "{ }".to_string(),
                    1..=4 => self.inner(known, Self::fragment),
                    _ => self.inner(known, Self::own_message),
                };
                format!("{guard}{body}")
            })
            .collect();
        format!("alternative {} ", cases.join(" or "))
    }

    fn guard(&mut self, known: &Known, percent: usize) -> String {
        if self.random.chance(percent) { format!("[{}] ", self.condition(known)) } else { String::new() }
    }

    fn declaration(&mut self, known: &mut Known) -> String {
        self.variables += 1;
        let name = format!("v{}", self.variables);
        let parameters =
            self.world.inputs.iter().chain(&self.world.outputs).filter_map(|each| each.parameter);
        let types: Vec<Ty> = parameters.chain(self.world.attributes.iter().map(|each| each.ty)).collect();
        let ty = if types.is_empty() { Ty::Bool } else { *self.random.pick(&types) };
        let narrow = ty == Ty::Dev && self.world.devices.contains(&"sub") && self.random.chance(40);
        let ty = if narrow { Ty::Sub } else { ty };
        let is_set = self.random.chance(40);
        let value = if is_set { format!(" = {}", self.value(known, ty)) } else { String::new() };
        known.variables.push(Variable { name: name.clone(), ty, is_set });
        format!("var {} {name}{value} ", ty.text())
    }

    /// A modifier with a modality in so many cases of a hundred, if this side may have one.
    fn modifier(&mut self, by: By, percent: usize) -> String {
        let mut text = String::new();
        if self.random.chance(25) {
            text.push_str("strict ");
        }
        let may = match (self.kind, by) {
            (Kind::Assumption, By::System) => false,
            (Kind::Guarantee, By::Environment) => self.random.chance(3),
            _ => true,
        };
        if may && self.random.chance(percent) {
            if self.random.chance(5) {
                text.push_str("monitored ");
            }
            let modalities = [(40, "eventually "), (30, "urgent "), (10, "requested "), (20, "committed ")];
            text.push_str(self.random.weighted(&modalities));
        }
        text
    }

    /// A message; the roles and variables in it are bound afterwards.
    fn message(&mut self, known: &mut Known, by: By, modifier: &str) -> String {
        let must_be_bound = by == By::System && !modifier.trim_start_matches("strict ").is_empty();
        let text = self.event(known, by, must_be_bound, true);
        known.begun = true;
        format!("{modifier}{text} ")
    }

    /// A message of a constraint, which binds nothing.
    fn constraint_message(&mut self, known: &Known, by: By) -> String {
        let text = self.event(&mut known.clone(), by, false, false);
        format!("{text} ")
    }

    /// Constraints of a body; `known` is what is known where it begins.
    fn constraints(&mut self, known: &Known, percent: usize) -> String {
        if !self.random.chance(percent) {
            return String::new();
        }
        // Bindings are evaluated before any constraint is asked.
        let known = Known { begun: true, ..known.clone() };
        let mut text = String::from(" constraints [ ");
        for _ in 0..1 + self.random.below(2) {
            let kind = self.random.weighted(&[
                (35, "ignore"),
                (30, "forbidden"),
                (20, "interrupt"),
                (15, "consider"),
            ]);
            let by = match (kind, self.kind) {
                ("forbidden", Kind::Guarantee) if self.random.chance(85) => By::System,
                ("forbidden", Kind::Assumption) if self.random.chance(85) => By::Environment,
                _ => self.anyone(),
            };
            let message = self.constraint_message(&known, by);
            _ = write!(text, "{kind} {message}");
        }
        text.push(']');
        text
    }

    /// Sender, receiver, operation and arguments.
    fn event(&mut self, known: &mut Known, by: By, must_be_bound: bool, may_bind: bool) -> String {
        let mut device = self.device(known, must_be_bound);
        let controller = *self.random.pick(&self.world.controllers);
        let setter =
            self.world.features.parameters && !self.world.attributes.is_empty() && self.random.chance(10);
        let (sender, receiver, operation) = match by {
            _ if setter => {
                let attribute = self.random.pick(&self.world.attributes).clone();
                let (first, rest) = attribute.name.split_at(1);
                let name = format!("set{}{rest}", first.to_uppercase());
                let operation = Operation { name, parameter: Some(attribute.ty) };
                let sender = match by {
                    By::System => controller,
                    By::Environment => self.device(known, must_be_bound),
                };
                (sender, device, operation)
            }
            By::System => {
                let mut operation = self.random.pick(&self.world.outputs).clone();
                if !must_be_bound && !self.caused.is_empty() && self.random.chance(75) {
                    let (receiver, caused) = self.random.pick(&self.caused).clone();
                    operation = caused;
                    if self.world.devices.contains(&device) && self.world.devices.contains(&receiver) {
                        device = receiver;
                    }
                }
                if must_be_bound {
                    self.caused.push((device, operation.clone()));
                }
                (controller, device, operation)
            }
            By::Environment => (device, controller, self.random.pick(&self.world.inputs).clone()),
        };
        let arguments = match operation.parameter {
            Some(ty) => format!("({})", self.argument(known, ty, may_bind)),
            None if self.random.chance(10) => String::new(),
            None => "()".to_string(),
        };
        if may_bind {
            for (role, _) in &self.world.roles {
                if *role == sender || *role == receiver {
                    known.bound.insert(*role);
                }
            }
        }
        format!("{sender} -> {receiver}.{}{arguments}", operation.name)
    }

    /// A device or a dynamic role.
    fn device(&mut self, known: &Known, must_be_bound: bool) -> &'static str {
        let roles: Vec<&'static str> = self
            .world
            .roles
            .iter()
            .map(|(role, _)| *role)
            .filter(|role| !must_be_bound || known.bound.contains(role))
            // A role that `bindings` bind is not for the initial message.
            .filter(|role| known.begun || !known.bound.contains(role))
            .collect();
        let devices = roles.is_empty() || !self.random.chance(35);
        let choices = if devices { &self.world.devices } else { &roles };
        let choice: &&str = self.random.pick(choices);
        choice
    }

    fn argument(&mut self, known: &mut Known, ty: Ty, may_bind: bool) -> String {
        let begun = known.begun;
        let fitting: Vec<usize> =
            (0..known.variables.len()).filter(|&index| ty.takes(known.variables[index].ty)).collect();
        if may_bind && !fitting.is_empty() && self.random.chance(50) {
            let variable = &mut known.variables[*self.random.pick(&fitting)];
            variable.is_set = true;
            return format!("bind {}", variable.name);
        }
        match self.random.below(10) {
            0..=2 => "*".to_string(),
            // Roles that `bindings` bind have no value when the initial message is looked at.
            3..=6 if begun => self.value(known, ty),
            _ => self.world.literal(self.random, ty),
        }
    }

    /// An expression of a type.
    fn value(&mut self, known: &Known, ty: Ty) -> String {
        let mut choices = vec![self.world.literal(self.random, ty)];
        choices.extend(
            known
                .variables
                .iter()
                .filter(|each| each.is_set && ty.takes(each.ty))
                .map(|each| each.name.clone()),
        );
        if let Some(attribute) = self.world.attributes.iter().find(|attribute| attribute.ty == ty) {
            choices.push(format!("{}.{}", self.owner(known), attribute.name));
        }
        if ty == Ty::Dev && known.begun {
            choices.extend(known.bound.iter().map(ToString::to_string));
        }
        if ty == Ty::Sub && known.begun && known.bound.contains("special") {
            choices.push("special".to_string());
        }
        self.random.pick(&choices).clone()
    }

    /// Something that has a device's attributes.
    fn owner(&mut self, known: &Known) -> String {
        let mut owners: Vec<String> = self.world.devices.iter().map(ToString::to_string).collect();
        if known.begun {
            owners.extend(known.bound.iter().map(ToString::to_string));
        }
        let owner = self.random.pick(&owners).clone();
        let has_link = self.world.attributes.iter().any(|attribute| attribute.ty == Ty::Dev);
        if has_link && self.random.chance(20) { format!("{owner}.link") } else { owner }
    }

    fn condition(&mut self, known: &Known) -> String {
        let first = self.comparison(known);
        match self.random.below(10) {
            0 => format!("{first} && {}", self.comparison(known)),
            1 => format!("{first} || {}", self.comparison(known)),
            2 => format!("{first} => {}", self.comparison(known)),
            3 => format!("!({first})"),
            _ => first,
        }
    }

    fn comparison(&mut self, known: &Known) -> String {
        let mut terms: Vec<(String, Ty)> = known
            .variables
            .iter()
            .filter(|each| each.is_set)
            .map(|each| (each.name.clone(), each.ty))
            .collect();
        for attribute in &self.world.attributes {
            terms.push((format!("{}.{}", self.owner(known), attribute.name), attribute.ty));
        }
        if terms.is_empty() {
            return self.random.pick(&["true", "false", "1 + 1 == 2"]).to_string();
        }
        let (term, ty) = self.random.pick(&terms).clone();
        match ty {
            Ty::Bool if self.random.chance(70) => self.random.pick(&["", "!"]).to_string() + &term,
            Ty::Int => {
                let operator = self.random.pick(&["<", "<=", ">", ">=", "==", "!="]);
                let right = self.random.pick(&["0", "1", "2", "-1 + 2"]);
                format!("{term} {operator} {right}")
            }
            _ => {
                let operator = self.random.pick(&["==", "!="]);
                format!("{term} {operator} {}", self.value(known, ty))
            }
        }
    }
}
