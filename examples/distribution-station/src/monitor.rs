//! A monitor of what is asked of the station, written from the words alone: it knows neither states nor formulas.
//!
//! It looks at the station, not at the sensors, and judges every command in the scan that gives it.

use alloc::{format, string::String, vec::Vec};
use core::fmt;

use crate::distribution_station::Outputs;
use crate::station::Station;

/// What an output that changes tells the station to do.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Command {
    /// Y2 goes on.
    PushOut,
    /// Y2 goes off.
    DrawBack,
    /// Y1 goes on.
    SwingToTesting,
    /// Y0 goes on.
    SwingToDock,
    /// Y4 goes on.
    Grip,
    /// Y3 goes on.
    LetGo,
}

impl Command {
    /// What a scan has commanded that found outputs as they were `before`, and left them as they are `after`.
    pub fn given(before: &Outputs, after: &Outputs) -> impl Iterator<Item = Command> + use<> {
        let edges = [
            (!before.y2 && after.y2, Command::PushOut),
            (before.y2 && !after.y2, Command::DrawBack),
            (!before.y1 && after.y1, Command::SwingToTesting),
            (!before.y0 && after.y0, Command::SwingToDock),
            (!before.y4 && after.y4, Command::Grip),
            (!before.y3 && after.y3, Command::LetGo),
        ];
        edges.into_iter().filter_map(|(given, command)| given.then_some(command))
    }
}

impl fmt::Display for Command {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Command::PushOut => "push a workpiece out",
            Command::DrawBack => "draw the injector back",
            Command::SwingToTesting => "swing the boom to the testing station",
            Command::SwingToDock => "swing the boom to the dock",
            Command::Grip => "vacuum on",
            Command::LetGo => "vacuum off",
        })
    }
}

/// What starts has to have come to an end before.
const UNFINISHED: &str = "the last movement is not finished";

/// What it has found.
#[derive(Debug, Default)]
pub struct Monitor {
    /// What was violated.
    pub violations: Vec<String>,
}

impl Monitor {
    /// A scan has given a command; `outputs` are those that it leaves.
    pub fn command(&mut self, station: &Station, outputs: &Outputs, command: Command) {
        let is_firm = !outputs.y4 || station.hook_holds();
        let is_free = !station.hook_holds();
        let mut ask = |holds: bool, what: &str| {
            if !holds {
                self.violations.push(format!("{command}: {what}"));
            }
        };
        match command {
            Command::PushOut => {
                ask(station.injector_is_back(), UNFINISHED);
                ask(!station.barrel_is_empty(), "the barrel is empty");
                ask(!station.dock_is_taken(), "the dock is occupied");
                ask(station.boom_at_testing(), "the boom is in the way");
            }
            Command::DrawBack => {
                ask(station.injector_is_out(), UNFINISHED);
                ask(station.boom_at_dock() && !is_free, "the hook does not hold the workpiece on the dock");
            }
            Command::SwingToTesting => {
                ask(station.boom_at_dock(), UNFINISHED);
                ask(!outputs.y2, "the injector is in the way");
                ask(is_firm && (is_free || !outputs.y3), "the grip is half done");
                let waits = station.injector_is_back() && station.barrel_is_empty();
                ask(!waits, "the barrel is empty, there is no need to make room");
            }
            Command::SwingToDock => {
                ask(station.boom_at_testing(), UNFINISHED);
                ask(is_free && !outputs.y4, "the hook still holds a workpiece");
                ask(!outputs.y2 || station.injector_is_out(), "a workpiece is on its way to the dock");
                let fetches = station.injector_is_out() && station.dock_is_taken();
                ask(
                    fetches || station.barrel_is_empty(),
                    "there is nothing to fetch and nothing to wait for",
                );
            }
            Command::Grip => {
                ask(station.boom_at_dock(), "the hook is not at the dock");
                ask(station.injector_is_out() && station.dock_is_taken(), "no workpiece lies there");
            }
            Command::LetGo => ask(station.boom_at_testing(), "the hook is not at the testing station"),
        }
    }
}
