// From tables at random, written by the tests of the Rust back end.

/// Controller of the specification `bench`.
///
/// 150 states, 7 environment events with 364 rows, 60 super steps.
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
        pub const TABLE_VERSION: u32 = 432_331_861;

        /// The most probes of a look-up of an event, as in [`accepts`](Self::accepts). A probe is a comparison with an
        /// entry of a table.
        pub const ACCEPTS_PROBES: u32 = 1;

        /// The most probes of a call of [`react`](Self::react).
        pub const REACT_PROBES: u32 = 2;

        /// The most probes of a call of [`cycle`](Self::cycle).
        pub const CYCLE_PROBES: u32 = 29;

        /// The most probes of a call of [`drain`](Self::drain).
        pub const DRAIN_PROBES: u32 = 141;

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

        const INITIAL: u8 = 120;

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
    static COMB: ::controller_template::Comb<[u16; 150], [u8; 433], [u8; 433]> = ::controller_template::Comb {
        displacement: [
              2,  66,  10,  16,  23,  73,  43,  80,  76,  94,
            263, 110,  84,   7, 122, 219, 129, 146, 109, 226,
            153, 228, 167, 181, 163, 232, 239, 194, 210, 243,
            233,  91,  14, 245, 273, 281,  98, 293, 338, 247,
            221, 254, 317, 104, 329,  21, 354, 261, 266, 108,
            358, 114, 271, 177, 340, 120, 277, 282, 364, 346,
            352, 365, 356, 126, 131, 138, 384, 253, 392, 370,
            373, 393, 395, 397,  72, 398, 286,   0, 290, 142,
            149, 296, 302, 306, 170, 399, 311, 314, 319, 400,
            155, 401, 402, 374, 403, 381, 404, 162, 405, 169,
            324,  90, 406, 407, 176, 145, 291, 408, 409, 410,
            411, 328, 412, 332, 339, 413, 414, 415,  28, 416,
            183, 417, 187, 396,  65, 418, 419, 379, 420, 421,
            422, 193,  34, 199, 206,  41, 386,  47, 345, 389,
            205, 423,  54, 391, 308, 424,  59, 350, 425, 212,
        ],
        first: 0,
        check: [
            0, 1, 2, 3, 4, 5, 6, 0, 1, 7, 3, 4, 5, 6, 0, 1, 2, 7, 4, 5,
            6, 0, 1, 7, 3, 4, 5, 6, 0, 1, 7, 3, 4, 5, 6, 1, 2, 3, 4, 5,
            6, 0, 1, 2, 3, 4, 5, 0, 1, 2, 7, 4, 5, 6, 0, 1, 2, 3, 4, 0,
            6, 2, 3, 4, 5, 6, 0, 1, 3, 4, 4, 5, 6, 0, 1, 2, 4, 4, 6, 6,
            0, 1, 2, 7, 4, 1, 6, 3, 4, 5, 6, 0, 2, 2, 3, 4, 6, 6, 0, 1,
            2, 7, 4, 5, 0, 1, 2, 3, 0, 5, 2, 3, 4, 5, 0, 6, 2, 7, 4, 5,
            6, 1, 2, 3, 4, 5, 0, 1, 2, 7, 4, 0, 6, 2, 3, 4, 7, 6, 0, 1,
            2, 3, 0, 5, 2, 0, 4, 5, 6, 0, 5, 2, 3, 7, 5, 6, 1, 2, 3, 4,
            7, 6, 0, 1, 2, 2, 3, 5, 6, 0, 0, 2, 3, 4, 7, 6, 0, 1, 2, 2,
            3, 5, 6, 0, 1, 2, 3, 0, 7, 6, 3, 4, 5, 6, 1, 2, 3, 4, 5, 0,
            1, 7, 3, 4, 5, 0, 0, 1, 3, 4, 5, 6, 0, 8, 2, 3, 4, 7, 6, 0,
            1, 0, 1, 4, 3, 6, 0, 1, 2, 1, 2, 3, 6, 1, 6, 8, 4, 5, 6, 0,
            7, 2, 3, 4, 1, 2, 8, 4, 1, 6, 3, 4, 7, 6, 0, 1, 3, 4, 4, 6,
            6, 0, 1, 0, 1, 4, 5, 1, 2, 6, 4, 5, 1, 8, 3, 4, 5, 0, 1, 2,
            7, 4, 0, 1, 2, 3, 0, 1, 7, 3, 4, 1, 1, 3, 4, 4, 6, 1, 2, 3,
            7, 5, 0, 1, 2, 3, 0, 1, 0, 1, 4, 5, 1, 2, 3, 1, 5, 3, 8, 5,
            6, 2, 3, 4, 7, 6, 2, 3, 4, 5, 2, 3, 0, 5, 6, 3, 7, 5, 6, 0,
            1, 3, 4, 5, 5, 6, 1, 7, 3, 4, 0, 6, 2, 7, 4, 5, 2, 3, 0, 7,
            6, 8, 4, 7, 6, 1, 2, 2, 3, 5, 5, 1, 2, 0, 1, 5, 3, 8, 4, 5,
            6, 0, 1, 4, 5, 6, 0, 6, 2, 0, 1, 7, 6, 2, 3, 6, 5, 1, 8, 7,
            7, 5, 7, 8, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7,
            7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7,
        ],
        target: [
            123,  95, 108,   3,  56, 132, 107, 134,  90,   0,
             17,  27, 112,   0,  15, 135,   0,   1, 136, 105,
            122,   7,  56,   2, 106,  96, 115,  57, 119,  66,
              3, 127,  47, 105,  25,  16,  15,  68,  74,  20,
            127,  82,  32,  58,  76, 104,  64,  85, 103,  26,
              4,  38,  65, 129,  80,  39,  53, 134,  82, 148,
              3,  65,  42,  66,  83,  88,  65,   8,  62,  65,
              2, 145, 101, 126, 127,  53,   2,  16,  46,  74,
             32,  71, 120,   5, 133,  76, 121,  37,  61,  66,
            115, 103,  94,  81,  68,  73,  19, 107,  99,  21,
            123,   6,  72,  60,  30,  20, 141,  25,  10,  60,
             87, 133,  39,  94,  73, 115,   5,   7, 102,  10,
            145,  68, 146,   9,  34,  63, 124, 113,   2,   8,
            131,  93, 102, 110,  53,   3,   9,  13, 111,  88,
             17,  59, 103,  71, 108,  39,  21,  84,  58,  61,
             15, 131,  30,  10,  69,  89, 103,  75,  13,  65,
             11, 110, 145,  41,   5,  65,  52,  16,  60,  29,
             68,  41,  71, 128,  12,  51,  58, 116,  40,  54,
             80,  60,  42, 138,  58, 128,  59,  28,  13,  65,
              9,   5, 146,  81,  93, 103,  81,  76,  38,  29,
             52,  14, 142, 119, 125, 108,  83, 123,  43,  48,
            109,  63,   5,   0, 102, 148,  79,  15, 136, 135,
             61, 121, 126,   8,  57,  94,  27, 107,   8,  63,
             37, 121,  40,  86,  81,   0,  77, 145,  51, 147,
             16,  51,  80,  54,  67,  90,   0, 135,  66,  15,
              6,   9,  17, 131,  12,  34, 100, 120,  18,  23,
             93, 140,  25,  23,  41,  43,  82,   6,  21, 114,
             44,  81,  85,   0,  16, 106, 105, 119,  90,  61,
             18,  14, 125,  62,  71,  37, 149, 102,  19,   8,
              3,  79,  64, 112, 133,  90,  74,  50,  47,  25,
             20, 114, 137,  59, 100, 106,  72,  68, 126, 106,
             28,   8,  45, 114,  84,  78,  70, 140,   0,   6,
            128,  87,  87,  63,  21, 119,  63,  22,   3,  33,
             42,  85,  76,   4,  94,  75,  22,  16, 106, 145,
             30,  61, 141, 104, 117, 132, 116,  23,  70,  67,
            108,  51,  26,  24,  54, 111,  20,   4, 110,  25,
             74,   0,  78,  26,  40,  22, 139,  14,  47,  75,
             44,  75, 102,  83, 124, 120, 113,   0,   9,  58,
             63,  80,  26, 100, 124,  49,   9, 126,  86,  33,
              1,  27,  48, 147, 118, 126, 122,  36,   0,  28,
             29,   7,  30,   0,  31,  32,  33,  34,  35,  36,
             37,  38,  39,  40,  41,  42,  43,  44,  45,  46,
             47,  48,  49,  50,  51,  52,  53,  54,  55,  56,
             57,  58,  59,
        ],
    };

    /// Targets of super steps.
    static SUPER_STEPS: [u8; 60] = [
         74,  81, 120,  95,  21,  77,  72, 126,  67,  36,
         68,  29, 115,  86,  47, 132,  48, 141,  44, 144,
        111, 116,  54, 114, 116, 111, 126, 124,  97,  99,
         93,  94, 143, 130, 137,  97, 138, 128, 119, 115,
        141, 106, 141, 116, 132, 114, 146, 123, 148, 118,
        129, 148, 127, 144, 137, 130, 133, 146, 147, 149,
    ];

    /// Per super step which commands it has.
    static COMMAND_SET: [u8; 60] = [
         0,  1,  2,  3,  4,  5,  1,  6,  7,  8,  9,  2, 10, 11,  2, 12,  1, 13, 14, 15,
        16, 17, 13,  1,  0, 18, 19, 20,  5, 18, 14, 21, 14,  1, 22,  1, 12, 12, 23, 20,
         1, 18, 12, 15, 24,  5, 14,  5, 25, 23, 14, 10, 18,  9,  1,  1,  2,  0, 26,  1,
    ];

    /// Codes that super steps command to `c0`; 0 is none.
    static C0_TARGET: [u8; 27] = [
        2, 0, 0, 0, 1, 0, 2, 3, 1, 0, 0, 3, 0, 0, 1, 0, 3, 2, 3, 2, 1, 3, 0, 0, 0, 3, 2,
    ];

    /// Codes that super steps command to `c1`; 0 is none.
    static C1_TARGET: [u8; 27] = [
        0, 0, 0, 1, 0, 2, 2, 1, 0, 0, 1, 0, 0, 3, 0, 2, 0, 2, 0, 2, 1, 3, 3, 1, 3, 1, 0,
    ];

    /// Codes that super steps command to `c2`; 0 is none.
    static C2_TARGET: [u8; 27] = [
        0, 0, 2, 3, 2, 0, 2, 1, 3, 3, 2, 3, 1, 0, 0, 3, 2, 1, 0, 0, 0, 0, 2, 0, 1, 0, 1,
    ];

    /// Per state, which set of events is owed there.
    static OWED_SET: [u8; 150] = [
         0,  1,  2,  3,  4,  2,  2,  0,  5,  1,  6,  7,  2,  2,  2,  2,  8,  9, 10,  2,
         2,  2, 11,  2,  2, 12, 13,  5,  2,  2,  2, 12, 14,  2,  2,  2,  4,  2,  2,  2,
         2, 15,  2, 16,  2,  2,  2,  2,  2, 12, 12,  0,  5, 17,  2,  2,  2,  4,  2, 18,
         2,  2,  2, 12,  2,  2, 15, 15, 12,  0, 15, 19,  4,  2,  1,  2,  2,  2,  2,  2,
         2,  2, 20,  2, 15,  5,  2, 12,  4, 12,  2, 12,  4,  0,  2, 13, 12, 18, 18, 16,
        15,  6,  2,  2,  4,  2, 11,  2,  4,  2,  2, 12,  4,  0,  2,  2,  2,  2,  2, 15,
        21,  2, 15,  6,  2,  2,  2,  2,  2,  2,  1,  4,  6,  1,  4,  2,  5,  7,  2,  2,
        17,  5,  2,  1,  5, 22, 15, 15, 15,  4,
    ];

    /// The sets, one bit an event.
    static OWED: [u32; 23] = [
         1, 16,  0, 72,  2, 64, 65,  9,  6,  7, 36, 48,  4, 10, 20, 32, 24,  5,  8, 33,
        14, 17, 96,
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
