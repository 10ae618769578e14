//! The arbiter of the corpus with any number of clients.

use std::fmt::Write as _;

const TWO_CLIENTS: &str = include_str!("../../specs/arbiter_2/spec.sml");

/// Mutual exclusion of so many clients. The game has [`states`] states and [`transitions`] transitions.
///
/// # Panics
///
/// If the specification of two clients is written differently.
#[must_use]
pub fn arbiter(clients: u32) -> String {
    let second = "  object client1: Client\n  object client2: Client\n";
    assert!(TWO_CLIENTS.contains(second) && TWO_CLIENTS.contains("2 clients"), "two clients");
    let mut all = String::new();
    for client in 1..=clients {
        let _ = writeln!(all, "  object client{client}: Client");
    }
    TWO_CLIENTS.replace(second, &all).replace("2 clients", &format!("{clients} clients"))
}

/// States of the game.
#[must_use]
pub fn states(clients: u32) -> u64 {
    (2 << clients) - 1 + (u64::from(clients) << clients) / 2
}

/// Transitions of the game.
#[must_use]
pub fn transitions(clients: u32) -> u64 {
    let (clients, sets) = (u64::from(clients), 1 << clients);
    (clients + 1) * (clients + 4) * sets / 4 - 1
}
