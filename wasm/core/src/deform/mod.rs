//! The blended map on the processor (sections III and IV-B, eq. 1): from the motions of all sites to the posed position
//! of every point, and back. The shader `web/src/render/warp.vert.glsl` is the only other implementation.
//!
//! For every point:
//!
//! - `pose`: p′ = Σ w_i(p) T_i(p) (eq. 1), or the rigid blend of `dual`.
//! - `drawing_order`: the triangles from the farthest to the nearest. `crossings`: regions where parts cover each
//!   other.
//! - `locate`, `inverse`: the point of the picture that is drawn at one point, or at many points.
//!
//! For the editor:
//!
//! - `posed_picture`: all of this for one solution, without the solution itself.
//! - `displaced`: the picture after a brush has displaced it.
//! - `layer`: the points under a drawing, all on one layer where the picture covers itself.
//! - `placement`: positions for handles. `hidden`, `lead`: handles behind another part, and parts in front of others.
//! - `folds`, `creases`: flipped triangles and areas.
//! - `way`, `fold_guard`: how far handles can move before the picture folds. `rounding`: the rounding of the editor.
//! - `forcing`, `free_pose`, `unfolding`: the handles that force folds, and the nearest pose without folds.
//! - `reach`, `coverage`, `bounds`, `borders`, `course`: data for overlays and other marks.
//!
//! Cost: a blend visits the supports over each vertex; everything else is linear in the mesh.

mod borders;
mod bounds;
mod course;
mod coverage;
mod creases;
mod crossings;
mod displaced;
mod drawing_order;
mod dual;
mod fold_guard;
mod folds;
mod forcing;
mod free_pose;
mod handle_pose;
mod hidden;
mod inverse;
mod layer;
mod lead;
mod locate;
mod outline;
mod placement;
mod pose;
mod posed_picture;
mod reach;
mod rounding;
mod triangle;
mod unfolding;
mod way;

pub use bounds::Bounds;
pub use creases::Crease;
pub(crate) use crossings::{Adjacency, PosedMesh};
pub(crate) use drawing_order::{DepthOrder, DrawnPose, depths, ranks, satisfies, topological};
pub use fold_guard::FoldLimit;
pub(crate) use folds::FoldingMesh;
pub use handle_pose::HandlePose;
pub(crate) use inverse::rest_points;
pub use lead::Lead;
pub use locate::Correspondence;
pub use pose::{Mapped, Pose};
pub use posed_picture::{PictureMesh, PosedPicture};
pub use unfolding::Unfolded;
pub use way::{GroupMember, GroupTransform, GroupWay, HandleWay, Turn};
