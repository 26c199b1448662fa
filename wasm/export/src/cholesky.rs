//! A dense Cholesky factorisation: one matrix, many right-hand sides.
//!
//! Cost: n³/3 once, and 2 n² for each right-hand side.

/// The lower factor of a symmetric positive definite matrix.
#[derive(Debug, Clone)]
pub(crate) struct Cholesky {
    size: usize,
    /// Rows of the lower triangle, one after another.
    rows: Vec<f64>,
}

impl Cholesky {
    /// Factorises a matrix in full rows; only its lower triangle is read.
    pub(crate) fn new(size: usize, matrix: &[f64]) -> Self {
        let mut rows: Vec<f64> = Vec::with_capacity(size * (size + 1) / 2);
        for i in 0..size {
            for j in 0..=i {
                let (row, other) = (start(i), start(j));
                let dot: f64 = (0..j).map(|k| rows[row + k] * rows[other + k]).sum();
                let rest = matrix[i * size + j] - dot;
                // Rounding may leave nothing of a pivot that should be positive.
                rows.push(if i == j { rest.max(f64::MIN_POSITIVE).sqrt() } else { rest / rows[other + j] });
            }
        }
        Self { size, rows }
    }

    /// Solves for one right-hand side in place.
    pub(crate) fn solve(&self, x: &mut [f64]) {
        for i in 0..self.size {
            let row = &self.rows[start(i)..start(i + 1)];
            let dot: f64 = row[..i].iter().zip(&x[..i]).map(|(a, b)| a * b).sum();
            x[i] = (x[i] - dot) / row[i];
        }
        for i in (0..self.size).rev() {
            let row = &self.rows[start(i)..start(i + 1)];
            x[i] /= row[i];
            let value = x[i];
            x[..i].iter_mut().zip(&row[..i]).for_each(|(x, a)| *x -= a * value);
        }
    }
}

fn start(row: usize) -> usize {
    row * (row + 1) / 2
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solution_satisfies_the_equations() {
        let matrix = [4.0, 1.0, 0.5, 1.0, 3.0, -1.0, 0.5, -1.0, 2.0];
        let mut x = [1.0, 2.0, 3.0];
        Cholesky::new(3, &matrix).solve(&mut x);
        for (row, right) in matrix.chunks(3).zip([1.0, 2.0, 3.0]) {
            let left: f64 = row.iter().zip(&x).map(|(a, b)| a * b).sum();
            assert!((left - right).abs() < 1e-12);
        }
    }
}
