//! Ladder diagrams: a rung on a grid, as text and as a drawing.

mod grid;
mod svg;
mod text;

#[cfg(feature = "plcopen")]
pub(in crate::emit) use grid::{drawn, places};
pub use svg::drawing;
pub(in crate::emit) use svg::escaped;
pub use text::text;

use super::{Source, rung_lines};
use grid::Grid;

/// A rung, and what is to be read above it.
struct Network {
    lines: Vec<String>,
    /// Nothing is drawn for a rung without coils.
    grid: Option<Grid>,
}

/// Ranges, which are found first, then the rungs of the program.
fn networks(source: &Source<'_>) -> Vec<Network> {
    let program = source.program;
    let ranges = source.ranges().map(|(variable, analogue, low, high)| {
        let (name, analogue) = (source.name(variable), &program.analogues[analogue as usize]);
        let mut lines = vec![format!("Range {name}: {analogue} from {low} to {high}")];
        lines.extend(program.variables[variable as usize].doc.iter().map(|line| line.trim().to_owned()));
        Network {
            lines,
            grid: Some(Grid::range(name, &[format!("{analogue} >= {low}"), format!("{analogue} <= {high}")])),
        }
    });
    let rungs = (1..).zip(&program.rungs).map(|(number, rung)| {
        let mut lines = rung_lines(source, number, rung);
        if rung.coils.is_empty() {
            lines.push("It commands nothing.".to_owned());
        }
        Network { lines, grid: (!rung.coils.is_empty()).then(|| Grid::rung(source, rung)) }
    });
    ranges.chain(rungs).collect()
}
