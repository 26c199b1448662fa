//! Intrinsic distance d(p, q): the length of the shortest path inside the domain (section III-A, with f = 1).
//!
//! The domain is flat, so a shortest path is a polyline that bends only at reflex corners of the outline. Its last
//! vertex is the *pseudo-source* of its end: the source itself, or the last corner at which the path bends. At *any*
//! point the distance is therefore the minimum of `offset + |p − pseudo_source|` over the pseudo-sources that see the
//! point.
//!
//! [`Distances`] finds the pseudo-sources exactly. It propagates visibility windows through [`Navigation`], a
//! triangulation of the outline only. No samples are involved, so the result does not depend on sampling. The paper
//! approximates distances by Dijkstra's algorithm on a [graph] over the samples. This method is kept as the reference,
//! and [point clouds](crate::cloud) use it.
//!
//! ```
//! use c2warp::{distance::Navigation, domain::Domain, glam::DVec2};
//!
//! let square = |low: f64, high: f64| {
//!     [(low, low), (high, low), (high, high), (low, high)].map(DVec2::from).to_vec()
//! };
//! let with_a_hole = Domain::from_rings(&[square(0.0, 100.0), square(30.0, 70.0)])?;
//! let navigation = Navigation::new(&with_a_hole);
//! let distances = navigation.distances_from([10.0, 30.0].into())?;
//! // Along the upper side of the hole, and around its corner.
//! let expected = 60.0 + f64::sqrt(200.0);
//! assert!((distances.to([80.0, 40.0].into()).unwrap() - expected).abs() < 1e-12);
//! assert_eq!(distances.to([50.0, 50.0].into()), None);
//! # Ok::<(), c2warp::Error>(())
//! ```
//!
//! # Literature
//!
//! - Mitchell, Mount and Papadimitriou, "The discrete geodesic problem" (1987): windows in the order of distance.
//! - Xin and Wang, "Improving Chen and Han's algorithm on the discrete geodesic problem" (2009): the test that drops
//!   a window.
//! - Cui, Harabor and Grastien, "Compromise-free pathfinding on a navigation mesh" (2017): the same test in the plane.
//!
//! # Cost and limits
//!
//! Exact distances are C¹ where paths begin to bend, and have a crease where two ways around a hole are equally long.
//! `penumbra` makes them C² at bends, and `unique` computes the distance to the nearest crease.
//!
//! A distance field takes about ten windows for each corner within its bound. See also [`Navigation`].

mod cone;
mod distances;
mod field;
pub mod graph;
mod navigation;
mod path_end;
mod penumbra;
mod propagate;
mod unique;
mod wedge;
mod window;

pub use distances::{Distances, Located};
pub(crate) use field::DistanceField;
pub(crate) use navigation::NavTriangle;
pub use navigation::Navigation;
pub(crate) use path_end::PathEnd;
pub(crate) use penumbra::Penumbrae;
pub(crate) use propagate::Propagation;
pub(crate) use window::{WINDOW_SLACK, Window};
