//! Three robots in a line: one feeds a table from a belt, one works the items and puts them on a rack, one delivers them
//! from there. Table and rack hold one item, and one robot at a time reaches into each; feeding and delivering robot
//! drive on one rail. What can be commanded is commanded at once.

/// What the sensors report, in table order.
pub(super) const EVENTS: [&str; 18] = [
    "depositRobot -> controller.arrivedAt(depositBelt)",
    "depositRobot -> controller.arrivedAt(rack)",
    "depositRobot -> controller.left(rack)",
    "depositRobot -> controller.pickedUpItem()",
    "depositRobot -> controller.releasedItem()",
    "feedBelt -> controller.blankArrived()",
    "feedRobot -> controller.arrivedAt(feedBelt)",
    "feedRobot -> controller.arrivedAt(table)",
    "feedRobot -> controller.pickedUpItem()",
    "feedRobot -> controller.releasedItem()",
    "workerRobot -> controller.arrivedAt(table)",
    "workerRobot -> controller.clampedItem()",
    "workerRobot -> controller.finishedGoodItem()",
    "workerRobot -> controller.finishedScrap()",
    "workerRobot -> controller.left(rack)",
    "workerRobot -> controller.left(table)",
    "workerRobot -> controller.pickedUpItem()",
    "workerRobot -> controller.releasedItem()",
];

const DELIVER: &str = "controller -> depositRobot.deliver()";
const TAKE_FROM_RACK: &str = "controller -> depositRobot.pickUp()";
const FETCH: &str = "controller -> feedRobot.fetch()";
const PUT_ON_TABLE: &str = "controller -> feedRobot.releaseItem()";
const TAKE_FROM_TABLE: &str = "controller -> workerRobot.pickUp()";
const PUT_ON_RACK: &str = "controller -> workerRobot.releaseItem()";

/// In table order.
pub(super) const COMMANDS: [&str; 6] =
    [DELIVER, TAKE_FROM_RACK, FETCH, PUT_ON_TABLE, TAKE_FROM_TABLE, PUT_ON_RACK];

/// The robot between belt and table; it is on the rail when it fetches and carries.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Default)]
enum Feed {
    #[default]
    Idle,
    Fetches,
    Carries,
    WaitsForTable,
    Releases,
    Returns,
}

/// The robot between table and rack.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Default)]
enum Worker {
    #[default]
    Idle,
    Takes,
    LeavesTable,
    Clamps,
    Works,
    WaitsForRack,
    Releases,
    LeavesRack,
    Returns,
}

/// The robot behind the rack; it is on the rail when it delivers.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Default)]
enum Deposit {
    #[default]
    Idle,
    Takes,
    LeavesRack,
    WaitsForRail,
    Delivers,
    Releases,
    Returns,
}

/// A state of the line.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Default)]
pub(super) struct Line {
    blank: bool,
    feed: Feed,
    table: bool,
    worker: Worker,
    /// Whether the worker's item is scrap.
    scrap: bool,
    /// An item, and whether it is scrap.
    rack: Option<bool>,
    deposit: Deposit,
    /// Whether the number of delivered items is odd.
    odd: bool,
}

impl Line {
    /// The same with one item delivered more or less.
    pub(super) fn twin(self) -> Line {
        Line { odd: !self.odd, ..self }
    }

    /// What can happen, and the state right after it.
    pub(super) fn events(self) -> Vec<(&'static str, Line)> {
        let mut events = Vec::new();
        if !self.blank && self.feed != Feed::Returns {
            events.push(("feedBelt -> controller.blankArrived()", Line { blank: true, ..self }));
        }
        events.extend(self.of_feed());
        events.extend(self.of_worker());
        if self.worker == Worker::Works {
            let scrap = Line { worker: Worker::WaitsForRack, scrap: true, ..self };
            events.push(("workerRobot -> controller.finishedScrap()", scrap));
        }
        events.extend(self.of_deposit());
        events
    }

