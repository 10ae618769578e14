//! Runs instruction lists.

use std::collections::BTreeMap;

/// Does a scan over variables and analogue inputs by name, and returns how many instructions there were and how high the stack was.
pub(crate) fn run(
    text: &str,
    bits: &mut BTreeMap<String, bool>,
    numbers: &BTreeMap<String, i64>,
) -> (usize, usize) {
    let mut stack: Vec<bool> = Vec::new();
    let (mut count, mut depth) = (0, 0);
    for line in text.lines() {
        if line.is_empty() {
            // A block ends with one value on the stack, which the next one does not see.
            assert!(stack.len() <= 1, "{stack:?}");
            stack.clear();
        }
        if line.is_empty() || line.starts_with("(*") && line.ends_with("*)") {
            continue;
        }
        let words: Vec<&str> = line.split_whitespace().collect();
        let value = |name: &str| bits[name];
        match words.as_slice() {
            ["STR", "NOT", name] => stack.push(!value(name)),
            ["STR", name] => stack.push(value(name)),
            [word @ ("AND" | "OR"), operand @ ..] => {
                let top = stack.last_mut().expect("something is there");
                let value = match operand {
                    ["NOT", name] => !value(name),
                    [name] => value(name),
                    _ => panic!("{line}"),
                };
                *top = if *word == "AND" { *top && value } else { *top || value };
            }
            [word @ ("ANDSTR" | "ORSTR")] => {
                let (second, first) = (stack.pop().expect("two"), stack.pop().expect("two"));
                stack.push(if *word == "ANDSTR" { first && second } else { first || second });
            }
            ["STRGE", name, number] => stack.push(numbers[*name] >= number.parse().expect("a number")),
            ["ANDLE", name, number] => {
                *stack.last_mut().expect("one") &= numbers[*name] <= number.parse().expect("a number");
            }
            [word @ ("SET" | "RST" | "OUT"), name] => {
                let top = *stack.last().expect("one");
                let bit = bits.get_mut(*name).expect("a variable");
                match *word {
                    "SET" => *bit |= top,
                    "RST" => *bit &= !top,
                    _ => *bit = top,
                }
            }
            _ => panic!("{line}"),
        }
        count += 1;
        depth = depth.max(stack.len());
    }
    (count, depth)
}
