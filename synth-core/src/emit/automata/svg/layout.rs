//! Where states stand and arrows run.
//!
//! States are in layers by their distance from the initial one, from left to right. An arrow to the next layer runs between the
//! sides of states. Any other one runs along a *track* below all states, down to it and up from it beside the layer, or right
//! below a state under which there is no other: so no arrow crosses a state, and no two run upon each other.

use super::super::{Edge, Graph};
use super::{CHARACTER, LINE, MARGIN};

/// Between layers beside the longest label, and between states of a layer.
pub(super) const GAP: usize = 40;
/// Between lines beside a layer.
const STEP: usize = 6;
/// From a layer to the first line on its left: as long as a tip and a bit.
const TIP: usize = 14;
/// Between tracks: a label has room.
const TRACK: usize = LINE + 4;
/// How often layers are put in the order of their neighbours.
const SWEEPS: usize = 8;

/// The box of a state.
#[derive(Clone, Copy, Default)]
pub(super) struct Place {
    layer: usize,
    /// There is no state below.
    last: bool,
    pub(super) x: usize,
    pub(super) y: usize,
    pub(super) width: usize,
    pub(super) height: usize,
}

impl Place {
    fn bottom(self) -> usize {
        self.y + self.height
    }
}

/// An arrow.
pub(super) struct Route {
    pub(super) path: String,
    /// Where the label can stand, the best place first.
    pub(super) labels: Vec<(usize, usize)>,
}

/// A drawing of a graph.
pub(super) struct Layout {
    /// Per node.
    pub(super) places: Vec<Place>,
    /// Per edge.
    pub(super) routes: Vec<Route>,
    pub(super) right: usize,
    pub(super) bottom: usize,
}

