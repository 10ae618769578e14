//! Drawings: states in layers by their distance from the initial one, from left to right.
//!
//! An arrow to the next layer runs between the sides of states, any other one below them: so the cycles that components mostly
//! are look like cycles.

use std::fmt::Write as _;

use super::{Edge, Graph};
use crate::emit::scan::ladder::escaped;

const CHARACTER: usize = 7;
const LINE: usize = 16;
const MARGIN: usize = 20;
/// Between layers beside the longest label, and between states of a layer.
const GAP: usize = 40;

/// The box of a state.
#[derive(Clone, Copy)]
struct Place {
    layer: usize,
    x: usize,
    y: usize,
    width: usize,
    height: usize,
}

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
    let places = places(graph, top);
    let right = places.iter().map(|place| place.x + place.width).max().unwrap_or(0);
    let mut bottom = places.iter().map(|place| place.y + place.height).max().unwrap_or(top);
    // What runs below the states has a track of its own.
    let floor = bottom;
    for edge in &graph.edges {
        let (from, to) = (places[edge.source], places[edge.target]);
        let (path, (x, y)) = if to.layer == from.layer + 1 {
            forward(from, to)
        } else {
            bottom += LINE + 4;
            around(from, to, bottom.max(floor))
        };
        arrow(out, edge, &path, x, y);
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
    (right, bottom)
}

fn arrow(out: &mut String, edge: &Edge, path: &str, x: usize, y: usize) {
    let class = if edge.controllable { "" } else { " class=\"dashed\"" };
    let _ = writeln!(out, "<path{class} d=\"{path}\" marker-end=\"url(#tip)\"/>");
    let _ = writeln!(out, "<text class=\"label\" x=\"{x}\" y=\"{y}\">{}</text>", escaped(&edge.label));
}

/// From the right side to the left one, and where the label stands.
fn forward(from: Place, to: Place) -> (String, (usize, usize)) {
    let (x, y) = (from.x + from.width, from.y + from.height / 2);
    let (end, level) = (to.x, to.y + to.height / 2);
    let middle = usize::midpoint(x, end);
    (format!("M{x} {y}C{middle} {y} {middle} {level} {end} {level}"), (middle, usize::midpoint(y, level) - 4))
}

/// From the lower side to the lower side, along a track.
fn around(from: Place, to: Place, track: usize) -> (String, (usize, usize)) {
    // A state's own arrow begins and ends at different places.
    let (x, end) = (from.x + from.width * 2 / 3, to.x + to.width / 3);
    let (y, level) = (from.y + from.height, to.y + to.height);
    (format!("M{x} {y}V{track}H{end}V{level}"), (usize::midpoint(x, end), track - 3))
}

fn places(graph: &Graph, top: usize) -> Vec<Place> {
    let layers = layers(graph);
    let longest = |layer: &[usize]| {
        let lines = layer.iter().flat_map(|&node| &graph.nodes[node].lines);
        lines.map(|line| line.chars().count()).max().unwrap_or(0)
    };
    let label = graph.edges.iter().map(|edge| edge.label.chars().count()).max().unwrap_or(0);
    let heights: Vec<usize> = graph.nodes.iter().map(|node| LINE * node.lines.len() + 8).collect();
    let total = |layer: &[usize]| layer.iter().map(|&node| heights[node] + GAP).sum::<usize>();
    let tallest = layers.iter().map(|layer| total(layer)).max().unwrap_or(0);
    let mut places = vec![Place { layer: 0, x: 0, y: top, width: 0, height: 0 }; graph.nodes.len()];
    let mut x = 2 * MARGIN;
    for (number, layer) in layers.iter().enumerate() {
        let width = longest(layer) * CHARACTER + 16;
        let mut y = top + (tallest - total(layer)) / 2;
        for &node in layer {
            places[node] = Place { layer: number, x, y, width, height: heights[node] };
            y += heights[node] + GAP;
        }
        x += width + GAP + label * CHARACTER;
    }
    places
}

/// States by their distance from the initial one, those out of its reach last.
fn layers(graph: &Graph) -> Vec<Vec<usize>> {
    let mut seen = vec![false; graph.nodes.len()];
    let mut layers = Vec::new();
    let mut layer = vec![graph.initial];
    seen[graph.initial] = true;
    while !layer.is_empty() {
        let mut next = Vec::new();
        for edge in layer.iter().flat_map(|&node| graph.edges.iter().filter(move |edge| edge.source == node))
        {
            if !std::mem::replace(&mut seen[edge.target], true) {
                next.push(edge.target);
            }
        }
        layers.push(std::mem::replace(&mut layer, next));
    }
    let rest: Vec<usize> = (0..graph.nodes.len()).filter(|&node| !seen[node]).collect();
    if !rest.is_empty() {
        layers.push(rest);
    }
    layers
}
