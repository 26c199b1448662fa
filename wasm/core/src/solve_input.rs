//! The part of a project that a solve depends on, and the checks of its handles.
//!
//! Cost: O(n log n) in the point handles, plus a visit of every bone for each; for bars and polygons see `bone`.

use std::sync::Arc;

use glam::DVec2;

use crate::{
    bone::{OutsidePart, Polyline, Skeleton},
    error::Error,
    grid::Grid,
    limits::{
        HELD_CLEARANCE, MAX_CLOSE_HANDLES, MAX_HANDLES, MAX_HELD_CORNERS, MAX_OUTLINE_LENGTH, MAX_POSED, MAX_SITES,
        MIN_SEPARATION,
    },
    picture::Picture,
    pose::{DisplacementField, SolvedHandle, StiffnessField, picture_size},
    prepared_domain::PreparedDomain,
    project::{Handle, LooseParts, PoseMode, Project, Shape, ShapeKind, Weighting},
    rank::{from_top, sort_by_rank},
    site::{PointSite, sharp_corners},
};

/// Handles closer than this, in pixels, are rejected: [`MIN_SEPARATION`] minus a tolerance, so that handles at exactly
/// that distance pass.
const MIN_HANDLE_DISTANCE: f64 = MIN_SEPARATION - 1e-9;

/// Everything that a solve depends on, apart from picture and domain. It does not include the pose of the handles.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SolveInput {
    pub(crate) samples: usize,
    pub(crate) density: usize,
    pub(crate) mode: PoseMode,
    pub(crate) weighting: Weighting,
    pub(crate) fix_boundary: bool,
    pub(crate) loose_parts: LooseParts,
    /// The stiffness of the picture. It is zero in the harmonic mode, which has no energy.
    pub(crate) stiffness: StiffnessField,
    /// Width and height of the picture.
    pub(crate) picture: DVec2,
    /// The displacement before posing; `None` if nothing is displaced.
    pub(crate) displacement: Option<Arc<DisplacementField>>,
    /// The handles of all kinds, in the order of the project.
    pub(crate) handles: Vec<SolvedHandle>,
    points: Vec<PointHandle>,
    /// The bars and polygons.
    pub(crate) polylines: Vec<Polyline>,
}

/// A point handle at rest.
#[derive(Debug, Clone, PartialEq)]
struct PointHandle {
    /// Index of the handle in the project.
    handle: u32,
    id: String,
    rest: DVec2,
}

/// The handles at rest, located in the domain and checked.
#[derive(Debug)]
pub(crate) struct LocatedHandles {
    /// Point handles from top to bottom, so that the result does not depend on their order in the project.
    pub(crate) points: Vec<PointSite>,
    /// The bones of bars and polygons.
    pub(crate) skeleton: Skeleton,
    /// Parts of bars and polygons outside the domain.
    pub(crate) outside: Vec<OutsidePart>,
}

impl LocatedHandles {
    /// Rest positions of the point handles.
    pub(crate) fn point_positions(&self) -> Vec<DVec2> {
        self.points.iter().map(|point| point.rest).collect()
    }

    /// Rest positions of the bones, by their ends.
    pub(crate) fn bone_positions(&self) -> Vec<[DVec2; 2]> {
        self.skeleton.bones.iter().map(|bone| bone.rest).collect()
    }
}

