//! `Controller`: the machine of the runtime with this module's types.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::Options;
use super::columns::number;
use super::engine::Rows;
use crate::controller::calls;
use crate::controller::tables::Tables;

/// Words of 32 events.
pub(super) fn words(tables: &Tables) -> usize {
    tables.events.len().div_ceil(32)
}

/// The struct and its methods.
pub(super) fn items(tables: &Tables, options: &Options, rows: &dyn Rows) -> TokenStream {
    let (fields, words, interface) = if options.ordered {
        ("its state", 0, one_at_a_time())
    } else {
        ("its state, and the events that are pending", words(tables), batches())
    };
    let doc = format!(" The controller: {fields}.");
    let bytes = Literal::usize_unsuffixed(4 * (words + 3));
    let words = Literal::usize_unsuffixed(words);
    let table_version = number(tables.version());
    let bounds = bounds(&Bounds::new(tables, rows), options);
    let react = react();
    let queries = queries();
    quote! {
        ::controller_template::formatted! {
            #[doc = #doc]
            #[derive(Clone, PartialEq, Eq, Debug)]
            pub struct Controller {
                machine: ::controller_template::Machine<Tables, #words>,
            }
        }

        /// What a controller is to go on from after a reset.
        pub type Saved = ::controller_template::Saved<#words, #bytes>;

        impl Controller {
            /// What tables are the same, in every language: [`restore`](Self::restore) refuses what others saved.
            pub const TABLE_VERSION: u32 = #table_version;

            #bounds

            /// In the initial state, with nothing pending.
            #[must_use]
            pub const fn new() -> Self {
                Self { machine: ::controller_template::Machine::new() }
            }

            /// Back to [`new`](Self::new).
            pub const fn reset(&mut self) {
                *self = Self::new();
            }

            /// What [`restore`](Self::restore) goes on from.
            #[must_use]
            pub fn save(&self) -> Saved {
                self.machine.save()
            }

            /// As it was when it was saved. What the plant did meanwhile nobody knows.
            ///
            /// # Errors
            ///
            /// If other tables saved it, or no controller did.
            pub fn restore(
                saved: &Saved,
            ) -> ::core::result::Result<Self, ::controller_template::RestoreError> {
                match ::controller_template::Machine::restore(saved) {
                    ::core::result::Result::Ok(machine) => ::core::result::Result::Ok(Self { machine }),
                    ::core::result::Result::Err(error) => ::core::result::Result::Err(error),
                }
            }

            #interface
            #react
            #queries
        }

        impl ::core::default::Default for Controller {
            fn default() -> Self {
                Self::new()
            }
        }
    }
}

/// The most probes of each call, and of [`Controller::accepts`]: a probe is a comparison with an entry of a table.
pub(super) struct Bounds {
    pub(super) accepts: u32,
    pub(super) react: u32,
    pub(super) cycle: u32,
    drain: u32,
}

impl Bounds {
    pub(super) fn new(tables: &Tables, rows: &dyn Rows) -> Bounds {
        let (event, super_step) = rows.probes();
        let probes = |lookups: u64, super_steps: u64| {
            let events = lookups.saturating_mul(event.into());
            let all = events.saturating_add(super_steps.saturating_mul(super_step.into()));
            u32::try_from(all).unwrap_or(u32::MAX)
        };
        Bounds {
            accepts: event,
            react: probes(1, 1),
            cycle: probes(calls::lookups_of_cycle(tables), 1),
            // Every repetition looks for a super step, also the last, which does none.
            drain: probes(calls::lookups_of_drain(tables), calls::super_steps(tables).saturating_add(1)),
        }
    }
}

