//! The same rig on another picture: all positions of a project are mapped to a picture of another size or crop.
//!
//! - [`Fitter::by_box`] stretches the rectangle of the project's picture to that of the new one, each axis separately.
//!   If both have the same proportions, this is a uniform scale.
//! - [`Fitter::by_alpha`] aligns the outline of the project's picture with that of the new one. It chooses the map with
//!   the greatest overlap from several maps based on boxes and moments: see `alignment`.
//!
//! Point handles outside the new domain move to its nearest point inside, at most [`REACH`] of its size, with their
//! poses and clips. Drawn rings are cut at the borders of the new picture. The solver ignores parts of bars and
//! polygons outside.
//!
//! Positions are in pixels of the respective picture. Turns in degrees and scales of handles do not change.
//!
//! Cost: an outline for each picture, and a visit of each of its edges for each handle outside.

mod alignment;
mod silhouette;

use glam::DVec2;

use self::silhouette::Silhouette;
use crate::{
    domain::{Domain, contains},
    error::Error,
    limits::HELD_CLEARANCE,
    picture::Picture,
    project::{DomainSpec, Project, Shape},
    segment::nearest_on_segment,
    solve_input::check_picture,
};

/// The maximum distance that a handle is moved into a new outline, as a fraction of the diagonal of the outline's box.
pub const REACH: f64 = 0.05;

/// Fits a project to other pictures.
///
/// ```
/// use c2warp::{Picture, fit::Fitter, project::{Handle, Project}};
///
/// let project = Project::for_picture(40, 30).with_handles([Handle::point("hand", [10.0, 15.0])]);
/// let rgba = vec![255; 80 * 60 * 4];
/// let fitted = Fitter::by_box(project).fit(&Picture::new(80, 60, &rgba)?)?;
/// assert_eq!(fitted.project.handles, [Handle::point("hand", [20.0, 30.0])]);
/// assert!(fitted.moved.is_empty());
/// # Ok::<(), c2warp::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Fitter {
    project: Project,
    /// The outline to align, or `None` to fit the rectangle of the picture.
    outline: Option<Silhouette>,
}

/// A project for another picture. The file name of its picture is empty.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Fitted {
    /// The project with all positions in pixels of the new picture.
    pub project: Project,
    /// Handles that were moved because they would be outside the domain.
    pub moved: Vec<MovedHandle>,
}

/// A handle that was moved into the domain.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct MovedHandle {
    /// The id of the handle.
    pub id: String,
    /// How far it was moved, in pixels of the new picture.
    pub distance: f64,
}

impl Fitter {
    /// Fits the rectangle of the project's picture to that of others. The picture itself is not needed.
    #[must_use]
    pub fn by_box(project: Project) -> Self {
        Self { project, outline: None }
    }

    /// Fits the outline of the project's picture to that of others.
    ///
    /// The outline has the threshold of the project's domain. A drawn domain moves with the outline of its picture.
    ///
    /// # Errors
    /// - [`Error::PictureMismatch`] if this is not the picture of the project.
    /// - [`Error::NoOutline`] for a picture without transparency.
    /// - The errors of [`Domain::from_alpha`].
    pub fn by_alpha(project: Project, picture: &Picture<'_>) -> Result<Self, Error> {
        check_picture(project.image.size(), picture)?;
        let outline = Some(silhouette(&project, picture)?);
        Ok(Self { project, outline })
    }

    /// The project for a picture.
    ///
    /// # Errors
    /// - [`Error::Project`] if [`Project::check`] fails.
    /// - [`Error::NoOutline`] for a picture without transparency, if outlines are aligned.
    /// - [`Error::HandleFarOutside`] for a handle that would have to be moved too far.
    /// - The errors of [`Domain::new`].
    pub fn fit(&self, picture: &Picture<'_>) -> Result<Fitted, Error> {
        self.project.check()?;
        let map = match &self.outline {
            Some(outline) => alignment::best(outline, &silhouette(&self.project, picture)?),
            None => alignment::of_rectangles(self.project.image.size(), picture.size()),
        };
        let mut project = self.project.mapped(&map, picture.size());
        cut_rings(&mut project, picture.size());
        let domain = Domain::bounded(project.domain.as_ref(), picture, project.fix_boundary)?;
        let moved = move_inside(&mut project, &domain)?;
        Ok(Fitted { project, moved })
    }
}

fn silhouette(project: &Project, picture: &Picture<'_>) -> Result<Silhouette, Error> {
    if !picture.has_transparency() {
        return Err(Error::NoOutline);
    }
    let threshold = match project.domain {
        Some(DomainSpec::Alpha { threshold }) => threshold,
        _ => DomainSpec::THRESHOLD,
    };
    Ok(Silhouette::new(&Domain::from_alpha(picture, threshold)?))
}

/// Cuts drawn rings at the borders of the picture. Corners that coincide afterwards are merged.
fn cut_rings(project: &mut Project, (width, height): (u32, u32)) {
    let corner = DVec2::new(f64::from(width), f64::from(height));
    if let Some(DomainSpec::Polygon { rings, .. }) = &mut project.domain {
        for ring in rings {
            ring.iter_mut().for_each(|p| *p = p.clamp(DVec2::ZERO, corner));
            ring.dedup();
            while ring.len() > 3 && ring.first() == ring.last() {
                ring.pop();
            }
        }
    }
}

/// Moves point handles outside a domain to its nearest point inside.
fn move_inside(project: &mut Project, domain: &Domain) -> Result<Vec<MovedHandle>, Error> {
    let (low, high) = domain.bounds();
    let most = REACH * low.distance(high);
    let mut moved = Vec::new();
    for index in 0..project.handles.len() {
        let Shape::Point { rest, .. } = project.handles[index].shape else { continue };
        let (inside, distance) = nearest_inside(domain, rest);
        // A point on the outline belongs to the domain.
        if distance == 0.0 {
            continue;
        }
        let id = project.handles[index].id.clone();
        if distance > most {
            return Err(Error::HandleFarOutside { id, distance, most });
        }
        project.move_handle(index, inside - rest);
        moved.push(MovedHandle { id, distance: rest.distance(inside) });
    }
    Ok(moved)
}

/// The nearest point inside a domain, and how far `p` is outside: 0 for a point of the domain.
fn nearest_inside(domain: &Domain, p: DVec2) -> (DVec2, f64) {
    let is_inside = |p: DVec2| domain.rings().iter().filter(|ring| contains(ring, p)).count() % 2 == 1;
    if is_inside(p) {
        return (p, 0.0);
    }
    let on_edges = domain.edges().map(|(a, b)| nearest_on_segment(p, a, b));
    let nearer = |best: DVec2, q: DVec2| if p.distance_squared(q) < p.distance_squared(best) { q } else { best };
    let nearest = on_edges.fold(DVec2::INFINITY, nearer);
    let distance = p.distance(nearest);
    // A little beyond the outline: a handle on it would be refused by its rounding, or by a held boundary.
    let inwards = (nearest - p).normalize_or_zero();
    let steps = (0..12).map(|halvings| nearest + inwards * (2.0 * HELD_CLEARANCE / f64::from(1 << halvings)));
    (steps.into_iter().find(|&q| is_inside(q)).unwrap_or(nearest), distance)
}

#[cfg(test)]
mod tests;
