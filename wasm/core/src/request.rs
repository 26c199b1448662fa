//! What a project asks of the solver, and what of it can be solved.

use glam::DVec2;

use crate::{
    distance::Place,
    error::Error,
    picture::Picture,
    project::{Blend, PoseMode, Project, Shape, Weighting},
    site::{MAX_HANDLES, MIN_SEPARATION},
    solver::Outline,
};

/// What is asked for, apart from where the handles are posed.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Request {
    pub(crate) samples: usize,
    pub(crate) density: usize,
    pub(crate) mode: PoseMode,
    pub(crate) weighting: Weighting,
    /// Id and rest place of each handle.
    pub(crate) handles: Vec<(String, DVec2)>,
}

/// A handle's site before it is solved.
pub(crate) struct RealSite<P = Place> {
    pub(crate) handle: usize,
    pub(crate) rest: DVec2,
    pub(crate) place: P,
}

impl Request {
    pub(crate) fn new(project: &Project) -> Result<Self, Error> {
        check_supported(project)?;
        if let Some(handle) = project.handles.get(MAX_HANDLES) {
            return Err(Error::TooManyHandles { count: project.handles.len(), id: handle.id.clone() });
        }
        let rest = |at: usize| match project.handles[at].shape {
            Shape::Point { rest, .. } => Ok(rest),
            Shape::Bar { .. } => Err(unsupported(format!("handles[{at}].kind"), "a bar handle")),
            Shape::Polygon { .. } => Err(unsupported(format!("handles[{at}].kind"), "a polygon handle")),
        };
        let handles = (0..project.handles.len()).map(|at| Ok((project.handles[at].id.clone(), rest(at)?)));
        Ok(Self {
            samples: project.samples as usize,
            density: project.pose.density as usize,
            mode: project.pose.mode,
            weighting: project.weighting.clone(),
            handles: handles.collect::<Result<_, Error>>()?,
        })
    }

    /// The handles' sites from top to bottom, whatever the order of the handles: the result must not depend on it.
    pub(crate) fn real_sites(&self, outline: &Outline) -> Result<Vec<RealSite>, Error> {
        self.sites_at(|p| outline.navigation.place(p))
    }

    /// The same, for what tells the place of a point, or that it lies outside.
    pub(crate) fn sites_at<P>(&self, place: impl Fn(DVec2) -> Option<P>) -> Result<Vec<RealSite<P>>, Error> {
        let site = |(handle, (id, rest)): (usize, &(String, DVec2))| {
            let outside = || Error::HandleOutside { id: id.clone(), x: rest.x, y: rest.y };
            let place = place(*rest).ok_or_else(outside)?;
            Ok(RealSite { handle, rest: *rest, place })
        };
        let mut sites = self.handles.iter().enumerate().map(site).collect::<Result<Vec<_>, Error>>()?;
        sites.sort_by(|a, b| a.rest.y.total_cmp(&b.rest.y).then(a.rest.x.total_cmp(&b.rest.x)));
        for (at, a) in sites.iter().enumerate() {
            for b in sites[at + 1..].iter().take_while(|b| b.rest.y - a.rest.y < MIN_SEPARATION) {
                let distance = a.rest.distance(b.rest);
                if distance < MIN_SEPARATION {
                    let (first, second) = (a.handle.min(b.handle), a.handle.max(b.handle));
                    let id = |handle: usize| self.handles[handle].0.clone();
                    return Err(Error::HandlesTooClose { first: id(first), second: id(second), distance });
                }
            }
        }
        Ok(sites)
    }
}

pub(crate) fn check_size(project: &Project, picture: &Picture) -> Result<(), Error> {
    let image = &project.image;
    if (image.width, image.height) == (picture.width, picture.height) {
        return Ok(());
    }
    Err(Error::PictureMismatch {
        project_width: image.width,
        project_height: image.height,
        width: picture.width,
        height: picture.height,
    })
}

fn check_supported(project: &Project) -> Result<(), Error> {
    if project.fix_boundary {
        return Err(unsupported("fix_boundary".into(), "a held boundary"));
    }
    if project.pose.blend == Blend::Rigid {
        return Err(unsupported("pose.blend".into(), "the rigid blend"));
    }
    if let Some(at) = project.handles.iter().position(|handle| handle.depth != 0.0) {
        return Err(unsupported(format!("handles[{at}].depth"), "a depth"));
    }
    Ok(())
}

fn unsupported(path: String, feature: &str) -> Error {
    Error::Unsupported { path, feature: feature.into() }
}
