//! The rules of the schema of PLCopen XML 2.01, as far as textual programs without extensions need it: which elements in
//! which order, which attributes with what values.

use roxmltree::{Document, Node};

const NAMESPACE: &str = "http://www.plcopen.org/xml/tc6_0201";
const XHTML: &str = "http://www.w3.org/1999/xhtml";

/// The elementary types that are elements without content.
const ELEMENTARY: &str =
    "BOOL|BYTE|WORD|DWORD|LWORD|SINT|INT|DINT|LINT|USINT|UINT|UDINT|ULINT|REAL|LREAL|TIME|DATE|DT|TOD";

/// An element, its attributes (`!`: required), and its content: names in order (`?` at most one, `*` any number).
type Rule = (&'static str, &'static str, &'static str);

const RULES: &[Rule] = &[
    ("project", "", "fileHeader contentHeader types instances documentation?"),
    (
        "fileHeader",
        "companyName! companyURL productName! productVersion! productRelease creationDateTime! contentDescription",
        "",
    ),
    (
        "contentHeader",
        "name! version modificationDateTime organization author language",
        "Comment? coordinateInfo",
    ),
    ("coordinateInfo", "", "pageSize? fbd ld sfc"),
    ("fbd", "", "scaling"),
    ("ld", "", "scaling"),
    ("sfc", "", "scaling"),
    ("scaling", "x! y!", ""),
    ("types", "", "dataTypes pous"),
    ("dataTypes", "", "dataType*"),
    ("dataType", "name!", "baseType initialValue? documentation?"),
    ("pous", "", "pou*"),
    ("pou", "name! pouType! globalId", "interface? body* documentation?"),
    (
        "interface",
        "",
        "returnType? localVars|tempVars|inputVars|outputVars|inOutVars|externalVars|globalVars* documentation?",
    ),
    ("localVars", "name constant retain nonretain persistent nonpersistent", "variable* documentation?"),
    ("tempVars", "name constant retain nonretain persistent nonpersistent", "variable* documentation?"),
    ("inputVars", "name constant retain nonretain persistent nonpersistent", "variable* documentation?"),
    ("outputVars", "name constant retain nonretain persistent nonpersistent", "variable* documentation?"),
    ("inOutVars", "name constant retain nonretain persistent nonpersistent", "variable* documentation?"),
    ("variable", "name! address globalId", "type initialValue? documentation?"),
    ("type", "", "TYPE"),
    ("baseType", "", "TYPE"),
    ("returnType", "", "TYPE"),
    ("array", "", "dimension dimension* baseType"),
    ("dimension", "lower! upper!", ""),
    ("derived", "name!", ""),
    ("pointer", "", "baseType"),
    ("initialValue", "", "simpleValue|arrayValue"),
    ("simpleValue", "value", ""),
    ("arrayValue", "", "value*"),
    ("value", "repetitionValue", "simpleValue|arrayValue"),
    ("body", "WorksheetName globalId", "IL|ST documentation?"),
    ("instances", "", "configurations"),
    ("configurations", "", "configuration*"),
    ("configuration", "name! globalId", "resource* globalVars* documentation?"),
    ("resource", "name! globalId", "task* globalVars* pouInstance* documentation?"),
    ("task", "name! single interval priority! globalId", "pouInstance* documentation?"),
    ("pouInstance", "name! typeName! globalId", "documentation?"),
];

/// Whether a document is well-formed and keeps the rules; else, where it does not.
pub(super) fn check(xml: &str) -> Result<(), String> {
    let document = Document::parse(xml).map_err(|error| error.to_string())?;
    let root = document.root_element();
    if root.tag_name().name() != "project" {
        return Err(format!("{} is the root", root.tag_name().name()));
    }
    element(root)
}

fn element(node: Node<'_, '_>) -> Result<(), String> {
    let name = node.tag_name().name();
    let wrong = |what: &str| Err(format!("{name} {:?}: {what}", node.attribute("name").unwrap_or("")));
    if node.tag_name().namespace() != Some(NAMESPACE) {
        return wrong("is of another namespace");
    }
    if let "ST" | "IL" | "documentation" = name {
        return formatted_text(node);
    }
    if node.children().any(|child| child.is_text() && !child.text().unwrap_or("").trim().is_empty()) {
        return wrong("holds text");
    }
    let children: Vec<&str> = elements(node).map(|child| child.tag_name().name()).collect();
    if ELEMENTARY.split('|').any(|keyword| keyword == name) {
        return if children.is_empty() { Ok(()) } else { wrong("holds something") };
    }
    let Some((_, attributes, content)) = RULES.iter().find(|(rule, ..)| *rule == name) else {
        return wrong("is unknown");
    };
    attributes_fit(node, attributes).or_else(|what| wrong(&what))?;
    if !content_fits(&children, content) {
        return wrong(&format!("holds {children:?} instead of `{content}`"));
    }
    elements(node).try_for_each(element)
}

fn elements<'a, 'input>(node: Node<'a, 'input>) -> impl Iterator<Item = Node<'a, 'input>> {
    node.children().filter(Node::is_element)
}

/// One element of XHTML, whatever is in it.
fn formatted_text(node: Node<'_, '_>) -> Result<(), String> {
    let spaces: Vec<_> = elements(node).map(|child| child.tag_name().namespace()).collect();
    if spaces == [Some(XHTML)] { Ok(()) } else { Err(format!("{} is no text", node.tag_name().name())) }
}

fn attributes_fit(node: Node<'_, '_>, attributes: &str) -> Result<(), String> {
    let known: Vec<&str> = attributes.split_whitespace().collect();
    let missing = known.iter().filter_map(|name| name.strip_suffix('!'));
    if let Some(name) = missing.into_iter().find(|name| !node.has_attribute(*name)) {
        return Err(format!("has no {name}"));
    }
    for attribute in node.attributes() {
        let (name, value) = (attribute.name(), attribute.value());
        if !known.iter().any(|known| known.trim_end_matches('!') == name) {
            return Err(format!("has the unknown attribute {name}"));
        }
        if !value_fits(name, value) {
            return Err(format!("has {name} {value:?}"));
        }
    }
    Ok(())
}

fn value_fits(attribute: &str, value: &str) -> bool {
    match attribute {
        "constant" | "retain" | "nonretain" | "persistent" | "nonpersistent" => {
            ["true", "false", "1", "0"].contains(&value)
        }
        "pouType" => ["function", "functionBlock", "program"].contains(&value),
        "priority" => value.parse::<u16>().is_ok(),
        "x" | "y" => value.parse::<f64>().is_ok(),
        // Stricter than the schema, which takes any text.
        "repetitionValue" => value.parse::<u32>().is_ok_and(|repetitions| repetitions > 0),
        "creationDateTime" | "modificationDateTime" => {
            let digits_as_0 = value.replace(|c: char| c.is_ascii_digit(), "0");
            digits_as_0 == "0000-00-00T00:00:00"
        }
        _ => true,
    }
}

/// Whether names are those of a pattern, whose parts exclude each other.
fn content_fits(names: &[&str], pattern: &str) -> bool {
    let mut names = names.iter().peekable();
    for part in pattern.split_whitespace() {
        let alternatives = match part.trim_end_matches(['?', '*']) {
            "TYPE" => format!("{ELEMENTARY}|array|derived|pointer"),
            alternatives => alternatives.to_owned(),
        };
        let fits = |name: &&&str| alternatives.split('|').any(|alternative| alternative == **name);
        match part.chars().last() {
            Some('*') => while names.next_if(|name| fits(name)).is_some() {},
            Some('?') => _ = names.next_if(|name| fits(name)),
            _ if names.next_if(|name| fits(name)).is_none() => return false,
            _ => {}
        }
    }
    names.next().is_none()
}

/// A document with every sort of thing that the rules are about.
const SAMPLE: &str = r#"<project xmlns="http://www.plcopen.org/xml/tc6_0201">
<fileHeader companyName="" productName="p" productVersion="1" creationDateTime="1970-01-01T00:00:00"/>
<contentHeader name="n"><coordinateInfo>
<fbd><scaling x="1" y="1"/></fbd><ld><scaling x="1" y="1"/></ld><sfc><scaling x="1" y="1"/></sfc>
</coordinateInfo></contentHeader>
<types><dataTypes><dataType name="T"><baseType><array><dimension lower="0" upper="1"/><baseType><BOOL/></baseType></array></baseType></dataType></dataTypes>
<pous><pou name="F" pouType="function"><interface><returnType><INT/></returnType><localVars constant="true">
<variable name="v"><type><derived name="T"/></type><initialValue><arrayValue><value repetitionValue="2"><simpleValue value="0"/></value></arrayValue></initialValue></variable>
</localVars></interface><body><ST><xhtml xmlns="http://www.w3.org/1999/xhtml">x</xhtml></ST></body></pou></pous></types>
<instances><configurations><configuration name="C"><resource name="R"><task name="K" priority="1"><pouInstance name="M" typeName="F"/></task></resource></configuration></configurations></instances>
</project>"#;

#[test]
fn the_rules_take_a_document() {
    assert_eq!(check(SAMPLE), Ok(()));
}

#[test]
fn the_rules_notice_every_fault() {
    for (from, to) in [
        ("</project>", ""),
        ("tc6_0201", "tc6_0200"),
        ("http://www.w3.org/1999/xhtml", "http://example.org"),
        (r#" productName="p""#, ""),
        (r#" name="v""#, ""),
        (r#" priority="1""#, ""),
        (r#"priority="1""#, r#"priority="high""#),
        (r#"pouType="function""#, r#"pouType="Function""#),
        (r#"constant="true""#, r#"constant="TRUE""#),
        (r#"constant="true""#, r#"const="true""#),
        ("1970-01-01T00:00:00", "1970-01-01 00:00:00"),
        (r#"repetitionValue="2""#, r#"repetitionValue="0""#),
        ("<type><derived name=\"T\"/></type>", ""),
        ("<type><derived name=\"T\"/></type>", "<type/>"),
        ("<type><derived name=\"T\"/></type>", "<type><BOOL/><INT/></type>"),
        ("<type><derived name=\"T\"/></type>", "<type><Bool/></type>"),
        ("<returnType><INT/></returnType>", "<inputVars/><returnType><INT/></returnType>"),
        ("<dimension lower=\"0\" upper=\"1\"/>", ""),
        ("<simpleValue value=\"0\"/>", ""),
        ("<simpleValue value=\"0\"/>", "0"),
        ("<ST>", "<ST>y</ST><ST>"),
        ("<body>", "<documentation/><body>"),
        ("<fbd><scaling x=\"1\" y=\"1\"/></fbd><ld>", "<ld>"),
        ("<instances>", "<instances><configurations/>"),
        ("<task", "<pouInstance name=\"M\" typeName=\"F\"/><task"),
    ] {
        assert!(SAMPLE.contains(from), "{from}");
        assert!(check(&SAMPLE.replace(from, to)).is_err(), "{from} as {to}");
    }
}
