//! Runs compiled statements over a memory of cells.
//!
//! Memory holds, one behind the other: constants, global variables, the instances that are run, and the frames of
//! the calls in progress. Nothing ever moves, so that an address stays valid.

mod evaluate;
mod execute;
mod locate;
mod text;

use crate::declare::Pou;
use crate::error::{Position, RuntimeError};

/// What stops a call; boxed, because results are returned all the time.
pub(crate) type Fault = Box<RuntimeError>;

fn fault<T>(at: Position, message: impl Into<String>) -> Result<T, Fault> {
    Err(Box::new(RuntimeError { line: at.line, column: at.column, message: message.into() }))
}

/// What one call cost. The standard function blocks count as one statement.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Stats {
    /// Statements that were begun: assignments, calls, `IF`, `CASE`, loops (once each), `EXIT`, `CONTINUE`, `RETURN`.
    pub statements: u64,
    /// Times that the body of a loop was entered.
    pub iterations: u64,
    /// Elements of arrays that were read, written or passed by a computed index.
    pub indexed: u64,
    /// Comparisons with an element of an array that was found by a computed index.
    pub compared: u64,
    /// Calls of functions and function blocks.
    pub calls: u64,
    /// Elements that were copied in assignments and arguments of whole arrays and structures.
    pub copied: u64,
    /// Operations and conversions whose result did not fit the type and was wrapped around. Systems differ in the
    /// width in which they compute, so a portable text has none.
    pub wrapped: u64,
}

#[derive(Clone, Debug)]
pub(crate) struct Machine {
    pub(crate) memory: Vec<i64>,
    /// Where constants end and global variables begin.
    globals: usize,
    /// The instance whose code runs.
    this: usize,
    /// The frame of the call in progress.
    frame: usize,
    /// Behind the last frame.
    top: usize,
    /// The statement that runs.
    at: Position,
    /// In nanoseconds.
    pub(crate) clock: i64,
    pub(crate) stats: Stats,
    /// Statements and iterations that are left.
    fuel: u64,
    /// Tells the pointers of this call from those of earlier ones.
    epoch: i64,
}

impl Machine {
    pub(crate) fn new(memory: Vec<i64>, globals: usize) -> Machine {
        let top = memory.len();
        let (at, stats) = (Position::default(), Stats::default());
        Machine { memory, globals, this: 0, frame: 0, top, at, clock: 0, stats, fuel: 0, epoch: 0 }
    }

    /// The place of global variables.
    pub(crate) fn globals(&self) -> usize {
        self.globals
    }

    /// Forgets the last call. Frames begin at `stack`; the call may take so many statements and iterations.
    pub(crate) fn begin(&mut self, stack: usize, fuel: u64) {
        self.top = stack;
        self.stats = Stats::default();
        self.fuel = fuel;
        self.epoch = (self.epoch + 1) % locate::EPOCHS;
    }

    /// Runs a function block or program.
    pub(crate) fn run_block(&mut self, pous: &[Pou], index: usize, instance: usize) -> Result<(), Fault> {
        let pou = &pous[index];
        let caller = (self.this, self.frame, self.stats);
        self.this = instance;
        self.frame = self.reserve(&pou.frame);
        self.execute(pous, &pou.code)?;
        self.top = self.frame;
        (self.this, self.frame) = (caller.0, caller.1);
        if !pou.counted {
            self.stats = caller.2;
        }
        Ok(())
    }

    /// Runs a function whose frame is filled in.
    pub(crate) fn run_function(&mut self, pous: &[Pou], index: usize, frame: usize) -> Result<(), Fault> {
        let caller = self.frame;
        self.frame = frame;
        self.execute(pous, &pous[index].code)?;
        self.frame = caller;
        Ok(())
    }

    /// A new frame.
    fn reserve(&mut self, image: &[i64]) -> usize {
        let frame = self.top;
        self.top += image.len();
        if self.memory.len() < self.top {
            self.memory.resize(self.top, 0);
        }
        self.memory[frame..self.top].copy_from_slice(image);
        frame
    }

    fn store(&mut self, address: usize, value: i64) -> Result<(), Fault> {
        if address < self.globals {
            return fault(self.at, "a constant is written through a pointer");
        }
        self.memory[address] = value;
        Ok(())
    }

    fn burn(&mut self) -> Result<(), Fault> {
        match self.fuel.checked_sub(1) {
            Some(left) => {
                self.fuel = left;
                Ok(())
            }
            None => fault(self.at, "the call takes too many statements"),
        }
    }
}
