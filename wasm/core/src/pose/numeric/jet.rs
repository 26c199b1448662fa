//! A number that depends on another, with its first three derivatives.

use std::ops::{Add, Mul, Sub};

/// The jet of third order of a function of one variable, such as the energy along a line, or of several functions at
/// once.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Jet<T = f64> {
    pub(crate) value: T,
    pub(crate) first: T,
    pub(crate) second: T,
    pub(crate) third: T,
}

impl<T: Copy + Default + From<f64> + Add<Output = T> + Mul<Output = T>> Jet<T> {
    /// c₀ + c₁ t + c₂ t² at t.
    #[inline]
    pub(crate) fn of_polynomial([c0, c1, c2]: [T; 3], t: T) -> Self {
        Self { value: (c2 * t + c1) * t + c0, first: (c2 + c2) * t + c1, second: c2 + c2, third: T::default() }
    }

    /// Composes this function with `inner`, evaluated at its argument (chain rule).
    #[inline]
    pub(crate) fn of(&self, inner: &Self) -> Self {
        let Self { value, first, second, third } = *self;
        let (by, bend) = (inner.first, inner.second);
        Self {
            value,
            first: first * by,
            second: second * by * by + first * bend,
            third: third * by * by * by + T::from(3.0) * second * by * bend + first * inner.third,
        }
    }

    #[inline]
    pub(crate) fn map<U>(self, of: impl Fn(T) -> U) -> Jet<U> {
        Jet { value: of(self.value), first: of(self.first), second: of(self.second), third: of(self.third) }
    }
}

impl<T: Add<Output = T>> Add for Jet<T> {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            first: self.first + other.first,
            second: self.second + other.second,
            third: self.third + other.third,
        }
    }
}

impl<T: Sub<Output = T>> Sub<T> for Jet<T> {
    type Output = Self;

    #[inline]
    fn sub(self, constant: T) -> Self {
        Self { value: self.value - constant, ..self }
    }
}

/// Leibniz's rule.
impl<T: Copy + From<f64> + Add<Output = T> + Mul<Output = T>> Mul for Jet<T> {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            first: self.first * other.value + self.value * other.first,
            second: self.second * other.value + T::from(2.0) * self.first * other.first + self.value * other.second,
            third: self.third * other.value
                + T::from(3.0) * (self.second * other.first + self.first * other.second)
                + self.value * other.third,
        }
    }
}

#[cfg(test)]
impl Jet {
    /// Asserts that the derivatives of a function are the slopes of its value and of one another, within `tolerance`.
    pub(crate) fn assert_slopes(mut function: impl FnMut(f64) -> Self, at: f64, tolerance: f64) {
        let step = 1e-4;
        let [here, before, after] = [at, at - step, at + step].map(&mut function);
        for (found, [before, after]) in [
            (here.first, [before.value, after.value]),
            (here.second, [before.first, after.first]),
            (here.third, [before.second, after.second]),
        ] {
            let slope = (after - before) / (2.0 * step);
            assert!((slope - found).abs() < tolerance * (1.0 + slope.abs()), "{slope} and {found} at {at}");
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// t³ − 2t: at t.
    fn cubic(t: f64) -> Jet {
        Jet { value: t * t * t - 2.0 * t, first: 3.0 * t * t - 2.0, second: 6.0 * t, third: 6.0 }
    }

    /// Of a polynomial, from its coefficients.
    fn derivatives(coefficients: &[f64], t: f64) -> Jet {
        let derived = |c: &[f64]| -> Vec<f64> { (1..).zip(&c[1..]).map(|(power, c)| f64::from(power) * c).collect() };
        let at = |c: &[f64]| c.iter().rev().fold(0.0, |sum, c| sum * t + c);
        let first = derived(coefficients);
        let second = derived(&first);
        Jet { value: at(coefficients), first: at(&first), second: at(&second), third: at(&derived(&second)) }
    }

    fn assert_close(found: Jet, expected: Jet) {
        let Jet { value, first, second, third } = found + expected.map(|value| -value);
        assert!([value, first, second, third].iter().all(|off| off.abs() < 1e-12), "{found:?} is not {expected:?}");
    }

    #[test]
    fn products_and_chains_are_those_of_the_polynomials() {
        for t in [-1.2, 0.0, 0.7] {
            let square = Jet::of_polynomial([3.0, -1.0, 2.0], t);
            assert_close(square, derivatives(&[3.0, -1.0, 2.0], t));
            // (t³ − 2t) (3 − t + 2t²)
            assert_close(cubic(t) * square, derivatives(&[0.0, -6.0, 2.0, -1.0, -1.0, 2.0], t));
            // With t = 1 − s + s²/2 instead of t: expanded.
            let inner = Jet::of_polynomial([1.0, -1.0, 0.5], t);
            let expanded = [-1.0, -1.0, 3.5, -4.0, 2.25, -0.75, 0.125];
            assert_close(cubic(inner.value).of(&inner), derivatives(&expanded, t));
        }
    }
}
