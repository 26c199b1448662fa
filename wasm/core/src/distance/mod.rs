//! Intrinsic distance d(p, q): the length of the shortest path inside the domain (section III-A, with f = 1).
//!
//! The domain is flat, so a shortest path is a polyline that bends only at reflex corners of the outline. The distance from a
//! source is therefore, at *any* point, the minimum of `offset + |p − pseudo_source|` over the pseudo-sources (the source
//! itself, or the last corner at which the path bends) that see the point. [`DistanceField`] finds them exactly by
//! propagating visibility windows through a triangulation of the outline alone ([`Navigation`]): no samples take part, so the
//! result does not depend on sampling. The paper's own approximation, Dijkstra's algorithm on a graph over the samples, is
//! kept in [`graph`] as the reference.
//!
//! Literature: Mitchell, Mount and Papadimitriou, "The discrete geodesic problem" (1987), for windows in the order of
//! distance; Xin and Wang, "Improving Chen and Han's algorithm on the discrete geodesic problem" (2009), for the test that
//! drops a window; Cui, Harabor and Grastien, "Compromise-free pathfinding on a navigation mesh" (2017), for its use in the
//! plane.
//!
//! Cost and limits: see [`Propagation`] (about ten windows for each corner within the bound) and [`Navigation`].

mod field;
pub mod graph;
mod navigation;
mod propagate;

pub use field::{DistanceField, PathEnd};
pub(crate) use field::{WINDOW_SLACK, Window};
pub use navigation::{Navigation, OutlineTriangle};
pub use propagate::Propagation;
