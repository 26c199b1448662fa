//! Sites: the locations h_i of real handles, and the virtual sites that Algorithm 1 adds (sections III-B and IV-A).
//!
//! - `virtual_sites`: Algorithm 1. It inserts a site at the `farthest` point of the worst cell; beyond what it needs, also at
//!   `contacts`, where cells of two handles meet.
//! - `regions`: its state, all sites inserted so far, with their fields, their `cells`, and the room that `obstacles` leave them.
//! - `tessellation`: real sites, and those along bars and a held outline (`chain`), as close as their surroundings ask for
//!   (section V-D).
//! - `graph`: the cell graph (section IV-B).

mod cells;
mod chain;
mod contacts;
mod farthest;
mod graph;
mod obstacles;
mod regions;
mod tessellation;
mod virtual_sites;
mod visit_stamps;

use glam::DVec2;
use serde::{Deserialize, Serialize};

use crate::distance::{DistanceField, NavTriangle};

pub(crate) use graph::SiteGraph;
pub(crate) use obstacles::Obstacles;
pub(crate) use regions::Regions;
pub(crate) use virtual_sites::{Scores, allowed_score, insert_virtual_sites, score};

/// Scores and radii that differ by less than this share are tied: far above rounding, far below what anyone places.
const TIE: f64 = 1e-9;

/// Greatest cell radius over its site's separation, where no real site limits it. See [`Site::reach_limit`].
const GRADING: f64 = 1.7;
/// Greatest cell radius in a nook, over the clearance of its site. See [`Site::in_nook`].
const NOOK_GRADING: f64 = 1.1;

/// The kind of a site, with the handle that it belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum SiteKind {
    /// A point handle.
    Point {
        /// Its index in the project.
        handle: u32,
    },
    /// A bar or polygon handle: one of the sites along a straight piece of it.
    Bone {
        /// Its index in the project.
        handle: u32,
        /// Index of the piece.
        bone: u32,
    },
    /// The outline, where the project fixes it.
    Boundary,
    /// Inserted by Algorithm 1.
    Virtual,
}

impl SiteKind {
    /// Whether the handles set the site's motion: not virtual.
    #[must_use]
    pub fn is_real(self) -> bool {
        self != Self::Virtual
    }

    /// Index of the project's handle that the site belongs to.
    #[must_use]
    pub fn handle(self) -> Option<usize> {
        match self {
            Self::Point { handle } | Self::Bone { handle, .. } => Some(handle as usize),
            Self::Boundary | Self::Virtual => None,
        }
    }
}

/// The site of a point handle that is about to be inserted.
#[derive(Debug)]
pub(crate) struct PointSite<P = NavTriangle> {
    pub(crate) rest: DVec2,
    pub(crate) triangle: P,
    /// Index of the handle in the project.
    pub(crate) handle: u32,
}

/// A site with its cell and its support. Lengths in pixels.
///
/// The sites of connected bones are one body, and so are those of a held outline: their supports may overlap one another, and
/// the `other` sites below are those outside the body.
#[derive(Debug, Clone)]
pub struct Site {
    /// h_i: the rest place.
    pub rest: DVec2,
    /// Its kind.
    pub kind: SiteKind,
    /// r_h: distance to the nearest other site or bone; infinite where the island has no other.
    pub separation: f64,
    /// Distance to the nearest other point handle, bone or held outline; infinite where the island has none.
    pub clearance: f64,
    /// r_d: distance to the farthest point of the cell.
    pub cell_radius: f64,
    /// r_i: the distance at which φ reaches zero.
    pub support_radius: f64,
    /// Whether the site belongs to no body and lies between two bones that meet at a shallow angle, close to both.
    ///
    /// Its support keeps clear of both bones. Towards their joint its cell ends at the bones' sites, and however many these
    /// are, the cell reaches about as far as the support: with a margin, Algorithm 1 would insert sites towards the joint
    /// without end. So the cell may reach a little farther. The supports of the two bones, which may overlap, cover the rest.
    pub(crate) in_nook: bool,
    pub(crate) island: usize,
    pub(crate) triangle: NavTriangle,
    pub(crate) field: DistanceField,
}

impl Site {
    /// The greatest radius of the site's support, and so of its cell.
    ///
    /// The paper's condition r_d ≤ r_h (eq. 3) makes a support cover its cell and keep clear of every other site. Met by
    /// Algorithm 1 to the letter, it makes all cells alike: two handles 10 px apart on a picture of 1,000 px cause 1,000
    /// virtual sites, and two 5 px apart more than 20,000. But interpolation is required at real handles only. So supports
    /// must keep clear of real sites, and may reach over virtual ones by a factor of [`GRADING`]. The sites that Algorithm 1
    /// inserts are then farther apart by that factor than those that cause them, so cells grow with the distance from a close
    /// pair, and their number with the logarithm of the gap (as in Ruppert's Delaunay refinement, 1995).
    pub(crate) fn reach_limit(&self) -> f64 {
        let clearance = if self.in_nook { NOOK_GRADING * self.clearance } else { self.clearance };
        (GRADING * self.separation).min(clearance)
    }
}
