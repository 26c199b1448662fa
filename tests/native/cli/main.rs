//! Tests of the `c2warp` command. They run the real binary on scenes with generated pictures.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod animate;
mod bake;
mod bombs;
mod carried;
mod check;
mod command;
mod drawings;
mod errors;
mod export;
mod fit;
mod help;
mod inspect;
mod manual;
mod maps;
mod new;
mod outputs;
mod scene_folder;
mod shapes;
mod stmap;
mod streams;
mod tables;
mod warp;
mod weights;
