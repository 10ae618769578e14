//! PLCopen XML (TC6, version 2.01): the Structured Text of a controller in the form that tools exchange projects in.
//!
//! What is declared and done is that of [`text`](super::text): the same units, with declarations as elements and
//! statements as text. The comment at the top of the text is the documentation of the function block.
//!
//! # Time stamps
//!
//! The schema asks for the time of creation. It is always the first second of 1970, because the same input gives the
//! same bytes; what a file was made from is told by the input hash in its description.

mod interface;
pub mod ladder;
mod xml;

use super::block::Block;
use super::dialect::Frame;
use super::names::Runner;
use super::program::{self, configuration};
use super::unit::{Kind, Unit};
use super::writer::{Writer, harmless};
use super::{Options, Target, Unfit, header};
use crate::controller::tables::{Provenance, Tables};
use interface::data_type;
use xml::Xml;

const NAMESPACE: &str = "http://www.plcopen.org/xml/tc6_0201";
const CREATION: &str = "1970-01-01T00:00:00";

/// The Structured Text in the elements.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Dialect {
    /// That of [`Target::Iec`].
    #[default]
    Iec,
    /// That of [`Target::Codesys`].
    Codesys,
}

impl Dialect {
    /// The target whose Structured Text it is.
    #[must_use]
    pub fn target(self) -> Target {
        match self {
            Dialect::Iec => Target::Iec,
            Dialect::Codesys => Target::Codesys,
        }
    }

    /// As on the command line.
    fn argument(self) -> &'static str {
        match self {
            Dialect::Iec => "plcopen",
            Dialect::Codesys => "plcopen --dialect codesys",
        }
    }

    /// How to load the file.
    fn notes(self) -> &'static [&'static str] {
        match self {
            Dialect::Iec => &[],
            Dialect::Codesys => &[
                "Import it below an application (Project, Import PLCopenXML), and call the program from a task.",
            ],
        }
    }

    /// The element of XHTML that holds text; the schema takes any one. Beremiz and OpenPLC read `p` and nothing else.
    fn paragraph(self) -> &'static str {
        match self {
            Dialect::Iec => "p",
            Dialect::Codesys => "xhtml",
        }
    }

    /// The task's interval, which the schema leaves open: a literal of the standard, or as CODESYS writes it.
    fn interval(self) -> String {
        let milliseconds = configuration::INTERVAL_MS;
        match self {
            Dialect::Iec => format!("T#{milliseconds}ms"),
            Dialect::Codesys => format!("PT{}S", f64::from(milliseconds) / 1000.0),
        }
    }
}

/// The whole document, ending in a newline, deterministic; of the dialect, whatever the target of `options`.
///
/// # Errors
///
/// As [`text`](super::text).
pub fn document(tables: &Tables, dialect: Dialect, options: &Options) -> Result<String, Unfit> {
    let options = &Options { target: dialect.target(), ..*options };
    let block = Block { argument: dialect.argument(), ..Block::new(tables, options)? };
    let mut xml = Xml::new(dialect.paragraph());
    xml.element("project", &[("xmlns", NAMESPACE)], |xml| {
        headers(xml, &tables.specification, &tables.provenance);
        xml.element("types", &[], |xml| {
            data_types(xml, &block);
            xml.element("pous", &[], |xml| units(xml, &block, dialect));
        });
        instances(xml, &block.names.runner(), dialect);
    });
    Ok(xml.finish())
}

fn headers(xml: &mut Xml, name: &str, provenance: &Provenance) {
    let description = format!("Generated from {}, input hash {}", provenance.file, provenance.hash);
    let file = [
        ("companyName", ""),
        ("productName", "sml"),
        ("productVersion", env!("CARGO_PKG_VERSION")),
        ("creationDateTime", CREATION),
        ("contentDescription", &harmless(&description)),
    ];
    xml.empty("fileHeader", &file);
    xml.element("contentHeader", &[("name", name)], |xml| {
        xml.element("coordinateInfo", &[], |xml| {
            for language in ["fbd", "ld", "sfc"] {
                xml.on_a_line(language, &[], |xml| xml.empty("scaling", &[("x", "1"), ("y", "1")]));
            }
        });
    });
}

fn data_types(xml: &mut Xml, block: &Block<'_>) {
    xml.element("dataTypes", &[], |xml| {
        xml.element("dataType", &[("name", &block.names.events_type)], |xml| {
            xml.on_a_line("baseType", &[], |xml| data_type(xml, &block.events_array()));
        });
    });
}

fn units(xml: &mut Xml, block: &Block<'_>, dialect: Dialect) {
    let header = header::header(block, dialect.notes());
    for unit in block.units().iter().chain([&program::unit(block)]) {
        let lines = match unit.kind {
            Kind::FunctionBlock => header.lines.iter().map(String::as_str).collect(),
            Kind::Function(_) | Kind::Program => Vec::from_iter(unit.comment),
        };
        pou(xml, block, unit, &lines);
    }
}

fn pou(xml: &mut Xml, block: &Block<'_>, unit: &Unit<'_>, comment: &[&str]) {
    pou_with(xml, unit, comment, |xml| structured_text(xml, block.dialect().frame, unit));
}

/// A unit whose body is what `body` writes.
fn pou_with(xml: &mut Xml, unit: &Unit<'_>, comment: &[&str], body: impl FnOnce(&mut Xml)) {
    let (kind, returned) = match &unit.kind {
        Kind::Function(returned) => ("function", Some(returned)),
        Kind::FunctionBlock => ("functionBlock", None),
        Kind::Program => ("program", None),
    };
    xml.element("pou", &[("name", unit.name), ("pouType", kind)], |xml| {
        xml.element("interface", &[], |xml| {
            if let Some(returned) = returned {
                xml.on_a_line("returnType", &[], |xml| data_type(xml, returned));
            }
            for section in &unit.declarations.sections {
                interface::section(xml, section);
            }
        });
        xml.element("body", &[], body);
        documentation(xml, comment);
    });
}

/// The statements of a unit.
fn structured_text(xml: &mut Xml, frame: &dyn Frame, unit: &Unit<'_>) {
    let mut body = Writer::new(frame);
    (unit.body)(&mut body);
    xml.element("ST", &[], |xml| xml.text(&body.finish()));
}

/// Says nothing without any line. Tools show documentation as comments, so no line may end one.
fn documentation(xml: &mut Xml, lines: &[&str]) {
    if !lines.is_empty() {
        let lines: Vec<String> = lines.iter().map(|line| harmless(line)).collect();
        xml.element("documentation", &[], |xml| {
            xml.text(lines.join("\n").trim_end());
        });
    }
}

fn instances(xml: &mut Xml, runner: &Runner<'_>, dialect: Dialect) {
    use configuration::{INSTANCE, NAME, PRIORITY, RESOURCE, TASK};
    let interval = dialect.interval();
    let priority = PRIORITY.to_string();
    let task = [("name", TASK), ("interval", &interval), ("priority", &priority)];
    let instance = [("name", INSTANCE), ("typeName", runner.program)];
    xml.element("instances", &[], |xml| {
        xml.element("configurations", &[], |xml| {
            xml.element("configuration", &[("name", NAME)], |xml| {
                xml.element("resource", &[("name", RESOURCE)], |xml| {
                    xml.element("task", &task, |xml| xml.empty("pouInstance", &instance));
                });
            });
        });
    });
}
