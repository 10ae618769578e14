//! The plant: two arms, a press and a belt on which blanks arrive. Every action takes a random number of cycles, and
//! what must not happen to steel is an accident.

use alloc::{borrow::ToOwned, format, string::String, vec::Vec};

use crate::production_cell::{DepositArm, Event, FeedArm, Press};
use crate::random::Random;

/// The longest that an action takes, in cycles.
const SLOWEST: u32 = 6;

/// Where an arm is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Place {
    FeedBelt,
    Press,
    DepositBelt,
}

/// What a component is doing.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Action {
    PickUp,
    Release,
    MoveTo(Place),
    Press,
}

/// A component that does one thing at a time.
#[derive(Debug)]
struct Worker {
    name: &'static str,
    action: Option<Action>,
    left: u32,
    accidents: Vec<String>,
}

impl Worker {
    fn new(name: &'static str) -> Self {
        Worker { name, action: None, left: 0, accidents: Vec::new() }
    }

    fn start(&mut self, action: Action) {
        if let Some(busy) = self.action {
            self.accidents.push(format!("{} gets {action:?} while it does {busy:?}", self.name));
        }
        self.action = Some(action);
        self.left = 0;
    }

    /// One cycle later: the action that is finished now. Its duration is drawn when it is first looked at.
    fn advance(&mut self, random: &mut Random) -> Option<Action> {
        self.action?;
        if self.left == 0 {
            self.left = random.up_to(SLOWEST);
        }
        self.left -= 1;
        if self.left == 0 { self.action.take() } else { None }
    }
}

/// An arm.
#[derive(Debug)]
pub struct Arm {
    worker: Worker,
    place: Place,
    carries: bool,
}

impl Arm {
    fn new(name: &'static str, place: Place) -> Self {
        Arm { worker: Worker::new(name), place, carries: false }
    }
}

/// The arm between feed belt and press.
#[derive(Debug)]
pub struct FeedArmDrive(Arm);

/// The arm between press and deposit belt.
#[derive(Debug)]
pub struct DepositArmDrive(Arm);

/// The press.
#[derive(Debug)]
pub struct PressDrive {
    worker: Worker,
    item: Option<Item>,
}

/// What lies in the press.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Item {
    Blank,
    Pressed,
}

impl FeedArm for FeedArmDrive {
    fn move_to_feed_belt(&mut self) {
        self.0.worker.start(Action::MoveTo(Place::FeedBelt));
    }
    fn move_to_press(&mut self) {
        self.0.worker.start(Action::MoveTo(Place::Press));
    }
    fn pick_up(&mut self) {
        self.0.worker.start(Action::PickUp);
    }
    fn release_item(&mut self) {
        self.0.worker.start(Action::Release);
    }
}

impl DepositArm for DepositArmDrive {
    fn move_to_deposit_belt(&mut self) {
        self.0.worker.start(Action::MoveTo(Place::DepositBelt));
    }
    fn move_to_press(&mut self) {
        self.0.worker.start(Action::MoveTo(Place::Press));
    }
    fn pick_up(&mut self) {
        self.0.worker.start(Action::PickUp);
    }
    fn release_item(&mut self) {
        self.0.worker.start(Action::Release);
    }
}

impl Press for PressDrive {
    fn start_pressing(&mut self) {
        self.worker.start(Action::Press);
    }
}

/// The whole cell.
pub struct Plant {
    /// Secondary of `feedArm`.
    pub feed_arm: FeedArmDrive,
    /// Secondary of `depositArm`.
    pub deposit_arm: DepositArmDrive,
    /// Secondary of `press`.
    pub press: PressDrive,
    blank_on_belt: bool,
    until_blank: u32,
    delivered: u64,
    accidents: Vec<String>,
    random: Random,
}

