//! Ladder diagrams as text.
//!
//! ```text
//! Rung 1: right
//!   Swing the boom to the testing station.
//!
//! |   Y1        X2        Y4                  Y0    |
//! |--|/|--+----| |---+---|/|-----------------(R)----|
//! ```
//!
//! Names stand above contacts `| |` and `|/|` and coils `(S)`, `(R)` and `( )`. A rung that is too wide goes on below: every wire
//! that ends in `>` begins there again, on the same line of the drawing.

use super::grid::{Cell, Grid, Symbol};
use super::{Source, networks};
use crate::emit::scan::origin;
use crate::plant::Drive;

/// The longest line, in characters, unless one name alone is longer.
const LINE_LIMIT: usize = 120;

/// The whole diagram, ending in a newline, deterministic.
#[must_use]
pub fn text(source: &Source<'_>) -> String {
    let mut out = String::new();
    for line in origin(source, "Ladder diagram of", "ladder") {
        push_line(&mut out, &line);
    }
    for network in networks(source) {
        out.push('\n');
        for (index, line) in network.lines.iter().enumerate() {
            let indent = if index == 0 { "" } else { "  " };
            wrap(&mut out, line, indent);
        }
        if let Some(grid) = &network.grid {
            draw(&mut out, grid);
        }
    }
    out
}

fn push_line(out: &mut String, line: &str) {
    out.push_str(line.trim_end());
    out.push('\n');
}

/// Breaks at spaces.
fn wrap(out: &mut String, text: &str, indent: &str) {
    let mut line = String::new();
    for word in text.split_whitespace() {
        if !line.is_empty() && indent.len() + line.chars().count() + 1 + word.chars().count() > LINE_LIMIT {
            push_line(out, &format!("{indent}{line}"));
            line.clear();
        }
        if !line.is_empty() {
            line.push(' ');
        }
        line.push_str(word);
    }
    push_line(out, &format!("{indent}{line}"));
}

/// The symbol, three characters.
fn drawn(symbol: Symbol) -> &'static str {
    match symbol {
        Symbol::Contact { negated: false } => "| |",
        Symbol::Contact { negated: true } => "|/|",
        Symbol::Comparison => "[ ]",
        Symbol::Coil(Drive::Set) => "(S)",
        Symbol::Coil(Drive::Reset) => "(R)",
        Symbol::Coil(Drive::Out) => "( )",
    }
}

/// Per column its width in characters: names with a space on both sides.
fn widths(grid: &Grid) -> Vec<usize> {
    let width = |column| {
        let labels = (0..grid.rows).filter_map(move |row| match grid.cell(row, column) {
            Cell::Element(_, label) => Some(label.chars().count()),
            _ => None,
        });
        labels.max().unwrap_or(0).max("| |".len() + 2) + 2
    };
    (0..grid.columns).map(width).collect()
}

/// Draws columns until the line is full, again and again.
fn draw(out: &mut String, grid: &Grid) {
    let widths = widths(grid);
    let mut first = 0;
    while first < grid.columns {
        let mut end = first;
        // A rail or a mark on both sides, with a piece of wire each, and the boundary at the left of every column.
        let mut width = "|-".len() + "-|".len();
        while end < grid.columns && (end == first || width + 1 + widths[end] <= LINE_LIMIT) {
            width += 1 + widths[end];
            end += 1;
        }
        out.push('\n');
        page(out, grid, &widths, first, end);
        first = end;
    }
}

/// Draws columns `first..end`.
fn page(out: &mut String, grid: &Grid, widths: &[usize], first: usize, end: usize) {
    let used = |row: &usize| {
        let row = *row;
        (first..end).any(|column| grid.is_wired(row, Some(column)))
            || (first..end).any(|boundary| row > 0 && grid.is_linked(row - 1, boundary))
    };
    let rows = (0..grid.rows).rev().find(used).map_or(0, |last| last + 1);
    for row in 0..rows {
        push_line(out, &names(grid, widths, first, end, row));
        push_line(out, &wires(grid, widths, first, end, row));
    }
}

/// The line above a row: names, and links that pass.
fn names(grid: &Grid, widths: &[usize], first: usize, end: usize, row: usize) -> String {
    let mut line = String::from(if first == 0 { "| " } else { "  " });
    for (column, &width) in (first..end).zip(&widths[first..end]) {
        line.push(if row > 0 && grid.is_linked(row - 1, column) { '|' } else { ' ' });
        let label = match grid.cell(row, column) {
            Cell::Element(_, label) => label.as_str(),
            _ => "",
        };
        centered(&mut line, label, width, ' ');
    }
    if end == grid.columns {
        line.push_str(" |");
    }
    line
}

/// A row: symbols, wires, and where they are linked.
fn wires(grid: &Grid, widths: &[usize], first: usize, end: usize, row: usize) -> String {
    let mut line = String::from(match (first, row) {
        (0, 0) => "|-",
        (0, _) => "| ",
        _ if grid.is_wired(row, Some(first - 1)) => ">-",
        _ => "  ",
    });
    for (column, &width) in (first..end).zip(&widths[first..end]) {
        let wired = grid.is_wired(row, Some(column)) || grid.is_wired(row, column.checked_sub(1));
        let linked = grid.is_linked(row, column) || row > 0 && grid.is_linked(row - 1, column);
        line.push(match (wired, linked) {
            (true, true) => '+',
            (true, false) => '-',
            (false, true) => '|',
            (false, false) => ' ',
        });
        match grid.cell(row, column) {
            Cell::Empty => centered(&mut line, "", width, ' '),
            Cell::Wire => centered(&mut line, "", width, '-'),
            Cell::Element(symbol, _) => centered(&mut line, drawn(*symbol), width, '-'),
        }
    }
    let wired = grid.is_wired(row, Some(end - 1));
    line.push_str(match (end == grid.columns, wired) {
        (true, true) => "-|",
        (true, false) => " |",
        (false, true) => ">",
        (false, false) => "",
    });
    line
}

fn centered(out: &mut String, text: &str, width: usize, fill: char) {
    let room = width.saturating_sub(text.chars().count());
    out.extend(std::iter::repeat_n(fill, room / 2));
    out.push_str(text);
    out.extend(std::iter::repeat_n(fill, room - room / 2));
}
