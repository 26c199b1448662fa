//! Numbers in text files, rounded to a number of decimals.

use serde_json::Value;

/// Decimals of positions and lengths in pixels.
pub(crate) const PLACE: i32 = 4;
/// Decimals of weights, texture coordinates and matrices.
pub(crate) const SHARE: i32 = 7;
/// Decimals of angles in degrees.
pub(crate) const DEGREE: i32 = 5;
/// Decimals of scales, and of times in seconds.
pub(crate) const SCALE: i32 = 6;

/// The rounded number, never negative zero.
pub(crate) fn rounded(number: f64, decimals: i32) -> f64 {
    let steps = 10_f64.powi(decimals);
    (number * steps).round() / steps + 0.0
}

/// The rounded number in JSON, without a decimal point if it is whole.
pub(crate) fn json(number: f64, decimals: i32) -> Value {
    let number = rounded(number, decimals);
    if number.fract() == 0.0 && number.abs() < 1e15 { Value::from(number as i64) } else { Value::from(number) }
}

/// Rounds weights so that they sum to 1: the greatest takes the remainder.
pub(crate) fn shares(row: impl Iterator<Item = (usize, f64)>) -> Vec<(usize, f64)> {
    let mut row: Vec<(usize, f64)> = row.map(|(bone, weight)| (bone, rounded(weight, SHARE))).collect();
    let sum: f64 = row.iter().map(|one| one.1).sum();
    if let Some(greatest) = row.iter_mut().reduce(|a, b| if b.1 > a.1 { b } else { a }) {
        greatest.1 = rounded(greatest.1 + 1.0 - sum, SHARE);
    }
    row.retain(|one| one.1 > 0.0);
    row
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_weights_sum_to_one() {
        assert_eq!(json(2.000_000_04, SCALE).to_string(), "2");
        assert_eq!(json(-0.000_001, PLACE).to_string(), "0");
        assert_eq!(json(1.0 / 3.0, PLACE).to_string(), "0.3333");
        let row = shares([(1, 1.0 / 3.0), (4, 1.0 / 3.0), (5, 1.0 / 3.0), (9, 1e-9)].into_iter());
        assert_eq!(row.len(), 3);
        assert!((row.iter().map(|one| one.1).sum::<f64>() - 1.0).abs() < 1e-12);
    }
}
