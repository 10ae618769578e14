//! A production line whose controller can have any number of transitions: stations in a row, a place for one item
//! before each, and items counted in batches behind the last.
//!
//! A station takes an item from its place, works on it, and puts it on the next place or discards it. What can be
//! commanded is commanded at once: a state of the controller has an event for every station that is busy.

/// Most stations of a line.
pub(super) const MOST: usize = 6;

/// What a station reports, in order of the texts.
pub(super) const REPORTS: [&str; 5] = ["failed", "finished", "home", "pickedUp", "released"];
/// What it is told, in order of the texts.
pub(super) const ORDERS: [&str; 3] = ["discard", "put", "take"];

const FAILED: usize = 0;
const FINISHED: usize = 1;
const HOME: usize = 2;
const PICKED_UP: usize = 3;
const RELEASED: usize = 4;

const DISCARD: usize = 0;
const PUT: usize = 1;
const TAKE: usize = 2;

/// What a station does.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default, Debug)]
enum Phase {
    #[default]
    Idle,
    Takes,
    Works,
    /// Has a good item, which it cannot put yet.
    Waits,
    /// Has a bad one.
    Holds,
    Puts,
    Discards,
    Returns,
}

/// A state of the line.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default, Debug)]
pub(super) struct Line {
    phases: [Phase; MOST],
    /// Whether an item lies before each station.
    items: [bool; MOST],
    /// Items delivered of the batch.
    delivered: u32,
}

/// What happens: a new item before the first station, or a report of a station.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Happening {
    Arrival,
    Report { station: usize, report: usize },
}

/// A command to a station.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Order {
    pub(super) station: usize,
    pub(super) order: usize,
}

/// How many stations there are, and items of a batch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shape {
    pub(super) stations: usize,
    pub(super) batch: u32,
}

impl Line {
    /// The same with so many items delivered.
    pub(super) fn with_delivered(self, delivered: u32) -> Line {
        Line { delivered, ..self }
    }

    /// Items delivered of the batch.
    pub(super) fn delivered(self) -> u32 {
        self.delivered
    }

    /// What can happen, and the state right after it.
    pub(super) fn happenings(self, shape: Shape) -> Vec<(Happening, Line)> {
        let mut all = Vec::new();
        if !self.items[0] {
            let mut after = self;
            after.items[0] = true;
            all.push((Happening::Arrival, after));
        }
        for station in 0..shape.stations {
            let mut report = |report, phase| {
                let mut after = self;
                after.phases[station] = phase;
                match (report, self.phases[station]) {
                    (PICKED_UP, _) => after.items[station] = false,
                    (RELEASED, Phase::Puts) if station + 1 < shape.stations => {
                        after.items[station + 1] = true;
                    }
                    (RELEASED, Phase::Puts) => after.delivered = (after.delivered + 1) % shape.batch,
                    _ => {}
                }
                all.push((Happening::Report { station, report }, after));
            };
            match self.phases[station] {
                Phase::Idle | Phase::Waits | Phase::Holds => {}
                Phase::Takes => report(PICKED_UP, Phase::Works),
                Phase::Works => {
                    report(FAILED, Phase::Holds);
                    report(FINISHED, Phase::Waits);
                }
                Phase::Puts | Phase::Discards => report(RELEASED, Phase::Returns),
                Phase::Returns => report(HOME, Phase::Idle),
            }
        }
        all
    }

    /// The state after everything that can be commanded now, and the commands in order of the stations.
    pub(super) fn react(mut self, shape: Shape) -> (Line, Vec<Order>) {
        let mut orders = Vec::new();
        for station in 0..shape.stations {
            // One station at a time reaches into a place.
            let free = |line: &Line| {
                station + 1 == shape.stations
                    || !line.items[station + 1] && line.phases[station + 1] != Phase::Takes
            };
            let alone = |line: &Line| {
                station == 0 || !matches!(line.phases[station - 1], Phase::Puts | Phase::Returns)
            };
            let (order, phase) = match self.phases[station] {
                Phase::Idle if self.items[station] && alone(&self) => (TAKE, Phase::Takes),
                Phase::Waits if free(&self) => (PUT, Phase::Puts),
                Phase::Holds => (DISCARD, Phase::Discards),
                _ => continue,
            };
            self.phases[station] = phase;
            orders.push(Order { station, order });
        }
        (self, orders)
    }
}

#[cfg(test)]
mod tests {
    use super::{Happening, Line, ORDERS, REPORTS, Shape};

    /// Plays reports, and returns the orders.
    #[track_caller]
    fn check(stations: usize, happenings: &str, orders: &str) {
        let shape = Shape { stations, batch: 2 };
        let mut line = Line::default();
        let mut said = Vec::new();
        for happening in happenings.split_whitespace() {
            let wanted = |&(which, _): &(Happening, Line)| match which {
                Happening::Arrival => happening == "arrival",
                Happening::Report { station, report } => {
                    format!("{station}.{}", REPORTS[report]) == happening
                }
            };
            let (_, after) = line.happenings(shape).into_iter().find(wanted).expect(happening);
            let (next, orders) = after.react(shape);
            said.extend(orders.iter().map(|order| format!("{}.{}", order.station, ORDERS[order.order])));
            line = next;
        }
        assert_eq!(said.join(" "), orders);
    }

    #[test]
    fn an_item_passes_a_station() {
        check(1, "arrival 0.pickedUp 0.finished 0.released 0.home", "0.take 0.put");
        check(1, "arrival 0.pickedUp 0.failed 0.released 0.home arrival", "0.take 0.discard 0.take");
    }

    #[test]
    fn the_next_station_takes_when_the_place_is_left() {
        check(2, "arrival 0.pickedUp 0.finished 0.released", "0.take 0.put");
        check(2, "arrival 0.pickedUp 0.finished 0.released 0.home", "0.take 0.put 1.take");
    }
}
