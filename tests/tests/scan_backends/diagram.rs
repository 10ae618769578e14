//! Reads ladder diagrams of PLCopen XML, and evaluates them by following connections.

use std::collections::BTreeMap;

use roxmltree::{Document, Node};

/// An element by its `localId`.
#[derive(Debug)]
enum Element {
    Rail,
    Contact { name: String, negated: bool, from: Vec<usize> },
    Number(String),
    Block { kind: String, inputs: Vec<Vec<usize>> },
    Coil { name: String, storage: String, from: Vec<usize> },
    End,
}

/// A diagram.
#[derive(Debug)]
pub(crate) struct Diagram {
    elements: BTreeMap<usize, Element>,
    /// In the order of execution.
    coils: Vec<usize>,
}

fn child<'a>(node: Node<'a, 'a>, name: &str) -> Option<Node<'a, 'a>> {
    node.children().find(|child| child.has_tag_name(name) || child.tag_name().name() == name)
}

fn connections(node: Node<'_, '_>) -> Vec<usize> {
    let points = node.descendants().filter(|node| node.tag_name().name() == "connection");
    points.map(|node| node.attribute("refLocalId").expect("an origin").parse().expect("a number")).collect()
}

/// Reads the body of the function block.
///
/// Coils are in the order of the document, which must be that of their positions: from top to bottom, then left to right.
pub(crate) fn read(xml: &str) -> Diagram {
    let document = Document::parse(xml).expect("XML");
    let body = document.descendants().find(|node| node.tag_name().name() == "LD").expect("a ladder");
    let mut diagram = Diagram { elements: BTreeMap::new(), coils: Vec::new() };
    let mut last = (0, 0);
    wires_are_drawn(body);
    for node in body.children().filter(Node::is_element) {
        let id: usize = node.attribute("localId").expect("an id").parse().expect("a number");
        let text = |name: &str| child(node, name).and_then(|node| node.text()).expect("text").to_owned();
        let from = || child(node, "connectionPointIn").map(connections).expect("a connection");
        let element = match node.tag_name().name() {
            "comment" => continue,
            "leftPowerRail" => Element::Rail,
            "rightPowerRail" => {
                assert!(connections(node).iter().all(|id| diagram.coils.contains(id)));
                Element::End
            }
            "contact" => Element::Contact {
                name: text("variable"),
                negated: node.attribute("negated") == Some("true"),
                from: from(),
            },
            "inVariable" => Element::Number(text("expression")),
            "block" => {
                let inputs = child(node, "inputVariables").expect("inputs");
                let inputs = inputs.children().filter(Node::is_element).map(connections).collect();
                Element::Block { kind: node.attribute("typeName").expect("a type").to_owned(), inputs }
            }
            "coil" => {
                let position = child(node, "position").expect("a position");
                let coordinate = |name| position.attribute(name).expect("a place").parse().expect("a number");
                let place: (usize, usize) = (coordinate("y"), coordinate("x"));
                assert!(place > last, "coils are in the order of their positions");
                last = place;
                diagram.coils.push(id);
                let storage = node.attribute("storage").unwrap_or("none").to_owned();
                Element::Coil { name: text("variable"), storage, from: from() }
            }
            other => panic!("{other}"),
        };
        assert!(diagram.elements.insert(id, element).is_none(), "ids are unique");
    }
    diagram
}

fn point(node: Node<'_, '_>) -> (usize, usize) {
    let [x, y] = ["x", "y"].map(|name| node.attribute(name).expect("a place").parse().expect("a number"));
    (x, y)
}

/// Wires lead from where an element is fed to an output of what feeds it, leftwards, up and down.
fn wires_are_drawn(body: Node<'_, '_>) {
    let elements: Vec<Node<'_, '_>> = body.children().filter(Node::is_element).collect();
    let ends = |node: Node<'_, '_>, kind: &str| -> Vec<(usize, usize)> {
        let (x, y) = child(node, "position").map(point).expect("a position");
        let points = node.descendants().filter(|node| node.tag_name().name() == kind);
        let relative = points.map(|node| child(node, "relPosition").map(point).expect("a position"));
        relative.map(|(right, down)| (x + right, y + down)).collect()
    };
    for &element in &elements {
        let inputs = element.descendants().filter(|node| node.tag_name().name() == "connectionPointIn");
        for (input, here) in inputs.zip(ends(element, "connectionPointIn")) {
            for wire in input.children().filter(|node| node.tag_name().name() == "connection") {
                let from =
                    elements.iter().find(|other| other.attribute("localId") == wire.attribute("refLocalId"));
                let outputs = ends(*from.expect("an element"), "connectionPointOut");
                let points: Vec<_> = wire.children().filter(Node::is_element).map(point).collect();
                assert_eq!(points[0], here);
                assert!(outputs.contains(&points[points.len() - 1]), "{outputs:?} {points:?}");
                for pair in points.windows(2) {
                    let [(x, y), (next_x, next_y)] = [pair[0], pair[1]];
                    assert!(y == next_y && next_x < x || x == next_x && y != next_y, "{points:?}");
                }
            }
        }
    }
}

impl Diagram {
    /// Does a scan. The condition of a rung is evaluated once a coil, or once for all coils that hang at the same place.
    pub(crate) fn run(&self, bits: &mut BTreeMap<String, bool>, numbers: &BTreeMap<String, i64>, once: bool) {
        let mut found: Option<(&[usize], bool)> = None;
        for coil in &self.coils {
            let Element::Coil { name, storage, from } = &self.elements[coil] else { panic!("a coil") };
            let power = match found {
                Some((place, power)) if once && place == from.as_slice() => power,
                _ => from.iter().any(|&id| self.power(id, bits, numbers)),
            };
            // Rungs have rails of their own, so coils of another never hang at the same place, but for the rail itself.
            found = Some((from, power));
            let bit = bits.get_mut(name).expect("a variable");
            match storage.as_str() {
                "set" => *bit |= power,
                "reset" => *bit &= !power,
                _ => *bit = power,
            }
        }
    }

    fn power(&self, id: usize, bits: &BTreeMap<String, bool>, numbers: &BTreeMap<String, i64>) -> bool {
        let any = |from: &[usize]| from.iter().any(|&id| self.power(id, bits, numbers));
        match &self.elements[&id] {
            Element::Rail => true,
            Element::Contact { name, negated, from } => bits[name] != *negated && any(from),
            Element::Block { kind, inputs } => match kind.as_str() {
                "AND" => inputs.iter().all(|from| any(from)),
                "GE" => self.number(&inputs[0], numbers) >= self.number(&inputs[1], numbers),
                "LE" => self.number(&inputs[0], numbers) <= self.number(&inputs[1], numbers),
                other => panic!("{other}"),
            },
            other => panic!("no current comes from {other:?}"),
        }
    }

    fn number(&self, from: &[usize], numbers: &BTreeMap<String, i64>) -> i64 {
        let [id] = from else { panic!("one number") };
        let Element::Number(text) = &self.elements[id] else { panic!("a number") };
        text.parse().unwrap_or_else(|_| numbers[text])
    }

    /// The variables of all coils.
    pub(crate) fn driven(&self) -> impl Iterator<Item = &str> {
        self.elements.values().filter_map(|element| match element {
            Element::Coil { name, .. } => Some(name.as_str()),
            _ => None,
        })
    }
}
