//! A second opinion on games, slow and simple: the nested fixed points of the definition, over a graph in which
//! edges (and silences) are nodes of their own, so that acceptance is on nodes only.

use std::collections::BTreeSet;
use synth_core::game::{Game, Strategy, Turn};

type Nodes = Vec<bool>;

/// The graph with a node for each state, then one for each edge, then one for each silence.
pub(crate) struct Graph {
    pub(crate) states: usize,
    successors: Vec<Vec<usize>>,
    system: Nodes,
    environment: Nodes,
    lost: Nodes,
    assumptions: Vec<Nodes>,
    goals: Vec<Nodes>,
}

impl Graph {
    pub(crate) fn new(game: &Game) -> Self {
        let states = game.states();
        let mut successors = vec![Vec::new(); states];
        let mut met: Vec<BTreeSet<u32>> = Vec::new();
        let keys = 0..game.key_sets.keys();
        for state in 0..states {
            met.push(keys.clone().filter(|&key| !game.key_sets.contains(game.open[state], key)).collect());
        }
        for state in 0..states {
            for edge in game.edges_of(state as u32) {
                let node = successors.len();
                successors[state].push(node);
                successors.push(vec![game.target[edge] as usize]);
                met.push(game.key_sets.members(game.discharged(edge)).collect());
            }
            if game.silent[state] {
                let node = successors.len();
                successors[state].push(node);
                successors.push(vec![state]);
                met.push(BTreeSet::new());
            }
        }
        // The end of the play is a loop.
        for (state, turn) in game.turn.iter().enumerate() {
            if matches!(turn, Turn::Won | Turn::Lost) {
                successors[state].push(state);
            }
        }
        let nodes = successors.len();
        let is = |turns: fn(Turn) -> bool| -> Nodes {
            (0..nodes).map(|node| node < states && turns(game.turn[node])).collect()
        };
        let won = is(|turn| turn == Turn::Won);
        let meets = |&key: &u32| met.iter().map(|met| met.contains(&key)).collect::<Nodes>();
        let mut goals: Vec<Nodes> = game.guarantees.iter().map(meets).collect();
        for goal in &mut goals {
            goal.iter_mut().zip(&won).for_each(|(met, &won)| *met |= won);
        }
        goals.push(is(|turn| turn.is_environment() || turn == Turn::Won));
        Graph {
            states,
            system: is(Turn::is_system),
            environment: is(Turn::is_environment),
            lost: is(|turn| turn == Turn::Lost),
            assumptions: game.assumptions.iter().map(meets).collect(),
            goals,
            successors,
        }
    }

    /// The nodes from which the system can force the next node to be in `nodes`.
    fn controllable(&self, nodes: &Nodes, node: usize) -> bool {
        let successors = &self.successors[node];
        !self.lost[node]
            && if self.system[node] {
                successors.iter().any(|&next| nodes[next])
            } else {
                successors.iter().all(|&next| nodes[next])
            }
    }

    fn filled(&self, value: bool) -> Nodes {
        vec![value; self.successors.len()]
    }

    /// νZ. ⋀j μY. ⋁i νX. (Gj ∧ cpre Z) ∨ cpre Y ∨ (¬Ai ∧ cpre X). If super steps must end whatever becomes of the
    /// assumptions, there is no Ai for the last goal, and for the others
    /// νX. μV. (Gj ∧ cpre Z) ∨ cpre Y ∨ (¬Ai ∧ (Env ∧ cpre X ∨ cpre V)).
    pub(crate) fn winning(&self, ending: bool) -> Nodes {
        let never = vec![self.filled(true)];
        let mut z = self.filled(true);
        loop {
            let mut next_z = self.filled(true);
            for (index, goal) in self.goals.iter().enumerate() {
                let last = ending && index + 1 == self.goals.len();
                let assumptions =
                    if last || self.assumptions.is_empty() { &never } else { &self.assumptions };
                let mut y = self.filled(false);
                loop {
                    let mut next_y = self.filled(false);
                    for assumption in assumptions {
                        let mut x = self.filled(true);
                        loop {
                            let mut v = if ending { self.filled(false) } else { x.clone() };
                            let next_x = loop {
                                let next_v: Nodes = (0..x.len())
                                    .map(|node| {
                                        let stays = self.controllable(&v, node)
                                            || self.environment[node] && self.controllable(&x, node);
                                        goal[node] && self.controllable(&z, node)
                                            || self.controllable(&y, node)
                                            || !assumption[node] && stays
                                    })
                                    .collect();
                                if !ending || next_v == v {
                                    break next_v;
                                }
                                v = next_v;
                            };
                            if next_x == x {
                                break;
                            }
                            x = next_x;
                        }
                        next_y.iter_mut().zip(&x).for_each(|(y, &x)| *y |= x);
                    }
                    if next_y == y {
                        break;
                    }
                    y = next_y;
                }
                next_z.iter_mut().zip(&y).for_each(|(z, &y)| *z &= y);
            }
            if next_z == z {
                return z;
            }
            z = next_z;
        }
    }

