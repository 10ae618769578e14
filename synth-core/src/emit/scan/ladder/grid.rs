//! Where contacts, coils and wires of a rung stand.
//!
//! A grid has columns of cells, and between them, and at both ends, *boundaries* at which rows are linked. What is in series stands
//! side by side, what is in parallel one above the other, linked at its two boundaries. All that meets at a boundary in one
//! chain of links is the same node: a vertical line never crosses a wire that it is not connected to.

use crate::emit::scan::Source;
use crate::logic::{Expr, Literal, Var};
use crate::plant::{Drive, Rung};

/// What stands in a cell.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Cell {
    Empty,
    Wire,
    /// A symbol and what is written above it.
    Element(Symbol, String),
}

/// A symbol of a ladder.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Symbol {
    Contact {
        negated: bool,
    },
    /// A contact that closes where a comparison holds.
    Comparison,
    Coil(Drive),
}

/// A rung.
pub(super) struct Grid {
    pub(super) columns: usize,
    pub(super) rows: usize,
    /// By row.
    cells: Vec<Cell>,
    /// Whether a boundary links a row with the next; by row, one more than columns each.
    links: Vec<bool>,
}

/// Columns and rows.
type Size = (usize, usize);

/// How much room an expression takes: one column at least, one row at least.
fn size(expr: &Expr) -> Size {
    match expr {
        Expr::Constant(_) | Expr::Literal(_) => (1, 1),
        Expr::And(all) => all.iter().map(size).fold((0, 1), |(w, h), (w2, h2)| (w + w2, h.max(h2))),
        Expr::Or(any) => any.iter().map(size).fold((1, 0), |(w, h), (w2, h2)| (w.max(w2), h + h2)),
    }
}

/// Column and row of every literal of an expression, in the order in which they are written, and the size of it all.
#[cfg(feature = "plcopen")]
pub(in crate::emit) fn places(expr: &Expr) -> (Vec<(usize, usize)>, Size) {
    fn visit(expr: &Expr, column: usize, row: usize, out: &mut Vec<(usize, usize)>) {
        match expr {
            Expr::Constant(_) => {}
            Expr::Literal(_) => out.push((column, row)),
            Expr::And(all) => {
                let mut column = column;
                for part in all {
                    visit(part, column, row, out);
                    column += size(part).0;
                }
            }
            Expr::Or(any) => {
                let mut row = row;
                for part in any {
                    visit(part, column, row, out);
                    row += size(part).1;
                }
            }
        }
    }
    let mut out = Vec::new();
    visit(expr, 0, 0, &mut out);
    (out, size(expr))
}

impl Grid {
    /// A rung of a program, which has a coil.
    pub(super) fn rung(source: &Source<'_>, rung: &Rung) -> Grid {
        let condition = drawn(&rung.condition, rung.coils[0].variable);
        let coils = rung.coils.iter();
        Grid::new(
            &condition,
            &|literal| {
                (Symbol::Contact { negated: literal.negated }, source.name(literal.variable).to_owned())
            },
            coils.map(|coil| (Symbol::Coil(coil.drive), source.name(coil.variable).to_owned())),
        )
    }

    /// The rung that tells whether comparisons hold.
    pub(super) fn range(name: &str, comparisons: &[String; 2]) -> Grid {
        let both = [0, 1].map(|variable| Expr::Literal(Literal { variable, negated: false }));
        Grid::new(
            &Expr::And(both.into()),
            &|literal| (Symbol::Comparison, comparisons[literal.variable as usize].clone()),
            [(Symbol::Coil(Drive::Out), name.to_owned())].into_iter(),
        )
    }

    fn new(
        condition: &Expr,
        contact: &dyn Fn(Literal) -> (Symbol, String),
        coils: impl ExactSizeIterator<Item = (Symbol, String)>,
    ) -> Grid {
        let (width, height) = size(condition);
        let (columns, rows) = (width + 1, height.max(coils.len()));
        let (cells, links) = (vec![Cell::Empty; columns * rows], vec![false; (columns + 1) * rows]);
        let mut grid = Grid { columns, rows, cells, links };
        grid.place(condition, 0, 0, width, contact);
        grid.link(width, 0, coils.len() - 1);
        for (row, (symbol, label)) in coils.enumerate() {
            grid.cells[row * columns + width] = Cell::Element(symbol, label);
        }
        grid
    }

    /// Draws an expression from its upper left corner to a boundary.
    fn place(
        &mut self,
        expr: &Expr,
        column: usize,
        row: usize,
        end: usize,
        contact: &dyn Fn(Literal) -> (Symbol, String),
    ) {
        let drawn = match expr {
            Expr::Constant(_) => column,
            Expr::Literal(literal) => {
                let (symbol, label) = contact(*literal);
                self.cells[row * self.columns + column] = Cell::Element(symbol, label);
                column + 1
            }
            Expr::And(all) => all.iter().fold(column, |column, part| {
                let end = column + size(part).0;
                self.place(part, column, row, end, contact);
                end
            }),
            Expr::Or(any) => {
                let (mut below, mut last) = (row, row);
                for part in any {
                    self.place(part, column, below, end, contact);
                    last = below;
                    below += size(part).1;
                }
                self.link(column, row, last);
                self.link(end, row, last);
                end
            }
        };
        for column in drawn..end {
            self.cells[row * self.columns + column] = Cell::Wire;
        }
    }

    fn link(&mut self, boundary: usize, first: usize, last: usize) {
        for row in first..last {
            self.links[row * (self.columns + 1) + boundary] = true;
        }
    }

    pub(super) fn cell(&self, row: usize, column: usize) -> &Cell {
        &self.cells[row * self.columns + column]
    }

    /// Whether current may flow in a cell; outside of the grid it does not.
    pub(super) fn is_wired(&self, row: usize, column: Option<usize>) -> bool {
        column.is_some_and(|column| column < self.columns && *self.cell(row, column) != Cell::Empty)
    }

    /// Whether a boundary links a row with the next.
    pub(super) fn is_linked(&self, row: usize, boundary: usize) -> bool {
        self.links[row * (self.columns + 1) + boundary]
    }
}

/// The condition in contacts. There is none that never closes: one and its opposite in series never let current pass.
pub(in crate::emit) fn drawn(condition: &Expr, any: Var) -> Expr {
    match condition {
        Expr::Constant(false) => {
            Expr::And([false, true].map(|negated| Expr::Literal(Literal { variable: any, negated })).into())
        }
        _ => condition.clone(),
    }
}
