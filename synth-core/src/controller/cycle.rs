//! The interpreter of controllers: what every back end must do, cycle for cycle.
//!
//! Nothing here is clever. A back end is right when it issues the same commands and leaves the same events pending as
//! [`Machine`] does.

use super::{Controller, SuperStep};

/// What one call issued.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Commands {
    /// Per component its command code, 0 for none.
    pub codes: Vec<u32>,
    /// All system events in order, as indices into [`Controller::commands`]; those between controllable objects too.
    pub events: Vec<u32>,
}

/// A controller at work: its state and the events that are pending.
///
/// Events are indices into [`Controller::events`].
#[derive(Clone, Debug)]
pub struct Machine<'a> {
    controller: &'a Controller,
    /// Per command its component and code; `None` if it goes to a controllable object.
    code: Vec<Option<(usize, u32)>>,
    state: u32,
    pending: Vec<bool>,
}

impl<'a> Machine<'a> {
    /// In the initial state, nothing pending.
    #[must_use]
    pub fn new(controller: &'a Controller) -> Self {
        let mut code = vec![None; controller.commands.len()];
        for (component, commands) in controller.components.iter().map(|c| &c.commands).enumerate() {
            for (i, &command) in commands.iter().enumerate() {
                code[command as usize] = Some((component, i as u32 + 1));
            }
        }
        Machine { controller, code, state: controller.initial, pending: vec![false; controller.events.len()] }
    }

    /// Back to the initial state, nothing pending.
    pub fn reset(&mut self) {
        self.state = self.controller.initial;
        self.pending.fill(false);
    }

    /// The present state.
    #[must_use]
    pub fn state(&self) -> u32 {
        self.state
    }

    /// Makes an event pending; `false` if it was already, and the second is absorbed.
    ///
    /// # Panics
    ///
    /// If there is no such event.
    pub fn raise(&mut self, event: u32) -> bool {
        !std::mem::replace(&mut self.pending[event as usize], true)
    }

    /// Whether an event is pending.
    ///
    /// # Panics
    ///
    /// If there is no such event.
    #[must_use]
    pub fn is_pending(&self, event: u32) -> bool {
        self.pending[event as usize]
    }

    /// Whether an event has a row in the present state.
    ///
    /// # Panics
    ///
    /// If there is no such event.
    #[must_use]
    pub fn accepts(&self, event: u32) -> bool {
        self.successor(event).is_some()
    }

