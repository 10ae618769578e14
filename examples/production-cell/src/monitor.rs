//! A monitor of G1 to G5, written from their informal text alone: it knows neither states nor tables.
//!
//! It keeps its own picture of the cell and a list of duties. A command must be a duty that is possible now; and
//! before the next event no duty that is possible may be left.

use alloc::{format, string::String, vec::Vec};

use crate::production_cell::{Commands, DepositArmCommand, Event, FeedArmCommand, PressCommand};

/// What the controller has to command, once it is possible.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Duty {
    /// G1: pick up a blank, when the feed arm is at the feed belt and carries nothing.
    PickUpBlank,
    /// G2: bring it to the press,
    FeedArmToPress,
    /// put it down, when the press is empty,
    ReleaseIntoPress,
    /// and return.
    FeedArmToBelt,
    /// G3: press.
    Press,
    /// G4: pick up a pressed item, when the deposit arm is at the press and carries nothing.
    PickUpPressed,
    /// G5: bring it to the deposit belt,
    DepositArmToBelt,
    /// put it down,
    ReleaseOntoBelt,
    /// and return.
    DepositArmToPress,
}

/// The monitor's picture of the cell, its open duties and what it has found.
#[derive(Debug)]
pub struct Monitor {
    /// What was violated.
    pub violations: Vec<String>,
    duties: Vec<Duty>,
    feed_arm_at_belt: bool,
    feed_arm_carries: bool,
    deposit_arm_at_press: bool,
    deposit_arm_carries: bool,
    press_occupied: bool,
}

impl Default for Monitor {
    fn default() -> Self {
        Monitor {
            violations: Vec::new(),
            duties: Vec::new(),
            feed_arm_at_belt: true,
            feed_arm_carries: false,
            deposit_arm_at_press: true,
            deposit_arm_carries: false,
            press_occupied: false,
        }
    }
}

impl Monitor {
    fn is_possible(&self, duty: Duty) -> bool {
        match duty {
            Duty::PickUpBlank => self.feed_arm_at_belt && !self.feed_arm_carries,
            Duty::ReleaseIntoPress => !self.press_occupied,
            Duty::PickUpPressed => self.deposit_arm_at_press && !self.deposit_arm_carries,
            _ => true,
        }
    }

    /// An event was consumed.
    pub fn event(&mut self, event: Event) {
        for &duty in &self.duties {
            if self.is_possible(duty) {
                self.violations.push(format!("{duty:?} was possible, but not commanded before {event:?}"));
            }
        }
        match event {
            Event::FeedBeltControllerBlankArrived => self.duties.push(Duty::PickUpBlank),
            Event::FeedArmControllerPickedUpItem => {
                self.feed_arm_carries = true;
                self.duties.push(Duty::FeedArmToPress);
            }
            Event::FeedArmControllerArrivedAtPress => {
                self.feed_arm_at_belt = false;
                self.duties.push(Duty::ReleaseIntoPress);
            }
            Event::FeedArmControllerReleasedItem => {
                self.feed_arm_carries = false;
                self.press_occupied = true;
                self.duties.extend([Duty::FeedArmToBelt, Duty::Press]);
            }
            Event::FeedArmControllerArrivedAtFeedBelt => self.feed_arm_at_belt = true,
            Event::PressControllerPressingFinished => self.duties.push(Duty::PickUpPressed),
            Event::DepositArmControllerPickedUpItem => {
                self.deposit_arm_carries = true;
                self.press_occupied = false;
                self.duties.push(Duty::DepositArmToBelt);
            }
            Event::DepositArmControllerArrivedAtDepositBelt => {
                self.deposit_arm_at_press = false;
                self.duties.push(Duty::ReleaseOntoBelt);
            }
            Event::DepositArmControllerReleasedItem => {
                self.deposit_arm_carries = false;
                self.duties.push(Duty::DepositArmToPress);
            }
            Event::DepositArmControllerArrivedAtPress => self.deposit_arm_at_press = true,
        }
    }

    /// Commands were issued.
    pub fn commands(&mut self, commands: Commands) {
        let feed_arm = commands.feed_arm.map(|command| match command {
            FeedArmCommand::PickUp => Duty::PickUpBlank,
            FeedArmCommand::MoveToPress => Duty::FeedArmToPress,
            FeedArmCommand::ReleaseItem => Duty::ReleaseIntoPress,
            FeedArmCommand::MoveToFeedBelt => Duty::FeedArmToBelt,
        });
        let press = commands.press.map(|PressCommand::StartPressing| Duty::Press);
        let deposit_arm = commands.deposit_arm.map(|command| match command {
            DepositArmCommand::PickUp => Duty::PickUpPressed,
            DepositArmCommand::MoveToDepositBelt => Duty::DepositArmToBelt,
            DepositArmCommand::ReleaseItem => Duty::ReleaseOntoBelt,
            DepositArmCommand::MoveToPress => Duty::DepositArmToPress,
        });
        for duty in [feed_arm, press, deposit_arm].into_iter().flatten() {
            match self.duties.iter().position(|&open| open == duty) {
                Some(open) if self.is_possible(duty) => drop(self.duties.remove(open)),
                _ => self.violations.push(format!("{duty:?} was commanded, but not due")),
            }
        }
    }
}
