//! The breadth-first search: expand a layer, sort what it leads to, take away what was known, go on.

use super::Task;
use super::checkpoint::{Standing, Unusable, decode, encode};
use super::error::{ExternalError, Progress, Result};
use super::expand::{self, Block};
use super::folder::Folder;
use super::merge::Merge;
use super::order::{convert, sort};
use super::recent::Recent;
use super::segment::{Cursor, Segment, Writer};
use super::tables::{Mistake, Tables};
use super::visited::{Probe, Visited};
use crate::explore::{ExploreError, LimitReached, Limits};
use crate::game::YIELD;
use crate::playout::{KeyId, Playout};
use crate::successors::{Learned, PackedMoves};
use std::collections::BTreeSet;

/// Most rows of a batch. It says when something is learned, so numbers depend on it: it must be the same always.
const BATCH: usize = 1 << 14;

/// Most files that are merged at once.
const FAN: usize = 64;

/// How often a merge asks whether to stop, in rows.
const PERIOD: u64 = 1 << 16;

pub(super) struct Search<'x, 'p, 's> {
    tables: Tables<'p, 's>,
    folder: Folder,
    limits: &'x Limits,
    task: &'x Task<'x>,
    pub(super) standing: Standing,
    visited: Vec<Visited>,
    /// Files that the last checkpoint names.
    named: BTreeSet<u64>,
    /// States explored since then.
    since: u64,
    recent: Recent,
    /// Rows that the layer leads to, not sorted yet.
    candidates: Vec<u64>,
    blocks: Vec<Block>,
    learned: Block,
}

impl<'x, 'p, 's> Search<'x, 'p, 's> {
    /// Stands where the checkpoint says, or at the initial state.
    pub(super) fn open(playout: &'p mut Playout<'s>, limits: &'x Limits, task: &'x Task<'x>) -> Result<Self> {
        let folder = Folder::open(task.folder)?;
        let initial = Tables::new(playout);
        let (mut tables, row) =
            initial.map_err(|error| ExternalError::Explore(ExploreError::Play(error, Vec::new())))?;
        let saved = folder.read_checkpoint()?;
        let resumed = saved.map(|bytes| decode(&bytes, task.origin, &mut tables)).transpose();
        let resumed = resumed.map_err(|why| match why {
            Unusable::Other(what) => ExternalError::Other(folder.checkpoint(), what),
            Unusable::Damaged => {
                ExternalError::Damaged(folder.checkpoint(), "it is not what was written".to_owned())
            }
        })?;
        let is_new = resumed.is_none();
        let mut search = Search {
            recent: Recent::new(tables.words(), task.budget.recent(tables.words()).min(1 << 12)),
            tables,
            folder,
            limits,
            task,
            standing: resumed.unwrap_or_default(),
            visited: Vec::new(),
            named: BTreeSet::new(),
            since: 0,
            candidates: Vec::new(),
            blocks: Vec::new(),
            learned: Block::default(),
        };
        if is_new {
            search.begin(&row)?;
        } else {
            search.go_on()?;
        }
        Ok(search)
    }

    fn begin(&mut self, initial: &[u64]) -> Result<()> {
        self.folder.sweep(&BTreeSet::new())?;
        let number = self.next_file();
        let mut writer = Writer::new(&self.folder, number, 0)?;
        writer.push(initial)?;
        let (segment, index) = writer.finish()?;
        self.standing.layers.push(segment);
        self.visited.push(Visited { segment, index });
        self.checkpoint()
    }

    fn go_on(&mut self) -> Result<()> {
        self.named = self.standing.files();
        for segment in self.standing.segments().into_iter().flatten() {
            segment.check(&self.folder)?;
        }
        for &segment in &self.standing.visited {
            let words = self.tables.layouts[segment.layout as usize].words();
            self.visited.push(Visited { segment, index: segment.index(&self.folder, words)? });
        }
        self.folder.sweep(&self.named)
    }

    /// Explores until nothing is new.
    pub(super) fn run(&mut self) -> Result<()> {
        while !self.standing.finished {
            self.expand_layer()?;
            self.close_layer()?;
            if self.standing.states() > self.limits.states as u64 {
                self.checkpoint()?;
                return Err(self.limit("states", self.limits.states));
            }
        }
        self.checkpoint()
    }

