//! Instructions of each call of a function, counted in the emulator's log of all that are executed.

use super::elf::Function;
use std::collections::BTreeMap;
use std::fmt;

/// Instructions of the calls of one function, with those of what it calls.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Count {
    pub(crate) calls: u64,
    pub(crate) least: u64,
    pub(crate) most: u64,
    total: u64,
}

impl Count {
    fn of(instructions: u64) -> Self {
        Count { calls: 1, least: instructions, most: instructions, total: instructions }
    }

    fn add(&mut self, instructions: u64) {
        self.calls += 1;
        self.least = self.least.min(instructions);
        self.most = self.most.max(instructions);
        self.total += instructions;
    }

    /// Rounded.
    pub(crate) fn mean(&self) -> u64 {
        (self.total + self.calls / 2) / self.calls
    }
}

impl fmt::Display for Count {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Count { calls, least, most, .. } = self;
        write!(f, "calls {calls:6}  min {least:4}  mean {:4}  max {most:4}", self.mean())
    }
}

/// Counts while the log is read.
pub(crate) struct Counter<'f> {
    functions: &'f [Function],
    /// The function that is being called, where its caller goes on, and the instructions so far.
    open: Option<(&'f str, u64, u64)>,
    /// The instruction before.
    last: u64,
    counts: BTreeMap<&'f str, Count>,
}

impl<'f> Counter<'f> {
    /// Counts calls of these functions; those that one of them makes belong to it.
    pub(crate) fn new(functions: &'f [Function]) -> Self {
        Counter { functions, open: None, last: 0, counts: BTreeMap::new() }
    }

    /// A line of the log.
    pub(crate) fn line(&mut self, line: &str) {
        if let Some(address) = address(line) {
            self.executed(address);
        }
    }

    fn executed(&mut self, address: u64) {
        match &mut self.open {
            // A call has 2 or 4 bytes; control comes back behind it.
            Some((name, call, instructions)) if address == *call + 2 || address == *call + 4 => {
                let count = *instructions;
                self.counts.entry(name).and_modify(|old| old.add(count)).or_insert(Count::of(count));
                self.open = None;
            }
            Some((_, _, instructions)) => *instructions += 1,
            None => {
                if let Some(function) = self.functions.iter().find(|function| function.address == address) {
                    self.open = Some((&function.name, self.last, 1));
                }
            }
        }
        self.last = address;
    }

    /// Of every function that was called.
    pub(crate) fn counts(self) -> BTreeMap<&'f str, Count> {
        self.counts
    }
}

/// The address of an executed instruction: `Trace 0: 0x7f… [00000000/00000f34/…/…] name`.
fn address(line: &str) -> Option<u64> {
    let (_, inside) = line.strip_prefix("Trace ")?.split_once('[')?;
    u64::from_str_radix(inside.split('/').nth(1)?, 16).ok()
}

#[cfg(test)]
mod tests {
    use super::{Count, Counter, Function, address};

    #[test]
    fn an_address_is_the_second_number() {
        let line = "Trace 0: 0x7f3c2c000100 [00000000/00000f34/01000000/ff000201] main";
        assert_eq!(address(line), Some(0xf34));
        assert_eq!(address("Timer with period zero, disabling"), None);
    }

    #[test]
    fn a_call_is_counted_until_it_returns() {
        let function = |name: &str, address| Function { name: name.to_owned(), address, size: 8 };
        let functions = [function("f", 0x100), function("g", 0x200)];
        let mut counter = Counter::new(&functions);
        // `f` is called with four bytes and calls `g`; then again with two, and at last `g` alone.
        for address in [0x10, 0x14, 0x100, 0x102, 0x200, 0x202, 0x106, 0x18, 0x1a, 0x100, 0x1c, 0x200, 0x20] {
            counter.executed(address);
        }
        let counts: Vec<_> = counter.counts().into_iter().collect();
        let f = Count { calls: 2, least: 1, most: 5, total: 6 };
        assert_eq!(counts, [("f", f), ("g", Count::of(1))]);
        assert_eq!(f.mean(), 3);
    }
}
