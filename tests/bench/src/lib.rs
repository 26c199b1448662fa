//! What solving costs, natively and in WebAssembly: `npm run bench`.
//!
//! The same cases run in a native program and in a page, and print their times as the paper's Tables I and II do, with
//! the paper's figures beside them. What the program promises of its speed is said in ratios within one run, which hold on
//! any machine: [`bars`] lists them, and whether they are met. The yardstick is a *pass*: one distance field without a bound,
//! asked at every sample.

pub mod aligned;
pub mod bars;
pub mod cases;
pub mod clock;
pub mod drawing;
pub mod measure;
pub mod results;
pub mod suite;
pub mod tables;
pub mod web;
