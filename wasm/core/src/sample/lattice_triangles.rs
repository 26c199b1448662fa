//! The triangles of the lattice that belong to the mesh regardless of their surroundings.
//!
//! A triangle between three nodes is Delaunay if its circumcircle contains no other vertex. The only other vertices are
//! those on the outline and on bones, so only triangles near them are left out.
//!
//! No edge of the outline crosses a remaining triangle. Such an edge is no longer than the spacing, and has its ends
//! outside the circumcircle. So it cuts off at most a cap of a height of 0.29 spacings. A node in the cap would be
//! closer to the edge than its clearance.
//!
//! Triangles are numbered from the upper left to the lower right, across rows. Later triangles are drawn over earlier
//! ones, so where a pose folds the picture, one side covers the other completely.
//!
//! Cost: O(n) for n nodes, and a visit of the triangles around each other vertex.

use glam::DVec2;

use super::{
    lattice::{Lattice, ROW_HEIGHT},
    nodes::{NodeTriangle, Nodes},
};
use crate::triangulation::NONE;

/// The circumradius of a triangle as a multiple of the spacing: 1 / √3, with a margin for rounding.
const CIRCUMRADIUS: f64 = 0.577_351;

/// Whether a triangle lies between its base and the next row, or the previous one.
const SIDES: [bool; 2] = [true, false];

/// The triangles between lattice nodes whose circumcircles are empty.
///
/// Each has a base, an edge along a row, and is identified by the node at the left end of the base.
#[derive(Debug)]
pub(super) struct LatticeTriangles {
    /// The triangle from the base at each node to the next row, or [`NONE`].
    pub(super) below: Vec<u32>,
    /// The triangle from the base at each node to the previous row, or [`NONE`].
    pub(super) above: Vec<u32>,
    /// Whether each node is the corner of a triangle.
    is_corner: Vec<bool>,
    /// The number of triangles.
    count: usize,
}

impl LatticeTriangles {
    /// The triangles between nodes that are clear of `others`, the vertices that are not nodes.
    pub(super) fn new(nodes: &Nodes, others: &[DVec2]) -> Self {
        let [mut clear_below, mut clear_above] = SIDES.map(|_| vec![true; nodes.numbers()]);
        for &p in others {
            close_triangles(nodes, p, |base, is_below| {
                let clear = if is_below { &mut clear_below } else { &mut clear_above };
                clear[base] = false;
            });
        }
        let [mut below, mut above] = SIDES.map(|_| vec![NONE; nodes.numbers()]);
        let mut is_corner = vec![false; nodes.numbers()];
        let is_clear = |t: &NodeTriangle| if t.is_below { clear_below[t.base] } else { clear_above[t.base] };
        // A counting sort. Islands far apart share places.
        let wide = nodes.lattice().steps() / nodes.numbers() + 1;
        let mut next = vec![0_u32; nodes.lattice().steps() / wide + 2];
        nodes.visit_triangles(|t| {
            if is_clear(&t) {
                next[t.step / wide + 1] += 1;
                [t.base, t.base + 1, t.apex].into_iter().for_each(|node| is_corner[node] = true);
            }
        });
        let mut count = 0;
        for of_step in &mut next {
            count += *of_step;
            *of_step = count;
        }
        nodes.visit_triangles(|t| {
            if is_clear(&t) {
                let number = &mut next[t.step / wide];
                let numbers = if t.is_below { &mut below } else { &mut above };
                numbers[t.base] = *number;
                *number += 1;
            }
        });
        Self { below, above, is_corner, count: count as usize }
    }

    /// Whether a node is the corner of a triangle.
    pub(super) fn has_corner(&self, node: usize) -> bool {
        self.is_corner[node]
    }

    /// Corners and neighbours of all triangles, with room for more of them. `vertices` are the vertices of nodes.
    pub(super) fn mesh(&self, nodes: &Nodes, vertices: &[u32], room: usize) -> (Vec<[u32; 3]>, Vec<[u32; 3]>) {
        let Self { below, above, count, .. } = self;
        let [mut triangles, mut neighbours] = [(); 2].map(|()| vec![[0; 3]; count + room]);
        nodes.visit_triangles(|NodeTriangle { base, apex, is_below, .. }| {
            let (here, beyond) = if is_below { (below, above) } else { (above, below) };
            if here[base] == NONE {
                return;
            }
            let number = here[base] as usize;
            let [left, right, tip] = [base, base + 1, apex].map(|node| vertices[node]);
            // Beside it in its strip are triangles whose bases end and begin at its apex.
            let [across, before, after] = [beyond[base], beyond[apex - 1], beyond[apex]];
            (triangles[number], neighbours[number]) = if is_below {
                ([left, right, tip], [across, after, before])
            } else {
                ([right, left, tip], [across, before, after])
            };
        });
        triangles.truncate(*count);
        neighbours.truncate(*count);
        (triangles, neighbours)
    }
}

/// Calls `visit` with the triangles whose circumcircles contain a point: the left end of the base, and whether the apex
/// is in the next row. Some of them may have corners that are not nodes.
fn close_triangles(nodes: &Nodes, p: DVec2, mut visit: impl FnMut(usize, bool)) {
    let lattice = nodes.lattice();
    let radius = CIRCUMRADIUS * lattice.spacing;
    let reach = DVec2::new(radius + lattice.spacing / 2.0, radius + lattice.spacing * ROW_HEIGHT / 3.0);
    for (number, row, column) in nodes.in_box(p - reach, p + reach) {
        let base = lattice.node(row, column);
        for is_below in SIDES {
            if p.distance_squared(base + centre(lattice, is_below)) <= radius * radius {
                visit(number, is_below);
            }
        }
    }
}

/// The centre of a triangle, from the left end of its base.
fn centre(lattice: &Lattice, is_below: bool) -> DVec2 {
    let height = ROW_HEIGHT / 3.0;
    lattice.spacing * DVec2::new(0.5, if is_below { height } else { -height })
}
