//! Motions of all sites from the handles: what is computed anew in every frame of a drag.

use std::{
    borrow::Cow,
    collections::{BTreeSet, HashMap},
    f64::consts::TAU,
    sync::Arc,
};

use glam::{DMat2, DVec2};

use super::{
    Form, HarmonicFields, Motion, Pose, Quadrature, Solved, relaxation::Freedom, rigid::Rigid, unwrap::unwrap_angles,
};
use crate::{
    bone::{BoneMotion, Skeleton},
    error::Error,
    project::{Blend, Handle, PoseMode, Rotation, Shape, check_handles},
    site::{Site, SiteGraph, SiteKind},
};

/// Poses a solved scene. It knows the sites and how they depend on one another, no picture and no samples.
///
/// Cost of a pose: a look at every share of a handle in a virtual site, and at every pair of handles that has an edge where
/// rotations are automatic. Microseconds for tens of handles, some milliseconds for 1,000; some hundreds of microseconds more in the
/// rigid mode.
#[derive(Debug, Clone)]
pub struct Poser {
    rest: Arc<[DVec2]>,
    kinds: Vec<SiteKind>,
    skeleton: Skeleton,
    /// What each handle was solved as.
    solved: Vec<Solved>,
    /// ϖ: for each site its real sites and their shares.
    shares: Vec<Vec<(u32, f64)>>,
    /// Pairs of real sites that are neighbours, one of them a point handle, and how strongly: the edges that turn automatic
    /// rotations.
    edges: Vec<(u32, u32, f64)>,
    /// Pairs of handles that share out what is between them with no third one.
    meeting: Vec<[u32; 2]>,
    /// In the rigid mode.
    rigid: Option<Rigid>,
}

impl Poser {
    pub(crate) fn new(
        sites: &[Site],
        graph: &SiteGraph,
        harmonic: &HarmonicFields,
        skeleton: Skeleton,
        solved: Vec<Solved>,
        mode: PoseMode,
        quadrature: Option<Quadrature>,
    ) -> Self {
        let edges = effective_links(sites, graph, harmonic);
        let freedom = |site: &Site| match site.kind {
            SiteKind::Virtual => Freedom::Whole,
            SiteKind::Point { .. } => Freedom::Linear,
            SiteKind::Bone { bone, .. } if !skeleton.bones[bone as usize].of_loop => {
                let [a, b] = skeleton.bones[bone as usize].rest;
                Freedom::Across((b - a).normalize())
            }
            SiteKind::Bone { .. } | SiteKind::Boundary => Freedom::None,
        };
        let freedom = sites.iter().map(freedom).collect();
        let rigid = match mode {
            PoseMode::Harmonic => None,
            PoseMode::Rigid => Some(Rigid::new(freedom, graph.iter(), quadrature)),
        };
        Self {
            rest: sites.iter().map(|site| site.rest).collect(),
            kinds: sites.iter().map(|site| site.kind).collect(),
            skeleton,
            solved,
            shares: harmonic.rows.clone(),
            edges,
            meeting: meeting(sites, graph, harmonic),
            rigid,
        }
    }

