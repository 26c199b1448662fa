//! Automatic rotations of point handles (section VI): the best fit to the motions of neighbouring handles.
//!
//! Cost: linear in the pairs of handles that share an edge.

use std::{collections::BTreeMap, f64::consts::TAU};

use glam::DVec2;

use super::{HarmonicFields, Motion, unwrap::unwrap_angles};
use crate::{
    project::{Handle, Rotation},
    rank::sort_by_rank,
    site::{Site, SiteGraph, SiteKind},
};

/// The cell graph, reduced to the handles.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "poser-bytes", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Automatic {
    /// Pairs of neighbouring real sites, at least one of them a point handle, with a weight.
    pub(super) edges: Vec<(u32, u32, f64)>,
    /// Pairs of handles whose regions of the cell graph are adjacent.
    pub(super) adjacent: Vec<[u32; 2]>,
}

impl Automatic {
    pub(super) fn new(sites: &[Site], graph: &SiteGraph, harmonic: &HarmonicFields) -> Self {
        Self { edges: effective_links(sites, graph, harmonic), adjacent: adjacent(sites, graph, harmonic) }
    }

    /// Whether data read from bytes is consistent.
    pub(super) fn is_whole(&self, is_real: impl Fn(u32) -> bool, handles: usize) -> bool {
        self.edges.iter().all(|&(i, j, _)| is_real(i) && is_real(j))
            && self.adjacent.iter().flatten().all(|&handle| (handle as usize) < handles)
    }

    /// Sets the automatic rotations among the motions of real sites.
    pub(super) fn turn(&self, rest: &[DVec2], kinds: &[SiteKind], handles: &[Handle], motions: &mut [Motion]) {
        self.turn_to_fit(rest, rest, kinds, handles, motions);
        self.turn_alike(kinds, handles, motions);
    }

    /// The best fit of the pseudo-edges to neighbouring real sites, from rest to pose. Translations are from there.
    pub(super) fn turn_to_fit(
        &self,
        rest: &[DVec2],
        places: &[DVec2],
        kinds: &[SiteKind],
        handles: &[Handle],
        motions: &mut [Motion],
    ) {
        let is_auto = |kind: &SiteKind| match *kind {
            SiteKind::Point { handle } => handles[handle as usize].rotation == Rotation::Auto,
            SiteKind::Bone { .. } | SiteKind::Boundary | SiteKind::Virtual => false,
        };
        let is_auto: Vec<bool> = kinds.iter().map(is_auto).collect();
        let mut turns = vec![DVec2::ZERO; motions.len()];
        for &(i, j, weight) in &self.edges {
            let (i, j) = (i as usize, j as usize);
            if is_auto[i] || is_auto[j] {
                let before = places[j] - places[i];
                let after = before + (motions[j].translation - motions[i].translation);
                // Seen from the other end both edges are reversed, and the rotation between them is the same.
                let turn = weight / (rest[j] - rest[i]).length_squared()
                    * DVec2::new(before.dot(after), before.perp_dot(after));
                turns[i] += turn;
                turns[j] += turn;
            }
        }
        for site in (0..motions.len()).filter(|&site| is_auto[site]) {
            motions[site].angle = libm::atan2(turns[site].y, turns[site].x);
        }
    }

    /// Unwraps automatic rotations of neighbours to angles that differ by less than half a turn. They do not follow
    /// whole turns of a rotation that the user set.
    fn turn_alike(&self, kinds: &[SiteKind], handles: &[Handle], motions: &mut [Motion]) {
        let mut found = vec![0.0; handles.len()];
        for (kind, motion) in kinds.iter().zip(&*motions) {
            if let Some(handle) = kind.handle() {
                found[handle] = motion.angle;
            }
        }
        let is_auto = |&handle: &u32| handles[handle as usize].rotation == Rotation::Auto;
        let links = self.adjacent.iter().filter(|pair| pair.iter().all(is_auto));
        let mut angles = found.clone();
        let is_free = vec![true; handles.len()];
        unwrap_angles(&mut angles, &is_free, links.map(|&[a, b]| (a as usize, b as usize)));
        for (kind, motion) in kinds.iter().zip(motions) {
            if let Some(handle) = kind.handle().filter(|&handle| angles[handle] != found[handle]) {
                motion.angle += TAU * libm::round((angles[handle] - found[handle]) / TAU);
            }
        }
    }
}