    fn of_feed(self) -> Option<(&'static str, Line)> {
        let moved = |feed| Line { feed, ..self };
        Some(match self.feed {
            Feed::Fetches => ("feedRobot -> controller.pickedUpItem()", moved(Feed::Carries)),
            Feed::Carries => (
                "feedRobot -> controller.arrivedAt(table)",
                Line { blank: false, ..moved(Feed::WaitsForTable) },
            ),
            Feed::Releases => {
                ("feedRobot -> controller.releasedItem()", Line { table: true, ..moved(Feed::Returns) })
            }
            Feed::Returns => ("feedRobot -> controller.arrivedAt(feedBelt)", moved(Feed::Idle)),
            Feed::Idle | Feed::WaitsForTable => return None,
        })
    }

    fn of_worker(self) -> Option<(&'static str, Line)> {
        let moved = |worker| Line { worker, ..self };
        Some(match self.worker {
            Worker::Takes => (
                "workerRobot -> controller.pickedUpItem()",
                Line { table: false, ..moved(Worker::LeavesTable) },
            ),
            Worker::LeavesTable => ("workerRobot -> controller.left(table)", moved(Worker::Clamps)),
            Worker::Clamps => ("workerRobot -> controller.clampedItem()", moved(Worker::Works)),
            Worker::Works => ("workerRobot -> controller.finishedGoodItem()", moved(Worker::WaitsForRack)),
            Worker::Releases => (
                "workerRobot -> controller.releasedItem()",
                Line { rack: Some(self.scrap), scrap: false, ..moved(Worker::LeavesRack) },
            ),
            Worker::LeavesRack => ("workerRobot -> controller.left(rack)", moved(Worker::Returns)),
            Worker::Returns => ("workerRobot -> controller.arrivedAt(table)", moved(Worker::Idle)),
            Worker::Idle | Worker::WaitsForRack => return None,
        })
    }

    fn of_deposit(self) -> Option<(&'static str, Line)> {
        let moved = |deposit| Line { deposit, ..self };
        Some(match self.deposit {
            Deposit::Takes => (
                "depositRobot -> controller.pickedUpItem()",
                Line { rack: None, ..moved(Deposit::LeavesRack) },
            ),
            Deposit::LeavesRack => ("depositRobot -> controller.left(rack)", moved(Deposit::WaitsForRail)),
            Deposit::Delivers => {
                ("depositRobot -> controller.arrivedAt(depositBelt)", moved(Deposit::Releases))
            }
            Deposit::Releases => (
                "depositRobot -> controller.releasedItem()",
                Line { odd: !self.odd, ..moved(Deposit::Returns) },
            ),
            Deposit::Returns => ("depositRobot -> controller.arrivedAt(rack)", moved(Deposit::Idle)),
            Deposit::Idle | Deposit::WaitsForRail => return None,
        })
    }

    /// The state after what is commanded now, and the commands.
    pub(super) fn react(mut self) -> (Line, Vec<&'static str>) {
        let mut commands = Vec::new();
        if self.deposit == Deposit::WaitsForRail && !matches!(self.feed, Feed::Fetches | Feed::Carries) {
            self.deposit = Deposit::Delivers;
            commands.push(DELIVER);
        }
        if self.feed == Feed::Idle && self.blank && self.deposit != Deposit::Delivers {
            self.feed = Feed::Fetches;
            commands.push(FETCH);
        }
        if self.worker == Worker::Idle && self.table && !matches!(self.feed, Feed::Releases | Feed::Returns) {
            self.worker = Worker::Takes;
            commands.push(TAKE_FROM_TABLE);
        }
        let table_is_free = !self.table && !matches!(self.worker, Worker::Takes | Worker::LeavesTable);
        if self.feed == Feed::WaitsForTable && table_is_free {
            self.feed = Feed::Releases;
            commands.push(PUT_ON_TABLE);
        }
        let worker_at_rack = matches!(self.worker, Worker::Releases | Worker::LeavesRack);
        if self.deposit == Deposit::Idle && self.rack.is_some() && !worker_at_rack {
            self.deposit = Deposit::Takes;
            commands.push(TAKE_FROM_RACK);
        }
        let deposit_at_rack = matches!(self.deposit, Deposit::Takes | Deposit::LeavesRack);
        if self.worker == Worker::WaitsForRack && self.rack.is_none() && !deposit_at_rack {
            self.worker = Worker::Releases;
            commands.push(PUT_ON_RACK);
        }
        (self, commands)
    }
}
