//! Angles that go on from site to site.
//!
//! The rigid mode knows rotations, which have an angle up to whole turns. Between neighbours the least difference is meant: what
//! is rolled up by three turns unrolls by angles up to three turns. The rigid blend takes the mean of angles, so it needs them so.
//!
//! From the sites whose turn the person set, or else from the first, each site takes the angle nearest to that of the neighbour
//! it is reached from. Around a hole the last neighbours may still be a whole turn apart. Cost: a look at every link, and a visit
//! where a turn is missing somewhere.

use std::{
    collections::VecDeque,
    f64::consts::{PI, TAU},
};

use super::Motion;

/// Shifts the angles of free sites by whole turns.
pub(super) fn unwrap_angles(
    motions: &mut [Motion],
    is_free: &[bool],
    links: impl Iterator<Item = (usize, usize, f64)> + Clone,
) {
    if links.clone().all(|(i, j, _)| (motions[i].angle - motions[j].angle).abs() < PI) {
        return;
    }
    let mut neighbours: Vec<Vec<usize>> = vec![Vec::new(); motions.len()];
    for (i, j, _) in links {
        neighbours[i].push(j);
        neighbours[j].push(i);
    }
    let mut is_known: Vec<bool> = is_free.iter().map(|free| !free).collect();
    let mut queue: VecDeque<usize> = (0..motions.len()).filter(|&site| is_known[site]).collect();
    for first in 0..motions.len() {
        // Those that are set come first, then one of each part that none of them is in.
        if queue.is_empty() && !is_known[first] {
            is_known[first] = true;
            queue.push_back(first);
        }
        while let Some(site) = queue.pop_front() {
            for &next in &neighbours[site] {
                if !is_known[next] {
                    is_known[next] = true;
                    let turns = libm::round((motions[site].angle - motions[next].angle) / TAU);
                    motions[next].angle += TAU * turns;
                    queue.push_back(next);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chain(angles: &[f64], free: &[bool]) -> Vec<f64> {
        let mut motions: Vec<Motion> = angles.iter().map(|&angle| Motion { angle, ..Motion::default() }).collect();
        unwrap_angles(&mut motions, free, (1..angles.len()).map(|j| (j - 1, j, 1.0)));
        motions.iter().map(|motion| motion.angle).collect()
    }

    #[test]
    fn angles_go_on_through_many_turns() {
        let wound: Vec<f64> = (0..40).map(|i| f64::from(i) * 0.5).collect();
        let wrapped: Vec<f64> = wound.iter().map(|angle| angle - TAU * libm::round(angle / TAU)).collect();
        let found = chain(&wrapped, &[true; 40]);
        assert!(found.iter().zip(&wound).all(|(a, b)| (a - b).abs() < 1e-12));
    }

    #[test]
    fn what_was_set_stays_and_leads() {
        let mut free = [true; 5];
        free[4] = false;
        let found = chain(&[0.1, 0.2, 0.3, 0.4, 0.5 + 2.0 * TAU], &free);
        assert!(found.iter().zip([0.1, 0.2, 0.3, 0.4, 0.5]).all(|(a, b)| (a - b - 2.0 * TAU).abs() < 1e-12));
    }
}
