//! Numbers as text that parses back to the same bits.

/// Returns the shortest such text. Only very large and very small numbers have an exponent.
#[must_use]
pub fn decimal(number: f64) -> String {
    if number == 0.0 || (1e-5..1e16).contains(&number.abs()) { number.to_string() } else { format!("{number:e}") }
}

#[cfg(test)]
mod tests {
    use super::decimal;

    #[test]
    fn parses_back_to_the_same_bits() {
        for number in [0.0, -0.0, 1.0, 0.1 + 0.2, 1.0 / 3.0, 1e-5, 9.9e-6, -5e-324, 1e16, f64::MAX, 123_456_789.125] {
            assert_eq!(decimal(number).parse::<f64>().unwrap().to_bits(), number.to_bits(), "{number:e}");
        }
    }

    #[test]
    fn text_is_short() {
        assert_eq!(decimal(128.0), "128");
        assert_eq!(decimal(-1e-17), "-1e-17");
    }
}
