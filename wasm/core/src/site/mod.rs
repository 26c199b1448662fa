//! Sites: the origins h_i of real handles and the virtual handles that Algorithm 1 inserts (sections III-B and IV-A).
//!
//! In the order of their imports:
//!
//! - `cells`: 𝒱(h_i), the coarse samples nearest to each site.
//! - `voronoi`: the sites inserted so far, with their distance fields and cells.
//! - `obstacles`: the bones and the held outline that supports must not reach.
//! - `room`: the separation r_h and the clearance of each site.
//! - `farthest`: the farthest points of a cell, at distance r_d.
//! - `inserter`: inserts one site and updates all of the above.
//! - `chain`, `tessellation`: sites along bars and a held outline (section V-D).
//! - `contacts`: points where the cells of two handles meet.
//! - `round`: a round of Algorithm 1, for a replay.
//! - `virtual_sites`: Algorithm 1.
//! - `graph`: the cell graph (section IV-B).

mod cells;
mod chain;
mod contacts;
mod farthest;
mod graph;
mod inserter;
mod obstacles;
mod room;
mod round;
mod tessellation;
mod virtual_sites;
mod visit_stamps;
mod voronoi;

use glam::DVec2;

use crate::distance::{DistanceField, NavTriangle};

pub(crate) use chain::sharp_corners;
pub(crate) use graph::SiteGraph;
pub(crate) use inserter::{Partition, SiteInserter};
pub(crate) use obstacles::Obstacles;
pub use round::{Round, RoundPoint};
pub(crate) use tessellation::Tessellation;
pub(crate) use virtual_sites::{allowed_score, insert_virtual_sites, score};

/// Scores and radii with a smaller relative difference are tied. Rounding errors are far smaller, and differences
/// between handles far greater.
const TIE: f64 = 1e-9;

/// Greatest cell radius relative to its site's separation, if no real site limits it. See [`Site::reach_limit`].
const GRADING: f64 = 1.7;
/// Greatest cell radius in an acute joint, relative to the clearance of its site. See [`Site::in_acute_joint`].
const ACUTE_JOINT_GRADING: f64 = 1.1;

/// Greatest radius of a C² support, relative to the distance up to which shortest paths are unique. A path around the
/// other side of a hole is then longer by at least 10 % of the support's radius.
const UNIQUE: f64 = 0.95;

/// The kind of a site, with the handle that it belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "poser-bytes", derive(serde::Serialize, serde::Deserialize))]
pub enum SiteKind {
    /// A point handle.
    Point {
        /// Its index in the project.
        handle: u32,
    },
    /// One of the sites along a bone, a straight piece of a bar or polygon handle.
    Bone {
        /// Index of the handle in the project.
        handle: u32,
        /// Index of the bone.
        bone: u32,
    },
    /// One of the sites along the outline, if the project fixes it.
    Boundary,
    /// Inserted by Algorithm 1.
    Virtual,
}

impl SiteKind {
    /// Whether the handles set the site's motion: every kind but the virtual one.
    #[must_use]
    pub fn is_real(self) -> bool {
        self != Self::Virtual
    }

    /// Index of the site's handle in the project; `None` for boundary and virtual sites.
    #[must_use]
    pub fn handle(self) -> Option<usize> {
        match self {
            Self::Point { handle } | Self::Bone { handle, .. } => Some(handle as usize),
            Self::Boundary | Self::Virtual => None,
        }
    }

    /// One number for the kind: the index of the handle, −1 for a virtual site, −2 for a site of a held boundary.
    #[must_use]
    pub fn handle_code(self) -> i32 {
        match self {
            Self::Point { handle } | Self::Bone { handle, .. } => handle as i32,
            Self::Virtual => -1,
            Self::Boundary => -2,
        }
    }
}

/// The site of a point handle, located in the domain.
#[derive(Debug)]
pub(crate) struct PointSite {
    pub(crate) rest: DVec2,
    pub(crate) triangle: NavTriangle,
    /// Index of the handle in the project.
    pub(crate) handle: u32,
}

/// A site with the sizes of its cell and its support, in pixels.
///
/// The sites of connected bones form a body, and so do those of a held outline. Supports within a body may overlap. So
/// the "other" sites and bones of the fields below are those outside the body.
#[derive(Debug, Clone)]
pub struct Site {
    /// h_i: the rest position.
    pub rest: DVec2,
    /// Its kind.
    pub kind: SiteKind,
    /// r_h: distance to the nearest other site or bone; infinite if the island has no other.
    pub separation: f64,
    /// Distance to the nearest other point handle, bone or held outline; infinite if the island has none.
    pub clearance: f64,
    /// Distance that the support may not exceed, so that shortest paths in it are unique. It is infinite if the weights
    /// need not be C², and if no hole lies within reach.
    pub unique_reach: f64,
    /// r_d: distance to the farthest point of the cell.
    pub cell_radius: f64,
    /// A farthest point of the cell, at that distance.
    pub farthest: DVec2,
    /// r_i: the distance at which φ reaches zero.
    pub support_radius: f64,
    /// Within this distance a point handle takes a share of the weight of others, if the outline is held. 0 for other
    /// sites.
    pub(crate) precedence_radius: f64,
    /// Whether the site has no body and lies close to two bones that meet at an acute angle, between them. The sides of
    /// a sharp corner of a held outline count as bones, too.
    ///
    /// Its support must not reach either bone. Towards the joint the cell ends at the bones' sites. Regardless of their
    /// number, the cell extends about as far as the support may. If the cell needed a margin there, Algorithm 1 would
    /// insert sites towards the joint endlessly. So the cell may extend slightly beyond the support. The supports of
    /// the two bones may overlap and cover the rest.
    pub(crate) in_acute_joint: bool,
}

impl Site {
    /// The greatest allowed radius of the site's support, and thus of its cell.
    ///
    /// The paper's condition r_d ≤ r_h (eq. 3) makes a support cover its cell and end before every other site. If
    /// Algorithm 1 enforced it exactly, all cells would have similar sizes. On a picture of 1,000 px, two handles 10 px
    /// apart would then cause 1,000 virtual sites. At 5 px, they would cause more than 20,000.
    ///
    /// But only real handles need interpolation. So a support must end before real sites, and may extend over virtual
    /// ones by a factor of [`GRADING`]. The gaps between inserted sites then grow by that factor. Cells grow with the
    /// distance from a close pair, and their number grows with the logarithm of the gap, as in Ruppert's Delaunay
    /// refinement (1995).
    pub(crate) fn reach_limit(&self) -> f64 {
        let clearance = if self.in_acute_joint { ACUTE_JOINT_GRADING * self.clearance } else { self.clearance };
        (GRADING * self.separation).min(clearance).min(self.unique_reach)
    }
}

/// The distance field of a site and the location of its source.
#[derive(Debug, Clone)]
pub(crate) struct SiteField {
    pub(crate) island: usize,
    /// The triangle of the navigation mesh that contains the site.
    pub(crate) triangle: NavTriangle,
    pub(crate) distances: DistanceField,
}

impl SiteField {
    /// Intrinsic distance from the site to a point; infinite beyond the field's bound.
    pub(crate) fn distance(&self, triangle: NavTriangle, p: DVec2) -> f64 {
        self.distances.distance(triangle, p)
    }
}
