//! 𝒫: points all over the domain, with a constrained Delaunay mesh over them (section V-B).
//!
//! Samples are the vertices of the drawn mesh. A separate, coarser set locates cells. Distances and weights do not
//! depend on either set, because they are evaluated in closed form.

mod band;
mod base;
mod bones;
mod cache;
mod coarse;
mod feather;
mod fringe;
mod lattice;
mod lattice_triangles;
mod nav_scan;
mod nearby;
mod nodes;
mod outline;
mod refine;
mod samples;
mod shown;
mod skirt;
mod sprite;
#[cfg(test)]
mod tests;
mod tiles;

#[cfg(test)]
pub(crate) use base::BaseSamples;
pub(crate) use cache::{Places, SamplingCache, coarse_samples};
pub(crate) use coarse::{CoarseSamples, coarse_sample_count};
pub use feather::Feather;
pub(crate) use samples::Samples;
pub(crate) use sprite::SpriteSamples;
