//! Exports for JavaScript: a separate module with a solver, which a page loads at the first export that needs it.
//!
//! It runs in a worker that ends with the export, so cancelling needs no support here. Each export has its own file.

pub mod bake;
pub mod drawing;
pub mod engine;
pub mod maps;
mod solution;
pub mod solved;
