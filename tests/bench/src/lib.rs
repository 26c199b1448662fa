//! Benchmark of the solver, natively and in WebAssembly: `npm run bench`.
//!
//! The same cases run in a native program and in a page. The output has the form of the paper's Tables I and II, next
//! to the paper's values. [`requirements`] are mostly ratios within one run, so they hold on any machine. Their
//! baseline is a *pass*: one unbounded distance field, evaluated at every sample.

pub mod aligned;
pub mod cases;
pub mod clock;
pub mod drag;
pub mod growth;
pub mod limbs;
pub mod measure;
pub mod requirements;
pub mod results;
pub mod suite;
pub mod tables;
pub mod web;