/// Pseudo-edges (section VI) of point handles: the cell graph reduced to its real sites. The weight of an edge is the
/// flow between two handles, directly and via virtual sites (the Schur complement of the Laplacian). Edges between
/// other sites are left out, because there may be a million of them.
fn effective_links(sites: &[Site], graph: &SiteGraph, harmonic: &HarmonicFields) -> Vec<(u32, u32, f64)> {
    let is_point = |site: usize| matches!(sites[site].kind, SiteKind::Point { .. });
    let mut flow = BTreeMap::<(u32, u32), f64>::new();
    for (i, j, weight) in graph.iter() {
        for (real, other) in [(i, j), (j, i)] {
            // Links between two real sites count from both ends, as flows via virtual sites do.
            if !sites[real].kind.is_real() {
                continue;
            }
            for &(to, fraction) in &harmonic.rows[other] {
                if to as usize != real && (is_point(real) || is_point(to as usize)) {
                    let pair = ((real as u32).min(to), (real as u32).max(to));
                    *flow.entry(pair).or_default() += weight * fraction;
                }
            }
        }
    }
    flow.into_iter().map(|((i, j), weight)| (i, j, weight)).collect()
}

/// Pairs of handles whose regions of the cell graph are linked. A site belongs to the handle with the largest
/// harmonic weight.
fn adjacent(sites: &[Site], graph: &SiteGraph, harmonic: &HarmonicFields) -> Vec<[u32; 2]> {
    let leader = |row: &Vec<(u32, f64)>| {
        let (real, _) = row.iter().copied().reduce(|most, one| if one.1 > most.1 { one } else { most })?;
        sites[real as usize].kind.handle()
    };
    let leaders: Vec<Option<usize>> = harmonic.rows.iter().map(leader).collect();
    let pair = |(i, j, _): (usize, usize, f64)| {
        let (a, b) = (leaders[i]? as u32, leaders[j]? as u32);
        (a != b).then(|| [a.min(b), a.max(b)])
    };
    let mut pairs: Vec<[u32; 2]> = graph.iter().filter_map(pair).collect();
    sort_by_rank(&mut pairs, |&pair| pair.map(i64::from));
    pairs.dedup();
    pairs
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Picture, project::Project, solve};

    #[test]
    fn automatic_rotations_are_those_of_their_own_edges() {
        let places = [[20.0, 30.0], [80.0, 25.0], [50.0, 55.0], [30.0, 80.0], [75.0, 70.0]];
        let handle = |(id, [x, y]): (usize, &[f64; 2])| {
            let rotation = if id == 1 { "20" } else { "\"auto\"" };
            let posed = [x + 3.0 * (y * x) / 3e3, y + 0.1 * x];
            format!(
                r#"{{"id": "{id}", "kind": "point", "rest": [{x}, {y}], "posed": {posed:?}, "rotation": {rotation}}}"#
            )
        };
        let bar = r#"{"id": "bar", "kind": "bar", "rest": [[10, 92], [90, 95]], "posed": [[10, 80], [85, 99]]}"#;
        let handles: Vec<String> = places.iter().enumerate().map(handle).chain([bar.into()]).collect();
        let json = format!(
            r#"{{"format": "c2warp/1", "image": {{"src": "", "width": 100, "height": 100}}, "samples": 500, "handles": [{}]}}"#,
            handles.join(", ")
        );
        let project = Project::from_json(&json).unwrap();
        let solution = solve(&project, &Picture::new(100, 100, &[255; 40_000]).unwrap()).unwrap();
        let automatic = Automatic::new(solution.sites(), &solution.solved.graph, &solution.solved.harmonic);
        let (rest, kinds): (Vec<DVec2>, Vec<SiteKind>) =
            solution.sites().iter().map(|site| (site.rest, site.kind)).unzip();
        let still = solution.poser().real_motions(&project.handles);
        let mut turned = still.clone();
        automatic.turn_to_fit(&rest, &rest, &kinds, &project.handles, &mut turned);
        for (site, kind) in kinds.iter().enumerate() {
            let is_auto = matches!(*kind, SiteKind::Point { handle } if handle != 1);
            let own = automatic.edges.iter().filter(|&&(i, j, _)| [i, j].contains(&(site as u32)));
            let (mut cos, mut sin) = (0.0, 0.0);
            for &(i, j, weight) in own {
                let other = if i as usize == site { j } else { i } as usize;
                let before = rest[other] - rest[site];
                let after = before + (still[other].translation - still[site].translation);
                cos += weight / before.length_squared() * before.dot(after);
                sin += weight / before.length_squared() * before.perp_dot(after);
            }
            let angle = if is_auto { libm::atan2(sin, cos) } else { still[site].angle };
            assert_eq!(turned[site].angle.to_bits(), angle.to_bits(), "site {site}");
        }
        assert!(turned.iter().filter(|motion| motion.angle != 0.0).count() > 5);
    }
}
