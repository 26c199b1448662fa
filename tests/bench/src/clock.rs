//! Clocks for the native program and the page.

use std::{sync::LazyLock, time::Instant};

use wasm_bindgen::prelude::*;

/// A monotonic clock. Returns the milliseconds since a fixed moment.
pub type Clock = fn() -> f64;

/// The clock of a native program.
#[must_use]
pub fn native_ms() -> f64 {
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    START.elapsed().as_secs_f64() * 1e3
}

#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(js_namespace = performance, js_name = now)]
    fn performance_now() -> f64;
}

/// The clock of a page. Its resolution is 5 µs in a cross-origin isolated page, otherwise 100 µs.
#[must_use]
pub fn page_ms() -> f64 {
    performance_now()
}
