//! Minimum and maximum of two numbers for inner loops.
//!
//! In WebAssembly, `f64::min` and `f64::max` are function calls, because they return the other number if one is NaN.
//! They took 6 % of a solve of 600 samples.

/// The minimum of two numbers, or `a` if either is NaN.
pub(crate) fn fast_min(a: f64, b: f64) -> f64 {
    if b < a { b } else { a }
}

/// The maximum of two numbers, or `a` if either is NaN.
pub(crate) fn fast_max(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}
