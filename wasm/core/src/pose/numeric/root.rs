//! Roots of quadratic polynomials.

/// The least root of c + b t + a t² between 0 and `most`, or `most`; c is at least 0.
pub(in super::super) fn first_root(c: f64, b: f64, a: f64, most: f64) -> f64 {
    if b >= 0.0 && a >= 0.0 {
        return most;
    }
    let square = b * b - 4.0 * a * c;
    if square < 0.0 {
        return most;
    }
    let root = square.sqrt();
    // The roots are c / q and q / a. This form avoids cancellation.
    let q = -0.5 * if b >= 0.0 { b + root } else { b - root };
    [c / q, q / a].into_iter().filter(|root| *root >= 0.0).fold(most, f64::min)
}
