#![no_std]
//! Runtime.
