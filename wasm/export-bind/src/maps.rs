//! Maps of a warp, heat maps, and weights: the files of `c2warp maps` and `c2warp weights`.

use c2warp::{Canvas, Filter, ResampleOptions};
use c2warp_maps::{Map, MapFormat, Maps, Places, TableFormat, Weights, heat_map};
use js_sys::Error as JsError;
use wasm_bindgen::prelude::*;

use crate::solved::{SolvedProject, refused};

/// The largest array: a page keeps the whole array in memory.
const MOST_BYTES: u64 = 512 << 20;

/// A quantity with a value at each pixel.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy)]
pub enum MapKind {
    /// For each pixel of the warped picture, the position in the picture that it shows.
    Inverse,
    /// For each pixel of the picture, its position in the warped picture.
    Forward,
    /// The growth of areas and lengths.
    Stretch,
    /// Areas that the warp uncovers and covers.
    Disocclusion,
}

/// A map, its format, and the drawing that it belongs to.
#[wasm_bindgen]
#[derive(Debug, Clone, Copy)]
pub struct MapOptions {
    map: Map,
    format: MapFormat,
    canvas: Canvas,
    filter: Filter,
}

#[wasm_bindgen]
impl MapOptions {
    /// `exr`: OpenEXR with 32-bit floats, instead of PNG with 16 bits. `grow`: the map grows to contain everything that
    /// is bent beyond the picture's rectangle. `pixelated`: the drawing is pixel art.
    #[wasm_bindgen(constructor)]
    pub fn new(map: MapKind, exr: bool, grow: bool, pixelated: bool) -> Self {
        let map = match map {
            MapKind::Inverse => Map::Inverse,
            MapKind::Forward => Map::Forward,
            MapKind::Stretch => Map::Stretch,
            MapKind::Disocclusion => Map::Disocclusion,
        };
        let format = if exr { MapFormat::Exr } else { MapFormat::Png };
        let canvas = if grow { Canvas::Grown } else { Canvas::Picture };
        let filter = if pixelated { Filter::Nearest } else { Filter::Cubic };
        Self { map, format, canvas, filter }
    }
}

#[wasm_bindgen]
impl SolvedProject {
    /// A map of the project's pose, or of a named clip at a time in seconds. `name` is the name of the picture's file.
    ///
    /// # Errors
    /// For an unknown clip, and for a map that is larger than a picture may be.
    pub fn map(&self, options: MapOptions, name: &str, clip: Option<String>, seconds: f64) -> Result<Vec<u8>, JsError> {
        let MapOptions { map, format, canvas, filter } = options;
        let picture = self.picture()?;
        let pose = self.pose(clip, seconds)?;
        let drawn = ResampleOptions { scale: 1.0, canvas, filter, edges: self.project.edges };
        let drawing = self.solution.drawing(&picture, &pose, drawn).map_err(refused)?;
        let maps = Maps { solution: &self.solution, pose: &pose, picture, drawing: &drawing, name };
        maps.file(map, format, &mut |part| self.report(part)).map_err(refused)
    }

    /// The weight of a handle as a heat map over the picture at rest, as PNG.
    ///
    /// # Errors
    /// For an unknown handle.
    #[wasm_bindgen(js_name = heatMap)]
    pub fn heat_map(&self, handle: &str) -> Result<Vec<u8>, JsError> {
        let weights = Weights::new(&self.solution, &self.project, Some(handle)).map_err(refused)?;
        heat_map(&self.solution, &weights, self.picture()?, &mut |part| self.report(part)).map_err(refused)
    }

    /// The weights of all sites at every N-th pixel, as an array for NumPy or as CSV.
    ///
    /// # Errors
    /// For an array that is too large.
    pub fn weights(&self, every: u32, npy: bool) -> Result<Vec<u8>, JsError> {
        self.table(None, every, npy)
    }

    /// The weight of a handle at every N-th pixel, as an array for NumPy or as CSV.
    ///
    /// # Errors
    /// For an unknown handle, and for an array that is too large.
    #[wasm_bindgen(js_name = handleWeights)]
    pub fn handle_weights(&self, handle: &str, every: u32, npy: bool) -> Result<Vec<u8>, JsError> {
        self.table(Some(handle), every, npy)
    }

    /// The sites as CSV, in the order of the array's last axis.
    ///
    /// # Errors
    /// If the table cannot be written.
    pub fn sites(&self) -> Result<Vec<u8>, JsError> {
        let weights = Weights::new(&self.solution, &self.project, None).map_err(refused)?;
        let mut file = Vec::new();
        weights.write_sites(&mut file).map_err(refused)?;
        Ok(file)
    }
}

impl SolvedProject {
    fn table(&self, handle: Option<&str>, every: u32, npy: bool) -> Result<Vec<u8>, JsError> {
        let weights = Weights::new(&self.solution, &self.project, handle).map_err(refused)?;
        let places = Places::grid(self.size, every);
        weights.check_size(&places, MOST_BYTES).map_err(refused)?;
        let format = if npy { TableFormat::Npy } else { TableFormat::Csv };
        let mut file = Vec::new();
        weights.write(&places, format, &mut file, &mut |part| self.report(part)).map_err(refused)?;
        Ok(file)
    }
}
