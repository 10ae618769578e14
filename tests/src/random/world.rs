//! Classes, objects, operations and effects of a random specification.

use super::{Features, Random};
use std::fmt::Write as _;

/// Types that occur.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Ty {
    Bool,
    /// `0..=2`.
    Int,
    /// `enum Mode { red, green, blue }`.
    Mode,
    /// A device, never `null` unless errors are wanted.
    Dev,
    /// A device of the subclass, for variables only.
    Sub,
}

impl Ty {
    /// Whether a place of this type takes what has the other one.
    pub(super) fn takes(self, other: Ty) -> bool {
        self == other || (self == Ty::Dev && other == Ty::Sub)
    }

    pub(super) fn text(self) -> &'static str {
        match self {
            Ty::Bool => "bool",
            Ty::Int => "0..=2",
            Ty::Mode => "Mode",
            Ty::Dev => "Dev",
            Ty::Sub => "Sub",
        }
    }
}

/// An operation and its parameter, named `p`, if it has one.
#[derive(Clone, Debug)]
pub(super) struct Operation {
    pub(super) name: String,
    pub(super) parameter: Option<Ty>,
}

/// An attribute of all devices.
#[derive(Clone, Debug)]
pub(super) struct Attribute {
    pub(super) name: &'static str,
    pub(super) ty: Ty,
}

pub(super) struct World {
    pub(super) features: Features,
    /// Names of objects of class `Ctl`.
    pub(super) controllers: Vec<&'static str>,
    /// Names of objects of class `Dev` and `Sub`.
    pub(super) devices: Vec<&'static str>,
    pub(super) attributes: Vec<Attribute>,
    /// Of `Ctl`.
    pub(super) inputs: Vec<Operation>,
    /// Of `Dev`.
    pub(super) outputs: Vec<Operation>,
    /// Dynamic roles of class `Dev`, and of class `Sub`.
    pub(super) roles: Vec<(&'static str, &'static str)>,
    text: String,
}

const DEVICES: [&str; 3] = ["dev1", "dev2", "sub"];

impl World {
    pub(super) fn new(random: &mut Random, features: Features) -> World {
        let controllers = if random.chance(15) { vec!["ctl", "aux"] } else { vec!["ctl"] };
        let devices = DEVICES[..1 + random.weighted(&[(45, 0), (40, 1), (15, 2)])].to_vec();
        let mut attributes = Vec::new();
        for (chance, name, ty) in
            [(55, "on", Ty::Bool), (20, "level", Ty::Int), (20, "mode", Ty::Mode), (35, "link", Ty::Dev)]
        {
            let wanted = ty != Ty::Dev || features.bindings || features.channels;
            if random.chance(chance) && wanted && attributes.len() < 2 {
                attributes.push(Attribute { name, ty });
            }
        }
        let mut operations = |prefix: &str| -> Vec<Operation> {
            let count = 1 + random.weighted(&[(15, 0), (50, 1), (35, 2)]);
            (0..count)
                .map(|index| {
                    let parameter = features.parameters && random.chance(20);
                    let parameter = parameter.then(|| {
                        random.weighted(&[(3, Ty::Bool), (3, Ty::Int), (2, Ty::Mode), (2, Ty::Dev)])
                    });
                    Operation { name: format!("{prefix}{index}"), parameter }
                })
                .collect()
        };
        let inputs = operations("e");
        let outputs = operations("s");
        let mut roles = Vec::new();
        if features.dynamic {
            roles = vec![("any", "Dev"), ("other", "Dev")];
            if devices.contains(&"sub") {
                roles.push(("special", "Sub"));
            }
        }
        let mut world =
            World { features, controllers, devices, attributes, inputs, outputs, roles, text: String::new() };
        world.text = world.write(random);
        world
    }

    /// The sections before the collaboration.
    pub(super) fn text(&self) -> &str {
        &self.text
    }

    /// A literal of a type.
    pub(super) fn literal(&self, random: &mut Random, ty: Ty) -> String {
        match ty {
            Ty::Bool => random.pick(&["true", "false"]).to_string(),
            Ty::Int => random.below(3).to_string(),
            Ty::Mode => random.pick(&["red", "green", "blue", "Mode:red"]).to_string(),
            Ty::Dev => random.pick(&self.devices).to_string(),
            Ty::Sub => "sub".to_string(),
        }
    }

