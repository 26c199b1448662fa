//! Queries about many points. They solve first if necessary.
//!
//! The results equal those of the command, bit for bit. Weights have the closed form of eq. 2 at any point, while
//! [`PosedPicture`](crate::PosedPicture) interpolates over the mesh.

use std::sync::Arc;

use c2warp::{Error, deform::Pose, project::Project};
use glam::DVec2;
use wasm_bindgen::prelude::*;

use crate::{
    Session,
    error::to_js,
    history::History,
    posed_picture::{flat, pairs},
};

#[wasm_bindgen]
impl Session {
    /// The posed positions of rest points: points × 3 numbers posed x, posed y, growth of areas. NaN outside the
    /// domain.
    ///
    /// `points` are pairs of coordinates. Without a history, the pose depends only on the project and its handles.
    ///
    /// # Errors
    /// The errors of [`begin`](Self::begin) and [`advance`](Self::advance), and an error for handles without a pose.
    pub fn map(&mut self, project_json: &str, points: &[f64], history: Option<History>) -> Result<Vec<f64>, JsValue> {
        let (solution, pose) = self.posed(project_json, history)?;
        let mapped = pairs(points).into_iter().map(|p| solution.map(&pose, p));
        Ok(mapped.flat_map(|at| at.map_or([f64::NAN; 3], |at| [at.posed.x, at.posed.y, at.det])).collect())
    }

    /// The rest points that are drawn at points of the warped picture: points × 2. NaN where nothing is drawn.
    ///
    /// # Errors
    /// The errors of [`map`](Self::map).
    pub fn inverse(
        &mut self,
        project_json: &str,
        points: &[f64],
        history: Option<History>,
    ) -> Result<Vec<f64>, JsValue> {
        let (solution, pose) = self.posed(project_json, history)?;
        let rest = solution.rest_points(&pose, &pairs(points));
        Ok(rest.into_iter().flat_map(|rest| rest.map_or([f64::NAN; 2], |rest| rest.to_array())).collect())
    }

    /// The mesh in a pose.
    ///
    /// # Errors
    /// The errors of [`map`](Self::map).
    pub fn posed_mesh(&mut self, project_json: &str, history: Option<History>) -> Result<PosedMesh, JsValue> {
        let (solution, pose) = self.posed(project_json, history)?;
        Ok(PosedMesh {
            positions: flat(solution.posed_vertices(&pose).into_iter()),
            triangles: solution.drawn_triangles(&pose).concat(),
            folds: solution.folds(&pose).concat(),
        })
    }

    /// The weights of sites at rest points. A point outside the domain has no weights.
    ///
    /// # Errors
    /// The errors of [`begin`](Self::begin) and [`advance`](Self::advance).
    pub fn weights(&mut self, project_json: &str, points: &[f64]) -> Result<PointWeights, JsValue> {
        let project = read(project_json)?;
        let solution = self.try_solve(&project).map_err(|error| to_js(&error))?;
        let mut weights = PointWeights { offsets: vec![0], sites: Vec::new(), weights: Vec::new() };
        for p in pairs(points) {
            for (site, weight) in solution.weights_at(p).unwrap_or_default() {
                if weight > 0.0 {
                    weights.sites.push(site as u32);
                    weights.weights.push(weight);
                }
            }
            weights.offsets.push(weights.sites.len() as u32);
        }
        Ok(weights)
    }

    /// The intrinsic distances from a point to rest points, in pixels. Infinite where no path exists, NaN outside the
    /// domain.
    ///
    /// # Errors
    /// The errors of [`weights`](Self::weights), and an error for a point outside the domain.
    pub fn distances(&mut self, project_json: &str, x: f64, y: f64, points: &[f64]) -> Result<Vec<f64>, JsValue> {
        let navigation = self.solved_as(project_json)?.navigation();
        let distances = navigation.distances_from(DVec2::new(x, y)).map_err(|error| to_js(&error))?;
        let to = |p| navigation.located(p).map(|p| distances.to_located(p).unwrap_or(f64::INFINITY));
        Ok(pairs(points).into_iter().map(|p| to(p).unwrap_or(f64::NAN)).collect())
    }

    /// The shortest path between two points, as the coordinates of its vertices. Empty if no path connects them.
    ///
    /// # Errors
    /// The errors of [`distances`](Self::distances).
    pub fn path(&mut self, project_json: &str, x: f64, y: f64, to_x: f64, to_y: f64) -> Result<Vec<f64>, JsValue> {
        let navigation = self.solved_as(project_json)?.navigation();
        let distances = navigation.distances_from(DVec2::new(x, y)).map_err(|error| to_js(&error))?;
        let path = distances.path_to(DVec2::new(to_x, to_y)).unwrap_or_default();
        Ok(path.into_iter().flat_map(|p| p.to_array()).collect())
    }
}

impl Session {
    fn posed(
        &mut self,
        project_json: &str,
        history: Option<History>,
    ) -> Result<(Arc<c2warp::Solution>, Pose), JsValue> {
        let project = read(project_json)?;
        self.try_pose(&project, history).map_err(|error| to_js(&error))
    }
}

fn read(project_json: &str) -> Result<Project, JsValue> {
    Project::from_json(project_json).map_err(|reason| to_js(&Error::from(reason)))
}

/// The mesh in a pose. Every getter copies: call each once, then free it.
#[wasm_bindgen]
#[derive(Debug)]
pub struct PosedMesh {
    positions: Vec<f32>,
    triangles: Vec<u32>,
    folds: Vec<u32>,
}

#[wasm_bindgen]
impl PosedMesh {
    /// Vertices × 2: posed positions, in the order of a solution's vertices.
    #[must_use]
    #[wasm_bindgen(getter)]
    pub fn positions(&self) -> Vec<f32> {
        self.positions.clone()
    }

    /// Triangles × 3 vertices, in drawing order.
    #[must_use]
    #[wasm_bindgen(getter)]
    pub fn triangles(&self) -> Vec<u32> {
        self.triangles.clone()
    }

    /// Triangles × 3 vertices: the flipped triangles over the domain.
    #[must_use]
    #[wasm_bindgen(getter)]
    pub fn folds(&self) -> Vec<u32> {
        self.folds.clone()
    }
}

/// Weights above 0 in rows, one row per point. Every getter copies: call each once, then free it.
#[wasm_bindgen]
#[derive(Debug)]
pub struct PointWeights {
    offsets: Vec<u32>,
    sites: Vec<u32>,
    weights: Vec<f64>,
}

#[wasm_bindgen]
impl PointWeights {
    /// Points + 1: the index of each point's first entry.
    #[must_use]
    #[wasm_bindgen(getter)]
    pub fn offsets(&self) -> Vec<u32> {
        self.offsets.clone()
    }

    /// Entries: the site, ascending in each row.
    #[must_use]
    #[wasm_bindgen(getter)]
    pub fn sites(&self) -> Vec<u32> {
        self.sites.clone()
    }

    /// Entries: the weight.
    #[must_use]
    #[wasm_bindgen(getter)]
    pub fn weights(&self) -> Vec<f64> {
        self.weights.clone()
    }
}