    /// The motions of all sites when the handles are posed as given, in any order, to be blended in one way or the other; their rest
    /// places play no part, but for the turn of bars and polygons.
    ///
    /// # Errors
    /// [`Error::PoseMismatch`] for more or fewer handles than were solved, [`Error::PoseMissing`] where one of these is not among them,
    /// [`Error::PoseShape`] for one of another kind or with other
    /// corners; [`Error::Project`] for what no handle of a project may be, such as one with a scale of 0; [`Error::PoseNotFinite`] for
    /// numbers that overflow; [`Error::PoserBytes`] where bytes that were read say of bars what no scene says.
    pub fn pose(&self, handles: &[Handle], blend: Blend) -> Result<Pose, Error> {
        let given = handles;
        let handles = &*self.as_solved(given)?;
        for (handle, &Solved { form: solved, .. }) in handles.iter().zip(&self.solved) {
            if let Some(posed) = Form::of(&handle.shape).into_iter().find(|&form| form != solved) {
                return Err(Error::PoseShape { id: handle.id.clone(), solved, posed });
            }
        }
        check_handles(given)?;
        if !self.skeleton.fits(handles) {
            // A skeleton that is made is made of the handles' corners; one that was read need not be.
            return Err(Error::PoserBytes);
        }
        let mut motions = self.real_motions(handles);
        for (kind, motion) in self.kinds.iter().zip(&motions) {
            if let Some(handle) = kind.handle().filter(|_| !motion.is_in_bounds()) {
                return Err(Error::PoseNotFinite { id: handles[handle].id.clone() });
            }
        }
        self.turn_automatic(handles, &mut motions);
        self.turn_alike(handles, &mut motions);
        self.blend_virtual(&mut motions);
        if let Some(rigid) = &self.rigid {
            let is_free = |kind: &SiteKind| match kind {
                SiteKind::Virtual => true,
                SiteKind::Point { handle } => handles[*handle as usize].rotation == Rotation::Auto,
                SiteKind::Bone { .. } | SiteKind::Boundary => false,
            };
            let is_free: Vec<bool> = self.kinds.iter().map(is_free).collect();
            rigid.settle(&self.rest, &mut motions, &is_free, &self.scales(handles));
            let mut angles: Vec<f64> = motions.iter().map(|motion| motion.angle).collect();
            unwrap_angles(&mut angles, &is_free, rigid.links().map(|(i, j, _)| (i, j)));
            motions.iter_mut().zip(angles).for_each(|(motion, angle)| motion.angle = angle);
        }
        Ok(Pose::new(Arc::clone(&self.rest), motions, blend))
    }

    /// Whether a pose is of what this poses: the same sites.
    pub(crate) fn has_made(&self, pose: &Pose) -> bool {
        // The poser that made it may have been one of the same bytes.
        Arc::ptr_eq(pose.rest(), &self.rest) || *pose.rest() == self.rest
    }

