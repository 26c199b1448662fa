//! Numbers in sentences.

use std::fmt;

/// A number as it is written: in full, or with an exponent where that would be a row of zeros.
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
    fn no_number_is_a_row_of_zeros() {
        let written = |number| DisplayNumber(number).to_string();
        assert_eq!([0.0, -2.5, 1e-6, 123_456.0].map(written), ["0", "-2.5", "0.000001", "123456"]);
        assert_eq!([1e300, -2e15, 1e-300, f64::NAN].map(written), ["1e300", "-2e15", "1e-300", "NaN"]);
        assert_eq!(written(f64::INFINITY), "inf");
    }
}
