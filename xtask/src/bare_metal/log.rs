//! Logs of defmt: bytes that the target writes, in words with the texts that the program's file has.

use crate::failure::{At, Failure, Result};
use defmt_decoder::{DecodeError, Table};
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

/// The messages, a line each.
pub(crate) fn decode(program: &Path, log: &[u8]) -> Result<String> {
    let file = fs::read(program).doing(format_args!("read `{}`", program.display()))?;
    let table = Table::parse(&file).doing("read the texts of the log")?;
    let table = table.ok_or_else(|| Failure::new("the program has no texts of a log"))?;
    let mut decoder = table.new_stream_decoder();
    decoder.received(log);
    let mut text = String::new();
    loop {
        match decoder.decode() {
            Ok(frame) => {
                let _ = writeln!(text, "{}", frame.display_message());
            }
            Err(DecodeError::UnexpectedEof) => return Ok(text),
            Err(DecodeError::Malformed) => {
                return Err(Failure::new(format!("the log cannot be read behind\n{text}")));
            }
        }
    }
}
