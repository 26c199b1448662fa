//! The entry point of the benchmark in a page.

use wasm_bindgen::prelude::*;

use crate::{clock::page_ms, suite::Suite};

/// Runs all cases, which takes minutes, and returns the [`Timings`](crate::results::Timings) as JSON.
///
/// # Errors
/// If a case cannot be solved.
#[wasm_bindgen]
pub fn run() -> Result<String, JsError> {
    let timings = Suite::full(page_ms).timings(|_| {})?;
    Ok(serde_json::to_string(&timings)?)
}
