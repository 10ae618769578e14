//! One array of all targets, and runs of consecutive states instead of sources: see [`Runs`].

use super::Layout;
use super::search::{Entries, Search};
use super::step::{self, Place};
use crate::controller::runs::Runs;
use crate::controller::tables::Tables;
use crate::emit::st::block::Block;
use crate::emit::st::bound::{Cost, LayoutCost};
use crate::emit::st::header;
use crate::emit::st::unit::{Declarations, Section, Unit};
use crate::emit::st::writer::Writer;

/// Mapping functions as runs.
pub(in crate::emit::st) struct RunLayout {
    /// How a run is found.
    pub(in crate::emit::st) search: &'static dyn Search,
    /// The section of variables that holds the arrays.
    pub(in crate::emit::st) section: &'static str,
}

/// How the tables are read.
const READING: [&str; 3] = [
    "A run is consecutive states with rows; take the event's last with run_state <= state.",
    "row := run_row + state - run_state, valid if below the next run_row",
    "new state := event_base + target[row] (super steps: + a number)",
];

impl Layout for RunLayout {
    fn functions<'a>(&self, block: &'a Block<'_>) -> Vec<Unit<'a>> {
        let searches = block.has_rows() || block.has_super_steps();
        if searches { self.search.functions(block, Some(block.runs.state.len())) } else { Vec::new() }
    }

    fn tables(&self, out: &mut Declarations, block: &Block<'_>) {
        let runs = &block.runs;
        if runs.target.is_empty() {
            return;
        }
        let (state, index) = (block.types.state, block.types.index);
        out.section(self.section, |out| {
            header::reminder(out, block);
            for line in READING {
                out.comment(line);
            }
            if block.has_rows() {
                out.comment("per event its first run; behind them, that of the super steps");
                out.array("event_run", index, &runs.first[..runs.base.len()]);
            }
            out.comment("per run its first state, and its first row in target");
            out.array("run_state", state, &runs.state);
            out.array("run_row", index, &runs.row);
            if block.has_rows() {
                out.comment("per event what is added to its targets");
                out.array("event_base", state, &runs.base[..runs.base.len() - 1]);
            }
            out.array("target", state, &runs.target);
            if block.has_super_steps() {
                out.comment("per run of the super steps its commands");
                for (codes, (names, integer)) in runs.codes.iter().zip(block.components()) {
                    out.array(&names.codes, integer, codes);
                }
            }
        });
    }

    fn variables(&self, out: &mut Section, block: &Block<'_>) {
        if block.runs.target.is_empty() {
            return;
        }
        let index = block.types.index;
        if block.has_rows() {
            out.variable("event", index);
        }
        // An event may have several runs, whatever it has.
        let several = block.has_rows() || runs_of_super_steps(block) > 1;
        self.search.variables(out, index, several);
        out.variable("row", index);
    }

    fn consume(&self, out: &mut Writer, block: &Block<'_>) {
        let pending = if self.is_total(block) {
            "#pending[#event]"
        } else {
            "#pending[#event] AND #event_run[#event] < #event_run[#event + 1]"
        };
        let entries = Entries {
            array: "run_state",
            first: "#event_run[#event]",
            last: "#event_run[#event + 1] - 1",
            several: true,
        };
        out.repeat("NOT #changed", |out| {
            out.code("#changed := FALSE;");
            out.code(format_args!("FOR #event := 0 TO {} DO", block.names.events.len() - 1));
            out.indented(|out| {
                out.when(pending, |out| {
                    self.search.find(out, block, &entries);
                    hit(out, block, |out| {
                        out.code("#state := #event_base[#event] + #target[#row];");
                        out.code("#pending[#event] := FALSE;");
                        out.code("#changed := TRUE;");
                    });
                });
            });
            out.code("END_FOR;");
        });
    }

    fn super_step(&self, out: &mut Writer, block: &Block<'_>) {
        let runs = &block.runs;
        let (first, end) = (runs.super_steps(), runs.state.len());
        let entries = Entries {
            array: "run_state",
            first: &first.to_string(),
            last: &(end - 1).to_string(),
            several: runs_of_super_steps(block) > 1,
        };
        let of_run = if first == 0 { "#first".to_owned() } else { format!("#first - {first}") };
        self.search.find(out, block, &entries);
        let target = match runs.base.last() {
            Some(base) if *base > 0 => format!("{base} + #target[#row]"),
            _ => "#target[#row]".to_owned(),
        };
        let place = Place { codes: &of_run, target: &target };
        step::write(out, block, &place, |out, inside| hit(out, block, inside));
    }

    fn largest_index(&self, tables: &Tables, runs: &Runs) -> u64 {
        // A search adds two runs and one; a row is sought behind the end of its run, up to the last state.
        let searched = 2 * runs.state.len() as u64;
        let row = runs.target.len() as u64 + u64::from(tables.states);
        searched.max(row)
    }

    fn cost(&self, block: &Block<'_>) -> LayoutCost {
        let runs = &block.runs;
        let mut cost = LayoutCost::default();
        // `IF` the run begins in time, `row`, `IF` it ends behind.
        let compared = Cost { statements: 3, probes: 2, iterations: 0 };
        let events = block.names.events.len();
        if block.has_rows() {
            cost.entry = Cost::statements(1);
            cost.rounds_per_event = 1;
            let filled = (0..events).map(|event| u64::from(runs.count(event))).filter(|count| *count > 0);
            cost.searches = filled.map(|count| self.search.cost(count, true) + compared).collect();
            // `changed`, the loop over events, and an `IF` for each, which asks whether there are runs if need be.
            let asked = if self.is_total(block) { 0 } else { events as u64 };
            cost.round = Cost { statements: 2 + events as u64, iterations: 1 + events as u64, probes: asked };
            // `state`, `pending`, `changed`.
            cost.event = Cost::statements(3);
        }
        if block.has_super_steps() {
            let count = u64::from(runs_of_super_steps(block));
            step::add_cost(&mut cost, block, self.search.cost(count, count > 1) + compared);
        }
        cost
    }
}

impl RunLayout {
    /// Whether every event has a row.
    fn is_total(&self, block: &Block<'_>) -> bool {
        (0..block.names.events.len()).all(|event| block.runs.count(event) > 0)
    }
}

fn runs_of_super_steps(block: &Block<'_>) -> u32 {
    block.runs.count(block.names.events.len())
}

/// Statements for the case that the run `first` has the state; `row` is its row then.
fn hit(out: &mut Writer, block: &Block<'_>, inside: impl FnOnce(&mut Writer)) {
    let (state, index) = (block.types.state, block.types.index);
    out.when("#run_state[#first] <= #state", |out| {
        let further = state.converted(index, "#state - #run_state[#first]");
        let further = if state == index { format!("({further})") } else { further };
        out.code(format_args!("#row := #run_row[#first] + {further};"));
        out.when("#row < #run_row[#first + 1]", inside);
    });
}
