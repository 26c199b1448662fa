//! Exports for JavaScript: a module of its own with a solver, which a page loads at the first export that needs it.
//!
//! It lives in a worker that ends with the export. So a cancel needs no pause in it. One file an export.

pub mod bake;
pub mod drawing;
pub mod engine;
pub mod maps;
mod solution;
pub mod solved;