    /// The handles in the order in which they were solved.
    fn as_solved<'a>(&self, handles: &'a [Handle]) -> Result<Cow<'a, [Handle]>, Error> {
        if handles.len() != self.solved.len() {
            return Err(Error::PoseMismatch { expected: self.solved.len(), found: handles.len() });
        }
        if handles.iter().zip(&self.solved).all(|(handle, solved)| handle.id == solved.id) {
            return Ok(Cow::Borrowed(handles));
        }
        let by_id: HashMap<&str, &Handle> = handles.iter().map(|handle| (handle.id.as_str(), handle)).collect();
        let find = |Solved { id, .. }: &Solved| {
            by_id.get(id.as_str()).copied().cloned().ok_or_else(|| Error::PoseMissing { id: id.clone() })
        };
        self.solved.iter().map(find).collect::<Result<_, _>>().map(Cow::Owned)
    }

    /// The motions of the real sites, but for automatic rotations; none of the virtual ones yet.
    fn real_motions(&self, handles: &[Handle]) -> Vec<Motion> {
        let bones = self.skeleton.motions(handles);
        let motion = |(&rest, kind): (&DVec2, &SiteKind)| match *kind {
            SiteKind::Point { handle } => of_point(rest, &handles[handle as usize]),
            SiteKind::Bone { handle, bone } => of_bone(rest, &bones[bone as usize], handles[handle as usize].depth),
            SiteKind::Boundary | SiteKind::Virtual => Motion::default(),
        };
        self.rest.iter().zip(&self.kinds).map(motion).collect()
    }

    /// Blends the motions of virtual sites from those of real ones, by their harmonic shares (eq. 4).
    fn blend_virtual(&self, motions: &mut [Motion]) {
        // A motion that is the identity adds nothing: a held outline's, and usually those of most handles.
        let passed_on = |motion: &Motion| {
            (*motion != Motion::default()).then(|| {
                let passed_on = motion.passed_on();
                (passed_on, passed_on.linear())
            })
        };
        let passed_on: Vec<Option<(Motion, DMat2)>> = motions.iter().map(passed_on).collect();
        for site in (0..motions.len()).filter(|&site| !self.kinds[site].is_real()) {
            let here = |&(real, share): &(u32, f64)| {
                let real = real as usize;
                let from = self.rest[site] - self.rest[real];
                passed_on[real].map(|(motion, linear)| (motion.seen_from(from, linear), share))
            };
            motions[site] = Motion::blended(self.shares[site].iter().filter_map(here));
        }
    }

    /// Sets automatic rotations (section VI): the best fit of the pseudo-edges to neighbouring real sites, from rest to pose.
    fn turn_automatic(&self, handles: &[Handle], motions: &mut [Motion]) {
        let is_auto = |kind: &SiteKind| match *kind {
            SiteKind::Point { handle } => handles[handle as usize].rotation == Rotation::Auto,
            SiteKind::Bone { .. } | SiteKind::Boundary | SiteKind::Virtual => false,
        };
        let is_auto: Vec<bool> = self.kinds.iter().map(is_auto).collect();
        let mut turns = vec![DVec2::ZERO; motions.len()];
        for &(i, j, weight) in &self.edges {
            let (i, j) = (i as usize, j as usize);
            if is_auto[i] || is_auto[j] {
                let before = self.rest[j] - self.rest[i];
                let after = before + (motions[j].translation - motions[i].translation);
                // Seen from the other end both edges are reversed, and the rotation between them is the same.
                let turn = weight / before.length_squared() * DVec2::new(before.dot(after), before.perp_dot(after));
                turns[i] += turn;
                turns[j] += turn;
            }
        }
        for site in (0..motions.len()).filter(|&site| is_auto[site]) {
            motions[site].angle = libm::atan2(turns[site].y, turns[site].x);
        }
    }

    /// Takes automatic rotations of neighbours to angles that go on from one to the other. Where one was set, the way around to it is the
    /// person's: the automatic ones beside it do not follow it by whole turns.
    fn turn_alike(&self, handles: &[Handle], motions: &mut [Motion]) {
        let mut found = vec![0.0; handles.len()];
        for (kind, motion) in self.kinds.iter().zip(&*motions) {
            if let Some(handle) = kind.handle() {
                found[handle] = motion.angle;
            }
        }
        let is_auto = |&handle: &u32| handles[handle as usize].rotation == Rotation::Auto;
        let links = self.meeting.iter().filter(|pair| pair.iter().all(is_auto));
        let mut angles = found.clone();
        let is_free = vec![true; handles.len()];
        unwrap_angles(&mut angles, &is_free, links.map(|&[a, b]| (a as usize, b as usize)));
        for (kind, motion) in self.kinds.iter().zip(motions) {
            if let Some(handle) = kind.handle().filter(|&handle| angles[handle] != found[handle]) {
                motion.angle += TAU * libm::round((angles[handle] - found[handle]) / TAU);
            }
        }
    }

    /// The scales of the handles at each site, spread by their harmonic shares. The stretch of a bar along itself is not passed on.
    fn scales(&self, handles: &[Handle]) -> Vec<f64> {
        let logs: Vec<f64> = handles.iter().map(|handle| libm::log(handle.scale)).collect();
        if logs.iter().all(|&log| log == 0.0) {
            return vec![1.0; self.rest.len()];
        }
        let log = |&(real, share): &(u32, f64)| {
            let handle = self.kinds[real as usize].handle();
            share * handle.map_or(0.0, |handle| logs[handle])
        };
        self.shares.iter().map(|shares| libm::exp(shares.iter().map(log).sum())).collect()
    }

    /// The poser as bytes, to be made again elsewhere by [`Poser::from_bytes`] of the same version.
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        // Not by a derived implementation: anybody could then read one past the checks of `from_bytes`.
        let Self { rest, kinds, skeleton, solved, shares, edges, meeting, rigid } = self;
        let all = (rest, kinds, skeleton, solved, shares, edges, meeting, rigid);
        postcard::to_allocvec(&all).expect("plain data can be written to memory")
    }

    /// # Errors
    /// [`Error::PoserBytes`] for anything but the result of [`Poser::to_bytes`].
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, Error> {
        let all = postcard::from_bytes(bytes).map_err(|_| Error::PoserBytes)?;
        let (rest, kinds, skeleton, solved, shares, edges, meeting, rigid) = all;
        let poser = Self { rest, kinds, skeleton, solved, shares, edges, meeting, rigid };
        let sites = poser.rest.len();
        let real = |site: u32| poser.kinds.get(site as usize).is_some_and(|kind| kind.is_real());
        let known = |kind: &SiteKind| match *kind {
            SiteKind::Point { handle } => {
                poser.solved.get(handle as usize).is_some_and(|solved| solved.form == Form::Point)
            }
            SiteKind::Bone { handle, bone } => {
                (handle as usize) < poser.solved.len() && (bone as usize) < poser.skeleton.bones.len()
            }
            SiteKind::Boundary | SiteKind::Virtual => true,
        };
        let whole = poser.kinds.len() == sites
            && poser.shares.len() == sites
            && poser.shares.iter().flatten().all(|&(site, _)| real(site))
            && poser.edges.iter().all(|&(i, j, _)| real(i) && real(j))
            && poser.meeting.iter().flatten().all(|&handle| (handle as usize) < poser.solved.len())
            && poser.rigid.as_ref().is_none_or(|rigid| rigid.is_whole(sites))
            && poser.skeleton.is_whole(poser.solved.len())
            && poser.kinds.iter().all(known);
        if whole { Ok(poser) } else { Err(Error::PoserBytes) }
    }
}

