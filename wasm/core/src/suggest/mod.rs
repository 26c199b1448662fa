//! Suggests handles for a shape, where an animator would begin.
//!
//! One handle lies in the middle of each part of the domain, and one at the end of each limb. Joints follow at necks
//! and bends, and in the middle of straight limbs, at least a limb's width from other handles. A picture without an
//! outline, such as a photograph, has handles in even rows.
//!
//! - Limbs come from the medial axis, by TEASAR: see `skeleton`.
//! - Names come from the shape and position of limbs: see `figure`.
//! - Long ways are filled by farthest points (Gonzalez, "Clustering to minimize the maximum intercluster distance",
//!   1985), with intrinsic distances.
//!
//! The same domain has the same handles on every platform. A mirrored domain has mirrored handles, within a few cells.
//!
//! Cost: linear in about 120,000 cells for each handle, regardless of the size of the picture.

mod cells;
mod figure;
mod joints;
mod names;
mod placing;
mod skeleton;
mod spread;
mod taken;
#[cfg(test)]
mod tests;

use glam::DVec2;

use self::placing::Place;
use crate::{
    domain::Domain,
    project::Handle,
    rank::{from_top, sort_by_rank},
};

/// A suggested point handle.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct SuggestedHandle {
    /// Its part of a figure, with the side in the picture, as `left-arm-end`, or else its position, as `top-left`.
    /// Unique, and not empty.
    pub id: String,
    /// Its position, in pixels. It is in the domain.
    pub rest: DVec2,
    /// Why it was suggested.
    pub role: SuggestedRole,
}

/// Why a handle is suggested.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum SuggestedRole {
    /// In the middle of a part.
    Middle,
    /// At the end of a limb.
    End,
    /// At a neck or bend, or on a long way.
    Joint,
    /// In a wide part without limbs, or in a picture without an outline.
    Spread,
}

/// Suggests point handles for a domain, from top to bottom.
///
/// Without a `count`, their number follows from the shape: 5 to 14, and fewer only if the domain has no room. With a
/// `count`, there are as many as have room, and at least one.
///
/// ```
/// use c2warp::{domain::Domain, suggest::{SuggestedRole, suggest}};
///
/// let cross = [(40, 0), (60, 0), (60, 40), (100, 40), (100, 60), (60, 60), (60, 100), (40, 100), (40, 60), (0, 60)];
/// let ring = cross.into_iter().chain([(0, 40), (40, 40)]).map(|(x, y)| [f64::from(x), f64::from(y)].into()).collect();
/// let handles = suggest(&Domain::from_rings(&[ring])?, None);
/// let ends: Vec<&str> = handles.iter().filter(|h| h.role == SuggestedRole::End).map(|h| h.id.as_str()).collect();
/// assert_eq!(ends, ["upper-part-end", "left-part-end", "right-part-end", "lower-part-end"]);
/// # Ok::<(), c2warp::Error>(())
/// ```
#[must_use]
pub fn suggest(domain: &Domain, count: Option<usize>) -> Vec<SuggestedHandle> {
    let count = count.map(|count| count.max(1));
    let places = if is_rectangle(domain) { spread::spread(domain, count) } else { placing::places(domain, count, &[]) };
    named(domain, places, &[])
}

/// Suggests point handles beside the existing ones, from top to bottom.
///
/// None of them is near an existing handle, or has an id that reads like an existing one. They are at most 14, and none
/// if every place is near to a handle. Without handles, they are those of [`suggest`].
///
/// ```
/// use c2warp::{domain::Domain, project::Handle, suggest::suggest_beside};
///
/// let there = [Handle::point("eye", [300.0, 55.0])];
/// let picture = [[0, 0], [320, 0], [320, 240], [0, 240]].map(|[x, y]| [f64::from(x), f64::from(y)].into());
/// let suggested = suggest_beside(&Domain::from_rings(&[picture.to_vec()])?, &there);
/// let ids: Vec<&str> = suggested.iter().map(|handle| handle.id.as_str()).collect();
/// assert_eq!(ids, ["top-left", "top", "left", "middle", "right", "bottom-left", "bottom", "bottom-right"]);
/// # Ok::<(), c2warp::Error>(())
/// ```
#[must_use]
pub fn suggest_beside(domain: &Domain, handles: &[Handle]) -> Vec<SuggestedHandle> {
    let places = if is_rectangle(domain) {
        spread::spread_beside(domain, handles)
    } else {
        placing::places(domain, None, handles)
    };
    let taken: Vec<&str> = handles.iter().map(|handle| handle.id.as_str()).collect();
    named(domain, places, &taken)
}

/// Handles at some places, from top to bottom.
fn named(domain: &Domain, mut places: Vec<Place>, taken: &[&str]) -> Vec<SuggestedHandle> {
    let (low, high) = domain.bounds();
    sort_by_rank(&mut places, |place| from_top(place.at));
    let ids = names::ids(&places, low, high, taken);
    let handle = |(Place { at, role, .. }, id)| SuggestedHandle { id, rest: at, role };
    places.into_iter().zip(ids).map(handle).collect()
}

/// Whether a domain is an upright rectangle, such as a whole picture.
fn is_rectangle(domain: &Domain) -> bool {
    let [ring] = domain.rings() else { return false };
    let (low, high) = domain.bounds();
    let is_corner = |p: &DVec2| (p.x == low.x || p.x == high.x) && (p.y == low.y || p.y == high.y);
    ring.len() == 4 && ring.iter().all(is_corner)
}
