//! Whether a part of the picture lies in front of the parts that it crosses, by the depths of the handles.
//!
//! Cost: the sites over each triangle of the crossings.

use super::crossings::Crossing;
use crate::weight::SparseWeights;

/// The selected handles move one part of a crossing if its mean share of their motion exceeds that of the other part by
/// this. Crossings are ignored if both parts follow the selected handles, or neither does.
const SHARE: f64 = 0.25;
/// Mean depths that differ by less than this are equal. Edits change depths by at least a hundredth.
const SAME_DEPTH: f64 = 1e-4;

/// The order of a part relative to the foremost of the parts that it crosses.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Lead {
    /// Behind at least one of them.
    Behind,
    /// As deep as at least one of them, and not behind any.
    Level,
    /// In front of all of them, also if it crosses nothing.
    Front,
}

/// `depths` and `shares` have one entry per site. A share is 1 for a site that moves as the selected handles do.
pub(super) fn lead(
    triangles: &[[u32; 3]],
    weights: &SparseWeights,
    crossings: &[Crossing],
    depths: &[f64],
    shares: &[f64],
) -> Lead {
    let mean = |values: &[f64], t: u32| {
        let at = |vertex: u32| weights.row(vertex as usize).map(|(site, weight)| weight * values[site]).sum::<f64>();
        triangles[t as usize].into_iter().map(at).sum::<f64>() / 3.0
    };
    let of_crossing = |Crossing { pairs, .. }: &Crossing| {
        let difference = |values: &[f64]| {
            pairs.iter().map(|&[a, b]| mean(values, a) - mean(values, b)).sum::<f64>() / pairs.len() as f64
        };
        let share = difference(shares);
        (share.abs() >= SHARE).then(|| match difference(depths) * share.signum() {
            ahead if ahead > SAME_DEPTH => Lead::Front,
            ahead if ahead < -SAME_DEPTH => Lead::Behind,
            _ => Lead::Level,
        })
    };
    crossings.iter().filter_map(of_crossing).min().unwrap_or(Lead::Front)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_crossings_of_the_selected_parts_count() {
        // One site for each of three triangles.
        let triangles = [[0, 1, 2], [3, 4, 5], [6, 7, 8]];
        let mut weights = SparseWeights::with_capacity(9);
        for vertex in 0..9 {
            weights.push_row(std::iter::once((vertex / 3, 1.0)));
        }
        let crossing = |a, b| Crossing { pairs: vec![[a, b]], is_tangled: false };
        let of =
            |crossings: &[Crossing], depths: [f64; 3]| lead(&triangles, &weights, crossings, &depths, &[1.0, 0.0, 0.0]);
        let (first, swapped, other) = (crossing(0, 1), crossing(1, 0), crossing(1, 2));
        assert_eq!(of(&[], [0.0; 3]), Lead::Front);
        assert_eq!(of(std::slice::from_ref(&other), [0.0, 5.0, 1.0]), Lead::Front);
        for own in [first, swapped] {
            let all = [other.clone(), own];
            assert_eq!(of(&all, [1.0, 0.0, 7.0]), Lead::Front);
            assert_eq!(of(&all, [1.0, 1.0, 0.0]), Lead::Level);
            assert_eq!(of(&all, [1.0, 2.0, 0.0]), Lead::Behind);
        }
    }
}