    fn write(&self, random: &mut Random) -> String {
        let mut text = String::from("  domain world {\n    enum Mode { red, green, blue }\n");
        let signature = |operation: &Operation| match operation.parameter {
            Some(ty) => format!("{}(p: {})", operation.name, ty.text()),
            None => format!("{}()", operation.name),
        };
        let signatures =
            |operations: &[Operation]| operations.iter().map(signature).collect::<Vec<_>>().join("  ");
        let fields: Vec<String> =
            self.attributes.iter().map(|each| format!("{}: {}  ", each.name, each.ty.text())).collect();
        _ = writeln!(text, "    class Ctl {{ {} }}", signatures(&self.inputs));
        _ = writeln!(text, "    class Dev {{ {}{} }}", fields.concat(), signatures(&self.outputs));
        _ = writeln!(text, "    class Sub : Dev {{ }}\n  }}");
        for name in &self.controllers {
            _ = writeln!(text, "  object {name}: Ctl");
        }
        for &name in &self.devices {
            let class = if name == "sub" { "Sub" } else { "Dev" };
            _ = writeln!(text, "  object {name}: {class}{}", self.initial_values(random));
        }
        text.push_str(&self.effects(random));
        text.push_str("  controllable { Ctl }\n");
        self.write_events(random, &mut text);
        text
    }

    fn initial_values(&self, random: &mut Random) -> String {
        let mut values = Vec::new();
        for attribute in &self.attributes {
            let must = attribute.ty == Ty::Dev && !self.features.errors;
            if must || random.chance(30) {
                values.push(format!("{}: {}", attribute.name, self.literal(random, attribute.ty)));
            }
        }
        if values.is_empty() { String::new() } else { format!(" {{ {} }}", values.join(", ")) }
    }

    fn effects(&self, random: &mut Random) -> String {
        let mut text = String::new();
        for (operations, class) in [(&self.inputs, "Ctl"), (&self.outputs, "Dev")] {
            for operation in operations {
                for attribute in &self.attributes {
                    if random.chance(30) {
                        text.push_str(&self.effect(random, operation, class, attribute));
                    }
                }
            }
        }
        if text.is_empty() { text } else { format!("  effects {{\n{text}  }}\n") }
    }

    /// An effect of an event between a controller and a device on an attribute of the device.
    fn effect(
        &self,
        random: &mut Random,
        operation: &Operation,
        class: &str,
        attribute: &Attribute,
    ) -> String {
        let device = if random.chance(60) { "Dev" } else { *random.pick(&self.devices) };
        let (sender, receiver, owner) =
            if class == "Ctl" { (device, "Ctl", "sender") } else { ("Ctl", device, "receiver") };
        let owner = if device != "Dev" && random.chance(30) { device } else { owner };
        let target = format!("{owner}.{}", attribute.name);
        let value = match (attribute.ty, operation.parameter) {
            (ty, Some(parameter)) if ty == parameter && random.chance(80) => "p".to_string(),
            (Ty::Bool, _) if random.chance(25) => format!("!{target}"),
            (Ty::Int, _) if self.features.errors && random.chance(40) => format!("{target} + 1"),
            (Ty::Dev, _) if self.features.errors && random.chance(30) => "null".to_string(),
            (ty, _) => self.literal(random, ty),
        };
        let parameters = if operation.parameter.is_some() { "p" } else { "" };
        format!("    {sender} -> {receiver}.{}({parameters}) {{ {target} = {value} }}\n", operation.name)
    }

    fn write_events(&self, random: &mut Random, text: &mut String) {
        if self.features.non_spontaneous {
            let mut listed: Vec<String> = self
                .inputs
                .iter()
                // The first one happens by itself, so that something does.
                .skip(1)
                .filter(|_| random.chance(50))
                .map(|operation| format!("Ctl.{}", operation.name))
                .collect();
            for attribute in &self.attributes {
                if self.features.parameters && random.chance(50) {
                    let (first, rest) = attribute.name.split_at(1);
                    listed.push(format!("Dev.set{}{rest}", first.to_uppercase()));
                }
            }
            if !listed.is_empty() {
                _ = writeln!(text, "  non-spontaneous events {{ {} }}", listed.join(" "));
            }
        }
        if self.features.ranges {
            let mut ranges = String::new();
            for (operations, class) in [(&self.inputs, "Ctl"), (&self.outputs, "Dev")] {
                for operation in operations {
                    let Some(ty) = operation.parameter else { continue };
                    if random.chance(40) {
                        let span = match ty {
                            Ty::Int => random.pick(&["0..1", "1..=2", "0, 2"]).to_string(),
                            _ => self.literal(random, ty),
                        };
                        _ = write!(ranges, " {class}.{}(p = [{span}])", operation.name);
                    }
                }
            }
            if !ranges.is_empty() {
                _ = writeln!(text, "  parameter ranges {{{ranges} }}");
            }
        }
        if self.features.channels
            && random.chance(20)
            && self.attributes.iter().any(|each| each.ty == Ty::Dev)
        {
            // Only devices have references, so only what devices send to devices has channels.
            for attribute in &self.attributes {
                let (first, rest) = attribute.name.split_at(1);
                if random.chance(50) {
                    let event = format!("Dev.set{}{rest}", first.to_uppercase());
                    _ = writeln!(text, "  channels {{ {event} over Dev.link }}");
                }
            }
        }
    }
}
