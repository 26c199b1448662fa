//! Coverage: how many sites move each vertex.

use crate::weight::SparseWeights;

/// The number of sites that move each point.
pub(super) fn coverage(weights: &SparseWeights) -> impl Iterator<Item = u32> + '_ {
    weights.offsets().windows(2).map(|row| row[1] - row[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coverage_counts_the_entries_of_each_row() {
        let mut weights = SparseWeights::with_capacity(3);
        for count in [1, 0, 5] {
            weights.push_row((0..count).map(|site| (site, 1.0)));
        }
        assert_eq!(coverage(&weights).collect::<Vec<_>>(), [1, 0, 5]);
    }
}
