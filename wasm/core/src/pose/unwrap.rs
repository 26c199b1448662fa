//! Unwrapping of angles, so that neighbours differ by less than half a turn.
//!
//! A rotation determines its angle up to whole turns, but blends depend on the angles. Unwrapping chooses the smallest
//! difference between neighbours. A shape rolled up by three turns then unrolls by angles up to three turns, and a
//! shape rotated by half a turn has one angle everywhere.
//!
//! Unwrapping starts at the angles that the user set, or else at the smallest one. It follows the links with the
//! smallest differences first, so the order of sites does not matter. Each site takes the angle nearest to that of its
//! predecessor. Around a hole the last neighbours may still be a whole turn apart. Cost: linear in the links, plus a
//! heap of them if any angle must change.

use std::{
    collections::BinaryHeap,
    f64::consts::{PI, TAU},
};

use crate::{
    min_entry::MinEntry,
    rank::{ascending, sort_by_rank},
};

/// Shifts the free angles by whole turns.
pub(super) fn unwrap_angles(angles: &mut [f64], is_free: &[bool], links: impl Iterator<Item = (usize, usize)> + Clone) {
    if links.clone().all(|(i, j)| (angles[i] - angles[j]).abs() < PI) {
        return;
    }
    let mut unwrapping = Unwrapping::new(angles, links);
    (0..is_free.len()).filter(|&site| !is_free[site]).for_each(|site| unwrapping.know(site));
    unwrapping.spread();
    // Then start at the smallest angle of each component without a fixed one.
    let mut seeds: Vec<usize> = (0..is_free.len()).filter(|&site| !unwrapping.is_known[site]).collect();
    sort_by_rank(&mut seeds, |&site| [ascending(unwrapping.angles[site].abs()), 0]);
    for seed in seeds {
        if !unwrapping.is_known[seed] {
            unwrapping.know(seed);
            unwrapping.spread();
        }
    }
}

struct Unwrapping<'a> {
    angles: &'a mut [f64],
    neighbours: Vec<Vec<usize>>,
    /// Sites with a final angle.
    is_known: Vec<bool>,
    /// Links from known sites by the difference of angles: to, from.
    queue: BinaryHeap<MinEntry<(usize, usize)>>,
}

impl<'a> Unwrapping<'a> {
    fn new(angles: &'a mut [f64], links: impl Iterator<Item = (usize, usize)>) -> Self {
        let mut neighbours: Vec<Vec<usize>> = vec![Vec::new(); angles.len()];
        for (i, j) in links {
            neighbours[i].push(j);
            neighbours[j].push(i);
        }
        let is_known = vec![false; angles.len()];
        Self { angles, neighbours, is_known, queue: BinaryHeap::new() }
    }

    fn know(&mut self, at: usize) {
        self.is_known[at] = true;
        let unknown = self.neighbours[at].iter().filter(|&&next| !self.is_known[next]);
        self.queue.extend(unknown.map(|&next| {
            let apart = self.angles[next] - self.angles[at];
            MinEntry { key: (apart - TAU * libm::round(apart / TAU)).abs(), item: (next, at) }
        }));
    }

    fn spread(&mut self) {
        while let Some(MinEntry { item: (at, from), .. }) = self.queue.pop() {
            if !self.is_known[at] {
                let turns = libm::round((self.angles[from] - self.angles[at]) / TAU);
                self.angles[at] += TAU * turns;
                self.know(at);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chain(angles: &[f64], free: &[bool]) -> Vec<f64> {
        let mut found = angles.to_vec();
        unwrap_angles(&mut found, free, (1..angles.len()).map(|j| (j - 1, j)));
        found
    }

    #[test]
    fn angles_continue_through_many_turns() {
        let wound: Vec<f64> = (0..40).map(|i| f64::from(i) * 0.5).collect();
        let wrapped: Vec<f64> = wound.iter().map(|angle| angle - TAU * libm::round(angle / TAU)).collect();
        let found = chain(&wrapped, &[true; 40]);
        assert!(found.iter().zip(&wound).all(|(a, b)| (a - b).abs() < 1e-12));
    }

    /// Two fixed angles may contradict one another. The jump stays at the largest difference, in any order of the
    /// sites.
    #[test]
    fn the_order_of_sites_does_not_matter() {
        let (angles, links) = ([2.6, 3.1, -2.5, -2.2, -1.4], [(0, 1), (1, 2), (2, 3), (3, 4), (0, 2)]);
        let found = |order: [usize; 5]| {
            let mut found = [0.0; 5];
            let mut free = [true; 5];
            for (site, at) in order.into_iter().enumerate() {
                found[at] = angles[site];
                free[at] = site != 0 && site != 4;
            }
            let links: Vec<_> = links.iter().map(|&(i, j)| (order[i], order[j])).collect();
            unwrap_angles(&mut found, &free, links.into_iter());
            order.map(|at| found[at])
        };
        let first = found([0, 1, 2, 3, 4]);
        assert!([[4, 3, 2, 1, 0], [2, 0, 4, 1, 3], [1, 4, 0, 3, 2]].into_iter().all(|order| found(order) == first));
        assert_eq!((first[0], first[4]), (2.6, -1.4));
    }

    #[test]
    fn fixed_angles_stay_and_spread() {
        let mut free = [true; 5];
        free[4] = false;
        let found = chain(&[0.1, 0.2, 0.3, 0.4, 0.5 + 2.0 * TAU], &free);
        assert!(found.iter().zip([0.1, 0.2, 0.3, 0.4, 0.5]).all(|(a, b)| (a - b - 2.0 * TAU).abs() < 1e-12));
    }
}
