//! Results of synthesis, kept for the next build or the next key in an editor.
//!
//! A [`Key`] holds everything that a result depends on: the texts themselves, all options, and which tool it was. A
//! [`Store`] maps it to texts, and may lose them at any time: whoever asks must be able to make them. Keys are compared
//! as a whole, so two inputs never share a result, whatever their hashes.
//!
//! There are two stores. [`Folder`] is for build scripts, and for compilers on demand: a file an entry, written aside and
//! renamed, so that any number of processes may read and write without a lock. What is not whole when it is read does not
//! count, and what cannot be written is not kept; a cache never fails a build. [`Recent`] holds the last few results in
//! memory, for a process that lives long: rust-analyzer expands a macro at every key.
//!
//! Only what succeeded is kept. Mistakes name places, and are made to be mended.

mod entry;
mod folder;
mod key;
mod recent;

pub use folder::Folder;
pub use key::Key;
pub use recent::Recent;

/// The environment variable that names the [`Folder`] which build scripts and macros share. Empty, it turns the cache off.
pub const VARIABLE: &str = "SML_CACHE";

/// What remembers texts.
pub trait Store {
    /// The texts that were put there by this key, unless they are lost.
    fn get(&self, key: &Key) -> Option<Vec<String>>;

    /// Keeps texts, or does not.
    fn put(&self, key: &Key, texts: &[String]);
}

/// The hash that names entries and tells damaged ones: FNV-1a by words of eight bytes, the last one filled up with zeros, and the length.
/// Any change within one word changes it.
pub(crate) fn hash(bytes: &[u8]) -> u64 {
    let mut hash = 0xcbf2_9ce4_8422_2325_u64 ^ bytes.len() as u64;
    for word in bytes.chunks(8) {
        let mut filled = [0; 8];
        filled[..word.len()].copy_from_slice(word);
        hash = (hash ^ u64::from_le_bytes(filled)).wrapping_mul(0x0100_0000_01b3);
    }
    hash
}