    /// The events that assumptions promise in the present state.
    #[must_use]
    pub fn owed(&self) -> &'a [u32] {
        &self.controller.owed[self.state as usize]
    }

    /// The pending events that fit nowhere: what is pending and has no row in the present state, to be asked after a
    /// cycle. None while a super step is due, for what fits nowhere now may fit after it.
    #[must_use]
    pub fn unexpected(&self) -> Vec<u32> {
        if self.due().is_some() {
            return Vec::new();
        }
        let events = 0..self.pending.len() as u32;
        events.filter(|&event| self.is_pending(event) && !self.accepts(event)).collect()
    }

    /// One cycle: consumes pending events in table order, over and over until none fits, then does at most one
    /// super step.
    pub fn cycle(&mut self) -> Commands {
        let mut commands = self.nothing();
        self.consume();
        if let Some(step) = self.due() {
            self.perform(step, &mut commands);
        }
        commands
    }

    /// Repeats the cycle until nothing more happens, or up to a super step that would command a component already
    /// commanded in this call; that one is left to the next call.
    ///
    /// A circle of super steps that command nothing would never end. No verified controller has one; here the call
    /// ends after as many super steps in a row as there are states.
    pub fn drain(&mut self) -> Commands {
        let mut commands = self.nothing();
        let mut in_a_row = 0;
        loop {
            if self.consume() {
                in_a_row = 0;
            }
            let Some(step) = self.due() else { break };
            if self.commands_again(step, &commands) || in_a_row == self.controller.states {
                break;
            }
            self.perform(step, &mut commands);
            in_a_row += 1;
        }
        commands
    }

    /// Takes one event with its super step, and leaves what is pending alone. `None` if the present state does not
    /// accept the event: nothing has happened then. Of a split super step this does the first part; [`Self::cycle`]
    /// does the others, one a call, and no event is accepted before. Where a super step is due, only events that have a row
    /// beside it are accepted: in controllers of scenarios there is none.
    ///
    /// # Panics
    ///
    /// If there is no such event.
    pub fn react(&mut self, event: u32) -> Option<Commands> {
        self.state = self.successor(event)?;
        let mut commands = self.nothing();
        if let Some(step) = self.due() {
            self.perform(step, &mut commands);
        }
        Some(commands)
    }

    fn nothing(&self) -> Commands {
        Commands { codes: vec![0; self.controller.components.len()], events: Vec::new() }
    }

    fn successor(&self, event: u32) -> Option<u32> {
        let rows = &self.controller.environment[event as usize];
        rows.binary_search_by_key(&self.state, |row| row.0).ok().map(|row| rows[row].1)
    }

    fn due(&self) -> Option<SuperStep<'a>> {
        self.controller.super_steps.due(self.state)
    }

    /// Consumes what fits; whether there was anything.
    fn consume(&mut self) -> bool {
        let mut any = false;
        loop {
            let mut changed = false;
            for event in 0..self.pending.len() as u32 {
                if !self.is_pending(event) {
                    continue;
                }
                if let Some(target) = self.successor(event) {
                    self.state = target;
                    self.pending[event as usize] = false;
                    changed = true;
                }
            }
            if !changed {
                return any;
            }
            any = true;
        }
    }

    fn commands_again(&self, step: SuperStep<'_>, commands: &Commands) -> bool {
        let mut codes = step.events.iter().filter_map(|&event| self.code[event as usize]);
        codes.any(|(component, _)| commands.codes[component] != 0)
    }

    fn perform(&mut self, step: SuperStep<'_>, commands: &mut Commands) {
        self.state = step.target;
        for &event in step.events {
            commands.events.push(event);
            if let Some((component, code)) = self.code[event as usize] {
                commands.codes[component] = code;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::fixtures::{controller, event_index};
    use super::*;

    /// Runs a script on a controller: `+a` raises (`+a!` when it is absorbed), `cycle`, `drain`, `a?` reacts, `reset`;
    /// after each call what it issued as `object=code`, and the state.
    #[track_caller]
    fn check(lines: &str, script: &str, expected: &str) {
        let controller = controller(lines);
        let mut machine = Machine::new(&controller);
        let mut log = Vec::new();
        for word in script.split_whitespace() {
            let commands = if let Some(short) = word.strip_prefix('+') {
                let absorbed = short.ends_with('!');
                assert_eq!(machine.raise(event_index(&controller, short.trim_end_matches('!'))), !absorbed);
                continue;
            } else if let Some(short) = word.strip_suffix('?') {
                match machine.react(event_index(&controller, short)) {
                    Some(commands) => commands,
                    None => {
                        log.push(format!("refused {}", machine.state()));
                        continue;
                    }
                }
            } else if word == "cycle" {
                machine.cycle()
            } else if word == "drain" {
                machine.drain()
            } else {
                assert_eq!(word, "reset");
                machine.reset();
                continue;
            };
            let codes = controller.components.iter().zip(&commands.codes).filter(|(_, code)| **code != 0);
            let codes: Vec<String> =
                codes.map(|(component, code)| format!("{}={code} ", component.object)).collect();
            log.push(format!("{}{}", codes.concat(), machine.state()));
        }
        assert_eq!(log.join("; "), expected);
    }

    #[track_caller]
    fn check_unexpected(lines: &str, raised: &[&str], pending: &[&str], unexpected: &[&str]) {
        let controller = controller(lines);
        let mut machine = Machine::new(&controller);
        for short in raised {
            machine.raise(event_index(&controller, short));
        }
        machine.cycle();
        let indices =
            |shorts: &[&str]| shorts.iter().map(|e| event_index(&controller, e)).collect::<Vec<u32>>();
        let left: Vec<u32> = (0..controller.events.len() as u32).filter(|&e| machine.is_pending(e)).collect();
        assert_eq!(left, indices(pending));
        assert_eq!(machine.unexpected(), indices(unexpected));
    }

    const ARM: &str = "0: a 1, b 0 \n 1! arm.go press.go 2 \n 2: b 3 \n 3! arm.stop 0";

    #[test]
    fn an_event_and_its_super_step_are_one_cycle() {
        check(ARM, "+a cycle cycle +b cycle", "arm=1 press=1 2; 2; arm=2 0");
    }

    #[test]
    fn without_an_event_nothing_happens() {
        check(ARM, "cycle drain", "0; 0");
    }

    #[test]
    fn an_initial_super_step_needs_no_event() {
        check("0! arm.go 1 \n 1:", "cycle cycle", "arm=1 1; 1");
    }

    #[test]
    fn an_event_is_one_bit() {
        check(ARM, "+a +a! cycle +a +a! cycle", "arm=1 press=1 2; 2");
    }

    #[test]
    fn several_events_are_consumed_in_one_cycle_whatever_their_order() {
        check("0: b 1 \n 1: c 2 \n 2: a 3 \n 3:", "+a +b +c cycle", "3");
    }

    #[test]
    fn table_order_decides_between_events_that_both_fit() {
        check("0: a 1, b 2 \n 1: b 3 \n 2: a 4 \n 3: \n 4:", "+b +a cycle", "3");
    }

    #[test]
    fn an_event_consumed_before_its_turn_in_the_loop_waits_for_the_next_round() {
        // In state 0 only `b` fits; `a` comes in the second round, before `c` has its second chance.
        check("0: b 1 \n 1: a 2, c 3 \n 2: \n 3: a 4 \n 4:", "+a +b +c cycle", "4");
    }

    #[test]
    fn a_cycle_does_at_most_one_super_step() {
        check("0: a 1 \n 1! arm.go 2 \n 2! arm.stop 3 \n 3:", "+a cycle cycle cycle", "arm=1 2; arm=2 3; 3");
    }

    #[test]
    fn events_after_the_super_step_wait_for_the_next_cycle() {
        check(ARM, "+a +b cycle cycle", "arm=1 press=1 2; arm=2 0");
    }

    #[test]
    fn drain_repeats_until_nothing_happens() {
        check(
            "0: a 1 \n 1! arm.go 2 \n 2: b 3 \n 3! press.go 4 \n 4: c 5 \n 5:",
            "+a +b +c drain",
            "arm=1 press=1 5",
        );
    }

    #[test]
    fn drain_stops_before_a_component_is_commanded_again() {
        check(ARM, "+a +b drain drain", "arm=1 press=1 3; arm=2 0");
    }

    #[test]
    fn drain_leaves_the_whole_super_step_to_the_next_call() {
        check(
            "0: a 1 \n 1! arm.go 2 \n 2! press.go arm.stop 3 \n 3:",
            "+a drain drain",
            "arm=1 2; arm=2 press=1 3",
        );
    }

    #[test]
    fn drain_ends_in_a_circle_of_super_steps_that_command_nothing() {
        check("0! log.x 1 \n 1! log.y 0", "drain", "0");
    }

    #[test]
    fn drain_may_do_more_super_steps_than_there_are_states() {
        check("0: a 1, b 1, c 1 \n 1! log.x 0", "+a +b +c drain", "0");
    }

    #[test]
    fn react_takes_an_event_with_its_super_step() {
        check(ARM, "b? a? a? b?", "0; arm=1 press=1 2; refused 2; arm=2 0");
    }

    #[test]
    fn react_does_the_first_part_of_a_split_super_step_and_cycles_the_others() {
        check(
            "0: a 1 \n 1! arm.go 2 \n 2! arm.stop 3 \n 3! arm.go 0",
            "a? a? cycle a? cycle a?",
            "arm=1 2; refused 2; arm=2 3; refused 3; arm=1 0; arm=1 2",
        );
    }

    #[test]
    fn react_accepts_nothing_before_the_initial_super_step() {
        check("0! arm.go 1 \n 1: a 1", "a? cycle a?", "refused 0; arm=1 1; 1");
    }

    #[test]
    fn react_leaves_pending_events_alone() {
        check("0: a 1, b 2 \n 1: b 3 \n 2: \n 3:", "+b a? cycle", "1; 3");
    }

    #[test]
    fn reset_forgets_state_and_events() {
        check(ARM, "+a cycle +b reset cycle", "arm=1 press=1 2; 0");
    }

    #[test]
    fn commands_list_events_between_controllable_objects_in_order() {
        let controller = controller("0! log.y arm.go log.x 1 \n 1:");
        let commands = Machine::new(&controller).cycle();
        assert_eq!(commands, Commands { codes: vec![1], events: vec![2, 0, 1] });
    }

    #[test]
    fn what_fits_nowhere_stays_pending_and_is_unexpected() {
        check_unexpected("0: a 1 \n 1: b 0", &["b"], &["b"], &["b"]);
        check_unexpected("0: a 1 \n 1: b 0", &["a", "b"], &[], &[]);
    }

    #[test]
    fn what_fits_after_the_super_step_is_not_unexpected() {
        check_unexpected(ARM, &["a", "b"], &["b"], &[]);
    }

    #[test]
    fn nothing_is_unexpected_while_a_super_step_is_due() {
        check_unexpected("0: a 1 \n 1! arm.go 2 \n 2! arm.stop 0 \n 3: b 0", &["a", "b"], &["b"], &[]);
    }

    #[test]
    fn accepts_and_owed_tell_of_the_present_state() {
        let mut controller = controller(ARM);
        controller.owed.set(2, &[1]);
        let mut machine = Machine::new(&controller);
        assert_eq!((machine.accepts(0), machine.accepts(1), machine.owed()), (true, true, &[][..]));
        machine.react(0).expect("`a` is accepted");
        assert_eq!((machine.accepts(0), machine.accepts(1), machine.owed()), (false, true, &[1][..]));
    }
}
