//! The part of a project that a solve depends on, and its checks.

use glam::DVec2;

use crate::{
    bone::{Line, Outside, Skeleton},
    distance::NavTriangle,
    error::Error,
    limits::{HELD_CLEARANCE, MAX_HANDLES, MAX_SITES, MIN_SEPARATION},
    picture::Picture,
    pose::SolvedHandle,
    prepared_domain::PreparedDomain,
    project::{Form, Handle, PoseMode, Project, Shape, Weighting},
    site::PointSite,
};

/// Handles closer than this, in pixels, are refused: [`MIN_SEPARATION`] less a tolerance, so that handles exactly that far
/// apart pass.
const MIN_HANDLE_DISTANCE: f64 = MIN_SEPARATION - 1e-9;

/// Everything a solve depends on: not where the handles are posed.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Request {
    pub(crate) samples: usize,
    pub(crate) density: usize,
    pub(crate) mode: PoseMode,
    pub(crate) weighting: Weighting,
    pub(crate) fix_boundary: bool,
    /// The handles of all kinds.
    pub(crate) handles: Vec<SolvedHandle>,
    points: Vec<PointHandle>,
    lines: Vec<Line>,
}

#[derive(Debug, Clone, PartialEq)]
struct PointHandle {
    handle: u32,
    id: String,
    rest: DVec2,
}

/// The rest places of all handles in the domain, checked.
#[derive(Debug)]
pub(crate) struct Rest<P = NavTriangle> {
    /// Point handles from top to bottom, so that the result does not depend on their order in the project.
    pub(crate) points: Vec<PointSite<P>>,
    pub(crate) skeleton: Skeleton,
    /// Parts of lines outside the domain.
    pub(crate) outside: Vec<Outside>,
}

impl Rest {
    /// Rest places of the point handles.
    pub(crate) fn sites(&self) -> Vec<DVec2> {
        self.points.iter().map(|point| point.rest).collect()
    }

    /// Rest places of the bones.
    pub(crate) fn bones(&self) -> Vec<[DVec2; 2]> {
        self.skeleton.bones.iter().map(|bone| bone.rest).collect()
    }
}

impl Request {
    /// # Errors
    /// [`Error::Project`] for what [`Project::check`] refuses; [`Error::TooManyHandles`]; [`Error::TooManyCorners`] where bars and
    /// polygons have more straight pieces than there may be sites, as each piece needs one.
    pub(crate) fn new(project: &Project) -> Result<Self, Error> {
        project.check()?;
        if let Some(handle) = project.handles.get(MAX_HANDLES) {
            return Err(Error::TooManyHandles { count: project.handles.len(), id: handle.id.clone() });
        }
        let (mut points, mut lines) = (Vec::new(), Vec::new());
        for (at, handle) in project.handles.iter().enumerate() {
            let (at, id) = (at as u32, handle.id.clone());
            let line =
                |corners: &[DVec2], closed| Line { handle: at, id: id.clone(), corners: corners.to_vec(), closed };
            match &handle.shape {
                Shape::Point { rest, .. } => points.push(PointHandle { handle: at, id, rest: *rest }),
                Shape::Bar { rest, .. } => lines.push(line(rest, false)),
                Shape::Polygon { rest, .. } => lines.push(line(rest, true)),
            }
        }
        let segments: usize = lines.iter().map(Line::segments).sum();
        if segments > MAX_SITES {
            let longest =
                lines.iter().reduce(|longest, line| if line.segments() > longest.segments() { line } else { longest });
            let Line { id, corners, .. } = longest.expect("segments are pieces of lines");
            return Err(Error::TooManyCorners { id: id.clone(), corners: corners.len(), segments });
        }
        let solved = |handle: &Handle| SolvedHandle { id: handle.id.clone(), form: Form::of(&handle.shape)[0] };
        Ok(Self {
            samples: project.samples as usize,
            density: project.pose.density as usize,
            mode: project.pose.mode,
            weighting: project.weighting.clone(),
            fix_boundary: project.fix_boundary,
            handles: project.handles.iter().map(solved).collect(),
            points,
            lines,
        })
    }

