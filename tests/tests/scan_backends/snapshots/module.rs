// State-feedback controller of DistributionStation: generated, changes get lost.
// Generator: sml VERSION
// Plant: a.plant, input hash 0000000000000000
// To generate it again: sml export a.plant --target rust

/// State-feedback controller of the plant `DistributionStation`.
///
/// The distribution station of Festo's modular production system (Cote, St-Denis, Kerjean, ETFA 2005, section 5): an
/// injector pushes workpieces out of a barrel, a boom with a vacuum hook carries them to the next station.
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
    rustdoc::bare_urls,
    reason = "names and texts are the plant's"
)]
#[allow(
    clippy::cognitive_complexity,
    clippy::many_single_char_names,
    clippy::struct_excessive_bools,
    clippy::too_many_lines,
    clippy::trivially_copy_pass_by_ref,
    reason = "sizes are the plant's"
)]
pub mod distribution_station {
    /// What sensors say, read before a scan.
    #[derive(Clone, Copy, Default, PartialEq, Eq, Hash, Debug)]
    pub struct Inputs {
        /// `X0`
        pub x0: bool,
        /// `X1`
        pub x1: bool,
        /// `X2`
        pub x2: bool,
        /// `X3`
        pub x3: bool,
        /// `X5`
        pub x5: bool,
        /// `X6`
        pub x6: bool,
    }

    /// What a scan sets and resets, and reads as the last one left it; all of it off at first.
    #[derive(Clone, Copy, Default, PartialEq, Eq, Hash, Debug)]
    pub struct Outputs {
        /// `Y0`
        pub y0: bool,
        /// `Y1`
        pub y1: bool,
        /// `Y2`
        pub y2: bool,
        /// `Y3`
        pub y3: bool,
        /// `Y4`
        pub y4: bool,
    }

    /// What a scan can cause.
    #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
    pub enum Event {
        /// `inject`
        ///
        /// Push a workpiece onto the loading dock.
        ///
        /// Where `!Y0 && !Y2 && X0 && !X1 && !X2 && X3 && !X6 && (!Y4 || !Y3 && X5)`: set Y2.
        ///
        /// possible in Injector.I2B: 3 of 16 entries enable it
        /// inhibited by ClearDock in 13
        Inject,
        /// `reset`
        ///
        /// Draw the injector back.
        ///
        /// Where `!Y1 && Y2 && !Y3 && !X0 && X1 && X2 && !X3 && X5`: reset Y2.
        ///
        /// possible in Injector.I2D: 2 of 14 entries enable it
        /// inhibited by TakenFromDock in 12
        Reset,
        /// `right`
        ///
        /// Swing the boom to the testing station.
        ///
        /// Where `!Y1 && !Y2 && X2 && !X3 && (!X0 || !X1 && !X6) && (!Y3 && X5 || !Y4 && !X5)`: reset Y0, set Y1.
        ///
        /// possible in Boom.B2D: 6 of 14 entries enable it
        /// inhibited by RoomToSwing in 8
        Right,
        /// `left`
        ///
        /// Swing the boom to the loading dock.
        ///
        /// Where `!Y0 && !Y4 && !X2 && X3 && !X5 && (Y2 || X6) && (!Y2 || X1) && (!X0 || !X1)`: reset Y1, set Y0.
        ///
        /// possible in Boom.B2T: 4 of 24 entries enable it
        /// inhibited by EmptyHandedBack in 20
        Left,
        /// `grab`
        ///
        /// Vacuum on.
        ///
        /// Where `!Y1 && Y2 && !Y4 && !X0 && X1 && X2 && !X3 && !X5`: reset Y3, set Y4.
        ///
        /// possible in Hook.HF: 2 of 24 entries enable it
        /// inhibited by GrabOnDock in 22
        Grab,
        /// `rls`
        ///
        /// Vacuum off.
        ///
        /// Where `!Y0 && !Y3 && !X2 && X3 && X5 && (!X0 || !X1)`: reset Y4, set Y3.
        ///
        /// possible in Hook.HH: 8 of 18 entries enable it
        /// inhibited by ReleaseAtTesting in 10
        Rls,
    }

