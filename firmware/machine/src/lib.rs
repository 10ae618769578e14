//! One of the machines that are compared: `cargo xtask compare` writes it and names its file. Each has the same
//! interface, `new`, `event` and `step`.
#![no_std]

include!(env!("MACHINE", "`cargo xtask compare` names the file"));