    /// Locates the handles in a domain and cuts lines into bones.
    ///
    /// # Errors
    /// [`Error::HandleOutside`], [`Error::HandlesTooClose`], [`Error::OnHeldBoundary`], [`Error::BarTooShort`],
    /// [`Error::BarsOverlap`].
    pub(crate) fn rest(&self, prepared: &PreparedDomain) -> Result<Rest, Error> {
        let navigation = &prepared.navigation;
        let mut rest = self.points_at(|p| navigation.locate(p))?;
        if self.fix_boundary {
            let on_boundary = |point: &&PointHandle| prepared.domain.distance_to_outline(point.rest) < HELD_CLEARANCE;
            if let Some(point) = self.points.iter().find(on_boundary) {
                return Err(Error::OnHeldBoundary { id: point.id.clone() });
            }
        }
        (rest.skeleton, rest.outside) = Skeleton::new(&self.lines, &prepared.domain, navigation, self.fix_boundary)?;
        for point in &self.points {
            for bone in &rest.skeleton.bones {
                let distance = bone.distance(point.rest);
                if distance < MIN_HANDLE_DISTANCE {
                    let line = self.lines.iter().find(|line| line.handle == bone.handle);
                    let line = line.expect("bones are pieces of lines").id.clone();
                    return Err(Error::HandlesTooClose { first: point.id.clone(), second: line, distance });
                }
            }
        }
        Ok(rest)
    }

    /// Point handles alone. `locate` maps a point to its triangle of the outline and to the point moved into the domain, or to `None` outside.
    ///
    /// # Errors
    /// [`Error::HandleOutside`], [`Error::HandlesTooClose`].
    pub(crate) fn points_at<P>(&self, locate: impl Fn(DVec2) -> Option<(P, DVec2)>) -> Result<Rest<P>, Error> {
        let site = |&PointHandle { handle, ref id, rest }: &PointHandle| {
            let outside = || Error::HandleOutside { id: id.clone(), x: rest.x, y: rest.y };
            let (triangle, inside) = locate(rest).ok_or_else(outside)?;
            Ok(PointSite { rest: inside, triangle, handle })
        };
        let mut points = self.points.iter().map(site).collect::<Result<Vec<_>, Error>>()?;
        points.sort_by(|a, b| a.rest.y.total_cmp(&b.rest.y).then(a.rest.x.total_cmp(&b.rest.x)));
        for (at, one) in points.iter().enumerate() {
            for other in points[at + 1..].iter().take_while(|other| other.rest.y - one.rest.y < MIN_SEPARATION) {
                let distance = one.rest.distance(other.rest);
                if distance < MIN_HANDLE_DISTANCE {
                    let id = |handle: u32| {
                        let known = self.points.iter().find(|point| point.handle == handle);
                        known.expect("a handle of the request").id.clone()
                    };
                    let (first, second) = (id(one.handle.min(other.handle)), id(one.handle.max(other.handle)));
                    return Err(Error::HandlesTooClose { first, second, distance });
                }
            }
        }
        Ok(Rest { points, skeleton: Skeleton::default(), outside: Vec::new() })
    }

    /// Refuses lines and a held boundary, which a bare point cloud cannot have.
    pub(crate) fn check_points_only(&self) -> Result<(), Error> {
        if let Some(line) = self.lines.first() {
            let path = format!("handles[{}].kind", line.handle);
            return Err(unsupported(path, "a bar or polygon on a point cloud, which has no straight lines,"));
        }
        if self.fix_boundary {
            return Err(unsupported("fix_boundary".into(), "the boundary of a point cloud, which has none,"));
        }
        Ok(())
    }

    /// Numbers of point handles, bars and polygons.
    pub(crate) fn kinds(&self) -> [usize; 3] {
        let polygons = self.lines.iter().filter(|line| line.closed).count();
        [self.points.len(), self.lines.len() - polygons, polygons]
    }
}

/// Whether a picture has the size that a project is for.
pub(crate) fn check_picture((project_width, project_height): (u32, u32), picture: &Picture) -> Result<(), Error> {
    let (width, height) = picture.size();
    if (project_width, project_height) == (width, height) {
        return Ok(());
    }
    Err(Error::PictureMismatch { project_width, project_height, width, height })
}

fn unsupported(path: String, feature: &str) -> Error {
    Error::Unsupported { path, feature: feature.into() }
}
