//! Reads ladder diagrams that are drawn with characters, and lets current flow in them.

use std::collections::BTreeMap;

/// A contact or coil between two pieces of wire.
#[derive(Debug)]
struct Element {
    symbol: String,
    name: String,
    left: usize,
    right: usize,
}

/// A rung: pieces of wire are numbers.
#[derive(Debug)]
pub(crate) struct Network {
    nodes: usize,
    rail: usize,
    right_rail: Vec<usize>,
    contacts: Vec<Element>,
    coils: Vec<Element>,
}

/// The networks of a text, in their order.
pub(crate) fn read(text: &str) -> Vec<Network> {
    let mut networks = Vec::new();
    let mut pages: Vec<Vec<Vec<char>>> = Vec::new();
    let mut finish = |pages: &mut Vec<Vec<Vec<char>>>| {
        if !pages.is_empty() {
            networks.push(network(&std::mem::take(pages)));
        }
    };
    for block in text.split("\n\n") {
        let lines: Vec<Vec<char>> =
            block.trim_end_matches('\n').split('\n').map(|line| line.chars().collect()).collect();
        let is_drawing = lines
            .get(1)
            .is_some_and(|line| matches!(line.first(), Some('|' | '>')) || line.starts_with(&[' ', ' ']))
            && lines[0].first().is_some_and(|first| matches!(first, '|' | ' '));
        let is_first = lines.get(1).is_some_and(|line| line.first() == Some(&'|'));
        if !is_drawing || is_first {
            finish(&mut pages);
        }
        if is_drawing {
            pages.push(lines);
        }
    }
    finish(&mut pages);
    networks
}

/// Disjoint sets.
struct Sets(Vec<usize>);

impl Sets {
    fn find(&mut self, x: usize) -> usize {
        let mut root = x;
        while self.0[root] != root {
            root = self.0[root];
        }
        self.0[x] = root;
        root
    }

    fn unite(&mut self, a: usize, b: usize) {
        let (a, b) = (self.find(a), self.find(b));
        self.0[a] = b;
    }
}

const SYMBOLS: [&str; 6] = ["| |", "|/|", "[ ]", "(S)", "(R)", "( )"];

fn symbol_at(line: &[char], at: usize) -> Option<String> {
    let text: String = line.get(at..at + 3)?.iter().collect();
    let wired = at > 0 && line[at - 1] == '-' && line.get(at + 3) == Some(&'-');
    (wired && SYMBOLS.contains(&text.as_str())).then_some(text)
}

