// From tables at random, written by the tests of the Rust back end.

/// Controller of the specification `bench`.
///
/// 150 states, 7 environment events with 425 rows, 60 super steps.
///
/// Looking up an event takes at most 1 probe of its table, a super step 1. A cycle takes at most 29 probes.
#[allow(dead_code, unreachable_pub, reason = "no program needs every item")]
#[allow(
    clippy::disallowed_names,
    clippy::doc_markdown,
    clippy::enum_variant_names,
    clippy::module_inception,
    clippy::module_name_repetitions,
    clippy::similar_names,
    clippy::struct_field_names,
    clippy::upper_case_acronyms,
    clippy::wrong_self_convention,
    rustdoc::bare_urls,
    reason = "names and texts are the specification's"
)]
#[allow(
    clippy::many_single_char_names,
    clippy::too_many_arguments,
    clippy::too_many_lines,
    clippy::trivially_copy_pass_by_ref,
    clippy::type_complexity,
    reason = "sizes are the specification's"
)]
pub mod bench {
    ::controller_template::formatted! {
        /// The controller: its state, and the events that are pending.
        #[derive(Clone, PartialEq, Eq, Debug)]
        pub struct Controller {
            machine: ::controller_template::Machine<Tables, 1>,
        }
    }

    /// What a controller is to go on from after a reset.
    pub type Saved = ::controller_template::Saved<1, 16>;

    impl Controller {
        /// What tables are the same, in every language: [`restore`](Self::restore) refuses what others saved.
        pub const TABLE_VERSION: u32 = 702_256_936;

        /// The most probes of a look-up of an event, as in [`accepts`](Self::accepts). A probe is a comparison with an
        /// entry of a table.
        pub const ACCEPTS_PROBES: u32 = 1;

        /// The most probes of a call of [`react`](Self::react).
        pub const REACT_PROBES: u32 = 2;

        /// The most probes of a call of [`cycle`](Self::cycle).
        pub const CYCLE_PROBES: u32 = 29;

        /// The most probes of a call of [`drain`](Self::drain).
        pub const DRAIN_PROBES: u32 = 229;

        /// In the initial state, with nothing pending.
        #[must_use]
        pub const fn new() -> Self {
            Self {
                machine: ::controller_template::Machine::new(),
            }
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
                ::core::result::Result::Ok(machine) => {
                    ::core::result::Result::Ok(Self { machine })
                }
                ::core::result::Result::Err(error) => ::core::result::Result::Err(error),
            }
        }

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

        /// One cycle: consumes pending events in table order until none fits, then does one super step.
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

    impl ::core::default::Default for Controller {
        fn default() -> Self {
            Self::new()
        }
    }

    ::controller_template::formatted! {
        /// Events of the environment, in table order.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        #[repr(u8)]
        pub enum Event {
            /// `env -> ctl.e0000()`
            EnvCtlE0000,
            /// `env -> ctl.e0001()`
            EnvCtlE0001,
            /// `env -> ctl.e0002()`
            EnvCtlE0002,
            /// `env -> ctl.e0003()`
            EnvCtlE0003,
            /// `env -> ctl.e0004()`
            EnvCtlE0004,
            /// `env -> ctl.e0005()`
            EnvCtlE0005,
            /// `env -> ctl.e0006()`
            EnvCtlE0006,
        }
    }

    impl Event {
        const fn index(self) -> usize {
            self as usize
        }

        fn from_index(index: usize) -> ::core::option::Option<Self> {
            EVENTS.get(index).copied()
        }
    }

    static EVENTS: [Event; 7] = [
        Event::EnvCtlE0000,
        Event::EnvCtlE0001,
        Event::EnvCtlE0002,
        Event::EnvCtlE0003,
        Event::EnvCtlE0004,
        Event::EnvCtlE0005,
        Event::EnvCtlE0006,
    ];

    ::controller_template::formatted! {
        /// Commands to `c0`.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        #[repr(u8)]
        pub enum C0Command {
            /// `ctl -> c0.go()`
            Go = 1,
            /// `ctl -> c0.stop()`
            Stop = 2,
            /// `ctl -> c0.turn(1)`
            Turn1 = 3,
        }
    }