    /// Finds what the last layer leads to.
    fn expand_layer(&mut self) -> Result<()> {
        let Some(&layer) = self.standing.layers.last() else { return Ok(()) };
        let own = self.tables.layouts[layer.layout as usize].clone();
        let mut cursor = Cursor::new(&self.folder, &layer, &self.tables.layouts[..=layer.layout as usize])?;
        cursor.skip(self.standing.done)?;
        let mut read = Vec::new();
        while self.standing.done < layer.rows {
            read.clear();
            while read.len() < BATCH * own.words() && cursor.advance()? {
                read.extend_from_slice(cursor.row());
            }
            let rows = (read.len() / own.words()) as u64;
            if rows == 0 {
                cursor.skip(1)?;
            }
            if layer.layout as usize + 1 < self.tables.layouts.len() {
                read = convert(&own, self.tables.layout(), &read);
            }
            self.expand(&mut read)?;
            self.standing.done += rows;
            self.since += rows;
            if self.since >= self.task.budget.checkpoint {
                self.checkpoint()?;
            }
            self.check()?;
        }
        Ok(())
    }

    /// Counts the moves of a batch and collects where they lead.
    fn expand(&mut self, batch: &mut Vec<u64>) -> Result<()> {
        let filled = loop {
            let filled = expand::fill(&mut self.blocks, &self.tables.successors, batch, self.limits.threads);
            let narrow = self.learn(filled, batch)?;
            if narrow.is_empty() {
                break filled;
            }
            *batch = self.widen(&narrow, batch)?;
        };
        let mut blocks = std::mem::take(&mut self.blocks);
        for block in blocks[..filled].iter().chain([&self.learned]) {
            self.standing.counts.join(&block.counts);
        }
        let learned = std::mem::take(&mut self.learned);
        for block in blocks[..filled].iter().chain([&learned]) {
            self.collect(&block.rows)?;
        }
        self.learned = learned;
        std::mem::swap(&mut self.blocks, &mut blocks);
        Ok(())
    }

    /// Finds the moves that the tables did not give; what rows have no room for.
    fn learn(&mut self, filled: usize, batch: &[u64]) -> Result<Vec<(u32, u32)>> {
        let (mut moves, mut narrow) = (PackedMoves::default(), Vec::new());
        let words = self.tables.words();
        self.learned.clear();
        for &place in self.blocks[..filled].iter().flat_map(|block| &block.missed) {
            let row = &batch[place * words..(place + 1) * words];
            match self.tables.settle(row, &mut narrow, &mut moves) {
                Ok(Learned::Moves) => {
                    let Block { counts, rows, .. } = &mut self.learned;
                    counts.add(&self.tables.successors, row, &moves, rows);
                }
                Ok(Learned::Narrow) => {}
                Err(mistake) => return Err(self.mistake(row.to_vec(), mistake)),
            }
        }
        Ok(narrow)
    }

    /// Makes room in rows; the batch in the new layout.
    fn widen(&mut self, narrow: &[(u32, u32)], batch: &[u64]) -> Result<Vec<u64>> {
        self.flush()?;
        let old = self.tables.layout().clone();
        self.tables.widen(narrow);
        self.recent = Recent::new(self.tables.words(), self.recent.rows());
        Ok(convert(&old, self.tables.layout(), batch))
    }

    fn collect(&mut self, rows: &[u64]) -> Result<()> {
        let words = self.tables.words();
        for row in rows.chunks_exact(words) {
            if !self.recent.knows(row) {
                self.candidates.extend_from_slice(row);
            }
        }
        if self.candidates.len() * size_of::<u64>() >= self.task.budget.candidates {
            self.flush()
        } else {
            Ok(())
        }
    }

    /// Writes what was collected.
    fn flush(&mut self) -> Result<()> {
        if self.candidates.is_empty() {
            return Ok(());
        }
        let words = self.tables.words();
        let mut rows = std::mem::take(&mut self.candidates);
        sort(&mut rows, words);
        let mut writer = self.writer()?;
        for row in rows.chunks_exact(words) {
            writer.push(row)?;
        }
        let (run, _) = writer.finish()?;
        rows.clear();
        self.candidates = rows;
        self.standing.runs.push(run);
        if self.standing.runs.len() < FAN {
            return Ok(());
        }
        let runs = self.standing.runs.clone();
        match self.merge(&runs, None) {
            Ok(merged) => self.replace_runs(merged),
            // They are as good unmerged: whoever looks next whether to stop makes a checkpoint of them.
            Err(ExternalError::Stopped(_)) => {}
            Err(error) => return Err(error),
        }
        Ok(())
    }