    /// Panics if some play of this graph, all of whose nodes are reachable, is lost: whoever chooses.
    fn assert_every_play_is_won(&self, ending: bool) {
        let nodes = self.successors.len();
        for (index, goal) in self.goals.iter().enumerate() {
            // `reach[u][v]`: a path of at least one step from u to v through nodes that miss the goal.
            let mut reach = vec![vec![false; nodes]; nodes];
            for node in (0..nodes).filter(|&node| !goal[node]) {
                for &next in &self.successors[node] {
                    reach[node][next] = !goal[next];
                }
            }
            for via in 0..nodes {
                for from in 0..nodes {
                    if reach[from][via] {
                        let further = reach[via].clone();
                        reach[from].iter_mut().zip(further).for_each(|(reach, further)| *reach |= further);
                    }
                }
            }
            for node in (0..nodes).filter(|&node| reach[node][node]) {
                let around = |other: usize| reach[node][other] && reach[other][node];
                let fair = ending && index + 1 == self.goals.len()
                    || self.assumptions.iter().all(|met| (0..nodes).any(|other| met[other] && around(other)));
                assert!(!fair, "goal {index} is missed around node {node}");
            }
        }
        assert!(!self.lost.contains(&true), "the lost state can be reached");
    }
}

/// Panics unless the strategy is a well-formed one of the game and wins.
pub(crate) fn assert_wins(game: &Game, strategy: &Strategy, ending: bool) {
    assert_eq!(strategy.state[0], game.initial);
    let mut found = 1;
    for node in 0..strategy.nodes() as u32 {
        let state = strategy.state[node as usize];
        let edges: Vec<u32> = strategy.edges_of(node).map(|edge| strategy.edge[edge]).collect();
        let all: Vec<u32> = game.edges_of(state).map(|edge| edge as u32).collect();
        if game.turn[state as usize].is_system() {
            assert!(edges.len() == 1 && all.contains(&edges[0]), "node {node} is no choice");
        } else {
            assert_eq!(edges, all, "node {node} does not have all edges");
        }
        for edge in strategy.edges_of(node) {
            let target = strategy.target[edge];
            assert_eq!(strategy.state[target as usize], game.target[strategy.edge[edge] as usize]);
            assert!(target <= found, "nodes are not numbered breadth first");
            found = found.max(target + 1);
        }
    }
    assert_eq!(found as usize, strategy.nodes(), "unreachable nodes");
    // The strategy as a game without choices for the system.
    let of = |values: &[u32]| strategy.state.iter().map(|&state| values[state as usize]).collect::<Vec<_>>();
    let played = Game {
        initial: 0,
        turn: strategy.state.iter().map(|&state| game.turn[state as usize]).collect(),
        silent: strategy.state.iter().map(|&state| game.silent[state as usize]).collect(),
        open: of(&game.open),
        first: strategy.first.clone(),
        action: strategy.edge.iter().map(|&edge| game.action[edge as usize]).collect(),
        actions: game.actions.clone(),
        target: strategy.target.clone(),
        key_sets: game.key_sets.clone(),
        assumptions: game.assumptions.clone(),
        guarantees: game.guarantees.clone(),
    };
    Graph::new(&played).assert_every_play_is_won(ending);
}
