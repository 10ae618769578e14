// From tables at random, written by the tests of the Rust back end.

/// Controller of the specification `bench`.
///
/// 150 states, 7 environment events with 364 rows, 60 super steps.
///
/// Looking up an event takes at most 7 probes of its table, a super step 7. A cycle looks up at most 28 events.
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
            match event {
                Event::EnvCtlE0000 => ENV_CTL_E0000.lookup(state),
                Event::EnvCtlE0001 => ENV_CTL_E0001.lookup(state),
                Event::EnvCtlE0002 => ENV_CTL_E0002.lookup(state),
                Event::EnvCtlE0003 => ENV_CTL_E0003.lookup(state),
                Event::EnvCtlE0004 => ENV_CTL_E0004.lookup(state),
                Event::EnvCtlE0005 => ENV_CTL_E0005.lookup(state),
                Event::EnvCtlE0006 => ENV_CTL_E0006.lookup(state),
            }
        }

        fn super_step(
            state: Self::State,
        ) -> ::core::option::Option<(Self::State, Commands)> {
            let row = SUPER_STEPS.row(state)?;
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
            ::core::option::Option::Some((SUPER_STEPS.target(row)?, commands))
        }
    }

    impl Tables {
        fn owed(state: u32) -> ::controller_template::Bits<1> {
            ::controller_template::Bits::of_state(&OWED_SET, &OWED, state)
        }
    }

    /// `env -> ctl.e0000()`
    static ENV_CTL_E0000: ::controller_template::Mapping<[u8; 54]> = ::controller_template::Mapping::new(
        [
              1,   5,   7,  10,  13,  15,  19,  26,  31,  32,
             36,  40,  41,  43,  45,  47,  49,  50,  51,  56,
             57,  63,  64,  65,  70,  76,  77,  79,  80,  82,
             83,  84,  95,  97,  99, 104, 105, 113, 114, 118,
            120, 122, 133, 134, 135, 136, 137, 139, 140, 142,
            144, 146, 147, 149,
        ],
        [
             65, 126,  32,  23, 134, 135,  27, 147, 103,  15,
             99, 121,  12,  30,   7, 140,  10, 110,  73, 119,
            125, 124,  93, 111,  83, 149, 123, 103,  61, 137,
             72,  68,  80, 145,  29,  58,  39,  76, 145, 119,
            138,  28,  29,  83,  82,   9,  85,  33, 108,  80,
            126, 148, 108,   5,
        ],
    );

    /// `env -> ctl.e0001()`
    static ENV_CTL_E0001: ::controller_template::Mapping<[u8; 56]> = ::controller_template::Mapping::new(
        [
              1,   5,   7,  10,  12,  13,  15,  19,  21,  25,
             29,  32,  36,  39,  40,  41,  43,  45,  47,  48,
             52,  55,  56,  57,  58,  63,  65,  69,  70,  76,
             77,  78,  81,  82,  83,  86,  87,  90,  95,  97,
            104, 106, 114, 118, 120, 123, 131, 132, 133, 134,
            135, 137, 138, 139, 142, 144,
        ],
        [
              8, 127,  71,  41,  76,  90,  61, 107,  63,  86,
             67, 135,  21,  66, 126,  34,  20,  56,  25,   6,
             85,  68,  90,  62,  22, 113,  88,  75, 124, 102,
             95,  79,  50,  59,  68,  45,  78, 103,  26,  41,
            116,  64,  30,  66,  58,  36,  93,  16,  52, 123,
             32, 103, 116,   1,  39, 106,
        ],
    );

    /// `env -> ctl.e0002()`
    static ENV_CTL_E0002: ::controller_template::Mapping<[u8; 50]> = ::controller_template::Mapping::new(
        [
              5,   7,  19,  21,  24,  26,  29,  31,  32,  36,
             43,  46,  48,  49,  51,  53,  55,  56,  57,  58,
             61,  63,  64,  65,  69,  77,  79,  80,  81,  82,
             86,  88,  90,  97,  99, 100, 101, 104, 111, 120,
            131, 132, 135, 136, 137, 142, 143, 146, 147, 149,
        ],
        [
             53, 120,   8,  37,  65,  51,  90,  81,   0, 123,
            141,  20,  21,  87,   5,  54, 146,  61,  71, 139,
             14,   2, 110,  17, 102, 108, 108, 131,  47, 100,
            114,  87,  75,   5,  41,  63,  94,  40,  42, 128,
            103,  15,  58,  86,  26,  53, 147,  65,  26, 102,
        ],
    );

    /// `env -> ctl.e0003()`
    static ENV_CTL_E0003: ::controller_template::Mapping<[u8; 50]> = ::controller_template::Mapping::new(
        [
             12,  13,  21,  24,  26,  31,  38,  39,  40,  43,
             45,  46,  49,  52,  53,  55,  57,  61,  64,  65,
             67,  70,  76,  77,  78,  80,  81,  82,  86,  87,
             88,  90,  99, 100, 111, 113, 118, 120, 122, 124,
            131, 132, 133, 135, 138, 140, 142, 143, 146, 149,
        ],
        [
             37,  17, 121,  52,  80,  68,  61,   6,  57,  25,
            106,   4, 133,  16,  80,   9,  37,  47,  53,  59,
            100, 113,   8,   3, 112,  30,  25, 106,  84, 140,
             87,  13,  71,  22,  85,  75, 127,  59,   9,  62,
             81,  68, 142,  76,  70,  43, 134, 118,  42, 148,
        ],
    );

    /// `env -> ctl.e0004()`
    static ENV_CTL_E0004: ::controller_template::Mapping<[u8; 54]> = ::controller_template::Mapping::new(
        [
              1,   5,   7,  12,  13,  15,  25,  26,  29,  31,
             32,  36,  38,  39,  41,  45,  47,  48,  49,  50,
             51,  52,  55,  56,  63,  64,  67,  74,  76,  77,
             78,  79,  83,  88,  90,  93,  99, 100, 106, 118,
            122, 124, 127, 131, 132, 133, 135, 137, 138, 140,
            142, 146, 147, 149,
        ],
        [
              2,  16, 133,  61,  27,   8,  77,  54, 135,  73,
            136,  72, 141,   9,  18,  96,  43,  44,  39,  78,
            102, 106,  34,  14, 131,   3, 120,   2,   3,  56,
            133,  21,  28,  63,  65,   9, 128,   3,  90,  47,
              5,  65, 100,  76,  74, 119, 104,  38,  67,  48,
             82,  66,  54,  79,
        ],
    );

    /// `env -> ctl.e0005()`
    static ENV_CTL_E0005: ::controller_template::Mapping<[u8; 47]> = ::controller_template::Mapping::new(
        [
              1,  12,  13,  25,  32,  36,  38,  43,  45,  47,
             48,  49,  51,  52,  55,  58,  61,  65,  69,  77,
             79,  80,  81,  83,  86,  87,  93,  97, 100, 104,
            105, 111, 113, 114, 118, 122, 123, 127, 131, 132,
            133, 135, 137, 140, 143, 146, 147,
        ],
        [
            145,  66, 112, 145, 105,  60, 104,  60, 115,  82,
             81,  94,  10, 105,  63,  75,  44,  71, 120, 132,
             84,  69, 114,   8,  70,   6,  58,  16,  33,  60,
             15,   4,  16, 117, 105, 146,   7, 124,  38,  20,
            125,  64,  65, 109, 122,  83, 111,
        ],
    );

    /// `env -> ctl.e0006()`
    static ENV_CTL_E0006: ::controller_template::Mapping<[u8; 53]> = ::controller_template::Mapping::new(
        [
              1,   5,   7,  10,  12,  13,  15,  18,  19,  21,
             25,  29,  31,  32,  39,  41,  45,  46,  50,  51,
             63,  64,  67,  74,  77,  78,  79,  80,  87,  88,
             90,  93,  95,  97,  99, 101, 104, 111, 113, 114,
            118, 120, 122, 127, 132, 136, 137, 138, 139, 140,
            142, 146, 149,
        ],
        [
            101,  74, 121, 114, 115,   0,  94, 115,  40,  81,
             51,  15, 107, 122, 131,  93,  57,  74,  40, 145,
            102,  13,  23,  46, 107,  74,  58,  89, 128, 119,
            110,  63, 126,  60,  51,  19,  42,  94, 106, 132,
             25,  65,  81,  49, 127,  48, 129,  51, 126,  63,
              3,  88, 136,
        ],
    );

    /// Super steps.
    static SUPER_STEPS: ::controller_template::Mapping<[u8; 60]> = ::controller_template::Mapping::new(
        [
              0,   2,   3,   4,   6,   8,   9,  11,  14,  16,
             17,  20,  22,  23,  27,  28,  30,  33,  34,  35,
             37,  42,  44,  54,  59,  60,  62,  66,  68,  71,
             72,  73,  75,  85,  89,  91,  92,  94,  96,  98,
            102, 103, 107, 108, 109, 110, 112, 115, 116, 117,
            119, 121, 125, 126, 128, 129, 130, 141, 145, 148,
        ],
        [
             74,  81, 120,  95,  21,  77,  72, 126,  67,  36,
             68,  29, 115,  86,  47, 132,  48, 141,  44, 144,
            111, 116,  54, 114, 116, 111, 126, 124,  97,  99,
             93,  94, 143, 130, 137,  97, 138, 128, 119, 115,
            141, 106, 141, 116, 132, 114, 146, 123, 148, 118,
            129, 148, 127, 144, 137, 130, 133, 146, 147, 149,
        ],
    );

    /// Codes that super steps command to `c0`; 0 is none.
    static C0_TARGET: [u8; 60] = [
        2, 0, 0, 0, 1, 0, 0, 2, 3, 1, 0, 0, 0, 3, 0, 0, 0, 0, 1, 0, 3, 2, 0, 0, 2, 3, 2, 1, 0, 3,
        1, 3, 1, 0, 0, 0, 0, 0, 0, 1, 0, 3, 0, 0, 0, 0, 1, 0, 3, 0, 1, 0, 3, 0, 0, 0, 0, 2, 2, 0,
    ];

    /// Codes that super steps command to `c1`; 0 is none.
    static C1_TARGET: [u8; 60] = [
        0, 0, 0, 1, 0, 2, 0, 2, 1, 0, 0, 0, 1, 0, 0, 0, 0, 3, 0, 2, 0, 2, 3, 0, 0, 0, 2, 1, 2, 0,
        0, 3, 0, 0, 3, 0, 0, 0, 1, 1, 0, 0, 0, 2, 3, 2, 0, 2, 1, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0,
    ];

    /// Codes that super steps command to `c2`; 0 is none.
    static C2_TARGET: [u8; 60] = [
        0, 0, 2, 3, 2, 0, 0, 2, 1, 3, 3, 2, 2, 3, 2, 1, 0, 0, 0, 3, 2, 1, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 2, 0, 1, 1, 0, 0, 0, 0, 1, 3, 1, 0, 0, 0, 0, 0, 0, 2, 0, 3, 0, 0, 2, 0, 1, 0,
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
