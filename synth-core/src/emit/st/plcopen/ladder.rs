//! Ladder diagrams in the form that tools exchange projects in: bodies of the language LD.
//!
//! The function block has the interface of [the Structured Text](crate::emit::st::scan), but no input `enable`: a call from a
//! ladder has `EN`. Every rung stands between rails of its own below a comment that says what it is for.
//!
//! # Connections
//!
//! A connection leads from where current goes to where it comes from, and several that lead to one place are in parallel. There
//! are no wires as such, so a condition that always holds is a coil at the rail.
//!
//! Tools evaluate the condition of a rung once, or once a coil. Both come to the same here: of the coils of a rung the ones
//! whose variable the condition reads are driven last, and where there are several, the condition goes through a variable of
//! its own first.
//!
//! Positions are in pixels, which is what editors take them for, and wires have all their bends. They stand on the grid of the [drawing in
//! text](crate::emit::scan::ladder).

use super::xml::{Attribute, Xml};
use super::{Dialect, NAMESPACE, headers, instances, pou_with, structured_text};
use crate::emit::scan::ladder::{drawn, places};
use crate::emit::scan::{Source, origin, rung_lines};
use crate::emit::st::names::Scope;
use crate::emit::st::scan::{Block, Names};
use crate::emit::st::unit::{Kind, Unit};
use crate::emit::st::writer::harmless;
use crate::logic::{Expr, Literal, Var};
use crate::plant::{Coil, Drive, Rung};

/// Pixels of a character.
const CHARACTER: usize = 8;
const COLUMN_GAP: usize = 40;
const ROW: usize = 50;
const LINE: usize = 20;
const MARGIN: usize = 20;
/// Size of a contact and of a coil.
const SYMBOL: (usize, usize) = (21, 15);
const BLOCK: (usize, usize) = (60, 60);
const RAIL_WIDTH: usize = 3;
/// How far before an input wires go up or down.
const BEND: usize = 10;

/// The whole document, ending in a newline, deterministic.
#[must_use]
pub fn document(source: &Source<'_>, dialect: Dialect) -> String {
    let block = Block::new(source, dialect.target());
    let mut header = origin(source, "State-feedback controller of", dialect.argument());
    header.extend(dialect.notes().iter().map(|&note| note.to_owned()));
    let mut xml = Xml::new(dialect.paragraph());
    xml.element("project", &[("xmlns", NAMESPACE)], |xml| {
        headers(xml, &source.program.name, source.provenance);
        xml.element("types", &[], |xml| {
            xml.empty("dataTypes", &[]);
            xml.element("pous", &[], |xml| {
                function_block(xml, &block, &header);
                program(xml, &block);
            });
        });
        instances(xml, &block.names.runner(), dialect);
    });
    xml.finish()
}

fn function_block(xml: &mut Xml, block: &Block<'_>, header: &[String]) {
    let networks = Networks::new(block);
    let mut declarations = block.interface(false);
    block.locals(&mut declarations);
    if !networks.own.is_empty() {
        declarations.section("VAR_TEMP", |out| {
            out.comment("Conditions of rungs");
            networks.own.iter().for_each(|name| out.variable(name, "BOOL"));
        });
    }
    let (kind, name, body) = (Kind::FunctionBlock, &block.names.function_block, Box::new(|_: &mut _| {}));
    let unit = Unit { comment: None, kind, name, declarations, body };
    let header: Vec<&str> = header.iter().map(String::as_str).collect();
    pou_with(xml, &unit, &header, |xml| xml.element("LD", &[], |xml| networks.draw(xml)));
}

/// The program calls the block and passes everything through, in Structured Text.
fn program(xml: &mut Xml, block: &Block<'_>) {
    let mut declarations = block.interface(false);
    declarations.section("VAR", |out| {
        let controller = block.target.dialect().frame.block_type(&block.names.function_block);
        out.variable(crate::emit::st::scan::INSTANCE, controller);
    });
    let body = Box::new(|out: &mut _| block.pass_through(out, false));
    let unit = Unit { comment: None, kind: Kind::Program, name: &block.names.program, declarations, body };
    pou_with(xml, &unit, &[], |xml| structured_text(xml, block.target.dialect().frame, &unit));
}

/// A rung as it is drawn: contacts and coils by their identifiers.
struct Network {
    comment: Vec<String>,
    condition: Condition,
    coils: Vec<(String, Drive)>,
}

enum Condition {
    /// Over [`Networks::variables`].
    Contacts(Expr),
    /// An analogue input between two numbers.
    Range(String, i64, i64),
}

/// All that is drawn.
struct Networks {
    /// Identifiers of the program's variables, then of those of the diagram.
    variables: Vec<String>,
    /// The latter alone.
    own: Vec<String>,
    all: Vec<Network>,
}

