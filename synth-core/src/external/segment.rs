//! Files of ascending rows.
//!
//! A file is a sequence of blocks: the length of what follows the header, the number of rows and a hash (`u32`, `u32`, `u64`,
//! little end first); then the first row, and of each further row the difference to the one before as a base-128 number if
//! it lies in the first word alone, otherwise a zero byte and the row.

use super::error::{ExternalError, Result};
use super::folder::Folder;
use super::order::compare;
use crate::cache::hash;
use crate::successors::Layout;
use std::fs::{self, File};
use std::io::{self, BufReader, BufWriter, Read as _, Seek as _, SeekFrom, Write as _};
use std::path::PathBuf;

/// A block is closed when it has so many bytes.
const BLOCK: usize = 1 << 13;
const HEADER: usize = 16;

/// A file that is whole.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Segment {
    /// Its name in the folder.
    pub(super) number: u64,
    /// The layout of its rows, by the number of times that rows had been widened.
    pub(super) layout: u64,
    pub(super) rows: u64,
    pub(super) bytes: u64,
}

/// Where the blocks of a file begin, and with which rows.
#[derive(Clone, Debug, Default)]
pub(super) struct Index {
    pub(super) offsets: Vec<u64>,
    pub(super) firsts: Vec<u64>,
}

impl Index {
    pub(super) fn memory(&self) -> usize {
        (self.offsets.capacity() + self.firsts.capacity()) * size_of::<u64>()
    }
}

/// Writes a file; unless it is finished, nothing is left of it.
#[derive(Debug)]
pub(super) struct Writer<'f> {
    folder: &'f Folder,
    path: PathBuf,
    file: BufWriter<File>,
    segment: Segment,
    index: Index,
    block: Vec<u8>,
    in_block: u32,
    last: Vec<u64>,
    finished: bool,
}

impl<'f> Writer<'f> {
    pub(super) fn new(folder: &'f Folder, number: u64, layout: u64) -> Result<Self> {
        let path = folder.rows(number);
        let file = File::create(&path).map_err(|error| ExternalError::Write(path.clone(), error))?;
        Ok(Writer {
            folder,
            path,
            file: BufWriter::with_capacity(1 << 16, file),
            segment: Segment { number, layout, rows: 0, bytes: 0 },
            index: Index::default(),
            block: Vec::with_capacity(BLOCK + 64),
            in_block: 0,
            last: Vec::new(),
            finished: false,
        })
    }

    /// Appends a row, unless it is the last one once more. Rows must ascend.
    pub(super) fn push(&mut self, row: &[u64]) -> Result<()> {
        if self.last == row {
            return Ok(());
        }
        if self.in_block == 0 {
            self.index.offsets.push(self.segment.bytes);
            self.index.firsts.extend_from_slice(row);
            self.put_row(row);
        } else if row[1..] == self.last[1..] {
            self.put_number(row[0].wrapping_sub(self.last[0]));
        } else {
            self.block.push(0);
            self.put_row(row);
        }
        debug_assert!(self.last.is_empty() || compare(&self.last, row).is_lt());
        self.last.clear();
        self.last.extend_from_slice(row);
        self.in_block += 1;
        self.segment.rows += 1;
        if self.block.len() >= BLOCK { self.close_block() } else { Ok(()) }
    }

    fn put_row(&mut self, row: &[u64]) {
        row.iter().for_each(|word| self.block.extend_from_slice(&word.to_le_bytes()));
    }

    fn put_number(&mut self, mut number: u64) {
        while number >= 0x80 {
            self.block.push(number as u8 | 0x80);
            number >>= 7;
        }
        self.block.push(number as u8);
    }

    fn close_block(&mut self) -> Result<()> {
        let mut header = [0; HEADER];
        header[..4].copy_from_slice(&(self.block.len() as u32).to_le_bytes());
        header[4..8].copy_from_slice(&self.in_block.to_le_bytes());
        header[8..].copy_from_slice(&hash(&self.block).to_le_bytes());
        let written = self.file.write_all(&header).and_then(|()| self.file.write_all(&self.block));
        written.map_err(|error| ExternalError::Write(self.path.clone(), error))?;
        self.segment.bytes += (HEADER + self.block.len()) as u64;
        self.block.clear();
        self.in_block = 0;
        Ok(())
    }

