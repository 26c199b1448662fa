//! The benchmark for a page.

use wasm_bindgen::prelude::*;

use crate::{clock::page_ms, suite::Suite};

/// Runs every case; minutes may pass. Returns the [`Timings`](crate::results::Timings) as JSON.
///
/// # Errors
/// None, unless a scene cannot be solved any more.
#[wasm_bindgen]
pub fn run() -> Result<String, JsError> {
    let timings = Suite::full(page_ms).timings(|_| {})?;
    Ok(serde_json::to_string(&timings)?)
}
