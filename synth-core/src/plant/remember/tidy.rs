//! Codes that change with fewer events.

use super::conclude::{Conclusion, Occasion};
use super::machine::Machine;
use super::search::Codes;

/// Conclusions that are looked at before codes stay as they are.
const STEPS: usize = 2_000_000;
/// What it costs that an event can set a bit, or reset it; relative to one more occasion.
const RUNG: u32 = 4;

/// Exchanges two codes in one sight, or everywhere, while that makes fewer bits change; the state `initial` gets code 0. Returns
/// how many bits change, on all occasions.
pub(super) fn tidy(machine: &Machine, initial: u32, conclusions: &[Conclusion], codes: &mut Codes) -> u32 {
    let Some(mut least) = cost(conclusions, codes) else { return u32::MAX };
    let sights = machine.sight.iter().max().map_or(0, |most| most + 1);
    let mut states_of = vec![Vec::new(); sights as usize];
    machine
        .sight
        .iter()
        .zip(0..)
        .for_each(|(&sight, state): (&u32, u32)| states_of[sight as usize].push(state));
    states_of.push((0..machine.len() as u32).collect());
    let mut steps = 0;
    while steps <= STEPS {
        let before = least;
        for states in &states_of {
            for a in 0..1u32 << codes.bits {
                for b in a + 1..1 << codes.bits {
                    if steps > STEPS || !exchange(states, a, b, codes) {
                        continue;
                    }
                    steps += conclusions.len();
                    match cost(conclusions, codes).filter(|&cost| cost < least) {
                        Some(cost) => least = cost,
                        None => {
                            exchange(states, a, b, codes);
                        }
                    }
                }
            }
        }
        if least == before {
            break;
        }
    }
    let first = codes.of[initial as usize];
    codes.of.iter_mut().for_each(|code| *code ^= first);
    least
}

/// Whether there was anything to do.
fn exchange(states: &[u32], a: u32, b: u32, codes: &mut Codes) -> bool {
    let mut any = false;
    for &state in states {
        let code = &mut codes.of[state as usize];
        if *code == a || *code == b {
            *code ^= a ^ b;
            any = true;
        }
    }
    any
}

/// How many bits change, on all occasions, and weighted with [`RUNG`] what sets or resets them; `None` if one code would have to
/// become two.
fn cost(conclusions: &[Conclusion], codes: &Codes) -> Option<u32> {
    let mut cost = 0;
    let mut after = vec![u32::MAX; 1 << codes.bits];
    // What the event of a group of occasions sets and resets.
    let (mut event, mut set, mut reset) = (None, 0u32, 0u32);
    for group in conclusions.chunk_by(|a, b| a.occasion == b.occasion) {
        let next = match group[0].occasion {
            Occasion::Seen(_) => None,
            Occasion::Caused(event, _) => Some(event),
        };
        if next != event {
            cost += RUNG * (set.count_ones() + reset.count_ones());
            (event, set, reset) = (next, 0, 0);
        }
        after.fill(u32::MAX);
        for it in group {
            let (old, new) = (codes.of[it.source as usize], codes.of[it.target as usize]);
            match std::mem::replace(&mut after[old as usize], new) {
                u32::MAX => {
                    cost += (old ^ new).count_ones();
                    set |= new & !old;
                    reset |= old & !new;
                }
                known if known != new => return None,
                _ => {}
            }
        }
    }
    Some(cost + RUNG * (set.count_ones() + reset.count_ones()))
}
