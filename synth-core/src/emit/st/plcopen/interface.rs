//! Declarations as elements.

use super::documentation;
use super::xml::{Attribute, Xml};
use crate::emit::st::unit::{Item, Section, Type, Value};

/// Nobody reads them; lines end for the sake of editors.
const VALUES_PER_LINE: usize = 8;

/// The variables of a section.
pub(super) fn section(xml: &mut Xml, section: &Section) {
    let mut words = section.keyword.split(' ');
    let list = match words.next() {
        Some("VAR_INPUT") => "inputVars",
        Some("VAR_OUTPUT") => "outputVars",
        Some("VAR_IN_OUT") => "inOutVars",
        Some("VAR_TEMP") => "tempVars",
        _ => "localVars",
    };
    // `CONSTANT`, `RETAIN`, `NON_RETAIN` and `PERSISTENT` are attributes of these names.
    let qualifiers: Vec<String> = words.map(|word| word.replace('_', "").to_lowercase()).collect();
    let qualifiers: Vec<Attribute<'_>> = qualifiers.iter().map(|name| (name.as_str(), "true")).collect();
    xml.element(list, &qualifiers, |xml| {
        let mut comments = Vec::new();
        for item in &section.items {
            match item {
                Item::Comment(text) => comments.push(text.as_str()),
                Item::Variable { name, of, initial } => {
                    variable(xml, name, of, initial.as_ref(), &std::mem::take(&mut comments));
                }
            }
        }
        documentation(xml, &comments);
    });
}

fn variable(xml: &mut Xml, name: &str, of: &Type, initial: Option<&Value>, comments: &[&str]) {
    xml.element("variable", &[("name", name)], |xml| {
        xml.on_a_line("type", &[], |xml| data_type(xml, of));
        match initial {
            Some(Value::Simple(value)) => xml.on_a_line("initialValue", &[], |xml| simple(xml, value)),
            Some(Value::Array(values)) => {
                xml.element("initialValue", &[], |xml| {
                    xml.element("arrayValue", &[], |xml| array(xml, values));
                });
            }
            None => {}
        }
        documentation(xml, comments);
    });
}

fn simple(xml: &mut Xml, value: &str) {
    xml.empty("simpleValue", &[("value", value)]);
}

/// Runs of equal values, several a line.
fn array(xml: &mut Xml, values: &[u32]) {
    let runs: Vec<&[u32]> = values.chunk_by(|a, b| a == b).collect();
    for line in runs.chunks(VALUES_PER_LINE) {
        xml.together(|xml| line.iter().for_each(|run| value(xml, run)));
    }
}

fn value(xml: &mut Xml, run: &[u32]) {
    let repetitions = run.len().to_string();
    let attributes = [("repetitionValue", repetitions.as_str())];
    let attributes = if run.len() > 1 { &attributes[..] } else { &[] };
    xml.element("value", attributes, |xml| simple(xml, &run[0].to_string()));
}

/// The element of a type.
pub(super) fn data_type(xml: &mut Xml, of: &Type) {
    match of {
        Type::Elementary(keyword) => xml.empty(keyword, &[]),
        Type::Derived(name) => xml.empty("derived", &[("name", name)]),
        Type::Array { last, element } => xml.element("array", &[], |xml| {
            xml.empty("dimension", &[("lower", "0"), ("upper", &last.to_string())]);
            xml.element("baseType", &[], |xml| data_type(xml, element));
        }),
        Type::Pointer(target) => xml.element("pointer", &[], |xml| {
            xml.element("baseType", &[], |xml| data_type(xml, target));
        }),
    }
}
