//! Programs of rungs as Structured Text.
//!
//! A `FUNCTION_BLOCK <Plant>_Controller` does one scan a call, a `PROGRAM <Plant>_Main` passes its inputs and outputs
//! through, and what the target has for that runs it every 10 ms, all as for [tables](super::text). The block's inputs are
//! `enable : BOOL := TRUE`, every input of the plant and every analogue input (`INT`, or the first of `DINT` and `LINT` that
//! holds the ends of its ranges); its outputs are those of the plant, read back in the next call as they were left.
//! Memory is kept from call to call, beginning with its initial values. With `enable` FALSE nothing is done: outputs and
//! memory stay.

mod names;

use super::Target;
use super::dialect::Dialect;
use super::unit::{Declarations, Kind, Section, Type, Unit};
use super::writer::Writer;
use crate::emit::scan::formula::STRUCTURED;
use crate::emit::scan::{NameMap, Source, origin, rung_lines};
use crate::logic::{Expr, Var};
use crate::plant::{Coil, Drive, Rung, Use};
pub(super) use names::{ENABLE, INSTANCE, Names};

/// The whole text, ending in a newline, deterministic. [`Target::Case`] is as [`Target::Iec`]: there are no tables.
#[must_use]
pub fn text(source: &Source<'_>, target: Target) -> String {
    let block = Block::new(source, target);
    let Dialect { frame, notes, name, .. } = block.target.dialect();
    let mut out = Writer::new(*frame);
    for line in origin(source, "State-feedback controller of", name) {
        out.comment(&line);
    }
    notes.iter().for_each(|note| out.comment(note));
    out.comment("With enable FALSE nothing is done; outputs stay as they are.");
    out.gap();
    for unit in [block.function_block(), block.program()] {
        frame.unit(&mut out, &unit);
    }
    frame.configuration(&mut out, &block.names.runner());
    out.finish()
}

/// What signals are called in [`text`]'s output.
#[must_use]
pub fn names(source: &Source<'_>, target: Target) -> NameMap {
    let (Names { function_block, program, variables, analogues, .. }, _) = Names::new(source, target);
    NameMap { target: target.name(), function_block, program, variables, analogues, events: Vec::new() }
}

/// All that is known when a text is written.
pub(super) struct Block<'a> {
    pub(super) source: &'a Source<'a>,
    pub(super) target: Target,
    pub(super) names: Names,
}

