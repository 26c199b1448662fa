//! The map of a pose for shapes that leave the domain, such as outlines and landmarks. It is continuous across the
//! outline, so that no shape tears.
//!
//! Around a domain that is the picture or cut out of it, a point moves with the nearest point of the outline, and so
//! does the skirt. Around a domain of polygons, the picture does not move. There, the displacement of the outline fades
//! out over a few times its length.
//!
//! Cost: that of [`Solution::map`] inside. Outside, it also includes a search among the edges of the outline. Known
//! limit: midway between two islands, the nearest point changes from one island to the other, and the map jumps.

use glam::DVec2;

use crate::{Solution, deform::Pose, segment::nearest_on_segment};

/// The displacement of the outline fades out over this multiple of its own length. The slope of the fading is at most
/// 1.5 times its inverse, so that nothing folds.
const FADE_LENGTHS: f64 = 4.0;
/// Number of edges that share a box.
const RUN: usize = 16;

/// The posed positions of points inside and outside the domain. Made by [`Solution::continued`].
#[derive(Debug)]
pub struct ContinuedMap<'a> {
    solution: &'a Solution,
    pose: &'a Pose,
    edges: Vec<[DVec2; 2]>,
    /// The box around each run of edges: least and greatest coordinates.
    boxes: Vec<[DVec2; 2]>,
    /// Whether the picture around the domain does not move.
    background_stays: bool,
}

impl Solution {
    /// The map of a pose, continued beyond the domain.
    ///
    /// # Panics
    /// If the pose belongs to another solution.
    #[must_use]
    pub fn continued<'a>(&'a self, pose: &'a Pose) -> ContinuedMap<'a> {
        self.solved.expect_own(pose);
        let edges: Vec<[DVec2; 2]> = self.domain().edges().map(|(a, b)| [a, b]).collect();
        let around = |run: &[[DVec2; 2]]| {
            let points = run.iter().flatten();
            points.fold([DVec2::INFINITY, DVec2::NEG_INFINITY], |[low, high], p| [low.min(*p), high.max(*p)])
        };
        let boxes = edges.chunks(RUN).map(around).collect();
        let background_stays = !self.static_background().triangles().is_empty();
        ContinuedMap { solution: self, pose, edges, boxes, background_stays }
    }
}

impl ContinuedMap<'_> {
    /// Whether a point lies in the domain.
    #[must_use]
    pub fn is_inside(&self, p: DVec2) -> bool {
        self.solution.navigation().triangle_at(p).is_some()
    }

    /// Whether the picture around the domain does not move.
    #[must_use]
    pub fn background_stays(&self) -> bool {
        self.background_stays
    }

    /// The posed position of a point, in pixels.
    #[must_use]
    pub fn place(&self, p: DVec2) -> DVec2 {
        if let Some(mapped) = self.solution.map(self.pose, p) {
            return mapped.posed;
        }
        let foot = self.nearest_on_outline(p);
        let weights = self.solution.weights_at(foot).unwrap_or_default();
        if !self.background_stays {
            return self.pose.blended(p, weights);
        }
        let offset = self.pose.blended(foot, weights) - foot;
        let reach = FADE_LENGTHS * offset.length();
        let t = (p.distance(foot) / reach.max(f64::MIN_POSITIVE)).min(1.0);
        p + offset * (1.0 - t * t * (3.0 - 2.0 * t))
    }

    fn nearest_on_outline(&self, p: DVec2) -> DVec2 {
        let mut nearest = (f64::INFINITY, p);
        for (run, &[low, high]) in self.edges.chunks(RUN).zip(&self.boxes) {
            if p.distance_squared(p.clamp(low, high)) >= nearest.0 {
                continue;
            }
            for &[a, b] in run {
                let foot = nearest_on_segment(p, a, b);
                let squared = p.distance_squared(foot);
                if squared < nearest.0 {
                    nearest = (squared, foot);
                }
            }
        }
        nearest.1
    }
}

#[cfg(test)]
mod tests {
    use crate::{
        Picture,
        project::{DomainSpec, Handle, Project},
        solve,
    };

    use super::*;

    /// A square from 20 to 80 in a picture of 100 pixels, whose upper right corner is pulled to the right.
    fn places(is_cut_out: bool, points: &[[f64; 2]]) -> Vec<DVec2> {
        let inside = |at: usize| (20..80).contains(&(at % 100)) && (20..80).contains(&(at / 100));
        let alpha = |at| if is_cut_out && !inside(at) { 0 } else { 255 };
        let rgba: Vec<u8> = (0..10_000).flat_map(|at| [0, 0, 0, alpha(at)]).collect();
        let mut project = Project::for_picture(100, 100);
        if !is_cut_out {
            let ring = [[20.0, 20.0], [80.0, 20.0], [80.0, 80.0], [20.0, 80.0]].map(DVec2::from).to_vec();
            project.domain = Some(DomainSpec::polygon(vec![ring]));
        }
        let handle = Handle::point("corner", [75.0, 25.0]).posed_at([[80.0, 25.0]]);
        project.handles = vec![handle, Handle::point("held", [25.0, 75.0])];
        let solution = solve(&project, &Picture::new(100, 100, &rgba).unwrap()).unwrap();
        let pose = solution.pose(&project).unwrap();
        let map = solution.continued(&pose);
        points.iter().map(|&p| map.place(p.into())).collect()
    }

    #[test]
    fn map_is_continuous_across_the_outline() {
        for is_cut_out in [true, false] {
            let places = places(is_cut_out, &[[79.999, 40.0], [80.001, 40.0]]);
            let apart = places[1] - places[0] - DVec2::new(0.002, 0.0);
            assert!(apart.length() < 0.002, "{is_cut_out}: {places:?}");
        }
    }

    #[test]
    fn surroundings_follow_a_cut_out_and_stay_around_polygons() {
        let beside = [[95.0, 25.0], [99.9, 99.9]];
        let followed = places(true, &beside);
        assert!(followed[0].distance(DVec2::new(100.0, 25.0)) < 1.0, "{followed:?}");
        let stayed = places(false, &beside);
        assert!(stayed[0].x > 95.0 && stayed[0].x < 97.0, "{stayed:?}");
        assert_eq!(stayed[1], DVec2::from(beside[1]));
    }
}
