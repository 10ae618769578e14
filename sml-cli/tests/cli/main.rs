//! The command as its users meet it: arguments in, streams, files and exit code out.

mod counter_play;
mod exits;
mod figures;
mod files;
mod graph;
#[cfg(target_os = "linux")]
mod memory;
mod plants;
mod plants_exported;
mod plants_followed;
mod plants_modular;
mod plants_played;
mod play;
mod play_adversary;
mod play_dialog;
mod play_script;
mod products;
#[cfg(unix)]
mod spill;
mod stimulus;
mod support;
mod templates;
mod transcripts;
mod warnings;