    impl C0Command {
        /// The code in tables and in other languages' controllers; it is never 0.
        #[must_use]
        pub const fn code(self) -> u8 {
            self as u8
        }

        /// The command of a code.
        #[must_use]
        pub const fn from_code(code: u8) -> ::core::option::Option<Self> {
            match code {
                1 => ::core::option::Option::Some(Self::Go),
                2 => ::core::option::Option::Some(Self::Stop),
                3 => ::core::option::Option::Some(Self::Turn1),
                _ => ::core::option::Option::None,
            }
        }

        /// Has the secondary do it.
        pub fn apply<S: C0 + ?Sized>(self, secondary: &mut S) {
            match self {
                Self::Go => C0::go(secondary),
                Self::Stop => C0::stop(secondary),
                Self::Turn1 => C0::turn_1(secondary),
            }
        }
    }

    ::controller_template::formatted! {
        /// Commands to `c1`.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        #[repr(u8)]
        pub enum C1Command {
            /// `ctl -> c1.go()`
            Go = 1,
            /// `ctl -> c1.stop()`
            Stop = 2,
            /// `ctl -> c1.turn(1)`
            Turn1 = 3,
        }
    }

    impl C1Command {
        /// The code in tables and in other languages' controllers; it is never 0.
        #[must_use]
        pub const fn code(self) -> u8 {
            self as u8
        }

        /// The command of a code.
        #[must_use]
        pub const fn from_code(code: u8) -> ::core::option::Option<Self> {
            match code {
                1 => ::core::option::Option::Some(Self::Go),
                2 => ::core::option::Option::Some(Self::Stop),
                3 => ::core::option::Option::Some(Self::Turn1),
                _ => ::core::option::Option::None,
            }
        }

        /// Has the secondary do it.
        pub fn apply<S: C1 + ?Sized>(self, secondary: &mut S) {
            match self {
                Self::Go => C1::go(secondary),
                Self::Stop => C1::stop(secondary),
                Self::Turn1 => C1::turn_1(secondary),
            }
        }
    }

    ::controller_template::formatted! {
        /// Commands to `c2`.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        #[repr(u8)]
        pub enum C2Command {
            /// `ctl -> c2.go()`
            Go = 1,
            /// `ctl -> c2.stop()`
            Stop = 2,
            /// `ctl -> c2.turn(1)`
            Turn1 = 3,
        }
    }

    impl C2Command {
        /// The code in tables and in other languages' controllers; it is never 0.
        #[must_use]
        pub const fn code(self) -> u8 {
            self as u8
        }

        /// The command of a code.
        #[must_use]
        pub const fn from_code(code: u8) -> ::core::option::Option<Self> {
            match code {
                1 => ::core::option::Option::Some(Self::Go),
                2 => ::core::option::Option::Some(Self::Stop),
                3 => ::core::option::Option::Some(Self::Turn1),
                _ => ::core::option::Option::None,
            }
        }

        /// Has the secondary do it.
        pub fn apply<S: C2 + ?Sized>(self, secondary: &mut S) {
            match self {
                Self::Go => C2::go(secondary),
                Self::Stop => C2::stop(secondary),
                Self::Turn1 => C2::turn_1(secondary),
            }
        }
    }

    ::controller_template::formatted! {
        /// What one call commands: at most one command to each component.
        #[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
        #[must_use = "a command that is not carried out is lost"]
        pub struct Commands {
            /// To `c0`.
            pub c0: ::core::option::Option<C0Command>,
            /// To `c1`.
            pub c1: ::core::option::Option<C1Command>,
            /// To `c2`.
            pub c2: ::core::option::Option<C2Command>,
        }
    }

    impl Commands {
        /// Whether there is none.
        #[must_use]
        pub fn is_empty(self) -> bool {
            self == <Self as ::core::default::Default>::default()
        }

