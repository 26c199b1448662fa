//! Measures the distortion of the piecewise linear map over the common mesh.

use glam::{DMat2, DVec2};

use crate::comparison_mesh::ComparisonMesh;

/// Cap of the energy of a triangle, for triangles squeezed to a tenth or flipped.
///
/// The energy is unbounded. Without the cap, the worst triangle would dominate the mean.
pub const MAX_ENERGY: f64 = 100.0;
/// Displacement above which a triangle counts as moved, in pixels.
const MOVED: f64 = 0.5;

/// Measures of one map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Distortion {
    /// Mean symmetric Dirichlet energy |J|² + |J⁻¹|² − 4 by area, capped at [`MAX_ENERGY`] per triangle.
    pub energy: f64,
    /// The energy that 1 % of the area exceeds.
    pub energy_percentile_99: f64,
    /// Mean of |J − R|² for the nearest rotation R. The dense reference minimises it.
    pub rigidity: f64,
    /// Largest singular value of J.
    pub max_stretch: f64,
    /// Smallest singular value of J, negative where the map flips.
    pub min_stretch: f64,
    /// The number of triangles with det J < 0.
    pub folds: usize,
    /// Bending energy ∫ |∂²p′/∂n²|² over the area around the inner edges.
    ///
    /// It is the sum of (length ÷ distance of the centroids across the edge) · |J₁ − J₂|² over the edges. It has no
    /// unit and does not depend on the size of the picture.
    pub bending: f64,
    /// Total turning of the posed outline: the sum of the angles between successive edges, in radians.
    pub turning: f64,
    /// Fraction of the area that moved by more than half a pixel.
    pub moved: f64,
}

/// Returns the signed singular values of J, the larger one first. The second one is negative if J flips.
#[must_use]
pub fn stretches(j: DMat2) -> [f64; 2] {
    let (a, b, c, d) = (j.x_axis.x, j.y_axis.x, j.x_axis.y, j.y_axis.y);
    let (rotation, reflection) = ((a + d).hypot(c - b) / 2.0, (a - d).hypot(b + c) / 2.0);
    [rotation + reflection, rotation - reflection]
}

/// Returns the energy of a triangle, at most [`MAX_ENERGY`].
#[must_use]
pub fn energy([most, least]: [f64; 2]) -> f64 {
    if least <= 0.0 {
        return MAX_ENERGY;
    }
    (most * most + least * least + 1.0 / (most * most) + 1.0 / (least * least) - 4.0).clamp(0.0, MAX_ENERGY)
}

/// Returns the Jacobian of each triangle.
#[must_use]
pub fn jacobians(mesh: &ComparisonMesh, posed: &[DVec2]) -> Vec<DMat2> {
    let edges = |[a, b, c]: [DVec2; 3]| DMat2::from_cols(b - a, c - a);
    let jacobian = |t| edges(mesh.corners(t, posed)) * edges(mesh.corners(t, &mesh.vertices)).inverse();
    (0..mesh.triangles.len()).map(jacobian).collect()
}

impl Distortion {
    /// Measures the map to these posed positions.
    #[must_use]
    pub fn of(mesh: &ComparisonMesh, posed: &[DVec2]) -> Self {
        let jacobians = jacobians(mesh, posed);
        let stretches: Vec<[f64; 2]> = jacobians.iter().map(|&j| stretches(j)).collect();
        let area: f64 = mesh.areas.iter().sum();
        let mean = |measure: &dyn Fn(usize) -> f64| {
            (0..stretches.len()).map(|t| mesh.areas[t] * measure(t)).sum::<f64>() / area
        };
        let mut by_energy: Vec<(f64, f64)> =
            stretches.iter().map(|&s| energy(s)).zip(mesh.areas.iter().copied()).collect();
        by_energy.sort_by(|a, b| b.0.total_cmp(&a.0));
        let mut beyond = 0.0;
        let at_99 = by_energy.iter().find(|&&(_, area_of)| {
            beyond += area_of;
            beyond > 0.01 * area
        });
        let centroid = |t: usize, positions: &[DVec2]| mesh.corners(t, positions).iter().sum::<DVec2>() / 3.0;
        let bends = mesh.inner_edges().into_iter().map(|([a, b], [s, t])| {
            let edge = mesh.vertices[b as usize] - mesh.vertices[a as usize];
            let across = edge.perp_dot(centroid(t, &mesh.vertices) - centroid(s, &mesh.vertices)).abs();
            let jump = jacobians[t] - jacobians[s];
            edge.length_squared() / across * (jump.x_axis.length_squared() + jump.y_axis.length_squared())
        });
        Self {
            energy: mean(&|t| energy(stretches[t])),
            energy_percentile_99: at_99.map_or(0.0, |&(energy, _)| energy),
            rigidity: mean(&|t| (stretches[t][0] - 1.0).powi(2) + (stretches[t][1] - 1.0).powi(2)),
            max_stretch: stretches.iter().map(|s| s[0]).fold(0.0, f64::max),
            min_stretch: stretches.iter().map(|s| s[1]).fold(f64::INFINITY, f64::min),
            folds: stretches.iter().filter(|s| s[1] < 0.0).count(),
            bending: bends.sum(),
            turning: turning(mesh, posed),
            moved: mean(&|t| f64::from(u8::from(centroid(t, posed).distance(centroid(t, &mesh.vertices)) > MOVED))),
        }
    }
}

