//! A pose of the sites that is near given positions of a mesh, such as the optimum.

use c2warp::{Error, Solution, deform::Pose, project::Blend};
use glam::{DMat2, DVec2};

use crate::measure::stretches;

/// Least stretch of a site.
const LEAST: f64 = 0.1;

/// Returns the pose whose sites move like the vertices around them, by weighted least squares.
///
/// # Errors
/// If positions are not finite.
pub fn fitted(solution: &Solution, vertices: &[DVec2], posed: &[DVec2]) -> Result<Pose, Error> {
    let mut fits = vec![Fit::ZERO; solution.sites().len()];
    for (&from, &to) in vertices.iter().zip(posed) {
        for (site, weight) in solution.weights_at(from).into_iter().flatten() {
            fits[site].add(weight, from - solution.sites()[site].rest, to);
        }
    }
    let numbers: Vec<f64> = fits.iter().zip(solution.sites()).flat_map(|(fit, site)| fit.motion(site.rest)).collect();
    solution.poser().pose_of_numbers(&numbers, Blend::Linear)
}

/// Weighted sums over vertices near a site.
#[derive(Debug, Clone)]
struct Fit {
    weight: f64,
    from: DVec2,
    to: DVec2,
    /// Σ w from fromᵀ.
    spread: DMat2,
    /// Σ w to fromᵀ.
    product: DMat2,
}

impl Fit {
    const ZERO: Self =
        Self { weight: 0.0, from: DVec2::ZERO, to: DVec2::ZERO, spread: DMat2::ZERO, product: DMat2::ZERO };

    fn add(&mut self, weight: f64, from: DVec2, to: DVec2) {
        let outer = |p: DVec2| DMat2::from_cols(weight * from.x * p, weight * from.y * p);
        self.weight += weight;
        self.from += weight * from;
        self.to += weight * to;
        self.spread += outer(from);
        self.product += outer(to);
    }

    /// The numbers of the motion of a site at `rest`. A site without vertices stays at rest.
    fn motion(&self, rest: DVec2) -> [f64; 7] {
        if self.weight <= 0.0 {
            return [0.0; 7];
        }
        let (from, to) = (self.from / self.weight, self.to / self.weight);
        let outer = |p: DVec2| DMat2::from_cols(from.x * self.weight * p, from.y * self.weight * p);
        let linear = (self.product - outer(to)) * (self.spread - outer(from)).inverse();
        let linear = if linear.is_finite() { linear } else { DMat2::IDENTITY };
        let by = to - linear * from - rest;
        let ([angle, xx, xy, yy], DVec2 { x, y }) = (turn_and_strain(linear), by);
        [angle, xx, xy, yy, x, y, 0.0]
    }
}

/// The rotation nearest to a map, and the logarithm of the remaining stretch. Less stretch than [`LEAST`] is set to it.
fn turn_and_strain(map: DMat2) -> [f64; 4] {
    let (cos, sin) = (map.x_axis.x + map.y_axis.y, map.x_axis.y - map.y_axis.x);
    let angle = sin.atan2(cos);
    let stretch = DMat2::from_angle(-angle) * map;
    let [long, short] = stretches(map).map(|stretch| stretch.max(LEAST).ln());
    let (half, across) = ((stretch.x_axis.x - stretch.y_axis.y) / 2.0, stretch.x_axis.y);
    let radius = half.hypot(across);
    let share = if radius > 0.0 { (long - short) / (2.0 * radius) } else { 0.0 };
    let middle = f64::midpoint(long, short);
    [angle, middle + share * half, share * across, middle - share * half]
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
    fn a_linear_map_is_fitted_exactly() {
        let mut project = Project::for_picture(40, 30).with_handles([Handle::point("a", [10.0, 15.0])]);
        project = project.with_editor_settings();
        // Some samples per site.
        (project.samples, project.pose.density) = (400, 20);
        let solution = solve(&project, &Picture::new(40, 30, &vec![255; 40 * 30 * 4]).unwrap()).unwrap();
        let map = |p: DVec2| DMat2::from_cols_array(&[0.8, 0.9, -0.7, 1.1]) * p + DVec2::new(5.0, -3.0);
        let vertices = &solution.vertices()[..solution.samples()];
        let posed: Vec<DVec2> = vertices.iter().map(|&p| map(p)).collect();
        let pose = fitted(&solution, vertices, &posed).unwrap();
        for (&p, &expected) in vertices.iter().zip(&posed) {
            let found = solution.map(&pose, p).unwrap().posed;
            assert!(found.distance(expected) < 1e-6, "{p}: {found}, not {expected}");
        }
    }
}