        /// Has every secondary do what is commanded to its component.
        pub fn dispatch(
            self,
            c0: &mut (impl C0 + ?Sized),
            c1: &mut (impl C1 + ?Sized),
            c2: &mut (impl C2 + ?Sized),
        ) {
            if let ::core::option::Option::Some(command) = self.c0 {
                command.apply(c0);
            }
            if let ::core::option::Option::Some(command) = self.c1 {
                command.apply(c1);
            }
            if let ::core::option::Option::Some(command) = self.c2 {
                command.apply(c2);
            }
        }
    }

    impl ::controller_template::CommandSet for Commands {
        fn overlaps(self, other: Self) -> bool {
            (self.c0.is_some() && other.c0.is_some())
                || (self.c1.is_some() && other.c1.is_some())
                || (self.c2.is_some() && other.c2.is_some())
        }

        fn union(self, other: Self) -> Self {
            Self {
                c0: self.c0.or(other.c0),
                c1: self.c1.or(other.c1),
                c2: self.c2.or(other.c2),
            }
        }
    }

    /// Secondary of `c0`: starts what is commanded and returns at once.
    pub trait C0 {
        /// `ctl -> c0.go()`
        fn go(&mut self);

        /// `ctl -> c0.stop()`
        fn stop(&mut self);

        /// `ctl -> c0.turn(1)`
        fn turn_1(&mut self);
    }

    /// Secondary of `c1`: starts what is commanded and returns at once.
    pub trait C1 {
        /// `ctl -> c1.go()`
        fn go(&mut self);

        /// `ctl -> c1.stop()`
        fn stop(&mut self);

        /// `ctl -> c1.turn(1)`
        fn turn_1(&mut self);
    }

    /// Secondary of `c2`: starts what is commanded and returns at once.
    pub trait C2 {
        /// `ctl -> c2.go()`
        fn go(&mut self);

        /// `ctl -> c2.stop()`
        fn stop(&mut self);

        /// `ctl -> c2.turn(1)`
        fn turn_1(&mut self);
    }

    /// Version of the meaning of these tables.
    pub const FORMAT_VERSION: u32 = 1;

    const _: () = ::core::assert!(
        FORMAT_VERSION == ::controller_template::FORMAT_VERSION,
        "generated for another version of `controller-template`"
    );

    #[derive(Clone, PartialEq, Eq, Debug)]
    struct Tables;

    impl ::controller_template::Tables for Tables {
        type State = u8;

        type Event = Event;

        type Commands = Commands;

        const VERSION: u32 = Controller::TABLE_VERSION;

        const STATES: u32 = 150;

        const INITIAL: u8 = 107;

        fn index(event: Event) -> usize {
            event.index()
        }

        fn event(index: usize) -> ::core::option::Option<Event> {
            Event::from_index(index)
        }

        fn environment(
            event: Event,
            state: Self::State,
        ) -> ::core::option::Option<Self::State> {
            COMB.lookup(event.index(), state)
        }

        fn super_step(
            state: Self::State,
        ) -> ::core::option::Option<(Self::State, Commands)> {
            let step = COMB.index(7, state)?;
            let row = ::controller_template::Column::index(&COMMAND_SET, step)?;
            let commands = Commands {
                c0: C0Command::from_code(
                    ::controller_template::Column::get(&C0_TARGET, row)?,
                ),
                c1: C1Command::from_code(
                    ::controller_template::Column::get(&C1_TARGET, row)?,
                ),
                c2: C2Command::from_code(
                    ::controller_template::Column::get(&C2_TARGET, row)?,
                ),
            };
            ::core::option::Option::Some((
                ::controller_template::Column::get(&SUPER_STEPS, step)?,
                commands,
            ))
        }
    }

    impl Tables {
        fn owed(state: u32) -> ::controller_template::Bits<1> {
            ::controller_template::Bits::of_state(&OWED_SET, &OWED, state)
        }
    }

