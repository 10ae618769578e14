//! The function block: interface, and what a call does around the layout's own statements.

use super::dialect::Dialect;
use super::integer::{Integer, Types};
use super::layout::Layout;
use super::names::{EventNames, Names, OutputNames, STATE_NO};
use super::owed::{OWED, Owed};
use super::unit::{Declarations, Kind, Section, Type, Unit};
use super::writer::Writer;
use super::{Options, Trigger, Unexpected, Unfit, fit, retain};
use crate::controller::runs::Runs;
use crate::controller::tables::{Mapping, Tables};

/// All that is known when a text is written.
pub(super) struct Block<'a> {
    pub(super) tables: &'a Tables,
    pub(super) options: &'a Options,
    /// The target as on the command line.
    pub(super) argument: &'static str,
    pub(super) names: Names,
    pub(super) types: Types,
    pub(super) runs: Runs,
    /// What the environment owes, if somebody wants to know and it ever owes something.
    pub(super) owed: Option<Owed>,
}

impl<'a> Block<'a> {
    /// # Errors
    ///
    /// What the target cannot hold.
    pub(super) fn new(tables: &'a Tables, options: &'a Options) -> Result<Block<'a>, Unfit> {
        fit::check(tables, options)?;
        let runs = Runs::of(tables);
        let layout = options.target.dialect().layout(options.encoding);
        let owed = options.owed.then(|| Owed::new(&tables.owed)).filter(|owed| !owed.is_empty());
        let types = Types::of(tables, options.integers, layout.largest_index(tables, &runs), owed.as_ref())?;
        let (argument, names) = (options.target.name(), Names::new(tables, options.target));
        Ok(Block { tables, options, argument, names, types, runs, owed })
    }
}

