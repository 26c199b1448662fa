//! The posed course of lines at rest, for marks on the picture.
//!
//! Within a triangle the map of the mesh is affine. A line bends in every triangle that it crosses, so it is subdivided
//! first.
//!
//! Cost: that of [`rest_points`](super::inverse::rest_points), and linear in the triangles for each point beside the
//! mesh.

use glam::DVec2;

use super::{inverse::rest_points, locate::locate_near};

/// The posed course of each line, at points no farther apart than `step` at rest. Beside the mesh, its nearest part is
/// continued.
pub(super) fn posed_lines(
    rest: &[DVec2],
    posed: &[DVec2],
    triangles: &[[u32; 3]],
    lines: &[Vec<DVec2>],
    step: f64,
) -> Vec<Vec<DVec2>> {
    let divided: Vec<Vec<DVec2>> = lines.iter().map(|line| divided(line, step)).collect();
    let places = divided.concat();
    // The way from rest to pose: the roles of both are exchanged.
    let found = rest_points(posed, rest, triangles, &places);
    let beside = |p: DVec2| locate_near(posed, rest, triangles, p).map_or(p, |found| found.rest);
    let mut course = found.into_iter().zip(places).map(|(found, p)| found.unwrap_or_else(|| beside(p)));
    divided.iter().map(|line| course.by_ref().take(line.len()).collect()).collect()
}

/// The vertices of a line, with points between them no farther apart than `step`.
fn divided(line: &[DVec2], step: f64) -> Vec<DVec2> {
    let pieces = line.windows(2).flat_map(|ends| {
        let count = (ends[0].distance(ends[1]) / step).ceil().max(1.0);
        (0..count as usize).map(move |piece| ends[0].lerp(ends[1], piece as f64 / count))
    });
    pieces.chain(line.last().copied()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two squares of two triangles each, beside each other.
    const REST: [[f64; 2]; 6] = [[0.0, 0.0], [2.0, 0.0], [4.0, 0.0], [0.0, 2.0], [2.0, 2.0], [4.0, 2.0]];
    const TRIANGLES: [[u32; 3]; 4] = [[0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4]];

    /// The right edge goes up by 4.
    fn course(lines: &[&[[f64; 2]]], step: f64) -> Vec<Vec<DVec2>> {
        let rest = REST.map(DVec2::from);
        let posed = rest.map(|p| p - DVec2::Y * if p.x > 3.0 { 4.0 } else { 0.0 });
        let lines: Vec<Vec<DVec2>> = lines.iter().map(|line| line.iter().copied().map(DVec2::from).collect()).collect();
        posed_lines(&rest, &posed, &TRIANGLES, &lines, step)
    }

    #[test]
    fn lines_bend_between_their_vertices() {
        let bent = [[0.0, 1.0], [1.0, 1.0], [2.0, 1.0], [3.0, -1.0], [4.0, -3.0]].map(DVec2::from);
        assert_eq!(course(&[&[[0.0, 1.0], [4.0, 1.0]]], 1.0), [bent.to_vec()]);
        assert_eq!(course(&[&[[0.0, 1.0], [4.0, 1.0]]], f64::INFINITY), [vec![bent[0], bent[4]]]);
    }

    #[test]
    fn lines_stay_apart_and_the_nearest_part_continues_beside_the_mesh() {
        let lines = course(&[&[[3.0, 1.0]], &[], &[[-1.0, 0.0], [0.0, 0.0]]], 5.0);
        let ends = [[-1.0, 0.0], [0.0, 0.0]].map(DVec2::from);
        assert_eq!(lines, [vec![DVec2::new(3.0, -1.0)], vec![], ends.to_vec()]);
    }
}