    /// The rows of all events.
    static COMB: ::controller_template::Comb<[u16; 150], [u8; 506], [u8; 506]> = ::controller_template::Comb {
        displacement: [
             35,  92,  43,  48,  55, 294, 122,  21,  22,  64,
            448,  69, 301, 188,  70, 452, 303,  30, 456, 460,
              0, 311, 316, 117, 464, 465,  82, 120, 126, 470,
            150, 130, 114, 153, 162, 165, 137, 191, 142, 323,
            149, 155, 201, 327, 159,  38, 334, 167, 134, 337,
            145, 343, 473, 172, 206, 178, 348, 179, 186, 207,
            212, 352, 219, 193, 354, 477, 238, 279, 241, 200,
            204, 246, 211, 252, 217, 280, 361, 364, 224, 371,
             45, 375, 480, 485, 267, 290, 380, 486,  52, 300,
            383, 305, 320,  59, 324, 389, 335, 230, 342, 236,
            395, 402,  65, 360, 243, 250, 256,  73, 369, 372,
             81,   4,  89, 491, 496, 376, 384, 391, 498, 393,
             28, 399, 405, 411, 262,  97, 400, 269, 406, 415,
            416, 102, 414, 421, 424,   8, 428, 276, 109, 433,
            234, 431, 283, 116, 439, 437, 289,  15, 443, 314,
        ],
        first: 0,
        check: [
            0, 1, 2, 3, 4, 1, 6, 7, 0, 1, 2, 3, 4, 5, 6, 0, 1, 2, 3, 4,
            5, 6, 0, 1, 2, 3, 5, 6, 6, 7, 0, 3, 2, 3, 6, 5, 6, 7, 0, 1,
            2, 3, 7, 5, 6, 0, 1, 2, 3, 4, 7, 6, 0, 1, 2, 7, 4, 5, 6, 0,
            1, 2, 7, 4, 5, 6, 1, 2, 3, 4, 5, 7, 7, 0, 1, 2, 7, 7, 5, 6,
            7, 0, 1, 1, 3, 4, 4, 6, 7, 0, 1, 2, 0, 4, 2, 6, 7, 0, 1, 2,
            3, 4, 0, 1, 7, 3, 4, 5, 6, 0, 1, 2, 3, 4, 0, 6, 0, 1, 4, 3,
            4, 5, 6, 1, 7, 3, 4, 7, 6, 7, 0, 1, 2, 7, 0, 5, 6, 0, 4, 2,
            3, 4, 5, 1, 2, 3, 4, 2, 6, 0, 1, 6, 3, 4, 5, 0, 1, 7, 3, 4,
            7, 6, 3, 4, 5, 6, 7, 0, 1, 7, 3, 4, 7, 6, 2, 3, 4, 5, 6, 0,
            1, 3, 3, 5, 5, 6, 0, 1, 0, 1, 4, 5, 6, 0, 6, 2, 3, 4, 7, 6,
            0, 1, 2, 3, 4, 1, 2, 3, 7, 5, 6, 0, 1, 7, 7, 4, 5, 0, 7, 7,
            3, 4, 5, 6, 0, 1, 7, 3, 4, 5, 0, 8, 2, 3, 0, 5, 6, 1, 4, 3,
            4, 5, 6, 0, 1, 7, 3, 4, 7, 6, 0, 1, 2, 7, 4, 5, 0, 1, 2, 7,
            4, 5, 0, 8, 2, 3, 4, 0, 6, 0, 1, 4, 3, 6, 5, 6, 0, 1, 2, 0,
            4, 2, 6, 0, 1, 2, 8, 7, 5, 6, 1, 2, 3, 4, 5, 1, 8, 7, 4, 5,
            6, 0, 1, 0, 3, 2, 5, 7, 8, 6, 7, 0, 7, 2, 0, 4, 2, 6, 2, 3,
            6, 8, 6, 7, 1, 2, 3, 7, 1, 6, 3, 7, 5, 6, 0, 1, 2, 0, 1, 5,
            3, 8, 7, 6, 1, 2, 3, 4, 0, 7, 2, 3, 0, 5, 2, 3, 2, 5, 4, 5,
            6, 0, 1, 2, 0, 1, 5, 7, 8, 5, 6, 0, 1, 2, 3, 0, 7, 2, 3, 7,
            5, 1, 2, 7, 4, 2, 6, 4, 5, 6, 1, 7, 3, 4, 5, 0, 8, 2, 7, 4,
            7, 6, 0, 1, 2, 0, 7, 7, 6, 4, 5, 6, 1, 7, 3, 1, 5, 6, 4, 5,
            6, 0, 7, 7, 3, 4, 2, 6, 4, 5, 6, 3, 4, 5, 6, 2, 3, 4, 7, 6,
            1, 2, 3, 0, 7, 6, 8, 4, 8, 6, 7, 3, 8, 5, 6, 3, 4, 1, 6, 3,
            0, 5, 8, 3, 4, 1, 1, 3, 3, 8, 6, 6, 2, 8, 4, 5, 3, 0, 5, 6,
            0, 4, 5, 3, 4, 0, 0, 2, 8, 3, 5, 0, 6, 2, 8, 8, 5, 1, 2, 3,
            2, 8, 4, 5, 8, 8,
        ],
        target: [
             72,  64,  58, 133,  60, 110,  60,  11,  88, 114,
             75,  38, 115, 147,  62,  50,  40, 142, 145, 107,
             62, 142,  83, 103, 128,  43,  93,  63, 100,   5,
             61,   5,  15, 148,  82,  40,  84,  10,  76, 103,
             37,   9,   0,  58,  14,  71, 123,  80,  56,  16,
              1,  96,  63,  20,  53,   2,   4,  48,   9,  86,
             21, 100,   3, 117,  51,  53, 146, 112, 128, 124,
             88,   6,  40,  20,  14, 106,   7,   8,  80,  46,
             42,  56,   2,  58,  90,  64,  60,  61,  45,  25,
             17,  84, 103,  65,  42,   7,  46,  90, 108,  22,
             76, 111,  22,  47,  52, 119, 101,  54,   5, 124,
             75,  59,  48, 115, 145,  22,  79,  41,  82,  66,
             51, 127,  76,  78,  13,  70, 112,  14, 118,   4,
             80,  36, 147,  15, 138,  13, 114,  29,  44,  65,
             77,  81,  23,  93,  26,  54,  94, 121, 106,  58,
             52,  35,  73,  10,  46,  39, 123,  16, 136, 105,
             17,  61, 141,  63,  74,  52,  22, 119,   1,  18,
             18,  75,  19, 133,  80,  39, 120, 119,  71,  83,
             53,  78, 106, 110, 126,  88,  82, 120, 123,  41,
            132,  60,  20,  85, 144,   6,  14,  84,  20,  23,
             80,   8, 106, 131,   8,  37,   4,   3,  21,  94,
             10, 126,  65,  23,  24,  70, 106, 148,  30,  25,
            120,   6, 132, 117,   8,  81,  26,   2,  58,  81,
             67,   0, 113,  65, 102,  63,  91,   5,  81,   9,
            146,   3,  53,  66,  61,  27,   3,  38,  28,  86,
            126,  71,  30,  29,  20, 136,  34, 139,  25,  31,
            125, 120,  68,   0,  71, 100,  83,  61, 125,  62,
            131,  60,  74,  82,  15,  90,  75,  87, 127, 108,
             94,  25, 100,  95,   5,  62,   0,  32,  43,  45,
             94,  68,  79,  15, 117,  45,   0,  33,  66, 131,
             22, 149,  26, 103, 118, 103,  74,  34,   0,  15,
              9,  68,  35,  86,  68, 104,  76, 132,  26,  61,
              3,   0,  34,  12,  16, 102, 135,  36,  32,  17,
             72,  37, 107,  19, 145, 116,  17,  28,  39,  89,
             96,   0,  38,  28, 106,  52,  43,  71,  29,  39,
             68, 102,   9,  63,  61,  34,  57,  51,  69,  19,
            123, 108,  51, 133,   5,  90,  25,  41,   0,  65,
             63, 127,   0,  16,   3,  41,  43,   9, 133,  44,
             49, 141,  47,  47,  15,  59,  30,  16, 129, 130,
             87,  48,  63, 105, 126, 135,   0,   8,  49,   7,
             50,  85,  21,  54,   3,  85,  51,  53,  39, 122,
            113,  78, 108,  54,  65, 100, 142,  27,  74, 116,
             59, 113,  55,  56, 104, 121,  85,  10, 114, 118,
             82,  67,   0,  92, 128,   9,  82,  40,  57,  36,
             63,  81,  54,  59,  58,  70,   0, 122,   0,  17,
             59, 134,   0,  57, 118,  42, 145, 116,  82,   2,
            137, 145,   0,  16, 105,  30,  66,  27,   8,   0,
             11,  77,  53,   0, 115, 102,  44,  33, 128,  75,
             76, 114,  42,  21,  33,  90, 107,  37,   0,  28,
            127,   6,  59, 140,   0,   0,  67, 102,  87,  47,
             13,   0, 109,  35,   0,   0,
        ],
    };

