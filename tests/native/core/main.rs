//! Tests of the core on difficult domains.

mod alpha;
mod alpha_shapes;
mod api;
mod at_rest;
mod bars;
mod blend;
mod clips;
mod cloud;
mod continuity;
mod depth;
mod fine_outlines;
mod geodesic;
mod handles;
mod input_mesh;
mod loose_parts;
mod noise;
mod properties;
mod quality;
mod reuse;
mod rig;
mod rigid;
mod scenes;
mod static_background;
mod stiffness;
mod symmetry;
mod unfolding;
