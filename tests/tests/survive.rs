//! Whatever the bytes, there is a specification or a diagnostic. What fuzzing found stays here as a case.

use sml_tests::random::Random;
use sml_tests::{corpus, survive};
use std::path::Path;

/// Every file of a folder of `fuzz`.
fn inputs(folder: &str) -> Vec<(String, Vec<u8>)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz").join(folder);
    let mut paths: Vec<_> = std::fs::read_dir(&folder)
        .unwrap_or_else(|error| panic!("{}: {error}", folder.display()))
        .map(|entry| entry.expect("an entry").path())
        .collect();
    paths.sort();
    let read = |path: &Path| std::fs::read(path).expect("readable");
    paths.iter().map(|path| (path.display().to_string(), read(path))).collect()
}

#[test]
fn what_was_found() {
    for (name, bytes) in inputs("findings") {
        println!("{name}");
        survive::check(&bytes);
    }
}

/// The fuzzer begins with these and with the specifications of the corpus.
#[test]
fn the_seeds() {
    let seeds = inputs("corpus/reader");
    let corpus = corpus::all().into_iter().map(|entry| (entry.name, entry.text.into_bytes()));
    for (name, bytes) in seeds.into_iter().chain(corpus).chain(inputs("../tests/plants")) {
        println!("{name}");
        survive::check(&bytes);
    }
}

/// A few bytes of every specification of the corpus, changed at random.
#[test]
fn damaged_specifications() {
    let seeds: u64 = std::env::var("SML_SEEDS").ok().and_then(|seeds| seeds.parse().ok()).unwrap_or(4);
    let corpus = corpus::all().into_iter().map(|entry| (entry.name, entry.text.into_bytes()));
    for (name, text) in corpus.chain(inputs("../tests/plants")) {
        for seed in 0..seeds {
            let mut random = Random::new(seed);
            let mut bytes = text.clone();
            for _ in 0..1 + random.below(6) {
                let at = random.below(bytes.len());
                match random.below(4) {
                    0 => drop(bytes.remove(at)),
                    1 => bytes[at] = random.bits() as u8,
                    2 => bytes[at] = *random.pick(b"{}[]()=.;:#'\"/*-> 09az\n"),
                    _ => {
                        let piece = bytes[at..(at + 1 + random.below(20)).min(bytes.len())].to_vec();
                        let to = random.below(bytes.len());
                        bytes.splice(to..to, piece);
                    }
                }
            }
            println!("{name} {seed}");
            survive::check(&bytes);
        }
    }
}
