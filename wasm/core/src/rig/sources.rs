//! Handles and their bones with their motions in a pose: the sources in which sites have shares.
//!
//! A point is one source, and so is each bone of a bar or polygon. Every source is a map of the plane, independent of
//! the sites along a bone. So the shares of all sites along a bone add up to one share.

use glam::{DMat2, DVec2};

use super::{
    bytes::{Reader, Writer},
    error::RigError,
};
use crate::{
    bone::{Anchor, Bone, BoneMotion, Skeleton},
    pose::Motion,
    project::{Handle, Rotation, Shape, check_handles},
};

/// Handles in the pose of the project, and the bones of bars and polygons.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Sources {
    pub(super) handles: Vec<Handle>,
    pub(super) skeleton: Skeleton,
}

/// The map of a source: rotation and stretch around `anchor`, which moves to `posed`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Source {
    anchor: DVec2,
    posed: DVec2,
    /// The vector from the anchor along the bone to its end.
    bone: DVec2,
    motion: Motion,
    linear: DMat2,
    /// The motion passed to virtual sites: a bone that is posed to zero length does not collapse them.
    passed_on: Motion,
    passed_on_linear: DMat2,
}

impl Source {
    fn new(anchor: DVec2, posed: DVec2, bone: DVec2, motion: Motion) -> Self {
        let passed_on = motion.passed_on();
        let (linear, passed_on_linear) = (motion.linear(), passed_on.linear());
        Self { anchor, posed, bone, motion, linear, passed_on, passed_on_linear }
    }

    /// The motion of a site of the handle itself.
    pub(super) fn own(&self, place: DVec2) -> Motion {
        Motion { translation: self.posed + self.linear * (place - self.anchor) - place, ..self.motion }
    }

    /// The motion in which a virtual site has a share. The sites behind it lie at the mean fraction `along` of the
    /// bone.
    pub(super) fn spread(&self, place: DVec2, along: f64) -> Motion {
        let kept = along * ((self.linear - self.passed_on_linear) * self.bone);
        let translation = self.posed + self.passed_on_linear * (place - self.anchor) + kept - place;
        Motion { translation, ..self.passed_on }
    }
}

impl Sources {
    pub(super) fn new(handles: &[Handle], skeleton: &Skeleton) -> Self {
        let mut skeleton = skeleton.clone();
        // Only a solve needs bodies.
        skeleton.bones.iter_mut().for_each(|bone| bone.body = 0);
        Self { handles: handles.to_vec(), skeleton }
    }

    /// The number of handles and bones. Source k is handle k, and those after the handles are bones.
    pub(super) fn count(&self) -> usize {
        self.handles.len() + self.skeleton.bones.len()
    }

    /// Whether a number refers to a source: bars and polygons themselves are not sources.
    pub(super) fn has(&self, source: usize) -> bool {
        self.handles.get(source).map_or(source < self.count(), |handle| matches!(handle.shape, Shape::Point { .. }))
    }

    /// Whether handles have the kinds and corners of these ones, and rotations that need no solver.
    pub(super) fn fit(&self, handles: &[Handle]) -> bool {
        let corners = |handle: &Handle| (std::mem::discriminant(&handle.shape), handle.shape.posed().len());
        handles.len() == self.handles.len()
            && handles.iter().zip(&self.handles).all(|(a, b)| corners(a) == corners(b))
            && handles.iter().all(|handle| !turns_by_itself(handle))
    }

    /// The maps of all sources, with the handles posed as given. Bars and polygons themselves have no map.
    pub(super) fn posed(&self, handles: &[Handle]) -> Vec<Option<Source>> {
        let bones = self.skeleton.bones.iter().zip(self.skeleton.motions(handles));
        let of_bone = |(bone, motion): (&Bone, BoneMotion)| {
            let BoneMotion { rest, posed, along, angle, stretch, across } = motion;
            let depth = handles[bone.handle as usize].depth;
            let motion = Motion::of_bone(angle, along, stretch, across, DVec2::ZERO, depth);
            Source::new(rest, posed, bone.rest[1] - bone.rest[0], motion)
        };
        handles.iter().map(of_point).chain(bones.map(|bone| Some(of_bone(bone)))).collect()
    }

    pub(super) fn write(&self, to: &mut Writer) {
        self.handles.iter().for_each(|handle| write_handle(handle, to));
        to.count(self.skeleton.joints.len());
        for anchors in &self.skeleton.joints {
            to.count(anchors.len());
            for anchor in anchors {
                to.varint(anchor.handle);
                to.varint(anchor.segment);
                to.number(anchor.fraction);
            }
        }
        to.count(self.skeleton.bones.len());
        for bone in &self.skeleton.bones {
            to.varint(bone.handle);
            to.varint(bone.segment);
            bone.rest.iter().for_each(|&end| write_place(end, to));
            bone.joints.iter().for_each(|&joint| to.varint(joint));
            bone.beyond.iter().chain(&bone.beside).for_each(|&number| to.number(number));
        }
    }