impl Networks {
    fn new(block: &Block<'_>) -> Networks {
        let source = block.source;
        let (_, mut scope) = Names::new(source, block.target);
        let mut networks =
            Networks { variables: block.names.variables.clone(), own: Vec::new(), all: Vec::new() };
        for (variable, analogue, low, high) in source.ranges() {
            let analogue = &block.names.analogues[analogue as usize];
            networks.all.push(Network {
                comment: vec![format!("Range {}: {analogue} from {low} to {high}", source.name(variable))],
                condition: Condition::Range(analogue.clone(), low, high),
                coils: vec![(networks.variables[variable as usize].clone(), Drive::Out)],
            });
        }
        for (number, rung) in (1..).zip(&source.program.rungs) {
            let comment = rung_lines(source, number, rung);
            if !rung.coils.is_empty() {
                networks.push(&mut scope, rung, comment);
            }
        }
        networks
    }

    fn push(&mut self, scope: &mut Scope, rung: &Rung, mut comment: Vec<String>) {
        let mut condition = drawn(&rung.condition, rung.coils[0].variable);
        let coils = match in_any_order(&condition, &rung.coils) {
            Some(coils) => coils,
            None => {
                let name = scope.claim("condition", "");
                let variable = self.variables.len() as Var;
                self.variables.push(name.clone());
                self.own.push(name.clone());
                let coils = vec![(name, Drive::Out)];
                self.all.push(Network {
                    comment: std::mem::take(&mut comment),
                    condition: Condition::Contacts(condition),
                    coils,
                });
                condition = Expr::Literal(Literal { variable, negated: false });
                rung.coils.clone()
            }
        };
        let coils =
            coils.iter().map(|coil| (self.variables[coil.variable as usize].clone(), coil.drive)).collect();
        self.all.push(Network { comment, condition: Condition::Contacts(condition), coils });
    }

    fn draw(&self, xml: &mut Xml) {
        let mut pen = Pen { xml, next_id: 1, top: MARGIN, variables: &self.variables };
        for network in &self.all {
            pen.network(network);
        }
    }
}

/// The coils so ordered that it makes no difference whether the condition is evaluated once or once a coil; `None` if there
/// is no such order, or if a variable is driven twice.
fn in_any_order(condition: &Expr, coils: &[Coil]) -> Option<Vec<Coil>> {
    let (mut last, mut first): (Vec<Coil>, Vec<Coil>) =
        coils.iter().partition(|coil| reads(condition, coil.variable));
    first.append(&mut last);
    let late = coils.iter().filter(|coil| reads(condition, coil.variable)).count();
    let twice =
        (1..coils.len()).any(|end| coils[..end].iter().any(|coil| coil.variable == coils[end].variable));
    (late <= 1 && !twice).then_some(first)
}

fn reads(expr: &Expr, variable: Var) -> bool {
    match expr {
        Expr::Constant(_) => false,
        Expr::Literal(literal) => literal.variable == variable,
        Expr::And(parts) | Expr::Or(parts) => parts.iter().any(|part| reads(part, variable)),
    }
}

/// Pixels from the left and from the top.
type Point = (usize, usize);

/// Where current comes from.
#[derive(Clone, Copy)]
struct Outlet {
    /// The element.
    id: usize,
    /// Which of its outputs, if it has several.
    output: Option<&'static str>,
    at: Point,
}

/// Draws networks one below the other.
struct Pen<'a> {
    xml: &'a mut Xml,
    next_id: usize,
    top: usize,
    variables: &'a [String],
}

