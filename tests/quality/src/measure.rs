//! How much a map distorts: figures of the piecewise linear map over the common mesh.

use glam::{DMat2, DVec2};

use crate::fine::Fine;

/// What the energy of a triangle counts for at most, and that of one that is turned over: as squeezed to a tenth. The energy
/// itself has no bound, and a mean over it would tell of the one worst triangle alone.
pub const MOST_ENERGY: f64 = 100.0;
/// What has moved: by more than so many pixels.
const MOVED: f64 = 0.5;

/// Figures of one map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Distortion {
    /// Symmetric Dirichlet energy |J|² + |J⁻¹|² − 4, averaged by area, each triangle at [`MOST_ENERGY`] at most.
    pub energy: f64,
    /// The energy that 1 % of the area exceeds.
    pub energy_99: f64,
    /// Mean of |J − R|² for the nearest rotation R: what the dense reference minimises.
    pub rigidity: f64,
    /// Largest singular value of J.
    pub most_stretch: f64,
    /// Least singular value of J, negative where the map turns over.
    pub least_stretch: f64,
    /// Triangles with det J < 0.
    pub folds: usize,
    /// ∫ |∂²p′/∂n²|² over the area around the inner edges: Σ over edges of (length ÷ distance between the two centroids
    /// across the edge) · |J₁ − J₂|². Without a unit, the same at every size of the picture.
    pub bending: f64,
    /// Share of the area that moved by more than half a pixel.
    pub moved: f64,
}

/// Signed singular values of J, the larger first: the second is negative where J turns over.
#[must_use]
pub fn stretches(j: DMat2) -> [f64; 2] {
    let (a, b, c, d) = (j.x_axis.x, j.y_axis.x, j.x_axis.y, j.y_axis.y);
    let (turning, mirroring) = ((a + d).hypot(c - b) / 2.0, (a - d).hypot(b + c) / 2.0);
    [turning + mirroring, turning - mirroring]
}

/// The energy of a triangle, of no more than [`MOST_ENERGY`].
#[must_use]
pub fn energy([most, least]: [f64; 2]) -> f64 {
    if least <= 0.0 {
        return MOST_ENERGY;
    }
    (most * most + least * least + 1.0 / (most * most) + 1.0 / (least * least) - 4.0).clamp(0.0, MOST_ENERGY)
}

/// J of every triangle.
#[must_use]
pub fn jacobians(fine: &Fine, posed: &[DVec2]) -> Vec<DMat2> {
    let edges = |[a, b, c]: [DVec2; 3]| DMat2::from_cols(b - a, c - a);
    let jacobian = |t| edges(fine.corners(t, posed)) * edges(fine.corners(t, &fine.vertices)).inverse();
    (0..fine.triangles.len()).map(jacobian).collect()
}

impl Distortion {
    /// Measures where the vertices went.
    #[must_use]
    pub fn of(fine: &Fine, posed: &[DVec2]) -> Self {
        let jacobians = jacobians(fine, posed);
        let stretches: Vec<[f64; 2]> = jacobians.iter().map(|&j| stretches(j)).collect();
        let area: f64 = fine.areas.iter().sum();
        let mean =
            |figure: &dyn Fn(usize) -> f64| (0..stretches.len()).map(|t| fine.areas[t] * figure(t)).sum::<f64>() / area;
        let mut by_energy: Vec<(f64, f64)> =
            stretches.iter().map(|&s| energy(s)).zip(fine.areas.iter().copied()).collect();
        by_energy.sort_by(|a, b| b.0.total_cmp(&a.0));
        let mut beyond = 0.0;
        let at_99 = by_energy.iter().find(|&&(_, share)| {
            beyond += share;
            beyond > 0.01 * area
        });
        let centroid = |t: usize, places: &[DVec2]| fine.corners(t, places).iter().sum::<DVec2>() / 3.0;
        let bends = fine.inner_edges().into_iter().map(|([a, b], [s, t])| {
            let edge = fine.vertices[b as usize] - fine.vertices[a as usize];
            let across = edge.perp_dot(centroid(t, &fine.vertices) - centroid(s, &fine.vertices)).abs();
            let jump = jacobians[t] - jacobians[s];
            edge.length_squared() / across * (jump.x_axis.length_squared() + jump.y_axis.length_squared())
        });
        Self {
            energy: mean(&|t| energy(stretches[t])),
            energy_99: at_99.map_or(0.0, |&(energy, _)| energy),
            rigidity: mean(&|t| (stretches[t][0] - 1.0).powi(2) + (stretches[t][1] - 1.0).powi(2)),
            most_stretch: stretches.iter().map(|s| s[0]).fold(0.0, f64::max),
            least_stretch: stretches.iter().map(|s| s[1]).fold(f64::INFINITY, f64::min),
            folds: stretches.iter().filter(|s| s[1] < 0.0).count(),
            bending: bends.sum(),
            moved: mean(&|t| f64::from(u8::from(centroid(t, posed).distance(centroid(t, &fine.vertices)) > MOVED))),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn singular_values_tell_stretch_and_turning_over() {
        let turn = DMat2::from_angle(0.7);
        let close = |found: [f64; 2], expected: [f64; 2]| {
            assert!((found[0] - expected[0]).abs() < 1e-12 && (found[1] - expected[1]).abs() < 1e-12, "{found:?}");
        };
        close(stretches(turn), [1.0, 1.0]);
        close(stretches(turn * DMat2::from_diagonal((3.0, 0.5).into()) * turn), [3.0, 0.5]);
        close(stretches(turn * DMat2::from_diagonal((1.0, -2.0).into())), [2.0, -1.0]);
        assert_eq!(energy([1.0, 1.0]), 0.0);
        assert!((energy([2.0, 1.0]) - 2.25).abs() < 1e-12);
        assert_eq!(energy([2.0, -1.0]), MOST_ENERGY);
    }

    #[test]
    fn figures_of_a_map_that_is_known() {
        let at = |i: u32| DVec2::new(f64::from(i % 21), f64::from(i / 21)) / 20.0;
        let cell = |i: u32| [[i, i + 1, i + 22], [i, i + 22, i + 21]];
        let triangles: Vec<[u32; 3]> = (0..420).filter(|i| i % 21 != 20).flat_map(cell).collect();
        let areas = vec![1.0 / 800.0; triangles.len()];
        let fine = Fine { vertices: (0..441).map(at).collect(), triangles, areas };
        let still = Distortion::of(&fine, &fine.vertices);
        assert!(still.energy < 1e-12 && still.bending < 1e-12 && still.folds == 0 && still.moved == 0.0);
        let wide: Vec<DVec2> = fine.vertices.iter().map(|p| DVec2::new(2.0 * p.x, p.y)).collect();
        let wide = Distortion::of(&fine, &wide);
        assert!((wide.energy - 2.25).abs() < 1e-9 && (wide.energy_99 - 2.25).abs() < 1e-9, "{wide:?}");
        assert!((wide.rigidity - 1.0).abs() < 1e-9 && wide.bending < 1e-9, "{wide:?}");
        assert!((wide.most_stretch - 2.0).abs() < 1e-9 && (wide.least_stretch - 1.0).abs() < 1e-9);
        // x² along x: its second derivative is 2 everywhere.
        let bent: Vec<DVec2> = fine.vertices.iter().map(|p| DVec2::new(p.x * p.x, p.y)).collect();
        let bent = Distortion::of(&fine, &bent).bending;
        // Squares cut in half say a half more or less of a second derivative, by which way its direction runs to the cuts.
        assert!((3.0..=7.0).contains(&bent), "{bent}");
    }
}