    /// Targets of super steps.
    static SUPER_STEPS: [u8; 60] = [
         50,  24, 122,   5,  38,  24,  70, 115, 147,  50,
         32, 128,  71, 120,  41,  72,  85, 108,  59,  59,
         42, 122, 121,  74, 107,  93,  64,  85, 107, 100,
        112,  89, 104, 143, 117, 100, 149, 129, 143, 111,
        118, 123, 149, 148, 114, 119, 127, 135, 126, 134,
        130, 137, 147, 140, 138, 132, 149, 148, 149, 149,
    ];

    /// Per super step which commands it has.
    static COMMAND_SET: [u8; 60] = [
         0,  0,  1,  0,  2,  3,  4,  5,  6,  0,  5,  7,  6,  6,  8,  0,  4,  9, 10, 11,
         6, 10,  0,  0, 10, 12,  0,  0,  4, 13,  0,  5,  0,  0,  7,  6,  6,  7,  4, 14,
        10, 15, 10,  0,  0, 12, 10, 16, 17, 18, 10,  0, 10, 19,  0,  0,  6, 20, 21, 11,
    ];

    /// Codes that super steps command to `c0`; 0 is none.
    static C0_TARGET: [u8; 22] = [
        0, 2, 1, 1, 0, 2, 0, 0, 0, 0, 3, 0, 0, 2, 0, 0, 3, 3, 3, 0, 1, 0,
    ];

