//! Ladder diagrams as drawings, to be printed.

use std::fmt::Write as _;

use super::grid::{Cell, Grid, Symbol};
use super::{Source, networks};
use crate::emit::scan::origin;
use crate::plant::Drive;

/// Height of a row, of a line of text, width of a character, all in pixels.
const ROW: usize = 44;
const LINE: usize = 18;
const CHARACTER: usize = 8;
const MARGIN: usize = 20;
/// Half the width of a symbol.
const HALF: usize = 9;

/// The whole diagram as SVG, ending in a newline, deterministic.
#[must_use]
pub fn drawing(source: &Source<'_>) -> String {
    let mut body = String::new();
    let (mut y, mut width) = (MARGIN, 0);
    for line in origin(source, "Ladder diagram of", "svg") {
        y += LINE;
        width = width.max(label(&mut body, "start", MARGIN, y, &line));
    }
    for network in networks(source) {
        y += LINE;
        for (index, line) in network.lines.iter().enumerate() {
            y += LINE;
            let class = if index == 0 { "title" } else { "start" };
            width = width.max(label(&mut body, class, MARGIN, y, line));
        }
        if let Some(grid) = &network.grid {
            y += LINE / 2;
            width = width.max(draw(&mut body, grid, y));
            y += grid.rows * ROW;
        }
    }
    let (width, height) = (width + MARGIN, y + MARGIN);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\">\n\
         <style>path {{ stroke: black; stroke-width: 1.5; fill: none }} \
         text {{ font: 13px monospace; text-anchor: middle }} \
         .start, .title {{ text-anchor: start }} .title {{ font-weight: bold }}</style>\n\
         <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n{body}</svg>\n"
    )
}

/// Writes a text and returns where it ends.
fn label(out: &mut String, class: &str, x: usize, y: usize, text: &str) -> usize {
    let class = if class.is_empty() { String::new() } else { format!(" class=\"{class}\"") };
    // Writing to a string cannot fail.
    let _ = writeln!(out, "<text{class} x=\"{x}\" y=\"{y}\">{}</text>", escaped(text));
    x + text.chars().count() * CHARACTER
}

/// Text that is no markup.
pub(in crate::emit) fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
    }
    out
}

/// Draws a rung below `top` and returns its right end.
fn draw(out: &mut String, grid: &Grid, top: usize) -> usize {
    let lefts = boundaries(grid);
    let right = lefts[grid.columns];
    let (rail, bottom) = (right + MARGIN, top + grid.rows * ROW);
    let mut path = format!("M{MARGIN} {top}V{bottom}M{rail} {top}V{bottom}");
    let line = |row: usize| top + row * ROW + ROW * 2 / 3;
    let _ = write!(path, "M{MARGIN} {y}H{}", lefts[0], y = line(0));
    for row in 0..grid.rows {
        let y = line(row);
        for column in 0..grid.columns {
            let (from, to) = (lefts[column], lefts[column + 1]);
            match grid.cell(row, column) {
                Cell::Empty => {}
                Cell::Wire => {
                    let _ = write!(path, "M{from} {y}H{to}");
                }
                Cell::Element(symbol, name) => {
                    let middle = usize::midpoint(from, to);
                    element(&mut path, *symbol, [from, middle, to], y);
                    label(out, "", middle, y - 14, name);
                    if let Some(letter) = letter(*symbol) {
                        label(out, "", middle, y + 5, letter);
                    }
                }
            }
        }
        if grid.is_wired(row, Some(grid.columns - 1)) {
            let _ = write!(path, "M{right} {y}H{rail}");
        }
        for (boundary, x) in lefts.iter().enumerate() {
            if grid.is_linked(row, boundary) {
                let _ = write!(path, "M{x} {y}V{}", line(row + 1));
            }
        }
    }
    let _ = writeln!(out, "<path d=\"{path}\"/>");
    rail
}

/// Where the boundaries are.
fn boundaries(grid: &Grid) -> Vec<usize> {
    let mut lefts = vec![2 * MARGIN];
    for column in 0..grid.columns {
        let labels = (0..grid.rows).filter_map(|row| match grid.cell(row, column) {
            Cell::Element(_, label) => Some(label.chars().count()),
            _ => None,
        });
        let longest = labels.max().unwrap_or(0);
        lefts.push(lefts[column] + (longest * CHARACTER).max(2 * HALF + 12) + 16);
    }
    lefts
}

fn letter(symbol: Symbol) -> Option<&'static str> {
    match symbol {
        Symbol::Coil(Drive::Set) => Some("S"),
        Symbol::Coil(Drive::Reset) => Some("R"),
        _ => None,
    }
}

/// A symbol and its wires to both sides.
fn element(path: &mut String, symbol: Symbol, [from, middle, to]: [usize; 3], y: usize) {
    let (left, right, above, below) = (middle - HALF, middle + HALF, y - HALF, y + HALF);
    let _ = write!(path, "M{from} {y}H{left}M{right} {y}H{to}");
    let _ = match symbol {
        Symbol::Contact { negated } => {
            if negated {
                let _ = write!(path, "M{left} {below}L{right} {above}");
            }
            write!(path, "M{left} {above}V{below}M{right} {above}V{below}")
        }
        Symbol::Comparison => {
            write!(path, "M{} {above}H{left}V{below}h4M{} {above}H{right}V{below}h-4", left + 4, right - 4)
        }
        Symbol::Coil(_) => {
            write!(path, "M{left} {y}a{HALF} {HALF} 0 1 0 {d} 0a{HALF} {HALF} 0 1 0 -{d} 0", d = 2 * HALF)
        }
    };
}
