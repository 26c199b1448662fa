//! A solution as typed arrays.

use glam::DVec2;
use wasm_bindgen::prelude::*;

/// The arrays that the page uses for drawing and posing. Every getter copies: call each once, then free the solution.
#[wasm_bindgen(inspectable)]
#[derive(Debug)]
pub struct Solution {
    positions: Vec<f32>,
    triangles: Vec<u32>,
    background_positions: Vec<f32>,
    background_triangles: Vec<u32>,
    feather_positions: Vec<f32>,
    feather_owners: Vec<u32>,
    feather_levels: Vec<f32>,
    feather_triangles: Vec<u32>,
    offsets: Vec<u32>,
    sites: Vec<u32>,
    weights: Vec<f32>,
    site_rest: Vec<f64>,
    site_handle: Vec<i32>,
    site_edges: Vec<u32>,
    poser: Vec<u8>,
    report: String,
}

impl Solution {
    pub(crate) fn new(solution: &c2warp::Solution, report: String) -> Self {
        Self {
            positions: flat(solution.vertices().iter().map(DVec2::to_array)),
            triangles: solution.triangles().concat(),
            background_positions: flat(solution.static_background().vertices().iter().map(DVec2::to_array)),
            background_triangles: solution.static_background().triangles().concat(),
            feather_positions: flat(solution.feather().vertices().iter().map(DVec2::to_array)),
            feather_owners: solution.feather().owners().to_vec(),
            feather_levels: solution.feather().levels().iter().map(|&level| level as f32).collect(),
            feather_triangles: solution.feather().triangles().concat(),
            offsets: solution.weights().offsets().to_vec(),
            sites: solution.weights().sites().to_vec(),
            weights: solution.weights().weights().iter().map(|&weight| weight as f32).collect(),
            site_rest: solution.sites().iter().flat_map(|site| site.rest.to_array()).collect(),
            site_handle: solution.sites().iter().map(|site| site.kind.handle_code()).collect(),
            site_edges: solution.links().flat_map(|(i, j, _)| [i as u32, j as u32]).collect(),
            poser: solution.poser().to_bytes(),
            report,
        }
    }
}

fn flat(points: impl Iterator<Item = [f64; 2]>) -> Vec<f32> {
    points.flatten().map(|coordinate| coordinate as f32).collect()
}

#[wasm_bindgen]
impl Solution {
    /// Vertices × 2: rest positions in image pixels, the samples first, then the skirt.
    #[wasm_bindgen(getter)]
    pub fn positions(&self) -> Vec<f32> {
        self.positions.clone()
    }

    /// Triangles × 3 vertex indices, in drawing order.
    #[wasm_bindgen(getter)]
    pub fn triangles(&self) -> Vec<u32> {
        self.triangles.clone()
    }

    /// Vertices × 2 of the static background.
    #[wasm_bindgen(getter)]
    pub fn background_positions(&self) -> Vec<f32> {
        self.background_positions.clone()
    }

    /// Its triangles × 3 vertex indices.
    #[wasm_bindgen(getter)]
    pub fn background_triangles(&self) -> Vec<u32> {
        self.background_triangles.clone()
    }

    /// Vertices × 2 of the feather.
    #[wasm_bindgen(getter)]
    pub fn feather_positions(&self) -> Vec<f32> {
        self.feather_positions.clone()
    }

    /// For each vertex of the feather, the vertex of the mesh that it follows.
    #[wasm_bindgen(getter)]
    pub fn feather_owners(&self) -> Vec<u32> {
        self.feather_owners.clone()
    }

    /// The level of each vertex of the feather, which determines its opacity.
    #[wasm_bindgen(getter)]
    pub fn feather_levels(&self) -> Vec<f32> {
        self.feather_levels.clone()
    }

    /// The triangles of the feather × 3 vertex indices.
    #[wasm_bindgen(getter)]
    pub fn feather_triangles(&self) -> Vec<u32> {
        self.feather_triangles.clone()
    }

    /// Vertices + 1: the index of each vertex's first entry in `sites` and `weights`.
    #[wasm_bindgen(getter)]
    pub fn offsets(&self) -> Vec<u32> {
        self.offsets.clone()
    }

    /// Entries: the site.
    #[wasm_bindgen(getter)]
    pub fn sites(&self) -> Vec<u32> {
        self.sites.clone()
    }

    /// Entries: the weight. A vertex's weights sum to 1; a vertex without entries does not move.
    #[wasm_bindgen(getter)]
    pub fn weights(&self) -> Vec<f32> {
        self.weights.clone()
    }

    /// Sites × 2: rest positions in image pixels.
    #[wasm_bindgen(getter)]
    pub fn site_rest(&self) -> Vec<f64> {
        self.site_rest.clone()
    }

    /// Sites: index of the handle in the project, −1 for a virtual site, −2 for a site of a held boundary.
    #[wasm_bindgen(getter)]
    pub fn site_handle(&self) -> Vec<i32> {
        self.site_handle.clone()
    }

    /// Links of the cell graph × 2 sites.
    #[wasm_bindgen(getter)]
    pub fn site_edges(&self) -> Vec<u32> {
        self.site_edges.clone()
    }

    /// Bytes for a [`PosedPicture`](crate::PosedPicture).
    #[wasm_bindgen(getter)]
    pub fn poser(&self) -> Vec<u8> {
        self.poser.clone()
    }

    /// The object of `inspect --json`, as text.
    #[wasm_bindgen(getter)]
    pub fn report(&self) -> String {
        self.report.clone()
    }
}
