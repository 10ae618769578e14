//! The command as its users meet it: arguments in, streams, files and exit code out.

mod exits;
mod figures;
mod files;
mod graph;
mod play;
mod products;
mod stimulus;
mod support;
mod warnings;