impl Plant {
    /// An empty cell: the arms wait at the feed belt and at the press.
    pub fn new(random: Random) -> Self {
        Plant {
            feed_arm: FeedArmDrive(Arm::new("the feed arm", Place::FeedBelt)),
            deposit_arm: DepositArmDrive(Arm::new("the deposit arm", Place::Press)),
            press: PressDrive { worker: Worker::new("the press"), item: None },
            blank_on_belt: false,
            until_blank: 1,
            delivered: 0,
            accidents: Vec::new(),
            random,
        }
    }

    /// Items on the deposit belt.
    pub fn delivered(&self) -> u64 {
        self.delivered
    }

    /// Accidents since the last call.
    pub fn accidents(&mut self) -> Vec<String> {
        let mut all = core::mem::take(&mut self.accidents);
        for worker in [&mut self.feed_arm.0.worker, &mut self.deposit_arm.0.worker, &mut self.press.worker] {
            all.append(&mut worker.accidents);
        }
        all
    }

    /// One cycle later: the sensors that have changed.
    pub fn advance(&mut self) -> Vec<Event> {
        let mut sensors = Vec::new();
        if !self.blank_on_belt {
            self.until_blank -= 1;
            if self.until_blank == 0 {
                self.blank_on_belt = true;
                sensors.push(Event::FeedBeltControllerBlankArrived);
            }
        }
        if let Some(action) = self.feed_arm.0.worker.advance(&mut self.random) {
            sensors.push(self.feed_arm_did(action));
        }
        if let Some(action) = self.deposit_arm.0.worker.advance(&mut self.random) {
            sensors.push(self.deposit_arm_did(action));
        }
        if self.press.worker.advance(&mut self.random).is_some() {
            if self.press.item != Some(Item::Blank) {
                self.accidents.push("the press closes on nothing".to_owned());
            }
            self.press.item = Some(Item::Pressed);
            sensors.push(Event::PressControllerPressingFinished);
        }
        sensors
    }

    fn feed_arm_did(&mut self, action: Action) -> Event {
        let arm = &mut self.feed_arm.0;
        match action {
            Action::MoveTo(place) => {
                arm.place = place;
                if place == Place::Press {
                    Event::FeedArmControllerArrivedAtPress
                } else {
                    Event::FeedArmControllerArrivedAtFeedBelt
                }
            }
            Action::PickUp => {
                if arm.place != Place::FeedBelt || arm.carries || !self.blank_on_belt {
                    self.accidents.push("the feed arm grips nothing".to_owned());
                }
                arm.carries = true;
                self.blank_on_belt = false;
                self.until_blank = self.random.up_to(2 * SLOWEST);
                Event::FeedArmControllerPickedUpItem
            }
            Action::Release | Action::Press => {
                if arm.place != Place::Press || !arm.carries || self.press.item.is_some() {
                    self.accidents.push("the feed arm drops a blank where it cannot lie".to_owned());
                }
                arm.carries = false;
                self.press.item = Some(Item::Blank);
                Event::FeedArmControllerReleasedItem
            }
        }
    }

    fn deposit_arm_did(&mut self, action: Action) -> Event {
        let arm = &mut self.deposit_arm.0;
        match action {
            Action::MoveTo(place) => {
                arm.place = place;
                if place == Place::Press {
                    Event::DepositArmControllerArrivedAtPress
                } else {
                    Event::DepositArmControllerArrivedAtDepositBelt
                }
            }
            Action::PickUp => {
                if arm.place != Place::Press || arm.carries || self.press.item != Some(Item::Pressed) {
                    self.accidents.push("the deposit arm grips what is not pressed".to_owned());
                }
                arm.carries = true;
                self.press.item = None;
                Event::DepositArmControllerPickedUpItem
            }
            Action::Release | Action::Press => {
                if arm.place != Place::DepositBelt || !arm.carries {
                    self.accidents.push("the deposit arm lets go off the belt".to_owned());
                }
                arm.carries = false;
                self.delivered += 1;
                Event::DepositArmControllerReleasedItem
            }
        }
    }
}