impl Pen<'_> {
    fn id(&mut self) -> usize {
        self.next_id += 1;
        self.next_id - 1
    }

    fn network(&mut self, network: &Network) {
        self.comment(&network.comment);
        let (left, top) = (MARGIN, self.top);
        let (from, x, rows) = match &network.condition {
            Condition::Contacts(condition) => {
                let (places, (columns, rows)) = places(condition);
                let rail = self.id();
                self.rail("leftPowerRail", rail, left, &[]);
                let widths = self.widths(condition, &places, columns);
                let mut ends = vec![left + COLUMN_GAP];
                widths.iter().for_each(|width| ends.push(ends[ends.len() - 1] + width));
                let at: Vec<_> =
                    places.iter().map(|&(column, row)| (ends[column], top + row * ROW)).collect();
                let rail = Outlet { id: rail, output: None, at: (left + RAIL_WIDTH, top + SYMBOL.1 / 2) };
                let from = self.contacts(condition, vec![rail], &mut at.iter());
                (from, ends[columns], rows)
            }
            // Blocks are connected to variables, so there is no left rail.
            Condition::Range(analogue, low, high) => {
                let both = self.range(analogue, *low, *high, top);
                (vec![both], both.at.0 + COLUMN_GAP, 3)
            }
        };
        let width = network.coils.iter().map(|(name, _)| name.len() * CHARACTER).max().unwrap_or(0);
        let mut coils = Vec::new();
        for (row, (name, drive)) in network.coils.iter().enumerate() {
            coils.push(self.coil(name, *drive, (x, top + row * ROW), &from));
        }
        let id = self.id();
        self.rail("rightPowerRail", id, x + COLUMN_GAP + width.max(SYMBOL.0), &coils);
        self.top += rows.max(network.coils.len()) * ROW;
    }

    /// Per column how much room its longest name takes.
    fn widths(&self, condition: &Expr, places: &[(usize, usize)], columns: usize) -> Vec<usize> {
        let mut widths = vec![SYMBOL.0 + COLUMN_GAP; columns];
        let mut literals = Vec::new();
        collect(condition, &mut literals);
        for (literal, &(column, _)) in literals.iter().zip(places) {
            let name = &self.variables[literal.variable as usize];
            widths[column] = widths[column].max(name.len() * CHARACTER + COLUMN_GAP / 2);
        }
        widths
    }

    /// Draws contacts; what comes from their right ends is returned.
    fn contacts<'p>(
        &mut self,
        expr: &Expr,
        from: Vec<Outlet>,
        places: &mut impl Iterator<Item = &'p Point>,
    ) -> Vec<Outlet> {
        match expr {
            Expr::Constant(_) => from,
            Expr::Literal(literal) => {
                let at = places.next().copied().unwrap_or_default();
                vec![self.contact(*literal, at, &from)]
            }
            Expr::And(all) => all.iter().fold(from, |from, part| self.contacts(part, from, places)),
            Expr::Or(any) => any.iter().flat_map(|part| self.contacts(part, from.clone(), places)).collect(),
        }
    }

    fn contact(&mut self, literal: Literal, at: Point, from: &[Outlet]) -> Outlet {
        let name = self.variables[literal.variable as usize].clone();
        self.symbol("contact", &name, ("negated", if literal.negated { "true" } else { "false" }), at, from)
    }

    fn coil(&mut self, name: &str, drive: Drive, at: Point, from: &[Outlet]) -> Outlet {
        let storage = match drive {
            Drive::Set => "set",
            Drive::Reset => "reset",
            Drive::Out => "none",
        };
        self.symbol("coil", name, ("storage", storage), at, from)
    }

    fn symbol(
        &mut self,
        kind: &str,
        name: &str,
        modifier: Attribute<'_>,
        at: Point,
        from: &[Outlet],
    ) -> Outlet {
        let id = self.id();
        self.sized(kind, id, SYMBOL, &[modifier], |xml| {
            position(xml, "position", at);
            point_in(xml, at, (0, SYMBOL.1 / 2), from);
            point_out(xml, &[], (SYMBOL.0, SYMBOL.1 / 2));
            xml.plain("variable", name);
        });
        Outlet { id, output: None, at: (at.0 + SYMBOL.0, at.1 + SYMBOL.1 / 2) }
    }

    /// A rail as high as what is connected to it.
    fn rail(&mut self, kind: &str, id: usize, x: usize, from: &[Outlet]) {
        let top = self.top;
        let size = (RAIL_WIDTH, from.len().max(1) * ROW);
        self.sized(kind, id, size, &[], |xml| {
            position(xml, "position", (x, top));
            if kind == "leftPowerRail" {
                point_out(xml, &[("formalParameter", "")], (RAIL_WIDTH, SYMBOL.1 / 2));
            }
            for (row, coil) in from.iter().enumerate() {
                point_in(xml, (x, top), (0, row * ROW + SYMBOL.1 / 2), std::slice::from_ref(coil));
            }
        });
    }

    /// Two comparisons and their conjunction.
    fn range(&mut self, analogue: &str, low: i64, high: i64, top: usize) -> Outlet {
        let left = MARGIN + COLUMN_GAP;
        let numbers = [low, high].map(|number| number.to_string().len());
        let longest = numbers.into_iter().max().unwrap_or(0).max(analogue.len());
        let middle = left + (longest + 1) * CHARACTER + COLUMN_GAP;
        let mut comparison = |kind: &'static str, number: i64, y: usize| {
            let inputs = [analogue.to_owned(), number.to_string()];
            let mut line = y;
            let inputs = inputs.map(|expression| {
                line += LINE;
                self.in_variable(&expression, (left, line))
            });
            self.block(kind, (middle, y), &inputs)
        };
        let both = [comparison("GE", low, top), comparison("LE", high, top + 3 * ROW / 2)];
        self.block("AND", (middle + BLOCK.0 + COLUMN_GAP, top), &both)
    }

    fn in_variable(&mut self, expression: &str, at: Point) -> Outlet {
        let id = self.id();
        let size = (expression.len() * CHARACTER + CHARACTER, LINE);
        self.sized("inVariable", id, size, &[], |xml| {
            position(xml, "position", at);
            point_out(xml, &[], (size.0, LINE / 2));
            xml.plain("expression", expression);
        });
        Outlet { id, output: None, at: (at.0 + size.0, at.1 + LINE / 2) }
    }

    fn block(&mut self, kind: &str, at: Point, inputs: &[Outlet]) -> Outlet {
        let id = self.id();
        self.sized("block", id, BLOCK, &[("typeName", kind)], |xml| {
            position(xml, "position", at);
            xml.element("inputVariables", &[], |xml| {
                for (number, input) in (1..).zip(inputs) {
                    let name = format!("IN{number}");
                    xml.element("variable", &[("formalParameter", &name)], |xml| {
                        point_in(xml, at, (0, LINE / 2 + number * LINE), std::slice::from_ref(input));
                    });
                }
            });
            xml.empty("inOutVariables", &[]);
            xml.element("outputVariables", &[], |xml| {
                xml.element("variable", &[("formalParameter", "OUT")], |xml| {
                    point_out(xml, &[], (BLOCK.0, LINE / 2 + LINE));
                });
            });
        });
        Outlet { id, output: Some("OUT"), at: (at.0 + BLOCK.0, at.1 + LINE / 2 + LINE) }
    }

    /// A comment above a network; `top` moves below it.
    fn comment(&mut self, lines: &[String]) {
        if lines.is_empty() {
            return;
        }
        let longest = lines.iter().map(|line| line.chars().count()).max().unwrap_or(0);
        let size = ((longest + 2) * CHARACTER, lines.len() * LINE + LINE / 2);
        let (id, top) = (self.id(), self.top);
        self.sized("comment", id, size, &[], |xml| {
            position(xml, "position", (MARGIN, top));
            let lines: Vec<String> = lines.iter().map(|line| harmless(line)).collect();
            xml.element("content", &[], |xml| xml.text(&lines.join("\n")));
        });
        self.top += size.1 + LINE;
    }

    fn sized(
        &mut self,
        kind: &str,
        id: usize,
        (width, height): (usize, usize),
        attributes: &[Attribute<'_>],
        inside: impl FnOnce(&mut Xml),
    ) {
        let (id, width, height) = (id.to_string(), width.to_string(), height.to_string());
        let mut all = vec![("localId", id.as_str()), ("width", &width), ("height", &height)];
        all.extend(attributes);
        self.xml.element(kind, &all, inside);
    }
}