impl Layout {
    /// Of a graph, below `top`.
    pub(super) fn new(graph: &Graph, top: usize) -> Layout {
        let mut layers = layers(graph);
        untangle(graph, &mut layers);
        let places = places(graph, &layers, top);
        let floor = places.iter().map(|place| place.bottom()).max().unwrap_or(top);
        let ends: Vec<Option<[End; 2]>> = ends(graph, &places);
        let tracks = tracks(&ends);
        let used = tracks.iter().flatten().map(|track| track + 1).max().unwrap_or(0);
        let route = |(number, edge): (usize, &Edge)| {
            let (from, to) = (places[edge.source], places[edge.target]);
            let half = edge.label.chars().count() * CHARACTER / 2;
            match (ends[number], tracks[number]) {
                (Some(ends), Some(track)) => around(ends, floor + TRACK * (track + 1), half),
                _ if edge.source == edge.target => within(from, half),
                _ => {
                    // Events of both kinds between the same states are two arrows.
                    let twin = number > 0
                        && graph.edges[number - 1].source == edge.source
                        && graph.edges[number - 1].target == edge.target;
                    forward(from, to, if twin { from.height / 3 } else { 0 })
                }
            }
        };
        let routes: Vec<Route> = graph.edges.iter().enumerate().map(route).collect();
        let boxes = places.iter().map(|place| place.x + place.width);
        let beside = ends.iter().flatten().flatten().map(|end| end.x + STEP);
        let labels = graph.edges.iter().zip(&routes).flat_map(|(edge, route)| {
            let half = edge.label.chars().count() * CHARACTER / 2;
            route.labels.iter().map(move |(x, _)| x + half)
        });
        let right = boxes.chain(beside).chain(labels).max().unwrap_or(0);
        Layout { places, routes, right, bottom: floor + TRACK * used }
    }
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

/// Puts states between their neighbours in the layers before and behind, so that fewer arrows cross.
fn untangle(graph: &Graph, layers: &mut [Vec<usize>]) {
    let mut height = vec![0.0; graph.nodes.len()];
    let settle = |layer: &[usize], height: &mut [f64]| {
        for (row, &node) in layer.iter().enumerate() {
            height[node] = row as f64 - (layer.len() - 1) as f64 / 2.0;
        }
    };
    layers.iter().for_each(|layer| settle(layer, &mut height));
    let mut layer_of = vec![0; graph.nodes.len()];
    for (number, layer) in layers.iter().enumerate() {
        layer.iter().for_each(|&node| layer_of[node] = number);
    }
    for sweep in 0..SWEEPS {
        let onwards = sweep % 2 == 0;
        for step in 1..layers.len() {
            let number = if onwards { step } else { layers.len() - 1 - step };
            let beside = |node: usize| {
                let edges =
                    graph.edges.iter().filter(|edge| layer_of[edge.target] == layer_of[edge.source] + 1);
                let ends = edges.filter_map(|edge| match onwards {
                    true if edge.target == node => Some(height[edge.source]),
                    false if edge.source == node => Some(height[edge.target]),
                    _ => None,
                });
                let ends: Vec<f64> = ends.collect();
                if ends.is_empty() { height[node] } else { ends.iter().sum::<f64>() / ends.len() as f64 }
            };
            let wanted: Vec<f64> = (0..graph.nodes.len()).map(beside).collect();
            // Stable: what wants the same place keeps its order.
            layers[number].sort_by(|&a, &b| wanted[a].total_cmp(&wanted[b]));
            settle(&layers[number], &mut height);
        }
    }
}

fn places(graph: &Graph, layers: &[Vec<usize>], top: usize) -> Vec<Place> {
    let mut places = vec![Place::default(); graph.nodes.len()];
    let heights: Vec<usize> = graph.nodes.iter().map(|node| LINE * node.lines.len() + 8).collect();
    let total = |layer: &[usize]| layer.iter().map(|&node| heights[node] + GAP).sum::<usize>();
    let tallest = layers.iter().map(|layer| total(layer)).max().unwrap_or(0);
    for (number, layer) in layers.iter().enumerate() {
        let mut y = top + (tallest - total(layer)) / 2;
        for (row, &node) in layer.iter().enumerate() {
            let last = row + 1 == layer.len();
            places[node] = Place { layer: number, last, y, height: heights[node], ..Place::default() };
            y += heights[node] + GAP;
        }
    }
    let label = graph.edges.iter().map(|edge| edge.label.chars().count()).max().unwrap_or(0);
    let longest = |layer: &[usize]| {
        let lines = layer.iter().flat_map(|&node| &graph.nodes[node].lines);
        lines.map(|line| line.chars().count()).max().unwrap_or(0)
    };
    let mut x = 2 * MARGIN;
    for (number, layer) in layers.iter().enumerate() {
        x += STEP * lines(graph, &places, number, |edge| edge.target);
        let width = longest(layer) * CHARACTER + 16;
        layer.iter().for_each(|&node| (places[node].x, places[node].width) = (x, width));
        x += width + GAP + label * CHARACTER + STEP * lines(graph, &places, number, |edge| edge.source);
    }
    places
}

/// How many lines run beside a layer: at the left the `end`s of arrows are their targets, at the right their sources.
fn lines(graph: &Graph, places: &[Place], layer: usize, end: fn(&Edge) -> usize) -> usize {
    let beside = graph.edges.iter().filter(|edge| is_below(places, edge));
    beside.filter(|edge| places[end(edge)].layer == layer && !places[end(edge)].last).count()
}

/// Whether an arrow needs a track.
fn is_below(places: &[Place], edge: &Edge) -> bool {
    let (from, to) = (places[edge.source], places[edge.target]);
    if edge.source == edge.target { from.last } else { to.layer != from.layer + 1 }
}

/// Where an arrow leaves or meets a state, and where it runs down from there, or up.
#[derive(Clone, Copy)]
struct End {
    at: (usize, usize),
    x: usize,
}

/// Per edge that needs a track its ends. Every end of a state has a place of its own.
fn ends(graph: &Graph, places: &[Place]) -> Vec<Option<[End; 2]>> {
    let below: Vec<bool> = graph.edges.iter().map(|edge| is_below(places, edge)).collect();
    let layers = places.iter().map(|place| place.layer + 1).max().unwrap_or(0);
    let mut beside = [vec![0; layers], vec![0; layers]];
    let mut met = [vec![0; places.len()], vec![0; places.len()]];
    let all = |node: usize, end: fn(&Edge) -> usize| {
        graph.edges.iter().zip(&below).filter(|(edge, below)| **below && end(edge) == node).count()
    };
    let mut end = |node: usize, side: usize, of: fn(&Edge) -> usize| {
        let place = places[node];
        met[side][node] += 1;
        let (number, count) = (met[side][node], all(node, of) + 1);
        if place.last {
            // Out of the right half, into the left one.
            let half = place.width / 2;
            let x = place.x + half * number / count + if side == 0 { half } else { 0 };
            return End { at: (x, place.bottom()), x };
        }
        let half = place.height / 2;
        let y = place.y + half + half * number / count;
        let line = &mut beside[side][place.layer];
        *line += 1;
        let away = TIP + STEP * (*line - 1);
        if side == 0 {
            let right = place.x + place.width;
            End { at: (right, y), x: right + away - TIP / 2 }
        } else {
            End { at: (place.x, y), x: place.x - away }
        }
    };
    let edges = graph.edges.iter().zip(&below);
    edges
        .map(|(edge, below)| {
            below.then(|| [end(edge.source, 0, |edge| edge.source), end(edge.target, 1, |edge| edge.target)])
        })
        .collect()
}

/// Per edge its track, counted from the states: short ones first, and what does not overlap on one.
fn tracks(ends: &[Option<[End; 2]>]) -> Vec<Option<usize>> {
    let mut spans: Vec<(usize, usize, usize)> = ends
        .iter()
        .enumerate()
        .filter_map(|(edge, ends)| ends.map(|[from, to]| (edge, from.x.min(to.x), from.x.max(to.x))))
        .collect();
    spans.sort_by_key(|&(edge, left, right)| (right - left, edge));
    let mut taken: Vec<Vec<(usize, usize)>> = Vec::new();
    let mut tracks = vec![None; ends.len()];
    for (edge, left, right) in spans {
        let is_free = |track: &Vec<(usize, usize)>| {
            track.iter().all(|&(from, to)| right + MARGIN < from || to + MARGIN < left)
        };
        let track = taken.iter().position(is_free).unwrap_or(taken.len());
        if track == taken.len() {
            taken.push(Vec::new());
        }
        taken[track].push((left, right));
        tracks[edge] = Some(track);
    }
    tracks
}

/// From the right side to the left one.
fn forward(from: Place, to: Place, lower: usize) -> Route {
    let (x, y) = (from.x + from.width, from.y + from.height / 2 + lower);
    let (end, level) = (to.x, to.y + to.height / 2 + lower);
    let middle = usize::midpoint(x, end);
    // On the curve, with all its parts in per cent.
    let on = |percent: usize| {
        let (t, s) = (percent, 100 - percent);
        let outer = |a: usize, b: usize, c: usize| {
            (a * s * s * s + 3 * b * s * s * t + 3 * b * s * t * t + c * t * t * t) / 1_000_000
        };
        let rise = (y * (s * s * s + 3 * s * s * t) + level * (t * t * t + 3 * s * t * t)) / 1_000_000;
        (outer(x, middle, end), rise - 4)
    };
    Route {
        path: format!("M{x} {y}C{middle} {y} {middle} {level} {end} {level}"),
        labels: [50, 38, 62, 28, 72].map(on).into(),
    }
}

/// Along a track; the label stands on it, or behind it if it is longer, of which `half` is given.
fn around([from, to]: [End; 2], track: usize, half: usize) -> Route {
    // The last piece turns the tip, so there is none of no length.
    let aside = |end: End, x: usize| if end.x == end.at.0 { String::new() } else { format!("H{x}") };
    let (out, back) = (aside(from, from.x), aside(to, to.at.0));
    Route {
        path: format!("M{} {}{out}V{track}H{}V{}{back}", from.at.0, from.at.1, to.x, to.at.1),
        labels: on_track(from.x.min(to.x), from.x.max(to.x), track, half),
    }
}

fn on_track(left: usize, right: usize, track: usize, half: usize) -> Vec<(usize, usize)> {
    if right - left < 2 * half {
        return vec![(right + half + STEP, track - 3)];
    }
    [4, 3, 5, 2, 6].map(|part| (left + (right - left) * part / 8, track - 3)).into()
}

/// From a state to itself, above another state.
fn within(of: Place, half: usize) -> Route {
    let (from, to, track) = (of.x + of.width * 2 / 3, of.x + of.width / 3, of.bottom() + TRACK);
    Route {
        path: format!("M{from} {}V{track}H{to}V{}", of.bottom(), of.bottom()),
        labels: on_track(to, from, track, half),
    }
}