fn network(pages: &[Vec<Vec<char>>]) -> Network {
    let width = pages.iter().flatten().map(Vec::len).max().expect("a line") + 1;
    let height = pages.iter().map(Vec::len).max().expect("a page") + 1;
    let at = |page: usize, line: usize, column: usize| (page * height + line) * width + column;
    let mut sets = Sets((0..pages.len() * width * height).collect());
    let (mut contacts, mut coils, mut right_rail) = (Vec::new(), Vec::new(), Vec::new());
    for (page, lines) in pages.iter().enumerate() {
        for (number, line) in lines.iter().enumerate() {
            let is_wires = number % 2 == 1;
            let vertical = |line: Option<&Vec<char>>, column: usize| {
                column > 0 && matches!(line.and_then(|line| line.get(column)), Some('|' | '+'))
            };
            let mut column = 0;
            while column < line.len() {
                if let Some(symbol) = is_wires.then(|| symbol_at(line, column)).flatten() {
                    let name = above(&lines[number - 1], column + 1);
                    let (left, right) = (at(page, number, column - 1), at(page, number, column + 3));
                    let list = if symbol.starts_with('(') { &mut coils } else { &mut contacts };
                    list.push(Element { symbol, name, left, right });
                    column += 3;
                    continue;
                }
                let is_end = column == 0 || column + 1 == line.len();
                let wire = |c: char| matches!(c, '-' | '+' | '>') || c == '|' && is_end;
                if is_wires {
                    let next = line.get(column + 1).copied();
                    let next_wire = next.is_some_and(|c| {
                        matches!(c, '-' | '+' | '>') || c == '|' && column + 2 == line.len()
                    });
                    if wire(line[column]) && next_wire {
                        sets.unite(at(page, number, column), at(page, number, column + 1));
                    }
                    if column > 0
                        && column + 1 == line.len()
                        && line[column] == '|'
                        && line[column - 1] == '-'
                    {
                        right_rail.push(at(page, number, column));
                    }
                }
                // Rails are no verticals of the rung: the left one is one node, the right one the end.
                let in_symbol = |line: &Vec<char>| {
                    (0..3).any(|back| column >= back && symbol_at(line, column - back).is_some())
                };
                let below = lines.get(number + 1);
                let is_rail = column + 1 == line.len()
                    && matches!(line.get(column), Some('|'))
                    && page + 1 == pages.len()
                    && below.is_none_or(|below| below.len() == line.len());
                if vertical(Some(line), column)
                    && vertical(below, column)
                    && !is_rail
                    && !below.is_some_and(in_symbol)
                {
                    sets.unite(at(page, number, column), at(page, number + 1, column));
                }
                column += 1;
            }
            // Where a wire goes on.
            if line.last() == Some(&'>') {
                assert_eq!(pages[page + 1][number].first(), Some(&'>'), "line {number}");
                sets.unite(at(page, number, line.len() - 1), at(page + 1, number, 0));
            }
        }
    }
    let renamed = |elements: Vec<Element>, sets: &mut Sets| -> Vec<Element> {
        let ends = |element: Element| Element {
            left: sets.find(element.left),
            right: sets.find(element.right),
            ..element
        };
        elements.into_iter().map(ends).collect()
    };
    let contacts = renamed(contacts, &mut sets);
    let coils = renamed(coils, &mut sets);
    let rail = sets.find(at(0, 1, 0));
    let right_rail = right_rail.into_iter().map(|node| sets.find(node)).collect();
    Network { nodes: sets.0.len(), rail, right_rail, contacts, coils }
}

/// The name whose middle is nearest to a column.
fn above(line: &[char], middle: usize) -> String {
    let text: String = line.iter().map(|&c| if c == '|' { ' ' } else { c }).collect();
    let mut best: Option<(usize, String)> = None;
    let mut start = 0;
    for piece in text.split("  ") {
        let name = piece.trim();
        let first = start + piece.len() - piece.trim_start().len();
        start += piece.len() + 2;
        let distance = (2 * first + name.len()).abs_diff(2 * middle + 1);
        if !name.is_empty() && best.as_ref().is_none_or(|(least, _)| distance < *least) {
            best = Some((distance, name.to_owned()));
        }
    }
    let (distance, name) = best.expect("a name");
    assert!(distance <= 3, "{name} is {distance} off in {text}");
    name
}

/// Does a scan.
pub(crate) fn run(networks: &[Network], bits: &mut BTreeMap<String, bool>, numbers: &BTreeMap<String, i64>) {
    for network in networks {
        let mut sets = Sets((0..network.nodes).collect());
        for contact in &network.contacts {
            let closed = match contact.symbol.as_str() {
                "| |" => bits[&contact.name],
                "|/|" => !bits[&contact.name],
                _ => compare(&contact.name, numbers),
            };
            if closed {
                sets.unite(contact.left, contact.right);
            }
        }
        let rail = sets.find(network.rail);
        // All coils hang at the same wire.
        let holds: Vec<bool> = network.coils.iter().map(|coil| sets.find(coil.left) == rail).collect();
        assert!(holds.iter().all(|&value| value == holds[0]));
        assert!(network.coils.iter().all(|coil| network.right_rail.contains(&coil.right)), "{network:?}");
        for (coil, holds) in network.coils.iter().zip(holds) {
            let bit = bits.get_mut(&coil.name).expect("a variable");
            match coil.symbol.as_str() {
                "(S)" => *bit |= holds,
                "(R)" => *bit &= !holds,
                _ => *bit = holds,
            }
        }
    }
}

fn compare(text: &str, numbers: &BTreeMap<String, i64>) -> bool {
    let words: Vec<&str> = text.split(' ').collect();
    let [name, operator, number] = words.as_slice() else { panic!("{text}") };
    let number: i64 = number.parse().expect("a number");
    if *operator == ">=" { numbers[*name] >= number } else { numbers[*name] <= number }
}
