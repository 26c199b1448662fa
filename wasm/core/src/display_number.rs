//! Numbers in messages.

use std::fmt;

/// Formats a number for a message. It uses an exponent if it would otherwise contain many zeros.
pub(crate) struct DisplayNumber(pub(crate) f64);

impl fmt::Display for DisplayNumber {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(number) = self;
        if *number == 0.0 || (1e-6..1e15).contains(&number.abs()) {
            write!(f, "{number}")
        } else {
            write!(f, "{number:e}")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::DisplayNumber;

    #[test]
    fn numbers_with_many_zeros_have_an_exponent() {
        let text = |number| DisplayNumber(number).to_string();
        assert_eq!([0.0, -2.5, 1e-6, 123_456.0].map(text), ["0", "-2.5", "0.000001", "123456"]);
        assert_eq!([1e300, -2e15, 1e-300, f64::NAN].map(text), ["1e300", "-2e15", "1e-300", "NaN"]);
        assert_eq!(text(f64::INFINITY), "inf");
    }
}