    /// The whole file. It may be in the system's memory yet.
    pub(super) fn finish(mut self) -> Result<(Segment, Index)> {
        if self.in_block > 0 {
            self.close_block()?;
        }
        self.file.flush().map_err(|error| ExternalError::Write(self.path.clone(), error))?;
        self.finished = true;
        Ok((self.segment, std::mem::take(&mut self.index)))
    }

    pub(super) fn rows(&self) -> u64 {
        self.segment.rows
    }
}

impl Drop for Writer<'_> {
    fn drop(&mut self) {
        if !self.finished {
            self.folder.remove(self.segment.number);
        }
    }
}

/// Reads the rows of a file, each in a layout that may be wider than theirs.
#[derive(Debug)]
pub(super) struct Cursor {
    path: PathBuf,
    file: BufReader<File>,
    bytes: u64,
    /// Where the next block begins.
    offset: u64,
    /// The block that is read, counted from 0; seeking says which.
    block_number: usize,
    block: Vec<u8>,
    at: usize,
    in_block: u32,
    words: usize,
    row: Vec<u64>,
    /// If the layout is another.
    conversion: Option<Box<(Layout, Layout, Vec<u64>)>>,
}

impl Cursor {
    /// Stands before the first row; rows are shown in the last layout.
    pub(super) fn new(folder: &Folder, segment: &Segment, layouts: &[Layout]) -> Result<Cursor> {
        let path = folder.rows(segment.number);
        let file = File::open(&path).map_err(|error| ExternalError::Read(path.clone(), error))?;
        let own = segment.layout as usize;
        let (from, to) = (&layouts[own], &layouts[layouts.len() - 1]);
        let is_old = own + 1 < layouts.len();
        let conversion = is_old.then(|| Box::new((from.clone(), to.clone(), vec![0; to.words()])));
        Ok(Cursor {
            path,
            file: BufReader::with_capacity(1 << 16, file),
            bytes: segment.bytes,
            offset: 0,
            block_number: usize::MAX,
            block: Vec::new(),
            at: 0,
            in_block: 0,
            words: from.words(),
            row: vec![0; from.words()],
            conversion,
        })
    }

    /// Goes to the next row; whether there is one.
    pub(super) fn advance(&mut self) -> Result<bool> {
        if self.in_block == 0 {
            if self.offset == self.bytes {
                return Ok(false);
            }
            self.read_block()?;
            self.take_row()?;
        } else {
            match self.take_number()? {
                0 => self.take_row()?,
                difference => self.row[0] = self.row[0].wrapping_add(difference),
            }
        }
        self.in_block -= 1;
        if let Some(conversion) = &mut self.conversion {
            let (from, to, row) = &mut **conversion;
            row.fill(0);
            to.convert(from, &self.row, row);
        }
        Ok(true)
    }

    /// The row at which it stands.
    #[inline]
    pub(super) fn row(&self) -> &[u64] {
        self.conversion.as_ref().map_or(&self.row, |conversion| &conversion.2)
    }

    /// The block in which it stands; none before the first row.
    pub(super) fn block(&self) -> Option<usize> {
        (self.block_number != usize::MAX).then_some(self.block_number)
    }

    /// Stands before the first row of a block.
    pub(super) fn seek(&mut self, block: usize, offset: u64) -> Result<()> {
        let distance = offset as i64 - self.offset as i64;
        self.file.seek_relative(distance).map_err(|error| ExternalError::Read(self.path.clone(), error))?;
        (self.offset, self.in_block) = (offset, 0);
        self.block_number = block.wrapping_sub(1);
        Ok(())
    }

    /// Passes over so many rows.
    pub(super) fn skip(&mut self, rows: u64) -> Result<()> {
        for _ in 0..rows {
            if !self.advance()? {
                return Err(self.damaged("it has fewer rows than the checkpoint says"));
            }
        }
        Ok(())
    }

