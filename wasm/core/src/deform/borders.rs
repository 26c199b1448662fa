//! The borders between cells in a pose.

use glam::DVec2;

use super::triangle::{corners, interpolate};
use crate::cell_borders::BorderPiece;

/// Both ends of each piece in a posed mesh, whose triangles are flat.
pub(super) fn posed_borders<'a>(
    pieces: &'a [BorderPiece],
    posed: &'a [DVec2],
) -> impl Iterator<Item = [DVec2; 2]> + 'a {
    pieces.iter().map(|piece| piece.ends.map(|end| interpolate(corners(posed, piece.corners), end)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_of_a_piece_follow_its_triangle() {
        let posed = [[0.0, 0.0], [8.0, 0.0], [0.0, 4.0], [8.0, 4.0]].map(DVec2::from);
        let pieces = [
            BorderPiece { corners: [0, 1, 2], ends: [[0.5, 0.5, 0.0], [0.0, 0.25, 0.75]] },
            BorderPiece { corners: [1, 3, 2], ends: [[1.0, 0.0, 0.0], [0.0, 0.5, 0.5]] },
        ];
        let expected = [[[4.0, 0.0], [2.0, 3.0]], [[8.0, 0.0], [4.0, 4.0]]].map(|ends| ends.map(DVec2::from));
        assert_eq!(posed_borders(&pieces, &posed).collect::<Vec<_>>(), expected);
    }
}
