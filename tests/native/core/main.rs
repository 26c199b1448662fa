//! What the core promises, on domains that are hard for it.

mod again;
mod alpha;
mod bars;
mod blend;
mod cloud;
mod depth;
mod geodesic;
mod given;
mod handles;
mod made;
mod noise;
mod properties;
mod quality;
mod rigid;
mod scenes;
mod surroundings;
mod symmetry;
