//! Where the fast implementation and the naive one differ: `differences [first seed] [seeds] [size] [core|errors]`.

use sml_tests::agreement::{Outcome, compare};
use sml_tests::random::{Features, Options, specification};

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |index: usize, default: u64| {
        arguments.get(index).and_then(|argument| argument.parse().ok()).unwrap_or(default)
    };
    let features = match arguments.get(3).map(String::as_str) {
        Some("core") => Features::CORE,
        Some("errors") => Features { errors: true, ..Features::FULL },
        _ => Features::FULL,
    };
    let options = Options { size: number(2, 5) as usize, features };
    let (mut games, mut mistakes, mut different) = (0, 0, 0);
    for seed in number(0, 0)..number(0, 0) + number(1, 1000) {
        let text = specification(seed, options);
        for classic in [false, true] {
            match compare(&text, classic, 1000) {
                Ok(Outcome::Game(_)) => games += 1,
                Ok(Outcome::Mistake) => mistakes += 1,
                Ok(Outcome::TooLarge) => {}
                Err(error) => {
                    different += 1;
                    println!("seed {seed}, classic {classic}: {error}\n{text}");
                }
            }
        }
    }
    println!("{games} equal games, {mistakes} equal mistakes, {different} differences");
}
