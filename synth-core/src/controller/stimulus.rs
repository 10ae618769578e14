//! Stimuli: events cycle by cycle as CSV, and the commands that answer them.
//!
//! The header names events; each further line is one cycle with a 0 or 1 for each of them. Fields may be quoted as
//! in RFC 4180, and spaces around them do not count. An event text that is not quoted may contain commas all the
//! same: those in parentheses separate nothing. Blank lines are passed over.

use super::Controller;
use super::cycle::Machine;
use crate::diagnostic::counted;
use std::fmt::Write;

/// Runs a controller through a stimulus.
///
/// Returns a CSV with the header `state,<object>…`, and per cycle the state after it and the command code that it
/// issued to each component, 0 for none. With `drain` a cycle is a [`Machine::drain`].
///
/// # Errors
///
/// If the stimulus is malformed or names an unknown event: a message with the line.
pub fn run(controller: &Controller, csv: &str, drain: bool) -> Result<String, String> {
    let text = csv.strip_prefix('\u{feff}').unwrap_or(csv);
    let mut lines = (1..).zip(text.lines()).filter(|(_, line)| !line.trim().is_empty());
    let (number, header) = lines.next().ok_or("the stimulus is empty: its first line must name events")?;
    let events = columns(controller, header).map_err(|message| format!("line {number}: {message}"))?;
    let mut machine = Machine::new(controller);
    let mut output = String::from("state");
    for component in &controller.components {
        output.push(',');
        output.push_str(&component.object);
    }
    output.push('\n');
    for (number, line) in lines {
        raise(&mut machine, &events, line).map_err(|message| format!("line {number}: {message}"))?;
        let commands = if drain { machine.drain() } else { machine.cycle() };
        let _ = write!(output, "{}", machine.state());
        for code in commands.codes {
            let _ = write!(output, ",{code}");
        }
        output.push('\n');
    }
    Ok(output)
}

/// Per column its event.
fn columns(controller: &Controller, header: &str) -> Result<Vec<u32>, String> {
    let mut events = Vec::new();
    for text in fields(header)? {
        let index = controller.events.binary_search_by(|event| event.text.as_str().cmp(&text));
        let event =
            index.map_err(|_| format!("`{text}` is not an environment event of the controller"))? as u32;
        if events.contains(&event) {
            return Err(format!("`{text}` is named twice"));
        }
        events.push(event);
    }
    Ok(events)
}

fn raise(machine: &mut Machine<'_>, events: &[u32], line: &str) -> Result<(), String> {
    let fields = fields(line)?;
    if fields.len() != events.len() {
        let (found, named) = (counted(fields.len(), "field"), counted(events.len(), "event"));
        return Err(format!("{found}, but the header names {named}"));
    }
    for (field, &event) in fields.iter().zip(events) {
        match field.as_str() {
            "0" => {}
            "1" => {
                machine.raise(event);
            }
            _ => return Err(format!("`{field}` is neither 0 nor 1")),
        }
    }
    Ok(())
}

/// The fields of one line.
fn fields(line: &str) -> Result<Vec<String>, String> {
    let mut fields = Vec::new();
    let mut rest = line;
    loop {
        rest = rest.trim_start();
        let (field, after) = match rest.strip_prefix('"') {
            Some(quoted) => unquote(quoted)?,
            None => {
                let (field, after) = rest.split_at(bare_length(rest));
                (field.trim_end().to_owned(), after)
            }
        };
        fields.push(field);
        match after.strip_prefix(',') {
            Some(next) => rest = next,
            None => return Ok(fields),
        }
    }
}

/// The content of a field after its opening quote, and what follows the field: nothing or a comma.
fn unquote(text: &str) -> Result<(String, &str), String> {
    let mut field = String::new();
    let mut rest = text;
    loop {
        let (part, after) = rest.split_once('"').ok_or("a quoted field does not end on its line")?;
        field.push_str(part);
        let Some(more) = after.strip_prefix('"') else {
            let after = after.trim_start();
            if after.is_empty() || after.starts_with(',') {
                return Ok((field, after));
            }
            return Err(format!("expected a comma after the quoted field `{field}`"));
        };
        field.push('"');
        rest = more;
    }
}