/// Constants of `Controller`. A program that takes one event at a time has none pending.
fn bounds(bounds: &Bounds, options: &Options) -> TokenStream {
    let Bounds { accepts, react, cycle, drain } = bounds;
    let [accepts, react, cycle, drain] =
        [*accepts, *react, if options.ordered { react - accepts } else { *cycle }, *drain].map(number);
    let drain = (!options.ordered).then(|| {
        quote! {
            /// The most probes of a call of [`drain`](Self::drain).
            pub const DRAIN_PROBES: u32 = #drain;
        }
    });
    quote! {
        /// The most probes of a look-up of an event, as in [`accepts`](Self::accepts). A probe is a comparison with an
        /// entry of a table.
        pub const ACCEPTS_PROBES: u32 = #accepts;

        /// The most probes of a call of [`react`](Self::react).
        pub const REACT_PROBES: u32 = #react;

        /// The most probes of a call of [`cycle`](Self::cycle).
        pub const CYCLE_PROBES: u32 = #cycle;

        #drain
    }
}

/// `cycle` of a program that takes one event at a time.
fn one_at_a_time() -> TokenStream {
    cycle(" Does the super step that is due, if any: the initial one, or the rest of one that is split.")
}

fn cycle(doc: &str) -> TokenStream {
    quote! {
        #[doc = #doc]
        pub fn cycle(&mut self) -> Commands {
            self.machine.cycle(&mut ())
        }

        /// [`cycle`](Self::cycle), observed.
        pub fn cycle_observed(
            &mut self,
            observer: &mut impl ::controller_template::Observer<Event, Commands>,
        ) -> Commands {
            self.machine.cycle(observer)
        }
    }
}

/// `react`, which every controller has.
fn react() -> TokenStream {
    quote! {
        /// Takes one event with its super step; refuses with `None` an event that does not fit, as none does where
        /// only a super step is due. Pending events stay so.
        ///
        /// Of a split super step this is the first part; [`cycle`](Self::cycle) delivers the others, one a call.
        #[must_use]
        pub fn react(&mut self, event: Event) -> ::core::option::Option<Commands> {
            self.machine.react(event, &mut ())
        }

        /// [`react`](Self::react), observed.
        #[must_use]
        pub fn react_observed(
            &mut self,
            event: Event,
            observer: &mut impl ::controller_template::Observer<Event, Commands>,
        ) -> ::core::option::Option<Commands> {
            self.machine.react(event, observer)
        }
    }
}

/// What a program needs that takes several events at once.
fn batches() -> TokenStream {
    let cycle = cycle(
        " One cycle: consumes pending events in table order until none fits, then does one super step.",
    );
    quote! {
        /// Makes an event pending for the next cycle; `false` if it is already, and then once is all it counts.
        pub fn raise(&mut self, event: Event) -> bool {
            self.machine.raise(event)
        }

        /// Whether an event is pending.
        #[must_use]
        pub fn is_pending(&self, event: Event) -> bool {
            self.machine.is_pending(event)
        }

        /// The pending events in table order. After a cycle, unless a super step is due, these fit nowhere: they are
        /// unexpected.
        pub fn pending(&self) -> impl ::core::iter::Iterator<Item = Event> + use<> {
            self.machine.pending().ones().filter_map(Event::from_index)
        }

        #cycle

        /// Cycles until no super step is due, and returns the commands of all.
        ///
        /// Stops before a super step that would command a component already commanded in this call, and leaves it
        /// to the next one.
        pub fn drain(&mut self) -> Commands {
            self.machine.drain(&mut ())
        }

        /// [`drain`](Self::drain), observed.
        pub fn drain_observed(
            &mut self,
            observer: &mut impl ::controller_template::Observer<Event, Commands>,
        ) -> Commands {
            self.machine.drain(observer)
        }
    }
}

fn queries() -> TokenStream {
    quote! {
        /// The state's number.
        #[must_use]
        pub fn state(&self) -> u32 {
            self.machine.state()
        }

        /// Whether an event fits the state.
        #[must_use]
        pub fn accepts(&self, event: Event) -> bool {
            self.machine.accepts(event)
        }

        /// The events that the environment owes in this state, in table order, so that a watchdog can name what has
        /// not come. This is no safety function.
        pub fn owed(&self) -> impl ::core::iter::Iterator<Item = Event> + use<> {
            Tables::owed(self.machine.state()).ones().filter_map(Event::from_index)
        }
    }
}
