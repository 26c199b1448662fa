//! The `c2warp` command as people run it: the real binary, on scenes whose pictures are drawn by formulas.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod command;
mod inspect;
mod refusals;
mod stmap;
mod streams;
mod tables;
mod warp;
mod workplace;
