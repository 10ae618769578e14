//! Prints a member of a family of specifications or plants: `family NAME NUMBER`, such as `family lift 12`.

use sml_tests::families::{ALL, by_name};

fn main() -> Result<(), String> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [name, number] = arguments.as_slice() else { return Err(usage()) };
    let family = by_name(name).ok_or_else(usage)?;
    let number = number.parse().ok().filter(|number| *number >= family.least).ok_or_else(usage)?;
    print!("{}", (family.text)(number));
    Ok(())
}

fn usage() -> String {
    let one = |family: &sml_tests::families::Family| {
        format!("{} ({}, {} or more)", family.name, family.of, family.least)
    };
    format!("usage: family NAME NUMBER, where NAME is {}", ALL.each_ref().map(one).join(", "))
}