impl Block<'_> {
    /// The functions of the layout, and the function block.
    pub(super) fn units(&self) -> Vec<Unit<'_>> {
        let layout = self.layout();
        let mut declarations = Declarations::default();
        self.interface(&mut declarations, true);
        layout.tables(&mut declarations, self);
        if let Some(owed) = &self.owed {
            let constants = self.dialect().frame.constants();
            declarations.section(constants, |out| owed.tables(out, self.types.owed));
        }
        self.variables(&mut declarations);
        let mut units = layout.functions(self);
        units.push(Unit {
            comment: None,
            kind: Kind::FunctionBlock,
            name: &self.names.function_block,
            declarations,
            body: Box::new(|out| self.call(out)),
        });
        units
    }

    pub(super) fn dialect(&self) -> &'static Dialect {
        self.options.target.dialect()
    }

    pub(super) fn layout(&self) -> &'static dyn Layout {
        self.dialect().layout(self.options.encoding)
    }

    /// The events that occur in some row, with their indices.
    pub(super) fn events(&self) -> impl Iterator<Item = (usize, &Mapping, &EventNames, &str)> {
        let tables = self.tables.events.iter().zip(&self.names.events).enumerate();
        tables
            .filter(|(_, (table, _))| !table.mapping.source.is_empty())
            .map(|(index, (table, names))| (index, &table.mapping, names, table.event.text.as_str()))
    }

    /// Whether an event can ever be consumed.
    pub(super) fn has_rows(&self) -> bool {
        self.events().next().is_some()
    }

    pub(super) fn has_super_steps(&self) -> bool {
        !self.tables.super_steps.source.is_empty()
    }

    /// A drain without super steps is one cycle.
    pub(super) fn drains(&self) -> bool {
        self.options.drain && self.has_super_steps()
    }

    /// Per component its names and the type of its codes.
    pub(super) fn components(&self) -> impl Iterator<Item = (&OutputNames, Integer)> {
        self.names.components.iter().zip(self.types.codes.iter().copied())
    }

    /// The last index of `pending`, which has one element at least.
    fn last_event(&self) -> usize {
        self.names.events.len().saturating_sub(1)
    }

    /// What the type of `pending` stands for.
    pub(super) fn events_array(&self) -> Type {
        Type::array(self.last_event(), "BOOL")
    }

    pub(super) fn events_type(&self) -> Type {
        self.dialect().frame.events_type(&self.names, self.events_array())
    }

    /// `VAR_INPUT` and `VAR_OUTPUT` of the function block and, without initial values, of the program.
    pub(super) fn interface(&self, out: &mut Declarations, initial: bool) {
        out.section("VAR_INPUT", |out| {
            out.initialized("enable", "BOOL", "TRUE");
            out.variable("reset", "BOOL");
            for event in &self.names.events {
                out.variable(&event.input, "BOOL");
            }
        });
        out.section("VAR_OUTPUT", |out| {
            for component in &self.names.components {
                out.variable(&component.output, "INT");
            }
            if initial {
                out.initialized(STATE_NO, self.types.state_no, self.tables.initial);
            } else {
                out.variable(STATE_NO, self.types.state_no);
            }
            out.variable("pending", self.events_type());
            out.variable("unexpected", "BOOL");
            out.variable("overrun", "BOOL");
            if self.options.owed {
                out.variable(OWED, self.events_type());
            }
        });
    }

    fn variables(&self, out: &mut Declarations) {
        if self.options.retain {
            out.section("VAR RETAIN", |out| {
                retain::variables(out, self);
                self.memory(out);
            });
            if !self.has_variables() {
                return;
            }
        }
        out.section("VAR", |out| {
            if !self.options.retain {
                self.memory(out);
            }
            if !self.names.events.is_empty() {
                out.variable("raised", self.events_type());
                out.variable("index", self.types.index);
            }
            self.layout().variables(out, self);
            if self.has_rows() {
                out.variable("changed", "BOOL");
            }
            if self.has_super_steps() {
                out.variable("due", "BOOL");
            }
            if self.drains() {
                out.variable("done", "BOOL");
            }
            if self.owed.is_some() {
                out.variable("owed_row", self.types.owed);
            }
        });
    }

    /// Whether there are variables beside those that last from call to call.
    fn has_variables(&self) -> bool {
        !self.names.events.is_empty() || self.has_super_steps()
    }

    /// The variables that last from call to call.
    fn memory(&self, out: &mut Section) {
        out.initialized("state", self.types.state, self.tables.initial);
        if self.options.trigger == Trigger::Edge && !self.names.events.is_empty() {
            out.variable("previous", self.events_type());
        }
    }

    /// The body.
    fn call(&self, out: &mut Writer) {
        for component in &self.names.components {
            out.code(format_args!("#{} := 0;", component.output));
        }
        out.code("#overrun := FALSE;");
        let faults = self.options.unexpected == Unexpected::Fault;
        if !faults {
            out.code("#unexpected := FALSE;");
        }
        for (index, event) in self.names.events.iter().enumerate() {
            out.code(format_args!("#raised[{index}] := #{};", event.input));
        }
        out.gap();
        if self.options.retain {
            retain::restore(out, self);
        }
        out.code("IF #reset THEN");
        out.indented(|out| self.reset(out));
        // A controller without any event or super step has nothing to do.
        if self.has_variables() {
            out.code(if faults { "ELSIF #enable AND NOT #unexpected THEN" } else { "ELSIF #enable THEN" });
            out.indented(|out| self.run(out));
        }
        out.code("END_IF;");
        if self.options.trigger == Trigger::Edge && !self.names.events.is_empty() {
            out.code("#previous := #raised;");
        }
        let state = self.types.state.converted(self.types.state_no, "#state");
        out.code(format_args!("#{STATE_NO} := {state};"));
        if let Some(owed) = &self.owed {
            owed.update(out, self);
        }
        if self.options.retain {
            retain::keep(out, self);
        }
    }

    fn reset(&self, out: &mut Writer) {
        out.code(format_args!("#state := {};", self.tables.initial));
        if self.options.unexpected == Unexpected::Fault {
            out.code("#unexpected := FALSE;");
        }
        self.for_each_event(out, |out| out.code("#pending[#index] := FALSE;"));
    }

    pub(super) fn for_each_event(&self, out: &mut Writer, inside: impl FnOnce(&mut Writer)) {
        if !self.names.events.is_empty() {
            out.code(format_args!("FOR #index := 0 TO {} DO", self.last_event()));
            out.indented(inside);
            out.code("END_FOR;");
        }
    }

    fn run(&self, out: &mut Writer) {
        self.for_each_event(out, |out| self.raise(out));
        if self.drains() {
            out.repeat("#done", |out| self.cycle(out));
        } else {
            self.cycle(out);
        }
        self.refuse(out);
    }

    fn raise(&self, out: &mut Writer) {
        let raised = match self.options.trigger {
            Trigger::Edge => "#raised[#index] AND NOT #previous[#index]",
            Trigger::Level => "#raised[#index]",
        };
        out.when(raised, |out| {
            out.code("#overrun := #overrun OR #pending[#index];");
            out.code("#pending[#index] := TRUE;");
        });
    }

    fn cycle(&self, out: &mut Writer) {
        let layout = self.layout();
        if self.has_rows() {
            layout.consume(out, self);
        }
        if self.has_super_steps() {
            out.comment("super step");
            layout.super_step(out, self);
        }
    }

    /// What is pending while the controller waits for the environment fits nowhere.
    fn refuse(&self, out: &mut Writer) {
        if self.names.events.is_empty() {
            return;
        }
        let each = |out: &mut Writer| {
            self.for_each_event(out, |out| {
                out.code("#unexpected := #unexpected OR #pending[#index];");
                if self.options.unexpected == Unexpected::Drop {
                    out.code("#pending[#index] := FALSE;");
                }
            });
        };
        if self.has_super_steps() {
            out.when("NOT #due", each);
        } else {
            each(out);
        }
    }
}
