//! Poses of baked rigs for JavaScript: a separate module that only poses.
//!
//! The player loads it when a reader first poses a picture whose poses need the solver.

use c2warp::{deform::HandlePose, pose::Motion, rig::RigPoser, weight::SparseWeights};
use glam::DVec2;
use js_sys::Error as JsError;
use wasm_bindgen::prelude::*;

/// Poses the handles of a rig.
#[wasm_bindgen]
#[derive(Debug)]
pub struct SectionPoser {
    poser: RigPoser,
}

#[wasm_bindgen]
impl SectionPoser {
    /// Reads the unpacked section `POSR` of a rig, and takes its mesh. `positions` are vertices × 2 at rest, and
    /// `triangles` are triangles × 3. `rows` are vertices × 2: the first entry and their number. `entries` are
    /// entries × 2: site and weight.
    ///
    /// # Errors
    /// For a section of another format, a damaged section, or a mesh of another rig.
    #[wasm_bindgen(constructor)]
    pub fn new(
        section: &[u8],
        positions: &[f32],
        triangles: &[u32],
        rows: &[u32],
        entries: &[f32],
    ) -> Result<Self, JsError> {
        let mut poser = RigPoser::from_section(section).map_err(told)?;
        let (sites, weights) =
            entries.as_chunks::<2>().0.iter().map(|&[site, weight]| (site as u32, f64::from(weight))).unzip();
        let offsets =
            rows.as_chunks::<2>().0.iter().map(|&[first, _]| first).chain([entries.len() as u32 / 2]).collect();
        let weights = SparseWeights::from_parts(offsets, sites, weights)
            .ok_or_else(|| JsError::new("the weights contradict one another"))?;
        let places: Vec<DVec2> =
            positions.as_chunks::<2>().0.iter().map(|&[x, y]| DVec2::new(x.into(), y.into())).collect();
        poser.set_mesh(&places, triangles.as_chunks::<3>().0, &weights).map_err(told)?;
        Ok(Self { poser })
    }

    /// The motions of all sites for posed handles. Each has seven numbers: angle; strain xx, xy, yy; translation x, y;
    /// depth. `poses` is the flat array of [`HandlePose::from_numbers`].
    ///
    /// # Errors
    /// For poses of other handles, and for poses without valid motions.
    pub fn motions(&self, poses: &[f64]) -> Result<Vec<f64>, JsError> {
        self.poser.motions(&read(poses)?).map(|motions| numbers(&motions)).map_err(told)
    }

    /// The motions of the next frame of a drag, from those of the frame before.
    ///
    /// # Errors
    /// As for [`motions`](Self::motions), and for motions of another rig.
    pub fn followed(&self, before: &[f64], poses: &[f64]) -> Result<Vec<f64>, JsError> {
        self.poser.followed(&motions_of(before)?, &read(poses)?).map(|motions| numbers(&motions)).map_err(told)
    }

    /// The motions in which a drag comes to rest, from those of its last frame.
    ///
    /// # Errors
    /// As for [`followed`](Self::followed).
    pub fn settled(&self, before: &[f64], poses: &[f64]) -> Result<Vec<f64>, JsError> {
        self.poser.settled(&motions_of(before)?, &read(poses)?).map(|motions| numbers(&motions)).map_err(told)
    }
}

fn told(reason: impl std::fmt::Display) -> JsError {
    JsError::new(&reason.to_string())
}

fn read(poses: &[f64]) -> Result<Vec<HandlePose>, JsError> {
    HandlePose::from_numbers(poses).ok_or_else(|| JsError::new("the poses end within a handle"))
}

fn numbers(motions: &[Motion]) -> Vec<f64> {
    motions.iter().flat_map(Motion::numbers).collect()
}

fn motions_of(numbers: &[f64]) -> Result<Vec<Motion>, JsError> {
    let (motions, rest) = numbers.as_chunks();
    if rest.is_empty() {
        Ok(motions.iter().map(Motion::from_numbers).collect())
    } else {
        Err(JsError::new("the motions end within a site"))
    }
}
