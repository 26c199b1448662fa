//! The energy of the map itself, from its exact Jacobians at the centres of the mesh's triangles.
//!
//! [`Distortion`](crate::measure::Distortion) measures the piecewise linear map over the mesh instead.

use c2warp::{Solution, deform::Pose, weight::Influence};
use glam::{DMat2, DVec2};

use crate::{
    comparison_mesh::ComparisonMesh,
    measure::{energy, stretches},
};

/// The centre of a triangle.
#[derive(Debug)]
struct Centre {
    at: DVec2,
    area: f64,
    influences: Vec<Influence>,
}

/// The centres of a mesh's triangles, with the weights of a solution.
#[derive(Debug)]
pub struct Centres(Vec<Centre>);

impl Centres {
    /// Finds the weights at the centres. Centres outside the domain are left out.
    #[must_use]
    pub fn new(mesh: &ComparisonMesh, solution: &Solution) -> Self {
        let centre = |(triangle, &area): (usize, &f64)| {
            let at = mesh.corners(triangle, &mesh.vertices).iter().sum::<DVec2>() / 3.0;
            Some(Centre { at, area, influences: solution.influences_at(at)? })
        };
        Self(mesh.areas.iter().enumerate().filter_map(centre).collect())
    }

    /// Returns the mean energy of a linearly blended pose by area, capped like that of triangles.
    #[must_use]
    pub fn energy(&self, pose: &Pose) -> f64 {
        let area: f64 = self.0.iter().map(|centre| centre.area).sum();
        let sum: f64 = self.0.iter().map(|centre| centre.area * energy(stretches(centre.jacobian(pose)))).sum();
        sum / area
    }
}

impl Centre {
    /// The derivative of eq. 1 by the product rule.
    fn jacobian(&self, pose: &Pose) -> DMat2 {
        let term = |&Influence { site, weight, gradient }: &Influence| {
            let moved = pose.moved(site, self.at);
            let linear = [DVec2::X, DVec2::Y].map(|axis| pose.moved(site, self.at + axis) - moved);
            // Gradients sum to zero: relative to the point, fewer digits are lost.
            let by = moved - self.at;
            DMat2::from_cols(weight * linear[0] + gradient.x * by, weight * linear[1] + gradient.y * by)
        };
        self.influences.iter().map(term).sum()
    }
}

#[cfg(test)]
mod tests {
    use c2warp::{
        Picture,
        project::{Handle, Project},
        solve,
    };

    use super::*;

    #[test]
    fn jacobians_are_those_of_the_map() {
        let handles = [
            Handle::point("a", [10.0, 15.0]).posed_at([[8.0, 9.0]]),
            Handle::point("b", [30.0, 15.0]).posed_at([[33.0, 17.0]]),
        ];
        let mut project = Project::for_picture(40, 30).with_handles(handles);
        project.samples = 200;
        let solution = solve(&project, &Picture::new(40, 30, &vec![255; 40 * 30 * 4]).unwrap()).unwrap();
        let pose = solution.pose(&project).unwrap();
        let Centres(centres) = Centres::new(&ComparisonMesh::of(&solution), &solution);
        assert!(centres.len() > 200);
        for centre in &centres {
            let map = |by: DVec2| solution.map(&pose, centre.at + by).unwrap().posed;
            let slope = |by: DVec2| (map(by) - map(-by)) / 2e-5;
            let expected = DMat2::from_cols(slope(1e-5 * DVec2::X), slope(1e-5 * DVec2::Y));
            assert!(centre.jacobian(&pose).abs_diff_eq(expected, 1e-4), "{centre:?}");
        }
    }
}