    /// Codes that super steps command to `c1`; 0 is none.
    static C1_TARGET: [u8; 22] = [
        0, 1, 0, 0, 1, 0, 2, 3, 2, 1, 0, 0, 0, 2, 3, 3, 3, 2, 3, 0, 1, 1,
    ];

    /// Codes that super steps command to `c2`; 0 is none.
    static C2_TARGET: [u8; 22] = [
        0, 1, 3, 0, 0, 0, 0, 0, 2, 1, 0, 1, 2, 0, 1, 3, 3, 1, 1, 3, 1, 3,
    ];

    /// Per state, which set of events is owed there.
    static OWED_SET: [u8; 150] = [
         0,  1,  2,  2,  3,  2,  2,  2,  2,  2,  4,  2,  5,  2,  2,  2,  2,  2,  0,  6,
         2,  7,  0,  2,  2,  3,  2,  2,  8,  2,  2,  2,  0,  2,  2,  4,  4,  6,  2,  9,
        10,  2,  2, 11,  2,  2,  2,  2,  2,  2,  3, 12,  2,  4, 13,  2, 14,  2,  0,  2,
        14, 15,  2,  3,  8,  0,  8,  8,  5,  9, 13,  2,  3,  2,  2, 16,  3,  2,  2,  2,
        14, 15,  2,  2,  2,  2,  2,  2,  9, 11,  2,  9, 13,  2,  2,  2,  2,  2,  2, 17,
        15, 13, 17,  2,  2,  7,  8,  2, 15,  0, 13,  2, 11, 13, 18,  4,  4, 10,  2, 11,
        14,  8,  2,  2,  2,  1,  2, 13, 19,  2, 15, 11, 20,  0,  2,  2,  2,  2,  2,  2,
         4,  2,  2,  9,  2, 15,  1,  2,  2,  8,
    ];

    /// The sets, one bit an event.
    static OWED: [u32; 21] = [
         1,  5,  0, 64,  8,  6, 33, 48,  2, 40, 72,  4,  3, 16, 65, 32, 12, 68, 24, 20,
        18,
    ];

