//! `Controller`: the machine of the runtime with this module's types.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::Options;
use crate::controller::tables::Tables;

/// Words of 32 events.
pub(super) fn words(tables: &Tables) -> usize {
    tables.events.len().div_ceil(32)
}

/// The struct and its methods.
pub(super) fn items(tables: &Tables, options: &Options) -> TokenStream {
    let (fields, words, interface) = if options.ordered {
        ("its state", 0, one_at_a_time())
    } else {
        ("its state, and the events that are pending", words(tables), batches())
    };
    let doc = format!(" The controller: {fields}.");
    let words = Literal::usize_unsuffixed(words);
    let react = react();
    let queries = queries();
    quote! {
        #[doc = #doc]
        #[derive(Clone, PartialEq, Eq, Debug)]
        pub struct Controller {
            machine: ::controller_template::Machine<Tables, #words>,
        }

        impl Controller {
            /// In the initial state, with nothing pending.
            #[must_use]
            pub const fn new() -> Self {
                Self { machine: ::controller_template::Machine::new() }
            }

            /// Back to [`new`](Self::new).
            pub const fn reset(&mut self) {
                *self = Self::new();
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
        /// Takes one event with its super step; refuses with `None` an event that does not fit, and any while a
        /// super step is due. Pending events stay so.
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
