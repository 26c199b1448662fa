//! Triangle meshes: constrained Delaunay triangulation, insertion of vertices, and point location.

mod delaunay;
mod insertion;
mod locate;
mod mesh;

pub(crate) use insertion::Inserted;
pub(crate) use locate::{Locator, OUTLINE_TOLERANCE, signed_depth};
pub(crate) use mesh::{NONE, Triangulation};