    ::controller_template::names! {
        impl Event {
            /// Every event, in table order.
            pub const ALL: [Self; 7] = [
                Self::EnvCtlE0000,
                Self::EnvCtlE0001,
                Self::EnvCtlE0002,
                Self::EnvCtlE0003,
                Self::EnvCtlE0004,
                Self::EnvCtlE0005,
                Self::EnvCtlE0006,
            ];
            /// The event with a text.
            #[must_use]
            pub fn from_text(text: &str) -> ::core::option::Option<Self> {
                Self::ALL.into_iter().find(|event| event.text() == text)
            }
            /// `sender -> receiver.operation(arguments)`.
            #[must_use]
            pub const fn text(self) -> &'static str {
                match self {
                    Self::EnvCtlE0000 => "env -> ctl.e0000()",
                    Self::EnvCtlE0001 => "env -> ctl.e0001()",
                    Self::EnvCtlE0002 => "env -> ctl.e0002()",
                    Self::EnvCtlE0003 => "env -> ctl.e0003()",
                    Self::EnvCtlE0004 => "env -> ctl.e0004()",
                    Self::EnvCtlE0005 => "env -> ctl.e0005()",
                    Self::EnvCtlE0006 => "env -> ctl.e0006()",
                }
            }
        }

        impl C0Command {
            /// The command with a text.
            #[must_use]
            pub fn from_text(text: &str) -> ::core::option::Option<Self> {
                match text {
                    "ctl -> c0.go()" => ::core::option::Option::Some(Self::Go),
                    "ctl -> c0.stop()" => ::core::option::Option::Some(Self::Stop),
                    "ctl -> c0.turn(1)" => ::core::option::Option::Some(Self::Turn1),
                    _ => ::core::option::Option::None,
                }
            }
            /// `sender -> receiver.operation(arguments)`.
            #[must_use]
            pub const fn text(self) -> &'static str {
                match self {
                    Self::Go => "ctl -> c0.go()",
                    Self::Stop => "ctl -> c0.stop()",
                    Self::Turn1 => "ctl -> c0.turn(1)",
                }
            }
        }

        impl C1Command {
            /// The command with a text.
            #[must_use]
            pub fn from_text(text: &str) -> ::core::option::Option<Self> {
                match text {
                    "ctl -> c1.go()" => ::core::option::Option::Some(Self::Go),
                    "ctl -> c1.stop()" => ::core::option::Option::Some(Self::Stop),
                    "ctl -> c1.turn(1)" => ::core::option::Option::Some(Self::Turn1),
                    _ => ::core::option::Option::None,
                }
            }
            /// `sender -> receiver.operation(arguments)`.
            #[must_use]
            pub const fn text(self) -> &'static str {
                match self {
                    Self::Go => "ctl -> c1.go()",
                    Self::Stop => "ctl -> c1.stop()",
                    Self::Turn1 => "ctl -> c1.turn(1)",
                }
            }
        }

        impl C2Command {
            /// The command with a text.
            #[must_use]
            pub fn from_text(text: &str) -> ::core::option::Option<Self> {
                match text {
                    "ctl -> c2.go()" => ::core::option::Option::Some(Self::Go),
                    "ctl -> c2.stop()" => ::core::option::Option::Some(Self::Stop),
                    "ctl -> c2.turn(1)" => ::core::option::Option::Some(Self::Turn1),
                    _ => ::core::option::Option::None,
                }
            }
            /// `sender -> receiver.operation(arguments)`.
            #[must_use]
            pub const fn text(self) -> &'static str {
                match self {
                    Self::Go => "ctl -> c2.go()",
                    Self::Stop => "ctl -> c2.stop()",
                    Self::Turn1 => "ctl -> c2.turn(1)",
                }
            }
        }
    }

    ::controller_template::serialized! {
        struct Commands {
            c0: C0Command,
            c1: C1Command,
            c2: C2Command,
        }

        struct Event;

        struct C0Command;

        struct C1Command;

        struct C2Command;
    }
}
