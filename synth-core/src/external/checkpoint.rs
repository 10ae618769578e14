//! Where an exploration stands, as bytes: which one it is, what was counted and learned, and which files it has.

use super::bytes::{Source, put_numbers, put_text};
use super::counts::Counts;
use super::segment::Segment;
use super::tables::Tables;
use crate::cache::hash;
use crate::playout::Semantics;
use crate::syntax::{FileId, Sources};
use std::collections::BTreeSet;

/// Another number here and the files of before are of another version.
const MAGIC: &[u8] = b"sml exploration 1\n";

/// Which exploration it is. Parts are compared, not hashed, so that the one that differs can be told.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Origin {
    tool: String,
    options: String,
    texts: String,
}

impl Origin {
    /// The exploration of these texts by this tool.
    #[must_use]
    pub fn new(sources: &Sources, semantics: Semantics) -> Origin {
        let files = (0..sources.len() as u32).map(FileId);
        Origin {
            tool: format!("{} {}", env!("CARGO_PKG_VERSION"), env!("SYNTH_CORE_FINGERPRINT")),
            options: format!("{semantics:?}"),
            texts: files.map(|file| sources.text(file)).collect::<Vec<_>>().join("\0"),
        }
    }

    fn write(&self, out: &mut Vec<u8>) {
        [&self.tool, &self.options, &self.texts].into_iter().for_each(|text| put_text(out, text));
    }

    /// What the one that is read differs in.
    fn differs(&self, source: &mut Source<'_>) -> Option<Option<&'static str>> {
        let (tool, options, texts) = (source.text()?, source.text()?, source.text()?);
        Some(match () {
            () if texts != self.texts => Some("another specification"),
            () if options != self.options => Some("other options"),
            () if tool != self.tool => Some("another version of the tool"),
            () => None,
        })
    }
}

/// Where it stands.
#[derive(Clone, Debug, Default)]
pub(super) struct Standing {
    pub(super) counts: Counts,
    /// The states by their distance from the initial one; the moves of the last layer are looked for.
    pub(super) layers: Vec<Segment>,
    /// So many states of the last layer are explored.
    pub(super) done: u64,
    /// The same states in fewer files.
    pub(super) visited: Vec<Segment>,
    /// What the last layer leads to, so far.
    pub(super) runs: Vec<Segment>,
    /// The last layer leads to nothing new.
    pub(super) finished: bool,
    /// The number of the next file.
    pub(super) next_file: u64,
}

impl Standing {
    /// The numbers of all files.
    pub(super) fn files(&self) -> BTreeSet<u64> {
        self.segments().into_iter().flatten().map(|segment| segment.number).collect()
    }

    pub(super) fn segments(&self) -> [&[Segment]; 3] {
        [&self.layers, &self.visited, &self.runs]
    }

    /// States found.
    pub(super) fn states(&self) -> u64 {
        self.layers.iter().map(|layer| layer.rows).sum::<u64>()
            + u64::from(self.counts.lost)
            + u64::from(self.counts.won)
    }

    fn write(&self, out: &mut Vec<u8>) {
        let Counts { transitions, system, environment, yielded, idle, lost, won, open } = &self.counts;
        put_numbers(out, &[*transitions, *system, *environment, *yielded, *idle]);
        put_numbers(out, &[u64::from(*lost), u64::from(*won)]);
        put_numbers(out, &[self.done, u64::from(self.finished), self.next_file]);
        put_numbers(out, &[open.len() as u64]);
        put_numbers(out, open);
        for list in self.segments() {
            put_numbers(out, &[list.len() as u64]);
            for segment in list {
                put_numbers(out, &[segment.number, segment.layout, segment.rows, segment.bytes]);
            }
        }
    }

    fn read(source: &mut Source<'_>) -> Option<Standing> {
        let mut standing = Standing::default();
        let counts = &mut standing.counts;
        counts.transitions = source.number()?;
        counts.system = source.number()?;
        counts.environment = source.number()?;
        counts.yielded = source.number()?;
        counts.idle = source.number()?;
        counts.lost = source.number()? != 0;
        counts.won = source.number()? != 0;
        standing.done = source.number()?;
        standing.finished = source.number()? != 0;
        standing.next_file = source.number()?;
        for _ in 0..source.number()? {
            standing.counts.open.push(source.number()?);
        }
        for list in [&mut standing.layers, &mut standing.visited, &mut standing.runs] {
            for _ in 0..source.number()? {
                let (number, layout) = (source.number()?, source.number()?);
                let (rows, bytes) = (source.number()?, source.number()?);
                list.push(Segment { number, layout, rows, bytes });
            }
        }
        Some(standing)
    }
}

pub(super) fn encode(origin: &Origin, standing: &Standing, tables: &Tables<'_, '_>) -> Vec<u8> {
    let mut rest = Vec::new();
    origin.write(&mut rest);
    standing.write(&mut rest);
    tables.write(&mut rest);
    [MAGIC, &hash(&rest).to_le_bytes(), &rest].concat()
}

/// Why a checkpoint cannot be gone on from.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Unusable {
    Damaged,
    Other(&'static str),
}

/// Where it stands; tables that know nothing yet learn what was known.
pub(super) fn decode(
    bytes: &[u8],
    origin: &Origin,
    tables: &mut Tables<'_, '_>,
) -> Result<Standing, Unusable> {
    let sum_and_rest = bytes.strip_prefix(MAGIC).and_then(|rest| rest.split_first_chunk());
    let (sum, rest) = sum_and_rest.ok_or(Unusable::Damaged)?;
    if u64::from_le_bytes(*sum) != hash(rest) {
        return Err(Unusable::Damaged);
    }
    let mut source = Source(rest);
    if let Some(what) = origin.differs(&mut source).ok_or(Unusable::Damaged)? {
        return Err(Unusable::Other(what));
    }
    let standing = Standing::read(&mut source).ok_or(Unusable::Damaged)?;
    tables.read(&mut source).ok_or(Unusable::Damaged)?;
    let known = |segment: &Segment| (segment.layout as usize) < tables.layouts.len();
    let sound = standing.segments().into_iter().flatten().all(known) && !standing.layers.is_empty();
    if sound { Ok(standing) } else { Err(Unusable::Damaged) }
}
