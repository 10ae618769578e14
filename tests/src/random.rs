//! Random small specifications, as text, from a seed.
//!
//! They are well formed by construction: names resolve, types fit, variables and roles are bound before they are
//! read, modal messages of assumptions come from the environment, every loop has a message. All speak of one small
//! world of controllers (`Ctl`) and devices (`Dev`, `Sub`): controllers send `s0`, `s1`, … to devices, devices send
//! `e0`, `e1`, … to controllers, and either may set a device's attributes. A few of them run into an error
//! of play-out (an attribute out of its range, a path through `null`), since no static rule excludes that.

mod body;
pub mod grammar;
mod world;

use body::Writer;
use world::World;

/// Which constructs may occur beyond messages, modalities, `strict`, waits, static roles, constraints and effects.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Features {
    /// `alternative`.
    pub alternative: bool,
    /// `parallel`.
    pub parallel: bool,
    /// `while`.
    pub loops: bool,
    /// Nested bodies with constraints of their own.
    pub nested: bool,
    /// `interrupt` and `violation` fragments.
    pub conditions: bool,
    /// Variables, assignments and `bind`.
    pub variables: bool,
    /// Dynamic roles.
    pub dynamic: bool,
    /// `bindings`.
    pub bindings: bool,
    /// Parameters of operations, and `setX`.
    pub parameters: bool,
    /// `parameter ranges`.
    pub ranges: bool,
    /// `channels`.
    pub channels: bool,
    /// `existential` scenarios, which the game knows nothing of.
    pub existential: bool,
    /// `non-spontaneous events`.
    pub non_spontaneous: bool,
    /// References that are `null` at times, and increments that may leave their range: errors of play-out become likely.
    pub errors: bool,
}

impl Features {
    /// The smallest language.
    pub const CORE: Features = Features {
        alternative: false,
        parallel: false,
        loops: false,
        nested: false,
        conditions: false,
        variables: false,
        dynamic: false,
        bindings: false,
        parameters: false,
        ranges: false,
        channels: false,
        existential: false,
        non_spontaneous: true,
        errors: false,
    };

    /// Everything, but few errors of play-out.
    pub const FULL: Features = Features {
        alternative: true,
        parallel: true,
        loops: true,
        nested: true,
        conditions: true,
        variables: true,
        dynamic: true,
        bindings: true,
        parameters: true,
        ranges: true,
        channels: true,
        existential: true,
        non_spontaneous: true,
        errors: false,
    };
}

/// What to generate.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Options {
    /// Largest number of scenarios, from 1; bodies grow a little with it too. 5 gives mostly 2 to 500 states.
    pub size: usize,
    /// The part of the language.
    pub features: Features,
}

impl Default for Options {
    fn default() -> Self {
        Options { size: 5, features: Features::FULL }
    }
}

/// A specification; the same for the same seed and options.
#[must_use]
pub fn specification(seed: u64, options: Options) -> String {
    let mut random = Random::new(seed);
    let world = World::new(&mut random, options.features);
    let scenarios = Writer::scenarios(&mut random, &world, options);
    format!("specification Random {{\n{}{scenarios}}}\n", world.text())
}

/// A small deterministic generator (SplitMix64: Steele, Lea and Flood 2014).
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// One that always gives the same for the same seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Random(seed)
    }

    /// The next 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        bits ^ (bits >> 31)
    }

    /// A number below `end`, which must not be 0.
    pub fn below(&mut self, end: usize) -> usize {
        (self.bits() % end as u64) as usize
    }

    /// True in so many cases of a hundred.
    pub fn chance(&mut self, percent: usize) -> bool {
        self.below(100) < percent
    }

    /// One of them; there must be one.
    pub fn pick<'a, T>(&mut self, choices: &'a [T]) -> &'a T {
        &choices[self.below(choices.len())]
    }

    /// One of them, as often as its weight says; one weight must be positive.
    pub fn weighted<T: Copy>(&mut self, choices: &[(usize, T)]) -> T {
        let total = choices.iter().map(|(weight, _)| weight).sum();
        let mut left = self.below(total);
        for &(weight, choice) in choices {
            if left < weight {
                return choice;
            }
            left -= weight;
        }
        choices[0].1
    }
}