impl SolveInput {
    /// # Errors
    /// - [`Error::Project`] if [`Project::check`] fails.
    /// - [`Error::TooManyHandles`].
    /// - [`Error::TooManyCorners`] if bars and polygons have more segments than the limit of sites, because each needs
    ///   a site.
    /// - [`Error::PoseNotFinite`] for a pose that no solution accepts.
    pub(crate) fn new(project: &Project) -> Result<Self, Error> {
        project.check()?;
        if let Some(handle) = project.handles.get(MAX_HANDLES) {
            return Err(Error::TooManyHandles { count: project.handles.len(), id: handle.id.clone() });
        }
        if let Some(handle) = project.handles.iter().find(|handle| !is_posed_in_bounds(handle)) {
            return Err(Error::PoseNotFinite { id: handle.id.clone() });
        }
        let (mut points, mut polylines) = (Vec::new(), Vec::new());
        for (at, handle) in project.handles.iter().enumerate() {
            let (at, id) = (at as u32, handle.id.clone());
            let polyline =
                |corners: &[DVec2], closed| Polyline { handle: at, id: id.clone(), corners: corners.to_vec(), closed };
            match &handle.shape {
                Shape::Point { rest, .. } => points.push(PointHandle { handle: at, id, rest: *rest }),
                Shape::Bar { rest, .. } => polylines.push(polyline(rest, false)),
                Shape::Polygon { rest, .. } => polylines.push(polyline(rest, true)),
            }
        }
        check_segments(&polylines)?;
        let solved = |handle: &Handle| SolvedHandle { id: handle.id.clone(), shape: ShapeKind::of(&handle.shape)[0] };
        Ok(Self {
            samples: project.samples as usize,
            density: project.pose.density as usize,
            mode: project.pose.mode,
            weighting: project.weighting.clone(),
            fix_boundary: project.fix_boundary,
            loose_parts: project.loose_parts,
            stiffness: match project.pose.mode {
                PoseMode::Harmonic => StiffnessField::default(),
                PoseMode::Rigid => StiffnessField::new(project),
            },
            picture: picture_size(project),
            displacement: DisplacementField::of(project).map(Arc::new),
            handles: project.handles.iter().map(solved).collect(),
            points,
            polylines,
        })
    }

    /// Whether the solutions of two inputs differ only in their posers: in stiffness or displacement.
    pub(crate) fn differs_only_in_poser(&self, other: &Self) -> bool {
        let (stiffness, displacement) = (other.stiffness.clone(), other.displacement.clone());
        self != other && Self { stiffness, displacement, ..self.clone() } == *other
    }

    /// Locates the handles in a domain and cuts bars and polygons into bones.
    ///
    /// # Errors
    /// [`Error::OutlineTooLong`], [`Error::HandleOutside`], [`Error::HandlesTooClose`], [`Error::HandlesCrowded`],
    /// [`Error::OnHeldBoundary`], [`Error::HeldTooFine`], [`Error::BarTooShort`], [`Error::BarsOverlap`],
    /// [`Error::TooManySites`].
    pub(crate) fn locate(&self, prepared: &PreparedDomain) -> Result<LocatedHandles, Error> {
        let PreparedDomain { domain, navigation, .. } = prepared;
        let (low, high) = domain.bounds();
        let diagonal = low.distance(high);
        let (length, max) = (domain.perimeter(), MAX_OUTLINE_LENGTH * diagonal);
        if length > max {
            return Err(Error::OutlineTooLong { length, max });
        }
        let site = |point: &PointHandle| {
            let (triangle, rest) = navigation.locate(point.rest).ok_or_else(|| point.outside())?;
            Ok(PointSite { rest, triangle, handle: point.handle })
        };
        let mut points = self.points.iter().map(site).collect::<Result<Vec<_>, Error>>()?;
        sort_by_rank(&mut points, |point| from_top(point.rest));
        self.check_distances(&points.iter().map(|point| (point.rest, point.handle)).collect::<Vec<_>>())?;
        self.check_crowding(&points, diagonal)?;
        if self.fix_boundary {
            let corners = domain.rings().iter().map(|ring| sharp_corners(ring).count()).sum();
            if corners > MAX_HELD_CORNERS {
                return Err(Error::HeldTooFine { corners });
            }
            let on_boundary = |point: &&PointHandle| domain.distance_to_outline(point.rest) < HELD_CLEARANCE;
            if let Some(point) = self.points.iter().find(on_boundary) {
                return Err(Error::OnHeldBoundary { id: point.id.clone() });
            }
        }
        let (skeleton, outside) = Skeleton::new(&self.polylines, domain, navigation, self.fix_boundary)?;
        // Each bone has a site.
        if points.len() + skeleton.bones.len() > MAX_SITES {
            return Err(Error::TooManySites);
        }
        self.check_distances_to_bones(&skeleton)?;
        Ok(LocatedHandles { points, skeleton, outside })
    }

    /// The positions and indices of the point handles from top to bottom, for a domain that is not a
    /// [`PreparedDomain`].
    ///
    /// # Errors
    /// [`Error::HandleOutside`], [`Error::HandlesTooClose`].
    #[cfg(feature = "cloud")]
    pub(crate) fn points_inside(&self, contains: impl Fn(DVec2) -> bool) -> Result<Vec<(DVec2, u32)>, Error> {
        if let Some(point) = self.points.iter().find(|point| !contains(point.rest)) {
            return Err(point.outside());
        }
        let mut points: Vec<(DVec2, u32)> = self.points.iter().map(|point| (point.rest, point.handle)).collect();
        sort_by_rank(&mut points, |&(rest, _)| from_top(rest));
        self.check_distances(&points)?;
        Ok(points)
    }