impl<'a> Block<'a> {
    pub(super) fn new(source: &'a Source<'a>, target: Target) -> Block<'a> {
        let target = if target == Target::Case { Target::Iec } else { target };
        Block { source, target, names: Names::new(source, target).0 }
    }

    /// The block that does a scan.
    fn function_block(&self) -> Unit<'_> {
        let mut declarations = self.interface(true);
        self.locals(&mut declarations);
        Unit {
            comment: None,
            kind: Kind::FunctionBlock,
            name: &self.names.function_block,
            declarations,
            body: Box::new(|out| {
                // There is no empty list of statements.
                if self.has_statements() {
                    out.when("#enable", |out| self.scan(out));
                } else {
                    out.code("RETURN;");
                }
            }),
        }
    }

    fn has_statements(&self) -> bool {
        self.source.ranges().next().is_some()
            || self.source.program.rungs.iter().any(|rung| !rung.coils.is_empty())
    }

    /// The program that passes everything through.
    pub(super) fn program(&self) -> Unit<'_> {
        let mut declarations = self.interface(true);
        let controller = self.target.dialect().frame.block_type(&self.names.function_block);
        declarations.section("VAR", |out| out.variable(INSTANCE, controller));
        Unit {
            comment: None,
            kind: Kind::Program,
            name: &self.names.program,
            declarations,
            body: Box::new(|out| self.pass_through(out, true)),
        }
    }

    /// `VAR_INPUT` and `VAR_OUTPUT`; `enabled` if there is an input `enable`.
    pub(super) fn interface(&self, enabled: bool) -> Declarations {
        let mut declarations = Declarations::default();
        self.section(&mut declarations, "VAR_INPUT", |out| {
            if enabled {
                out.initialized(ENABLE, "BOOL", "TRUE");
            }
            self.variables(out, |usage| usage == Use::Input);
            for (index, name) in (0..).zip(&self.names.analogues) {
                out.variable(name, self.analogue(index));
            }
        });
        self.section(&mut declarations, "VAR_OUTPUT", |out| {
            self.variables(out, |usage| usage == Use::Output);
        });
        declarations
    }

    /// Memory, and what is computed in every call.
    pub(super) fn locals(&self, declarations: &mut Declarations) {
        self.section(declarations, "VAR", |out| self.variables(out, |usage| matches!(usage, Use::Memory(_))));
        self.section(declarations, "VAR_TEMP", |out| {
            self.variables(out, |usage| matches!(usage, Use::Scratch | Use::Range(..)));
        });
    }

    /// A section, unless nothing is in it: strict compilers want a variable in each.
    fn section(
        &self,
        declarations: &mut Declarations,
        keyword: &'static str,
        inside: impl FnOnce(&mut Section),
    ) {
        let mut section = Section { keyword, items: Vec::new() };
        inside(&mut section);
        if !section.items.is_empty() {
            declarations.sections.push(section);
        }
    }

    fn variables(&self, out: &mut Section, wanted: impl Fn(Use) -> bool) {
        for (variable, name) in self.source.program.variables.iter().zip(&self.names.variables) {
            if !wanted(variable.usage) {
                continue;
            }
            variable.doc.iter().for_each(|line| out.comment(line.trim()));
            match variable.usage {
                Use::Memory(true) => out.initialized(name, "BOOL", "TRUE"),
                Use::Memory(false) => out.initialized(name, "BOOL", "FALSE"),
                _ => out.variable(name, "BOOL"),
            }
        }
    }

    /// The narrowest type that holds the ends of all ranges of an analogue input.
    fn analogue(&self, analogue: u32) -> Type {
        let fits = |least: i64, greatest: i64| self.source.analogue_fits(analogue, least, greatest);
        Type::Elementary(if fits(i16::MIN.into(), i16::MAX.into()) {
            "INT"
        } else if fits(i32::MIN.into(), i32::MAX.into()) {
            "DINT"
        } else {
            "LINT"
        })
    }

    fn scan(&self, out: &mut Writer) {
        for (variable, analogue, low, high) in self.source.ranges() {
            let (name, analogue) = (self.name(variable), &self.names.analogues[analogue as usize]);
            out.code_in_parts(&[
                format!("#{name} :="),
                format!("(#{analogue} >= {low})"),
                format!("AND (#{analogue} <= {high});"),
            ]);
        }
        for (number, rung) in (1..).zip(&self.source.program.rungs) {
            rung_lines(self.source, number, rung).iter().for_each(|line| out.comment(line));
            self.rung(out, rung);
        }
    }

    fn rung(&self, out: &mut Writer, rung: &Rung) {
        let condition = self.formula(&rung.condition);
        match rung.coils.as_slice() {
            [] => out.comment("It commands nothing."),
            [Coil { variable, drive: Drive::Out }] => {
                assign(out, &format!("#{} :=", self.name(*variable)), condition, ";");
            }
            coils => {
                assign(out, "IF", condition, " THEN");
                out.indented(|out| {
                    coils.iter().for_each(|coil| self.drive(out, coil, coil.drive != Drive::Reset));
                });
                if coils.iter().any(|coil| coil.drive == Drive::Out) {
                    out.code("ELSE");
                    let outs = coils.iter().filter(|coil| coil.drive == Drive::Out);
                    out.indented(|out| outs.for_each(|coil| self.drive(out, coil, false)));
                }
                out.code("END_IF;");
            }
        }
    }

    fn drive(&self, out: &mut Writer, coil: &Coil, value: bool) {
        let value = if value { "TRUE" } else { "FALSE" };
        out.code(format_args!("#{} := {value};", self.name(coil.variable)));
    }

    fn name(&self, variable: Var) -> &str {
        &self.names.variables[variable as usize]
    }

    fn formula(&self, expr: &Expr) -> Vec<String> {
        STRUCTURED.parts(expr, &|variable| format!("#{}", self.name(variable)))
    }

    /// Calls the block, and copies its outputs.
    pub(super) fn pass_through(&self, out: &mut Writer, enabled: bool) {
        let of = |wanted: Use| {
            let variables = self.source.program.variables.iter().zip(&self.names.variables);
            variables.filter(move |(variable, _)| variable.usage == wanted).map(|(_, name)| name.as_str())
        };
        let enable = enabled.then_some(ENABLE);
        let analogues = self.names.analogues.iter().map(String::as_str);
        let inputs: Vec<&str> = enable.into_iter().chain(of(Use::Input)).chain(analogues).collect();
        if inputs.is_empty() {
            out.code(format_args!("#{INSTANCE}();"));
        } else {
            out.code(format_args!("#{INSTANCE}("));
            out.indented(|out| {
                for (index, input) in inputs.iter().enumerate() {
                    let end = if index + 1 == inputs.len() { ");" } else { "," };
                    out.code_in_parts(&[format!("{input} :="), format!("#{input}{end}")]);
                }
            });
        }
        for output in of(Use::Output) {
            out.code_in_parts(&[format!("#{output} :="), format!("#{INSTANCE}.{output};")]);
        }
    }
}

/// `before condition after`, on as many lines as it needs.
fn assign(out: &mut Writer, before: &str, mut condition: Vec<String>, after: &str) {
    if let Some(first) = condition.first_mut() {
        first.insert_str(0, &format!("{before} "));
    }
    if let Some(last) = condition.last_mut() {
        last.push_str(after);
    }
    out.code_in_parts(&condition);
}
