//! Time, from wherever the benchmark runs.

use std::{sync::LazyLock, time::Instant};

use wasm_bindgen::prelude::*;

/// Milliseconds since some moment that does not change; never goes back.
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

/// The clock of a page. In steps of 5 µs where the page is isolated from others, else of 100 µs.
#[must_use]
pub fn page_ms() -> f64 {
    performance_now()
}
