//! 𝒫: points all over the domain, with a constrained Delaunay mesh over them (section V-B).
//!
//! Samples are the vertices of the drawn mesh. A separate, coarser set locates cells. Distances and weights depend on
//! neither: they are evaluated.

mod base;
mod bones;
mod cache;
mod coarse;
mod feather;
mod fringe;
mod lattice;
mod outline;
mod refine;
mod samples;
mod shown;
mod skirt;
mod sprite;
mod tiles;

#[cfg(test)]
pub(crate) use base::BaseSamples;
pub(crate) use cache::SamplingCache;
pub(crate) use coarse::{CoarseSamples, coarse_sample_count};
pub use feather::Feather;
pub(crate) use samples::Samples;
pub(crate) use sprite::SpriteSamples;
