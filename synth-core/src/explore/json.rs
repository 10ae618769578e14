//! The explicit game as JSON, for programs that draw, compare or check it.
//!
//! ```json
//! {"version":1,"initial":0,
//!  "states":[{"id":0,"owner":"environment","case":6,"yielded":false,"attributes":{"lamp.on":false},
//!             "copies":[{"scenario":"C.S","roles":{"r":"lamp"},"variables":{"v":3},"cut":"7:5"}]}],
//!  "edges":[[0,"a -> c.go()",1,[0]]],
//!  "keys":[{"kind":"guarantee","scenario":"C.S[r=lamp]","line":7,"column":5,"values":[],"open":[0]}]}
//! ```
//!
//! States and edges are many, valuations, copies and sets of keys few: the text of each of these is made once.

use super::{Explored, StateId};
use crate::game::{Turn, YIELD};
use crate::model::{Domain, Kind, Spec, Type, UNSET, Value};
use crate::playout::{Copy, CopyId, Key, KeyId, bound_name, variables_read};
use rustc_hash::FxHashMap;
use serde_json::{Map, Value as Json, json};
use std::collections::BTreeSet;
use std::io::{self, Write};

/// Writes the whole game.
///
/// # Errors
/// Those of `out`.
pub fn write_json(explored: &Explored<'_>, out: &mut dyn Write) -> io::Result<()> {
    let game = &explored.game;
    let mut cache = Cache::new(explored);
    write!(out, "{{\"version\":1,\"initial\":{},\n\"states\":[", game.initial)?;
    for state in 0..game.states() as StateId {
        out.write_all(if state == 0 { b"\n" } else { b",\n" })?;
        cache.state(state, out)?;
    }
    out.write_all(b"\n],\n\"edges\":[")?;
    for source in 0..game.states() as StateId {
        for edge in game.edges_of(source) {
            out.write_all(if edge == 0 { b"\n" } else { b",\n" })?;
            cache.edge(source, edge, out)?;
        }
    }
    out.write_all(b"\n],\n\"keys\":[")?;
    for (index, open) in open_states(explored, &cache.keys).iter().enumerate() {
        out.write_all(if index == 0 { b"\n" } else { b",\n" })?;
        let mut key = describe_key(explored, cache.keys[index]);
        key["open"] = json!(open);
        write!(out, "{key}")?;
    }
    out.write_all(b"\n]}\n")
}

/// Texts of what states and edges share.
struct Cache<'e, 's> {
    explored: &'e Explored<'s>,
    /// The keys that are shown, ascending; outputs refer to them by their position.
    keys: Vec<KeyId>,
    valuations: FxHashMap<Vec<Value>, String>,
    copies: Vec<Option<String>>,
    /// Per event.
    events: Vec<String>,
    /// Per set of keys.
    sets: Vec<String>,
    /// Of the state at hand.
    values: Vec<Value>,
    copies_there: Vec<CopyId>,
}

impl<'e, 's> Cache<'e, 's> {
    fn new(explored: &'e Explored<'s>) -> Self {
        let Explored { playout, game, .. } = explored;
        let mut shown = BTreeSet::new();
        shown.extend(game.assumptions.iter().chain(&game.guarantees).copied());
        let mut used = vec![false; game.key_sets.len()];
        game.actions.discharged_sets().for_each(|set| used[set as usize] = true);
        let used = (0..game.key_sets.len() as u32).filter(|&set| used[set as usize]);
        shown.extend(used.flat_map(|set| game.key_sets.members(set)));
        let keys: Vec<KeyId> = shown.into_iter().collect();
        let set = |set: u32| {
            let members = game.key_sets.members(set);
            json!(members.filter_map(|key| keys.binary_search(&key).ok()).collect::<Vec<usize>>()).to_string()
        };
        let events =
            (0..playout.event_count() as u32).map(|event| json!(playout.event(event).text).to_string());
        Cache {
            explored,
            valuations: FxHashMap::default(),
            copies: Vec::new(),
            events: events.collect(),
            sets: (0..game.key_sets.len() as u32).map(set).collect(),
            values: Vec::new(),
            copies_there: Vec::new(),
            keys,
        }
    }

