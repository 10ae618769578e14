// From tables at random, written by the tests of the Rust back end.

/// Controller of the specification `bench`.
///
/// 150 states, 7 environment events with 364 rows, 60 super steps.
///
/// Looking up an event takes at most 8 probes of its table, a super step 8. A cycle looks up at most 28 events.
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
    clippy::type_complexity,
    reason = "sizes are the specification's"
)]
pub mod bench {
    /// The controller: its state, and the events that are pending.
    #[derive(Clone, PartialEq, Eq, Debug)]
    pub struct Controller {
        machine: ::controller_template::Machine<Tables, 1>,
    }

    impl Controller {
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
            RUNS.lookup(event.index(), state)
        }

        fn super_step(
            state: Self::State,
        ) -> ::core::option::Option<(Self::State, Commands)> {
            let (row, place) = RUNS.row(7, state)?;
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
            ::core::option::Option::Some((RUNS.target(7, place)?, commands))
        }
    }

    impl Tables {
        fn owed(state: u32) -> ::controller_template::Bits<1> {
            ::controller_template::Bits::of_state(&OWED_SET, &OWED, state)
        }
    }

    /// Events in table order, then the super steps.
    static RUNS: ::controller_template::Runs<
        [u16; 9],
        [u16; 8],
        [u8; 305],
        [u8; 305],
        [u8; 8],
          8, 427,
    > = ::controller_template::Runs {
        first: [0, 35, 72, 105, 139, 174, 208, 246, 305],
        start: [0, 432, 880, 1280, 1680, 2112, 2488, 2912],
        state: [
              1,   5,   7,  10,  13,  15,  19,  26,  31,  36,
             40,  43,  45,  47,  49,  56,  63,  70,  76,  79,
             82,  95,  97,  99, 104, 113, 118, 120, 122, 133,
            139, 142, 144, 146, 149,   1,   5,   7,  10,  12,
             15,  19,  21,  25,  29,  32,  36,  39,  43,  45,
             47,  52,  55,  63,  65,  69,  76,  81,  86,  90,
             95,  97, 104, 106, 114, 118, 120, 123, 131, 137,
            142, 144,   5,   7,  19,  21,  24,  26,  29,  31,
             36,  43,  46,  48,  51,  53,  55,  61,  63,  69,
             77,  79,  86,  88,  90,  97,  99, 104, 111, 120,
            131, 135, 142, 146, 149,  12,  21,  24,  26,  31,
             38,  43,  45,  49,  52,  55,  57,  61,  64,  67,
             70,  76,  80,  86,  90,  99, 111, 113, 118, 120,
            122, 124, 131, 135, 138, 140, 142, 146, 149,   1,
              5,   7,  12,  15,  25,  29,  31,  36,  38,  41,
             45,  47,  55,  63,  67,  74,  76,  83,  88,  90,
             93,  99, 106, 118, 122, 124, 127, 131, 135, 137,
            140, 142, 146, 149,   1,  12,  25,  32,  36,  38,
             43,  45,  47,  51,  55,  58,  61,  65,  69,  77,
             79,  83,  86,  93,  97, 100, 104, 111, 113, 118,
            122, 127, 131, 135, 137, 140, 143, 146,   1,   5,
              7,  10,  12,  15,  18,  21,  25,  29,  31,  39,
             41,  45,  50,  63,  67,  74,  77,  87,  90,  93,
             95,  97,  99, 101, 104, 111, 113, 118, 120, 122,
            127, 132, 136, 142, 146, 149,   0,   2,   3,   4,
              6,   8,   9,  11,  14,  16,  17,  20,  22,  23,
             27,  28,  30,  33,  34,  35,  37,  42,  44,  54,
             59,  60,  62,  66,  68,  71,  72,  73,  75,  85,
             89,  91,  92,  94,  96,  98, 102, 103, 107, 108,
            109, 110, 112, 115, 116, 117, 119, 121, 125, 126,
            128, 130, 141, 145, 148,
        ],
        end: [
             1,  2,  3,  4,  5,  6,  7,  8, 10, 11, 13, 14, 15, 16, 19, 21, 24, 25, 27, 29,
            32, 33, 34, 35, 37, 39, 40, 41, 42, 47, 49, 50, 51, 53, 54,  1,  2,  3,  4,  6,
             7,  8,  9, 10, 11, 12, 13, 16, 17, 18, 20, 21, 25, 26, 27, 29, 32, 35, 37, 38,
            39, 40, 41, 42, 43, 44, 45, 46, 51, 54, 55, 56,  1,  2,  3,  4,  5,  6,  7,  9,
            10, 11, 12, 14, 15, 16, 20, 21, 24, 25, 26, 30, 31, 32, 33, 34, 37, 38, 39, 40,
            42, 45, 47, 49, 50,  2,  3,  4,  5,  6,  9, 10, 12, 13, 15, 16, 17, 18, 20, 21,
            22, 25, 28, 31, 32, 34, 35, 36, 37, 38, 39, 40, 43, 44, 45, 46, 48, 49, 50,  1,
             2,  3,  5,  6,  8,  9, 11, 12, 14, 15, 16, 22, 24, 26, 27, 28, 32, 33, 34, 35,
            36, 38, 39, 40, 41, 42, 43, 46, 47, 49, 50, 51, 53, 54,  1,  3,  4,  5,  6,  7,
             8,  9, 12, 14, 15, 16, 17, 18, 19, 20, 23, 24, 26, 27, 28, 29, 31, 32, 34, 35,
            37, 38, 41, 42, 43, 44, 45, 47,  1,  2,  3,  4,  6,  7,  9, 10, 11, 12, 14, 15,
            16, 18, 20, 22, 23, 24, 28, 30, 31, 32, 33, 34, 35, 36, 37, 38, 40, 41, 42, 43,
            44, 45, 50, 51, 52, 53,  1,  2,  3,  4,  5,  6,  7,  8,  9, 10, 11, 12, 13, 14,
            15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34,
            35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54,
            56, 57, 58, 59, 60,
        ],
        base: [5, 1, 0, 3, 2, 4, 0, 21],
        width: [8, 8, 8, 8, 8, 8, 8, 8],
        bits: *b"\
            \x3c\x79\x1b\x12\x81\x82\x16\x8e\x62\x0a\x5e\x74\x07\x19\x02\x87\x05\x69\x44\x72\
            \x78\x77\x58\x6a\x4e\x90\x76\x62\x38\x84\x43\x3f\x4b\x8c\x18\x35\x22\x47\x8c\x72\
            \x85\x17\x18\x4e\x4d\x04\x50\x1c\x67\x4b\x79\x8f\x67\x00\x07\x7e\x46\x28\x4b\x59\
            \x3c\x6a\x3e\x55\x42\x86\x14\x41\x7d\x21\x13\x37\x18\x05\x54\x43\x59\x3d\x15\x70\
            \x57\x4a\x7b\x65\x5e\x4e\x31\x3a\x43\x2c\x4d\x66\x19\x28\x73\x3f\x1d\x41\x39\x23\
            \x5c\x0f\x33\x7a\x1f\x66\x73\x00\x26\x69\x35\x78\x08\x25\x41\x33\x5a\x51\x00\x7b\
            \x8d\x14\x15\x57\x05\x36\x92\x3d\x47\x8b\x0e\x02\x6e\x11\x66\x6c\x6c\x83\x2f\x64\
            \x72\x57\x4b\x05\x29\x3f\x5e\x28\x2a\x80\x67\x0f\x3a\x56\x1a\x35\x93\x41\x1a\x66\
            \x22\x0e\x76\x31\x4d\x41\x3a\x03\x36\x16\x67\x01\x82\x0d\x4d\x06\x22\x2c\x32\x38\
            \x61\x6e\x05\x00\x6d\x1b\x16\x67\x51\x89\x54\x0a\x44\x13\x52\x48\x7c\x38\x06\x3b\
            \x4e\x41\x8b\x49\x43\x28\x83\x73\x27\x91\x00\x0e\x83\x3b\x19\x06\x4b\x34\x85\x47\
            \x86\x46\x8b\x07\x10\x5e\x29\x2a\x25\x4c\x64\x68\x20\x0c\x81\x01\x76\x00\x01\x36\
            \x83\x13\x1a\x3d\x3f\x07\x7e\x01\x58\x2d\x03\x3f\x62\x4a\x48\x75\x66\x24\x41\x2e\
            \x50\x40\x34\x4d\x8d\x3e\x6c\x8d\x65\x38\x64\x38\x6f\x4e\x4d\x5a\x06\x65\x3b\x47\
            \x28\x43\x74\x80\x50\x41\x6e\x04\x42\x02\x36\x0c\x1d\x38\x0b\x00\x0c\x71\x65\x8e\
            \x03\x78\x22\x10\x79\x3c\x3d\x69\x76\x4f\x6b\x65\x4a\x79\x72\x73\x00\x5e\x73\x28\
            \x51\x33\x0f\x6b\x7a\x83\x5d\x39\x4a\x28\x91\x66\x0d\x17\x2e\x6b\x4a\x3a\x59\x80\
            \x77\x6e\x3f\x7e\x3c\x33\x13\x2a\x5e\x6a\x84\x19\x41\x51\x31\x7f\x30\x81\x33\x7e\
            \x3f\x03\x58\x88\x35\x3c\x63\x4a\x00\x38\x33\x69\x2e\x0f\x2f\x08\x5e\x41\x1a\x6f\
            \x1b\x78\x17\x7b\x5a\x5f\x21\x5d\x5f\x5a\x69\x67\x4c\x4e\x48\x49\x7a\x6d\x74\x4c\
            \x75\x6b\x62\x5e\x78\x55\x78\x5f\x6f\x5d\x7d\x66\x7f\x61\x6c\x7f\x6a\x7b\x74\x6d\
            \x70\x7d\x7e\x80\x00\x00\x00",
    };

    /// Codes that super steps command to `c0`; 0 is none.
    static C0_TARGET: [u8; 59] = [
        2, 0, 0, 0, 1, 0, 0, 2, 3, 1, 0, 0, 0, 3, 0, 0, 0, 0, 1, 0, 3, 2, 0, 0, 2, 3, 2, 1, 0, 3,
        1, 3, 1, 0, 0, 0, 0, 0, 0, 1, 0, 3, 0, 0, 0, 0, 1, 0, 3, 0, 1, 0, 3, 0, 0, 0, 2, 2, 0,
    ];

    /// Codes that super steps command to `c1`; 0 is none.
    static C1_TARGET: [u8; 59] = [
        0, 0, 0, 1, 0, 2, 0, 2, 1, 0, 0, 0, 1, 0, 0, 0, 0, 3, 0, 2, 0, 2, 3, 0, 0, 0, 2, 1, 2, 0,
        0, 3, 0, 0, 3, 0, 0, 0, 1, 1, 0, 0, 0, 2, 3, 2, 0, 2, 1, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0,
    ];

    /// Codes that super steps command to `c2`; 0 is none.
    static C2_TARGET: [u8; 59] = [
        0, 0, 2, 3, 2, 0, 0, 2, 1, 3, 3, 2, 2, 3, 2, 1, 0, 0, 0, 3, 2, 1, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 2, 0, 1, 1, 0, 0, 0, 0, 1, 3, 1, 0, 0, 0, 0, 0, 0, 2, 0, 3, 0, 2, 0, 1, 0,
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
}
