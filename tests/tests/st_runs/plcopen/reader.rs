//! Reads the Structured Text out of PLCopen XML, as a tool that imports it would.

use std::fmt::Write as _;

use roxmltree::{Document, Node};

/// The text of a document that keeps to the schema; documentation becomes comments.
pub(super) fn structured_text(xml: &str) -> String {
    let document = Document::parse(xml).expect("well-formed");
    let mut out = String::new();
    for node in document.descendants().filter(Node::is_element) {
        let name = node.attribute("name").unwrap_or_default();
        match node.tag_name().name() {
            "dataType" => {
                let of = data_type(child(node, "baseType").expect("a type"));
                let _ = writeln!(out, "TYPE {name} : {of}; END_TYPE");
            }
            "pou" => unit(&mut out, node),
            "configuration" => configuration(&mut out, node),
            _ => {}
        }
    }
    out
}

/// Words and signs of a text, without comments.
pub(super) fn tokens(text: &str) -> Vec<String> {
    let mut tokens: Vec<String> = Vec::new();
    let parts = text.split("(*").enumerate();
    for part in
        parts.map(|(index, part)| if index == 0 { part } else { part.split_once("*)").expect("an end").1 })
    {
        let mut in_word = false;
        for c in part.chars() {
            let is_word = c.is_ascii_alphanumeric() || c == '_';
            match tokens.last_mut() {
                Some(word) if in_word && is_word => word.push(c),
                _ if !c.is_whitespace() => tokens.push(c.to_string()),
                _ => {}
            }
            in_word = is_word;
        }
    }
    tokens
}

fn child<'a, 'input>(node: Node<'a, 'input>, name: &str) -> Option<Node<'a, 'input>> {
    children(node).find(|child| child.has_tag_name(name))
}

fn children<'a, 'input>(node: Node<'a, 'input>) -> impl Iterator<Item = Node<'a, 'input>> {
    node.children().filter(Node::is_element)
}

/// The type in `type`, `baseType` or `returnType`.
fn data_type(node: Node<'_, '_>) -> String {
    let of = children(node).next().expect("a type");
    let base = || data_type(child(of, "baseType").expect("a base type"));
    match of.tag_name().name() {
        "derived" => of.attribute("name").expect("a name").to_owned(),
        "pointer" => format!("POINTER TO {}", base()),
        "array" => {
            let limits = child(of, "dimension").expect("limits");
            let limit = |name| limits.attribute(name).expect("a limit");
            format!("ARRAY [{}..{}] OF {}", limit("lower"), limit("upper"), base())
        }
        elementary => elementary.to_owned(),
    }
}

fn unit(out: &mut String, pou: Node<'_, '_>) {
    let keyword = match pou.attribute("pouType") {
        Some("function") => "FUNCTION",
        Some("functionBlock") => "FUNCTION_BLOCK",
        _ => "PROGRAM",
    };
    comment(out, pou);
    let interface = child(pou, "interface").expect("an interface");
    let returned = child(interface, "returnType").map(|of| format!(" : {}", data_type(of)));
    let name = pou.attribute("name").expect("a name");
    let _ = writeln!(out, "{keyword} {name}{}", returned.unwrap_or_default());
    for list in children(interface) {
        let section = match list.tag_name().name() {
            "inputVars" => "VAR_INPUT",
            "outputVars" => "VAR_OUTPUT",
            "localVars" => "VAR",
            _ => continue,
        };
        out.push_str(section);
        for qualifier in list.attributes() {
            let _ = write!(out, " {}", qualifier.name().to_uppercase());
        }
        out.push('\n');
        children(list).filter(|node| node.has_tag_name("variable")).for_each(|node| variable(out, node));
        out.push_str("END_VAR\n");
    }
    let body = child(pou, "body").and_then(|body| child(body, "ST")).expect("Structured Text");
    out.push_str(formatted(body));
    let _ = writeln!(out, "END_{keyword}");
}

fn variable(out: &mut String, node: Node<'_, '_>) {
    comment(out, node);
    let name = node.attribute("name").expect("a name");
    let _ = write!(out, "{name} : {}", data_type(child(node, "type").expect("a type")));
    if let Some(initial) = child(node, "initialValue") {
        let _ = write!(out, " := {}", value(initial));
    }
    out.push_str(";\n");
}

/// A value as a literal; repetitions are written out.
fn value(node: Node<'_, '_>) -> String {
    let of = children(node).next().expect("a value");
    if of.has_tag_name("simpleValue") {
        return of.attribute("value").expect("a literal").to_owned();
    }
    let elements = children(of).flat_map(|element| {
        let repetitions = element.attribute("repetitionValue").map_or(1, |n| n.parse().expect("a number"));
        std::iter::repeat_n(value(element), repetitions)
    });
    format!("[{}]", elements.collect::<Vec<_>>().join(", "))
}

fn comment(out: &mut String, node: Node<'_, '_>) {
    if let Some(documentation) = child(node, "documentation") {
        let _ = writeln!(out, "(* {} *)", formatted(documentation));
    }
}

/// The text in `ST` or `documentation`.
fn formatted<'a>(node: Node<'a, '_>) -> &'a str {
    children(node).next().and_then(|text| text.text()).unwrap_or_default()
}

fn configuration(out: &mut String, node: Node<'_, '_>) {
    let resource = child(node, "resource").expect("a resource");
    let task = child(resource, "task").expect("a task");
    let instance = child(task, "pouInstance").expect("an instance");
    let name = |node: Node<'_, '_>| node.attribute("name").expect("a name").to_owned();
    let _ = writeln!(out, "CONFIGURATION {} RESOURCE {} ON PLC", name(node), name(resource));
    let interval = duration(task.attribute("interval").expect("an interval"));
    let priority = task.attribute("priority").expect("a priority");
    let _ = writeln!(out, "TASK {}(INTERVAL := {interval}, PRIORITY := {priority});", name(task));
    let program = instance.attribute("typeName").expect("a program");
    let _ = writeln!(out, "PROGRAM {} WITH {} : {program};", name(instance), name(task));
    out.push_str("END_RESOURCE END_CONFIGURATION\n");
}

/// A literal of the standard, also from a duration of XML in seconds, which CODESYS writes.
fn duration(text: &str) -> String {
    match text.strip_prefix("PT").and_then(|rest| rest.strip_suffix('S')) {
        Some(seconds) => format!("T#{}ms", seconds.parse::<f64>().expect("seconds") * 1000.0),
        None => text.to_owned(),
    }
}
