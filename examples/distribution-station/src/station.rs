//! The station: what moves, moves a little in every step, at a speed that is never the same, and between two switches closes
//! neither. What must not happen to steel is an accident.

use alloc::{borrow::ToOwned, string::String, vec::Vec};

use crate::distribution_station::{Inputs, Outputs};
use crate::random::Random;

/// From one end of a movement to the other.
const WAY: u32 = 1000;
/// A switch closes so far from its end.
const REACH: u32 = 20;
/// Here the injector takes hold of the workpiece in the barrel.
const BARREL: u32 = 300;
/// So near to the dock the boom is in the way of the injector.
const IN_THE_WAY: u32 = 500;
/// The pressure switch closes at so much vacuum,
const HOLDS: u32 = 700;
/// and opens again at so little.
const LETS_GO: u32 = 300;
/// The most workpieces that someone puts into the empty barrel,
const FILLING: u32 = 8;
/// and the most steps that this takes.
const ABSENCE: u32 = 400;
/// The most steps from one scan to the next.
const SLOWEST_SCAN: u32 = 5;

/// The station, positions in thousandths.
#[derive(Debug)]
pub struct Station {
    random: Random,
    /// 0 at the barrel.
    injector: u32,
    /// 0 at the dock.
    boom: u32,
    vacuum: u32,
    holds: bool,
    /// Workpieces in the barrel.
    barrel: u32,
    until_filled: u32,
    /// Workpieces in front of the injector, on their way to the dock or on it.
    dock: u32,
    delivered: u64,
    accidents: Vec<String>,
}

impl Station {
    /// All at rest, nothing in the barrel.
    #[must_use]
    pub fn new(random: Random) -> Self {
        Station {
            random,
            injector: 0,
            boom: 0,
            vacuum: 0,
            holds: false,
            barrel: 0,
            until_filled: ABSENCE,
            dock: 0,
            delivered: 0,
            accidents: Vec::new(),
        }
    }

    /// What its sensors say.
    #[must_use]
    pub fn sensors(&self) -> Inputs {
        Inputs {
            x0: self.injector <= REACH,
            x1: self.injector >= WAY - REACH,
            x2: self.boom <= REACH,
            x3: self.boom >= WAY - REACH,
            x5: self.holds,
            x6: self.barrel == 0,
        }
    }

    /// Whether the boom is at the dock.
    #[must_use]
    pub fn boom_at_dock(&self) -> bool {
        self.boom <= REACH
    }

    /// Whether the boom is at the testing station.
    #[must_use]
    pub fn boom_at_testing(&self) -> bool {
        self.boom >= WAY - REACH
    }

    /// Whether the injector is back at the barrel.
    #[must_use]
    pub fn injector_is_back(&self) -> bool {
        self.injector <= REACH
    }

    /// Whether the injector is out at the dock.
    #[must_use]
    pub fn injector_is_out(&self) -> bool {
        self.injector >= WAY - REACH
    }

    /// Whether the hook holds a workpiece.
    #[must_use]
    pub fn hook_holds(&self) -> bool {
        self.holds
    }

    /// Whether there is a workpiece on the dock, or on the way to it.
    #[must_use]
    pub fn dock_is_taken(&self) -> bool {
        self.dock > 0
    }

    /// Whether there is nothing in the barrel.
    #[must_use]
    pub fn barrel_is_empty(&self) -> bool {
        self.barrel == 0
    }

    /// Whether injector or boom is between two switches.
    #[must_use]
    pub fn is_between(&self) -> bool {
        [self.injector, self.boom].iter().any(|at| (REACH + 1..WAY - REACH).contains(at))
    }

    /// Workpieces that were brought to the testing station.
    #[must_use]
    pub fn delivered(&self) -> u64 {
        self.delivered
    }

    /// What has gone wrong since the last time.
    pub fn accidents(&mut self) -> Vec<String> {
        core::mem::take(&mut self.accidents)
    }

    /// Until the next scan, which comes sooner or later.
    pub fn advance(&mut self, outputs: &Outputs) {
        for _ in 0..self.random.up_to(SLOWEST_SCAN) {
            self.move_injector(outputs);
            self.move_boom(outputs);
            self.change_vacuum(outputs);
            self.fill_barrel();
        }
    }

    fn move_injector(&mut self, outputs: &Outputs) {
        let (before, step) = (self.injector, 10 + self.random.up_to(40));
        if !outputs.y2 {
            self.injector = before.saturating_sub(step);
            self.accident(
                before > 0 && self.dock > 0,
                "a workpiece is let go of on the dock before the hook has it",
            );
            return;
        }
        self.injector = WAY.min(before + step);
        let moves = self.injector > before;
        self.accident(moves && self.boom < IN_THE_WAY, "the injector runs into the boom");
        if before < BARREL && self.injector >= BARREL {
            self.accident(self.barrel == 0, "the injector pushes nothing");
            self.accident(self.dock > 0, "a workpiece is pushed onto another");
            self.dock += self.barrel.min(1);
            self.barrel = self.barrel.saturating_sub(1);
        }
    }

    fn move_boom(&mut self, outputs: &Outputs) {
        let (before, step) = (self.boom, 5 + self.random.up_to(25));
        self.boom = match (outputs.y0, outputs.y1) {
            (true, false) => before.saturating_sub(step),
            (false, true) => WAY.min(before + step),
            (false, false) => before,
            (true, true) => {
                self.accident(true, "the boom is pulled to both sides");
                before
            }
        };
        // Within reach of a switch it settles against the stop.
        let moves = self.boom != before && !self.boom_at_dock() && !self.boom_at_testing();
        self.accident(
            moves && outputs.y4 && !self.holds,
            "the boom tears at a workpiece that it does not hold",
        );
        self.accident(moves && outputs.y3 && self.holds, "the boom throws a workpiece");
        self.accident(moves && self.holds && self.dock > 0, "the workpiece in the hook hits another");
    }

    /// Without a workpiece the hook sucks air only.
    fn change_vacuum(&mut self, outputs: &Outputs) {
        let closed = self.holds || self.boom_at_dock() && self.injector_is_out() && self.dock > 0;
        let step = 20 + self.random.up_to(60);
        self.vacuum = match (outputs.y3, outputs.y4 && closed) {
            (true, _) => self.vacuum.saturating_sub(3 * step),
            (false, true) => WAY.min(self.vacuum + step),
            (false, false) => self.vacuum.saturating_sub(1),
        };
        if !self.holds && self.vacuum >= HOLDS {
            self.holds = true;
            self.dock -= 1;
        } else if self.holds && self.vacuum <= LETS_GO {
            self.holds = false;
            self.accident(!self.boom_at_testing(), "a workpiece falls off the hook");
            self.delivered += 1;
        }
    }

    fn fill_barrel(&mut self) {
        if self.barrel > 0 {
            return;
        }
        self.until_filled -= 1;
        if self.until_filled == 0 {
            self.barrel = self.random.up_to(FILLING);
            self.until_filled = self.random.up_to(ABSENCE);
        }
    }

    fn accident(&mut self, happens: bool, what: &str) {
        if happens {
            self.accidents.push(what.to_owned());
        }
    }
}
