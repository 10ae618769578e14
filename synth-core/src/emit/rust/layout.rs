//! Generated text laid out as a person would: tables in aligned columns, a blank line between items.

/// Lines of tables are no longer than this.
const WIDTH: usize = 100;

/// Aligns the numbers of tables, breaks long byte strings, and sets items apart.
pub(super) fn tidy(source: &str) -> String {
    let mut out = String::with_capacity(source.len() + source.len() / 8);
    let mut lines = source.lines().peekable();
    let mut previous = "";
    while let Some(line) = lines.next() {
        if is_gap(previous, line) {
            out.push('\n');
        }
        previous = line;
        if is_numbers(line) {
            let mut numbers: Vec<&str> = elements(line).collect();
            while let Some(more) = lines.next_if(|line| is_numbers(line)) {
                numbers.extend(elements(more));
            }
            fill(&mut out, indentation(line), &numbers);
        } else if line.len() > WIDTH && line.contains("b\"\\x") {
            break_bytes(&mut out, line);
        } else {
            out.push_str(line);
            out.push('\n');
        }
    }
    out
}

/// Whether an item ends with one line and the next begins with the other: items of the module, and of an `impl` or
/// trait in it.
fn is_gap(previous: &str, line: &str) -> bool {
    let ends = previous.ends_with(['}', ';']);
    let begins = line.trim_start().starts_with(|c: char| c != '}');
    ends && begins && indentation(previous) == indentation(line) && indentation(line) <= 8
}

/// Whether a line is nothing but numbers, each with a comma.
fn is_numbers(line: &str) -> bool {
    let line = line.trim_start();
    line.starts_with(|c: char| c.is_ascii_digit())
        && line.ends_with(',')
        && line.bytes().all(|byte| byte.is_ascii_digit() || matches!(byte, b'_' | b',' | b' '))
}

fn elements(line: &str) -> impl Iterator<Item = &str> {
    line.split(',').map(str::trim).filter(|number| !number.is_empty())
}

fn indentation(line: &str) -> usize {
    line.len() - line.trim_start().len()
}

/// Ten, twenty, … numbers a line where at least ten fit, so that positions are easily counted.
fn fill(out: &mut String, indent: usize, numbers: &[&str]) {
    let width = numbers.iter().map(|number| number.len()).max().unwrap_or(1);
    let fit = (WIDTH.saturating_sub(indent) / (width + 2)).max(1);
    let columns = if fit >= 10 { fit - fit % 10 } else { fit };
    for row in numbers.chunks(columns) {
        out.extend(std::iter::repeat_n(' ', indent));
        for (i, number) in row.iter().enumerate() {
            let separator = if i == 0 { "" } else { " " };
            out.push_str(separator);
            out.extend(std::iter::repeat_n(' ', width - number.len()));
            out.push_str(number);
            out.push(',');
        }
        out.push('\n');
    }
}

/// Twenty-odd bytes of a string a line; a backslash at the end of a line continues it after the next line's blanks.
fn break_bytes(out: &mut String, line: &str) {
    let Some(start) = line.find("b\"\\x").map(|at| at + 2) else { return };
    let Some(end) = line.rfind('"') else { return };
    let indent = indentation(line) + 4;
    let bytes = (WIDTH.saturating_sub(indent) / 16 * 4).max(4);
    out.push_str(&line[..start]);
    for chunk in line.as_bytes()[start..end].chunks(4 * bytes) {
        out.push_str("\\\n");
        out.extend(std::iter::repeat_n(' ', indent));
        out.extend(chunk.iter().copied().map(char::from));
    }
    out.push_str(&line[end..]);
    out.push('\n');
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(source: &str, expected: &str) {
        assert_eq!(tidy(source), expected);
    }

    #[test]
    fn numbers_are_aligned() {
        check("    1, 20,\n    1_000, 4,\n", "        1,    20, 1_000,     4,\n");
        let numbers: String = (0..25).map(|n| format!("    {},\n", n * n)).collect();
        let laid_out = tidy(&format!("    [\n{numbers}    ]\n"));
        assert_eq!(laid_out.lines().count(), 5, "{laid_out}");
        assert!(laid_out.lines().all(|line| line.len() <= WIDTH));
        assert_eq!(laid_out.lines().nth(1).map(|line| line.matches(',').count()), Some(10));
    }

    #[test]
    fn items_are_set_apart() {
        check(
            "mod m {\n    fn f() {\n    }\n    fn g();\n    fn h();\n}\n",
            "mod m {\n    fn f() {\n    }\n\n    fn g();\n\n    fn h();\n}\n",
        );
        check("            let x = 1;\n            x\n", "            let x = 1;\n            x\n");
    }

    #[test]
    fn other_lines_stay() {
        let source = "fn f() {\n    x,\n    1 + 1,\n}\n";
        check(source, source);
    }

    #[test]
    fn byte_strings_are_broken_between_bytes() {
        let line = format!("    Packed::new(*b\"{}\");", "\\x0a".repeat(50));
        let broken = tidy(&line);
        assert!(broken.lines().all(|line| line.len() <= WIDTH), "{broken}");
        let joined: String = broken.lines().map(|line| line.trim_start().trim_end_matches('\\')).collect();
        assert_eq!(joined, line.trim_start());
    }
}