fn of_point(rest: DVec2, handle: &Handle) -> Motion {
    let Shape::Point { posed, .. } = handle.shape else { unreachable!("kinds are checked before") };
    let angle = match handle.rotation {
        Rotation::Degrees(degrees) => degrees.to_radians(),
        Rotation::Auto => 0.0,
    };
    Motion::similarity(angle, handle.scale, posed - rest, handle.depth)
}

/// What a bone does at one of its sites.
fn of_bone(rest: DVec2, bone: &BoneMotion, depth: f64) -> Motion {
    let motion = Motion::of_bone(bone.angle, bone.along, bone.stretch, bone.across, DVec2::ZERO, depth);
    Motion { translation: bone.posed + motion.linear() * (rest - bone.rest) - rest, ..motion }
}

/// Pairs of handles between whose parts of the cell graph there are links: each site is of the part that has the largest share in it.
fn meeting(sites: &[Site], graph: &SiteGraph, harmonic: &HarmonicFields) -> Vec<[u32; 2]> {
    let leader = |row: &Vec<(u32, f64)>| {
        let (real, _) = row.iter().copied().reduce(|most, one| if one.1 > most.1 { one } else { most })?;
        sites[real as usize].kind.handle()
    };
    let leaders: Vec<Option<usize>> = harmonic.rows.iter().map(leader).collect();
    let pair = |(i, j, _): (usize, usize, f64)| {
        let (a, b) = (leaders[i]? as u32, leaders[j]? as u32);
        (a != b).then(|| [a.min(b), a.max(b)])
    };
    graph.iter().filter_map(pair).collect::<BTreeSet<_>>().into_iter().collect()
}

/// Pseudo-edges (section VI) of point handles: the cell graph reduced to its real sites. The weight of an edge is the flow between
/// two handles, directly and via virtual sites (the Schur complement of the Laplacian). Edges between other sites are left out: there
/// may be a million.
fn effective_links(sites: &[Site], graph: &SiteGraph, harmonic: &HarmonicFields) -> Vec<(u32, u32, f64)> {
    let is_point = |site: usize| matches!(sites[site].kind, SiteKind::Point { .. });
    let mut flow = std::collections::BTreeMap::<(u32, u32), f64>::new();
    for (i, j, weight) in graph.iter() {
        for (real, other) in [(i, j), (j, i)] {
            // Links between two real sites count from both ends, as flows by way of virtual sites do.
            if !sites[real].kind.is_real() {
                continue;
            }
            for &(to, share) in &harmonic.rows[other] {
                if to as usize != real && (is_point(real) || is_point(to as usize)) {
                    let pair = ((real as u32).min(to), (real as u32).max(to));
                    *flow.entry(pair).or_default() += weight * share;
                }
            }
        }
    }
    flow.into_iter().map(|((i, j), weight)| (i, j, weight)).collect()
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
        let poser = solution.poser();
        let still = poser.real_motions(&project.handles);
        let mut turned = still.clone();
        poser.turn_automatic(&project.handles, &mut turned);
        for (site, kind) in poser.kinds.iter().enumerate() {
            let is_auto = matches!(*kind, SiteKind::Point { handle } if handle != 1);
            let own = poser.edges.iter().filter(|&&(i, j, _)| [i, j].contains(&(site as u32)));
            let (mut cos, mut sin) = (0.0, 0.0);
            for &(i, j, weight) in own {
                let other = if i as usize == site { j } else { i } as usize;
                let before = poser.rest[other] - poser.rest[site];
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