    fn state(&mut self, state: StateId, out: &mut dyn Write) -> io::Result<()> {
        let Explored { playout, store, game } = self.explored;
        let turn = game.turn[state as usize];
        let owner = match turn {
            _ if turn.is_system() => "system",
            _ if turn.is_environment() => "environment",
            _ => "none",
        };
        write!(out, "{{\"id\":{state},\"owner\":\"{owner}\",")?;
        if matches!(turn, Turn::Lost | Turn::Won) {
            return out.write_all(br#""case":null,"yielded":false,"attributes":{},"copies":[]}"#);
        }
        store.values(playout, state, &mut self.values);
        if !self.valuations.contains_key(&self.values) {
            let text = attributes(&playout.spec().domain, &self.values).to_string();
            self.valuations.insert(self.values.clone(), text);
        }
        let valuation = &self.valuations[&self.values];
        store.copies(state, &mut self.copies_there);
        let (case, yielded) = (turn as u8, store.yielded(state));
        write!(out, "\"case\":{case},\"yielded\":{yielded},\"attributes\":{valuation},\"copies\":[")?;
        for (position, &id) in self.copies_there.iter().enumerate() {
            let copy = remembered(&mut self.copies, id, || {
                describe_copy(playout.spec(), playout.copy(id)).to_string()
            });
            write!(out, "{}{copy}", if position == 0 { "" } else { "," })?;
        }
        out.write_all(b"]}")
    }

    fn edge(&self, source: StateId, edge: usize, out: &mut dyn Write) -> io::Result<()> {
        let game = &self.explored.game;
        let (label, target) = (game.label(edge), game.target[edge]);
        let text = if label == YIELD { "\"yield\"" } else { &self.events[label as usize] };
        let discharged = &self.sets[game.discharged(edge) as usize];
        write!(out, "[{source},{text},{target},{discharged}]")
    }
}

/// The text with this index, made when it is asked for first.
fn remembered(texts: &mut Vec<Option<String>>, index: u32, make: impl FnOnce() -> String) -> &str {
    let index = index as usize;
    if texts.len() <= index {
        texts.resize(index + 1, None);
    }
    texts[index].get_or_insert_with(make)
}

/// Per key: the states in which it is open, ascending.
fn open_states(explored: &Explored<'_>, keys: &[KeyId]) -> Vec<Vec<StateId>> {
    let game = &explored.game;
    let mut open = vec![Vec::new(); keys.len()];
    for (state, &set) in (0..).zip(&game.open) {
        for key in game.key_sets.members(set) {
            if let Ok(index) = keys.binary_search(&key) {
                open[index].push(state);
            }
        }
    }
    open
}

fn describe_key(explored: &Explored<'_>, key: KeyId) -> Json {
    let spec = explored.playout.spec();
    let Key { scenario, roles, node, values } = explored.playout.key(key);
    let scenario = &spec.scenarios[*scenario];
    let place = scenario.nodes[usize::from(*node)].span.start;
    let types = variables_read(scenario, *node).into_iter().map(|variable| scenario.variables[variable].ty);
    let values = values.iter().zip(types).map(|(&value, ty)| value_json(&spec.domain, value, ty));
    json!({
        "kind": match scenario.kind {
            Kind::Assumption => "assumption",
            Kind::Guarantee | Kind::Existential => "guarantee",
        },
        "scenario": bound_name(spec, scenario, roles),
        "line": place.line,
        "column": place.column,
        "values": values.collect::<Vec<Json>>(),
    })
}

fn describe_copy(spec: &Spec, copy: &Copy) -> Json {
    let scenario = &spec.scenarios[copy.scenario];
    let roles = scenario.roles.iter().zip(&copy.roles);
    let roles: Map<String, Json> =
        roles.map(|(role, &value)| (role.name.clone(), object_json(&spec.domain, value))).collect();
    let mut variables = Map::new();
    for (variable, &value) in scenario.variables.iter().zip(&copy.variables) {
        let value = value_json(&spec.domain, value, variable.ty);
        // Bodies side by side may declare the same name.
        let mut name = variable.name.clone();
        let mut number = 2;
        while variables.contains_key(&name) {
            name = format!("{}#{number}", variable.name);
            number += 1;
        }
        variables.insert(name, value);
    }
    let place = |&node: &u16| {
        let start = scenario.nodes[usize::from(node)].span.start;
        format!("{}:{}", start.line, start.column)
    };
    let cut: Vec<String> = copy.cut.iter().map(place).collect();
    json!({ "scenario": scenario.name, "roles": roles, "variables": variables, "cut": cut.join(",") })
}

fn attributes(domain: &Domain, values: &[Value]) -> Json {
    let mut all = Map::new();
    for object in &domain.objects {
        for (position, attribute) in domain.classes[object.class].attributes.iter().enumerate() {
            let value = value_json(domain, values[object.first_slot + position], attribute.ty);
            all.insert(format!("{}.{}", object.name, attribute.name), value);
        }
    }
    Json::Object(all)
}

/// An object by its name; `null` also for a role that is not bound.
fn object_json(domain: &Domain, value: Value) -> Json {
    usize::try_from(value).map_or(Json::Null, |object| json!(domain.objects[object].name))
}

/// A value; `null` also for a variable that is not set.
fn value_json(domain: &Domain, value: Value, ty: Type) -> Json {
    match ty {
        _ if value == UNSET => Json::Null,
        Type::Bool => json!(value != 0),
        Type::Int(..) => json!(value),
        Type::Enum(_) => json!(domain.show(value, ty)),
        Type::Class(_) => object_json(domain, value),
    }
}