/// The length up to the first comma outside parentheses.
fn bare_length(text: &str) -> usize {
    let mut depth = 0_usize;
    for (i, byte) in text.bytes().enumerate() {
        match byte {
            b'(' => depth += 1,
            b')' => depth = depth.saturating_sub(1),
            b',' if depth == 0 => return i,
            _ => {}
        }
    }
    text.len()
}

#[cfg(test)]
mod tests {
    use super::super::Event;
    use super::super::fixtures::controller;
    use super::*;

    /// Three events, of which `env -> ctl.m(1, x)` has commas.
    fn example() -> Controller {
        let mut controller =
            controller("0: a 1, b 0, m 2 \n 1! arm.go 2 \n 2: b 3 \n 3! arm.stop press.go 0");
        controller.events[2] = Event::from_text("env -> ctl.m(1, x)").expect("an event");
        controller
    }

    #[track_caller]
    fn check(csv: &str, expected: &str) {
        assert_eq!(run(&example(), csv, false).as_deref(), Ok(expected));
    }

    #[track_caller]
    fn check_error(csv: &str, expected: &str) {
        assert_eq!(run(&example(), csv, false).as_deref().map_err(String::as_str), Err(expected));
    }

    #[test]
    fn each_row_is_a_cycle() {
        check(
            "env -> ctl.b(),env -> ctl.a()\n0,0\n1,1\n0,0\n1,0\n",
            "state,arm,press\n0,0,0\n2,1,0\n0,2,1\n0,0,0\n",
        );
    }

    #[test]
    fn drain_goes_further_in_a_row() {
        let csv = "env -> ctl.a(),env -> ctl.b()\n1,1\n0,0\n";
        assert_eq!(run(&example(), csv, false).as_deref(), Ok("state,arm,press\n2,1,0\n0,2,1\n"));
        assert_eq!(run(&example(), csv, true).as_deref(), Ok("state,arm,press\n3,1,0\n0,2,1\n"));
    }

    #[test]
    fn a_header_alone_gives_a_header() {
        check("env -> ctl.a()\n", "state,arm,press\n");
        check("env -> ctl.a()", "state,arm,press\n");
    }

    #[test]
    fn quotes_spaces_and_other_line_ends_do_not_matter() {
        let expected = "state,arm,press\n2,0,0\n0,2,1\n";
        check("env -> ctl.b(),\"env -> ctl.m(1, x)\"\n0,1\n1,0\n", expected);
        check(
            "\u{feff} \"env -> ctl.b()\" , \"env -> ctl.m(1, x)\" \r\n\r\n 0 , \"1\" \r\n1,0\r\n\r\n",
            expected,
        );
        check("env -> ctl.b() , env -> ctl.m(1, x)\n0,1\n1,0", expected);
    }

    #[test]
    fn malformed_headers() {
        check_error("", "the stimulus is empty: its first line must name events");
        check_error("\n  \n", "the stimulus is empty: its first line must name events");
        check_error("0,1\n", "line 1: `0` is not an environment event of the controller");
        check_error("env -> ctl.a(),\n", "line 1: `` is not an environment event of the controller");
        check_error(
            "ctl -> arm.go()",
            "line 1: `ctl -> arm.go()` is not an environment event of the controller",
        );
        check_error("\nenv -> ctl.a(),env -> ctl.a()", "line 2: `env -> ctl.a()` is named twice");
        check_error("\"env -> ctl.a()", "line 1: a quoted field does not end on its line");
        check_error("\"env\" x", "line 1: expected a comma after the quoted field `env`");
        check_error("\"a\"\"b\"", "line 1: `a\"b` is not an environment event of the controller");
    }

    #[test]
    fn malformed_rows() {
        let header = "env -> ctl.a(),env -> ctl.b()\n1,0\n";
        check_error(&format!("{header}1\n"), "line 3: 1 field, but the header names 2 events");
        check_error(&format!("{header}1,0,0\n"), "line 3: 3 fields, but the header names 2 events");
        check_error(&format!("{header}\n1,2\n"), "line 4: `2` is neither 0 nor 1");
        check_error(&format!("{header}1,\n"), "line 3: `` is neither 0 nor 1");
        check_error(&format!("{header}true,0\n"), "line 3: `true` is neither 0 nor 1");
    }
}