/// Returns the sum of the angles between successive edges of the outline. Vertices at which parts touch are left out.
fn turning(mesh: &ComparisonMesh, posed: &[DVec2]) -> f64 {
    let mut next = vec![Vec::new(); posed.len()];
    let outline = mesh.outline();
    outline.iter().for_each(|&[a, b]| next[a as usize].push(b));
    let at = |v: u32| posed[v as usize];
    let angle = |&[a, b]: &[u32; 2]| match next[b as usize][..] {
        [c] => {
            let (before, after) = (at(b) - at(a), at(c) - at(b));
            before.perp_dot(after).atan2(before.dot(after)).abs()
        }
        _ => 0.0,
    };
    outline.iter().map(angle).sum()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    #[test]
    fn singular_values_show_stretch_and_flips() {
        let turn = DMat2::from_angle(0.7);
        let close = |found: [f64; 2], expected: [f64; 2]| {
            assert!((found[0] - expected[0]).abs() < 1e-12 && (found[1] - expected[1]).abs() < 1e-12, "{found:?}");
        };
        close(stretches(turn), [1.0, 1.0]);
        close(stretches(turn * DMat2::from_diagonal((3.0, 0.5).into()) * turn), [3.0, 0.5]);
        close(stretches(turn * DMat2::from_diagonal((1.0, -2.0).into())), [2.0, -1.0]);
        assert_eq!(energy([1.0, 1.0]), 0.0);
        assert!((energy([2.0, 1.0]) - 2.25).abs() < 1e-12);
        assert_eq!(energy([2.0, -1.0]), MAX_ENERGY);
    }

    #[test]
    fn distortion_of_known_maps() {
        let at = |i: u32| DVec2::new(f64::from(i % 21), f64::from(i / 21)) / 20.0;
        let cell = |i: u32| [[i, i + 1, i + 22], [i, i + 22, i + 21]];
        let triangles: Vec<[u32; 3]> = (0..420).filter(|i| i % 21 != 20).flat_map(cell).collect();
        let areas = vec![1.0 / 800.0; triangles.len()];
        let mesh = ComparisonMesh { vertices: (0..441).map(at).collect(), triangles, areas };
        let still = Distortion::of(&mesh, &mesh.vertices);
        assert!(still.energy < 1e-12 && still.bending < 1e-12 && still.folds == 0 && still.moved == 0.0);
        let wide: Vec<DVec2> = mesh.vertices.iter().map(|p| DVec2::new(2.0 * p.x, p.y)).collect();
        let wide = Distortion::of(&mesh, &wide);
        assert!((wide.energy - 2.25).abs() < 1e-9 && (wide.energy_percentile_99 - 2.25).abs() < 1e-9, "{wide:?}");
        assert!((wide.rigidity - 1.0).abs() < 1e-9 && wide.bending < 1e-9, "{wide:?}");
        assert!((wide.max_stretch - 2.0).abs() < 1e-9 && (wide.min_stretch - 1.0).abs() < 1e-9);
        // x² along x: its second derivative is 2 everywhere.
        let bent: Vec<DVec2> = mesh.vertices.iter().map(|p| DVec2::new(p.x * p.x, p.y)).collect();
        let bent = Distortion::of(&mesh, &bent).bending;
        // Diagonals of the squares change the result by up to a half, depending on their direction.
        assert!((3.0..=7.0).contains(&bent), "{bent}");
        // A square turns once. Its image has four right angles, too.
        assert!((still.turning - TAU).abs() < 1e-9 && (wide.turning - TAU).abs() < 1e-9);
    }
}