    /// Reads the sources of named handles.
    pub(super) fn read(from: &mut Reader<'_>, names: &[String]) -> Result<Self, RigError> {
        let handles: Vec<Handle> = names.iter().map(|name| read_handle(name, from)).collect::<Result<_, _>>()?;
        from.expect(check_handles(&handles).is_ok(), "contain an invalid handle")?;
        let mut joints = Vec::new();
        for _ in 0..from.count(1)? {
            let anchors = (0..from.count(10)?).map(|_| read_anchor(from)).collect::<Result<Vec<_>, _>>()?;
            joints.push(anchors);
        }
        let bones = (0..from.count(68)?).map(|_| read_bone(&handles, from)).collect::<Result<_, _>>()?;
        let skeleton = Skeleton { bones, joints };
        let is_whole = skeleton.is_consistent(handles.len()) && skeleton.fits(&handles);
        from.expect(is_whole, "have bones that do not match their handles")?;
        Ok(Self { handles, skeleton })
    }
}

/// Whether the rotation of a handle depends on other handles; for a bar or polygon, by whole turns.
pub(super) fn turns_by_itself(handle: &Handle) -> bool {
    handle.rotation == Rotation::Auto
}

fn of_point(handle: &Handle) -> Option<Source> {
    let Shape::Point { rest, posed } = handle.shape else { return None };
    let angle = match handle.rotation {
        Rotation::Degrees(degrees) => degrees.to_radians(),
        Rotation::Auto => 0.0,
    };
    Some(Source::new(rest, posed, DVec2::ZERO, Motion::similarity(angle, handle.scale, DVec2::ZERO, handle.depth)))
}

const POINT: u8 = 0;
const BAR: u8 = 1;
const POLYGON: u8 = 2;

fn write_handle(handle: &Handle, to: &mut Writer) {
    let (rest, posed) = (handle.shape.rest(), handle.shape.posed());
    let kind = match handle.shape {
        Shape::Point { .. } => POINT,
        Shape::Bar { .. } => BAR,
        Shape::Polygon { .. } => POLYGON,
    };
    to.byte(kind);
    if kind != POINT {
        to.count(rest.len());
    }
    rest.iter().chain(posed).for_each(|&place| write_place(place, to));
    to.number(match handle.rotation {
        Rotation::Degrees(degrees) => degrees,
        Rotation::Auto => 0.0,
    });
    to.number(handle.scale);
    to.number(handle.depth);
}

fn read_handle(name: &str, from: &mut Reader<'_>) -> Result<Handle, RigError> {
    let kind = from.byte()?;
    from.expect(kind <= POLYGON, "contain a handle of an unknown kind")?;
    let corners = if kind == POINT { 1 } else { from.count(32)? };
    let rest = read_places(corners, from)?;
    let posed = read_places(corners, from)?;
    let shape = match kind {
        POINT => Shape::Point { rest: rest[0], posed: posed[0] },
        BAR => Shape::Bar { rest, posed },
        _ => Shape::Polygon { rest, posed },
    };
    let [rotation, scale, depth] = [from.number()?, from.number()?, from.number()?];
    Ok(Handle { id: name.to_owned(), shape, rotation: rotation.into(), scale, depth, stiffness: 0.0 })
}

fn read_anchor(from: &mut Reader<'_>) -> Result<Anchor, RigError> {
    Ok(Anchor { handle: from.varint()?, segment: from.varint()?, fraction: from.number()? })
}

fn read_bone(handles: &[Handle], from: &mut Reader<'_>) -> Result<Bone, RigError> {
    let (handle, segment) = (from.varint()?, from.varint()?);
    let rest = [read_place(from)?, read_place(from)?];
    let joints = [from.varint()?, from.varint()?];
    let mut pair = || Ok([from.number()?, from.number()?]);
    let (beyond, beside): ([f64; 2], [f64; 2]) = (pair()?, pair()?);
    let are_numbers = rest[0] != rest[1]
        && rest.iter().all(|end| end.is_finite())
        && beyond.iter().chain(&beside).all(|number| number.is_finite());
    from.expect(are_numbers, "contain a bone of zero length")?;
    let of_loop = handles.get(handle as usize).is_some_and(|handle| matches!(handle.shape, Shape::Polygon { .. }));
    Ok(Bone { handle, segment, rest, of_loop, joints, beyond, beside, body: 0 })
}

fn write_place(place: DVec2, to: &mut Writer) {
    to.number(place.x);
    to.number(place.y);
}

fn read_place(from: &mut Reader<'_>) -> Result<DVec2, RigError> {
    Ok(DVec2::new(from.number()?, from.number()?))
}

fn read_places(count: usize, from: &mut Reader<'_>) -> Result<Vec<DVec2>, RigError> {
    (0..count).map(|_| read_place(from)).collect()
}
