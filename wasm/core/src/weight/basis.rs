//! φ: the basis function, a Bézier polynomial (section V-A, eq. 5).
//!
//! φ(0) = 1, φ(t) = 0 for t ≥ 1, and φ decreases in between. Its first and second derivatives vanish at both ends, so
//! that weights are C². It is evaluated as `(1 − t)³` times a sum of non-negative terms, so it is positive for every t
//! < 1.
//!
//! Cost: O(n) for degree n.

use crate::project::Filling;

/// The basis function of one degree and filling.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Basis {
    /// `b_i · C(n, i)` for i from 0 to n − 3. The last three control values are 0.
    value: Vec<f64>,
    /// `−n (b_{i+1} − b_i) · C(n − 1, i)` for i from 2 to n − 3. The other differences are 0.
    slope: Vec<f64>,
}

impl Basis {
    /// The basis of degree `n`. `filling` sets the control values between the three at 1 and the three at 0.
    ///
    /// # Panics
    /// If the degree is below 5: the conditions on φ need six control values.
    pub(crate) fn new(degree: u32, filling: Filling) -> Self {
        assert!(degree >= 5, "the conditions on φ need six control values");
        let n = degree as usize;
        let control = |i: usize| match (i, filling) {
            (0..=2, _) => 1.0,
            (i, _) if i + 2 >= n => 0.0,
            (_, Filling::Half) => 0.5,
            (i, Filling::Line) => 1.0 - (i - 2) as f64 / (n - 4) as f64,
        };
        let value = (0..=n - 3).map(|i| control(i) * binomial(n, i)).collect();
        let slope = (2..=n - 3).map(|i| n as f64 * (control(i) - control(i + 1)) * binomial(n - 1, i)).collect();
        Self { value, slope }
    }

    /// φ(t) for t ≥ 0.
    pub(crate) fn value(&self, t: f64) -> f64 {
        if t >= 1.0 {
            return 0.0;
        }
        let u = 1.0 - t;
        u * u * u * homogeneous(&self.value, t, u)
    }

    /// Replaces each t by φ(t), for t from 0 to 1. Returns the same bits as [`value`](Self::value).
    pub(crate) fn values(&self, ts: &mut [f64]) {
        // Degree 5, the default, has three coefficients.
        if let [a, b, c] = self.value[..] {
            for t in ts {
                let u = 1.0 - *t;
                let power = *t * *t;
                *t = u * u * u * ((a * u + b * *t) * u + c * power);
            }
        } else {
            ts.iter_mut().for_each(|t| *t = self.value(*t));
        }
    }

    /// φ′(t) for t ≥ 0.
    pub(crate) fn derivative(&self, t: f64) -> f64 {
        if t >= 1.0 {
            return 0.0;
        }
        let u = 1.0 - t;
        -(t * t) * (u * u) * homogeneous(&self.slope, t, u)
    }
}

/// Σ c_i tⁱ uᵐ⁻ⁱ for i from 0 to m.
fn homogeneous(c: &[f64], t: f64, u: f64) -> f64 {
    let (first, others) = c.split_first().expect("a basis has coefficients");
    let (mut sum, mut power) = (*first, 1.0);
    for c in others {
        power *= t;
        sum = sum * u + c * power;
    }
    sum
}

fn binomial(n: usize, k: usize) -> f64 {
    (1..=k).fold(1.0, |product, i| product * (n + 1 - i) as f64 / i as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bases() -> impl Iterator<Item = Basis> {
        (5..=12).flat_map(|n| [Filling::Line, Filling::Half].map(|filling| Basis::new(n, filling)))
    }

    #[test]
    fn degree_five_is_the_quintic() {
        let basis = Basis::new(5, Filling::Line);
        for t in [0.0, 0.1, 0.5, 0.9] {
            let u: f64 = 1.0 - t;
            let quintic = u.powi(5) + 5.0 * t * u.powi(4) + 10.0 * t * t * u.powi(3);
            assert!((basis.value(t) - quintic).abs() < 1e-15);
        }
    }

    #[test]
    fn meets_the_criteria_of_section_iii_b() {
        for basis in bases() {
            assert_eq!(basis.value(0.0), 1.0);
            assert_eq!(basis.value(1.0), 0.0);
            assert_eq!(basis.derivative(0.0), 0.0);
            let h = 1e-4;
            for i in 1..1000 {
                let t = f64::from(i) / 1000.0;
                assert!(basis.derivative(t) < 0.0);
                let slope = (basis.value(t + h) - basis.value(t - h)) / (2.0 * h);
                // The error of central differences is h² times a third derivative of at most some thousands.
                assert!((basis.derivative(t) - slope).abs() < 1e-4);
            }
            // φ″ vanishes at both ends, so φ′ is of second order there.
            for t in [1e-4, 1.0 - 1e-4] {
                assert!(basis.derivative(t).abs() < 1e-5);
            }
        }
    }

    #[test]
    fn is_positive_just_below_1() {
        for basis in bases() {
            assert!(basis.value(1.0 - f64::EPSILON) > 0.0);
        }
    }
}
