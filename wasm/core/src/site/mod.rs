//! Sites: the origins h_i of real handles, and the virtual ones that Algorithm 1 adds (paper, sections III-B and IV-A).

mod cells;
mod contacts;
mod farthest;
mod graph;
mod marks;
mod piece;
mod regions;
mod summit;
mod tessellation;
mod virtual_sites;

use glam::DVec2;
use serde::{Deserialize, Serialize};

use crate::distance::{DistanceField, Place};

pub use graph::SiteGraph;
pub(crate) use regions::{Obstacles, Regions};
pub(crate) use virtual_sites::{allowed_score, insert_virtual_sites, score};

/// Sites closer than this, in pixels, count as one spot.
pub const MIN_SEPARATION: f64 = 0.01;
/// Most handles in one solve.
pub const MAX_HANDLES: usize = 1000;
/// Most sites, real and virtual, in one solve.
pub const MAX_SITES: usize = 8192;

/// A cell may be larger than its site's separation by this factor, where no real site is in the way. See
/// [`Site::reach_limit`].
const GRADING: f64 = 1.7;
/// A cell in a nook may reach this much farther than bones are clear of its site. See [`Site::in_nook`].
const INTO_NOOK: f64 = 1.1;

/// What a site is there for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Origin {
    /// A point handle.
    Point {
        /// Its index in the project.
        handle: u32,
    },
    /// A bar or polygon handle: one of the places that stand for a straight piece of it.
    Bone {
        /// Its index in the project.
        handle: u32,
        /// Number of the piece.
        bone: u32,
    },
    /// The outline, where the project holds it.
    Boundary,
    /// Algorithm 1.
    Virtual,
}

impl Origin {
    /// Whether the site moves as the person says, and not as its neighbours do.
    #[must_use]
    pub fn is_real(self) -> bool {
        self != Self::Virtual
    }

    /// The project's handle that it belongs to.
    #[must_use]
    pub fn handle(self) -> Option<usize> {
        match self {
            Self::Point { handle } | Self::Bone { handle, .. } => Some(handle as usize),
            Self::Boundary | Self::Virtual => None,
        }
    }
}

/// A site with its cell. Lengths in pixels.
///
/// The sites of connected bones, and those of a held outline, are one body: they may reach over one another, and for them
/// others are only those outside it.
#[derive(Debug, Clone)]
pub struct Site {
    /// h_i, at rest.
    pub rest: DVec2,
    /// What it is there for.
    pub origin: Origin,
    /// Distance to the nearest other site or bone, r_h; infinite where an island has no other.
    pub separation: f64,
    /// Distance to the nearest other point handle, bone or held outline; infinite where there is none.
    pub clearance: f64,
    /// Distance to the farthest point of the cell, r_d.
    pub cell_radius: f64,
    /// Where φ reaches zero, r_i.
    pub support_radius: f64,
    /// Whether it is of no body and stands close between two bones that meet at a shallow angle.
    ///
    /// Its support is clear of both. Towards their joint sites of theirs end its cell, and however many those are, the cell
    /// reaches as far as the support, about: with a margin, virtual sites would follow one another into the joint without end. So
    /// the cell may reach a little farther. Supports of the two bones cover what is left, as they may reach over one another.
    pub(crate) in_nook: bool,
    pub(crate) island: usize,
    pub(crate) place: Place,
    pub(crate) field: DistanceField,
}

impl Site {
    /// How far the site's support may reach, and so, how large its cell may be.
    ///
    /// The paper's condition (3) asks for r_d ≤ r_h: a support covers its cell and stays clear of every other site. Met by
    /// Algorithm 1 to the letter, it makes all cells alike: two handles 10 px apart on a picture of 1,000 px draw 1,000
    /// virtual sites after them, and two 5 px apart more than 20,000. But interpolation is owed to real handles only. So
    /// supports must stay clear of real sites, and may reach over virtual ones by a factor of [`GRADING`]. As the sites that
    /// Algorithm 1 inserts are then farther apart than those that ask for them, by that factor, cells grow with the distance
    /// from a close pair and their number with the logarithm of the gap (as in Ruppert's Delaunay refinement, 1995).
    pub(crate) fn reach_limit(&self) -> f64 {
        let clearance = if self.in_nook { INTO_NOOK * self.clearance } else { self.clearance };
        (GRADING * self.separation).min(clearance)
    }
}
