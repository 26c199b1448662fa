//! Hostile input for c2warp.
//!
//! Each module attacks one kind of input: `attack` takes any bytes, and panics if c2warp breaks a promise. `fuzz/` runs
//! the modules under libFuzzer, which looks for bytes that reach new code. `tests/corpus` runs them on the corpora
//! and on mutations of these with a fixed seed.

pub mod alpha;
pub mod drawings;
pub mod handles;
pub mod pictures;
pub mod project;
pub mod rings;

mod promises;
mod shapes;

/// An attack by any bytes.
pub type Attack = fn(&[u8]);

/// The attacks by the names of their corpora and fuzz targets.
pub const ATTACKS: [(&str, Attack); 6] = [
    ("project", project::attack),
    ("rings", rings::attack),
    ("alpha", alpha::attack),
    ("handles", handles::attack),
    ("pictures", pictures::attack),
    ("drawings", drawings::attack),
];