/// The literals of an expression as they are written.
fn collect(expr: &Expr, out: &mut Vec<Literal>) {
    match expr {
        Expr::Constant(_) => {}
        Expr::Literal(literal) => out.push(*literal),
        Expr::And(parts) | Expr::Or(parts) => parts.iter().for_each(|part| collect(part, out)),
    }
}

fn position(xml: &mut Xml, name: &str, (x, y): Point) {
    xml.empty(name, &[("x", &x.to_string()), ("y", &y.to_string())]);
}

fn point_out(xml: &mut Xml, attributes: &[Attribute<'_>], at: Point) {
    xml.on_a_line("connectionPointOut", attributes, |xml| position(xml, "relPosition", at));
}

/// Where current comes into an element that stands at `at`, with the wires.
///
/// A wire is a list of points from here to where current comes from. Some editors draw wires without points from one input to
/// another.
fn point_in(xml: &mut Xml, at: Point, relative: Point, from: &[Outlet]) {
    let here = (at.0 + relative.0, at.1 + relative.1);
    xml.element("connectionPointIn", &[], |xml| {
        position(xml, "relPosition", relative);
        for Outlet { id, output, at } in from {
            let id = id.to_string();
            let output = output.map(|output| ("formalParameter", output));
            let attributes: Vec<Attribute<'_>> =
                std::iter::once(("refLocalId", id.as_str())).chain(output).collect();
            // Up and down between the columns, right before this one.
            let bend = here.0 - BEND;
            let bends = [(bend, here.1), (bend, at.1)];
            let bends = if here.1 == at.1 { &[][..] } else { &bends };
            xml.on_a_line("connection", &attributes, |xml| {
                let points = std::iter::once(&here).chain(bends).chain([at]);
                points.for_each(|&point| position(xml, "position", point));
            });
        }
    });
}
