//! Whether the system could win by its environment's failure.

use super::{Game, acceptance::Acceptance, predecessors::Predecessors, pursuit::Pursuit, region::Region};
use fixedbitset::FixedBitSet;

/// The states from which the system can keep the environment from being fair to its assumptions, though every super
/// step ends, or (with classic semantics) have it violated. Where there are none, assumptions and system are
/// *well separated*: nothing is won because the environment cannot do as it is said to.
///
/// It is the game whose only goal is never accepted, so that only the assumptions can decide it.
#[must_use]
pub fn overpowered(game: &Game) -> FixedBitSet {
    let predecessors = Predecessors::new(game);
    let assumptions = Acceptance::assumptions(game);
    let never = Acceptance::never(game);
    let mut region = Region::new(game, &predecessors);
    let mut pursuit = Pursuit::new(game, &predecessors, true);
    let mut progress = FixedBitSet::with_capacity(game.edges());
    loop {
        let fair = pursuit.run(&never, &assumptions, &region.states, &mut progress);
        if fair.is_clear() {
            return region.states;
        }
        region.remove(game, &predecessors, fair);
    }
}
