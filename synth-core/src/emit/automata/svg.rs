//! Drawings. [`layout`] says where things are.

mod layout;

use std::fmt::Write as _;

use self::layout::{GAP, Layout, Place};
use super::{Edge, Graph};
use crate::emit::scan::ladder::escaped;

const CHARACTER: usize = 7;
const LINE: usize = 16;
const MARGIN: usize = 20;
/// All automata, one below the other.
pub(super) fn drawing(plant: &str, graphs: &[Graph]) -> String {
    let mut body = String::new();
    let (mut top, mut width) = (MARGIN, 0);
    for graph in graphs {
        // Writing to a string cannot fail.
        let _ = writeln!(
            body,
            "<text class=\"title\" x=\"{MARGIN}\" y=\"{}\">{}</text>",
            top + LINE,
            escaped(&graph.title)
        );
        let (right, bottom) = draw(&mut body, graph, top + 2 * LINE);
        (width, top) = (width.max(right), bottom + GAP);
    }
    let (width, height) = (width + MARGIN, top + MARGIN);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\">\n\
         <title>{}</title>\n\
         <style>path, rect {{ stroke: black; fill: none }} .dashed {{ stroke-dasharray: 5 3 }} \
         text {{ font: 12px monospace; text-anchor: middle }} .title {{ font-weight: bold; text-anchor: start }} \
         .label {{ paint-order: stroke; stroke: white; stroke-width: 3px }}</style>\n\
         <defs><marker id=\"tip\" viewBox=\"0 0 10 10\" refX=\"10\" refY=\"5\" markerWidth=\"8\" markerHeight=\"8\" orient=\"auto\">\
         <path d=\"M0 1L10 5L0 9z\" style=\"fill: black\"/></marker></defs>\n\
         <rect width=\"100%\" height=\"100%\" style=\"fill: white; stroke: none\"/>\n{body}</svg>\n",
        escaped(plant)
    )
}

/// Draws below `top`, and returns the right and the lower end.
fn draw(out: &mut String, graph: &Graph, top: usize) -> (usize, usize) {
    let Layout { places, routes, right, bottom } = Layout::new(graph, top);
    for (edge, route) in graph.edges.iter().zip(&routes) {
        let class = if edge.controllable { "" } else { " class=\"dashed\"" };
        // Writing to a string cannot fail.
        let _ = writeln!(out, "<path{class} d=\"{}\" marker-end=\"url(#tip)\"/>", route.path);
    }
    if let Some(initial) = places.get(graph.initial) {
        let y = initial.y + initial.height / 2;
        let _ = writeln!(
            out,
            "<path d=\"M{} {y}H{}\" marker-end=\"url(#tip)\"/>",
            initial.x - GAP / 2,
            initial.x
        );
    }
    for (node, place) in graph.nodes.iter().zip(&places) {
        let Place { x, y, width, height, .. } = *place;
        let _ = writeln!(out, "<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" rx=\"8\"/>");
        if node.marked {
            let (x, y, width, height) = (x + 3, y + 3, width - 6, height - 6);
            let _ =
                writeln!(out, "<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" rx=\"6\"/>");
        }
        for (line, text) in node.lines.iter().enumerate() {
            let (x, y) = (x + width / 2, y + LINE * (line + 1));
            let _ = writeln!(out, "<text x=\"{x}\" y=\"{y}\">{}</text>", escaped(text));
        }
    }
    // Last, so that no line strikes them out.
    let mut taken: Vec<[usize; 4]> = Vec::new();
    for (edge, route) in graph.edges.iter().zip(&routes) {
        label(out, edge, &route.labels, &mut taken);
    }
    (right, bottom)
}

/// Writes a label at the first place that is free of other ones, or else at the best.
fn label(out: &mut String, edge: &Edge, places: &[(usize, usize)], taken: &mut Vec<[usize; 4]>) {
    let half = edge.label.chars().count() * CHARACTER / 2;
    let area = |(x, y): (usize, usize)| [x.saturating_sub(half), x + half, y.saturating_sub(LINE * 3 / 4), y];
    let is_free = |&&place: &&(usize, usize)| {
        let [left, right, above, below] = area(place);
        taken.iter().all(|&[l, r, a, b]| right < l || r < left || below < a || b < above)
    };
    if let Some(&(x, y)) = places.iter().find(is_free).or(places.first()) {
        taken.push(area((x, y)));
        let _ = writeln!(out, "<text class=\"label\" x=\"{x}\" y=\"{y}\">{}</text>", escaped(&edge.label));
    }
}
