//! Numbers as multiples of powers of two.

/// The nearest multiple of 2⁻ᵇⁱᵗˢ; `None` beyond 32 bits.
pub(super) fn round(number: f64, bits: u8) -> Option<i32> {
    let steps = (number * f64::from(1_u32 << bits)).round();
    // NaN fails, too.
    (steps.abs() < f64::from(i32::MAX)).then_some(steps as i32)
}

/// The number of a multiple of 2⁻ᵇⁱᵗˢ.
pub(super) fn value(steps: i32, bits: u8) -> f64 {
    f64::from(steps) / f64::from(1_u32 << bits)
}