    fn replace_runs(&mut self, merged: Option<Visited>) {
        let runs = std::mem::take(&mut self.standing.runs);
        self.standing.runs.extend(merged.map(|merged| merged.segment));
        runs.iter().for_each(|run| self.retire(run));
    }

    /// One file of several, without the rows that were visited; none if nothing is left.
    fn merge(&mut self, segments: &[Segment], without: Option<&[Visited]>) -> Result<Option<Visited>> {
        let number = self.next_file();
        let Tables { layouts, .. } = &self.tables;
        let cursors = segments.iter().map(|segment| Cursor::new(&self.folder, segment, layouts));
        let mut merge = Merge::new(cursors.collect::<Result<_>>()?)?;
        let probes = without.unwrap_or_default().iter();
        let mut probes = probes
            .map(|visited| Probe::new(&self.folder, visited, layouts))
            .collect::<Result<Vec<Probe<'_>>>>()?;
        let last = layouts.len() as u64 - 1;
        let mut writer = Writer::new(&self.folder, number, last)?;
        let mut rows = 0_u64;
        'rows: while let Some(row) = merge.next()? {
            rows += 1;
            if rows.is_multiple_of(PERIOD) && (self.task.stop)() {
                return Err(self.stopped());
            }
            for probe in &mut probes {
                if probe.contains(row)? {
                    continue 'rows;
                }
            }
            writer.push(row)?;
        }
        if writer.rows() == 0 {
            return Ok(None);
        }
        let (segment, index) = writer.finish()?;
        Ok(Some(Visited { segment, index }))
    }

    /// Makes the next layer of what the last one leads to.
    fn close_layer(&mut self) -> Result<()> {
        self.flush()?;
        let runs = self.standing.runs.clone();
        let visited = std::mem::take(&mut self.visited);
        let layer = self.merge(&runs, Some(&visited));
        self.visited = visited;
        let layer = self.or_checkpoint(layer)?;
        self.replace_runs(None);
        match layer {
            None => self.standing.finished = true,
            Some(layer) => {
                self.standing.layers.push(layer.segment);
                self.visited.push(layer);
                self.standing.done = 0;
                self.remember_more();
                let compacted = self.compact();
                self.or_checkpoint(compacted)?;
            }
        }
        Ok(())
    }

    /// As many rows are remembered as there are states, as far as memory allows.
    fn remember_more(&mut self) {
        let (words, states) = (self.tables.words(), self.standing.states() as usize);
        if 2 * self.recent.rows() <= self.task.budget.recent(words).min(states) {
            self.recent = Recent::new(words, self.task.budget.recent(words).min(2 * states));
        }
    }

    /// Files at least double in length from the last to the first, so there are few.
    fn compact(&mut self) -> Result<()> {
        while let [.., before, last] = self.visited.as_slice()
            && before.segment.rows < 2 * last.segment.rows
        {
            let both = [before.segment, last.segment];
            let merged = self.merge(&both, None)?;
            self.visited.truncate(self.visited.len() - 2);
            self.visited.extend(merged);
            both.iter().filter(|one| !self.is_layer(one)).for_each(|segment| self.retire(segment));
        }
        Ok(())
    }

    /// Layers are written one after the other.
    fn is_layer(&self, segment: &Segment) -> bool {
        self.standing.layers.binary_search_by_key(&segment.number, |layer| layer.number).is_ok()
    }

    /// If somebody asked to stop, so that it can be gone on from here.
    fn or_checkpoint<T>(&mut self, result: Result<T>) -> Result<T> {
        if let Err(ExternalError::Stopped(_)) = result {
            self.checkpoint()?;
        }
        result
    }

    /// Whether to go on.
    fn check(&mut self) -> Result<()> {
        if (self.task.stop)() {
            self.checkpoint()?;
            return Err(self.stopped());
        }
        if self.memory() > self.limits.memory {
            self.checkpoint()?;
            return Err(self.limit("memory", self.limits.memory));
        }
        Ok(())
    }

    fn checkpoint(&mut self) -> Result<()> {
        self.flush()?;
        self.since = 0;
        self.standing.visited = self.visited.iter().map(|visited| visited.segment).collect();
        let named = self.standing.files();
        let fresh: Vec<u64> = named.difference(&self.named).copied().collect();
        self.folder.write_checkpoint(&encode(self.task.origin, &self.standing, &self.tables), &fresh)?;
        let before = std::mem::replace(&mut self.named, named);
        before.difference(&self.named).for_each(|&file| self.folder.remove(file));
        Ok(())
    }

    /// A file that is not needed any more, unless to go on from the last checkpoint.
    fn retire(&self, segment: &Segment) {
        if !self.named.contains(&segment.number) {
            self.folder.remove(segment.number);
        }
    }

    fn next_file(&mut self) -> u64 {
        self.standing.next_file += 1;
        self.standing.next_file - 1
    }

    fn writer(&mut self) -> Result<Writer<'_>> {
        let number = self.next_file();
        let layout = self.tables.layouts.len() as u64 - 1;
        Writer::new(&self.folder, number, layout)
    }

    pub(super) fn memory(&self) -> usize {
        self.tables.memory()
            + self.recent.memory()
            + self.candidates.capacity() * size_of::<u64>()
            + self.visited.iter().map(|visited| visited.index.memory()).sum::<usize>()
            + self.blocks.iter().chain([&self.learned]).map(Block::memory).sum::<usize>()
    }

    fn explored(&self) -> u64 {
        self.standing.counts.system + self.standing.counts.environment
    }

    fn stopped(&self) -> ExternalError {
        ExternalError::Stopped(Progress {
            states: self.standing.states(),
            explored: self.explored(),
            transitions: self.standing.counts.transitions,
            layers: self.standing.layers.len() - 1,
        })
    }

    fn limit(&self, what: &'static str, limit: usize) -> ExternalError {
        ExternalError::Explore(ExploreError::Limit(LimitReached {
            what,
            limit,
            states: self.standing.states() as usize,
            explored: self.explored() as usize,
            edges: self.standing.counts.transitions as usize,
            memory: self.memory(),
        }))
    }

    /// A mistake in the moves of a row of the last layer, with a shortest play to it.
    fn mistake(&mut self, row: Vec<u64>, (event, error): Mistake) -> ExternalError {
        match self.play_to(row) {
            Ok(mut play) => {
                play.extend(event.map(|event| self.text(event)));
                ExternalError::Explore(ExploreError::Play(error, play))
            }
            Err(error) => error,
        }
    }

    fn text(&self, label: u32) -> String {
        self.tables.playout.text((label != YIELD).then_some(label)).to_owned()
    }

    /// Looks for a row's predecessors, layer by layer.
    fn play_to(&mut self, mut row: Vec<u64>) -> Result<Vec<String>> {
        let mut play = Vec::new();
        let mut moves = PackedMoves::default();
        let before = self.standing.layers.len() - 1;
        for layer in (0..before).rev() {
            let layer = self.standing.layers[layer];
            let mut cursor = Cursor::new(&self.folder, &layer, &self.tables.layouts)?;
            while cursor.advance()? {
                // Its moves have been found before, so nothing can be wrong or too narrow.
                let found = self.tables.settle(cursor.row(), &mut Vec::new(), &mut moves);
                if found.is_err() {
                    continue;
                }
                let edge = moves.edges().iter().find(|edge| edge.end.is_none() && moves.target(edge) == row);
                if let Some(edge) = edge {
                    play.push(self.text(edge.event));
                    row = cursor.row().to_vec();
                    break;
                }
            }
        }
        play.reverse();
        Ok(play)
    }

    /// Keys of a kind that are open somewhere.
    pub(super) fn open_keys(&self, kind: crate::model::Kind) -> usize {
        let Tables { playout, .. } = &self.tables;
        let is_open = |key: KeyId| {
            let word = self.standing.counts.open.get(key as usize / 64);
            word.is_some_and(|word| word >> (key % 64) & 1 != 0)
        };
        let spec = playout.spec();
        let keys = (0..playout.key_count() as KeyId).filter(|&key| is_open(key));
        keys.filter(|&key| spec.scenarios[playout.key(key).scenario].kind == kind).count()
    }

    /// Words of a row, and bytes on disk.
    pub(super) fn size(&self) -> (usize, u64) {
        let layers = self.standing.layers.iter();
        let others = self.visited.iter().map(|visited| &visited.segment);
        let others = others.filter(|one| !self.is_layer(one));
        (self.tables.words(), layers.chain(others).map(|segment| segment.bytes).sum())
    }
}
