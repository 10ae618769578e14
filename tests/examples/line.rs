//! Prints the production line of the corpus with so many presses: `line PRESSES`. Its state space grows by a factor of
//! about 14 with each.

fn main() -> Result<(), &'static str> {
    let presses = std::env::args().nth(1).and_then(|n| n.parse().ok()).ok_or("usage: line PRESSES")?;
    print!("{}", sml_tests::line::line(presses));
    Ok(())
}