    impl Event {
        /// All of them, in the order of the plant.
        pub const ALL: [Self; 6] = [
            Self::Inject,
            Self::Reset,
            Self::Right,
            Self::Left,
            Self::Grab,
            Self::Rls,
        ];

        /// As the plant has it.
        #[must_use]
        pub const fn name(self) -> &'static str {
            match self {
                Self::Inject => "inject",
                Self::Reset => "reset",
                Self::Right => "right",
                Self::Left => "left",
                Self::Grab => "grab",
                Self::Rls => "rls",
            }
        }

        const fn number(self) -> usize {
            self as usize
        }
    }

    /// What a scan caused.
    #[derive(Clone, Copy, Default, PartialEq, Eq, Hash, Debug)]
    pub struct Events([u32; 1]);

    impl Events {
        /// Whether an event is one of them.
        #[must_use]
        pub const fn contains(self, event: Event) -> bool {
            self.0[event.number() / 32] >> (event.number() % 32) & 1 != 0
        }

        /// Whether nothing was caused.
        #[must_use]
        pub fn is_empty(self) -> bool {
            self.0.iter().all(|&word| word == 0)
        }

        /// All of them, in the order of the plant.
        pub fn iter(self) -> impl Iterator<Item = Event> {
            Event::ALL.into_iter().filter(move |&event| self.contains(event))
        }

        const fn insert(&mut self, event: Event) {
            self.0[event.number() / 32] |= 1 << (event.number() % 32);
        }
    }

    /// Does one scan: from inputs, and outputs as they are, finds what may be done, and does it.
    #[allow(
        unused_assignments,
        unused_mut,
        unused_variables,
        clippy::missing_const_for_fn,
        clippy::needless_pass_by_ref_mut,
        clippy::nonminimal_bool,
        clippy::overly_complex_bool_expr,
        clippy::suspicious_operation_groupings,
        clippy::useless_let_if_seq,
        reason = "formulas are the synthesis's"
    )]
    pub fn scan(inputs: &Inputs, outputs: &mut Outputs) -> Events {
        let mut events = Events::default();

        if !outputs.y0 && !outputs.y2 && inputs.x0 && !inputs.x1 && !inputs.x2
            && inputs.x3 && !inputs.x6 && (!outputs.y4 || !outputs.y3 && inputs.x5)
        {
            outputs.y2 = true;
            events.insert(Event::Inject);
        }

        if !outputs.y1 && outputs.y2 && !outputs.y3 && !inputs.x0 && inputs.x1
            && inputs.x2 && !inputs.x3 && inputs.x5
        {
            outputs.y2 = false;
            events.insert(Event::Reset);
        }

        if !outputs.y1 && !outputs.y2 && inputs.x2 && !inputs.x3
            && (!inputs.x0 || !inputs.x1 && !inputs.x6)
            && (!outputs.y3 && inputs.x5 || !outputs.y4 && !inputs.x5)
        {
            outputs.y0 = false;
            outputs.y1 = true;
            events.insert(Event::Right);
        }

        if !outputs.y0 && !outputs.y4 && !inputs.x2 && inputs.x3 && !inputs.x5
            && (outputs.y2 || inputs.x6) && (!outputs.y2 || inputs.x1)
            && (!inputs.x0 || !inputs.x1)
        {
            outputs.y1 = false;
            outputs.y0 = true;
            events.insert(Event::Left);
        }

        if !outputs.y1 && outputs.y2 && !outputs.y4 && !inputs.x0 && inputs.x1
            && inputs.x2 && !inputs.x3 && !inputs.x5
        {
            outputs.y3 = false;
            outputs.y4 = true;
            events.insert(Event::Grab);
        }

        if !outputs.y0 && !outputs.y3 && !inputs.x2 && inputs.x3 && inputs.x5
            && (!inputs.x0 || !inputs.x1)
        {
            outputs.y4 = false;
            outputs.y3 = true;
            events.insert(Event::Rls);
        }

        events
    }
}