    /// Rejects point handles that are too close to each other. `points` are their positions and indices, from top to
    /// bottom.
    fn check_distances(&self, points: &[(DVec2, u32)]) -> Result<(), Error> {
        for (at, &(one, handle)) in points.iter().enumerate() {
            for &(other, other_handle) in points[at + 1..].iter().take_while(|(p, _)| p.y - one.y < MIN_SEPARATION) {
                let distance = one.distance(other);
                if distance < MIN_HANDLE_DISTANCE {
                    let id = |handle: u32| self.handles[handle as usize].id.clone();
                    let (first, second) = (id(handle.min(other_handle)), id(handle.max(other_handle)));
                    return Err(Error::HandlesTooClose { first, second, distance });
                }
            }
        }
        Ok(())
    }

    /// Rejects more than [`MAX_CLOSE_HANDLES`] point handles that are close to another handle.
    fn check_crowding(&self, points: &[PointSite], diagonal: f64) -> Result<(), Error> {
        for (share, max) in MAX_CLOSE_HANDLES {
            let within = share * diagonal;
            let grid = Grid::new(within, points.iter().enumerate().map(|(at, point)| (point.rest, at)));
            let is_close = |(at, point): &(usize, &PointSite)| {
                grid.around(point.rest, within)
                    .any(|other| other != *at && points[other].rest.distance(point.rest) < within)
            };
            let close: Vec<u32> = points.iter().enumerate().filter(is_close).map(|(_, point)| point.handle).collect();
            if let Some(&first) = close.iter().min().filter(|_| close.len() > max) {
                let id = self.handles[first as usize].id.clone();
                return Err(Error::HandlesCrowded { count: close.len(), within, max, id });
            }
        }
        Ok(())
    }

    /// Rejects point handles that are too close to a bone.
    fn check_distances_to_bones(&self, skeleton: &Skeleton) -> Result<(), Error> {
        for point in &self.points {
            for bone in &skeleton.bones {
                let distance = bone.distance(point.rest);
                if distance < MIN_HANDLE_DISTANCE {
                    let second = self.handles[bone.handle as usize].id.clone();
                    return Err(Error::HandlesTooClose { first: point.id.clone(), second, distance });
                }
            }
        }
        Ok(())
    }

    /// Numbers of point handles, bars and polygons.
    pub(crate) fn handle_counts(&self) -> [usize; 3] {
        let polygons = self.polylines.iter().filter(|polyline| polyline.closed).count();
        [self.points.len(), self.polylines.len() - polygons, polygons]
    }
}

impl PointHandle {
    fn outside(&self) -> Error {
        Error::HandleOutside { id: self.id.clone(), x: self.rest.x, y: self.rest.y }
    }
}

/// Whether all numbers of a pose are small enough for a solution. A solution may reject further poses of bars.
fn is_posed_in_bounds(handle: &Handle) -> bool {
    let coordinates = handle.shape.posed().iter().flat_map(DVec2::to_array);
    coordinates.chain([handle.scale, handle.depth]).all(|number| number.abs() <= MAX_POSED)
}

/// Rejects bars and polygons with more segments than the limit of sites. Names the handle with the most.
fn check_segments(polylines: &[Polyline]) -> Result<(), Error> {
    let segments: usize = polylines.iter().map(Polyline::segments).sum();
    if segments <= MAX_SITES {
        return Ok(());
    }
    let longest =
        polylines.iter().reduce(|longest, one| if one.segments() > longest.segments() { one } else { longest });
    let Polyline { id, corners, .. } = longest.expect("segments are pieces of polylines");
    Err(Error::TooManyCorners { id: id.clone(), corners: corners.len(), segments })
}

/// # Errors
/// [`Error::PictureMismatch`] if a picture does not have the size that a project is for.
pub(crate) fn check_picture((project_width, project_height): (u32, u32), picture: &Picture) -> Result<(), Error> {
    let (width, height) = picture.size();
    if (project_width, project_height) == (width, height) {
        return Ok(());
    }
    Err(Error::PictureMismatch { project_width, project_height, width, height })
}
