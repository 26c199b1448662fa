//! Numbers as text that reads back to the same bits.

/// The shortest such text, with an exponent only for very large and very small numbers.
pub(crate) fn text(number: f64) -> String {
    if number == 0.0 || (1e-5..1e16).contains(&number.abs()) { number.to_string() } else { format!("{number:e}") }
}

#[cfg(test)]
mod tests {
    use super::text;

    #[test]
    fn reads_back_to_the_last_bit() {
        for number in [0.0, -0.0, 1.0, 0.1 + 0.2, 1.0 / 3.0, 1e-5, 9.9e-6, -5e-324, 1e16, f64::MAX, 123_456_789.125] {
            assert_eq!(text(number).parse::<f64>().unwrap().to_bits(), number.to_bits(), "{number:e}");
        }
    }

    #[test]
    fn is_short() {
        assert_eq!(text(128.0), "128");
        assert_eq!(text(-1e-17), "-1e-17");
    }
}