    fn read_block(&mut self) -> Result<()> {
        let mut header = [0; HEADER];
        self.file.read_exact(&mut header).map_err(|error| self.unreadable(error))?;
        let (length, rows, sum) = split_header(&header);
        if length as u64 > self.bytes.saturating_sub(self.offset + HEADER as u64) || rows == 0 {
            return Err(self.damaged(&format!("no block begins at byte {}", self.offset)));
        }
        self.block.resize(length, 0);
        self.file.read_exact(&mut self.block).map_err(|error| unreadable(&self.path, error))?;
        if hash(&self.block) != sum {
            return Err(self.damaged(&format!("the block at byte {} is not what was written", self.offset)));
        }
        self.offset += (HEADER + length) as u64;
        self.block_number = self.block_number.wrapping_add(1);
        (self.at, self.in_block) = (0, rows);
        Ok(())
    }

    fn take_row(&mut self) -> Result<()> {
        for word in 0..self.words {
            let Some(bytes) = self.block.get(self.at..).and_then(|rest| rest.first_chunk()) else {
                return Err(self.damaged("a block ends within a row"));
            };
            self.row[word] = u64::from_le_bytes(*bytes);
            self.at += 8;
        }
        Ok(())
    }

    #[inline]
    fn take_number(&mut self) -> Result<u64> {
        let (mut number, mut shift) = (0, 0);
        loop {
            let Some(&byte) = self.block.get(self.at).filter(|_| shift < 64) else {
                return Err(self.damaged("a block ends within a row"));
            };
            self.at += 1;
            number |= u64::from(byte & 0x7F) << shift;
            if byte < 0x80 {
                return Ok(number);
            }
            shift += 7;
        }
    }

    fn damaged(&self, what: &str) -> ExternalError {
        ExternalError::Damaged(self.path.clone(), what.to_owned())
    }

    fn unreadable(&self, error: io::Error) -> ExternalError {
        unreadable(&self.path, error)
    }
}

fn split_header(header: &[u8; HEADER]) -> (usize, u32, u64) {
    let [a, b, c, d, e, f, g, h, sum @ ..] = *header;
    (u32::from_le_bytes([a, b, c, d]) as usize, u32::from_le_bytes([e, f, g, h]), u64::from_le_bytes(sum))
}

fn unreadable(path: &std::path::Path, error: io::Error) -> ExternalError {
    match error.kind() {
        io::ErrorKind::UnexpectedEof => {
            ExternalError::Damaged(path.to_owned(), "it is shorter than the checkpoint says".to_owned())
        }
        _ => ExternalError::Read(path.to_owned(), error),
    }
}

impl Segment {
    /// Whether the file has the length that it had when it was written.
    pub(super) fn check(&self, folder: &Folder) -> Result<()> {
        let path = folder.rows(self.number);
        let length = match fs::metadata(&path) {
            Ok(metadata) => metadata.len(),
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                return Err(ExternalError::Damaged(path, "it is missing".to_owned()));
            }
            Err(error) => return Err(ExternalError::Read(path, error)),
        };
        if length == self.bytes {
            return Ok(());
        }
        let what = format!("it has {length} bytes instead of {}", self.bytes);
        Err(ExternalError::Damaged(path, what))
    }

    /// Finds its blocks.
    pub(super) fn index(&self, folder: &Folder, words: usize) -> Result<Index> {
        let path = folder.rows(self.number);
        let read = |error| unreadable(&path, error);
        let mut file = BufReader::new(File::open(&path).map_err(read)?);
        let (mut index, mut offset, mut rows) = (Index::default(), 0, 0);
        while offset < self.bytes {
            let (mut header, mut word) = ([0; HEADER], [0; 8]);
            file.read_exact(&mut header).map_err(read)?;
            let (length, in_block, _) = split_header(&header);
            index.offsets.push(offset);
            for _ in 0..words {
                file.read_exact(&mut word).map_err(read)?;
                index.firsts.push(u64::from_le_bytes(word));
            }
            offset += (HEADER + length) as u64;
            rows += u64::from(in_block);
            file.seek(SeekFrom::Start(offset)).map_err(read)?;
        }
        if offset != self.bytes || rows != self.rows {
            return Err(ExternalError::Damaged(path, "its blocks do not add up".to_owned()));
        }
        Ok(index)
    }
}
