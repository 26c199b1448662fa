//! The lesser and the greater of two numbers, where many are compared.
//!
//! `f64::min` and `f64::max` are calls of functions in WebAssembly, as they pass over a number that is NaN wherever it stands:
//! 6 % of a solve of 600 samples.

/// The lesser of two numbers; the first where either is NaN.
pub(crate) fn fast_min(a: f64, b: f64) -> f64 {
    if b < a { b } else { a }
}

/// The greater of two numbers; the first where either is NaN.
pub(crate) fn fast_max(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}
